"""Has components that send too much wait: their socket is not read while a receiver that reads has a long queue."""

from __future__ import annotations

import asyncio
from collections import OrderedDict
from collections.abc import Callable
from typing import Final

from jauspy.protocol.counters import Counters

HIGH_WATER: Final = 384
"""Queued datagrams of a component above which reading pauses: of its 512, a burst from the socket still has room."""
LOW_WATER: Final = 352
"""Queued datagrams at which reading goes on: after short pauses, since others' datagrams come in between."""
PATIENCE: Final = 150e-6
"""Seconds that are waited for each datagram that a receiver reads, on average: one that is slower loses its own."""
MAX_CREDIT: Final = 0.03
"""Seconds that are waited for a receiver that reads nothing, as while the kernel runs other processes."""
REST: Final = 0.2
"""Seconds without a pause after one in vain, so that receivers that do not read take little of others' time."""
MIN_BAR: Final = 0.5
MAX_BAR: Final = 60.0
"""Seconds in which nobody waits for a receiver after a pause in vain: twice as many after each further one."""
MAX_RECEIVERS: Final = 1024
"""Receivers whose credit is remembered; those with all of theirs need not be."""


class BackPressure:
    """Decides when components wait for a receiver, by its path. `pause()` and `resume()` stop reading and go on.

    Datagrams that are not read fill the kernel's buffers, so that their senders block or are told to try again. All
    components share one socket, so nobody waits for long, nor often for a receiver that does not read.
    """

    def __init__(self, pause: Callable[[], object], resume: Callable[[], None], counters: Counters) -> None:
        self._pause, self._resume = pause, resume
        self._counters = counters
        self._loop = asyncio.get_running_loop()
        self._timer: asyncio.TimerHandle | None = None
        self._awaited: set[str] = set()
        self._paused_at = 0.0
        self._credit: OrderedDict[str, float] = OrderedDict()
        """Seconds that may still be waited for receivers, if less than `MAX_CREDIT`."""
        self._barred: dict[str, tuple[float, float]] = {}
        """Until when, and for how long, nobody waits for receivers for which a pause was in vain."""
        self._resting_until = float("-inf")

    def congested(self, path: str) -> None:
        """Note that a queue is above `HIGH_WATER`."""
        if path in self._awaited:
            return
        now = self._loop.time()
        until, _ = self._barred.get(path, (now, 0.0))
        if now < until or now < self._resting_until:
            return
        self._awaited.add(path)
        if self._timer is None:
            self._counters["local.paused"] += 1
            self._paused_at = now
            self._timer = self._loop.call_later(self._credit.get(path, MAX_CREDIT), self._give_up)
            self._pause()

    def relieved(self, path: str) -> None:
        """Note that a queue is at `LOW_WATER` or below."""
        if path in self._awaited:
            earned = PATIENCE * (HIGH_WATER - LOW_WATER)
            credit = self._credit.pop(path, MAX_CREDIT) + earned - (self._loop.time() - self._paused_at)
            if credit < MAX_CREDIT:
                self._credit[path] = max(credit, 0.0)
                if len(self._credit) > MAX_RECEIVERS:
                    self._credit.popitem(last=False)
            self._end(path)
        elif self._barred:
            self._barred.pop(path, None)

    def forget(self, path: str) -> None:
        """Forget a component that is gone."""
        self._barred.pop(path, None)
        self._credit.pop(path, None)
        self._end(path)

    def _end(self, path: str) -> None:
        self._awaited.discard(path)
        if not self._awaited and self._timer is not None:
            self._timer.cancel()
            self._timer = None
            self._resume()

    def close(self) -> None:
        """Wait for nobody any more, and do not read again; a second call does nothing."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        self._awaited.clear()

    def _give_up(self) -> None:
        assert self._timer is not None
        now = self._loop.time()
        if now - self._timer.when() > MAX_CREDIT / 2.0:  # this process did not run: the receivers had no chance
            self._timer = self._loop.call_later(MAX_CREDIT, self._give_up)
            return
        self._timer = None
        self._counters["local.paused_in_vain"] += 1
        for path in self._awaited:
            self._credit.pop(path, None)
            _, last = self._barred.get(path, (0.0, MIN_BAR / 2.0))
            bar = min(2.0 * last, MAX_BAR)
            self._barred[path] = now + bar, bar
        self._awaited.clear()
        self._resting_until = now + REST
        self._resume()
