"""CiA 402 without I/O: states of a drive, controlwords that lead to them, and texts of errors."""

from __future__ import annotations

from collections.abc import Iterator
from enum import Enum, IntEnum
from typing import Final


class DriveState(Enum):
    """The states of a drive's power (CiA 402-2), named as in the standard."""

    NOT_READY = "Not Ready to Switch On"
    SWITCH_ON_DISABLED = "Switch On Disabled"
    READY_TO_SWITCH_ON = "Ready to Switch On"
    SWITCHED_ON = "Switched On"
    OPERATION_ENABLED = "Operation Enabled"
    QUICK_STOP_ACTIVE = "Quick Stop Active"
    FAULT_REACTION_ACTIVE = "Fault Reaction Active"
    FAULT = "Fault"


STATUS_PATTERNS: Final = (
    (0x4F, 0x00, DriveState.NOT_READY),
    (0x4F, 0x40, DriveState.SWITCH_ON_DISABLED),
    (0x6F, 0x21, DriveState.READY_TO_SWITCH_ON),
    (0x6F, 0x23, DriveState.SWITCHED_ON),
    (0x6F, 0x27, DriveState.OPERATION_ENABLED),
    (0x6F, 0x07, DriveState.QUICK_STOP_ACTIVE),
    (0x4F, 0x0F, DriveState.FAULT_REACTION_ACTIVE),
    (0x4F, 0x08, DriveState.FAULT),
)
"""Mask, value and state of a statusword (6041h)."""

STATUS_OF: Final = {
    DriveState.NOT_READY: 0x0000,
    DriveState.SWITCH_ON_DISABLED: 0x0240,
    DriveState.READY_TO_SWITCH_ON: 0x0221,
    DriveState.SWITCHED_ON: 0x0223,
    DriveState.OPERATION_ENABLED: 0x0237,
    DriveState.QUICK_STOP_ACTIVE: 0x0217,
    DriveState.FAULT_REACTION_ACTIVE: 0x021F,
    DriveState.FAULT: 0x0218,
}
"""A statusword of each state, as simulated drives send it."""

TARGET_REACHED: Final = 0x0400
LIMIT_ACTIVE: Final = 0x0800
HOMING_ATTAINED: Final = 0x1000
HOMING_ERROR: Final = 0x2000
"""Bits of the statusword; the last two in the mode `HOMING`."""

NEW_SETPOINT: Final = 0x10
CHANGE_IMMEDIATELY: Final = 0x20
"""Bits of the controlword in the mode `PROFILE_POSITION`; the first one's rising edge makes the drive take it."""


def state_of(statusword: int) -> DriveState:
    """The state in a statusword."""
    for mask, value, state in STATUS_PATTERNS:
        if statusword & mask == value:
            return state
    return DriveState.NOT_READY


class Controlword(IntEnum):
    """Controlwords (6040h)."""

    DISABLE_VOLTAGE = 0x00
    QUICK_STOP = 0x02
    SHUTDOWN = 0x06
    SWITCH_ON = 0x07
    ENABLE_OPERATION = 0x0F
    START_HOMING = 0x1F
    FAULT_RESET = 0x80


class Mode(IntEnum):
    """Modes of operation (6060h)."""

    PROFILE_POSITION = 1
    HOMING = 6
    CYCLIC_POSITION = 8
    CYCLIC_VELOCITY = 9
    CYCLIC_TORQUE = 10


def towards_operation(state: DriveState) -> Controlword:
    """The controlword for the next step to Operation Enabled. A fault is not reset by it."""
    match state:
        case DriveState.SWITCH_ON_DISABLED:
            return Controlword.SHUTDOWN
        case DriveState.READY_TO_SWITCH_ON:
            return Controlword.SWITCH_ON
        case DriveState.SWITCHED_ON | DriveState.OPERATION_ENABLED | DriveState.QUICK_STOP_ACTIVE:
            return Controlword.ENABLE_OPERATION
        case _:
            return Controlword.DISABLE_VOLTAGE


