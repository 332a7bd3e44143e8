"""Characteristics of ISO 9283 from measured poses: of poses, of linear paths, of arrivals, and their drift.

AP is the distance of the mean attained pose from the commanded one, RP the mean distance of the attained poses from
their mean plus three standard deviations (clauses 7.2.1 and 7.2.2). Angles are about the axes of the tool. AT and RT
are the same at planes across the path, the largest of which counts (clauses 8.2 and 8.3). The stabilisation time begins
when the tool first comes into a band around the pose where it ends up, and ends when it stays there; the overshoot is
how far it leaves the band in between (clauses 7.4 and 7.5). Drift is the change of AP and RP over time (clause 7.6).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple, TypeAlias

import numpy as np
import pinocchio as pin

from jauspy.cell.frames import Array, averaged

ALONG_DIAGONAL: Final = 0.1
"""P2 to P5 are that far from the ends of the plane's diagonals, as a fraction of their length."""
PLANES: Final = 46
"""Planes across a path at which it is compared."""
EDGE: Final = 0.05
"""Fraction of a path at each end that does not count: there the tool starts and stops."""

Angles: TypeAlias = tuple[float, float, float]
"""Values about the axes x, y, z of the tool, radians: a, b, c of the standard."""


@dataclass(slots=True)
class LaserTracker:
    """Measures true poses with noise; its standard deviations are those of a tracker with a six-axis probe."""

    random: np.random.Generator
    position: float = 15e-6
    """Standard deviation of the position, metres."""
    angle: float = 1e-4
    """Standard deviation of the angles, radians."""

    def measure(self, pose: pin.SE3) -> pin.SE3:
        """Measure a pose once."""
        turn = pin.exp3(self.random.normal(0.0, self.angle, 3))
        return pin.SE3(pose.rotation @ turn, pose.translation + self.random.normal(0.0, self.position, 3))


def cube_points(center: Sequence[float], side: float) -> list[Array]:
    """P1 to P5: the middle of the plane through two opposite edges of the cube, and four points on its diagonals."""
    half = side / 2.0 * (1.0 - 2.0 * ALONG_DIAGONAL)
    corners = ((0.0, 0.0, 0.0), (half, half, half), (half, -half, half), (-half, -half, -half), (-half, half, -half))
    return [np.array(center) + np.array(corner) for corner in corners]


@dataclass(frozen=True, slots=True)
class Accuracy:
    """Accuracy and repeatability of a pose, or of a path, metres and radians."""

    accuracy: float
    """AP or AT of the position."""
    repeatability: float
    """RP or RT of the position."""
    angles: Angles = (0.0, 0.0, 0.0)
    """AP or AT about each axis."""
    angle_spreads: Angles = (0.0, 0.0, 0.0)
    """RP or RT about each axis: three standard deviations."""

    @property
    def angle_accuracy(self) -> float:
        """AP or AT about the worst axis."""
        return max(self.angles)

    @property
    def angle_repeatability(self) -> float:
        """RP or RT about the worst axis."""
        return max(self.angle_spreads)


def accuracy(commanded: pin.SE3, attained: Sequence[pin.SE3]) -> Accuracy:
    """AP and RP of a pose; a single measurement has no spread."""
    mean = averaged(list(attained))
    distances = np.array([float(np.linalg.norm(pose.translation - mean.translation)) for pose in attained])
    spread = float(np.std(distances, ddof=1)) if len(attained) > 1 else 0.0
    turns = np.array([pin.log3(mean.rotation.T @ pose.rotation) for pose in attained])
    deviations = np.std(turns, axis=0, ddof=1) if len(attained) > 1 else np.zeros(3)
    return Accuracy(
        float(np.linalg.norm(mean.translation - commanded.translation)),
        float(np.mean(distances)) + 3.0 * spread,
        _angles(np.abs(pin.log3(commanded.rotation.T @ mean.rotation))),
        _angles(3.0 * deviations),
    )


def _angles(values: Array) -> Angles:
    a, b, c = values.tolist()
    return a, b, c


def largest(found: Iterable[Accuracy]) -> Accuracy:
    """The largest figures of all poses, or of all planes of a path."""
    rows = list(found)
    return Accuracy(
        max(row.accuracy for row in rows),
        max(row.repeatability for row in rows),
        _angles(np.max([row.angles for row in rows], axis=0)),
        _angles(np.max([row.angle_spreads for row in rows], axis=0)),
    )


# --- arrivals -----------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Arrival:
    """How the tool came to rest at a pose."""

    stabilisation: float
    """Seconds from the first time in the band until it stays there."""
    overshoot: float
    """Largest distance, in metres, from where it ended up, once it had been in the band; zero if it stayed there."""


