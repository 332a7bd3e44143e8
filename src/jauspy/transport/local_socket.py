"""Unix datagram sockets by path name: bound once, cleaned up, and never stolen from a living owner."""

from __future__ import annotations

import contextlib
import errno
import shutil
import socket
from pathlib import Path
from typing import Final

from jauspy.errors import TransportError

MAX_PATH: Final = 107
"""Longest path of a Unix socket on Linux, in bytes."""


OTHER_DIRECTORY: Final = "choose another directory for the local sockets"

_NO_LISTENER: Final = (errno.ENOENT, errno.ECONNREFUSED)


def is_alive(path: Path) -> bool:
    """True when somebody listens on this socket, and lets this user in."""
    return _probe(path) == 0


def is_dead(path: Path) -> bool:
    """True when nobody listens on this socket; what cannot be found out is false, as with `is_alive`."""
    return _probe(path) in _NO_LISTENER


def refusal(path: Path) -> str | None:
    """One sentence on why this user cannot speak to whoever may listen on `path`; None when nothing stands between."""
    match _probe(path):
        case errno.ENOTDIR:
            return f"{path.parent} is no directory, so it has no local sockets; {ELSEWHERE}"
        case errno.EACCES | errno.EPERM:
            return f"this user may not use {path}; run as its owner or in its group, or {ELSEWHERE}"
        case errno.EPROTOTYPE:
            return f"{path} is a socket of another kind; move it, or {ELSEWHERE}"
        case _:
            return None


def bind(path: Path, *, owner: str, advice: str = OTHER_DIRECTORY, mode: int | None = None) -> socket.socket:
    """A non-blocking socket bound to `path`; raises `TransportError` when it cannot be.

    `owner` is a phrase for who else may be there, and `advice` for what to do then if it shall go on running.
    """
    if len(str(path).encode()) > MAX_PATH:
        raise TransportError(
            f"the socket path {path} is longer than {MAX_PATH} bytes; "
            "choose a directory with a shorter name for the local sockets"
        )
    if is_alive(path):
        raise TransportError(f"{owner} is already running on {path}; stop it, or {advice}")
    if (why := refusal(path)) is not None:
        raise TransportError(why)
    if path.exists() and not path.is_socket():
        raise TransportError(f"{path} is in the way and is no socket; move it, or {ELSEWHERE}")
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
        raise TransportError(f"cannot open the socket {path}: {error.strerror}; {ELSEWHERE}") from error
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
    """Remove a socket that nobody listens on; what cannot be removed stays, for whoever binds next."""
    if path.is_socket() and is_dead(path):
        with contextlib.suppress(OSError):
            path.unlink()


def _probe(path: Path) -> int:
    """The error number of an attempt to connect, 0 when it worked."""
    try:
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as probe:
            probe.connect(str(path))
    except OSError as error:
        return error.errno or errno.ENAMETOOLONG
    return 0
