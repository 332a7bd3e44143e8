"""Unix datagram sockets by path name: bound once, cleaned up, and never stolen from a living owner."""

from __future__ import annotations

import errno
import shutil
import socket
import stat
from pathlib import Path
from typing import Final

from jauspy.errors import TransportError

MAX_PATH: Final = 107
"""Longest path of a Unix socket on Linux, in bytes."""


def is_alive(path: Path) -> bool:
    """True when somebody listens on this socket."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(str(path))
        except OSError as error:
            return error.errno not in (errno.ENOENT, errno.ECONNREFUSED)
    return True


def bind(path: Path, *, owner: str, mode: int | None = None) -> socket.socket:
    """A non-blocking socket bound to `path`; raises `TransportError` when `owner` (a phrase) is already there."""
    if len(str(path).encode()) > MAX_PATH:
        raise TransportError(f"the socket path {path} is longer than {MAX_PATH} bytes; choose a shorter --local-root")
    if path.exists() and not stat.S_ISSOCK(path.stat().st_mode):
        raise TransportError(f"{path} is in the way and is no socket; move it, or choose another --local-root")
    if is_alive(path):
        raise TransportError(f"{owner} is already running on {path}; stop it, or choose another --local-root")
    sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    try:
        sock.setblocking(False)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
        sock.bind(str(path))
        if mode is not None:
            path.chmod(mode)
    except OSError as error:
        sock.close()
        raise TransportError(f"cannot open the socket {path}: {error.strerror}; choose another --local-root") from error
    return sock


def give_to_group(path: Path, group: str | None) -> None:
    """Let another group own the socket; raises `TransportError` when this user may not."""
    if group is None:
        return
    try:
        shutil.chown(path, group=group)
    except LookupError:
        raise TransportError(f"local_group: there is no group {group!r} on this machine") from None
    except OSError as error:
        raise TransportError(f"local_group: cannot give {path} to {group!r}: {error.strerror}") from error


def clean_up(path: Path) -> None:
    """Remove a socket that was just closed, unless somebody else has taken its name since."""
    if not is_alive(path):
        path.unlink(missing_ok=True)
