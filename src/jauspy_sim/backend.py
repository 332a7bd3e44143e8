"""The backend `sim`: physics by MuJoCo. Importing it does not import MuJoCo."""

from __future__ import annotations

from importlib.util import find_spec

from jauspy.errors import ConfigError
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel


class MujocoBackend:
    """Any robot in any of the worlds of `jauspy_sim/worlds`."""

    name: str = "sim"

    def open(self, robot: RobotModel, world: str) -> Robot:
        """That robot, settled on the ground at the world's origin."""
        if find_spec("mujoco") is None:
            raise ConfigError("the backend 'sim' needs MuJoCo: pip install 'jauspy[sim]'")
        from jauspy_sim.robot import SimulatedRobot  # noqa: PLC0415 - only where MuJoCo is installed

        return SimulatedRobot.open(robot, world)
