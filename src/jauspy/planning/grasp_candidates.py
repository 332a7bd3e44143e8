"""Grasps of a seen thing by a parallel gripper: poses of the tool, ranked, with room for palm and fingers.

The tool's x axis points at the thing, its y axis from finger to finger, and its origin is between the finger tips.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Vector
from jauspy.planning.objects import SeenObject
from jauspy.platform.description import GroupSetup, RobotModel

Array: TypeAlias = NDArray[np.float64]

PITCHES: Final = tuple(math.radians(angle) for angle in (0.0, 20.0, 40.0, 60.0, 75.0, 90.0))
"""Radians downward from level, of approaches."""
TURNS: Final = 6
"""Directions of approaches around the thing, besides that from the arm's foot."""
STEPS: Final[Array] = np.array([(0.01 * shift, 0.01 * rise) for shift in range(-3, 3) for rise in range(-5, 8)])
"""Metres along the approach, and upward, from the middle of the thing to the tool."""
STEEP, VERTICAL, ALIGNED = math.radians(59.0), math.radians(89.0), math.radians(5.0)
"""Pitches from which on fingers are turned along a thing, and need no roll for that; the angle that is near enough."""
FINGER_ROOM: Final = 0.005
"""Metres between each open finger and the thing."""
PALM_ROOM: Final = 0.008
"""Metres between palm and thing."""
SUPPORT_ROOM: Final = 0.012
"""Metres between the gripper and the surface on which the thing stands."""
LEAST_WIDTH: Final = 0.008
"""Metres; fingers cannot feel what is thinner."""
LEAST_POINTS: Final = 12
"""Points between the fingers, at least."""
FACE, FACE_DEPTH = 0.012, 0.005
"""Metres along a finger that a face of the thing extends at least, and by which its points may be farther inside."""
FAR: Final = 1e3
"""Metres; beyond all points."""
SAMPLE: Final = 1000
"""Points of a thing that are looked at."""
COLUMN: Final = 0.008
"""Metres between points of a thing, besides."""
AMPLE: Final = 0.03
"""Metres to the surface beyond which more room is no advantage."""
PAD_DEPTH: Final = 0.04
"""Metres from the tips of the fingers to the end of the part that grips."""


@dataclass(frozen=True, slots=True)
class Gripper:
    """The shapes of an open gripper, in the frame of the tool, metres."""

    turns: Array
    """Rotations of boxes, shape (n, 3, 3)."""
    places: Array
    """Their middles, shape (n, 3)."""
    halves: Array
    """Half of their sides, shape (n, 3)."""
    is_finger: NDArray[np.bool_]
    opening: float
    """Width between the open fingers."""
    tip: float
    """Where the fingers end, along x."""
    pad: float
    """Half of the height of a finger, along z."""

    def corners(self) -> Array:
        """The corners of all boxes, shape (8 n, 3)."""
        signs = np.array([(a, b, c) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)], float)
        found: Array = self.places[:, None] + (signs * self.halves[:, None]) @ self.turns.transpose(0, 2, 1)
        return found.reshape(-1, 3)


@dataclass(frozen=True, slots=True)
class Candidate:
    """A grasp, in the frame of the base."""

    pose: Transform
    """The tool, when it has the thing between its fingers."""
    width: float
    """Metres of the thing between the fingers, as seen."""
    pitch: float
    """Radians downward of the approach."""
    cost: float

    @property
    def approach(self) -> Vector:
        """Direction in which the tool comes."""
        return self.pose.rotate((1.0, 0.0, 0.0))

    def moved(self, back: float = 0.0, up: float = 0.0) -> Transform:
        """The tool's pose by metres back along the approach, and upward."""
        x, y, z = self.approach
        px, py, pz = self.pose.position
        return Transform(self.pose.rotation, (px - back * x, py - back * y, pz - back * z + up))


