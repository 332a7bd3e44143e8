"""Reads files that a user names: regular files of limited size. Errors are one sentence that names the file."""

from __future__ import annotations

import os
import tomllib
from pathlib import Path
from typing import Any, Final

from jauspy.errors import ConfigError

MAX_FILE: Final = 16 << 20
"""Bytes. A file may name further ones, such as /dev/zero, which never ends."""


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
        raise ConfigError(f"{path}: has more than {limit >> 20} MiB")
    return data


def read_toml(path: Path) -> dict[str, Any]:
    """The keys of a TOML file; raises `ConfigError`."""
    return parse_toml(read_file(path), str(path))


def below(folder: Path, path: str) -> Path | None:
    """Return `folder / path` without `..`, or None if that leads out of the folder.

    Symbolic links are not resolved: packages may be installed as links.
    """
    target = Path(os.path.normpath(folder / path))
    return target if target.is_relative_to(os.path.normpath(folder)) else None


def parse_toml(data: bytes, name: str) -> dict[str, Any]:
    """The keys in these bytes; `name` begins the sentence of the `ConfigError`."""
    try:
        return tomllib.loads(data.decode())
    except RecursionError:
        raise ConfigError(f"{name}: is nested too deeply") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ConfigError(f"{name}: is not TOML: {error}") from error
