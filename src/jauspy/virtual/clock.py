"""Virtual time: an event loop advances to its next timer instead of waiting for it."""

from __future__ import annotations

import asyncio
from datetime import UTC, datetime, timedelta
from types import TracebackType
from typing import Any, Final, Self

from jauspy.errors import ConfigError

EPOCH: Final = datetime(2026, 1, 1, tzinfo=UTC)
"""The wall clock's time when a virtual clock starts."""
START_TIME: Final = 1000.0
"""Seconds that the loop's clock shows at the start, always the same, so that sums of times are rounded alike."""
ITERATION_TIME: Final = 1e-9
"""Seconds that one iteration of the loop takes. With 0, a timer that runs early, within the resolution of the loop, and
sets itself again would run early for ever."""


class VirtualClock:
    """Inside `with VirtualClock()` the running event loop uses virtual time.

    While a task can run, no time passes; when none can, time advances to the next timer. An hour of timeouts takes
    milliseconds, and a test runs the same way each time. Threads, processes and real sockets use real time and are not
    waited for: do not use them inside.
    """

    def __init__(self) -> None:
        self._loop: Any = None
        self._selector: Any = None
        self._now = START_TIME

    def time(self) -> float:
        """Seconds of the loop's monotonic clock, as `loop.time()`."""
        return self._now

    @property
    def elapsed(self) -> float:
        """Virtual seconds since it started."""
        return self._now - START_TIME

    def utc_now(self) -> datetime:
        """The wall clock, which starts at midnight of 1 January 2026."""
        return EPOCH + timedelta(seconds=self.elapsed)

    def __enter__(self) -> Self:
        loop: Any = asyncio.get_running_loop()
        if self._loop is not None or isinstance(loop.__dict__.get("_selector"), _VirtualSelector):
            raise ConfigError("this event loop uses a virtual clock already")
        if "_selector" not in vars(loop):
            raise ConfigError(f"{type(loop).__name__} cannot use a virtual clock; use asyncio's own event loop")
        self._now = START_TIME
        _shift_timers(loop, START_TIME - loop.time())
        # asyncio has no public interface to replace the clock and the selector of a running loop (ADR 36).
        self._loop, self._selector = loop, loop._selector  # noqa: SLF001
        loop._selector, loop.time = _VirtualSelector(self._selector, self), self.time  # noqa: SLF001
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        loop, self._loop = self._loop, None
        loop._selector = self._selector  # noqa: SLF001
        del loop.time
        _shift_timers(loop, loop.time() - self._now)

    def advance(self, seconds: float) -> None:
        """Advance the time; called by the selector."""
        self._now += seconds


def _shift_timers(loop: Any, seconds: float) -> None:
    """Shift the running timers when the clock is shifted, so that each keeps its remaining time."""
    for handle in loop._scheduled:  # noqa: SLF001
        handle._when += seconds  # noqa: SLF001


class _VirtualSelector:
    """A selector that advances the clock instead of waiting for a timeout."""

    def __init__(self, selector: Any, clock: VirtualClock) -> None:
        self._selector = selector
        self._clock = clock

    def __getattr__(self, name: str) -> Any:
        return getattr(self._selector, name)

    def select(self, timeout: float | None = None) -> Any:
        """The ready files. If none is ready, the timeout passes at once; without a timeout it waits in real time."""
        ready = self._selector.select(0 if timeout is not None else None)
        self._clock.advance((timeout or 0.0) + ITERATION_TIME if not ready else ITERATION_TIME)
        return ready
