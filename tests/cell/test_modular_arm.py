"""Kinematics of arms of modules, standing and hanging."""

from __future__ import annotations

import math

import numpy as np
import pinocchio as pin
import pytest

from jauspy.cell.frames import offset_between, shifted
from jauspy.cell.modular_arm import FIVE_JOINTS, Chain, HangingChain, Member
from jauspy.cell.scene import Layout
from jauspy.errors import ConfigError

BASE = shifted(0.6, 0.22, 0.2)


@pytest.fixture(scope="module")
def members(layout: Layout) -> list[Member]:
    return [Member(name, layout.type_of(name), pin.SE3.Identity(), "output") for name in FIVE_JOINTS]


@pytest.fixture(scope="module")
def chain(members: list[Member]) -> Chain:
    return Chain(BASE, members)


def test_upright_it_is_as_high_as_its_parts(chain: Chain, layout: Layout) -> None:
    heights = [layout.type_of(name).connectors["output"].position[2] for name in FIVE_JOINTS]
    joints = [type.servo.joint.position[2] for name in FIVE_JOINTS if (type := layout.type_of(name)).servo]
    tip = chain.forward(np.zeros(5))
    assert chain.joints == ["servo_1", "servo_2", "servo_3", "servo_11", "servo_5"]
    assert tip.translation == pytest.approx([0.6, 0.22, 0.2 + sum(heights) + sum(joints)])


def test_hanging_on_its_tip_the_first_part_is_where_it_was(chain: Chain, members: list[Member]) -> None:
    q = np.array([0.3, 0.5, -0.4, 0.7, 0.2])
    hanging = HangingChain(chain.forward(q), members)
    assert hanging.joints == chain.joints[::-1]
    assert max(offset_between(hanging.forward(q[::-1]), BASE)) < 1e-9
    assert len(hanging.links) == len(chain.links)


@pytest.mark.slow
def test_it_points_down_where_it_is_commanded(chain: Chain) -> None:
    point, down = np.array([1.05, 0.22, 0.4]), np.array([0.0, 0.0, -1.0])
    found = chain.pointing(point, down, np.zeros(5))
    assert len(found) >= 2
    for q in found:
        tip = chain.forward(q)
        assert tip.translation == pytest.approx(point, abs=3e-4)
        assert tip.rotation[:, 2] @ down > math.cos(0.02)


@pytest.mark.slow
def test_a_base_that_leans_is_made_up_for(members: list[Member]) -> None:
    leaning = BASE * pin.SE3(pin.utils.rpyToMatrix(0.003, 0.002, 0.0), np.zeros(3))
    assert Chain(leaning, members).pointing(np.array([1.05, 0.22, 0.4]), np.array([0.0, 0.0, -1.0]), np.zeros(5))


@pytest.mark.slow
def test_out_of_reach_there_is_no_posture(chain: Chain) -> None:
    assert chain.pointing(np.array([3.0, 0.0, 0.3]), np.array([0.0, 0.0, -1.0]), np.zeros(5)) == []


def test_the_velocity_of_the_tip_is_its_change(chain: Chain) -> None:
    q, v = np.array([0.1, 0.4, 0.9, 0.5, 0.0]), np.array([0.2, -0.5, 0.3, 0.8, 1.0])
    step = 1e-6
    change = (chain.forward(q + step * v).translation - chain.forward(q).translation) / step
    assert chain.velocity(q, v) == pytest.approx(change, abs=1e-5)


def test_an_unknown_connector_is_named(layout: Layout) -> None:
    with pytest.raises(ConfigError, match="servo_1 has no connector 'side'"):
        Chain(BASE, [Member("servo_1", layout.type_of("servo_1"), pin.SE3.Identity(), "side")])
