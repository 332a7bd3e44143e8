"""The CM-MOB of robots on wheels, on virtual time, and a client in control of it."""

from __future__ import annotations

import math
import statistics
from pathlib import Path

import pytest
from tests.helpers.wheeled import toml, write
from tests.robot.workcell import Workcell

from jauspy.backends import find
from jauspy.errors import ConfigError
from jauspy.messages import mobility as m, ugv
from jauspy.robot import robot_files
from jauspy.robot.robot_files import robot_model

KINDS = ("skid_steer", "ackermann", "mecanum")


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("wheels")
    return {kind: str(write(folder, kind)) for kind in KINDS}


@pytest.fixture(params=["kinematic", pytest.param("sim", marks=pytest.mark.slow)])
def backend(request: pytest.FixtureRequest) -> str:
    if request.param == "sim":
        pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    return str(request.param)


def under_control(backend: str, robot: str) -> Workcell:
    cell = Workcell(backend, robot, 102)
    cell.take_control()
    return cell


def velocity(forward: float, turn: float = 0.0, right: float | None = None) -> m.SetVelocityCommand:
    current = m.SetVelocityCommand.CommandType.SET_CURRENT_COMMAND
    return m.SetVelocityCommand(command_type=current, velocity_x=forward, velocity_y=right, yaw_rate=turn)


def measured(cell: Workcell) -> m.ReportVelocityState:
    found = cell.ask(m.QueryVelocityState(0xFFFF))
    assert isinstance(found, m.ReportVelocityState)
    return found


def commanded(cell: Workcell) -> m.ReportVelocityCommand:
    found = cell.ask(m.QueryVelocityCommand(0xFF, 0))
    assert isinstance(found, m.ReportVelocityCommand)
    return found


@pytest.mark.parametrize("kind", KINDS)
def test_efforts_drive_and_turn_right(backend: str, kind: str, files: dict[str, str]) -> None:
    cell = under_control(backend, files[kind])
    cell.tell(m.SetWrenchEffort(propulsive_linear_effort_x=40.0, propulsive_rotational_effort_z=30.0))
    cell.run(1.5)
    pose = cell.ask(m.QueryLocalPose(0xFFFF))
    assert pose.x > 0.3
    assert pose.yaw > 0.2


@pytest.mark.parametrize("kind", KINDS)
def test_efforts_drive_in_the_simulator(kind: str, files: dict[str, str]) -> None:
    pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    cell = under_control("sim", files[kind])
    cell.tell(m.SetWrenchEffort(propulsive_linear_effort_x=40.0, propulsive_rotational_effort_z=30.0))
    cell.run(1.0)
    pose = cell.ask(m.QueryLocalPose(0xFFFF))
    assert pose.x > 0.2
    assert pose.yaw > 0.08


@pytest.mark.parametrize("kind", KINDS)
def test_velocities_are_kept(backend: str, kind: str, files: dict[str, str]) -> None:
    cell = under_control(backend, files[kind])
    reports = []
    for _ in range(30):
        cell.tell(velocity(0.5, 0.4))
        cell.run(0.1)
        reports.append(measured(cell))
    assert statistics.mean(each.velocity_x for each in reports[10:]) == pytest.approx(0.5, abs=0.05)
    assert statistics.mean(each.yaw_rate for each in reports[10:]) == pytest.approx(0.4, abs=0.06)


def test_mecanum_wheels_move_sideways(backend: str, files: dict[str, str]) -> None:
    cell = under_control(backend, files["mecanum"])
    cell.tell(m.SetWrenchEffort(propulsive_linear_effort_y=50.0))
    cell.run(1.5)
    pose = cell.ask(m.QueryLocalPose(0xFFFF))
    assert pose.y > 0.5, "to the right"
    assert abs(pose.x) < 0.03
    assert abs(pose.yaw) < 0.05
    for _ in range(3):
        cell.tell(velocity(0.2, right=-0.4))
        cell.run(1.0)
    found = measured(cell)
    assert (found.velocity_x, found.velocity_y) == pytest.approx((0.2, -0.4), abs=0.05)
    assert commanded(cell).velocity_y == pytest.approx(-0.4, abs=0.01)


def test_other_wheels_have_no_sideways_velocity(files: dict[str, str]) -> None:
    cell = under_control("kinematic", files["skid_steer"])
    cell.tell(velocity(0.2, right=0.3))
    assert commanded(cell).velocity_y is None
    assert cell.ask(m.QueryWrenchEffort(0xFFFF)).propulsive_linear_effort_y is None


def test_a_car_limits_curves_to_its_narrowest(backend: str, files: dict[str, str]) -> None:
    cell = under_control(backend, files["ackermann"])
    chassis = cell.ask(ugv.QueryPlatformSpecifications()).platform_specifics
    for _ in range(3):
        cell.tell(velocity(0.4, 1.1))
        cell.run(1.0)
    wanted = commanded(cell)
    assert wanted.yaw_rate == pytest.approx(0.4 / chassis.min_turn_radius, abs=0.01)
    assert measured(cell).yaw_rate == pytest.approx(wanted.yaw_rate, abs=0.07)
    cell.tell(velocity(0.0, 0.5))
    assert commanded(cell).yaw_rate == pytest.approx(0.0, abs=1e-3), "not on the spot"
    assert cell.host.counters["curve_too_narrow"] == 4


