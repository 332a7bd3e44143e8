"""Mobility services over a fake chassis: signs, units, and above all when nothing may move."""

from __future__ import annotations

import math

import pytest

from jauspy.geometry.poses import Pose, Twist
from jauspy.messages.core import (
    ClearEmergency,
    ReleaseControl,
    RequestControl,
    Reset,
    Resume,
    SetEmergency,
    Shutdown,
    Standby,
    TimeStamp,
)
from jauspy.messages.mobility import (
    QueryLocalPose,
    QueryLocalPoseExt,
    QueryVelocityState,
    QueryVelocityStateExt,
    QueryWrenchEffort,
    ReportLocalPose,
    ReportVelocityState,
    ReportWrenchEffort,
    SetLocalPose,
    SetLocalPoseExt,
    SetWrenchEffort,
    VelocityVehicleXYZRec,
    ZPosition,
)

A, B = "42.1.1", "42.2.1"
FORWARD = SetWrenchEffort(propulsive_linear_effort_x=40.0)
NOW = TimeStamp(535, 26, 9, 15, 14)
EVERYTHING = 0xFFFF


@pytest.fixture
def driving(robot, drive):
    """Client A drives forward."""
    for message in (RequestControl(100), Resume(), FORWARD):
        robot.tell(A, message)
    assert drive.effort == (pytest.approx(0.4, abs=1e-4), pytest.approx(0.0, abs=1e-4))
    return robot


def near(report):
    """The report, compared with what fields of 16 bits can hold."""
    return {name: pytest.approx(value, abs=2e-3) for name, value in report.items()}


def values(report) -> dict[str, float]:
    names = (slot.name for slot in type(report).layout().slots)
    return {name: value for name in names if isinstance(value := getattr(report, name), float)}


@pytest.mark.parametrize(
    "before",
    [
        [],
        [(A, Resume())],
        [(A, RequestControl(100))],
        [(B, RequestControl(100)), (B, Resume())],
        [(A, RequestControl(100)), (A, Resume()), (A, Standby())],
        [(A, RequestControl(100)), (A, Resume()), (B, SetEmergency(1))],
        [(A, RequestControl(100)), (A, Resume()), (A, ReleaseControl())],
        [(A, RequestControl(100)), (A, Resume()), (B, RequestControl(101))],
        [(A, RequestControl(100)), (A, Resume()), (A, Reset())],
        [(A, RequestControl(100)), (A, Resume()), (A, Shutdown())],
    ],
    ids=[
        "nothing",
        "no control",
        "standby",
        "another's",
        "standby again",
        "emergency",
        "released",
        "taken",
        "reset",
        "shutdown",
    ],
)
def test_commands_need_control_and_ready(robot, drive, before) -> None:
    for client, message in before:
        robot.tell(client, message)
    robot.tell(A, FORWARD)
    assert all(effort == (0.0, 0.0) for effort in drive.efforts)
    assert values(robot.ask(A, QueryWrenchEffort(EVERYTHING)))["propulsive_linear_effort_x"] == pytest.approx(
        0, abs=2e-3
    )


@pytest.mark.parametrize(
    ("client", "message"),
    [
        (A, Standby()),
        (A, ReleaseControl()),
        (A, Reset()),
        (A, Shutdown()),
        (A, RequestControl(0)),
        (B, SetEmergency(1)),
        (B, RequestControl(101)),
    ],
)
def test_end_of_ready_or_control_stops_the_drive(driving, drive, client, message) -> None:
    driving.tell(client, message)
    assert drive.effort == (0.0, 0.0)


def test_control_timeout_stops_the_drive(driving, drive) -> None:
    stops = drive.stops
    driving.run(5.0)
    assert drive.effort == (0.0, 0.0)
    assert drive.stops > stops
    assert driving.host.controller is None


def test_failure_stops_the_drive(driving, drive) -> None:
    driving.host.fire("Failure")
    assert drive.effort == (0.0, 0.0)


def test_close_stops_the_drive(driving, drive) -> None:
    driving.host.close(1.0)
    driving.host.close(1.0)
    assert drive.effort == (0.0, 0.0)


def test_drive_stands_after_an_emergency_until_the_next_command(driving, drive) -> None:
    driving.tell(B, SetEmergency(1))
    driving.tell(B, ClearEmergency(1))
    assert drive.effort == (0.0, 0.0)
    driving.tell(A, FORWARD)
    assert drive.effort[0] == pytest.approx(0.4, abs=1e-4)


def test_renewed_request_of_the_controller_does_not_stop_the_drive(driving, drive) -> None:
    driving.tell(A, RequestControl(100))
    assert drive.effort[0] == pytest.approx(0.4, abs=1e-4)


def test_failed_stop_does_not_keep_control(driving, drive) -> None:
    def broken() -> None:
        raise OSError("motor bus")

    drive.stop = broken
    driving.tell(B, SetEmergency(1))
    assert driving.host.status.name == "EMERGENCY"
    assert driving.host.counters["action_failed"] >= 1


def test_positive_z_effort_turns_right(driving, drive) -> None:
    driving.tell(A, SetWrenchEffort(propulsive_linear_effort_x=-100.0, propulsive_rotational_effort_z=25.0))
    assert drive.effort == (pytest.approx(-1.0), pytest.approx(-0.25, abs=1e-4))
    report = driving.ask(A, QueryWrenchEffort(EVERYTHING))
    assert values(report) == near({"propulsive_linear_effort_x": -100.0, "propulsive_rotational_effort_z": 25.0})


