"""Finds and reads the descriptions of robots: those that come with jauspy, and a user's own TOML files."""

from __future__ import annotations

import tomllib
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Final

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from jauspy.errors import ConfigError
from jauspy.modules.config import AccessControlConfig, ModuleConfig, OriginConfig, RobotConfig

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
        return RobotConfig.model_validate(data)
    except ValidationError as error:
        problems = "\n".join(f"  {_explain(each)}" for each in error.errors(include_url=False))
        raise ConfigError(f"{source}: is not a description of a robot:\n{problems}") from error


def _find(name_or_path: str | Path) -> Traversable:
    text = str(name_or_path)
    if isinstance(name_or_path, Path) or text.endswith(SUFFIX) or "/" in text:
        return Path(name_or_path)
    if text not in known():
        raise ConfigError(f"no robot {text!r}; known are: {', '.join(known())}; or give the path of a .toml file")
    return _FOLDER / f"{text}{SUFFIX}"


def _explain(problem: ErrorDetails) -> str:
    """One problem as `modules[0].component: 300: ... less than or equal to 254`."""
    where = problem["loc"]
    key = "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in where).lstrip(".") or "the file"
    match problem["type"]:
        case "missing":
            return f"{key}: is missing"
        case "extra_forbidden":
            return f"{key}: there is no such key; known here are: {', '.join(_keys(where[:-1]))}"
        case "value_error":
            return str(problem["ctx"]["error"])
        case _:
            return f"{key}: {problem['input']!r}: {problem['msg'][0].lower()}{problem['msg'][1:]}"


def _keys(where: tuple[int | str, ...]) -> list[str]:
    """The keys that a table may have."""
    tables: dict[tuple[str, ...], type[BaseModel]]
    tables = {
        (): RobotConfig,
        ("origin",): OriginConfig,
        ("modules",): ModuleConfig,
        ("modules", "access_control"): AccessControlConfig,
    }
    return sorted(tables[tuple(str(part) for part in where if not isinstance(part, int))].model_fields)
