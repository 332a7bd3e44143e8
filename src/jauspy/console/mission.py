"""A mission: waypoints with speeds and actions, and no-go areas; saved as JSON (docs/missions.md has the form).

Positions are metres in the robot's local frame, x forward and y left of where it started (REP-103), or latitude and
longitude in degrees (WGS 84).
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated, Any, Final, Literal, TypeAlias

from pydantic import BaseModel, ConfigDict, Field

from jauspy.console.conventions import Conventions
from jauspy.console.geographic_frame import GeographicFrame
from jauspy.console.languages import joined, sentence
from jauspy.console.route import MAX_WAYPOINTS, Waypoint
from jauspy.console.trajectory import UNKNOWN, Author, read_model
from jauspy.errors import ConfigError
from jauspy.printable import printable

FORMAT: Final = "jauspy-mission"
VERSION: Final = 1
MAX_AREAS: Final = 50
MAX_CORNERS: Final = 100
MAX_DISTANCE: Final = 10_000.0
"""Metres from the origin of the local frame."""
MIN_SPEED: Final = 0.01
"""m/s; a robot that is slower seems to stand, and reaches no waypoint in useful time."""
MAX_SPEED: Final = 5.0
"""m/s; the robot also has its own limits."""
MAX_WAIT: Final = 3600.0
"""Seconds."""

Point: TypeAlias = tuple[float, float]


def _in_si(speed: float) -> str:
    return f"{speed:g} m/s"


def check_speed(speed: float, shown: Callable[[float], str] = _in_si) -> None:
    """Raise `ConfigError` for a speed with which no mission can be driven; `shown` is how speeds are written."""
    if not MIN_SPEED <= speed <= MAX_SPEED:
        raise ConfigError(
            sentence("a speed is at least {least} and at most {most}", least=shown(MIN_SPEED), most=shown(MAX_SPEED))
        )


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, allow_inf_nan=False)


class Wait(_Strict):
    """Stand for some seconds."""

    kind: Literal["wait"] = "wait"
    seconds: Annotated[float, Field(gt=0.0, le=MAX_WAIT)]

    @property
    def text(self) -> str:
        """The action in words."""
        return sentence("wait {seconds:g} s", seconds=self.seconds)


class Look(_Strict):
    """Turn the camera's pan-tilt unit: radians, pan to the left and tilt downwards (REP-103)."""

    kind: Literal["look"] = "look"
    pan: Annotated[float, Field(ge=-math.pi, le=math.pi)]
    tilt: Annotated[float, Field(ge=-math.pi, le=math.pi)] = 0.0

    @property
    def text(self) -> str:
        """The action in words."""
        return self.shown(Conventions())

    def shown(self, conventions: Conventions) -> str:
        """The action in words, with the unit of a page."""
        return sentence(
            "look {pan}, {tilt}", pan=conventions.angle_text(self.pan), tilt=conventions.angle_text(self.tilt)
        )


class Still(_Strict):
    """Save a still image into the folder of recordings; of the only camera, or of that with this name."""

    kind: Literal["still"] = "still"
    camera: Annotated[str, Field(max_length=64)] = ""

    @property
    def text(self) -> str:
        """The action in words."""
        if not self.camera:
            return sentence("still image")
        return sentence("still image of {camera}", camera=printable(self.camera))


Action: TypeAlias = Wait | Look | Still


class _PointModel(_Strict):
    x: Annotated[float, Field(ge=-MAX_DISTANCE, le=MAX_DISTANCE)] | None = None
    y: Annotated[float, Field(ge=-MAX_DISTANCE, le=MAX_DISTANCE)] | None = None
    latitude: Annotated[float, Field(ge=-90.0, le=90.0)] | None = None
    longitude: Annotated[float, Field(ge=-180.0, le=180.0)] | None = None


class _WaypointModel(_PointModel):
    speed: Annotated[float, Field(ge=MIN_SPEED, le=MAX_SPEED)] | None = None
    action: Annotated[Action, Field(discriminator="kind")] | None = None


class _AreaModel(_Strict):
    name: Annotated[str, Field(max_length=64)] = ""
    corners: Annotated[list[_PointModel], Field(min_length=3, max_length=MAX_CORNERS)]


class _FileModel(_Strict):
    format: Literal["jauspy-mission"]
    version: Literal[1]
    frame: Literal["local", "global"]
    robot: Annotated[str, Field(max_length=255)] = ""
    author: Author = UNKNOWN
    waypoints: Annotated[list[_WaypointModel], Field(max_length=MAX_WAYPOINTS)]
    no_go: Annotated[list[_AreaModel], Field(max_length=MAX_AREAS)] = []


@dataclass(frozen=True, slots=True)
class Step:
    """What a waypoint has besides its place: the speed on the way to it, m/s, and what is done there."""

    speed: float | None = None
    action: Action | None = None

    def shown(self, conventions: Conventions) -> str:
        """Speed and action in words, with the units of a page; empty without both."""
        parts = [] if self.speed is None else [conventions.exact_speed(self.speed)]
        if isinstance(self.action, Look):
            parts.append(self.action.shown(conventions))
        elif self.action is not None:
            parts.append(self.action.text)
        return joined(parts, ", ")


PLAIN: Final = Step()


@dataclass(frozen=True, slots=True)
class Area:
    """A polygon into which no leg of a mission may lead."""

    corners: tuple[Point, ...]
    name: str = ""


