"""What only the kinematic robot promises."""

import math

import pytest

from jauspy.backends.kinematic import KinematicBackend, SkidSteerParameters, track_speed_after
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
