"""The backend `sim`: physics by MuJoCo. Importing it does not import MuJoCo."""

from __future__ import annotations

import ctypes
import os
from importlib.util import find_spec
from typing import Final

from jauspy.errors import ConfigError
from jauspy.platform.contract import Robot
from jauspy.platform.description import RobotModel

GL_LIBRARIES: Final = {
    "egl": (("libEGL.so.1",), ("libOpenGL.so.0", "libGL.so.1")),
    "osmesa": (("libOSMesa.so.8", "libOSMesa.so.6"),),
}
"""One of each of these groups is needed."""
GL_PACKAGES: Final = {"egl": "libegl1 and libopengl0", "osmesa": "libosmesa6"}
"""The packages of Debian and Ubuntu."""


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
        if way in GL_LIBRARIES and not has_gl(way):
            missing = next(names[0] for names in GL_LIBRARIES[way] if not any(map(_loads, names)))
            raise ConfigError(
                f"MUJOCO_GL={way} needs {missing}, which is not installed: install {GL_PACKAGES[way]}, or "
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


def has_gl(way: str) -> bool:
    """True if the libraries for `egl` or `osmesa` can be loaded."""
    return all(any(map(_loads, names)) for names in GL_LIBRARIES[way])


def choose_gl() -> str | None:
    """`egl`, `osmesa` or None. The environment's MUJOCO_GL counts: with `disable` it is None."""
    wanted = os.environ.get("MUJOCO_GL", "").lower()
    if wanted:
        return wanted if wanted in GL_LIBRARIES else None
    return next((way for way in GL_LIBRARIES if has_gl(way)), None)


def _loads(library: str) -> bool:
    try:
        ctypes.CDLL(library)
    except OSError:
        return False
    return True
