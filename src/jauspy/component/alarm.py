"""One timer of the event loop, moved as little as possible."""

from __future__ import annotations

import asyncio
from collections.abc import Callable


class LoopTimer:
    """Calls `ring` once, at the time that was last set, by `clock`."""

    def __init__(self, ring: Callable[[], None], clock: Callable[[], float]) -> None:
        self._ring = ring
        self._clock = clock
        self._timer: asyncio.TimerHandle | None = None
        self._at: float | None = None

    def set(self, loop: asyncio.AbstractEventLoop, at: float | None) -> None:
        """Ring then, or not at all; the same time as before costs nothing."""
        if self._timer is not None:
            if at == self._at:
                return
            self._timer.cancel()
            self._timer = None
        if at is not None:
            self._timer, self._at = loop.call_later(max(0.0, at - self._clock()), self._rings), at

    def cancel(self) -> None:
        """Do not ring any more; twice is fine."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _rings(self) -> None:
        self._timer = None
        self._ring()
