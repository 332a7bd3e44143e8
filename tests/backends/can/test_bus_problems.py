"""What can be wrong with a bus or what is on it: each is noticed, nothing moves, and a sentence says what to do."""

from __future__ import annotations

import errno
from dataclasses import replace
from pathlib import Path

import can
import pytest
from tests.backends.can.conftest import OpenCan
from tests.backends.can.test_failing_drives import CYCLE, advance_until_fault, set_in_motion

from jauspy.backends.can import pdo
from jauspy.backends.can.cia402 import DriveState
from jauspy.backends.can.faults import DriveFault
from jauspy.backends.can.robot import CanRobot
from jauspy.backends.can.simulated import fleet
from jauspy.backends.can.simulated.axes import MotorAxis
from jauspy.backends.can.simulated.drive import SimulatedDrive
from jauspy.backends.can.units import unwrapped
from jauspy.errors import ConfigError
from jauspy.robot.can_drives import identity_of


def refuse_frames(robot: CanRobot, error: Exception) -> None:
    assert robot.virtual_bus is not None

    def send(message: can.Message, timeout: float | None = None) -> None:
        raise error

    robot.virtual_bus.near.send = send  # type: ignore[method-assign] - the adapter's driver


@pytest.mark.slow
def test_a_bus_that_takes_no_frames_is_too_full(robot: CanRobot) -> None:
    set_in_motion(robot)
    refuse_frames(robot, can.CanOperationError("No buffer space available"))
    text = advance_until_fault(robot)
    assert "takes no more frames (No buffer space available): the bus is too full or nobody acknowledges" in text


@pytest.mark.slow
def test_bus_off(robot: CanRobot) -> None:
    set_in_motion(robot)
    robot.master.bus_failed("bus-off")
    text = advance_until_fault(robot)
    assert "virtual:motors is bus-off: check bit rate, wiring and termination; then Reset" in text
    robot.advance(CYCLE)  # recovers


def test_a_bus_that_is_off_is_restarted_by_its_own_command(open_can: OpenCan) -> None:
    robot = open_can()
    robot.master.setup = replace(robot.master.setup, bus="socketcan:can0")
    robot.master.bus_failed("bus-off")
    text = advance_until_fault(robot)
    assert "socketcan:can0 is bus-off: check bit rate, wiring and termination; restart it (`ip link set can0" in text


def test_a_cable_that_is_pulled(robot: CanRobot) -> None:
    set_in_motion(robot)
    refuse_frames(robot, can.CanOperationError("Failed to transmit: Network is down", errno.ENETDOWN))
    text = advance_until_fault(robot)
    assert "takes no more frames (Failed to transmit: Network is down [Error Code 100]): it is down: `ip link" in text
    robot.drives["arm_1"].configured = False
    with pytest.raises(DriveFault, match="takes no frames: Failed to transmit: Network is down"):
        robot.advance(CYCLE)


@pytest.mark.slow
def test_time_in_which_the_robot_sent_no_sync_is_not_the_drives(robot: CanRobot) -> None:
    set_in_motion(robot)
    robot._ticker._now += 0.09
    robot.advance(0.1)
    assert robot.master.running


def test_lost_sync_stops_the_drives_and_is_named(robot: CanRobot) -> None:
    set_in_motion(robot)
    assert robot.virtual_bus is not None
    robot.virtual_bus.loses = lambda message: message.arbitration_id == pdo.SYNC
    assert "has not answered SYNC for" in advance_until_fault(robot)
    for _ in range(60):
        robot._ticker.wait_cycle()
    assert {drive.state for drive in robot.fleet.drives.values()} == {DriveState.FAULT}
    assert robot.drives["left_track"].error_code == 0x8700


@pytest.mark.slow
def test_another_master_stops_the_robot(robot: CanRobot) -> None:
    set_in_motion(robot)
    assert robot.virtual_bus is not None
    for _ in range(5):
        robot.virtual_bus.far.send(can.Message(arbitration_id=pdo.SYNC, is_extended_id=False))
    assert "another master sends SYNC on virtual:motors: end it" in advance_until_fault(robot)


