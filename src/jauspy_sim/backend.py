"""The backend `sim`: physics by MuJoCo. Importing it does not import MuJoCo."""

from __future__ import annotations

import os
from collections.abc import Sequence
from importlib.util import find_spec

from jauspy.errors import ConfigError
from jauspy.platform.backend import PlacedRobot
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
        check_libraries()
        try:
            if robot.cell is not None:
                from jauspy_sim.cell.robot import SimulatedCell  # noqa: PLC0415 - only where MuJoCo is installed

                return SimulatedCell.open(robot, world)
            from jauspy_sim.robot import SimulatedRobot  # noqa: PLC0415 - only where MuJoCo is installed
        except (ImportError, AttributeError, RuntimeError) as error:  # no GL library
            raise _import_error(error) from error
        return SimulatedRobot.open(robot, world)

    def open_several(self, robots: Sequence[PlacedRobot], world: str) -> Sequence[Robot]:
        """Open several robots in one world, which see and touch each other. Raises `ConfigError` as `open` does."""
        check_libraries()
        if any(placed.robot.cell is not None for placed in robots):
            raise ConfigError("a robot of a factory cell has its world for itself; start it without others")
        try:
            from jauspy_sim.robot import open_several  # noqa: PLC0415 - only where MuJoCo is installed
        except (ImportError, AttributeError, RuntimeError) as error:  # no GL library
            raise _import_error(error) from error
        return open_several(robots, world)


def check_libraries() -> None:
    """Raise `ConfigError` if MuJoCo is missing, or the GL library that MUJOCO_GL names."""
    if find_spec("mujoco") is None:
        raise ConfigError("the backend 'sim' needs MuJoCo: pip install 'jauspy[sim]'")
    way = _way()
    if way in GL_LIBRARIES and (missing := missing_gl(way)):
        raise ConfigError(
            f"MUJOCO_GL={way} needs {missing[0]}, which is not installed: install {GL_PACKAGES[way]}, or "
            "unset MUJOCO_GL, or set it to 'disable' to draw camera pictures without GL"
        )


def _way() -> str:
    return os.environ.get("MUJOCO_GL", "").lower().strip()


def _import_error(error: Exception) -> ConfigError:
    setting = f" with MUJOCO_GL={_way()}" if _way() else ""
    return ConfigError(f"the backend 'sim' cannot import MuJoCo{setting}: {error}")