def arrival(times: Sequence[float], distances: Sequence[float], band: float) -> Arrival:
    """The arrival at a pose, by the distances (m) at these times (s) from where the tool ends up."""
    outside = np.asarray(distances) > band
    first = int(np.argmin(outside))
    later = np.flatnonzero(outside[first:])
    if outside[first] or not len(later):
        return Arrival(0.0, 0.0)
    last = first + int(later[-1]) + 1
    end = times[min(last, len(times) - 1)]
    return Arrival(end - times[first], float(np.max(np.asarray(distances)[first:])))


# --- paths --------------------------------------------------------------------------------------------------------


class Sample(NamedTuple):
    """One measurement of a moving tool."""

    time: float
    """Seconds."""
    pose: pin.SE3


@dataclass(frozen=True, slots=True)
class PathAccuracy:
    """Accuracy and repeatability of a linear path."""

    worst: Accuracy
    """AT and RT: the largest figures of all planes."""
    deviations: Array
    """Shape (planes, 3): the mean path less the commanded one, in the world, metres."""
    speed: float
    """Mean speed along the path between the first and the last plane, m/s."""
    cycles: int = 0
    """Measured passages."""


def line(start: pin.SE3, end: pin.SE3, planes: int = PLANES, edge: float = EDGE) -> list[pin.SE3]:
    """Commanded poses on a linear path, one in each plane across it: straight, and turning evenly."""
    turn = pin.log3(start.rotation.T @ end.rotation)
    way = end.translation - start.translation
    return [
        pin.SE3(start.rotation @ pin.exp3(part * turn), start.translation + part * way)
        for part in np.linspace(edge, 1.0 - edge, planes)
    ]


def path_accuracy(commanded: Sequence[pin.SE3], passages: Sequence[Sequence[Sample]]) -> PathAccuracy:
    """AT and RT of a linear path, by samples of each passage.

    `commanded` are the poses in the planes, all on a line. Raises `ValueError` for a passage that does not cross all.
    """
    way = commanded[-1].translation - commanded[0].translation
    length = float(np.linalg.norm(way))
    along = way / length
    places = np.array([float((pose.translation - commanded[0].translation) @ along) for pose in commanded])
    crossings = [_crossings(samples, commanded[0].translation, along, places) for samples in passages]
    rows = [accuracy(pose, [found[number].pose for found in crossings]) for number, pose in enumerate(commanded)]
    means = [averaged([found[number].pose for found in crossings]).translation for number in range(len(commanded))]
    offsets = np.array([mean - pose.translation for mean, pose in zip(means, commanded, strict=True)])
    speeds = [length / (found[-1].time - found[0].time) for found in crossings]
    return PathAccuracy(largest(rows), offsets, float(np.mean(speeds)), len(passages))


def _crossings(samples: Sequence[Sample], origin: Array, along: Array, places: Array) -> list[Sample]:
    """The first time and pose of a tool in each plane, between the samples before and after it."""
    travel = np.array([float((sample.pose.translation - origin) @ along) for sample in samples])
    found = []
    for place in places.tolist():
        beyond = travel >= place
        number = int(np.argmax(beyond))
        if not beyond[number] or number == 0:
            raise ValueError(f"the tool does not cross the plane at {1000.0 * place:.0f} mm of its path")
        before, after = samples[number - 1], samples[number]
        part = (place - travel[number - 1]) / (travel[number] - travel[number - 1])
        turn = pin.log3(before.pose.rotation.T @ after.pose.rotation)
        pose = pin.SE3(
            before.pose.rotation @ pin.exp3(part * turn),
            before.pose.translation + part * (after.pose.translation - before.pose.translation),
        )
        found.append(Sample(before.time + part * (after.time - before.time), pose))
    return found


# --- drift --------------------------------------------------------------------------------------------------------


class DriftPoint(NamedTuple):
    """Accuracy of one pose, measured at a time."""

    time: float
    """Seconds since the first measurement."""
    accuracy: Accuracy


@dataclass(frozen=True, slots=True)
class Drift:
    """Accuracy of one pose over time, the first measurement first."""

    points: tuple[DriftPoint, ...]

    @property
    def accuracy(self) -> float:
        """dAP: the largest change of AP since the first measurement, metres."""
        return max(abs(point.accuracy.accuracy - self.points[0].accuracy.accuracy) for point in self.points)

    @property
    def repeatability(self) -> float:
        """dRP: the largest change of RP since the first measurement, metres."""
        return max(abs(point.accuracy.repeatability - self.points[0].accuracy.repeatability) for point in self.points)

    @property
    def duration(self) -> float:
        """Seconds from the first to the last measurement."""
        return self.points[-1].time
