"""Tasks in CoBRA's JSON format: poses to reach within tolerances, among boxes.

Format: https://cobra.cps.cit.tum.de, as `timor-python` 1.1.1 reads and writes it. Of it, goals of the types `at` and
`reach` are read, the projections `x`, `y`, `z`, `r_sph` and `Theta_R`, and obstacles that are boxes; the rest is
refused. Metres and radians, in the world's frame. What no projection restricts is free.

For two arms on one base, each goal has the key `arm`, which CoBRA does not have: the connector of the base that carries
the arm which is to reach it.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Final

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import cross, dot
from jauspy.user_files import read_file

MAX_SIZE: Final = 1_000_000
"""Bytes of a task's file."""
MAX_ENTRIES: Final = 100
"""Goals, and obstacles."""
MAX_NAME: Final = 80
"""Characters of a name that are kept."""
MAX_ARMS: Final = 2
PROJECTIONS: Final = ("x", "y", "z", "r_sph", "Theta_R")
_ORTHOGONAL: Final = 1e-4
"""Permitted error of a rotation's rows: files have four digits at least."""


@dataclass(frozen=True, slots=True)
class Goal:
    """A pose of the tip to reach; `tolerances` are the limits of each projection of the error, in the goal's frame."""

    name: str
    pose: Transform
    tolerances: Mapping[str, tuple[float, float]]
    arm: str = ""
    """The connector of the base whose arm is to reach it; empty in a task for one arm."""

    def met(self, tip: Transform) -> bool:
        """True if a tip's pose is within all tolerances."""
        values = projections(self.pose.inverse() @ tip)
        return all(low <= values[name] <= high for name, (low, high) in self.tolerances.items())


@dataclass(frozen=True, slots=True)
class Obstacle:
    """A box: the pose of its middle, and its size along x, y, z."""

    name: str
    pose: Transform
    size: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class DesignTask:
    """Goals to reach in their order."""

    name: str
    goals: tuple[Goal, ...]
    obstacles: tuple[Obstacle, ...] = ()

    @property
    def arms(self) -> tuple[str, ...]:
        """The connectors of the base that carry an arm, in the order of the goals; empty for one arm."""
        return tuple(dict.fromkeys(goal.arm for goal in self.goals if goal.arm))

    def of(self, arm: str) -> DesignTask:
        """The task of one of the arms."""
        return replace(self, name=f"{self.name}/{arm}", goals=tuple(goal for goal in self.goals if goal.arm == arm))


def projections(error: Transform) -> dict[str, float]:
    """CoBRA's projections of an error: its coordinates, its length, and the angle of its rotation."""
    x, y, z = error.position
    trace = sum(error.rotation[axis][axis] for axis in range(3))
    angle = math.acos(min(1.0, max(-1.0, (trace - 1.0) / 2.0)))
    return {"x": x, "y": y, "z": z, "r_sph": math.hypot(x, y, z), "Theta_R": angle}


def load_task(path: Path) -> DesignTask:
    """Read a task. Raises `ConfigError` with the key of what is not permitted."""
    data = read_file(path, MAX_SIZE)
    try:
        return parse_task(json.loads(data))
    except (ValueError, RecursionError) as error:
        raise ConfigError(f"{path}: cannot be read: {error}") from error
    except ConfigError as error:
        raise ConfigError(f"{path}: {error}") from error


def parse_task(document: object) -> DesignTask:
    """A task from its JSON document. Raises `ConfigError`."""
    header = _table(_table(document, "task").get("header", {}), "header")
    goals = _entries(document, "goals")
    if not goals:
        raise ConfigError("goals: there must be one at least")
    read = tuple(_goal(goal, f"goals[{index}]") for index, goal in enumerate(goals))
    if len({goal.name for goal in read}) != len(read):
        raise ConfigError("goals: two have the same ID")
    arms = {goal.arm for goal in read}
    if arms != {""} and ("" in arms or len(arms) != MAX_ARMS):
        raise ConfigError(f"goals: either none has an arm, or each has one of {MAX_ARMS}")
    boxes: list[Obstacle] = []
    for index, obstacle in enumerate(_entries(document, "obstacles")):
        boxes += _obstacle(obstacle, f"obstacles[{index}]")
    return DesignTask(str(header.get("ID", "task"))[:MAX_NAME], read, tuple(boxes))


