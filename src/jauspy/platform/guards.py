"""The contract of guards: they slow down commands that would end in a contact, and stop before it.

See docs/adr/0185-guards-against-collisions.md. A guard only slows down: it moves nothing by itself, and a command to
stop passes at once.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from typing import ClassVar, cast

from jauspy.platform.contract import Command, OptionalPart, PartId, Robot, RobotLink, RobotParts


@dataclass(frozen=True, slots=True)
class GuardState:
    """The state of a guard at one moment."""

    enabled: bool
    active: bool = False
    """True while it slows a command down, or has stopped it."""
    distance: float = math.inf
    """Metres to the nearest thing that it watches, as far as it looks; infinite without any."""
    problem: str = ""
    """Why it stopped the robot, as a sentence, until a command moves that part again."""


class Guard(OptionalPart):
    """A guard of one kind, which is a subclass."""

    label: ClassVar[str]
    """Kind of contact that it prevents, in texts."""

    @property
    def id(self) -> PartId:
        """A robot has at most one of each kind."""
        return PartId(_kind(type(self)))

    @abstractmethod
    def state(self) -> GuardState:
        """The present state."""

    @abstractmethod
    def enable(self, enabled: bool) -> None:
        """Switch it on or off."""


@cache
def _kind(found: type[Guard]) -> type[Guard]:
    """The contract that a class implements: `SelfCollisionGuard` or `ObstacleGuard`."""
    return next(kind for kind in found.__mro__ if "label" in vars(kind))


class SelfCollisionGuard(Guard):
    """Keeps arms, flippers, grippers and cameras from touching each other and the body."""

    label = "self collision"

    def proxy(self, link: RobotLink) -> SelfCollisionGuard:
        """The guard for other threads."""
        return _SelfCollisionProxy(link)


class ObstacleGuard(Guard):
    """Keeps the chassis from driving into what lidars and depth cameras see."""

    label = "obstacle"

    @abstractmethod
    def see(self, camera: str, frame: str, points: bytes, age: float) -> None:
        """Take points that a depth camera saw `age` seconds ago: float32 rows of x, y and z in the frame of a link."""

    def proxy(self, link: RobotLink) -> ObstacleGuard:
        """The guard for other threads."""
        return _ObstacleProxy(link)


@dataclass(frozen=True, slots=True)
class Sighting(Command):
    """Points that a depth camera saw, as in `ObstacleGuard.see`."""

    camera: str
    frame: str
    points: bytes
    age: float

    @property
    def part(self) -> PartId:
        """The camera of the guard."""
        return PartId(ObstacleGuard, self.camera)

    def apply(self, robot: Robot) -> None:
        """Pass them to the guard."""
        if (guard := next((part for part in guards_of(robot) if isinstance(part, ObstacleGuard)), None)) is not None:
            guard.see(self.camera, self.frame, self.points, self.age)


@dataclass(frozen=True, slots=True)
class GuardSwitch(Command):
    """Switch a guard on or off."""

    guard: PartId
    enabled: bool

    @property
    def part(self) -> PartId:
        """The guard."""
        return self.guard

    def apply(self, robot: Robot) -> None:
        """Switch it."""
        for guard in guards_of(robot):
            if guard.id == self.guard:
                guard.enable(self.enabled)


class _SelfCollisionProxy(SelfCollisionGuard):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def state(self) -> GuardState:
        return cast("GuardState", self._link.snapshot.parts[self.id])

    def enable(self, enabled: bool) -> None:
        self._link.submit(GuardSwitch(self.id, enabled))


class _ObstacleProxy(ObstacleGuard):
    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def see(self, camera: str, frame: str, points: bytes, age: float) -> None:
        self._link.submit(Sighting(camera, frame, points, age))

    def state(self) -> GuardState:
        return cast("GuardState", self._link.snapshot.parts[self.id])

    def enable(self, enabled: bool) -> None:
        self._link.submit(GuardSwitch(self.id, enabled))


def guards_of(robot: RobotParts) -> Iterator[Guard]:
    """The guards that a robot has."""
    return (part for part in robot.optional_parts if isinstance(part, Guard))
