"""Poses of SDF: resolves poses of links, joints and frames to the frame of their model."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Final, TypeVar

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.geometry.urdf import Element
from jauspy.geometry.vectors import rotation_from_quaternion

MODEL: Final = "__model__"
WORLD: Final = "world"

T = TypeVar("T")


def words(element: Element | None) -> list[str]:
    """The words in an element, which may be missing."""
    return [] if element is None or element.text is None else element.text.split()


def line_of(element: Element) -> int:
    """The line of an element in its file."""
    return int(getattr(element, "sourceline", 0) or 0)


def is_true(element: Element | None) -> bool | None:
    """None where it is left out."""
    return None if element is None else words(element)[:1] in (["1"], ["true"], ["True"])


def located(near: Path, read: Callable[[], T]) -> T:
    """Result of `read`; a `ConfigError` that names a line gets the file."""
    try:
        return read()
    except ConfigError as error:
        text = str(error)
        if not text.startswith("line "):
            raise
        line, _, rest = text.removeprefix("line ").partition(": ")
        raise ConfigError(f"{near}:{line}: {rest}") from error


def floats(element: Element, count: int) -> tuple[float, ...]:
    """The numbers in an element; raises `ConfigError` with its line."""
    try:
        values = tuple(map(float, words(element)))
    except ValueError:
        values = ()
    if len(values) != count or not all(map(math.isfinite, values)):
        text = " ".join(words(element))
        raise ConfigError(f"line {line_of(element)}: <{element.tag}>{text}</{element.tag}>: is not {count} numbers")
    return values


def raw_pose(owner: Element) -> tuple[Transform, str]:
    """The `<pose>` in an element, and the frame that it is relative to, or an empty text. Raises `ConfigError`."""
    element = owner.find("pose")
    if element is None or not words(element):
        return Transform(), "" if element is None else (element.get("relative_to") or "")
    relative_to = element.get("relative_to") or element.get("frame") or ""
    if element.get("rotation_format") == "quat_xyzw":
        x, y, z, a, b, c, d = floats(element, 7)
        return Transform(rotation_from_quaternion(d, a, b, c), (x, y, z)), relative_to
    x, y, z, *angles = floats(element, 6)
    turn = math.radians if element.get("degrees") in ("1", "true") else float
    return Transform.from_pose(Pose(x, y, z, *map(turn, angles))), relative_to


class Scope:
    """The frames of one model or world, each with its pose in the model's frame, found when it is asked for."""

    def __init__(self, root: str = MODEL) -> None:
        self._frames: dict[str, Callable[[], Transform]] = {root: Transform}
        self._known: dict[str, Transform] = {}
        self._open: set[str] = set()
        self._root = root

    def add(self, name: str, pose: Transform, relative_to: str, line: int) -> None:
        """Add a frame whose pose is relative to another one, which may be added later."""

        def find() -> Transform:
            return self.pose(relative_to or self._root, line) @ pose

        self._frames.setdefault(name, find)

    def pose(self, name: str, line: int = 0) -> Transform:
        """The pose of a frame; raises `ConfigError` for an unknown one, and for one that is relative to itself."""
        if name in self._known:
            return self._known[name]
        if name == WORLD and name not in self._frames:
            return Transform()
        if name not in self._frames:
            raise ConfigError(f"line {line}: there is no frame {name!r}; there are: {', '.join(sorted(self._frames))}")
        if name in self._open:
            raise ConfigError(f"line {line}: the pose of {name!r} is relative to itself")
        self._open.add(name)
        found = self._known[name] = self._frames[name]()
        self._open.discard(name)
        return found
