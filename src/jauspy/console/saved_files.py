"""Files in which the console saves named poses and trajectories of each robot, as JSON."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Annotated, Final, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from jauspy.console.trajectory import MAX_FILE, Trajectory
from jauspy.errors import ConfigError
from jauspy.user_files import read_file, read_toml

MAX_NAME: Final = 40
MAX_SAVED: Final = 100
"""Poses of an arm, and trajectories of a robot."""
_NAME: Final = re.compile(r"[\w][\w .+-]*")
_Position = Annotated[float, Field(allow_inf_nan=False)]


class _Poses(BaseModel):
    model_config = ConfigDict(extra="forbid")
    poses: dict[str, dict[str, dict[str, _Position]]] = {}
    """By component, then by name: positions by joint."""


def state_directory() -> Path:
    """Directory of the files of the console: `$XDG_STATE_HOME/jauspy/console`, by default in `~/.local/state`."""
    root = os.environ.get("XDG_STATE_HOME", "")
    return Path(root if root.startswith("/") else Path.home() / ".local" / "state") / "jauspy" / "console"


def checked_name(name: str) -> str:
    """The name without surrounding spaces; raises `ConfigError` unless it can be a file's name."""
    name = name.strip()
    if not _NAME.fullmatch(name) or len(name) > MAX_NAME:
        raise ConfigError(
            f"a name is 1 to {MAX_NAME} letters, digits, spaces and . + - _, and begins with a letter or digit"
        )
    return name


RobotPoses: TypeAlias = dict[str, dict[str, dict[str, float]]]
"""By robot, then by name: positions by joint."""
_ROBOT_POSES: Final = TypeAdapter(dict[str, dict[str, dict[str, _Position]]])


def read_poses(path: Path) -> RobotPoses:
    """A file of named poses, a table `[robot.name]` for each; raises `ConfigError` that names the mistake."""
    try:
        poses = _ROBOT_POSES.validate_python(read_toml(path))
    except ValidationError as error:
        where = ".".join(map(str, error.errors()[0]["loc"]))
        raise ConfigError(
            f"{path}: {where}: expected a table [ROBOT.POSE] with a position for each joint, in radians or metres"
        ) from error
    for name in (name for named in poses.values() for name in named):
        try:
            checked_name(name)
        except ConfigError as error:
            raise ConfigError(f"{path}: {name!r}: {error}") from error
    return poses


class SavedFiles:
    """The poses and trajectories of one robot."""

    def __init__(self, subsystem: int, robot: str, root: Path | None = None) -> None:
        label = re.sub(r"[^\w-]+", "_", robot)[:MAX_NAME]
        self._folder = (root or state_directory()) / (f"{subsystem}-{label}" if label else str(subsystem))

    def poses(self, component: str) -> dict[str, dict[str, float]]:
        """The poses of an arm by name; raises `ConfigError` for a file that cannot be read."""
        return self._poses().poses.get(component, {})

    def save_pose(self, component: str, name: str, positions: dict[str, float]) -> None:
        """Save a pose, positions in radians or metres; replaces the pose of this name."""
        poses = self._poses()
        own = poses.poses.setdefault(component, {})
        own[checked_name(name)] = {joint: round(value, 4) + 0.0 for joint, value in positions.items()}
        if len(own) > MAX_SAVED:
            raise ConfigError(f"an arm has at most {MAX_SAVED} poses; delete one first")
        self._write("poses.json", poses.model_dump_json(indent=2))

    def delete_pose(self, component: str, name: str) -> None:
        """Delete a pose; unknown names are ignored."""
        poses = self._poses()
        poses.poses.get(component, {}).pop(name, None)
        self._write("poses.json", poses.model_dump_json(indent=2))

    def trajectories(self) -> list[str]:
        """The names of the trajectories."""
        return sorted(path.stem for path in (self._folder / "trajectories").glob("*.json"))[:MAX_SAVED]

    def save_trajectory(self, name: str, text: str) -> None:
        """Save a trajectory; replaces the one of this name."""
        name, known = checked_name(name), self.trajectories()
        if name not in known and len(known) >= MAX_SAVED:
            raise ConfigError(f"a robot has at most {MAX_SAVED} trajectories; delete one first")
        self._write(f"trajectories/{name}.json", text)

    def trajectory(self, name: str) -> Trajectory:
        """Load a trajectory; raises `ConfigError`."""
        path = self._folder / "trajectories" / f"{checked_name(name)}.json"
        return Trajectory.from_json(read_file(path, MAX_FILE), str(path))

    def delete_trajectory(self, name: str) -> None:
        """Delete a trajectory; unknown names are ignored."""
        (self._folder / "trajectories" / f"{checked_name(name)}.json").unlink(missing_ok=True)

    def _poses(self) -> _Poses:
        path = self._folder / "poses.json"
        if not path.exists():
            return _Poses()
        try:
            return _Poses.model_validate_json(read_file(path, MAX_FILE))
        except ValidationError as error:
            first = error.errors()[0]
            where = ".".join(map(str, first["loc"])) or "the whole"
            raise ConfigError(f"{path}: {where}: {first['msg']}; correct or delete the file") from None

    def _write(self, name: str, text: str) -> None:
        """Replace the file atomically."""
        path = self._folder / name
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            new = path.with_suffix(".new")
            new.write_text(text)
            new.replace(path)
        except OSError as error:
            raise ConfigError(f"{path}: cannot be written: {error.strerror}") from error
