"""Time that does not pass by itself: an event loop jumps to its next timer instead of waiting for it."""

from __future__ import annotations

import asyncio
from datetime import UTC, datetime, timedelta
from types import TracebackType
from typing import Any, Final, Self

from jauspy.errors import ConfigError

EPOCH: Final = datetime(2026, 1, 1, tzinfo=UTC)
"""The wall clock's time when a virtual clock starts."""
START: Final = 1000.0
"""Seconds that the loop's clock shows when a virtual clock starts, always the same: sums of times are rounded alike."""
TURN: Final = 1e-9
"""Seconds that a turn of the loop takes. Were it none, a timer that is run early, within the loop's resolution, and
sets itself again would be early for ever."""


class VirtualClock:
    """Inside `with VirtualClock()` the running event loop lives on virtual time.

    While anything can run, no time passes; when nothing can, it is the next timer's time at once. An hour of timeouts
    takes milliseconds, and the same test runs the same way each time. Threads, processes and real sockets live on real
    time and are not waited for; do without them inside.
    """

    def __init__(self) -> None:
        self._loop: Any = None
        self._selector: Any = None
        self._now = START

    def time(self) -> float:
        """Seconds of the loop's monotonic clock, as `loop.time()`."""
        return self._now

    @property
    def elapsed(self) -> float:
        """Virtual seconds since it started."""
        return self._now - START

    def utc_now(self) -> datetime:
        """The wall clock: midnight of 1 January 2026, and what has passed since."""
        return EPOCH + timedelta(seconds=self.elapsed)

    def __enter__(self) -> Self:
        loop: Any = asyncio.get_running_loop()
        if self._loop is not None or isinstance(loop.__dict__.get("_selector"), _Jumps):
            raise ConfigError("this event loop lives on a virtual clock already; one is enough")
        if "_selector" not in vars(loop):
            raise ConfigError(f"{type(loop).__name__} cannot live on a virtual clock; use asyncio's own event loop")
        self._now = START
        _put_off(loop, START - loop.time())
        # asyncio has no public way to do this to a loop that runs; a loop is its `time` and its `select` (ADR 36).
        self._loop, self._selector = loop, loop._selector  # noqa: SLF001
        loop._selector, loop.time = _Jumps(self._selector, self), self.time  # noqa: SLF001
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        loop, self._loop = self._loop, None
        loop._selector = self._selector  # noqa: SLF001
        del loop.time
        _put_off(loop, loop.time() - self._now)

    def pass_by(self, seconds: float) -> None:
        """Let time pass; called by the loop."""
        self._now += seconds


def _put_off(loop: Any, seconds: float) -> None:
    """Timers that run already keep the time that is left to them when the clock is changed by so much."""
    for handle in loop._scheduled:  # noqa: SLF001
        handle._when += seconds  # noqa: SLF001


class _Jumps:
    """A selector that does not wait when it is told for how long."""

    def __init__(self, selector: Any, clock: VirtualClock) -> None:
        self._selector = selector
        self._clock = clock

    def __getattr__(self, name: str) -> Any:
        return getattr(self._selector, name)

    def select(self, timeout: float | None = None) -> Any:
        """What is ready now; when nothing is, the time-out is over. Without one it waits for real."""
        ready = self._selector.select(0 if timeout is not None else None)
        self._clock.pass_by((timeout or 0.0) + TURN if not ready else TURN)
        return ready
