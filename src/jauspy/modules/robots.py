"""Finds and reads the descriptions of robots: those that come with jauspy, and a user's own TOML files."""

from __future__ import annotations

import tomllib
from importlib.resources import as_file, files
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, Final

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from jauspy.config_errors import explain
from jauspy.errors import ConfigError
from jauspy.modules.config import RobotConfig

SUFFIX: Final = ".toml"
_FOLDER: Final = files("jauspy") / "robots"

MOST_EXTENSIONS: Final = 8
"""Files that may extend each other in a row."""


def known() -> list[str]:
    """Names of the robots that come with jauspy, sorted."""
    return sorted(each.name.removesuffix(SUFFIX) for each in _FOLDER.iterdir() if each.name.endswith(SUFFIX))


def load(name_or_path: str | Path) -> RobotConfig:
    """The robot of that name, or of that TOML file; `ConfigError` names the key that is wrong and what it may be.

    A file may say `extends = "inc1"` (a name or a path): it has all keys of that file that it does not set itself.
    """
    source = _find(name_or_path, Path())
    data = _read(source, MOST_EXTENSIONS)
    try:
        return RobotConfig.model_validate(data)
    except ValidationError as error:
        problems = "\n".join(f"  {explain(each, RobotConfig)}" for each in _causes(error.errors(include_url=False)))
        raise ConfigError(f"{source}: is not a description of a robot:\n{problems}") from error


def _causes(problems: list[ErrorDetails]) -> list[ErrorDetails]:
    """Without what follows from another one: a list is too short, too, when what is in it is wrong."""
    places = [problem["loc"] for problem in problems]
    return [p for p in problems if not any(q != p["loc"] and q[: len(p["loc"])] == p["loc"] for q in places)]


def _read(source: Traversable, extensions: int) -> dict[str, Any]:
    """The keys of a file and of those that it extends; `urdf` starts at the file that sets it."""
    try:
        data = tomllib.loads(source.read_text(encoding="utf-8"))
    except OSError as error:
        raise ConfigError(f"{source}: cannot be read: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ConfigError(f"{source}: is not TOML: {error}") from error
    with as_file(source) as file:
        folder = file.parent
    if isinstance(data.get("urdf"), str):
        data["urdf"] = str(folder / data["urdf"])
    other = data.pop("extends", None)
    if other is None:
        return data
    if not isinstance(other, str) or not extensions:
        raise ConfigError(f"{source}: extends = {other!r}: it must name another robot, and not lead back to this one")
    return _read(_find(other, folder), extensions - 1) | data


def _find(name_or_path: str | Path, folder: Path) -> Traversable:
    text = str(name_or_path)
    if isinstance(name_or_path, Path) or text.endswith(SUFFIX) or "/" in text:
        return folder / name_or_path
    if text not in known():
        raise ConfigError(f"no robot {text!r}; known are: {', '.join(known())}; or give the path of a .toml file")
    return _FOLDER / f"{text}{SUFFIX}"
