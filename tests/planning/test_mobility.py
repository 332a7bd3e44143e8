"""What robots climb, from their descriptions."""

import math
from dataclasses import replace

import numpy as np
import pytest
from tests.helpers.robot import described

pytest.importorskip("scipy", reason="planning needs scipy")

from jauspy.errors import ConfigError
from jauspy.planning.mobility import flipper_joints, mobility_of, with_posture
from jauspy.platform.stability_setup import StabilitySetup

INC1 = described("inc1")[1]


def test_flippers_climb_higher_than_tracks():
    mobility = mobility_of(INC1)
    assert 0.05 < mobility.step < 0.12
    assert 0.12 < mobility.flipper_step < 0.2, "20 cm need flippers that push while it climbs"
    assert flipper_joints(INC1) == ("base_link_to_flippers",)


def test_slopes_are_limited_by_friction_before_a_low_robot_tips():
    mobility = mobility_of(INC1)
    assert mobility.up == mobility.side == pytest.approx(math.atan(0.6))


def test_slopes_are_limited_where_the_robot_would_tip():
    strict = replace(INC1, stability=StabilitySetup(slow=math.radians(59.0), stop=math.radians(55.0)))
    assert mobility_of(strict).side < math.radians(15.0)


def test_a_raised_arm_reaches_farther_and_tips_sooner():
    stretched = with_posture(INC1, {"arm_link_1_to_arm_link_2": 0.3, "arm_link_2_to_arm_link_3": 0.0})
    assert mobility_of(stretched).front > mobility_of(INC1).front + 0.3


def test_circles_cover_the_footprint():
    mobility = mobility_of(INC1)
    centres, radius = mobility.circles
    for x in (-mobility.back, 0.0, mobility.front):
        assert min(math.hypot(x - centre, mobility.half_width) for centre in centres) <= radius + 1e-9
    assert radius < 1.1 * mobility.half_width


def test_tiles_cover_the_footprint_and_hardly_more():
    mobility = mobility_of(INC1)
    centres, radii = mobility.tiles
    xs, ys = np.meshgrid(np.linspace(-0.6, 0.6, 241), np.linspace(-0.6, 0.6, 241))
    points = np.column_stack([xs.ravel(), ys.ravel()])
    covered = (np.hypot(*(points[:, None] - centres).transpose(2, 0, 1)) <= radii + 1e-9).any(axis=1)
    low, high = np.array([-mobility.back, -mobility.half_width]), np.array([mobility.front, mobility.half_width])
    assert covered[((points >= low) & (points <= high)).all(axis=1)].all()
    assert not covered[((points < low - 0.01) | (points > high + 0.01)).any(axis=1)].any()


def test_a_base_that_is_fixed_cannot_drive():
    with pytest.raises(ConfigError, match="neither tracks nor wheels"):
        mobility_of(replace(INC1, tracks=None))
