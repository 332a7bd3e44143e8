"""Visual shapes of tracks that move with their belts, in every picture of the robot.

The physics of tracks (`jauspy_sim.physics.tracks`) has no moving treads. It keeps the distance that the belts of each
side have run in `userdata` of the state. A visual shape moves if its element in the URDF has these attributes (other
programs ignore them):

- `belt_way`: "forward" or "backward", in which direction of x it moves when the robot drives forward;
- `belt_radius`, in metres: it turns about y of its origin instead, as the belt does around a wheel;
- `belt_pitch`, in metres from tread to tread: it is moved by less than that, because treads look alike. Without it,
  it turns all the way around.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Element, RobotDescription, numbers, origin, place
from jauspy.platform.description import TrackSetup

SIDES: Final = 2
"""Numbers in `userdata` for each robot: metres that the belts of the left and right side have run, positive forward."""

WAYS: Final = {"forward": 1.0, "backward": -1.0}

Floats = NDArray[np.float64]


def belted_links(description: RobotDescription, tracks: TrackSetup) -> Mapping[str, int]:
    """The links that are belts, and their sides: 0 left, 1 right."""
    return {
        description.joint(name).child: side
        for side, joints in enumerate((tracks.left, tracks.right))
        for name in joints
    }


def mark(geom: mujoco.MjsGeom, visual: Element, side: int) -> None:
    """Mark the shape of a visual element to move with the belts of that side, if it has the attributes.

    Raises `ConfigError` for invalid values.
    """
    way = visual.get("belt_way")
    if way is None:
        return
    if way not in WAYS:
        raise ConfigError(f'{place(visual)}: belt_way="{way}": must be "forward" or "backward"')
    pitch, radius = (max(0.0, numbers(visual, f"belt_{key}", 1, "0")[0]) for key in ("pitch", "radius"))
    if not pitch and not radius:
        raise ConfigError(f"{place(visual)}: belt_way: needs belt_pitch, belt_radius, or both, in metres")
    centre = Transform.from_pose(origin(visual)).position
    geom.userdata = [side + 1.0, WAYS[way], pitch, radius, *centre]


class Treads:
    """The shapes of a model that were marked."""

    def __init__(self, model: mujoco.MjModel) -> None:
        user = model.geom_user
        self._geoms = np.flatnonzero(user[:, 0] > 0.0) if user.shape[1] else np.empty(0, np.int64)
        if not self._geoms.size:
            return
        self._bodies = model.geom_bodyid[self._geoms]
        sides, self._ways, pitch, radius, x, y, z = user[self._geoms, :7].T
        self._sides = sides.astype(np.int64) - 1
        self._repeating = np.flatnonzero(pitch > 0.0)
        self._pitches = pitch[self._repeating]
        self._turns = radius > 0.0
        self._radii = np.where(self._turns, radius, np.inf)
        self._centres = np.stack([x, y, z], axis=1)

    def place(self, data: mujoco.MjData) -> None:
        """Move the shapes that `mj_kinematics` has placed by the distances of the belts in `data.userdata`."""
        if not self._geoms.size:
            return
        run = self._ways * data.userdata[self._sides]
        run[self._repeating] -= self._pitches * np.round(run[self._repeating] / self._pitches)
        frames = data.xmat[self._bodies].reshape(-1, 3, 3)
        centres = data.xpos[self._bodies] + (frames @ self._centres[:, :, None])[:, :, 0]
        turned = frames @ _about_y(run / self._radii) @ frames.transpose(0, 2, 1)
        arms = data.geom_xpos[self._geoms] - centres
        ahead = frames[:, :, 0] * np.where(self._turns, 0.0, run)[:, None]
        data.geom_xpos[self._geoms] = centres + (turned @ arms[:, :, None])[:, :, 0] + ahead
        attitudes = data.geom_xmat[self._geoms].reshape(-1, 3, 3)
        data.geom_xmat[self._geoms] = (turned @ attitudes).reshape(-1, 9)


def _about_y(angles: Floats) -> Floats:
    """Rotations by angles, shape (n, 3, 3)."""
    c, s, zero, one = np.cos(angles), np.sin(angles), np.zeros_like(angles), np.ones_like(angles)
    return np.stack([c, zero, s, zero, one, zero, -s, zero, c], axis=1).reshape(-1, 3, 3)