def next_state(state: DriveState, control: int, before: int) -> DriveState:
    """The state of a drive after a controlword, `before` being the last one. Quick stop holds (605Ah is 5..8)."""
    if state is DriveState.FAULT:
        reset = control & Controlword.FAULT_RESET and not before & Controlword.FAULT_RESET
        return DriveState.SWITCH_ON_DISABLED if reset else state
    if state in {DriveState.NOT_READY, DriveState.FAULT_REACTION_ACTIVE}:
        return state
    if not control & 0x02:  # disable voltage
        return DriveState.SWITCH_ON_DISABLED
    if not control & 0x04:  # quick stop
        powered = state in {DriveState.OPERATION_ENABLED, DriveState.QUICK_STOP_ACTIVE}
        return DriveState.QUICK_STOP_ACTIVE if powered else DriveState.SWITCH_ON_DISABLED
    wanted = (
        DriveState.READY_TO_SWITCH_ON
        if not control & 0x01
        else DriveState.OPERATION_ENABLED
        if control & 0x08
        else DriveState.SWITCHED_ON
    )
    if state is DriveState.SWITCH_ON_DISABLED:
        return DriveState.READY_TO_SWITCH_ON if wanted is DriveState.READY_TO_SWITCH_ON else state
    if state is DriveState.QUICK_STOP_ACTIVE:
        return wanted if wanted is DriveState.OPERATION_ENABLED else state
    if state is DriveState.READY_TO_SWITCH_ON and wanted is DriveState.OPERATION_ENABLED:
        return DriveState.SWITCHED_ON
    return wanted


REGISTER_BITS: Final = ("generic", "current", "voltage", "temperature", "communication", "device profile", "", "vendor")
"""The bits of the error register (1001h), the lowest first."""


def register_text(register: int) -> str:
    """The text of an error register, as in `current, voltage`."""
    return ", ".join(_bits(register)) or "none"


def _bits(register: int) -> Iterator[str]:
    for bit, name in enumerate(REGISTER_BITS):
        if register >> bit & 1 and name:
            yield name


ERRORS: Final = {
    0x2310: "overcurrent at the output",
    0x2320: "short circuit or earth fault",
    0x3210: "DC link overvoltage",
    0x3220: "DC link undervoltage",
    0x4210: "the device is too hot",
    0x4310: "the drive is too hot",
    0x5441: "safe torque off",
    0x6320: "a parameter is wrong",
    0x7121: "the motor is blocked",
    0x7300: "a sensor failed",
    0x7305: "the encoder failed",
    0x8110: "CAN overrun: frames were lost",
    0x8120: "CAN in error passive mode",
    0x8130: "the heartbeat of the robot stopped",
    0x8140: "recovered from bus-off",
    0x8210: "a command (RPDO) of a wrong length was ignored",
    0x8250: "a command (RPDO) did not arrive in time",
    0x8400: "the speed is not what it should be",
    0x8611: "following error: the joint does not follow its command",
    0x8612: "a position limit was reached",
    0x8700: "SYNC was lost",
}
"""Error codes (603Fh and emergency messages) of CiA 301 and CiA 402."""

ERROR_CLASSES: Final = {
    0x1000: "a general error",
    0x2000: "an error of the current",
    0x3000: "an error of the voltage",
    0x4000: "an error of the temperature",
    0x5000: "an error of the drive's hardware",
    0x6000: "an error of the drive's software",
    0x7000: "an error of an additional module",
    0x8000: "an error of monitoring",
    0x9000: "an external error",
    0xF000: "an error of the drive's own",
}


def error_text(code: int) -> str:
    """The text of an error code, as in `overcurrent at the output (2310h)`."""
    if not code:
        return "no error"
    known = ERRORS.get(code) or ERROR_CLASSES.get(code & 0xF000, "an unknown error")
    return f"{known} ({code:04X}h)"
