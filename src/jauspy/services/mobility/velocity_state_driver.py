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
from jauspy.services.mobility.velocity_control import STANDSTILL, AccelerationLimits, PlanarVelocity

VELOCITY_TOLERANCE: Final = 1e-3
"""m/s, rad/s: a velocity at its limit may have been rounded up by its field, whose steps are as large."""
MIN_ACCELERATION_LIMIT: Final = 0.05
"""m/s^2, rad/s^2; with a limit of zero a moving platform would never stop."""


@dataclass(frozen=True, slots=True)
class VelocityRange:
    """The minimal and maximal velocity of both axes."""

    minimum: PlanarVelocity
    maximum: PlanarVelocity

    @classmethod
    def of(cls, chassis: Chassis) -> VelocityRange:
        """The limits of the chassis."""
        sideways = chassis.max_speed if chassis.moves_sideways else 0.0
        return cls(
            PlanarVelocity(-chassis.max_speed, -chassis.max_turn_rate, -sideways),
            PlanarVelocity(chassis.max_speed, chassis.max_turn_rate, sideways),
        )

    def contains(self, velocity: PlanarVelocity) -> bool:
        """True for a velocity within the range, but for `VELOCITY_TOLERANCE`."""
        return (
            _within(self.minimum.speed, velocity.speed, self.maximum.speed)
            and _within(self.minimum.turn_rate, velocity.turn_rate, self.maximum.turn_rate)
            and _within(self.minimum.sideways, velocity.sideways, self.maximum.sideways)
        )


def _within(minimum: float, value: float, maximum: float) -> bool:
    return minimum - VELOCITY_TOLERANCE <= value <= maximum + VELOCITY_TOLERANCE


def updated_limits(limits: AccelerationLimits, msg: SetAccelerationLimit, chassis: Chassis) -> AccelerationLimits:
    """The limits after a command, at most those of the chassis; what the command leaves out stays."""
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


def _limit(wanted: float | None, present: float, limit: float) -> float:
    return present if wanted is None else min(limit, max(MIN_ACCELERATION_LIMIT, abs(wanted)))


Command: TypeAlias = SetVelocityCommand | SetVelocityCommandExt

_KINDS: Final = 4
"""Kinds of command; the wide form has each twice, over ground and relative to the medium, which is the same here."""


class CommandKind(IntEnum):
    """Quantities that a velocity command sets."""

    CURRENT = 0
    MAX = 1
    MIN = 2
    DEFAULT = 3


