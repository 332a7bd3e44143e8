"""One world of a backend for several robots, each of which has a runner of its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

from jauspy.errors import ConfigError
from jauspy.platform.backend import Backend, OpensSeveral, PlacedRobot
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel


class SharedWorld:
    """Opens all robots when the first one is opened; `backends` are those of each robot, in the same order.

    A second robot of one description gets another name in the world, as in `inc1_2`.
    """

    def __init__(self, backend: Backend, robots: Sequence[PlacedRobot]) -> None:
        """Raises `ConfigError` for a backend whose robots have no common world."""
        if not isinstance(backend, OpensSeveral):
            raise ConfigError(
                f"the backend {backend.name!r} has one robot in a world: start the others with `jauspy up` of their own"
            )
        self._backend: OpensSeveral = backend
        self._robots = _named(robots)
        self._opened: Sequence[Robot] | None = None
        self.backends = tuple(_RobotOfWorld(self, backend.name, number) for number in range(len(robots)))

    def open(self, number: int, world: str) -> Robot:
        """The robot of that number, at rest where it starts; `world` is that of the robot that is opened first."""
        if self._opened is None:
            self._opened = self._backend.open_several(self._robots, world)
        return self._opened[number]


class _RobotOfWorld:
    """A `Backend` with one robot, which was described when its world was made."""

    def __init__(self, world: SharedWorld, name: str, number: int) -> None:
        self.name = name
        self._world = world
        self._number = number

    def open(self, robot: RobotModel, world: str) -> Robot:  # noqa: ARG002 - described when its world was made
        """Open the robot."""
        return self._world.open(self._number, world)


def _named(robots: Sequence[PlacedRobot]) -> list[PlacedRobot]:
    """The robots, with names that differ."""
    counts: Counter[str] = Counter()
    found = []
    for placed in robots:
        description = placed.robot.description
        counts[description.name] += 1
        count = counts[description.name]
        named = description if count == 1 else replace(description, name=f"{description.name}_{count}")
        found.append(replace(placed, robot=replace(placed.robot, description=named)))
    return found