def test_a_car_drives_backward_to_the_side_that_is_commanded(backend: str, files: dict[str, str]) -> None:
    cell = under_control(backend, files["ackermann"])
    for _ in range(3):
        cell.tell(velocity(-0.4, 0.3))
        cell.run(1.0)
    found = measured(cell)
    assert (found.velocity_x, found.yaw_rate) == pytest.approx((-0.4, 0.3), abs=0.06)


@pytest.mark.parametrize("heading", [0.8, -2.5])
def test_a_car_drives_a_curve_to_a_heading(backend: str, heading: float, files: dict[str, str]) -> None:
    cell = under_control(backend, files["ackermann"])
    for _ in range(8):
        cell.tell(m.SetLocalVector(speed=0.5, heading=heading))
        cell.run(1.0)
    assert cell.ask(m.QueryLocalPose(0xFFFF)).yaw == pytest.approx(heading, abs=0.05)
    cell.tell(m.SetLocalVector(speed=0.0, heading=0.0))
    assert cell.host.counters["cannot_turn_on_the_spot"] == 1


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("point", [(2.0, 1.0), pytest.param((0.2, 0.7), marks=pytest.mark.slow), (-1.5, -0.5)])
def test_waypoints_are_reached(kind: str, point: tuple[float, float], files: dict[str, str]) -> None:
    reached(under_control("kinematic", files[kind]), point)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("point", [(2.0, 1.0), (0.2, 0.7), (-1.5, -0.5)])
def test_waypoints_are_reached_in_the_simulator(kind: str, point: tuple[float, float], files: dict[str, str]) -> None:
    pytest.importorskip("mujoco", reason="MuJoCo is not installed")
    reached(under_control("sim", files[kind]), point)


def reached(cell: Workcell, point: tuple[float, float]) -> None:
    cell.tell(m.SetLocalWaypoint(x=point[0], y=point[1]), m.SetTravelSpeed(speed=0.6))
    for _ in range(250):
        cell.run(0.1)
        if cell.ask(m.QueryTravelSpeed()).speed < 0.01:
            break
    pose = cell.ask(m.QueryLocalPose(0xFFFF))
    assert math.dist((pose.x, pose.y), point) < 0.35


def test_a_car_has_the_driver_of_cars(backend: str, files: dict[str, str]) -> None:
    cell = under_control(backend, files["ackermann"])
    names = {service.urn.rpartition(":")[2] for service in cell.host.services}
    assert "AckermannDriver" in names
    assert "SkidSteerDriver" not in names
    cell.tell(ugv.SetAckermannConfiguration(steering_angle=0.3, throttle_effort=40.0, brake_effort=0.0))
    cell.run(1.5)
    pose = cell.ask(m.QueryLocalPose(0xFFFF))
    assert pose.x > 0.4
    assert pose.yaw > 0.2
    cell.tell(ugv.SetAckermannConfiguration(steering_angle=0.3, throttle_effort=40.0, brake_effort=50.0))
    cell.run(1.0)
    assert measured(cell).velocity_x == pytest.approx(0.0, abs=0.01)


def test_the_specification_names_the_wheels(files: dict[str, str]) -> None:
    car = Workcell("kinematic", files["ackermann"], 102).ask(ugv.QueryPlatformSpecifications())
    assert car.platform_specifics.drive_wheel_radius == pytest.approx(0.1, abs=1e-3)
    assert 0.4 < car.platform_specifics.steering_angle_range < 0.6
    assert car.platform_spec.wheel_base == pytest.approx(0.4, abs=1e-3)


@pytest.mark.parametrize(
    ("kind", "old", "new", "said"),
    [
        (
            "skid_steer",
            "'fl_axle'",
            "'fl_axel'",
            "wheels.left: 'fl_axel' is not a continuous joint of the URDF; those are: fl_axle",
        ),
        ("skid_steer", "left = ['fl_axle'", "left = ['fr_axle'", "wheels.left: fr_axle is there twice"),
        ("skid_steer", 'type = "skid_steer"', 'type = "mecano"', "wheels.type = 'mecano'"),
        ("skid_steer", 'type = "skid_steer"', 'type = "ackermann"', "an ackermann chassis has steering joints"),
        ("mecanum", ", 'rl_axle'", "", "mecanum wheels are four"),
        ("ackermann", "['rl_axle']", "['fl_axle']", "the joint 'fl_axle' needs <limit effort"),
        ("skid_steer", "[wheels]", "[tracks]\nleft = ['a']\nright = ['b']\n[wheels]", "the robot has tracks, too"),
        ("skid_steer", "[wheels]", "[wheels]\nradius = -1", "wheels.radius"),
    ],
)
def test_mistakes_are_named(tmp_path: Path, kind: str, old: str, new: str, said: str) -> None:
    path = write(tmp_path, kind)
    assert old in toml(kind)
    path.write_text(toml(kind).replace(old, new))
    with pytest.raises(ConfigError, match=said.replace("[", r"\[")):
        robot_model(robot_files.load(path))


def test_the_backend_can_has_no_wheels(files: dict[str, str]) -> None:
    model = robot_model(robot_files.load(files["mecanum"]))
    with pytest.raises(ConfigError, match="mecanum has wheels, and the backend can drives tracks only"):
        find("can").open(model, "empty")
