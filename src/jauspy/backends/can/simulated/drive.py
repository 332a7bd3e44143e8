"""A simulated servo drive: a `canopen.LocalNode` with the state machine and the watchdogs of CiA 402."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Final

import canopen

from jauspy.backends.can import pdo
from jauspy.backends.can.cia402 import (
    HOMING_ATTAINED,
    LIMIT_ACTIVE,
    NEW_SETPOINT,
    STATUS_OF,
    TARGET_REACHED,
    DriveState,
    Mode,
    next_state,
)
from jauspy.backends.can.simulated.axes import Axis
from jauspy.backends.can.units import DriveUnits
from jauspy.platform.joints import ControlMode
from jauspy.platform.servo_drives import DriveSetup

FAULTS: Final = {
    "overcurrent": (0x2310, 0x03),
    "overvoltage": (0x3210, 0x05),
    "undervoltage": (0x3220, 0x05),
    "overtemperature": (0x4310, 0x09),
    "encoder": (0x7305, 0x21),
    "blocked": (0x7121, 0x21),
}
"""Error code and error register of faults on demand."""

BEHAVIOURS: Final = {"normal": 0, "silent": 1, "restart": 2, "deaf": 3}
"""Other behaviours on demand: the drive sends no PDO and no emergency, restarts, or ignores SYNC."""

FAULT_OBJECT: Final = 0x2F00
BEHAVIOUR_OBJECT: Final = 0x2F01
TEMPERATURE_OBJECT: Final = 0x2F10
"""Objects of simulated drives only: writing a code makes that fault."""

COMMAND_TIMEOUT: Final = 0.1
"""Seconds without SYNC, or without a command, after which an enabled drive stops."""

WRONG_LENGTH: Final = 0x8210
"""The error code of a command (RPDO) of another length, which is told once, ignored, and no fault."""

FIRST_SENT: Final = 0x1800
"""The index of the parameter of the first PDO that a drive sends; those that it takes have lower ones."""

WRITABLE: Final = frozenset({0x6040, 0x6060, 0x6071, 0x607A, 0x60FF})
"""Objects that may be mapped into commands."""

START_HOMING: Final = 0x10
"""Bit of the controlword."""

MODES: Final = {
    Mode.PROFILE_POSITION: (0x607A, ControlMode.POSITION),
    Mode.CYCLIC_POSITION: (0x607A, ControlMode.POSITION),
    Mode.CYCLIC_VELOCITY: (0x60FF, ControlMode.VELOCITY),
    Mode.CYCLIC_TORQUE: (0x6071, ControlMode.EFFORT),
}
"""The object with the target of each mode."""

STANDSTILL: Final = 0.01
"""rad/s or m/s below which a fault reaction has ended."""


@dataclass(slots=True)
class Consumed:
    """A heartbeat that the drive watches (1016h)."""

    node: int
    timeout: float
    last: float | None = None


class SimulatedDrive:
    """One drive. `step` is called as time passes, `on_sync` at SYNC; the network calls the rest."""

    def __init__(
        self,
        setup: DriveSetup,
        units: DriveUnits,
        axis: Axis,
        dictionary: canopen.ObjectDictionary,
        network: canopen.Network,
    ) -> None:
        self.setup = setup
        self.axis = axis
        self.node = canopen.LocalNode(setup.node, dictionary)
        self.state = DriveState.SWITCH_ON_DISABLED
        self.mode = 0
        self.keeps_home = False
        """True if it is homed after each start."""
        self.homed = setup.homing is None
        self._home_counts = 0
        """Offset of the encoder from the reported position, before the home position is found."""
        self._homing_way = 0.0
        self._brake_releases_at = 0.0
        self.silent = self.deaf = False
        self.serial = 1000 + setup.node if setup.serial is None else setup.serial
        self._units = units
        self._network = network
        self._now = 0.0
        self._control = 0
        self._targets = {0x607A: 0, 0x60FF: 0, 0x6071: 0}
        self._code = self._register = 0
        self._pending: dict[int, bytes] = {}
        self.ignored = 0
        """Commands of another length than is mapped."""
        self._layouts: dict[int, tuple[struct.Struct, tuple[int, ...]]] = {}
        self._last_sync: float | None = None
        self._last_command: float | None = None
        self._syncs = 0
        self._consumed: Consumed | None = None
        self._error_since: float | None = None
        self._restart_due = False
        self._values: dict[int, Callable[[], int]] = {
            0x1001: lambda: self._register,
            0x603F: lambda: self._code,
            0x6041: self._statusword,
            0x6061: lambda: self.mode,
            0x6064: self._counts,
            0x606C: lambda: self._units.velocity_counts(self.axis.velocity),
            0x6077: lambda: self._units.torque(self.axis.effort),
            0x6078: lambda: self._units.torque(self.axis.effort),  # a motor's current is proportional to its torque
            0x6079: lambda: 48_000,
            TEMPERATURE_OBJECT: lambda: 353,
        }
        network[setup.node] = self.node
        self.node.add_read_callback(self._read)
        self.node.add_write_callback(self._written)
        network.subscribe(0, self._on_nmt)
        for command in pdo.COMMANDS.values():
            network.subscribe(command.cob_id + setup.node, self._on_command)

    # --- the object dictionary --------------------------------------------------------------------------------------

    def _counts(self) -> int:
        counts = self._units.position_counts(self.axis.position) - self._home_counts
        return (counts + 2**31) % 2**32 - 2**31

    def _statusword(self) -> int:
        word = STATUS_OF[self.state]
        if self.mode == Mode.HOMING and self.homed and self.setup.homing is not None and not self._homing_way:
            word |= HOMING_ATTAINED | TARGET_REACHED
        torque = abs(self._units.torque(self.axis.effort))
        if self.state is DriveState.OPERATION_ENABLED and torque >= self.value_of(0x6072, 0):
            word |= LIMIT_ACTIVE
        return word

    def _read(self, *, index: int, subindex: int, **_: Any) -> int | None:
        if index == 0x1018 and subindex == 4:
            return self.serial
        found = self._values.get(index)
        return None if found is None else found()

    def _written(self, *, index: int, subindex: int, data: bytes, **_: Any) -> None:
        value = int.from_bytes(data, "little")
        if 0x1400 <= index < 0x1C00:
            self._layouts.clear()
        elif index == 0x1016 and subindex == 1:
            self._consume(value >> 16 & 0x7F, (value & 0xFFFF) / 1e3)
        elif index == 0x6060:
            self.mode = value
        elif index == 0x6040:
            self._apply_control(value)
        elif index == FAULT_OBJECT:
            self.fail(value, next((register for code, register in FAULTS.values() if code == value), 0x01))
        elif index == BEHAVIOUR_OBJECT:
            self.silent = value == BEHAVIOURS["silent"]
            self.deaf = value == BEHAVIOURS["deaf"]
            self._restart_due = value == BEHAVIOURS["restart"]

    def _consume(self, node: int, timeout: float) -> None:
        if self._consumed is not None:
            self._network.unsubscribe(pdo.HEARTBEAT + self._consumed.node, self._on_heartbeat)
        self._consumed = Consumed(node, timeout) if node and timeout else None
        if self._consumed is not None:
            self._network.subscribe(pdo.HEARTBEAT + node, self._on_heartbeat)

    def value_of(self, index: int, sub: int) -> int:
        """The present value of an object."""
        return int.from_bytes(self.node.get_data(index, sub), "little")

    # --- the network ------------------------------------------------------------------------------------------------

    def boot(self) -> None:
        """Start, as after power-on: nothing is configured."""
        self.node.data_store.clear()
        self.homed = self.homed or self.keeps_home
        if self.setup.homing is not None and not self.keeps_home:
            self.homed, self._homing_way = False, 0.0
            self._home_counts = self._units.position_counts(self.axis.position)
        self._layouts.clear()
        self._pending.clear()
        self._consume(0, 0.0)
        self._set_state(DriveState.SWITCH_ON_DISABLED)
        self._code = self._register = self._control = self.mode = 0
        self._last_sync = self._last_command = self._error_since = None
        self.silent = self.deaf = False
        self.node.nmt.send_command(129)  # Initialising: sends the boot-up message
        self.node.nmt.send_command(128)

    def _on_nmt(self, _id: int, data: bytearray, _at: float) -> None:
        if len(data) >= 2 and data[1] in {0, self.setup.node}:
            if data[0] in {129, 130}:
                self._restart_due = True
            elif data[0] in {2, 128} and self.state is DriveState.OPERATION_ENABLED:
                self.fail(0x8130, 0x11)

    def _on_heartbeat(self, _id: int, _data: bytearray, _at: float) -> None:
        if self._consumed is not None:
            self._consumed.last = self._now

    def _on_command(self, can_id: int, data: bytearray, _at: float) -> None:
        cob_id = can_id - self.setup.node
        layout = self._layout(next(command.parameter for command in pdo.COMMANDS.values() if command.cob_id == cob_id))
        if layout is None or len(data) != layout[0].size:
            self.ignored += 1
            if self.ignored == 1:
                self._send_emergency(WRONG_LENGTH, self._register)
            return
        self._pending[cob_id] = bytes(data)
        self._last_command = self._now

    def on_sync(self) -> None:
        """Take the commands that arrived since the last SYNC, and send what is mapped."""
        if self.node.nmt.state != "OPERATIONAL" or self.deaf:
            return
        self._last_sync = self._now
        self._syncs += 1
        for cob_id, data in self._pending.items():
            self._take(cob_id, data)
        self._pending.clear()
        if self.silent:
            return
        for report in (pdo.STATUS, pdo.SPEED):
            if not self._syncs % report.every:
                self._send(report)

    def _take(self, cob_id: int, data: bytes) -> None:
        number = next(command.parameter for command in pdo.COMMANDS.values() if command.cob_id == cob_id)
        found = self._layout(number)
        if found is None or len(data) != found[0].size:  # the mapping was changed meanwhile
            return
        layout, objects = found
        values = dict(zip(objects, layout.unpack(data), strict=True))
        mode = values.get(0x6060, self.mode)
        control = values.get(0x6040, self._control)
        if mode in MODES or mode in {Mode.HOMING, Mode.PROFILE_POSITION}:
            self.mode = mode
        if mode != Mode.PROFILE_POSITION or (control & NEW_SETPOINT and not self._control & NEW_SETPOINT):
            self._targets |= {index: value for index, value in values.items() if index in self._targets}
        if 0x6040 in values:
            self._apply_control(control)
        self._move()

    def _send(self, wanted: pdo.Pdo) -> None:
        found = self._layout(wanted.parameter)
        if found is None:
            return
        layout, objects = found
        values = [self._values[index]() for index in objects]
        self._network.send_message(wanted.cob_id + self.setup.node, layout.pack(*values))

    def _layout(self, parameter: int) -> tuple[struct.Struct, tuple[int, ...]] | None:
        """The layout that the master has written to the mapping of a PDO; None for one that the drive does not have."""
        found = self._layouts.get(parameter)
        if found is None:
            mapping = parameter + 0x200
            entries = [self.value_of(mapping, sub) for sub in range(1, self.value_of(mapping, 0) + 1)]
            objects = tuple(entry >> 16 for entry in entries)
            known = self._values.keys() if parameter >= FIRST_SENT else WRITABLE
            if any((entry & 0xFF, False) not in pdo.FORMATS or entry >> 16 not in known for entry in entries):
                return None
            codes = [pdo.FORMATS[entry & 0xFF, entry >> 16 in pdo.SIGNED] for entry in entries]
            found = self._layouts[parameter] = struct.Struct("<" + "".join(codes)), objects
        return found

    # --- CiA 402 ----------------------------------------------------------------------------------------------------

    def _apply_control(self, control: int) -> None:
        state = next_state(self.state, control, self._control)
        if self.state is DriveState.FAULT and state is not self.state:
            self._code = self._register = 0
            self._emergency()
        if state is DriveState.OPERATION_ENABLED and self.state is not state:
            self._last_sync = self._last_command = self._now
            if self.state is not DriveState.QUICK_STOP_ACTIVE:
                self._brake_releases_at = self._now + self.setup.brake_release
        self._control = control
        self._set_state(state)

    def _set_state(self, state: DriveState) -> None:
        self.state = state
        if state not in {
            DriveState.OPERATION_ENABLED,
            DriveState.QUICK_STOP_ACTIVE,
            DriveState.FAULT_REACTION_ACTIVE,
        }:
            self.axis.release()

    def _move(self) -> None:
        if self.state is DriveState.OPERATION_ENABLED and self._now < self._brake_releases_at:
            self.axis.release()
        elif self.state is DriveState.OPERATION_ENABLED and self.mode == Mode.HOMING:
            self._search_home()
        elif self.state is DriveState.OPERATION_ENABLED and self.mode in MODES:
            index, mode = MODES[Mode(self.mode)]
            raw, units = self._targets[index], self._units
            if mode is ControlMode.POSITION:
                self.axis.drive(mode, units.position(raw))
            elif mode is ControlMode.VELOCITY:
                self.axis.drive(mode, units.velocity(raw))
            else:
                self.axis.drive(mode, units.effort(raw))
        elif self.state in {DriveState.QUICK_STOP_ACTIVE, DriveState.FAULT_REACTION_ACTIVE}:
            self.axis.stop(units_deceleration(self._units, self.value_of(0x6085, 0)))

    def _search_home(self) -> None:
        """The switch of a simulated drive is where its encoder counts 0, or for the methods 35 and 37 where it is."""
        home = self._units.position(0)
        off = home - self.axis.position
        if not self._control & START_HOMING:
            self._homing_way = 0.0
            self.axis.stop(self._units.stop_deceleration)
        elif self.value_of(0x6098, 0) in {35, 37}:
            self._home_counts, self.homed = self._units.position_counts(self.axis.position), True
        elif not self.homed and not self._homing_way:
            self._homing_way = math.copysign(1.0, off)
        if self._homing_way and off * self._homing_way <= 0.0:
            self._homing_way, self._home_counts, self.homed = 0.0, 0, True
        if self._homing_way:
            speed = abs(self._units.velocity(self.value_of(0x6099, 1)))
            self.axis.drive(ControlMode.VELOCITY, self._homing_way * speed)
        else:
            self.axis.stop(self._units.stop_deceleration)

    def fail(self, code: int, register: int) -> None:
        """Go to Fault, by a quick stop if it moves, and send an emergency message."""
        if self.state in {DriveState.FAULT, DriveState.FAULT_REACTION_ACTIVE}:
            return
        powered = self.state in {DriveState.OPERATION_ENABLED, DriveState.QUICK_STOP_ACTIVE}
        self._code, self._register = code, register
        self._set_state(DriveState.FAULT_REACTION_ACTIVE if powered else DriveState.FAULT)
        self._move()
        self._emergency()

    def _emergency(self) -> None:
        self._send_emergency(self._code, self._register)

    def _send_emergency(self, code: int, register: int) -> None:
        if not self.silent:
            data = struct.pack("<HB5x", code, register)
            self._network.send_message(pdo.EMCY + self.setup.node, data)

    def step(self, now: float) -> None:
        """Check watchdogs and the following error; called after the axes have moved."""
        self._now = now
        if self._restart_due:
            self._restart_due = False
            self.boot()
        if self.state is DriveState.FAULT_REACTION_ACTIVE and abs(self.axis.velocity) < STANDSTILL:
            self._set_state(DriveState.FAULT)
        consumed = self._consumed
        if consumed is not None and consumed.last is not None and now - consumed.last > consumed.timeout:
            consumed.last = None
            self.fail(0x8130, 0x11)
        if self.state is DriveState.OPERATION_ENABLED:
            if self._last_sync is not None and now - self._last_sync > COMMAND_TIMEOUT:
                self.fail(0x8700, 0x11)
            elif self._last_command is not None and now - self._last_command > COMMAND_TIMEOUT:
                self.fail(0x8250, 0x11)
            self._check_following(now)

    def _check_following(self, now: float) -> None:
        window = self.value_of(0x6065, 0)
        if self.mode != Mode.CYCLIC_POSITION or window == 0xFFFFFFFF:
            self._error_since = None
            return
        if abs(self._targets[0x607A] - self._counts()) <= window:
            self._error_since = None
        elif self._error_since is None:
            self._error_since = now
        elif now - self._error_since > self.value_of(0x6066, 0) / 1e3:
            self.fail(0x8611, 0x21)


def units_deceleration(units: DriveUnits, raw: int) -> float:
    """The deceleration of a quick stop in rad/s^2 or m/s^2, of what was written to the drive."""
    return abs(units.velocity(raw)) or units.stop_deceleration
