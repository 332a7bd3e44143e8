"""Reads files that a user names: regular files of limited size. Errors are one sentence that names the file."""

from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Final

from jauspy.errors import ConfigError

MAX_FILE: Final = 16 << 20
"""Bytes. A file may name further ones, such as /dev/zero, which never ends."""
MAX_DEPTH: Final = 64
"""Levels of tables and lists in a TOML file."""
_LONG_KEY: Final = re.compile(
    r"""(?<![\w-])(?:(?:[\w-]++|"(?:[^"\\\n]|\\.)*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+)""" + f"{{{MAX_DEPTH}}}", re.ASCII
)
"""A key of so many parts with dots between them, for which tomllib takes time that grows with their square."""
MAX_REASON: Final = 300
"""Characters of the reason in an error, which may quote the file."""

MANIFESTS: Final = ("package.xml", "model.config", "model.sdf")
"""Files that make a directory a package of ROS or a model of Gazebo."""

CONTENT_FOLDERS: Final = frozenset(
    ("description", "mesh", "meshes", "mjcf", "models", "robot", "robots", "sdf", "urdf", "worlds", "xacro")
)
"""Usual names of folders within a package."""


def read_file(path: Path, limit: int = MAX_FILE) -> bytes:
    """The content of a regular file of up to `limit` bytes; raises `ConfigError`."""
    try:
        if path.exists() and not path.is_file():
            raise ConfigError(f"{path}: is not a regular file")
        with path.open("rb") as file:
            data = file.read(limit + 1)
    except OSError as error:
        raise ConfigError(f"{path}: cannot be read: {error.strerror}") from error
    if len(data) > limit:
        most = f"{limit >> 20} MiB" if limit >= 1 << 20 else f"{limit} bytes"
        raise ConfigError(f"{path}: has more than {most}")
    return data


def check_folder_of(path: Path) -> None:
    """Raise `ConfigError` unless the folder exists in which a file is to be written."""
    folder = path.absolute().parent
    if not folder.is_dir():
        raise ConfigError(f"{path}: the directory {folder} does not exist")


def read_toml(path: Path) -> dict[str, Any]:
    """The keys of a TOML file; raises `ConfigError`."""
    return parse_toml(read_file(path), str(path))


def below(folder: Path, path: str) -> Path | None:
    """Return `folder / path` without `..`, or None if that leads out of the folder.

    Symbolic links are not resolved: packages may be installed as links.
    """
    target = Path(os.path.normpath(folder / path))
    return target if target.is_relative_to(os.path.normpath(folder)) else None


def own_folder(path: Path) -> Path:
    """The folder with what belongs to a file: its directory, or the one above `urdf`, `meshes` and the like."""
    folder = path.absolute().parent
    return folder.parent if folder.name in CONTENT_FOLDERS else folder


def confined(path: Path, folders: Iterable[Path]) -> Path:
    """`path`, if a file of a stranger may name it; else `ConfigError`: what is read may be reported to clients.

    Links are followed first. The file must be below one of the folders, or in a package or model, and no part of its
    path there may begin with a dot. The home directory, and those above it, count neither as folder nor as package.
    """
    try:
        real, home = path.resolve(), Path.home().resolve()
    except (OSError, RuntimeError) as error:  # no home, or links that lead to each other
        raise ConfigError(f"{path}: cannot be found: {error}") from error
    folders = [folder.resolve() for folder in folders]
    packages = (parent for parent in (real, *real.parents) if any((parent / name).is_file() for name in MANIFESTS))
    for folder in (*folders, *packages):
        if real.is_relative_to(folder) and not home.is_relative_to(folder):
            if any(part.startswith(".") for part in real.relative_to(folder).parts):
                continue
            return path
    places = ", ".join(dict.fromkeys(map(str, folders)))
    what = f"{path}: " if real == path.absolute() else f"{path}: leads to {real}, and "
    raise ConfigError(
        f"{what}is not read, because it is neither below {places} nor in a package or model, a directory with "
        f"{' or '.join(MANIFESTS)}"
    )


def parse_toml(data: bytes, name: str) -> dict[str, Any]:
    """The keys in these bytes; `name` begins the sentence of the `ConfigError`."""
    try:
        text = data.decode()
        if _LONG_KEY.search(text) is not None:
            raise ConfigError(f"{name}: is nested too deeply")
        found = tomllib.loads(text)
    except RecursionError:
        raise ConfigError(f"{name}: is nested too deeply") from None
    except ValueError as error:  # of tomllib, of a wrong encoding, of a number with thousands of digits
        raise ConfigError(f"{name}: is not TOML: {str(error)[:MAX_REASON]}") from error
    if _is_deep(found):
        raise ConfigError(f"{name}: is nested too deeply")
    return found


def _is_deep(value: Any) -> bool:
    """True for more than `MAX_DEPTH` levels of tables and lists."""
    level = [value]
    for _ in range(MAX_DEPTH):
        tables = [part.values() if isinstance(part, dict) else part for part in level if isinstance(part, dict | list)]
        level = [part for parts in tables for part in parts]
    return any(isinstance(part, dict | list) for part in level)
