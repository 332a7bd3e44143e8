"""What only the kinematic robot promises."""

import math

import pytest

from jauspy.backends.kinematic import KinematicBackend, SkidSteerParameters, track_speed_after
from jauspy.platform.battery import Battery, BatteryState
from jauspy.platform.joints import ControlMode, JointState, Target
from jauspy.robot.robot_files import load, robot_model

INC1 = robot_model(load("inc1"))


def test_stops_completely() -> None:
    robot = KinematicBackend().open(INC1, "empty")
    robot.drive.set_effort(1.0, 0.5)
    robot.advance(1.0)
    robot.drive.stop()
    robot.advance(1.0)
    assert (robot.drive.twist().vx, robot.drive.twist().wz) == (0.0, 0.0)


def test_friction_never_reverses_a_track() -> None:
    assert track_speed_after(0.001, 0.0, 0.005, SkidSteerParameters()) == 0.0
    assert track_speed_after(-0.001, 0.0, 0.005, SkidSteerParameters()) == 0.0


def test_time_is_exact_and_yaw_wraps() -> None:
    robot = KinematicBackend().open(INC1, "yard")
    robot.drive.set_effort(0.0, 1.0)
    for _ in range(7):
        robot.advance(0.777)
        assert -math.pi <= robot.drive.pose().yaw <= math.pi
    assert robot.time == pytest.approx(7 * 0.777)


def test_states_of_joints_are_made_anew_only_after_a_change() -> None:
    robot = KinematicBackend().open(INC1, "empty")
    arm = robot.groups["arm"]
    rest = arm.state()
    robot.advance(0.1)
    assert arm.state() is rest
    arm.command([Target(ControlMode.EFFORT, joint.effort) for joint in arm.joints])
    assert arm.state().efforts == tuple(joint.effort for joint in arm.joints)
    robot.advance(0.1)
    moved = arm.state()
    assert all(now != before for now, before in zip(moved.positions, rest.positions, strict=True))
    assert min(moved.velocities) > 0.0
    arm.hold()
    assert arm.state() == JointState(moved.positions, (0.0,) * 5, (0.0,) * 5)
    robot.close()


def test_power_follows_the_positions_of_joints_and_what_moves() -> None:
    def power() -> float:
        state = next(part for part in robot.optional_parts if part.id.kind is Battery).state()
        assert isinstance(state, BatteryState)
        return state.power

    robot = KinematicBackend().open(INC1, "empty")
    robot.advance(1.0)
    folded = power()
    stretched = [Target(ControlMode.POSITION, value) for value in (0.0, 0.0, 0.0, 0.0, 0.0)]
    robot.groups["arm"].command(stretched)
    robot.advance(20.0)
    assert power() > folded + 1.0, "an arm stretched out is heavier to hold"
    resting = power()
    robot.drive.set_effort(0.5, 0.0)
    robot.advance(1.0)
    assert power() > resting + 10.0
    robot.drive.stop()
    robot.advance(3.0)
    assert power() == pytest.approx(resting)
    robot.close()


def test_what_rests_is_moved_again_by_a_command() -> None:
    robot = KinematicBackend().open(robot_model(load("rover")), "empty")
    robot.advance(0.1)
    robot.drive.set_effort(1.0, 0.0)
    robot.advance(1.0)
    assert robot.drive.pose().x > 0.3
    robot.close()
