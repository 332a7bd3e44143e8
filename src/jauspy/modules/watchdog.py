"""Stops a drive whenever its component is not in a state in which it may move."""

from __future__ import annotations

from typing import Final, Protocol

from jauspy.services.host import Host

PERIOD: Final = 0.1
"""Seconds between two looks."""

MAY_MOVE: Final = ("Controlled", "Available", "Ready")
"""The states, one within the other, in which a client in control may move something (AS5710)."""


class Stoppable(Protocol):
    """What moves."""

    def stop(self) -> None:
        """Stop at once; twice is fine."""
        ...


def may_move(host: Host) -> bool:
    """True while a client is in control and has resumed the component."""
    path = host.path
    return any(path[start : start + len(MAY_MOVE)] == MAY_MOVE for start in range(len(path)))


class Watchdog:
    """A second line of defence: the services stop the drive by themselves, unless there is a mistake in them."""

    def __init__(self, host: Host, drive: Stoppable) -> None:
        self._host = host
        self._drive = drive
        self._look()

    def _look(self) -> None:
        self._host.set_timer("watchdog", self._host.now + PERIOD, self._look)
        if not may_move(self._host):
            self._drive.stop()
