"""What the simulation knows of a robot that drives in it, for measurements; no client of the robot uses it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

import mujoco

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy_sim.driving.contact_watch import ContactWatch
from jauspy_sim.driving.depth_rays import DepthRays
from jauspy_sim.driving.true_heights import TrueHeights, true_heights

MOVABLE: Final = ("crate", "bin", "sofa", "waste_bin", "carton_1")
"""Things that are put into the way of a robot; the first that the world has."""


class DrivingTruth:
    """The truth about one robot; `step` metres is the highest step that it climbs.

    `watch` has its `step` called after steps of the physics.
    """

    def __init__(
        self, model: mujoco.MjModel, data: mujoco.MjData, name_prefix: str, pose: Callable[[], Pose], step: float
    ) -> None:
        self._model, self._data, self._prefix = model, data, name_prefix
        self._pose, self._step = pose, step
        self.heights: TrueHeights = true_heights(model, data, name_prefix, step)
        """The heights of the world without the robot."""
        self.watch = ContactWatch(model, data, name_prefix, pose, ground=self.heights, step=step)
        """Measures contacts and way."""

    def measure_heights(self) -> None:
        """Measure the heights again, after things were moved."""
        self.heights = self.watch.ground = true_heights(self._model, self._data, self._prefix, self._step)

    def pose(self) -> Pose:
        """Pose of the base in the world."""
        return self._pose()

    def begin(self) -> None:
        """Count contacts, and measure the way, from now on."""
        self.watch.begin()

    @property
    def way(self) -> float:
        """Metres driven since `begin`."""
        return self.watch.way

    @property
    def contacts(self) -> Mapping[str, int]:
        """Samples of the physics since `begin` with a contact that is not with the ground, by body of the world."""
        return dict(self.watch.contacts)

    def depth_camera(self, link: str, seed: int) -> DepthRays:
        """A depth camera at a link of the robot."""
        return DepthRays(self._model, self._data, self._prefix, link, seed)

    def put_thing(self, x: float, y: float) -> str:
        """Put a movable thing of the world to a place, at rest; returns its name. Raises `ConfigError` without any."""
        model, data = self._model, self._data
        for name in MOVABLE:
            if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, name) >= 0:
                joint = model.body(name).jntadr[0]
                break
        else:
            raise ConfigError(f"the world has nothing that could be put into the way: {', '.join(MOVABLE)}")
        place, speed = model.jnt_qposadr[joint], model.jnt_dofadr[joint]
        data.qpos[place : place + 2] = x, y
        data.qvel[speed : speed + 6] = 0.0
        mujoco.mj_forward(model, data)
        return name
