"""Helpers of a component in the event loop: a guard against exceptions, and one timer."""

from __future__ import annotations

import asyncio
from collections import Counter
from collections.abc import Callable
from types import TracebackType
from typing import Final

from jauspy.logs import get_logger

_LOG: Final = get_logger("jauspy.component")


class ErrorGuard:
    """A `with` block that logs and counts exceptions, so that the component goes on; reusable, not to be nested."""

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
    """Calls `on_timeout` once at the time (s) that was set last, by `clock`; uses one timer handle of the loop."""

    def __init__(self, on_timeout: Callable[[], None], clock: Callable[[], float]) -> None:
        self._on_timeout = on_timeout
        self._clock = clock
        self._handle: asyncio.TimerHandle | None = None
        self._at: float | None = None

    def set(self, loop: asyncio.AbstractEventLoop, at: float | None) -> None:
        """Set the time, None for never; the same time as before costs nothing."""
        if self._handle is not None:
            if at == self._at:
                return
            self._handle.cancel()
            self._handle = None
        if at is not None:
            self._handle, self._at = loop.call_later(max(0.0, at - self._clock()), self._expire), at

    def cancel(self) -> None:
        """Cancel the timer, if it is set."""
        if self._handle is not None:
            self._handle.cancel()
            self._handle = None

    def _expire(self) -> None:
        self._handle = None
        self._on_timeout()
