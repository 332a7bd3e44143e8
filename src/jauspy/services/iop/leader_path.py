"""The path that a leader has driven, in metres along it, from where its follower is on."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice, pairwise
from typing import Final

from jauspy.geometry.poses import PlanarPoint

SPACING: Final = 0.1
"""Metres between two points that are kept; the newest one may be nearer."""
MAX_POINTS: Final = 4096
"""Points that are kept; of a longer path nothing is known, and the follower is too far behind in any case."""
WINDOW: Final = 1.5
"""Metres of the path ahead in which the follower is looked for: not on a later part of it that comes near."""
MEMORY: Final = 1.0
"""Metres of the path that are kept behind the follower."""


@dataclass(slots=True)
class PathPoint:
    """A point of the path: where, how far along it in metres, and until when the leader was there, in seconds."""

    position: PlanarPoint
    along: float
    time: float


@dataclass(frozen=True, slots=True)
class PathPlace:
    """A place on the path, or beside it."""

    along: float
    """Metres along the path."""
    direction: float
    """Direction of the path there, radians from x towards y."""
    aside: float
    """Metres beside the path, positive in the direction from x towards y."""


class LeaderPath:
    """Begins at the follower, and is extended by each pose of the leader; the part behind the follower is forgotten."""

    def __init__(self, follower: PlanarPoint, leader: PlanarPoint, now: float) -> None:
        distance, _ = follower.to(leader)
        self._points = deque([PathPoint(follower, 0.0, now), PathPoint(leader, distance, now)])
        self._place = 0.0

    def __len__(self) -> int:
        return len(self._points)

    @property
    def leader(self) -> PathPoint:
        """Where the leader was last."""
        return self._points[-1]

    @property
    def is_full(self) -> bool:
        """True if the path is longer than what is kept."""
        return len(self._points) >= MAX_POINTS

    def extend(self, leader: PlanarPoint, heading: float, now: float) -> None:
        """Add a pose of the leader, its heading in radians from x towards y; driving back shortens the path."""
        points = self._points
        if _ahead(leader, points[-1].position, heading) > 0.0:
            back = points[-1].along - leader.to(points[-1].position)[0]
            while len(points) > 2 and points[-2].along >= back:
                points.pop()
            self._set_leader(leader, now)
        elif points[-2].position.to(leader)[0] < SPACING:
            self._set_leader(leader, now)
        elif not self.is_full:
            distance, _ = points[-1].position.to(leader)
            points.append(PathPoint(leader, points[-1].along + distance, now))

    def _set_leader(self, leader: PlanarPoint, now: float) -> None:
        before = self._points[-2]
        self._points[-1] = PathPoint(leader, before.along + before.position.to(leader)[0], now)

    def follower(self, position: PlanarPoint) -> PathPlace:
        """Where the follower is, at the nearest point of the path ahead of where it was; forgets what is behind."""
        nearest: PathPlace | None = None
        best = math.inf
        for start, end in self._segments():
            if start.along > self._place + WINDOW:
                break
            if end.along < self._place:
                continue
            length, direction = start.position.to(end.position)
            dx, dy = position.x - start.position.x, position.y - start.position.y
            ahead = dx * math.cos(direction) + dy * math.sin(direction)
            covered = min(length, max(0.0, ahead, self._place - start.along))
            distance = math.hypot(
                dx - covered * math.cos(direction),
                dy - covered * math.sin(direction),
            )
            if distance < best:
                best = distance
                aside = dy * math.cos(direction) - dx * math.sin(direction)
                nearest = PathPlace(start.along + covered, direction, math.copysign(distance, aside))
        if nearest is None:  # the leader drove back behind the follower
            return PathPlace(self._place, self._points[-2].position.to(self.leader.position)[1], 0.0)
        self._place = max(self._place, nearest.along)
        while len(self._points) > 2 and self._points[1].along < self._place - MEMORY:
            self._points.popleft()
        return nearest

    def point(self, along: float) -> tuple[PlanarPoint, float]:
        """The point that far along the path, and the path's direction there; beyond the leader straight on."""
        for start, end in self._segments():
            if end.along >= along and end.along > start.along:
                break
        length, direction = start.position.to(end.position)
        far = along - start.along if length else 0.0
        return PlanarPoint(
            start.position.x + far * math.cos(direction), start.position.y + far * math.sin(direction)
        ), direction

    def passed(self, time: float) -> float:
        """How far along the path the leader was at that time, in metres."""
        points = self._points
        if time >= points[-1].time:
            return points[-1].along
        later = points[-1]
        for earlier in islice(reversed(points), 1, None):
            if earlier.time <= time:
                share = (time - earlier.time) / (later.time - earlier.time) if later.time > earlier.time else 1.0
                return earlier.along + share * (later.along - earlier.along)
            later = earlier
        return points[0].along

    def _segments(self) -> Iterator[tuple[PathPoint, PathPoint]]:
        return pairwise(self._points)


def _ahead(point: PlanarPoint, other: PlanarPoint, heading: float) -> float:
    """Metres by which the other point is ahead of this one."""
    return (other.x - point.x) * math.cos(heading) + (other.y - point.y) * math.sin(heading)
