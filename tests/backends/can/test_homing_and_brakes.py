"""Drives that do not know their position, that are braked, or that lack the cyclic synchronous modes."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from tests.backends.can.conftest import OpenCan, setup_of, simulated
from tests.backends.can.test_failing_drives import advance_until_fault
from tests.helpers.robot import described

from jauspy.backends.can.cia402 import DriveState, Mode
from jauspy.backends.can.faults import DriveFault
from jauspy.backends.can.master import Master
from jauspy.backends.can.robot import CanRobot
from jauspy.backends.can.simulated.axes import MotorAxis
from jauspy.backends.can.simulated.drive import SimulatedDrive
from jauspy.backends.can.simulated.fleet import DriveFleet
from jauspy.errors import ConfigError
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.servo_drives import Homing

WRIST = 4
HOMING = {"arm_4": {"homing": Homing(method=17, speed=0.5, timeout=10.0)}}


@pytest.fixture
def powered_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """Simulated drives forget their home positions when they start, as on a bus."""

    def forgetful(*arguments: Any, keeps_home: bool) -> DriveFleet:
        assert keeps_home
        return DriveFleet(*arguments)

    monkeypatch.setattr("jauspy.backends.can.robot.DriveFleet", forgetful)


def home(changes: dict[str, Any], announced: list[str]) -> None:
    model = replace(described("inc1")[1], can=setup_of(**changes))
    robot = CanRobot(
        model, setup_of(**changes), "virtual:motors", "empty", lambda master: master.home(announced.append)
    )
    try:
        assert simulated(robot, "arm_4").homed
        assert robot.drives["arm_4"].position == pytest.approx(0.0, abs=0.02)  # where its switch is
        assert robot.drives["arm_4"].position == pytest.approx(simulated(robot, "arm_4").axis.position, abs=1e-3)
        others = [drive for name, drive in robot.fleet.drives.items() if name != "arm_4"] if robot.fleet else []
        assert {drive.state for drive in others} == {DriveState.SWITCH_ON_DISABLED, DriveState.READY_TO_SWITCH_ON} & {
            drive.state for drive in others
        }
    finally:
        robot.close()


@pytest.mark.usefixtures("powered_on")
def test_nothing_moves_before_all_drives_know_their_position(
    open_can: OpenCan, monkeypatch: pytest.MonkeyPatch
) -> None:
    speeds: list[float] = []
    advance = MotorAxis.advance

    def watched(self: MotorAxis, dt: float) -> None:
        advance(self, dt)
        speeds.append(abs(self.velocity))

    monkeypatch.setattr(MotorAxis, "advance", watched)
    with pytest.raises(
        ConfigError, match=r"'arm_4' \(node 7\): position unknown since power-on: `jauspy can home ROBOT --bus virtual"
    ):
        open_can(**HOMING)
    assert max(speeds) == 0.0


@pytest.mark.usefixtures("powered_on")
def test_homing_moves_one_drive_to_its_switch_and_says_so() -> None:
    announced: list[str] = []
    home(HOMING, announced)
    assert announced == ["drive 'arm_4' (node 7) moves 'arm_link_3_to_arm_link_4' by homing method 17, 10 s at most"]


@pytest.mark.usefixtures("powered_on")
def test_homing_that_finds_nothing_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    made = MotorAxis.__init__

    def stuck(self: MotorAxis, *arguments: Any, **more: Any) -> None:
        made(self, *arguments, **more)
        self.blocked = True

    monkeypatch.setattr(MotorAxis, "__init__", stuck)
    with pytest.raises(DriveFault, match=r"'arm_4' .* did not find its home position: it took more than 0.3 s"):
        home({"arm_4": {"homing": Homing(method=17, speed=0.5, timeout=0.3)}}, [])


def test_simulated_drives_in_this_process_know_their_home_also_after_a_restart(open_can: OpenCan) -> None:
    robot = open_can(**HOMING)
    assert robot.master.running
    simulated(robot, "arm_4").boot()
    assert "'arm_4' (node 7), which moves 'arm_link_3_to_arm_link_4', has restarted" in advance_until_fault(robot)
    robot.advance(0.1)  # Reset
    assert robot.master.running


@pytest.mark.usefixtures("powered_on")
def test_a_drive_on_a_bus_that_restarts_needs_its_home_again() -> None:
    changes = setup_of(**HOMING)
    robot = CanRobot(replace(described("inc1")[1], can=changes), changes, "virtual:motors", "empty", home_and_start)
    try:
        simulated(robot, "arm_4").boot()
        advance_until_fault(robot)
        with pytest.raises(DriveFault, match=r"'arm_4' \(node 7\): position unknown since power-on: `jauspy can home"):
            robot.advance(0.1)
    finally:
        robot.close()


def home_and_start(master: Master) -> None:
    master.home(lambda _: None)
    master.start()


@pytest.mark.slow
def test_a_joint_waits_until_its_brake_has_released(open_can: OpenCan) -> None:
    robot = open_can(arm_5={"brake_release": 0.3})
    arm = robot.groups["arm"]
    arm.command([None, None, None, None, Target(ControlMode.POSITION, 0.5)])
    robot.advance(0.2)
    assert arm.state().positions[WRIST] == pytest.approx(0.0, abs=1e-3)
    robot.advance(1.5)
    assert arm.state().positions[WRIST] == pytest.approx(0.5, abs=1e-3)
    arm.hold()  # by quick stop, with power: the brake stays released
    robot.advance(0.1)
    arm.command([None, None, None, None, Target(ControlMode.POSITION, 0.0)])
    robot.advance(0.25)
    assert arm.state().positions[WRIST] < 0.45


@pytest.fixture
def profile_position_only(monkeypatch: pytest.MonkeyPatch) -> None:
    read = SimulatedDrive._read

    def reported(self: SimulatedDrive, *, index: int, subindex: int, **more: object) -> int | None:
        if index == 0x6502 and self.setup.name == "arm_5":
            return 0b1
        return read(self, index=index, subindex=subindex, **more)

    monkeypatch.setattr(SimulatedDrive, "_read", reported)


@pytest.mark.slow
@pytest.mark.usefixtures("profile_position_only")
@pytest.mark.parametrize(
    ("target", "reached"),
    [
        (Target(ControlMode.POSITION, 0.5), pytest.approx(0.5, abs=0.01)),
        pytest.param(Target(ControlMode.VELOCITY, 0.4), pytest.approx(0.6, abs=0.15), marks=pytest.mark.slow),
        (Target(ControlMode.EFFORT, 6.0), pytest.approx(0.0, abs=1e-3)),
    ],
    ids=["position", "velocity", "effort"],
)
def test_profile_position_is_used_where_the_drive_has_nothing_better(
    robot: CanRobot, target: Target, reached: object, caplog: pytest.LogCaptureFixture
) -> None:
    robot.groups["arm"].command([None, None, None, None, target])
    robot.advance(1.5)
    assert robot.groups["arm"].state().positions[WRIST] == reached
    if target.mode is ControlMode.EFFORT:
        assert "has no mode for efforts" in caplog.text
    else:
        assert simulated(robot, "arm_5").mode == Mode.PROFILE_POSITION


def test_a_drive_at_its_limit_says_so_when_it_does_not_follow(robot: CanRobot) -> None:
    axis = simulated(robot, "arm_1").axis
    assert isinstance(axis, MotorAxis)
    axis._inertia = 1e6  # no torque moves it
    robot.groups["arm"].command([Target(ControlMode.POSITION, 1.0), *[None] * 4])
    text = advance_until_fault(robot, 1.5)
    assert "does not follow: " in text
    assert "(it says that an internal limit is active)" in text
