"""Notification of systemd by the protocol of sd_notify(3): readiness, reloads, and the watchdog."""

from __future__ import annotations

import asyncio
import os
import socket
import time
from types import TracebackType
from typing import Final, Self

SOCKET: Final = "NOTIFY_SOCKET"
WATCHDOG: Final = "WATCHDOG_USEC"


class SystemdNotifier:
    """Within its context the service is ready, and the event loop feeds the watchdog, so that a hang is detected.

    Does nothing if the process was not started by systemd with notifications.
    """

    def __init__(self) -> None:
        self._address = os.environ.get(SOCKET, "").replace("@", "\0", 1)
        self._pause = int(os.environ.get(WATCHDOG) or 0) / 2e6
        self._timer: asyncio.TimerHandle | None = None

    async def __aenter__(self) -> Self:
        self._notify("READY=1")
        if self._address and self._pause:
            self._feed_watchdog()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._timer is not None:
            self._timer.cancel()
        self._notify("STOPPING=1")

    def reloading(self) -> None:
        """Report the start of a reload; `ready` reports its end."""
        self._notify(f"RELOADING=1\nMONOTONIC_USEC={time.monotonic_ns() // 1000}")

    def ready(self, status: str) -> None:
        """Report the end of a reload; `systemctl status` shows `status`."""
        self._notify(f"READY=1\nSTATUS={status}")

    def _feed_watchdog(self) -> None:
        self._notify("WATCHDOG=1")
        self._timer = asyncio.get_running_loop().call_later(self._pause, self._feed_watchdog)

    def _notify(self, text: str) -> None:
        if not self._address:
            return
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM | socket.SOCK_CLOEXEC) as sock:
            sock.setblocking(False)
            try:
                sock.sendto(text.encode(), self._address)
            except OSError:
                return
