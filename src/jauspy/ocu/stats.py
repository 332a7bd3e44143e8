"""How much was sent and received, and how long answers took."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass
from statistics import median
from typing import Final

MAX_ROUND_TRIPS: Final = 10_000
"""Round trips that the median is taken over: the latest."""


@dataclass(frozen=True, slots=True)
class Stats:
    """A moment's figures. Round-trip times are in seconds, of the latest 10,000 queries; 0 when there were none."""

    sent: int = 0
    received: int = 0
    answers: int = 0
    timeouts: int = 0
    malformed: int = 0
    unexpected: int = 0
    """Messages that nobody waited for, as answers that come too late."""
    rtt_min: float = 0.0
    rtt_median: float = 0.0
    rtt_max: float = 0.0


class StatsRecorder:
    """Counts as it goes; `snapshot` makes a `Stats`."""

    def __init__(self) -> None:
        self.sent = 0
        self.received = 0
        self.answers = 0
        self.timeouts = 0
        self.malformed = 0
        self.unexpected = 0
        self._round_trips: deque[float] = deque(maxlen=MAX_ROUND_TRIPS)

    def answered(self, seconds: float | None) -> None:
        """One query was answered after `seconds`; None when that is not known."""
        self.answers += 1
        if seconds is not None:
            self._round_trips.append(seconds)

    def snapshot(self) -> Stats:
        """The figures so far."""
        times = self._round_trips or (0.0,)
        return Stats(
            sent=self.sent,
            received=self.received,
            answers=self.answers,
            timeouts=self.timeouts,
            malformed=self.malformed,
            unexpected=self.unexpected,
            rtt_min=min(times),
            rtt_median=median(times),
            rtt_max=max(times),
        )
