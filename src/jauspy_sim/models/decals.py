"""Shapes on the ground below a robot that are only seen: its contact shadow, and the marks of its tracks.

They are in the model that cameras draw, not in that for physics; `jauspy_sim.rendering.decals` moves them. MuJoCo has
no transparent textures, so the shadow is made of rings, each slightly darker than the one around it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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

LAYER_GAP: Final = 0.0003
"""Metres between shapes above each other; a pixel's depth differs by a tenth of that at 3 m."""


class Shade(NamedTuple):
    """A shadow that darkens from its edge inward."""

    outer: float
    """Metres from the edge of what is above it to where the shadow begins."""
    inner: float
    """Distance to where it is darkest; negative inside of the edge."""
    darkness: float
    """Opacity there."""
    rings: int


BODY_SHADE: Final = Shade(0.12, -0.12, 0.5, 10)
"""Below the whole robot."""
FOOT_SHADE: Final = Shade(0.045, -0.015, 0.55, 5)
"""Below its tracks or wheels, in addition."""
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
    """Parts of a robot above the ground, and those that stand on it."""

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
    _add_rings(spec, 0, [found.body], BODY_SHADE)
    _add_rings(spec, BODY_SHADE.rings, found.feet, FOOT_SHADE)
    if robot.tracks is not None:
        width = found.feet[0].left - found.feet[0].right
        bar = MARK_LENGTH / BARS
        whole = Rectangle(-0.5 * MARK_LENGTH, 0.5 * MARK_LENGTH, -0.5 * width, 0.5 * width)
        bars = [
            Rectangle(start + 0.2 * bar, start + 0.75 * bar, -0.5 * width, 0.5 * width)
            for start in np.arange(BARS) * bar - 0.5 * MARK_LENGTH
        ]
        sheets = [(_corners(whole), 0.0), *((_corners(bar), LAYER_GAP) for bar in bars)]
        mesh = _Mesh()
        for outline, height in sheets:
            mesh.add_sheet(outline, height)
        mesh.add_to(spec, MARK, [f"{MARK} {number}" for number in range(4 * MARKS)])


def opacities() -> list[float]:
    """The opacity of each ring of the shadow."""
    shades = (BODY_SHADE, FOOT_SHADE)
    return [shade.darkness * _smooth((ring + 1) / shade.rings) for shade in shades for ring in range(shade.rings)]


def _smooth(x: float) -> float:
    """Step from 0 to 1, level at both ends."""
    return x * x * (3.0 - 2.0 * x)


def _add_rings(spec: mujoco.MjSpec, first: int, rectangles: Sequence[Rectangle], shade: Shade) -> None:
    """Add the rings of a shadow, from outside inward; the last one is closed. They are numbered from `first`."""
    reaches = np.linspace(shade.outer, shade.inner, shade.rings + 1)
    height = LAYER_GAP * (first > 0)
    for ring in range(shade.rings):
        mesh = _Mesh()
        for rectangle in rectangles:
            outline = _rounded(rectangle, reaches[ring])
            if ring == shade.rings - 1:
                mesh.add_sheet(outline, height)
            else:
                mesh.add_ring(outline, _rounded(rectangle, reaches[ring + 1]), height)
        name = f"{SHADOW} {first + ring}"
        mesh.add_to(spec, name, [name])


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


def decals_of(model: mujoco.MjModel) -> NDArray[np.bool_]:
    """Mask of the shapes of a model that are decals."""
    return np.array([model.geom(geom).name.startswith((SHADOW, MARK)) for geom in range(model.ngeom)], np.bool_)


class _Mesh:
    """A mesh of level faces, seen from above."""

    def __init__(self) -> None:
        self._points: list[Floats] = []
        self._faces: list[tuple[int, int, int]] = []

    def add_sheet(self, outline: Floats, height: float) -> None:
        """Add the inside of a convex outline."""
        first = self._add(outline, height)
        self._faces += [(first, first + corner, first + corner + 1) for corner in range(1, len(outline) - 1)]

    def add_ring(self, outer: Floats, inner: Floats, height: float) -> None:
        """Add what is between two outlines of as many points."""
        count = len(outer)
        first, second = self._add(outer, height), self._add(inner, height)
        for corner in range(count):
            after = (corner + 1) % count
            self._faces.append((first + corner, first + after, second + after))
            self._faces.append((first + corner, second + after, second + corner))

    def add_to(self, spec: mujoco.MjSpec, name: str, geoms: Sequence[str]) -> None:
        """Add the mesh, and shapes that show it."""
        mesh = spec.add_mesh(name=name, inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL)
        mesh.uservert = np.concatenate(self._points).ravel()
        mesh.userface = np.array(self._faces).ravel()
        for geom in geoms:
            spec.worldbody.add_geom(
                name=geom,
                type=mujoco.mjtGeom.mjGEOM_MESH,
                meshname=name,
                rgba=(0.0, 0.0, 0.0, 0.0),
                contype=0,
                conaffinity=0,
                mass=0.0,
                group=VISUAL,
            )

    def _add(self, outline: Floats, height: float) -> int:
        first = sum(len(point) for point in self._points)
        self._points.append(np.column_stack([outline, np.full(len(outline), height)]))
        return first
