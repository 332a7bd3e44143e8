"""What an arm holds, as MotionPlanner is told and reports it: a box, sphere or cylinder in the frame of the tool."""

from __future__ import annotations

import math
from typing import Final

from jauspy.errors import JausError
from jauspy.geometry.poses import Pose, Transform
from jauspy.messages.planning import ReportHeldObject, SetHeldObject
from jauspy.planning.obstacles import Box, Cylinder, Primitive, Sphere
from jauspy.services.units import sent_text

LARGEST: Final = 10.0
"""Metres of the sides of what an arm holds, and from the tool to its middle, at most."""
HELD: Final = "held object"
"""Name of a thing that was given none."""

_Shape: Final = SetHeldObject.Shape


class WrongObjectError(JausError):
    """A message that describes nothing that can be held; the message says why."""


def read_held(msg: SetHeldObject) -> Primitive | None:
    """The held thing of a message, None for an empty gripper; `WrongObjectError` for numbers that are none."""
    if msg.shape == _Shape.NOTHING:
        return None
    x, y, z = place = msg.x, msg.y, msg.z
    angles = msg.roll, msg.pitch, msg.yaw
    sides: tuple[float, ...]
    if msg.shape == _Shape.BOX:
        sides = (msg.size_x, msg.size_y, msg.size_z)
    elif msg.shape == _Shape.SPHERE:
        sides = (msg.size_x,)
    elif msg.shape == _Shape.CYLINDER:
        sides = (msg.size_x, msg.size_z)
    else:
        raise WrongObjectError(
            f"a held object has shape 0 (nothing), 1 (box), 2 (sphere) or 3 (cylinder), not {msg.shape}"
        )
    if not all(map(math.isfinite, (*place, *angles, *sides))):
        raise WrongObjectError("a held object has a number that is infinite or none")
    if max(map(abs, place)) > LARGEST or not all(0.0 < side <= LARGEST for side in sides):
        raise WrongObjectError(f"a held object is above 0 and at most {LARGEST:g} m large, and as near to the tool")
    if max(map(abs, angles)) > 1e6:
        raise WrongObjectError("the attitude of a held object is in radians, and none of its numbers above a million")
    pose, name = Transform.from_pose(Pose(x, y, z, *angles)), msg.object_name or HELD
    if msg.shape == _Shape.BOX:
        return Box(pose, (msg.size_x, msg.size_y, msg.size_z), name)
    if msg.shape == _Shape.SPHERE:
        return Sphere(pose, msg.size_x / 2.0, name)
    return Cylinder(pose, msg.size_x / 2.0, msg.size_z, name)


def report_of(held: Primitive | None) -> ReportHeldObject:
    """The report of what is held; sizes that a shape does not have are those of the box around it."""
    kind = ReportHeldObject.Shape
    if held is None:
        return ReportHeldObject(kind.NOTHING, "", *(0.0,) * 9)
    shape = kind.BOX if isinstance(held, Box) else kind.SPHERE if isinstance(held, Sphere) else kind.CYLINDER
    pose = held.pose.to_pose()
    place = pose.x, pose.y, pose.z, pose.roll, pose.pitch, pose.yaw
    return ReportHeldObject(shape, sent_text(held.name), *place, *box_around(held).size)


def box_around(held: Primitive, name: str = HELD) -> Box:
    """The box around a thing, with its axes."""
    if isinstance(held, Box):
        return Box(held.pose, held.size, name)
    side = 2.0 * held.radius
    return Box(held.pose, (side, side, held.length if isinstance(held, Cylinder) else side), name)
