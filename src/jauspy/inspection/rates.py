"""How often messages come, and how many bytes they take: by sender, receiver and name."""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from jauspy.inspection.traffic import SeenMessage

MAX_ROWS: Final = 10_000
"""Different senders, receivers and names; what is beyond is counted together."""
BEYOND: Final = "(others)"


class Route(NamedTuple):
    """A kind of message from one component to another."""

    source: str
    destination: str
    message: str


class Rate:
    """The times and sizes of the messages of one route."""

    def __init__(self) -> None:
        self.count = 0
        self.bytes = 0
        self.shortest, self.longest = math.inf, 0.0
        """Seconds between two messages."""
        self._last: float | None = None
        self._sum = self._squares = 0.0

    def add(self, time: float, size: int) -> None:
        """Add a message at a time (s) with a number of bytes."""
        self.count += 1
        self.bytes += size
        if self._last is not None:
            interval = max(0.0, time - self._last)
            self.shortest, self.longest = min(self.shortest, interval), max(self.longest, interval)
            self._sum += interval
            self._squares += interval * interval
        self._last = time

    @property
    def frequency(self) -> float | None:
        """Messages a second by the mean interval; None below two messages, or if all came at once."""
        return (self.count - 1) / self._sum if self.count > 1 and self._sum > 0.0 else None

    @property
    def jitter(self) -> float | None:
        """Standard deviation of the intervals, s; None below two intervals."""
        intervals = self.count - 1
        if intervals < 2:
            return None
        mean = self._sum / intervals
        return math.sqrt(max(0.0, self._squares / intervals - mean * mean))


class Rates:
    """The rates of all routes since `clear`, or the beginning."""

    def __init__(self) -> None:
        self.routes: dict[Route, Rate] = {}
        self.start: float | None = None
        self.end: float | None = None

    @property
    def seconds(self) -> float:
        """From the first message to the last."""
        return 0.0 if self.start is None or self.end is None else self.end - self.start

    def add(self, seen: SeenMessage) -> None:
        """Add a message."""
        self.start = seen.time if self.start is None else self.start
        self.end = seen.time
        packet = seen.part.packet
        route = Route(str(packet.source), str(packet.destination), seen.name)
        if route not in self.routes and len(self.routes) >= MAX_ROWS:
            route = Route(BEYOND, BEYOND, BEYOND)
        self.routes.setdefault(route, Rate()).add(seen.time, seen.size)

    def clear(self) -> None:
        """Begin a new period."""
        self.routes.clear()
        self.start = self.end = None
