"""The backend `sim`: physics by MuJoCo. Importing it does not import MuJoCo."""

from __future__ import annotations

import os
from importlib.util import find_spec

from jauspy.errors import ConfigError
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel
from jauspy_sim.gl_libraries import GL_LIBRARIES, GL_PACKAGES, missing_gl


class MujocoBackend:
    """Any robot in any of the worlds of `jauspy_sim/worlds`."""

    name: str = "sim"

    def open(self, robot: RobotModel, world: str) -> Robot:
        """Open a robot, at rest on the ground at the world's origin.

        Raises `ConfigError` if MuJoCo is missing or cannot be imported: it loads the GL library that MUJOCO_GL names.
        """
        if find_spec("mujoco") is None:
            raise ConfigError("the backend 'sim' needs MuJoCo: pip install 'jauspy[sim]'")
        way = os.environ.get("MUJOCO_GL", "").lower().strip()
        if way in GL_LIBRARIES and (missing := missing_gl(way)):
            raise ConfigError(
                f"MUJOCO_GL={way} needs {missing[0]}, which is not installed: install {GL_PACKAGES[way]}, or "
                "unset MUJOCO_GL, or set it to 'disable' to draw camera pictures without GL"
            )
        try:
            if robot.cell is not None:
                from jauspy_sim.cell.robot import SimulatedCell  # noqa: PLC0415 - only where MuJoCo is installed

                return SimulatedCell.open(robot, world)
            from jauspy_sim.robot import SimulatedRobot  # noqa: PLC0415 - only where MuJoCo is installed
        except (ImportError, AttributeError, RuntimeError) as error:  # no GL library
            setting = f" with MUJOCO_GL={way}" if way else ""
            raise ConfigError(f"the backend 'sim' cannot import MuJoCo{setting}: {error}") from error
        return SimulatedRobot.open(robot, world)
