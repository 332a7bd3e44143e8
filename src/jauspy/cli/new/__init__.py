"""Verbs of `jauspy new`, and how they write files: existing files are never overwritten."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from jauspy.cli import console
from jauspy.errors import ConfigError


def write_new(files: Mapping[Path, str | bytes]) -> None:
    """Write all files, or none if one exists; raises `ConfigError` that names it."""
    for path in files:
        if path.exists() or path.is_symlink():
            raise ConfigError(f"{path} exists; remove it, or choose another name")
    try:
        for path, content in files.items():
            path.parent.mkdir(parents=True, exist_ok=True)
            with path.open("xb") as file:
                file.write(content.encode() if isinstance(content, str) else content)
            console.print_lines(str(path))
    except OSError as error:
        raise ConfigError(f"{error.filename} cannot be written: {error.strerror}") from None


def write_new_folder(folder: Path, files: Mapping[str, str | bytes]) -> None:
    """Write a folder with these files; raises `ConfigError` if it is not empty."""
    if folder.is_symlink() or (folder.exists() and (not folder.is_dir() or any(folder.iterdir()))):
        raise ConfigError(f"{folder} exists; remove it, or choose another name")
    write_new({folder / name: content for name, content in files.items()})
