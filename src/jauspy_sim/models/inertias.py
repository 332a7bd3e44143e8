"""Tensors of inertia from files, of which some are physically impossible."""

from __future__ import annotations

import logging
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform

_LOG = logging.getLogger("jauspy_sim.inertia")

KEYS: Final = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")

MIN_INERTIA: Final = 1e-6
"""kg m^2; the least moment of inertia."""

MOMENT_TOLERANCE: Final = 1e-9
"""kg m^2; a moment that is negative by less than this is a rounding error, and becomes zero."""

BALL: Final = 0.02
"""Metres: radius of the ball whose inertia a body gets that has a mass and no inertia."""


def set_inertia(body: mujoco.MjsBody, mass: float, frame: Transform, tensor: NDArray[np.float64]) -> None:
    """Give a body a mass, kg, and an inertia in a frame at its centre of mass."""
    turn = np.array(frame.rotation)
    inertia = turn @ tensor @ turn.T
    body.mass, body.explicitinertial, body.ipos = mass, True, frame.position
    body.fullinertia = (*np.diag(inertia), inertia[0, 1], inertia[0, 2], inertia[1, 2])


def checked_inertia(moments: tuple[float, ...], mass: float, where: str) -> NDArray[np.float64]:
    """The tensor of Ixx, iyy, izz, ixy, ixz, iyz; an impossible one is replaced, and this is logged.

    Raises `ConfigError`, which begins with `where`, for a negative moment.
    """
    for key, value in zip(KEYS[:3], moments[:3], strict=True):
        if value < -MOMENT_TOLERANCE:
            raise ConfigError(f'{where}: <inertia {key}="{value:g}">: is negative')
    xx, yy, zz, xy, xz, yz = moments
    tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    least, middle, most = np.linalg.eigvalsh(tensor)
    if not tensor.any():
        return np.eye(3) * max(MIN_INERTIA, 0.4 * mass * BALL**2)
    if least <= 0.0:
        _LOG.warning("%s: no body has this inertia: a principal moment is %.3g; mended", where, least)
        mended: NDArray[np.float64] = np.diag(np.maximum(np.diag(tensor), max(1e-9, 0.01 * most)))
        least, middle, most = np.linalg.eigvalsh(mended)
        return mended if least + middle >= most else np.eye(3) * (least + middle + most) / 3.0
    if least + middle < most * (1.0 - 1e-6):
        _LOG.warning(
            "%s: no body has this inertia: %.3g + %.3g is less than %.3g; balanced", where, least, middle, most
        )
        balanced: NDArray[np.float64] = np.eye(3) * (least + middle + most) / 3.0
        return balanced
    return tensor
