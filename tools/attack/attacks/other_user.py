"""A user who is not in the group of the local sockets: may neither send to them, nor read the key or the status."""

from __future__ import annotations

import os
import socket
from collections.abc import Callable
from pathlib import Path

from jauspy.ids import JausID
from jauspy.node import status
from jauspy.protocol import junior

from ..arena import Arena
from ..attack import Attack, Attacker, Layout, NotPossible

RATE = 20
NOBODY = 65534
_REFUSED, _PERMITTED = 0, 1


def send(path: Path) -> None:
    """Connect as a component."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.sendto(junior.connect(JausID.parse("101.9.9")), str(path))


def connect(path: Path) -> None:
    """Connect to a stream socket."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as sock:
        sock.connect(str(path))


def bind(path: Path) -> None:
    """Take the socket of a component."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as sock:
        sock.bind(str(path))


def unlink(path: Path) -> None:
    """Remove a socket."""
    path.unlink()


def read(path: Path) -> None:
    """Read a file."""
    path.read_bytes()


def is_refused(action: Callable[[Path], None], path: Path) -> bool:
    """True when a user without groups may not do this."""
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == _REFUSED
    try:
        os.setgroups(())
        os.setgid(NOBODY)
        os.setuid(NOBODY)
        action(path)
    except PermissionError:
        os._exit(_REFUSED)
    finally:
        os._exit(_PERMITTED)


def run(arena: Arena) -> None:
    """One try after the other, each in a process of this user."""
    if os.geteuid():
        raise NotPossible("needs root, to be another user")
    arena.folder.chmod(0o755)
    root = arena.root
    tries: tuple[tuple[Callable[[Path], None], Path], ...] = (
        (send, root / junior.SOCKET_NAME),
        (connect, root / status.SOCKET_NAME),
        (bind, root / "6619999"),
        (unlink, root / junior.SOCKET_NAME),
        (read, arena.stage.key_file),
    )
    for number in arena.paced(RATE):
        action, path = tries[number % len(tries)]
        arena.sent += 1
        arena.require(is_refused(action, path), f"another user may {action.__name__} {path.name}")


ATTACK = Attack("other-user", Attacker.LOCAL, "tries", run, layout=Layout(keyed=True))
