"""The margin of tipping, against statics that one can do by hand, and against MuJoCo's masses."""

from __future__ import annotations

import dataclasses
import math

import pytest
from hypothesis import given, settings, strategies as st
from tests.helpers.robot import described

from jauspy.backends.kinematic import KinematicRobot
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.platform.chassis import measure
from jauspy.platform.stability import (
    EDGES,
    Payload,
    StabilityModel,
    gravity_direction,
    stability_of,
    support_polygon,
    tipping_angle,
)
from jauspy.platform.stability_setup import StabilitySetup
from jauspy.robot.robot_files import load

LEVEL = (0.0, 0.0, -1.0)
BOX = [(x, y, 0.0) for x in (-0.4, 0.4) for y in (-0.3, 0.3)]
CENTRE = (0.1, 0.0, 0.2)


def margins(down, centre=CENTRE, points=BOX):
    corners = support_polygon(points, centre)
    edges = zip(EDGES, corners, (*corners[1:], corners[0]), strict=True)
    return {name: math.degrees(tipping_angle(begin, end, centre, down)) for name, begin, end in edges}


def test_margins_of_a_box_are_those_of_statics():
    found = margins(LEVEL)
    assert found["front"] == pytest.approx(math.degrees(math.atan2(0.3, 0.2)))
    assert found["rear"] == pytest.approx(math.degrees(math.atan2(0.5, 0.2)))
    assert found["left"] == found["right"] == pytest.approx(math.degrees(math.atan2(0.3, 0.2)))


@pytest.mark.parametrize(
    ("pose", "edge"),
    [
        (Pose(pitch=math.radians(20.0)), "front"),
        (Pose(pitch=math.radians(-20.0)), "rear"),
        (Pose(roll=math.radians(20.0)), "right"),
        (Pose(roll=math.radians(-20.0)), "left"),
    ],
)
def test_a_slope_takes_its_angle_from_the_margin_of_the_lower_edge(pose, edge):
    level, tilted = margins(LEVEL), margins(gravity_direction(pose))
    assert tilted[edge] == pytest.approx(level[edge] - 20.0)


def test_beyond_the_edge_the_margin_is_negative():
    assert margins(LEVEL, centre=(0.5, 0.0, 0.2))["front"] < 0.0
    assert margins(gravity_direction(Pose(pitch=math.radians(60.0))))["front"] < 0.0
    assert min(margins((0.0, 0.0, 1.0)).values()) < 0.0, "on its back"


def test_points_above_the_ground_carry_nothing():
    found = support_polygon([*BOX, (0.9, 0.0, 0.1), (-0.9, 0.3, 0.1)], CENTRE)
    assert max(x for x, _, _ in found) == 0.4
    lifted = support_polygon([*BOX, (0.9, 0.2, -0.1), (0.9, -0.2, -0.1)], CENTRE)
    assert max(x for x, _, _ in lifted) == 0.9, "flippers that push down carry the front"
    assert min(x for x, _, _ in lifted) == -0.4


@pytest.mark.slow
@given(
    points=st.lists(st.tuples(*[st.floats(-2.0, 2.0)] * 3), min_size=1, max_size=30),
    centre=st.tuples(*[st.floats(-2.0, 2.0)] * 3),
    roll=st.floats(-math.pi, math.pi),
    pitch=st.floats(-math.pi, math.pi),
)
@settings(max_examples=200, deadline=None)
def test_any_shape_in_any_attitude_has_margins(points, centre, roll, pitch):
    for angle in margins(gravity_direction(Pose(roll=roll, pitch=pitch)), centre, points).values():
        assert -180.0 <= angle <= 180.0


def test_masses_and_payload_are_where_the_links_are():
    _, model = described("inc1")
    stability = StabilityModel(model)
    starts = {
        name: start for group in model.groups.values() for name, start in zip(group.joints, group.start, strict=True)
    }
    frames = stability.frames(starts)
    assert stability.centre(frames) == pytest.approx(measure(model).centre_of_gravity)
    loaded = stability.centre(frames, Payload(measure(model).mass, (1.0, 0.0, 0.0)))
    assert loaded[0] == pytest.approx((1.0 + measure(model).centre_of_gravity[0]) / 2.0)
    assert stability.mass_beyond("base_link") == pytest.approx(measure(model).mass)


def test_the_arm_to_the_side_and_an_overhang_take_from_the_margin():
    _, model = described("inc1")
    stability = StabilityModel(model)
    folded = {"base_link_to_flippers": 2.2, "arm_link_1_to_arm_link_2": 2.7, "arm_link_2_to_arm_link_3": -2.6}
    side = {"base_link_to_arm_link_1": 1.57, "arm_link_1_to_arm_link_2": 0.3, "arm_link_2_to_arm_link_3": -0.2}
    level = stability.margins(stability.frames(folded), LEVEL)
    frames = stability.frames(folded | side)
    hand = frames["tool_link"].position
    assert hand[1] > 0.6
    stretched = min(stability.margins(frames, LEVEL, Payload(8.0, hand)))
    assert stretched.edge == "left"
    assert stretched.angle < min(level).angle - math.radians(20.0)
    on_edges = {
        margin.edge: margin.angle for margin in stability.margins(stability.frames(folded), LEVEL, overhang=0.17)
    }
    whole = {margin.edge: margin.angle for margin in level}
    assert on_edges["rear"] < whole["rear"] - math.radians(5.0)
    assert on_edges["front"] < whole["front"] - math.radians(5.0)
    assert on_edges["left"] == pytest.approx(whole["left"], abs=1e-6)


def test_a_robot_without_the_table_or_tracks_has_no_monitor():
    _, model = described("inc1")
    robot = KinematicRobot(model)
    assert stability_of(model, robot) is not None
    assert stability_of(dataclasses.replace(model, stability=None), robot) is None
    assert stability_of(dataclasses.replace(model, tracks=None), robot) is None
    robot.close()


def test_an_empty_gripper_weighs_nothing_and_a_robot_without_scales_has_what_its_file_says():
    _, model = described("inc1")
    robot = KinematicRobot(model)
    robot.advance(0.1)
    assert stability_of(model, robot).payload().mass == 0.0
    blind = dataclasses.replace(model, force_torque=(), stability=StabilitySetup(payload=5.0))
    assert stability_of(blind, robot).payload().mass == 5.0
    assert stability_of(blind, robot).warning == ""
    robot.close()


@pytest.mark.parametrize(
    "text",
    [
        "slow = 5.0\nstop = 6.0",
        "slow = 0.0",
        "stop = -3.0",
        "slow = 400.0",
        "overhang = -1.0",
        "creep = 0.0",
        "payload = nan",
        "payload = 1e9",
        "speed = 1",
    ],
)
def test_silly_margins_are_refused(tmp_path, text):
    file = tmp_path / "robot.toml"
    file.write_text(f'extends = "inc1"\n[stability]\n{text}\n')
    with pytest.raises(ConfigError, match=r"stability|stop: must be below slow"):
        load(file)
