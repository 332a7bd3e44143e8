"""Opens the files of an audit log: new ones, or those of an audit log, and nothing else that a path may lead to."""

from __future__ import annotations

import fcntl
import json
import os
import stat
from pathlib import Path
from typing import Any, Final

from jauspy.errors import ConfigError

MAX_LINE: Final = 64 * 1024
"""Bytes."""
_BEGIN: Final = b'{"n": 1, '
"""Start of the first line, which may be incomplete after a power failure."""


def parsed(line: bytes) -> dict[str, Any] | None:
    """The content of a line of an audit log; None if it is none."""
    try:
        entry = json.loads(line)
    except (ValueError, RecursionError):
        return None
    is_line = isinstance(entry, dict) and isinstance(entry.get("n"), int) and isinstance(entry.get("previous"), str)
    return entry if is_line else None


def head_file(path: Path) -> Path:
    """The path of the file with the head of a log."""
    return path.with_name(f"{path.name}.head")


def own_path(folder: Path, given: str, key: str, hint: str) -> Path:
    """The path for writing that a robot's file in `folder` names as `key`.

    Raises `ConfigError`, which ends with `hint`, unless it is below the folder.

    Links are refused, as are names that begin with a dot. A file is checked again when it is opened.
    """
    if "\0" in given:
        raise ConfigError(f"{key} = {given!r}: no file has such a name; {hint}")
    real = Path(os.path.realpath(folder))
    path = Path(os.path.normpath(real / given))
    if not path.is_relative_to(real):
        raise ConfigError(f"{key} = {given!r}: leads out of {folder}, the folder of the robot's file; {hint}")
    if Path(os.path.realpath(path)) != path:
        raise ConfigError(f"{key} = {given!r}: is or goes through a link; {hint}")
    if any(part.startswith(".") for part in path.relative_to(real).parts) or path == real:
        raise ConfigError(f"{key} = {given!r}: is not visible below {folder}; {hint}")
    return path


class AuditFiles:
    """The open files of a log and its head; raises `ConfigError` for what is neither new nor an audit log.

    Links are not followed, and files that have another name, too, are refused.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self.log = self.head = -1
        self.was_empty = False
        """True if the log existed, without any line."""

    def open(self) -> None:
        """Open both, and lock the log. On errors, call `close`."""
        self.log, is_new = self._open(self._path)
        try:
            fcntl.flock(self.log, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise ConfigError(
                f"audit_log {self._path}: another robot writes to it; give each robot its own file"
            ) from error
        first, newline, _ = os.pread(self.log, MAX_LINE, 0).partition(b"\n")
        self.was_empty = not is_new and not first and not newline
        if not is_new and not self.was_empty and parsed(first) is None and not first.startswith(_BEGIN):
            raise ConfigError(f"audit_log {self._path}: is a file with something else; name a new file")
        path = head_file(self._path)
        self.head, _ = self._open(path)
        number, colon, _ = os.pread(self.head, MAX_LINE, 0).partition(b":")
        if (number or colon) and not (number.isdigit() and colon):
            raise ConfigError(f"audit_log {self._path}: {path} is a file with something else; remove it")

    def close(self) -> None:
        """Close what is open; may be called twice."""
        for file in (self.log, self.head):
            if file >= 0:
                os.close(file)
        self.log = self.head = -1

    def _open(self, path: Path) -> tuple[int, bool]:
        """The descriptor of a regular file, and whether it was created."""
        flags = os.O_RDWR | os.O_CLOEXEC | os.O_NONBLOCK | os.O_NOFOLLOW
        try:
            try:
                return os.open(path, flags | os.O_CREAT | os.O_EXCL, 0o600), True
            except FileExistsError:
                file = os.open(path, flags)
        except OSError as error:
            reason = "is a link" if path.is_symlink() else error.strerror
            raise ConfigError(f"audit_log {path}: {reason}") from error
        state = os.fstat(file)
        if not stat.S_ISREG(state.st_mode) or state.st_nlink > 1:
            os.close(file)
            what = "is not a regular file" if not stat.S_ISREG(state.st_mode) else "is also the file of another name"
            raise ConfigError(f"audit_log {path}: {what}")
        return file, False
