"""Files in which the console saves named poses, trajectories and missions of each robot, as JSON, with their authors.

Only users who may operate robots save and delete. What somebody else has saved is replaced or deleted only if the user
has seen who that was.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import islice
from pathlib import Path
from typing import Annotated, Final, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from jauspy.console.geographic_frame import GeographicFrame
from jauspy.console.languages import sentence
from jauspy.console.mission import Mission
from jauspy.console.trajectory import MAX_FILE, UNKNOWN, Author, Trajectory, place
from jauspy.console.users import User
from jauspy.errors import ConfigError
from jauspy.printable import printable
from jauspy.user_files import parse_toml, read_file

MAX_NAME: Final = 40
MAX_SAVED: Final = 100
"""Poses of an arm, and trajectories and missions of a robot."""
MAX_LISTED: Final = 10_000
"""Files of a folder that are looked at."""
TRAJECTORIES, MISSIONS = "trajectories", "missions"
"""Folders of files."""
_ONE: Final = {TRAJECTORIES: sentence("trajectory"), MISSIONS: sentence("mission")}
_FULL: Final = {
    TRAJECTORIES: sentence("a robot has at most {most} trajectories; delete one first", most=MAX_SAVED),
    MISSIONS: sentence("a robot has at most {most} missions; delete one first", most=MAX_SAVED),
}
_NAME: Final = re.compile(r"[\w][\w .+-]*")
_Position = Annotated[float, Field(allow_inf_nan=False)]


class _Poses(BaseModel):
    model_config = ConfigDict(extra="forbid")
    poses: dict[str, dict[str, dict[str, _Position]]] = {}
    """Trajectories by component, then by name: positions by joint."""
    authors: dict[str, dict[str, Author]] = {}
    """Authors of poses, by component and name; files of earlier versions have none."""


@dataclass(frozen=True, slots=True)
class Pose:
    """A named pose: positions by joint, in radians or metres."""

    positions: dict[str, float]
    author: Author = UNKNOWN


class SavedByOther(ConfigError):
    """Somebody else has saved what is to be replaced or deleted; pass `author` as `seen` when the user agrees."""

    def __init__(self, name: str, author: Author) -> None:
        super().__init__(sentence("{name} was {author}", name=name, author=author))
        self.author = author


def state_directory() -> Path:
    """Directory of the files of the console: `$XDG_STATE_HOME/jauspy/console`, by default in `~/.local/state`."""
    root = os.environ.get("XDG_STATE_HOME", "")
    return Path(root if root.startswith("/") else Path.home() / ".local" / "state") / "jauspy" / "console"


def checked_name(name: str) -> str:
    """The name without surrounding spaces; raises `ConfigError` unless it can be a file's name."""
    name = name.strip()
    if not _NAME.fullmatch(name) or len(name) > MAX_NAME:
        raise ConfigError(
            sentence(
                "a name is 1 to {most} letters, digits, spaces and . + - _, and begins with a letter or digit",
                most=MAX_NAME,
            )
        )
    return name


RobotPoses: TypeAlias = dict[str, dict[str, dict[str, float]]]
"""Poses by robot, then by name: positions by joint."""
_ROBOT_POSES: Final = TypeAdapter(dict[str, dict[str, dict[str, _Position]]])


def read_poses(path: Path) -> RobotPoses:
    """A file of named poses, a table `[robot.name]` for each; raises `ConfigError` that names the mistake."""
    try:
        poses = _ROBOT_POSES.validate_python(parse_toml(read_file(path, MAX_FILE), str(path)))
    except ValidationError as error:
        where = place(error.errors()[0]["loc"])
        raise ConfigError(
            f"{path}: {where}: expected a table [ROBOT.POSE] with a position for each joint, in radians or metres"
        ) from error
    for name in (name for named in poses.values() for name in named):
        try:
            checked_name(name)
        except ConfigError as error:
            raise ConfigError(f"{path}: {name[:MAX_NAME]!r}: {error}") from error
    return poses