def test_wrench_report_is_masked(driving) -> None:
    assert driving.ask(A, QueryWrenchEffort(0)) == ReportWrenchEffort()
    assert set(values(driving.ask(A, QueryWrenchEffort(1 << 5)))) == {"propulsive_rotational_effort_z"}


def test_velocity_in_jaus_axes(robot, drive) -> None:
    drive.present_twist = Twist(1.0, 0.5, 0.25, 0.1, 0.2, 0.3)
    report = robot.ask(A, QueryVelocityState(EVERYTHING))
    assert values(report) == near(
        {
            "velocity_x": 1.0,
            "velocity_y": -0.5,
            "velocity_z": -0.25,
            "roll_rate": 0.1,
            "pitch_rate": -0.2,
            "yaw_rate": -0.3,
        }
    )
    assert report.time_stamp == NOW
    assert robot.ask(A, QueryVelocityState(0)) == ReportVelocityState()
    masked = robot.ask(A, QueryVelocityState(0x0141))
    assert set(values(masked)) == {"velocity_x", "yaw_rate"}
    assert masked.time_stamp == NOW


def test_extended_velocity_has_two_presence_vectors(robot, drive) -> None:
    drive.present_twist = Twist(vx=3.0, vy=4.0)
    full = robot.ask(A, QueryVelocityStateExt(0xFF, 0xFFFF))
    assert values(full.velocity_var) == near({"velocity_x": 3.0, "velocity_y": -4.0, "velocity_z": 0.0})
    assert full.report_velocity_state_ext_rec.speed_over_ground == pytest.approx(5.0, abs=0.01)
    assert full.report_velocity_state_ext_rec.time_nano_seconds == 535_000_000
    half = robot.ask(A, QueryVelocityStateExt(0b010, 0b1000))
    assert half.velocity_var == VelocityVehicleXYZRec(velocity_y=pytest.approx(-4.0, abs=1e-4))
    assert set(values(half.report_velocity_state_ext_rec)) == {"yaw_rate"}


def test_pose_in_jaus_axes(robot, drive) -> None:
    drive.present_pose = Pose(1.0, 2.0, 3.0, 0.1, 0.2, 0.3)
    report = robot.ask(A, QueryLocalPose(EVERYTHING))
    assert values(report) == near({"x": 1.0, "y": -2.0, "z": -3.0, "roll": 0.1, "pitch": -0.2, "yaw": -0.3})
    assert report.time_stamp == NOW
    assert robot.ask(A, QueryLocalPose(0)) == ReportLocalPose()
    extended = robot.ask(A, QueryLocalPoseExt(EVERYTHING))
    assert extended.heading == pytest.approx(-0.3, abs=1e-3)
    assert extended.z_local == pytest.approx(-3.0, abs=1e-3)
    assert extended.altitude_msl is None


@pytest.mark.parametrize("yaw", [math.pi, -math.pi, 3 * math.pi, 7.0, -100.0])
def test_any_angle_can_be_reported(robot, drive, yaw) -> None:
    drive.present_pose = Pose(yaw=yaw)
    reported = robot.ask(A, QueryLocalPose(EVERYTHING)).yaw
    assert math.remainder(reported + yaw, math.tau) == pytest.approx(0.0, abs=1e-3)


def test_set_local_pose_moves_and_turns_the_frame(robot, drive) -> None:
    drive.present_pose = Pose(x=5.0, y=1.0, z=0.5, yaw=0.0)
    robot.tell(A, RequestControl(100))
    robot.tell(A, SetLocalPose(x=100.0, y=-200.0, yaw=math.pi / 2))
    report = robot.ask(A, QueryLocalPose(EVERYTHING))
    assert values(report) == near({"x": 100, "y": -200, "z": -0.5, "roll": 0, "pitch": 0, "yaw": math.pi / 2})
    drive.present_pose = Pose(x=7.0, y=1.0, z=0.5, yaw=0.0)
    report = robot.ask(A, QueryLocalPose(EVERYTHING))
    assert (report.x, report.y) == pytest.approx((100.0, -198.0), abs=1e-3), "forward is +y of the frame now"
    robot.tell(A, SetLocalPoseExt(x=0.0, z_position=ZPosition(ZPosition.Choice.Z_LOCAL, 9.0)))
    report = robot.ask(A, QueryLocalPose(EVERYTHING))
    assert (report.x, report.y, report.z) == pytest.approx((0.0, -198.0, 9.0), abs=0.01)
    robot.tell(A, SetLocalPoseExt(z_position=ZPosition(ZPosition.Choice.ALTITUDE_MSL, 50.0)))
    assert robot.ask(A, QueryLocalPose(0b100)).z == pytest.approx(9.0, abs=0.02)


def test_set_local_pose_needs_control(robot) -> None:
    robot.tell(A, SetLocalPose(x=100.0))
    robot.tell(B, RequestControl(100))
    robot.tell(A, SetLocalPose(x=100.0))
    assert robot.ask(A, QueryLocalPose(1)).x == pytest.approx(0.0, abs=1e-3)