@dataclass(frozen=True, slots=True)
class Mission:
    """Waypoints in the local frame, a step for each, and no-go areas."""

    waypoints: tuple[Waypoint, ...] = ()
    steps: tuple[Step, ...] = ()
    areas: tuple[Area, ...] = ()
    author: Author = UNKNOWN

    def to_json(self, robot: str, author: Author | None = None, frame: GeographicFrame | None = None) -> str:
        """The content of a file; of a global one if `frame` says where the local frame is on the globe."""

        def point(x: float, y: float) -> dict[str, float]:
            if frame is None:
                return {"x": x, "y": y}
            latitude, longitude = frame.to_globe(x, y)
            return {"latitude": round(latitude, 8), "longitude": round(longitude, 8)}

        waypoints: list[dict[str, Any]] = []
        for waypoint, step in zip(self.waypoints, self.steps, strict=True):
            row: dict[str, Any] = point(waypoint.x, waypoint.y)
            if step.speed is not None:
                row["speed"] = step.speed
            if step.action is not None:
                row["action"] = step.action.model_dump()
            waypoints.append(row)
        content: dict[str, Any] = {
            "format": FORMAT,
            "version": VERSION,
            "frame": "local" if frame is None else "global",
            "robot": robot,
            **({} if author is None else {"author": author.model_dump()}),
            "waypoints": waypoints,
            "no_go": [
                {"name": area.name, "corners": [point(*corner) for corner in area.corners]} for area in self.areas
            ],
        }
        return json.dumps(content, indent=2) + "\n"

    @classmethod
    def from_json(cls, text: str | bytes, name: str = "the file", frame: GeographicFrame | None = None) -> Mission:
        """Read a file; raises `ConfigError` with place and reason. Global ones need `frame`."""
        data = read_model(_FileModel, text, name, guide="docs/missions.md")
        if data.frame == "global" and frame is None:
            raise ConfigError(
                sentence("{name}: is in degrees, and this robot does not report where it is on the globe", name=name)
            )

        def local(at: str, model: _PointModel) -> Point:
            given = {key for key in ("x", "y", "latitude", "longitude") if getattr(model, key) is not None}
            wanted = {"x", "y"} if data.frame == "local" else {"latitude", "longitude"}
            if given != wanted:
                one, other = sorted(wanted)
                raise ConfigError(
                    sentence(
                        "{name}: {at}: needs {one} and {other}, as frame is {frame!r}",
                        name=name,
                        at=at,
                        one=one,
                        other=other,
                        frame=data.frame,
                    )
                )
            if data.frame == "local":
                assert model.x is not None
                assert model.y is not None
                return model.x, model.y
            assert frame is not None
            assert model.latitude is not None
            assert model.longitude is not None
            x, y = frame.to_local(model.latitude, model.longitude)
            if not math.hypot(x, y) < MAX_DISTANCE:
                raise ConfigError(
                    sentence(
                        "{name}: {at}: is {distance:.0f} km from the robot's origin",
                        name=name,
                        at=at,
                        distance=math.hypot(x, y) / 1000.0,
                    )
                )
            return round(x, 3), round(y, 3)

        places = [local(f"waypoints.{index}", each) for index, each in enumerate(data.waypoints)]
        areas = []
        for index, area in enumerate(data.no_go):
            corners = tuple(local(f"no_go.{index}.corners.{at}", each) for at, each in enumerate(area.corners))
            areas.append(Area(corners, printable(area.name)))
        return cls(
            tuple(Waypoint(*at) for at in places),
            tuple(Step(each.speed, each.action) for each in data.waypoints),
            tuple(areas),
            data.author,
        )

    def with_step(self, index: int, step: Step) -> Mission:
        """A copy with another step for a waypoint."""
        return replace(self, steps=(*self.steps[:index], step, *self.steps[index + 1 :]))


def crossing(points: Sequence[Point], areas: Sequence[Area]) -> str:
    """The leg of a way that leads into an area, as text; empty if none does. The first point is where the robot is."""
    for number, area in enumerate(areas, 1):
        called, edges = sentence("the no-go area {area}", area=area.name or number), list(_edges(area.corners))
        for index, (begin, end) in enumerate(pairwise(points), 1):
            if is_inside(end, area.corners):
                return sentence("waypoint {index} is in {called}", index=index, called=called)
            if any(_cross(begin, end, *edge) for edge in edges):
                return sentence("the way to waypoint {index} leads through {called}", index=index, called=called)
    return ""


def is_inside(point: Point, corners: Sequence[Point]) -> bool:
    """True for a point inside a polygon."""
    x, y = point
    inside = False
    for (x1, y1), (x2, y2) in _edges(corners):
        if (y1 > y) != (y2 > y) and x < (x2 - x1) * (y - y1) / (y2 - y1) + x1:
            inside = not inside
    return inside


def _edges(corners: Sequence[Point]) -> Iterator[tuple[Point, Point]]:
    """The sides of a polygon."""
    return zip(corners, (*corners[1:], corners[0]), strict=True)


def _cross(a: Point, b: Point, c: Point, d: Point) -> bool:
    """True if the segments from a to b and from c to d have a point in common."""

    def side(p: Point, q: Point, r: Point) -> float:
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    def within(p: Point, q: Point, r: Point) -> bool:
        return min(p[0], q[0]) <= r[0] <= max(p[0], q[0]) and min(p[1], q[1]) <= r[1] <= max(p[1], q[1])

    sides = side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)
    if sides[0] * sides[1] < 0.0 and sides[2] * sides[3] < 0.0:
        return True
    ends = ((a, b, c), (a, b, d), (c, d, a), (c, d, b))
    return any(value == 0.0 and within(*each) for value, each in zip(sides, ends, strict=True))
