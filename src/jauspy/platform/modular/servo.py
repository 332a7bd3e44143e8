"""Servo modules: their contract with modules and with the controller of a modular arm, states and commands."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import NamedTuple, Protocol

from jauspy.geometry.vectors import Vector
from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink, RobotParts
from jauspy.platform.joints import Gains, Target


@dataclass(frozen=True, slots=True)
class ServoState:
    """A servo module at one moment."""

    powered: bool = False
    """False while it has no power or is switched off; the other fields are then those of its last report."""
    position: float = 0.0
    """Radians at the output, any number of turns."""
    velocity: float = 0.0
    """rad/s."""
    torque: float = 0.0
    """Newton metres, measured by the spring."""
    current: float = 0.0
    """Current of the motor, in amperes."""
    temperature: float = 25.0
    """Temperature of the windings, in degrees Celsius."""
    voltage: float = 0.0
    """Voltage of its supply, in volts."""
    orientation: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)
    """Orientation of the housing in the world, as a unit quaternion w, x, y, z, by its IMU."""
    angular_velocity: Vector = (0.0, 0.0, 0.0)
    """Angular velocity of the housing in its own frame, rad/s, by its IMU."""
    acceleration: Vector = (0.0, 0.0, 0.0)
    """Specific force in the housing's frame, m/s^2, by its IMU: at rest 9.81 upward."""
    claimed_by: str = ""
    """Name of the modular arm or car that commands it; commands of others are then ignored."""


class ServoModule(OptionalPart):
    """A joint with motor, gear, spring, encoder and IMU in one housing; it holds its position when it is at rest."""

    name: str
    """Name of the module, as in `servo_1`."""

    @property
    def id(self) -> PartId:
        """Kind and name."""
        return PartId(ServoModule, self.name)

    @abstractmethod
    def state(self) -> ServoState:
        """Position, velocity, torque, supply and orientation, as the module measures them."""

    @abstractmethod
    def command(self, target: Target, feed_forward: float = 0.0) -> None:
        """Follow a target; `feed_forward` is added to the torque of its controller, in newton metres."""

    @abstractmethod
    def hold(self) -> None:
        """Brake, and hold the position where it comes to rest."""

    @abstractmethod
    def set_gains(self, position: Gains, velocity: Gains) -> None:
        """Set the gains of its controllers."""

    @abstractmethod
    def gains(self) -> tuple[Gains, Gains]:
        """The gains of its controllers: of position and of velocity."""

    def stop(self) -> None:
        """Hold, unless a modular arm commands it, which then stops it."""
        if not self.state().claimed_by:
            self.hold()

    def proxy(self, link: RobotLink) -> ServoModule:
        """The module for other threads."""
        return _ServoProxy(self.name, self.gains(), link)


@dataclass(frozen=True, slots=True)
class ServoCommand(Command):
    """Have a servo module follow a target; None has it hold its position."""

    name: str
    target: Target | None
    feed_forward: float = 0.0

    @property
    def part(self) -> PartId:
        """The module."""
        return PartId(ServoModule, self.name)

    def apply(self, robot: Robot) -> None:
        """Command it, unless a modular arm does."""
        servo = find(robot, self.name)
        if servo is None or servo.state().claimed_by:
            return
        if self.target is None:
            servo.hold()
        else:
            servo.command(self.target, self.feed_forward)


@dataclass(frozen=True, slots=True)
class ServoGains(Command):
    """Set the gains of a servo module."""

    name: str
    position: Gains
    velocity: Gains

    @property
    def part(self) -> PartId:
        """The gains of the module: a pending target is not replaced."""
        return PartId(ServoGains, self.name)

    def apply(self, robot: Robot) -> None:
        """Set them."""
        if (servo := find(robot, self.name)) is not None:
            servo.set_gains(self.position, self.velocity)


def find(robot: RobotParts, name: str) -> ServoModule | None:
    """The servo module of that name."""
    parts = (part for part in robot.optional_parts if isinstance(part, ServoModule))
    return next((part for part in parts if part.name == name), None)


class _ServoProxy(ServoModule):
    def __init__(self, name: str, gains: tuple[Gains, Gains], link: RobotLink) -> None:
        self.name = name
        self._gains = gains
        self._link = link

    def state(self) -> ServoState:
        state = self._link.snapshot.parts[self.id]
        assert isinstance(state, ServoState)
        return state

    def command(self, target: Target, feed_forward: float = 0.0) -> None:
        self._link.submit(ServoCommand(self.name, target, feed_forward))

    def hold(self) -> None:
        self._link.submit(ServoCommand(self.name, None))

    def set_gains(self, position: Gains, velocity: Gains) -> None:
        self._gains = position, velocity
        self._link.submit(ServoGains(self.name, position, velocity))

    def gains(self) -> tuple[Gains, Gains]:
        return self._gains


class ServoReading(NamedTuple):
    """Position, velocity and torque of a servo module at one moment; if `powered` is False, its last report."""

    powered: bool
    position: float
    """Radians at the output, any number of turns."""
    velocity: float
    """rad/s at the output."""
    torque: float
    """Newton metres through the spring, positive if it accelerates the output."""


class ServoDrive(Protocol):
    """A servo module as a modular arm commands it; the backend's `ServoModule` may be one itself."""

    @property
    def name(self) -> str:
        """Name of the module, as in `servo_1`."""
        ...

    def read(self) -> ServoReading:
        """Read position, velocity and torque now; cheap, because it is called in each control cycle."""
        ...

    def set_torque(self, torque: float) -> None:
        """Have the motor apply a torque (N m at the output), clamped to its limit, until the next command."""
        ...

    def hold(self) -> None:
        """Brake, and hold the position where it comes to rest, by its own controller."""
        ...

    def claim(self, arm: str) -> None:
        """Obey only the modular arm of this name from now on; empty ends the claim. `ServoState` reports it."""
        ...

    def gains(self) -> tuple[Gains, Gains]:
        """The gains of its own controllers: of position and of velocity."""
        ...