class VelocityStateDriver(Driver, urn="urn:jaus:jss:mobility:VelocityStateDriver"):
    """Speed along x and turn rate about z, within limits that the client may narrow.

    What a current or default command leaves out is zero; a limit that is left out stays. Values for other axes are
    ignored, and not reported, but for y if the platform moves sideways. A curve that is narrower than a chassis that
    steers can drive, also a turn on the spot, is limited, and the report of the command says what is driven.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._range = VelocityRange.of(vehicle.chassis)
        self._limits = vehicle.pilot.limits
        self._default = STANDSTILL
        self._current = STANDSTILL

    # --- predicates

    def is_current_velocity_cmd(self, msg: Command) -> bool:
        """True if the command is to be carried out, not kept as a limit or default."""
        return _kind(msg) is CommandKind.CURRENT

    def is_command_value_valid(self, msg: Command) -> bool:
        """True if the velocities are within the limits; else counted."""
        valid = self._range.contains(self._velocity(msg))
        if not valid:
            self.host.count("velocity_out_of_range", f"{msg}")
        return valid

    # --- actions

    def set_current_velocity_command(self, msg: Command) -> None:
        """Drive at this velocity until the next command."""
        wanted = self._velocity(msg)
        self._current = wanted.feasible(self.vehicle.chassis)
        if self._current.turn_rate != wanted.turn_rate:
            self.host.count("curve_too_narrow", f"{msg}")
        self.vehicle.pilot.follow(self, VelocityCourse(self._current, self._limits))

    def set_current_velocity_command_ext(self, msg: Command) -> None:
        """Same as `set_current_velocity_command`."""
        self.set_current_velocity_command(msg)

    def set_velocity_limit(self, msg: Command) -> None:
        """Keep a limit, at most that of the chassis, or the default."""
        match _kind(msg):
            case CommandKind.MAX:
                self._range = VelocityRange(self._range.minimum, self._limited(msg, self._range.maximum))
            case CommandKind.MIN:
                self._range = VelocityRange(self._limited(msg, self._range.minimum), self._range.maximum)
            case CommandKind.DEFAULT:
                self._default = self._velocity(msg)

    def set_velocity_limit_ext(self, msg: Command) -> None:
        """Same as `set_velocity_limit`."""
        self.set_velocity_limit(msg)

    def set_acceleration_limit(self, msg: SetAccelerationLimit) -> None:
        """Limit the acceleration, also of the present command."""
        self._limits = updated_limits(self._limits, msg, self.vehicle.chassis)
        if self.is_driving:
            self.vehicle.pilot.follow(self, VelocityCourse(self._current, self._limits))

    def reset_cmd_velocity_to_default(self) -> None:
        """Stop when Ready is left. The default is reported then; it does not move the platform."""
        self.vehicle.pilot.stop()
        self._current = self._default

    def control_lost(self) -> None:
        """Restore the limits of the chassis for the next client."""
        super().control_lost()
        self._range, self._limits = VelocityRange.of(self.vehicle.chassis), self.vehicle.pilot.limits
        self._default = self._current = STANDSTILL

    def on_preempted(self) -> None:
        """The reported command becomes the default."""
        self._current = self._default

    def _limited(self, msg: Command, present: PlanarVelocity) -> PlanarVelocity:
        speed = present.speed if msg.velocity_x is None else msg.velocity_x
        turn_rate = present.turn_rate if msg.yaw_rate is None else msg.yaw_rate
        sideways = present.sideways if msg.velocity_y is None else msg.velocity_y
        chassis = self.vehicle.chassis
        limited = PlanarVelocity(speed, turn_rate, sideways).clamped(chassis.max_speed, chassis.max_turn_rate)
        return limited if chassis.moves_sideways else replace(limited, sideways=0.0)

    def _velocity(self, msg: Command) -> PlanarVelocity:
        sideways = (msg.velocity_y or 0.0) if self.vehicle.chassis.moves_sideways else 0.0
        return PlanarVelocity(msg.velocity_x or 0.0, msg.yaw_rate or 0.0, sideways)

    def _sideways(self, velocity: PlanarVelocity) -> float | None:
        return velocity.sideways if self.vehicle.chassis.moves_sideways else None

    # --- reports

    def report_velocity_command(self, query: QueryVelocityCommand) -> ReportVelocityCommand:
        """The command of the queried kind; the current one for an unknown kind."""
        kind, velocity = self._queried(query.command_type)
        return ReportVelocityCommand(
            command_type=kind,
            velocity_x=velocity.speed,
            velocity_y=self._sideways(velocity),
            yaw_rate=velocity.turn_rate,
        )

    def report_velocity_command_ext(self, query: QueryVelocityCommandExt) -> ReportVelocityCommandExt:
        """Same as `report_velocity_command`."""
        _, velocity = self._queried(query.command_type % _KINDS)
        kind = query.command_type if query.command_type < 2 * _KINDS else CommandKind.CURRENT
        return ReportVelocityCommandExt(
            command_type=kind,
            velocity_x=velocity.speed,
            velocity_y=self._sideways(velocity),
            yaw_rate=velocity.turn_rate,
        )

    def _queried(self, kind: int) -> tuple[CommandKind, PlanarVelocity]:
        commands = {
            CommandKind.CURRENT: self._current,
            CommandKind.MAX: self._range.maximum,
            CommandKind.MIN: self._range.minimum,
            CommandKind.DEFAULT: self._default,
        }
        known = CommandKind(kind) if kind in tuple(CommandKind) else CommandKind.CURRENT
        return known, commands[known]

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
