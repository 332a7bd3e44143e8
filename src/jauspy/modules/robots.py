"""Finds and reads the descriptions of robots: those that come with jauspy, and a user's own TOML files."""

from __future__ import annotations

import tomllib
from importlib.resources import as_file, files
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Final

from pydantic import ValidationError

from jauspy.errors import ConfigError
from jauspy.modules.config import RobotConfig
from jauspy.node.explain import explain

SUFFIX: Final = ".toml"
_FOLDER: Final = files("jauspy") / "robots"


def known() -> list[str]:
    """Names of the robots that come with jauspy, sorted."""
    return sorted(each.name.removesuffix(SUFFIX) for each in _FOLDER.iterdir() if each.name.endswith(SUFFIX))


def load(name_or_path: str | Path) -> RobotConfig:
    """The robot of that name, or of that TOML file; `ConfigError` names the key that is wrong and what it may be."""
    source = _find(name_or_path)
    try:
        data = tomllib.loads(source.read_text(encoding="utf-8"))
    except OSError as error:
        raise ConfigError(f"{source}: cannot be read: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ConfigError(f"{source}: is not TOML: {error}") from error
    try:
        config = RobotConfig.model_validate(data)
    except ValidationError as error:
        problems = "\n".join(f"  {explain(each, RobotConfig)}" for each in error.errors(include_url=False))
        raise ConfigError(f"{source}: is not a description of a robot:\n{problems}") from error
    with as_file(source) as file:
        return config.model_copy(update={"urdf": str(file.parent / config.urdf)})


def _find(name_or_path: str | Path) -> Traversable:
    text = str(name_or_path)
    if isinstance(name_or_path, Path) or text.endswith(SUFFIX) or "/" in text:
        return Path(name_or_path)
    if text not in known():
        raise ConfigError(f"no robot {text!r}; known are: {', '.join(known())}; or give the path of a .toml file")
    return _FOLDER / f"{text}{SUFFIX}"
