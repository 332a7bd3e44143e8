"""The tilt guard: when it stops the robot, and what an operator has to do to go on."""

from __future__ import annotations

import dataclasses
import math

import pytest

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy.messages.core import QueryTime, RequestControl, Resume
from jauspy.messages.mobility import (
    QueryLocalVector,
    QueryTravelSpeed,
    QueryWrenchEffort,
    SetLocalVector,
    SetLocalWaypoint,
    SetTravelSpeed,
    SetVelocityCommand,
    SetWrenchEffort,
)
from jauspy.platform.chassis import Chassis, chassis_of
from jauspy.platform.description import TiltSetup
from jauspy.platform.stability import Margin, StabilityMonitor
from jauspy.platform.stability_setup import StabilitySetup
from jauspy.robot.monitors import tilt_problem
from jauspy.robot.robot_files import load, robot_model
from jauspy.services.core import AccessControl, Events, Management, Time
from jauspy.services.mobility import (
    LocalPoseSensor,
    LocalVectorDriver,
    LocalWaypointDriver,
    PrimitiveDriver,
    Vehicle,
    VelocityStateDriver,
)
from jauspy.services.mobility.tilt_guard import STEP, TiltGuard

A = "42.1.1"
FORWARD = SetWrenchEffort(propulsive_linear_effort_x=40.0)
BACKWARD = SetWrenchEffort(propulsive_linear_effort_x=-40.0)
ZERO = SetWrenchEffort(propulsive_linear_effort_x=0.0)
LIMITS = TiltSetup(pitch=math.radians(50.0), roll=math.radians(40.0))


def tilted(pitch: float = 0.0, roll: float = 0.0) -> Pose:
    """Degrees."""
    return Pose(0.0, 0.0, 0.0, math.radians(roll), math.radians(pitch), 0.0)


@pytest.fixture
def rig(make, drive):
    vehicle = Vehicle(drive, chassis=dataclasses.replace(Chassis(), tilt_guard=LIMITS))
    kinds = (PrimitiveDriver, LocalPoseSensor, LocalVectorDriver, LocalWaypointDriver, VelocityStateDriver)
    rig = make(
        *(kind(vehicle) for kind in kinds),
        AccessControl(default_authority=1, timeout=5),
        Management(),
        Events(),
        Time(),
    )
    for message in (RequestControl(100), Resume()):
        rig.tell(A, message)
    return rig


def repeat(rig, message, seconds: float) -> None:
    """Send it ten times a second."""
    for _ in range(round(10.0 * seconds)):
        rig.tell(A, message)
        rig.run(0.1)


@pytest.mark.parametrize(
    ("pose", "says"),
    [
        pytest.param(tilted(pitch=-51.0), "51 degrees (nose up; pitch limit 50)", id="rears up"),
        pytest.param(tilted(pitch=51.0), "51 degrees (nose down; pitch limit 50)", id="nose down"),
        pytest.param(tilted(roll=41.0), "41 degrees (right side down; roll limit 40)", id="right"),
        pytest.param(tilted(roll=-41.0), "41 degrees (left side down; roll limit 40)", id="left"),
        pytest.param(tilted(roll=180.0), "180 degrees (right side down; roll limit 40)", id="on its back"),
    ],
)
def test_a_tilted_robot_is_stopped_and_the_reason_is_said(rig, drive, pose, says, caplog) -> None:
    rig.tell(A, FORWARD)
    rig.run(0.2)
    assert drive.effort[0] == pytest.approx(0.4, abs=1e-4)
    drive.present_pose = pose
    rig.run(0.1)
    assert drive.effort == (0.0, 0.0)
    assert rig.host.counters["tilt"] == 1
    assert says in caplog.text
    assert says in tilt_problem(rig.host), "as `jauspy up` shows it"
    report = rig.ask(A, QueryWrenchEffort(0xFFFF))
    assert report.propulsive_linear_effort_x == pytest.approx(0.0, abs=2e-3)


