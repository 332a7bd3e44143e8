"""What the event loop calls must not raise into it: a bug is logged and counted, and the component goes on."""

from __future__ import annotations

import asyncio
import logging
from collections import Counter
from collections.abc import Callable
from types import TracebackType
from typing import Final

_LOG: Final = logging.getLogger("jauspy.component")


class ErrorGuard:
    """A `with` block around everything one wake-up does; reusable, not to be nested."""

    __slots__ = ("_counters", "_name")

    def __init__(self, name: str, counters: Counter[str]) -> None:
        self._name = name
        self._counters = counters

    def __enter__(self) -> None:
        return None

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> bool:
        if not isinstance(error, Exception):
            return False
        self._counters["internal_error"] += 1
        _LOG.error("%s: %s", self._name, error, exc_info=error)
        return True


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