class SavedFiles:
    """The poses and trajectories of one robot, for a user; None is nobody, who may read only.

    `on_change` is called with a sentence about each change.
    """

    def __init__(
        self,
        subsystem: int,
        robot: str,
        user: User | None,
        on_change: Callable[[str], None],
        root: Path | None = None,
    ) -> None:
        label = re.sub(r"[^\w-]+", "_", robot)[:MAX_NAME]
        self._folder = (root or state_directory()) / (f"{subsystem}-{label}" if label else str(subsystem))
        self._subsystem = subsystem
        self._user = user
        self._on_change = on_change

    def poses(self, component: str) -> dict[str, Pose]:
        """The poses of an arm by name; raises `ConfigError` for a file that cannot be read."""
        saved = self._poses()
        authors = saved.authors.get(component, {})
        return {
            name: Pose(positions, authors.get(name, UNKNOWN))
            for name, positions in saved.poses.get(component, {}).items()
            if _NAME.fullmatch(name) and len(name) <= MAX_NAME
        }

    def save_pose(self, component: str, name: str, positions: dict[str, float], *, seen: Author | None = None) -> None:
        """Save a pose, positions in radians or metres; replaces the pose of this name.

        Raises `SavedByOther` if that is of somebody else than `seen`, and `ConfigError` if it cannot be saved.
        """
        name, author, saved = checked_name(name), self._author(), self._poses()
        own_poses, authors = saved.poses.setdefault(component, {}), saved.authors.setdefault(component, {})
        before = authors.get(name, UNKNOWN) if name in own_poses else None
        self._check(name, before, seen)
        own_poses[name] = {joint: round(value, 4) + 0.0 for joint, value in positions.items()}
        if len(own_poses) > MAX_SAVED:
            raise ConfigError(sentence("an arm has at most {most} poses; delete one first", most=MAX_SAVED))
        authors[name] = author
        self._write_poses(saved)
        self._changed(sentence("saved the pose {name} of {component}", name=name, component=component), before)

    def delete_pose(self, component: str, name: str, *, seen: Author | None = None) -> None:
        """Delete a pose; unknown names are ignored. Raises as `save_pose`."""
        self._author()
        saved = self._poses()
        if name not in saved.poses.get(component, {}):
            return
        before = saved.authors.get(component, {}).pop(name, UNKNOWN)
        self._check(name, before, seen)
        del saved.poses[component][name]
        self._write_poses(saved)
        self._changed(sentence("deleted the pose {name} of {component}", name=name, component=component), before)

    def trajectories(self) -> list[str]:
        """The names of the trajectories."""
        return self._names(TRAJECTORIES)

    def save_trajectory(self, name: str, trajectory: Trajectory, robot: str, *, seen: Author | None = None) -> None:
        """Save a trajectory; replaces the one of this name. Raises as `save_pose`."""
        self._save(TRAJECTORIES, name, lambda author: trajectory.to_json(robot, author), seen)

    def trajectory(self, name: str) -> Trajectory:
        """Load a trajectory; raises `ConfigError`."""
        path = self._path(TRAJECTORIES, name)
        return Trajectory.from_json(read_file(path, MAX_FILE), str(path))

    def delete_trajectory(self, name: str, *, seen: Author | None = None) -> None:
        """Delete a trajectory; unknown names are ignored. Raises as `save_pose`."""
        self._delete(TRAJECTORIES, name, seen)

    def missions(self) -> list[str]:
        """The names of the missions."""
        return self._names(MISSIONS)

    def save_mission(self, name: str, mission: Mission, robot: str, *, seen: Author | None = None) -> None:
        """Save a mission; replaces the one of this name. Raises as `save_pose`."""
        self._save(MISSIONS, name, lambda author: mission.to_json(robot, author), seen)

    def mission(self, name: str, frame: GeographicFrame | None = None) -> Mission:
        """Load a mission; raises `ConfigError`. Those in degrees need the robot's frame on the globe."""
        path = self._path(MISSIONS, name)
        return Mission.from_json(read_file(path, MAX_FILE), str(path), frame)

    def delete_mission(self, name: str, *, seen: Author | None = None) -> None:
        """Delete a mission; unknown names are ignored. Raises as `save_pose`."""
        self._delete(MISSIONS, name, seen)

    def _names(self, kind: str) -> list[str]:
        try:
            with os.scandir(self._folder / kind) as entries:
                names = [entry.name for entry in islice(entries, MAX_LISTED)]
        except OSError:
            return []
        stems = (name.removesuffix(".json") for name in names if name.endswith(".json"))
        return sorted(stem for stem in stems if _NAME.fullmatch(stem) and len(stem) <= MAX_NAME)[:MAX_SAVED]

    def _save(self, kind: str, name: str, content: Callable[[Author], str], seen: Author | None) -> None:
        name, author, known = checked_name(name), self._author(), self._names(kind)
        before = self._author_of(kind, name)
        self._check(name, before, seen)
        if name not in known and len(known) >= MAX_SAVED:
            raise ConfigError(_FULL[kind])
        self._write(f"{kind}/{name}.json", content(author))
        self._changed(sentence("saved the {kind} {name}", kind=_ONE[kind], name=name), before)

    def _delete(self, kind: str, name: str, seen: Author | None) -> None:
        self._author()
        before = self._author_of(kind, name)
        if before is None:
            return
        self._check(name, before, seen)
        try:
            self._path(kind, name).unlink(missing_ok=True)
        except OSError as error:
            raise ConfigError(
                sentence("{path}: cannot be deleted: {strerror}", path=self._path(kind, name), strerror=error.strerror)
            ) from error
        self._changed(sentence("deleted the {kind} {name}", kind=_ONE[kind], name=name), before)

    def _path(self, kind: str, name: str) -> Path:
        return self._folder / kind / f"{checked_name(name)}.json"

    def _author(self) -> Author:
        """The user with the present time; raises `ConfigError` unless the user may operate."""
        if self._user is None or not self._user.may_operate:
            who = sentence("nobody") if self._user is None else f"{self._user.name} ({self._user.role})"
            raise ConfigError(
                sentence(
                    "{who} may not save or delete poses, trajectories and missions: this takes an operator", who=who
                )
            )
        return Author(by=self._user.name, at=f"{datetime.now(UTC):%Y-%m-%d %H:%M:%S} UTC")

    def _author_of(self, kind: str, name: str) -> Author | None:
        """The author of a file; None if there is none of this name."""
        if not self._path(kind, name).exists():
            return None
        try:
            return self.trajectory(name).author if kind == TRAJECTORIES else self.mission(name).author
        except ConfigError:  # it is damaged, and may be replaced
            return UNKNOWN

    def _check(self, name: str, before: Author | None, seen: Author | None) -> None:
        """Raise `SavedByOther` for what the user neither has saved nor has seen the author of."""
        assert self._user is not None
        if before is not None and before.by != self._user.name and before != seen:
            raise SavedByOther(name, before)

    def _changed(self, what: str, before: Author | None) -> None:
        assert self._user is not None
        if before is None or before.by == self._user.name:
            self._on_change(sentence("robot {robot}: {what}", robot=self._subsystem, what=what))
            return
        text = sentence("robot {robot}: {what}, which was {before}", robot=self._subsystem, what=what, before=before)
        self._on_change(text)

    def _poses(self) -> _Poses:
        path = self._folder / "poses.json"
        if not path.exists():
            return _Poses()
        try:
            return _Poses.model_validate_json(read_file(path, MAX_FILE))
        except ValidationError as error:
            first = error.errors()[0]
            raise ConfigError(
                sentence(
                    "{path}: {place}: {problem}; correct or delete the file",
                    path=path,
                    place=place(first["loc"]),
                    problem=first["msg"],
                )
            ) from None

    def _write_poses(self, poses: _Poses) -> None:
        try:
            text = poses.model_dump_json(indent=2)
        except ValueError as error:
            raise ConfigError(
                sentence("the poses cannot be saved: {error}", error=printable(str(error))[:200])
            ) from error
        self._write("poses.json", text)

    def _write(self, name: str, text: str) -> None:
        """Replace the file atomically."""
        path = self._folder / name
        new = path.with_suffix(".new")
        flags = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_NOFOLLOW | os.O_NONBLOCK
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            with os.fdopen(os.open(new, flags, 0o644), "w", encoding="utf-8", errors="backslashreplace") as stream:
                stream.write(text)
            new.replace(path)
        except OSError as error:
            raise ConfigError(
                sentence("{path}: cannot be written: {strerror}", path=path, strerror=error.strerror)
            ) from error
