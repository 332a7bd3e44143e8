"""The contract of backends."""

from __future__ import annotations

from typing import Protocol

from jauspy.platform.contract import Robot
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