def gripper_of(model: RobotModel, group: GroupSetup, tool: str, opening: float) -> Gripper:
    """The shapes of the gripper whose fingers the joints of a group move, with the fingers open.

    `tool` is the tool's link, `opening` metres between the open fingers. Raises `ConfigError` for a gripper without
    boxes: one whose collision shapes are meshes only.
    """
    boxes = LinkBoxes(model.description, group.joints)
    posture = [model.description.joint(name).upper for name in boxes.joints]
    tree = FrameTree(model.description)
    positions = dict(zip(boxes.joints, posture, strict=True))
    back = tree.pose(tool, positions).inverse()
    turn, place = np.array(back.rotation), np.array(back.position)
    turns, places = boxes.poses(np.array([posture]))
    palm = boxes.body_of(group.base)
    carried = [
        number
        for number, (name, owner) in enumerate(zip(boxes.names, boxes.owners, strict=True))
        if owner != palm or name == group.base
    ]
    if len(carried) < 2:
        raise ConfigError(f"the description has no boxes for the palm and the fingers of {group.base}")
    rotations = np.asarray(turn @ turns[0, carried], np.float64)
    middles = np.asarray(places[0, carried] @ turn.T + place, np.float64)
    halves = np.asarray(boxes.halves[carried], np.float64)
    fingers = np.array([boxes.owners[number] != palm for number in carried])
    reach = (np.abs(rotations) @ halves[..., None])[..., 0]
    tip = float((middles + reach)[fingers, 0].max())
    return Gripper(rotations, middles, halves, fingers, opening, tip, float(reach[fingers, 2].min()))


def candidates(thing: SeenObject, gripper: Gripper, foot: tuple[float, float]) -> list[Candidate]:
    """Grasps of a thing, the best first; `foot` is x and y of the arm's first axis, metres."""
    points = _solid(thing)
    x, y, _ = thing.centre
    out = math.atan2(y - foot[1], x - foot[0])
    headings = [out, *(out + math.tau * (step + 0.5) / TURNS for step in range(TURNS)), thing.yaw]
    headings += [thing.yaw + math.pi / 2.0 * step for step in (1, 2, 3)]
    found = []
    for pitch in PITCHES:
        for heading in headings:
            for roll in _rolls(thing, heading, pitch):
                attitude = _attitude(heading, pitch, roll)
                best = _best(thing, points, gripper, attitude, pitch=pitch, out=out)
                if best is not None:
                    found.append(best)
    return sorted(found, key=lambda one: one.cost)


def _rolls(thing: SeenObject, heading: float, pitch: float) -> list[float]:
    """Radians about the approach: fingers level, upright, and along the sides of the thing if it comes from above."""
    if pitch > VERTICAL:
        return [0.0]
    rolls = [0.0, math.pi / 2.0]
    off = math.remainder(thing.yaw - heading, math.pi / 2.0)
    if pitch >= STEEP and abs(off) > ALIGNED:
        rolls += [-off, math.copysign(math.pi / 2.0, off) - off]
    return rolls


def _attitude(heading: float, pitch: float, roll: float) -> Array:
    """Rotation of a tool whose x axis has a heading, and points downward by `pitch`."""
    c, s = math.cos(heading), math.sin(heading)
    x = np.array([math.cos(pitch) * c, math.cos(pitch) * s, -math.sin(pitch)])
    y = np.array([-s, c, 0.0])
    z = np.cross(x, y)
    return np.stack((x, math.cos(roll) * y + math.sin(roll) * z, math.cos(roll) * z - math.sin(roll) * y), axis=1)


