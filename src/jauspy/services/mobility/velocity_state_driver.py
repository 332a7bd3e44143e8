"""VelocityStateDriver: closed-loop velocities in the platform's frame (AS6009)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import IntEnum
from typing import Any, Final, TypeAlias

from jauspy.messages.mobility import (
    QueryAccelerationLimit,
    QueryVelocityCommand,
    QueryVelocityCommandExt,
    ReportAccelerationLimit,
    ReportVelocityCommand,
    ReportVelocityCommandExt,
    SetAccelerationLimit,
    SetVelocityCommand,
    SetVelocityCommandExt,
)
from jauspy.platform.chassis import Chassis
from jauspy.services.mobility.courses import VelocityCourse
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.mobility.velocity_control import STANDSTILL, AccelerationLimits, PlanarVelocity, clamp

ROUNDING: Final = 1e-3
"""m/s, rad/s: a velocity at its limit may have been rounded upward on the wire, where rates have steps as large."""
MIN_ACCELERATION_LIMIT: Final = 0.05
"""m/s^2, rad/s^2: a limit of zero would keep a moving platform moving for ever."""


@dataclass(frozen=True, slots=True)
class VelocityRange:
    """From the least to the most velocity, of both axes."""

    least: PlanarVelocity
    most: PlanarVelocity

    @classmethod
    def of(cls, chassis: Chassis) -> VelocityRange:
        """All that the chassis can do."""
        return cls(
            PlanarVelocity(-chassis.max_speed, -chassis.max_turn_rate),
            PlanarVelocity(chassis.max_speed, chassis.max_turn_rate),
        )

    def contains(self, motion: PlanarVelocity) -> bool:
        """True for a motion that is neither too fast nor too slow."""
        return _within(self.least.speed, motion.speed, self.most.speed) and _within(
            self.least.turn_rate, motion.turn_rate, self.most.turn_rate
        )


def _within(least: float, value: float, most: float) -> bool:
    return least - ROUNDING <= value <= most + ROUNDING


def clamped(motion: PlanarVelocity, chassis: Chassis) -> PlanarVelocity:
    """The motion, or as much of it as the chassis can do."""
    return PlanarVelocity(clamp(motion.speed, chassis.max_speed), clamp(motion.turn_rate, chassis.max_turn_rate))


def updated_limits(limits: AccelerationLimits, msg: SetAccelerationLimit, chassis: Chassis) -> AccelerationLimits:
    """The limits after a command; what it leaves out stays, and the chassis sets the upper bound."""
    x, yaw = msg.acceleration_x, msg.yaw_acceleration
    if msg.command_type == SetAccelerationLimit.CommandType.MAX_ACCELERATION:
        return replace(
            limits,
            acceleration=_limit(x, limits.acceleration, chassis.acceleration),
            turn_acceleration=_limit(yaw, limits.turn_acceleration, chassis.turn_acceleration),
        )
    return replace(
        limits,
        deceleration=_limit(x, limits.deceleration, chassis.deceleration),
        turn_deceleration=_limit(yaw, limits.turn_deceleration, chassis.turn_acceleration),
    )


def _limit(wanted: float | None, present: float, most: float) -> float:
    return present if wanted is None else min(most, max(MIN_ACCELERATION_LIMIT, abs(wanted)))


Command: TypeAlias = SetVelocityCommand | SetVelocityCommandExt

_KINDS: Final = 4
"""The wider form has each kind of command twice: over ground, and relative to the medium, here the same."""


class CommandKind(IntEnum):
    """What a velocity command sets."""

    CURRENT = 0
    MAX = 1
    MIN = 2
    DEFAULT = 3


class VelocityStateDriver(Driver, urn="urn:jaus:jss:mobility:VelocityStateDriver"):
    """Drives at a speed along x and turns at a rate about z, within limits that the client may narrow.

    A current or default command counts as a whole: what it leaves out is zero. A limit that is left out stays. What is
    set for other axes is ignored, and not reported.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._range = VelocityRange.of(vehicle.chassis)
        self._limits = vehicle.pilot.limits
        self._default = STANDSTILL
        self._current = STANDSTILL

    # --- predicates

    def is_current_velocity_cmd(self, msg: Command) -> bool:
        """The command is to be carried out, rather than to be kept."""
        return _kind(msg) is CommandKind.CURRENT

    def is_command_value_valid(self, msg: Command) -> bool:
        """The velocities are within the limits."""
        valid = self._range.contains(_motion(msg))
        if not valid:
            self.host.count("velocity_out_of_range", f"{msg}")
        return valid

    # --- actions

    def set_current_velocity_command(self, msg: Command) -> None:
        """Drive so, from now on."""
        self._current = _motion(msg)
        self.vehicle.pilot.follow(self, VelocityCourse(self._current, self._limits))

    def set_current_velocity_command_ext(self, msg: Command) -> None:
        """As `set_current_velocity_command`."""
        self.set_current_velocity_command(msg)

    def set_velocity_limit(self, msg: Command) -> None:
        """Keep a limit, or the default. Limits beyond what the chassis can do are what it can do."""
        match _kind(msg):
            case CommandKind.MAX:
                self._range = VelocityRange(self._range.least, self._limited(msg, self._range.most))
            case CommandKind.MIN:
                self._range = VelocityRange(self._limited(msg, self._range.least), self._range.most)
            case CommandKind.DEFAULT:
                self._default = _motion(msg)

    def set_velocity_limit_ext(self, msg: Command) -> None:
        """As `set_velocity_limit`."""
        self.set_velocity_limit(msg)

    def set_acceleration_limit(self, msg: SetAccelerationLimit) -> None:
        """How fast the motion may change; acts on the present command, too."""
        self._limits = updated_limits(self._limits, msg, self.vehicle.chassis)
        if self.drives:
            self.vehicle.pilot.follow(self, VelocityCourse(self._current, self._limits))

    def reset_cmd_velocity_to_default(self) -> None:
        """Runs when Ready is left: the platform stops. The default is what is reported; it drives nothing."""
        self.vehicle.pilot.stop()
        self._current = self._default

    def control_lost(self) -> None:
        """The next client finds the limits of the chassis, and no default."""
        super().control_lost()
        self._range, self._limits = VelocityRange.of(self.vehicle.chassis), self.vehicle.pilot.limits
        self._default = self._current = STANDSTILL

    def taken_over(self) -> None:
        """The command ends."""
        self._current = self._default

    def _limited(self, msg: Command, present: PlanarVelocity) -> PlanarVelocity:
        speed = present.speed if msg.velocity_x is None else msg.velocity_x
        turn_rate = present.turn_rate if msg.yaw_rate is None else msg.yaw_rate
        return clamped(PlanarVelocity(speed, turn_rate), self.vehicle.chassis)

    # --- reports

    def report_velocity_command(self, query: QueryVelocityCommand) -> ReportVelocityCommand:
        """The command of the kind that is asked for; of an unknown kind the current one."""
        kind, motion = self._asked(query.command_type)
        return ReportVelocityCommand(command_type=kind, velocity_x=motion.speed, yaw_rate=motion.turn_rate)

    def report_velocity_command_ext(self, query: QueryVelocityCommandExt) -> ReportVelocityCommandExt:
        """As `report_velocity_command`."""
        _, motion = self._asked(query.command_type % _KINDS)
        kind = query.command_type if query.command_type < 2 * _KINDS else CommandKind.CURRENT
        return ReportVelocityCommandExt(command_type=kind, velocity_x=motion.speed, yaw_rate=motion.turn_rate)

    def _asked(self, kind: int) -> tuple[CommandKind, PlanarVelocity]:
        motions = {
            CommandKind.CURRENT: self._current,
            CommandKind.MAX: self._range.most,
            CommandKind.MIN: self._range.least,
            CommandKind.DEFAULT: self._default,
        }
        known = CommandKind(kind) if kind in tuple(CommandKind) else CommandKind.CURRENT
        return known, motions[known]

    def report_acceleration_limit(self, query: QueryAccelerationLimit) -> ReportAccelerationLimit:
        """The limits of acceleration, or those of deceleration."""
        limits, kinds = self._limits, ReportAccelerationLimit.CommandType
        if query.command_type == kinds.MAX_DECELERATION:
            x, yaw, kind = limits.deceleration, limits.turn_deceleration, kinds.MAX_DECELERATION
        else:
            x, yaw, kind = limits.acceleration, limits.turn_acceleration, kinds.MAX_ACCELERATION
        return ReportAccelerationLimit(command_type=kind, acceleration_x=x, yaw_acceleration=yaw)


def _kind(msg: Any) -> CommandKind:
    return CommandKind(msg.command_type % _KINDS)


def _motion(msg: Command) -> PlanarVelocity:
    return PlanarVelocity(msg.velocity_x or 0.0, msg.yaw_rate or 0.0)