@pytest.mark.parametrize("pose", [tilted(pitch=-49.0), tilted(roll=39.0), tilted(pitch=49.0, roll=-39.0)])
def test_within_the_limits_it_drives(rig, drive, pose) -> None:
    drive.present_pose = pose
    repeat(rig, FORWARD, 2.0)
    assert drive.effort[0] == pytest.approx(0.4, abs=1e-4)
    assert not rig.host.counters["tilt"]


@pytest.mark.parametrize(
    "command",
    [
        FORWARD,
        BACKWARD,
        SetVelocityCommand(command_type=SetVelocityCommand.CommandType.SET_CURRENT_COMMAND, velocity_x=0.5),
        SetLocalVector(speed=0.5, heading=0.0),
    ],
    ids=["forward", "backward", "velocity", "vector"],
)
def test_commands_that_are_repeated_move_it_only_after_letting_go(rig, drive, command) -> None:
    repeat(rig, command, 0.5)
    drive.present_pose = tilted(pitch=-55.0)
    rig.run(0.1)
    drive.efforts.clear()
    repeat(rig, command, 3.0)
    assert all(effort == (0.0, 0.0) for effort in drive.efforts), "the stick is still held"
    assert rig.ask(A, QueryLocalVector(0xFF)).speed == pytest.approx(0.0, abs=1e-3), "nothing is commanded"
    rig.tell(A, RequestControl(100))
    rig.run(1.6)
    repeat(rig, command, 0.5)
    assert drive.effort[0] != 0.0


@pytest.mark.parametrize(
    "zero",
    [ZERO, SetVelocityCommand(command_type=SetVelocityCommand.CommandType.SET_CURRENT_COMMAND, velocity_x=0.0)],
    ids=["effort", "velocity"],
)
def test_zero_lets_go(rig, drive, zero) -> None:
    repeat(rig, FORWARD, 0.5)
    drive.present_pose = tilted(pitch=-55.0)
    repeat(rig, FORWARD, 0.5)
    assert drive.effort == (0.0, 0.0)
    rig.tell(A, zero)
    rig.tell(A, BACKWARD)
    assert drive.effort[0] == pytest.approx(-0.4, abs=1e-4)
    assert not tilt_problem(rig.host)


def test_it_is_stopped_again_when_it_tilts_further(rig, drive) -> None:
    repeat(rig, FORWARD, 0.5)
    drive.present_pose = tilted(pitch=-55.0)
    rig.run(0.1)
    for message in (ZERO, FORWARD):
        rig.tell(A, message)
    drive.present_pose = tilted(pitch=-64.0)
    repeat(rig, FORWARD, 0.5)
    assert drive.effort[0] == pytest.approx(0.4, abs=1e-4)
    drive.present_pose = tilted(pitch=-66.0)
    repeat(rig, FORWARD, 0.5)
    assert drive.effort == (0.0, 0.0)
    assert rig.host.counters["tilt"] == 2


def test_once_level_the_limits_are_the_first_ones_again(rig, drive) -> None:
    repeat(rig, FORWARD, 0.5)
    drive.present_pose = tilted(pitch=-55.0)
    rig.run(0.1)
    rig.tell(A, ZERO)
    repeat(rig, BACKWARD, 0.5)
    drive.present_pose = tilted(pitch=-10.0)
    repeat(rig, BACKWARD, 0.5)
    assert drive.effort[0] == pytest.approx(-0.4, abs=1e-4)
    drive.present_pose = tilted(pitch=-51.0)
    repeat(rig, BACKWARD, 0.5)
    assert drive.effort == (0.0, 0.0)


def test_a_waypoint_ends_and_a_new_one_may_be_set(rig, drive) -> None:
    def start() -> None:
        rig.tell(A, SetLocalWaypoint(x=5.0, y=0.0))
        rig.tell(A, SetTravelSpeed(0.5))
        for _ in range(10):
            rig.run(0.1)
            rig.tell(A, QueryTime(0xFF))

    start()
    assert drive.effort[0] > 0.1
    drive.present_pose = tilted(pitch=-55.0)
    rig.run(0.2)
    assert drive.effort == (0.0, 0.0)
    assert rig.ask(A, QueryTravelSpeed()).speed == pytest.approx(0.0, abs=1e-3)
    start()
    assert drive.effort[0] > 0.1, "set on purpose, in the knowledge of the tilt"


