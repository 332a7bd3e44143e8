"""The model of an arm against independent kinematics, and the check of motions against fine sampling."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("pinocchio", reason="needs jauspy[planning]")

import pinocchio as pin
from tests.helpers.seven_joints import seven_joints

from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import parse_urdf
from jauspy.planning.arm_model import ArmModel
from jauspy.planning.contacts import Contacts
from jauspy.planning.obstacles import Box, Obstacles
from jauspy.platform.description import GroupSetup, RobotModel
from jauspy.robot.robot_files import load, robot_model

GANTRY = """<robot name="gantry"><link name="base"/><link name="slide"/><link name="arm"/><link name="tool"/>
<joint name="x" type="prismatic"><parent link="base"/><child link="slide"/><origin xyz="0 0 1" rpy="0.3 0 0"/>
<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<joint name="turn" type="continuous"><parent link="slide"/><child link="arm"/><axis xyz="0 0 1"/>
<limit effort="1" velocity="2"/></joint>
<joint name="level" type="revolute"><parent link="arm"/><child link="tool"/><origin xyz="0.5 0 0"/><axis xyz="0 0 1"/>
<limit lower="-9" upper="9" effort="1" velocity="2"/><mimic joint="turn" multiplier="-0.5" offset="0.2"/></joint>
</robot>"""


def gantry() -> RobotModel:
    group = GroupSetup(("x", "turn"), {}, "base", "tool", 100.0, (0.0, 0.0))
    return RobotModel(parse_urdf(GANTRY), None, {"arm": group})


MODELS = {"inc1": lambda: robot_model(load("inc1")), "seven": seven_joints, "gantry": gantry}


@pytest.mark.parametrize("name", MODELS)
def test_frames_and_jacobian_of_the_tool(name: str) -> None:
    model = MODELS[name]()
    arm, boxes = ArmModel(model, "arm"), LinkBoxes(model.description, model.groups["arm"].joints)
    postures = np.random.default_rng(1).uniform(arm.lower, arm.upper, (20, len(arm.joints)))
    frames = arm.frames(postures)
    tools = arm.tool(frames)
    for posture, tool in zip(postures, tools, strict=True):
        turn, place = boxes.frame(model.groups["arm"].tip, posture.tolist())
        assert np.allclose(tool[:3, :3], turn, atol=1e-9)
        assert np.allclose(tool[:3, 3], place, atol=1e-9)
    jacobian = arm.jacobian(frames, tools[:, :3, 3])
    for column in range(len(arm.joints)):
        moved = postures.copy()
        moved[:, column] += 1e-6
        after = arm.tool(arm.frames(moved))
        assert np.allclose((after - tools)[:, :3, 3] / 1e-6, jacobian[:, :3, column], atol=1e-4)
        turns = (after[:, :3, :3] @ tools[:, :3, :3].transpose(0, 2, 1))[:, [2, 0, 1], [1, 2, 0]]
        assert np.allclose(turns / 1e-6, jacobian[:, 3:, column], atol=1e-4)


def test_joints_of_other_groups_stay_where_they_are_given() -> None:
    model = robot_model(load("inc1"))
    up, down = (ArmModel(model, "arm", {"base_link_to_flippers": value}) for value in (2.2, 0.0))
    places = [
        next(item for item in arm.geometry.geometryObjects if item.name == "left_flipper_0").placement
        for arm in (up, down)
    ]
    assert np.linalg.norm(places[0].translation - places[1].translation) > 0.1


@pytest.mark.parametrize(("name", "group"), [("inc1", "arm"), ("cell", "ur10")])
def test_shapes_come_nearer_by_no_more_than_their_levers(name: str, group: str) -> None:
    arm = ArmModel(robot_model(load(name)), group)
    shapes, pairs = arm.geometry.copy(), np.array(arm.pairs)
    for one, other in pairs.tolist():
        shapes.addCollisionPair(pin.CollisionPair(one, other))
    data, state = shapes.createData(), arm.kinematics.createData()
    levers = arm.relative_levers(list(shapes.geometryObjects), arm.levers, pairs)
    rng = np.random.default_rng(2)

    def distances(posture: np.ndarray) -> np.ndarray:
        pin.computeDistances(arm.kinematics, state, shapes, data, arm.configuration(posture))
        return np.array([result.min_distance for result in data.distanceResults])

    moved = np.zeros(len(pairs))
    for _ in range(60):
        one = rng.uniform(arm.lower, arm.upper)
        step = 0.1 * rng.normal(size=len(one)) * (rng.random(len(one)) < 0.5) * np.minimum(1.0, arm.upper - arm.lower)
        changes = np.abs(distances(one + step) - distances(one))
        most = levers @ np.abs(step)
        assert (changes <= 1.05 * most + 1e-5).all()
        moved = np.maximum(moved, changes / (most + 1e-3))
    assert np.median(moved) > 0.3, "the levers are not far too long either"


@pytest.mark.parametrize(("name", "group"), [("inc1", "arm"), ("cell", "ur10")])
def test_motions_that_are_called_free_touch_nothing_in_between(name: str, group: str) -> None:
    arm = ArmModel(robot_model(load(name)), group)
    rng = np.random.default_rng(4)
    posts = [
        Box(
            Transform(position=tuple(rng.uniform((-0.8, -0.8, 0.3), (1.2, 0.8, 0.9)).tolist())),
            (0.02, 0.02, 0.6),
            "post",
        )
        for _ in range(6)
    ]
    contacts = Contacts(arm, Obstacles(posts), 0.01)
    bare = Contacts(arm, Obstacles(posts), 0.0)
    free = blocked = 0
    for _ in range(100):
        one, other = rng.uniform(np.maximum(arm.lower, -3.0), np.minimum(arm.upper, 3.0), (2, len(arm.joints)))
        if not (contacts.is_free(one) and contacts.is_free(other)):
            continue
        touches = not all(bare.is_free(one + share * (other - one)) for share in np.linspace(0.0, 1.0, 400))
        is_free = contacts.is_motion_free(one, other)
        assert not (is_free and touches)
        free, blocked = free + is_free, blocked + touches
    assert free >= 2
    assert blocked >= 2
