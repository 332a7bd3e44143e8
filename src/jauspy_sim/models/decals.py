"""Shapes on the ground below a robot that are only seen: its contact shadow, and the marks of its tracks.

They are in the model that cameras draw, not in that for physics; `jauspy_sim.rendering.decals` moves them. MuJoCo has
no transparent textures, so a soft edge is a stack of thin sheets, each slightly smaller than the one below it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Final, NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import CollisionBox, collision_boxes
from jauspy.platform.description import RobotModel
from jauspy_sim.models.groups import VISUAL

SHADOW: Final = "contact shadow"
MARK: Final = "track mark"
MARKS: Final = 26
"""Marks of each end of a track, after which the oldest ones are used again; each takes 15 us of a picture."""
MARK_LENGTH: Final = 0.13
"""Metres."""
BARS: Final = 4
"""Grousers of a track in one mark."""

SHEET: Final = 0.1
"""Opacity of one sheet of the shadow: with twelve of them, 28 % of the ground's light is left."""
SHEET_GAP: Final = 0.0003
"""Metres between sheets; a pixel's depth differs by a tenth of that at 3 m."""
FOOT_SHEETS: Final = (-0.006, 0.003, 0.012, 0.022, 0.034)
"""Metres by which each sheet below a track or wheel reaches beyond it."""
BODY_SHEETS: Final = (-0.12, -0.07, -0.02, 0.015, 0.045, 0.07, 0.095)
"""As `FOOT_SHEETS`, below the whole robot."""
CORNER: Final = 4
"""Points of a quarter of a circle."""

Floats = NDArray[np.float64]


class Rectangle(NamedTuple):
    """A rectangle on the ground, in the frame of the robot's base: from and to x, from and to y, in metres."""

    back: float
    front: float
    right: float
    left: float


class Footprint(NamedTuple):
    """What of a robot is above the ground, and what stands on it."""

    body: Rectangle
    feet: tuple[Rectangle, ...]
    """The ground below each track, or below each wheel."""


def footprint(robot: RobotModel) -> Footprint | None:
    """The footprint of a robot on tracks or wheels; None for others."""
    boxes = list(collision_boxes(robot.description.urdf))
    frames = FrameTree(robot.description).poses({})
    if robot.tracks is not None:
        sides = [robot.description.joint(side[0]).child for side in (robot.tracks.left, robot.tracks.right)]
        belts = [[box for box in boxes if box.link == link] for link in sides]
        if not all(belts):
            return None
        around = [_around(frames, belt) for belt in belts]
        # its ends are round
        radii = [max(box.size[2] for box in belt) / 2 for belt in belts]
        feet = [
            whole._replace(back=whole.back + radius, front=whole.front - radius)
            for whole, radius in zip(around, radii, strict=True)
        ]
    elif robot.wheels is not None:
        around = feet = [
            Rectangle(wheel.x - wheel.radius / 2, wheel.x + wheel.radius / 2, wheel.y - half, wheel.y + half)
            for wheel in robot.wheels.wheels
            if (half := wheel.radius / 4)
        ]
    else:
        return None
    hull = [box for box in boxes if box.link == robot.description.root()]
    backs, fronts, rights, lefts = zip(*around, *([_around(frames, hull)] if hull else []), strict=True)
    return Footprint(Rectangle(min(backs), max(fronts), min(rights), max(lefts)), tuple(feet))


def _around(frames: Mapping[str, Transform], boxes: Sequence[CollisionBox]) -> Rectangle:
    """The rectangle below boxes."""
    corners = [
        (frames[box.link] @ Transform.from_pose(box.origin)).apply((sx * x / 2, sy * y / 2, sz * z / 2))
        for box in boxes
        for x, y, z in (box.size,)
        for sx in (-1, 1)
        for sy in (-1, 1)
        for sz in (-1, 1)
    ]
    x, y, _ = zip(*corners, strict=True)
    return Rectangle(min(x), max(x), min(y), max(y))


def add_decals(spec: mujoco.MjSpec, robot: RobotModel) -> None:
    """Add the shadow, and for a robot on tracks their marks. They are invisible until they are placed."""
    found = footprint(robot)
    if found is None:
        return
    sheets = [(found.body, reach) for reach in reversed(BODY_SHEETS)]
    sheets += [(foot, reach) for reach in reversed(FOOT_SHEETS) for foot in found.feet]
    _add(spec, SHADOW, _stacked(sheets), 1)
    if robot.tracks is not None:
        width = found.feet[0].left - found.feet[0].right
        bar = MARK_LENGTH / BARS
        whole = Rectangle(-0.5 * MARK_LENGTH, 0.5 * MARK_LENGTH, -0.5 * width, 0.5 * width)
        bars = [
            Rectangle(start + 0.2 * bar, start + 0.75 * bar, -0.5 * width, 0.5 * width)
            for start in np.arange(BARS) * bar - 0.5 * MARK_LENGTH
        ]
        _add(spec, MARK, [(_corners(whole), 0.0), *((_corners(each), SHEET_GAP) for each in bars)], 4 * MARKS)


def _stacked(sheets: Sequence[tuple[Rectangle, float]]) -> Iterator[tuple[Floats, float]]:
    """Outlines and heights of sheets, from the lowest one up."""
    level, last = -1, None
    for rectangle, reach in sheets:
        level += reach != last
        last = reach
        yield _rounded(rectangle, reach), level * SHEET_GAP


def _rounded(rectangle: Rectangle, reach: float) -> Floats:
    """The outline of a rectangle that is larger on all sides, with rounded corners."""
    back, front, right, left = rectangle
    shrunk = min(reach, 0.0)
    half = (front - back) / 2 + shrunk, (left - right) / 2 + shrunk
    middle = (front + back) / 2, (left + right) / 2
    radius = max(reach, 0.25 * min(half))
    inner = [max(side + max(reach, 0.0) - radius, 0.0) for side in half]
    turns = (np.arange(4)[:, None] + np.linspace(0.0, 1.0, CORNER)) * np.pi / 2
    x = np.array([1, -1, -1, 1])[:, None] * inner[0] + radius * np.cos(turns)
    y = np.array([1, 1, -1, -1])[:, None] * inner[1] + radius * np.sin(turns)
    return np.stack([middle[0] + x.ravel(), middle[1] + y.ravel()], axis=1)


def _corners(rectangle: Rectangle) -> Floats:
    back, front, right, left = rectangle
    return np.array([(front, left), (back, left), (back, right), (front, right)])


def _add(spec: mujoco.MjSpec, name: str, sheets: Iterable[tuple[Floats, float]], count: int) -> None:
    """Add a mesh of convex sheets, seen from above, and shapes that show it."""
    points: list[Floats] = []
    faces: list[tuple[int, int, int]] = []
    for outline, height in sheets:
        first = sum(len(each) for each in points)
        points.append(np.column_stack([outline, np.full(len(outline), height)]))
        faces += [(first, first + corner, first + corner + 1) for corner in range(1, len(outline) - 1)]
    mesh = spec.add_mesh(name=name, inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL)
    mesh.uservert = np.concatenate(points).ravel()
    mesh.userface = np.array(faces).ravel()
    material = spec.add_material(name=name, specular=0.0, shininess=0.0)
    for number in range(count):
        spec.worldbody.add_geom(
            name=f"{name} {number}",
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=name,
            material=material.name,
            rgba=(0.0, 0.0, 0.0, 0.0),
            contype=0,
            conaffinity=0,
            mass=0.0,
            group=VISUAL,
        )
