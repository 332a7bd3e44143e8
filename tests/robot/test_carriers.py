"""Where a sensor that joints move is mounted, and that a client can compute from it where the sensor is."""

from __future__ import annotations

import math
from functools import reduce
from operator import matmul

import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import JAUS_FROM_REP_103, Transform, jaus_frame
from jauspy.geometry.vectors import X, Z, rotation_about
from jauspy.ids import JausID
from jauspy.robot.config import ModuleConfig, RobotConfig
from jauspy.robot.kinds.mounting import joint_of
from jauspy.robot.robot_files import load, robot_model
from jauspy.services.environment_sensing import JointMount


def ids(config: RobotConfig) -> dict[JausID, ModuleConfig]:
    return {config.id_of(module): module for module in config.modules}


def carrier(robot: str, link: str) -> JointMount:
    config = load(robot)
    found = joint_of(ids(config), robot_model(config), link)
    assert found is not None
    return found


def same(found: Transform, expected: Transform) -> None:
    assert found.position == pytest.approx(expected.position, abs=1e-9)
    for row, wanted in zip(found.rotation, expected.rotation, strict=True):
        assert row == pytest.approx(wanted, abs=1e-9)


@pytest.mark.parametrize(
    ("robot", "link", "id", "joint"),
    [
        ("inc1", "arm_camera_link", "101.1.104", 4),
        ("inc1", "arm_link_1", "101.1.104", 1),
        ("inc1", "gripper_link", "101.1.104", 5),
        ("inc1", "pan_link", "101.1.107", 1),
        ("inc1", "chassis_camera_link", "101.1.107", 2),
        ("inc1", "flippers", "101.1.103", 1),
        ("inc1_pprm", "arm_camera_link", "102.1.104", 3),
    ],
)
def test_mounting_refers_to_the_last_joint_before_the_sensor(robot: str, link: str, id: str, joint: int) -> None:
    found = carrier(robot, link)
    assert (str(found.manipulator), found.number) == (id, joint)


@pytest.mark.parametrize("link", ["lidar_link", "base_link", "left_finger", "left_track"])
def test_sensor_without_moving_joint_has_no_joint_mount(link: str) -> None:
    config = load("inc1")
    assert joint_of(ids(config), robot_model(config), link) is None


@pytest.mark.parametrize("robot", ["inc1", "inc1_pprm"])
def test_arm_camera_pose_follows_from_reported_values(robot: str) -> None:
    config = load(robot)
    model = robot_model(config)
    group, tree = model.groups["arm"], FrameTree(model.description)
    positions = dict(zip(group.joints, (0.3, 0.25, -0.4, 0.6, 0.7), strict=False))
    arm = manipulator_geometry(model.description.chain(group.base, group.tip))
    standard = arm.from_urdf([positions[joint] for joint in group.joints])
    joint = carrier(robot, "arm_camera_link")
    frames = (link.frame(at) for link, at in list(zip(arm.links, standard, strict=True))[: joint.number])
    computed = reduce(matmul, frames, JAUS_FROM_REP_103 @ arm.base) @ joint.frame
    same(computed, jaus_frame(tree.pose("arm_camera_link", positions)))


def test_pan_tilt_camera_pose_follows_from_reported_values() -> None:
    """The coordinate system of the unit, turned by pan about its z and by tilt about y, and the sensor in that."""
    model = robot_model(load("inc1"))
    pan, tilt = 0.7, 0.4  # to the right, and up
    native = dict(zip(model.groups["pan_tilt"].joints, (-pan, -tilt), strict=True))
    system = Transform(position=(0.35, 0.0, -0.24))
    turned = system @ Transform(rotation_about(Z, pan)) @ Transform(rotation_about((0.0, 1.0, 0.0), tilt))
    computed = turned @ carrier("inc1", "chassis_camera_link").frame
    same(computed, jaus_frame(FrameTree(model.description).pose("chassis_camera_link", native)))
    assert computed.rotate(X) == pytest.approx(
        (math.cos(pan) * math.cos(tilt), math.sin(pan) * math.cos(tilt), -math.sin(tilt))
    )


def test_unknown_link_is_an_error() -> None:
    config = load("inc1")
    with pytest.raises(ConfigError, match="no joints lead from link 'base_link' to link 'nose'"):
        joint_of(ids(config), robot_model(config), "nose")
