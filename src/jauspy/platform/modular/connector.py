"""Vacuum connectors, and the gripper, which is one: the contract, their states and commands."""

from __future__ import annotations

import math
from abc import abstractmethod
from dataclasses import dataclass
from enum import Enum

from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink


class ConnectorError(Enum):
    """Reasons why the last attachment of a connector ended or failed."""

    NONE = "none"
    NO_CONTACT = "no contact"
    """Nothing to attach touches the plate."""
    TOO_FAR = "too far"
    """The middles of the plates are too far apart."""
    NOT_ALIGNED = "not aligned"
    """The angle between the plates is too large."""
    FAILED = "failed"
    """The attempt failed at random (simulated)."""
    OVERLOADED = "overloaded"
    """The connector has broken off."""
    NO_POWER = "no power"
    OTHER = "other"


@dataclass(frozen=True, slots=True)
class ConnectorState:
    """A vacuum connector at one moment."""

    powered: bool = False
    enabled: bool = False
    """The pump runs. An attached part stays attached without power; only disabling or an overload releases it."""
    attached_to: str = ""
    """Name of the part; empty when nothing is attached."""
    offset: Transform = IDENTITY
    """Frame of the attached part in the frame of the connector, from contact on; the identity without error."""
    force: float = 0.0
    """Magnitude of what it holds, in newtons."""
    moment: float = 0.0
    """Magnitude about the middle of the plate, in newton metres."""
    mass: float = 0.0
    """Kilograms of all that hangs on it, of the gripper: by the efforts of the robot's motors while it moves."""
    mass_deviation: float = math.inf
    """Standard deviation of that mass, kilograms; infinite while it is not known."""
    utilisation: float = 0.0
    """Fraction of the connection's strength that the load uses; above 1 it breaks off."""
    vacuum: float = 0.0
    """Pascals below the ambient pressure."""
    latched: bool = False
    """True when the attached part is locked mechanically."""
    broken_off: int = 0
    """Number of parts that an overload has released."""
    error: ConnectorError = ConnectorError.NONE
    """Reason why the last attachment ended or failed."""
    last_error: str = ""
    """The same as text; empty after a success."""


class VacuumConnector(OptionalPart):
    """Attaches a part that it touches, if it is aligned, and holds it until it is disabled or overloaded."""

    name: str
    """The part that has it and the connector's own name, as in `servo_1/output`; `gripper` is that of the arm."""
    attached_with: int | None = None
    """The authority of the client that attached the load, for its service; which ends with the power of the part."""

    @property
    def id(self) -> PartId:
        """Kind and name."""
        return PartId(VacuumConnector, self.name)

    @abstractmethod
    def state(self) -> ConnectorState:
        """State of the connector, as it measures it: vacuum, attached part, force and moment."""

    @abstractmethod
    def set(self, enabled: bool) -> None:
        """Start the pump, or vent, and cancel what is scheduled.

        Enabled, it attaches as soon as a part is in contact and aligned.
        """

    @abstractmethod
    def schedule(self, enabled: bool, delay: float) -> None:
        """Call `set` after `delay` seconds of the robot's time, in place of what is scheduled."""

    @abstractmethod
    def cancel(self) -> None:
        """Cancel what is scheduled."""

    def proxy(self, link: RobotLink) -> VacuumConnector:
        """The connector for other threads."""
        return _ConnectorProxy(self.name, link)


@dataclass(frozen=True, slots=True)
class ConnectorCommand(Command):
    """Enable or disable a vacuum connector."""

    name: str
    enabled: bool

    @property
    def part(self) -> PartId:
        """The connector."""
        return PartId(VacuumConnector, self.name)

    def apply(self, robot: Robot) -> None:
        """Set it."""
        if (connector := _find(robot, self.name)) is not None:
            connector.set(self.enabled)


@dataclass(frozen=True, slots=True)
class ConnectorSchedule(Command):
    """Schedule a command for a vacuum connector; None as `enabled` cancels what is scheduled."""

    name: str
    enabled: bool | None
    delay: float = 0.0

    @property
    def part(self) -> PartId:
        """The schedule of the connector: a pending command is not replaced."""
        return PartId(ConnectorSchedule, self.name)

    def apply(self, robot: Robot) -> None:
        """Schedule or cancel it."""
        if (connector := _find(robot, self.name)) is None:
            return
        if self.enabled is None:
            connector.cancel()
        else:
            connector.schedule(self.enabled, self.delay)


def _find(robot: Robot, name: str) -> VacuumConnector | None:
    parts = (part for part in robot.optional_parts if isinstance(part, VacuumConnector))
    return next((part for part in parts if part.name == name), None)


class _ConnectorProxy(VacuumConnector):
    def __init__(self, name: str, link: RobotLink) -> None:
        self.name = name
        self._link = link

    def state(self) -> ConnectorState:
        state = self._link.snapshot.parts[self.id]
        assert isinstance(state, ConnectorState)
        return state

    def set(self, enabled: bool) -> None:
        self._link.submit(ConnectorCommand(self.name, enabled))

    def schedule(self, enabled: bool, delay: float) -> None:
        self._link.submit(ConnectorSchedule(self.name, enabled, delay))

    def cancel(self) -> None:
        self._link.submit(ConnectorSchedule(self.name, None))