def test_the_allowance_counts_from_the_tilt_at_which_it_was_stopped() -> None:
    guard = TiltGuard(LIMITS)
    assert guard.allows(0.5)
    assert guard.problem(tilted(pitch=-70.0))
    assert guard.holds
    assert not guard.allows(1.0)
    guard.let_go()
    assert guard.allows(1.1)
    assert not guard.problem(tilted(pitch=-(70.0 + math.degrees(STEP) - 0.5)))
    assert guard.problem(tilted(pitch=-(70.0 + math.degrees(STEP) + 0.5)))


@pytest.mark.parametrize("limit", ["pitch = 4.0", "roll = 181.0", 'pitch = "off"', "yaw = 10.0"])
def test_limits_without_sense_are_refused(tmp_path, limit) -> None:
    file = tmp_path / "robot.toml"
    file.write_text(f'extends = "inc1"\n[tilt_guard]\n{limit}\n')
    with pytest.raises(ConfigError, match=f"tilt_guard.{limit.split()[0]}"):
        load(file)


def test_inc1_has_limits_that_its_chassis_knows() -> None:
    assert chassis_of(robot_model(load("inc1"))).tilt_guard == TiltSetup(math.radians(60.0), math.radians(45.0))


class FakeStability:
    """A robot whose margin of tipping the test sets, in degrees."""

    def __init__(self, margin: float = 60.0) -> None:
        self.setup = StabilitySetup()
        self.degrees = margin
        self.limits = True

    def limiting(self) -> Margin:
        return Margin(math.radians(self.degrees), "rear")

    def factor(self, margin: Margin) -> float:
        return StabilityMonitor.factor(self, margin)

    def text(self, margin: Margin) -> str:
        return f"{math.degrees(margin.angle):.0f} degrees from tipping backward"


def test_a_small_margin_of_tipping_stops_the_robot_as_a_tilt_does():
    stability = FakeStability()
    guard = TiltGuard(None, stability)
    assert guard.problem(tilted()) == ""
    assert guard.factor == 1.0
    assert guard.allows(9.9)
    stability.degrees = 9.0
    assert guard.problem(tilted()) == ""
    assert guard.factor == pytest.approx(0.5), "it drives more slowly, the nearer it is to tipping"
    stability.degrees = 5.0
    assert guard.problem(tilted()).startswith("5 degrees from tipping backward: the tracks or wheels stop")
    assert guard.factor == 0.25
    assert not guard.allows(10.0)
    guard.let_go()
    assert guard.allows(10.1), "to drive back"
    stability.degrees = 4.0
    assert guard.problem(tilted()) == ""
    stability.degrees = 2.5
    assert "2 degrees from tipping" in guard.problem(tilted())
    guard.let_go()
    stability.degrees = 30.0
    assert guard.problem(tilted()) == ""
    stability.degrees = 5.9
    assert guard.problem(tilted()), "level again, its limits are the first ones"


def test_an_aid_that_is_off_stops_and_slows_nothing():
    stability = FakeStability(-10.0)
    stability.limits = False
    guard = TiltGuard(None, stability)
    assert guard.problem(tilted()) == ""
    assert guard.factor == 1.0
    assert guard.problem(tilted(pitch=100.0)) == "", "nor has it limits of the tilt"


def test_efforts_and_velocities_are_reduced_near_tipping(make, drive):
    stability = FakeStability(9.0)
    vehicle = Vehicle(drive, stability=stability)
    rig = make(PrimitiveDriver(vehicle), AccessControl(default_authority=1, timeout=5), Management(), Events())
    for message in (RequestControl(200), Resume(), FORWARD):
        rig.tell(A, message)
    rig.run(0.2)
    assert drive.effort[0] == pytest.approx(0.2, abs=1e-4)
    stability.degrees = 60.0
    rig.run(0.2)
    assert drive.effort[0] == pytest.approx(0.4, abs=1e-4), "and are what was commanded when it is safe again"
    stability.degrees = 3.0
    rig.run(0.2)
    assert drive.effort == (0.0, 0.0)
    assert "tipping" in vehicle.pilot.tilt_problem
