"""The contract of backends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol, runtime_checkable

from jauspy.geometry.poses import Pose
from jauspy.platform.contract import DisabledRobot, Robot
from jauspy.platform.description import RobotModel


class Backend(Protocol):
    """Opens robots: of a simulator, on a bus, or by arithmetic."""

    @property
    def name(self) -> str:
        """The name it has in configuration files, e.g. `kinematic`."""
        ...

    def open(self, robot: RobotModel, world: str) -> Robot:
        """Open a robot in a world. Raises `ConfigError` with the known worlds for an unknown one."""
        ...


@runtime_checkable
class EnablesLast(Protocol):
    """A backend whose motors stop when the program that commands them is held up, as it may be while it starts."""

    def open_disabled(self, robot: RobotModel, world: str) -> DisabledRobot:
        """Open a robot as `Backend.open` does, without enabling its motors."""
        ...


@dataclass(frozen=True, slots=True)
class PlacedRobot:
    """A robot, and where its base starts in the world: x and y in metres, and the yaw in radians, as in REP-103.

    Names of the descriptions of robots of one world differ.
    """

    robot: RobotModel
    start: Pose = field(default_factory=Pose)


@runtime_checkable
class OpensSeveral(Protocol):
    """A backend that has several robots in one world, where they see and touch each other."""

    def open_several(self, robots: Sequence[PlacedRobot], world: str) -> Sequence[Robot]:
        """Open the robots of one world, each at rest where it starts. Raises `ConfigError` as `Backend.open` does.

        Those that share a state are `SharesWorld`.
        """
        ...