def _best(
    thing: SeenObject, points: Array, gripper: Gripper, attitude: Array, *, pitch: float, out: float
) -> Candidate | None:
    """The best place of the tool with this attitude; None if there is no room, or nothing between the fingers."""
    places = np.array(thing.centre) + STEPS[:, :1] * attitude[:, 0] + STEPS[:, 1:] * (0.0, 0.0, 1.0)
    local = (points @ attitude)[None] - (places @ attitude)[:, None]
    inside = _between(local, gripper)
    low = np.where(inside, local[..., 1], FAR).min(axis=1)
    high = np.where(inside, local[..., 1], -FAR).max(axis=1)
    width, aside = high - low, (low + high) / 2.0
    places = places + aside[:, None] * attitude[:, 1]
    corners = gripper.corners() @ attitude.T
    room = thing.support.heights(places) + thing.support.rises(corners).min()
    fits = (inside.sum(axis=1) >= LEAST_POINTS) & (width >= LEAST_WIDTH) & (room >= SUPPORT_ROOM)
    fits &= width <= gripper.opening - 2.0 * FINGER_ROOM
    if not fits.any():
        return None
    local, offsets, room, width, places, aside, inside = (
        rows[fits] for rows in (local, STEPS, room, width, places, aside, inside)
    )
    local[..., 1] -= aside[:, None]
    seen = abs(math.cos(out) * attitude[0, 1] + math.sin(out) * attitude[1, 1])
    cost = (
        np.hypot(np.hypot(*offsets.T), aside)
        + 1.5 * width.max()  # the least is that between faces
        + 3.0 * (width.max() - width)  # beside the widest place, fingers push a round thing away
        + 0.5 * np.maximum(0.0, AMPLE - room)
        + 0.03 * seen  # the far side is not seen
        + 0.01 * abs(pitch - 0.8)
    )
    cost[~(_has_room(local, gripper) & _has_faces(local, inside, width))] = np.inf
    best = int(cost.argmin())
    if math.isinf(cost[best]):
        return None
    pose = _transform(attitude, places[best])
    return Candidate(pose, float(width[best]), pitch, float(cost[best]))


def _between(local: Array, gripper: Gripper) -> NDArray[np.bool_]:
    """The points between the parts of the fingers that grip, whatever the width; `local`: shape (places, n, 3)."""
    x, z = local[..., 0], local[..., 2]
    found: NDArray[np.bool_] = (np.abs(z) <= gripper.pad) & (x <= gripper.tip) & (x >= gripper.tip - PAD_DEPTH)
    return found


def _has_faces(local: Array, inside: NDArray[np.bool_], width: Array) -> NDArray[np.bool_]:
    """For each place: True if both fingers meet more than an edge or a corner."""
    found = np.ones(len(local), np.bool_)
    for side in (-1.0, 1.0):
        touched = inside & (side * local[..., 1] >= width[:, None] / 2.0 - FACE_DEPTH)
        first = np.where(touched, local[..., 0], FAR).min(axis=1)
        last = np.where(touched, local[..., 0], -FAR).max(axis=1)
        found &= last - first >= FACE
    return found


def _has_room(local: Array, gripper: Gripper) -> NDArray[np.bool_]:
    """For each place: True if no point is where palm or fingers are, or come through on their straight way along x."""
    free = np.ones(len(local), np.bool_)
    for turn, place, half, finger in zip(
        gripper.turns, gripper.places, gripper.halves, gripper.is_finger.tolist(), strict=True
    ):
        reach = np.abs(turn) @ half + (FINGER_ROOM if finger else PALM_ROOM)
        off = local - place
        hit = (off[..., 0] <= reach[0]) & (np.abs(off[..., 1]) <= reach[1]) & (np.abs(off[..., 2]) <= reach[2])
        free &= ~hit.any(axis=1)
    return free


def _solid(thing: SeenObject) -> Array:
    """Points of a thing as if each that was seen had others below, down to the surface: a part of its far side."""
    points = thing.points
    if len(points) > SAMPLE:
        points = points[np.linspace(0, len(points) - 1, SAMPLE).astype(np.intp)]
    heights = thing.support.heights(points)
    layers = [points]
    for drop in np.arange(COLUMN, max(COLUMN, thing.size[2]), COLUMN):
        lower = points[heights > drop] - (0.0, 0.0, drop)
        layers.append(lower)
    solid = np.concatenate(layers)
    kept = np.unique(np.floor(solid / COLUMN).astype(np.int64), axis=0, return_index=True)[1]
    found: Array = solid[kept]
    return found


def _transform(rotation: Array, place: Array) -> Transform:
    rows = [tuple(map(float, row)) for row in rotation]
    x, y, z = map(float, place)
    return Transform((rows[0], rows[1], rows[2]), (x, y, z))  # type: ignore[arg-type]