def _table(value: object, key: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise ConfigError(f"{key}: must be an object")
    return value


def _entries(document: object, key: str) -> list[Any]:
    value = _table(document, "task").get(key, [])
    if not isinstance(value, list) or len(value) > MAX_ENTRIES:
        raise ConfigError(f"{key}: must be a list with {MAX_ENTRIES} entries at most")
    return value


def _number(value: object, key: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) < 1e6:
        raise ConfigError(f"{key}: must be a number within a million")
    return float(value)


def _rows(value: object, key: str, count: int, width: int) -> list[list[float]]:
    rows = value if isinstance(value, list) else []
    if len(rows) != count or not all(isinstance(row, list) and len(row) == width for row in rows):
        raise ConfigError(f"{key}: must be a list of {count} lists of {width} numbers")
    return [[_number(entry, key) for entry in row] for row in rows]


def _transform(value: object, key: str) -> Transform:
    rows = _rows(value, key, 4, 4)
    a, b, c = ((row[0], row[1], row[2]) for row in rows[:3])
    skew = max(
        abs(dot(a, a) - 1), abs(dot(b, b) - 1), abs(dot(c, c) - 1), abs(dot(a, b)), abs(dot(b, c)), abs(dot(a, c))
    )
    if skew > _ORTHOGONAL or dot(a, cross(b, c)) < 0.0 or rows[3] != [0.0, 0.0, 0.0, 1.0]:
        raise ConfigError(f"{key}: is not a homogeneous transform")
    return Transform((a, b, c), (rows[0][3], rows[1][3], rows[2][3]))


def _goal(value: object, key: str) -> Goal:
    table = _table(value, key)
    if table.get("type") not in ("at", "reach"):
        raise ConfigError(f"{key}.type: must be at or reach")
    place = f"{key}.goalPose"
    pose = _table(table.get("goalPose"), place)
    names = pose.get("toleranceProjection")
    if not isinstance(names, list) or not names or not all(name in PROJECTIONS for name in names):
        raise ConfigError(f"{place}.toleranceProjection: must be a list of: {', '.join(PROJECTIONS)}")
    limits = _rows(pose.get("tolerance"), f"{place}.tolerance", len(names), 2)
    if any(low > high for low, high in limits):
        raise ConfigError(f"{place}.tolerance: a lower limit is above the upper one")
    tolerances = {name: (low, high) for name, (low, high) in zip(names, limits, strict=True)}
    arm = table.get("arm", "")
    if not isinstance(arm, str) or len(arm) > MAX_NAME:
        raise ConfigError(f"{key}.arm: must be the name of a connector, as in left")
    nominal = _transform(pose.get("nominal"), f"{place}.nominal")
    return Goal(str(table.get("ID", key))[:MAX_NAME], nominal, tolerances, arm)


def _obstacle(value: object, key: str) -> list[Obstacle]:
    table = _table(value, key)
    given = table.get("collision")
    shapes = given if isinstance(given, list) else [given]
    if len(shapes) > MAX_ENTRIES:
        raise ConfigError(f"{key}.collision: must have {MAX_ENTRIES} shapes at most")
    found = []
    for shape in shapes:
        solid = _table(shape, f"{key}.collision")
        if solid.get("type") != "box":
            raise ConfigError(f"{key}.collision.type: must be box")
        parameters = _table(solid.get("parameters"), f"{key}.collision.parameters")
        x, y, z = (_number(parameters.get(axis), f"{key}.collision.parameters.{axis}") for axis in "xyz")
        if min(x, y, z) <= 0.0:
            raise ConfigError(f"{key}.collision.parameters: must be above zero")
        pose = _transform(solid.get("pose"), f"{key}.collision.pose")
        found.append(Obstacle(str(table.get("ID", key))[:MAX_NAME], pose, (x, y, z)))
    return found
