"""The tree of frames: by hand, and against the simulator."""

from __future__ import annotations

import math
from importlib.util import find_spec

import pytest

from jauspy.backends.kinematic import KinematicBackend
from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree, joint_frame
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.urdf import Joint, JointKind
from jauspy.platform.joints import ControlMode, Target, joint_positions
from jauspy.robot.robot_files import load, robot_model

INC1 = robot_model(load("inc1"))


def test_prismatic_joint_translates_and_revolute_joint_rotates() -> None:
    lift = Joint("lift", JointKind.PRISMATIC, "a", "b", Pose(x=1.0, yaw=math.pi / 2), axis=(1.0, 0.0, 0.0))
    assert joint_frame(lift, 2.0).position == pytest.approx((1.0, 2.0, 0.0))
    hinge = Joint("hinge", JointKind.REVOLUTE, "a", "b", Pose(z=1.0), axis=(0.0, 1.0, 0.0))
    assert joint_frame(hinge, math.pi / 2).apply((1.0, 0.0, 0.0)) == pytest.approx((0.0, 0.0, 0.0))


def test_all_links_have_a_pose_in_any_order_of_the_urdf() -> None:
    assert set(FrameTree(INC1.description).poses()) == INC1.description.links()


def test_one_pose_is_that_of_the_tree() -> None:
    tree, positions = FrameTree(INC1.description), {"base_link_to_arm_link_1": 0.3, "arm_link_2_to_arm_link_3": -0.7}
    for link, pose in tree.poses(positions).items():
        assert tree.pose(link, positions) == pose


def test_mimicking_joints_follow() -> None:
    poses = FrameTree(INC1.description).poses({"gripper_link_to_left_finger": 0.04})
    left, right = poses["left_finger"].position, poses["right_finger"].position
    assert left[1] - right[1] == pytest.approx(0.08)


def test_unknown_link_error_lists_the_links() -> None:
    with pytest.raises(ConfigError, match=r"inc1 has no link 'nose'; it has: .*lidar_link"):
        FrameTree(INC1.description).pose("nose")


def test_links_fixed_to_the_base_are_detected() -> None:
    tree = FrameTree(INC1.description)
    assert tree.is_fixed("lidar_link")
    assert not tree.is_fixed("arm_camera_link")


def test_positions_are_those_of_the_joints_that_were_moved() -> None:
    robot = KinematicBackend().open(INC1, "empty")
    robot.groups["arm"].command([Target(ControlMode.POSITION, 0.5), *[None] * 4])
    robot.advance(3.0)
    positions = joint_positions(robot.groups.values())
    assert positions["base_link_to_arm_link_1"] == pytest.approx(0.5)
    assert positions["base_link_to_flippers"] == pytest.approx(2.2)


@pytest.mark.skipif(find_spec("mujoco") is None, reason="MuJoCo is not installed")
@pytest.mark.parametrize("name", ["inc1", "inc1_pprm"])
def test_agrees_with_the_simulator_while_the_arm_moves(name: str) -> None:
    import mujoco

    from jauspy_sim.assembly import prefix
    from jauspy_sim.robot import SimulatedRobot

    model = robot_model(load(name))
    robot = SimulatedRobot.open(model, "empty")
    arm = robot.groups["arm"]
    arm.command([Target(ControlMode.VELOCITY, 0.2) for _ in arm.joints])
    robot.advance(1.0)
    mujoco.mj_kinematics(robot.model, robot.data)
    base = robot.data.body(f"{prefix(name)}base_link")
    for link, pose in FrameTree(model.description).poses(joint_positions(robot.groups.values())).items():
        body = robot.data.body(f"{prefix(name)}{link}")
        expected = base.xmat.reshape(3, 3).T @ (body.xpos - base.xpos)
        # belts and mimicking fingers have a little play in the simulator
        assert pose.position == pytest.approx(expected.tolist(), abs=2e-3), link
        turned = base.xmat.reshape(3, 3).T @ body.xmat.reshape(3, 3)
        assert [x for row in pose.rotation for x in row] == pytest.approx(turned.ravel().tolist(), abs=1e-6), link


@pytest.mark.parametrize(
    "pose", [Pose(1.0, 2.0, 3.0, 0.3, -0.2, 2.8), Pose(roll=-3.0, pitch=1.2), Pose(pitch=math.pi / 2, yaw=0.7)]
)
def test_transform_keeps_its_angles(pose: Pose) -> None:
    found = Transform.from_pose(pose).to_pose()
    assert [getattr(found, name) for name in Pose.__slots__] == pytest.approx(
        [getattr(pose, name) for name in Pose.__slots__]
    )


def test_the_pose_of_one_frame_in_another() -> None:
    base = Transform.from_pose(Pose(x=5.0, yaw=math.pi / 2))
    frames = FrameTree(INC1.description).frames(base, {}, "local")
    assert frames.pose("base_link", "local") == base
    assert frames.pose("lidar_link", "local").position == pytest.approx((5.0, -0.33, 0.44))
    assert frames.pose("local", "lidar_link").position == pytest.approx((0.33, 5.0, -0.44))
    assert frames.pose("tool_link", "tool_link").position == pytest.approx((0.0, 0.0, 0.0))
    assert set(frames.parents) == INC1.description.links()