def test_a_robot_does_not_start_beside_another_master(open_can: OpenCan, monkeypatch: pytest.MonkeyPatch) -> None:
    step = fleet.DriveFleet.step

    def step_with_sync(self: fleet.DriveFleet, dt: float) -> None:
        self._port.send(can.Message(arbitration_id=pdo.SYNC, is_extended_id=False))
        step(self, dt)

    monkeypatch.setattr(fleet.DriveFleet, "step", step_with_sync)
    with pytest.raises(ConfigError, match="another master sends SYNC on virtual:motors already"):
        open_can()


def test_the_eds_file_of_another_drive_is_refused(open_can: OpenCan) -> None:
    with pytest.raises(
        ConfigError, match=r"'arm_1' \(node 4\) has the product code 402h, .* EDS file acme.eds is for 7h"
    ):
        open_can(arm_1={"vendor": 0xA115, "product": 7, "eds": "acme.eds"})


def test_swapped_drives_are_noticed_by_their_serial_numbers(open_can: OpenCan, monkeypatch: pytest.MonkeyPatch) -> None:
    other = {4: 1005, 5: 1004}
    read = SimulatedDrive._read

    def swapped(self: SimulatedDrive, *, index: int, subindex: int, **more: object) -> int | None:
        if (index, subindex) == (0x1018, 4) and self.setup.node in other:
            return other[self.setup.node]
        return read(self, index=index, subindex=subindex, **more)

    monkeypatch.setattr(SimulatedDrive, "_read", swapped)
    with pytest.raises(ConfigError, match=r"'arm_1' \(node 4\) has the serial number 1005, .* node ids are swapped"):
        open_can(arm_1={"serial": 1004}, arm_2={"serial": 1005})


def test_a_joint_beyond_its_limits_does_not_start(open_can: OpenCan, monkeypatch: pytest.MonkeyPatch) -> None:
    made = MotorAxis.__init__

    def elsewhere(self: MotorAxis, joint: object, position: float, *, endless: bool = False) -> None:
        made(self, joint, position, endless=endless)  # type: ignore[arg-type] - passed through
        self.position += 0.0 if endless else 4.0

    monkeypatch.setattr(MotorAxis, "__init__", elsewhere)
    with pytest.raises(ConfigError, match=r"beyond its limits .*check zero, sign, gear_ratio and encoder_counts"):
        open_can()


def test_too_many_drives_for_the_bit_rate(open_can: OpenCan) -> None:
    with pytest.raises(
        ConfigError, match=r"would be \d+ % full with 11 drives at 500000 bit/s: lower can.sync_rate to"
    ):
        open_can(bit_rate=500_000)


@pytest.mark.slow
def test_an_encoder_that_wraps_drives_on(open_can: OpenCan) -> None:
    robot = open_can(left_track={"zero": 2**31 - 20_000})
    robot.drive.set_effort(0.5, 0.0)
    robot.advance(2.0)
    counts = robot.drives["left_track"].counts
    assert counts is not None
    assert counts > 2**31
    assert robot.drive.pose().x == pytest.approx(1.8, abs=0.1)
    assert robot.drive.pose().yaw == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize(
    ("counts", "before", "after"),
    [(-(2**31), 2**31 - 1, 2**31), (2**31 - 1, -(2**31), -(2**31) - 1), (5, 3, 5), (3, 2**32 + 5, 2**32 + 3)],
)
def test_unwrapped(counts: int, before: int, after: int) -> None:
    assert unwrapped(counts, before) == after


@pytest.mark.slow
def test_scans_of_a_robot_behind_the_drives_have_its_time(open_can: OpenCan) -> None:
    robot = open_can(bus="virtual:kinematic")
    robot.advance(0.5)
    (lidar,) = robot.lidars.values()
    assert lidar.scan is not None
    assert robot.time - lidar.scan.time == pytest.approx(lidar.age, abs=1e-6)


def test_an_eds_file_must_be_one(tmp_path: Path) -> None:
    file = tmp_path / "drive.eds"
    file.write_text("[FileInfo]\n")
    with pytest.raises(ConfigError, match=r"drive\.eds: is not an EDS file: it has no section \[DeviceInfo\]"):
        identity_of(file)


def test_simulated_drives_have_the_identity_of_their_eds_file() -> None:
    assert identity_of(Path(fleet.__file__).with_name("drive.eds")) == (0xA115, 0x402)
