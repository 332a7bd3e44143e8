"""Obstacles around a thing that is grasped: what is seen, and the thing and its surface as they were measured."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

import numpy as np

from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.vectors import Vector
from jauspy.planning.grasp_candidates import Candidate
from jauspy.planning.looking import Eyes
from jauspy.planning.objects import SeenObject
from jauspy.planning.obstacles import Box, Cylinder, Obstacles

VOXEL: Final = 0.03
"""Edge of the voxels of the scene, metres."""
AROUND: Final = 0.06
"""Metres around the thing in which its voxels, and those of the surface, count as what was measured exactly."""
SUPPORT_SIDE: Final = 0.4
"""Metres; side of the piece of the surface that is known exactly."""
HELD: Final = "held"
"""Name of the thing among what belongs to the robot's body."""


class AroundThing:
    """Obstacles for motions near a thing; `tip` is the link that holds it."""

    def __init__(self, eyes: Eyes, tip: str) -> None:
        self._eyes, self._tip = eyes, tip
        self._thing: SeenObject | None = None
        self._is_solid = True

    def set(self, thing: SeenObject | None, *, is_solid: bool = False) -> None:
        """The thing whose surroundings are known exactly, and whether it is an obstacle."""
        self._thing, self._is_solid = thing, is_solid

    def obstacles(self) -> Obstacles:
        """What is seen, and near the thing what was measured of it."""
        thing = self._thing
        if thing is None:
            return self._eyes.obstacles()
        found = self.without(thing)
        if not self._is_solid:
            return found
        solid = Box(Transform.from_pose(Pose(*thing.centre, yaw=thing.yaw)), thing.size, "the thing")
        return replace(found, primitives=(*found.primitives, solid))

    def without(self, thing: SeenObject) -> Obstacles:
        """What is seen but for the thing; its surface as a box."""
        seen = self._eyes.obstacles()
        x, y, _ = thing.centre
        long, short, height = thing.size
        radius = math.hypot(long, short) / 2.0 + AROUND
        above = thing.support.heights(seen.voxels)
        off = seen.voxels[:, :2] - (x, y)
        near = (np.hypot(*off.T) <= radius) & (above <= height + AROUND) & (above >= -2.0 * VOXEL)
        surface = (np.abs(off) <= SUPPORT_SIDE / 2.0).all(axis=1) & (np.abs(above) <= VOXEL)
        top = thing.support.at(x, y)
        table = Box(Transform(position=(x, y, top - 0.02)), (SUPPORT_SIDE, SUPPORT_SIDE, 0.04), "the surface")
        return replace(seen, voxels=seen.voxels[~(near | surface)], primitives=(*seen.primitives, table))

    def hold(self, thing: SeenObject, candidate: Candidate) -> None:
        """Count the thing as part of the robot's body, so that the scene does not have it."""
        assert self._eyes.scene.body is not None
        held = payload(thing, candidate)
        side = 2.0 * held.radius + AROUND
        self._eyes.scene.body.attach(self._tip, Box(held.pose, (side, side, held.length + AROUND), HELD))

    def let_go(self) -> None:
        """Nothing is held any more."""
        assert self._eyes.scene.body is not None
        self._eyes.scene.body.detach(HELD)
        self._thing = None


def payload(thing: SeenObject, candidate: Candidate) -> Cylinder:
    """The thing in the frame of the tool, as an upright cylinder."""
    long, short, height = thing.size
    pose = candidate.pose.inverse() @ Transform(position=thing.centre)
    return Cylinder(pose, math.hypot(long, short) / 2.0, height, "the thing")


def moved_thing(thing: SeenObject, point: Vector) -> SeenObject:
    """The thing where it was placed."""
    x, y, z = point
    plane = replace(thing.support, slope=(0.0, 0.0), height=z)
    return replace(thing, centre=(x, y, z + thing.size[2] / 2.0), support=plane)
