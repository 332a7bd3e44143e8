"""The backend `can`. Importing it does not import python-can and canopen."""

from __future__ import annotations

from importlib.util import find_spec

from jauspy.backends.can.faults import DriveFault
from jauspy.errors import ConfigError
from jauspy.platform.contract import DisabledRobot, Robot
from jauspy.platform.description import RobotModel


class CanBackend:
    """Robots whose joints and tracks are servo drives with CiA 402 on a CAN bus."""

    name: str = "can"

    def open(self, robot: RobotModel, world: str) -> Robot:
        """Open the bus, configure the drives, and enable them when all agree.

        Raises `ConfigError` if the robot's file has no `[can]`, if a package is missing, or if a drive lacks a required
        object.
        """
        return self._open(robot, world, enabled=True)

    def open_disabled(self, robot: RobotModel, world: str) -> DisabledRobot:
        """Open the bus and configure the drives, without power; raises `ConfigError` as `open`."""
        return self._open(robot, world, enabled=False)

    @staticmethod
    def _open(robot: RobotModel, world: str, *, enabled: bool) -> DisabledRobot:
        if robot.wheels is not None:
            raise ConfigError(f"{robot.description.name} has wheels, and the backend can drives tracks only")
        setup = robot.can
        if setup is None:
            raise ConfigError(
                f"{robot.description.name} has no table [can] in its file; the backend can needs it, and a table "
                "[can.drives.NAME] for each drive (docs/hardware.md)"
            )
        if isinstance(setup, str):
            raise ConfigError(setup)
        missing = [package for module, package in PACKAGES.items() if find_spec(module) is None]
        if missing:
            raise ConfigError(f"the backend 'can' needs {' and '.join(missing)}: pip install 'jauspy[can]'")
        from jauspy.backends.can.master import Master  # noqa: PLC0415 - only where the extra is installed
        from jauspy.backends.can.robot import CanRobot  # noqa: PLC0415

        try:
            return CanRobot(robot, setup, setup.bus, world, Master.start if enabled else Master.configure)
        except DriveFault as error:
            raise ConfigError(f"can: {error}") from error


PACKAGES = {"can": "python-can", "canopen": "canopen"}
"""The packages of the extra, by the module that is imported."""
