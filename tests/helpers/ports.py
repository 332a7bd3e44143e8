"""Ports that nobody else uses."""

from __future__ import annotations

import contextlib
import os
import secrets
import socket


def unused_port() -> int:
    """A port that nobody uses now, for UDP and TCP on any address.

    It is below those that the kernel gives to whoever asks for any, and in a range of this process's own: until the
    test binds it, nobody else takes it.
    """
    worker = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0")[2:]) % 10
    while True:
        port = 20_000 + 1000 * worker + secrets.randbelow(1000)
        with (
            contextlib.suppress(OSError),
            socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as datagrams,
            socket.socket(socket.AF_INET, socket.SOCK_STREAM) as streams,
        ):
            datagrams.bind(("", port))
            streams.bind(("", port))
            return port
