"""Reading datagram sockets in an event loop: everything that waits, with a bound per wake-up."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable
from typing import Any, Final

DATAGRAMS_PER_WAKEUP: Final = 64
MAX_DATAGRAM: Final = 65536


def start_reading(
    loop: asyncio.AbstractEventLoop,
    sock: socket.socket,
    take: Callable[[bytes, Any], None],
    failed: Callable[[OSError], None],
) -> None:
    """Call `take(datagram, sender)` for each datagram of a non-blocking socket until it is detached.

    An error that a sent datagram left behind goes to `failed`, and reading goes on.
    """

    def drain() -> None:
        for _ in range(DATAGRAMS_PER_WAKEUP):
            try:
                datagram, sender = sock.recvfrom(MAX_DATAGRAM)
            except (BlockingIOError, InterruptedError):
                return
            except OSError as error:
                failed(error)
                return
            take(datagram, sender)

    loop.add_reader(sock, drain)


def stop_reading(loop: asyncio.AbstractEventLoop, sock: socket.socket) -> None:
    """Stop reading and close the socket."""
    loop.remove_reader(sock)
    sock.close()
