"""Clearances between the links of a robot, by the boxes around their collision shapes, for many postures at once.

The same as in `link_clearances`, which is for one posture and does without numpy; this module needs it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from jauspy.geometry.link_boxes import LinkBoxes
from jauspy.geometry.link_clearances import PARALLEL
from jauspy.geometry.link_pairs import LinkPairs, Pair, mover

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array: TypeAlias = NDArray[np.floating[Any]]


class PostureClearances:
    """The clearances of pairs of boxes whose distance the joints of `boxes` change.

    All other joints count as rigid: the belt beside a flipper, always 1 cm away, would be the nearest link of all. Left
    out are pairs that touch in the posture `start`, in which the robot stands: their boxes are larger than what is in
    them, and would stop motions that are free. The posture zero would not do: arms may lie on the robot there.
    """

    def __init__(self, boxes: LinkBoxes, start: Mapping[str, float]) -> None:
        self._boxes = boxes
        self._radii = np.linalg.norm(boxes.halves, axis=1)
        joints = boxes.description.joints.values()
        rigid = [joint.name for joint in joints if mover(joint) not in boxes.joints]
        self._link_pairs = LinkPairs(boxes.description, boxes.joints, rigid=rigid)
        found = [
            (one, other)
            for one, other in combinations(range(len(boxes.names)), 2)
            if self._link_pairs.movers(boxes.names[one], boxes.names[other])
        ]
        self._set_pairs(found)
        if found:
            posture = np.array([[start.get(name, 0.0) for name in boxes.joints]])
            apart = self.at(posture)[0] > 0.0
            touching = {self.pair(number) for number in np.flatnonzero(~apart).tolist()}
            self._set_pairs([pair for number, pair in enumerate(found) if self.pair(number) not in touching])

    def __len__(self) -> int:
        """The number of pairs."""
        return len(self._one)

    def pair(self, number: int) -> Pair:
        """The names of the two links of a pair."""
        return self._boxes.names[self._one[number]], self._boxes.names[self._other[number]]

    def movers(self, number: int) -> frozenset[str]:
        """The joints that change the clearance of a pair."""
        return self._link_pairs.movers(*self.pair(number))

    def at(self, postures: Array, *, near: float | None = None) -> Array:
        """The clearances, metres, in postures of shape (n, joints); shape (n, pairs).

        With `near`, pairs that stay further apart by their bounding spheres get the clearance of those.
        """
        turns, places = self._boxes.poses(postures)
        centres = places[:, self._other] - places[:, self._one]
        spheres: Array = np.sqrt(np.einsum("npi,npi->np", centres, centres)) - self._both_radii
        if near is None:
            return self._separations(turns, centres, slice(None))
        close = np.flatnonzero((spheres < near).any(axis=0))
        if len(close):
            spheres[:, close] = self._separations(turns, centres[:, close], close)
        return spheres

    def _set_pairs(self, pairs: Sequence[tuple[int, int]]) -> None:
        self._one = np.array([one for one, _ in pairs], np.intp)
        self._other = np.array([other for _, other in pairs], np.intp)
        self._both_radii = self._radii[self._one] + self._radii[self._other]

    def _separations(self, turns: Array, centres: Array, pairs: Any) -> Array:
        """The greatest separation along the axes of both boxes, and those across two of their edges."""
        one, other = self._one[pairs], self._other[pairs]
        a, b = turns[:, one], turns[:, other]
        half_a, half_b = self._boxes.halves[one], self._boxes.halves[other]
        mixed = np.swapaxes(a, -1, -2) @ b
        size = np.abs(mixed)
        in_a = np.einsum("npji,npj->npi", a, centres)
        in_b = np.einsum("npji,npj->npi", b, centres)
        best = (np.abs(in_a) - half_a - np.einsum("npij,pj->npi", size, half_b)).max(axis=-1)
        best = np.maximum(best, (np.abs(in_b) - half_b - np.einsum("npij,pi->npj", size, half_a)).max(axis=-1))
        after, last = [1, 2, 0], [2, 0, 1]
        across = np.abs(in_a[..., last, None] * mixed[..., after, :] - in_a[..., after, None] * mixed[..., last, :])
        across -= half_a[:, after, None] * size[..., last, :] + half_a[:, last, None] * size[..., after, :]
        across -= half_b[:, None, after] * size[..., last] + half_b[:, None, last] * size[..., after]
        sines = 1.0 - mixed * mixed  # squared
        least = PARALLEL * PARALLEL
        across = np.where(sines > least, across / np.sqrt(np.maximum(sines, least)), -np.inf)
        found: Array = np.maximum(best, across.max(axis=(-1, -2)))
        return found
