"""The contract of backends."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

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
