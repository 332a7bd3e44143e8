"""The robot's own body in what its sensors see: boxes around its links at the positions of its joints. Needs numpy."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.geometry.urdf import RobotDescription
from jauspy.planning.link_looks import link_looks
from jauspy.planning.obstacles import Box

Array: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]

BEYOND: Final = 0.5
"""Metres by which a robot looks larger than the boxes of all its links together, at most."""


class OwnBody:
    """What the links of a robot fill, and `margin` metres around it; points are in the frame of the root link.

    These are the boxes around collision shapes, and the looks of links. Boxes for links that have neither
    (`without_shape`), and for what the robot holds, are given by `attach`.
    """

    def __init__(self, description: RobotDescription, margin: float) -> None:
        joints = [joint.name for joint in description.joints.values() if joint.is_independent]
        self._boxes = LinkBoxes(description, joints)
        self._links = description.links()
        self._looks, self.unread = link_looks(description.urdf, margin)
        """Files of meshes that cannot be read."""
        self._margin = margin
        self._attached: dict[str, tuple[str, Box]] = {}

    @property
    def joints(self) -> tuple[str, ...]:
        """The joints that move links."""
        return self._boxes.joints

    @property
    def without_shape(self) -> list[str]:
        """Links of which nothing is filtered out, as those that are frames only."""
        carried = {link for link, _ in self._attached.values()}
        return sorted(self._links - set(self._boxes.names) - carried - {look.link for look in self._looks})

    def attach(self, link: str, box: Box) -> None:
        """Count a box in the frame of a link as part of the body; it replaces an earlier one of its name."""
        self._boxes.body_of(link)
        self._attached[box.name] = link, box

    def detach(self, name: str) -> None:
        """Do not count an attached box any more; without effect for an unknown name."""
        self._attached.pop(name, None)

    def frame(self, link: str, positions: Mapping[str, float]) -> tuple[Array, Array]:
        """Rotation (3, 3) and position (3) of a link; raises `KeyError` for an unknown one."""
        turn, place = self._boxes.frame(link, self._posture(positions))
        return turn.astype(np.float64), place.astype(np.float64)

    def contains(self, points: Array, postures: Iterable[Mapping[str, float]], margin: float | None = None) -> Flags:
        """For each point, shape (n, 3): True if it is in the body in one of these postures.

        With a `margin` of its own, only the boxes count.
        """
        inside = np.zeros(len(points), np.bool_)
        for positions in postures:
            turns, middles, halves = self._placed(positions, self._margin if margin is None else margin)
            reach = (np.abs(turns) @ halves[..., None])[..., 0]
            near = (points >= (middles - reach).min(axis=0)) & (points <= (middles + reach).max(axis=0))
            numbers = np.flatnonzero(near.all(axis=1) & ~inside)
            close = points[numbers]
            for turn, middle, half, wide in zip(turns, middles, halves, reach, strict=True):
                about = np.flatnonzero((np.abs(close - middle) <= wide).all(axis=1))
                within = (np.abs((close[about] - middle) @ turn) <= half).all(axis=1)
                inside[numbers[about[within]]] = True
            if margin is None and self._looks:
                low, high = (middles - reach).min(axis=0) - BEYOND, (middles + reach).max(axis=0) + BEYOND
                around = np.flatnonzero(((points >= low) & (points <= high)).all(axis=1))
                for look in self._looks:
                    turn, place = self.frame(look.link, positions)
                    left = around[~inside[around]]
                    inside[left[look.contains((points[left] - place) @ turn)]] = True
        return inside

    def samples(self, positions: Mapping[str, float], spacing: float) -> Array:
        """Points in the body, at most `spacing` metres apart, shape (n, 3)."""
        found = []
        for turn, middle, half in zip(*self._placed(positions, self._margin), strict=True):
            axes = [np.linspace(-side, side, max(2, int(np.ceil(2.0 * side / spacing)) + 1)) for side in half]
            grid = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
            found.append(middle + grid @ turn.T)
        return np.concatenate(found) if found else np.empty((0, 3))

    def _posture(self, positions: Mapping[str, float]) -> Sequence[float]:
        return [positions.get(name, 0.0) for name in self._boxes.joints]

    def _placed(self, positions: Mapping[str, float], margin: float) -> tuple[Array, Array, Array]:
        """Rotations (b, 3, 3), middles (b, 3) and half sides (b, 3) of all boxes, these larger by a margin."""
        turns, middles = self._boxes.poses(np.array([self._posture(positions)]))
        rotations, places, halves = [turns[0]], [middles[0]], [self._boxes.halves]
        for link, box in self._attached.values():
            turn, place = self.frame(link, positions)
            rotations.append((turn @ np.array(box.pose.rotation))[None])
            places.append((place + turn @ np.array(box.pose.position))[None])
            halves.append(np.array(box.size)[None] / 2.0)
        return np.concatenate(rotations), np.concatenate(places), np.concatenate(halves) + margin
