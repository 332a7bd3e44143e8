"""Readers of the status and of the metrics: hundreds of connections that read nothing, or ask for nothing."""

from __future__ import annotations

import contextlib
import socket
import time
from typing import Any

from jauspy.node import status

from ..arena import Arena
from ..attack import Attack, Attacker
from ..hosts import Host
from ..stage import METRICS

RATE = 300
KEPT = 400
HONEST_INTERVAL = 1.0
TIMEOUT = 5.0


def stream(host: Host, address: Any) -> socket.socket:
    """A connection to a path, or to an address of a machine."""
    with host.entered():
        sock = socket.socket(socket.AF_UNIX if isinstance(address, str) else socket.AF_INET, socket.SOCK_STREAM)
    sock.setblocking(False)
    with contextlib.suppress(BlockingIOError):
        sock.connect(address)
    return sock


def is_readable(path: str) -> bool:
    """True when the status can be read."""
    try:
        with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as sock:
            sock.settimeout(TIMEOUT)
            sock.connect(path)
            return len(sock.recv(100)) > 0
    except OSError:
        return False


def run(arena: Arena) -> None:
    """The oldest are closed; a local user reads the status at times."""
    host, path = arena.hosts["robot"], str(arena.root / status.SOCKET_NAME)
    kept: list[socket.socket] = []
    due = time.monotonic()
    for number in arena.paced(RATE):
        address: Any = path if number % 2 else (arena.where[0], METRICS)
        with contextlib.suppress(OSError):
            kept.append(sock := arena.open(stream(host, address)))
            if number % 4 == 0:
                sock.send(b"GET /metrics HTTP/1.1\r\n" + b"X: y\r\n" * (number % 50))
        arena.sent += 1
        if len(kept) > KEPT:
            kept.pop(0).close()
        if time.monotonic() >= due:
            due = time.monotonic() + HONEST_INTERVAL
            arena.asked += 1
            arena.lost += not any(is_readable(path) for _ in range(2))


ATTACK = Attack("status-readers", Attacker.LOCAL, "connections", run)
