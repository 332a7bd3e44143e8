"""What was known at any time of a capture: its datagrams in memory, and copies of what was observed in between."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable, Iterator
from typing import Final

from jauspy.capture.dissect import Part
from jauspy.capture.reader import Datagram
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.inspection.observed import Observed
from jauspy.inspection.peers import PeerRecogniser
from jauspy.inspection.traffic import COPY_TIME, SeenMessage, seen_messages

MAX_BYTES: Final = 256 << 20
MAX_DATAGRAMS: Final = 1_000_000
"""What is beyond either is not shown."""
CHECKPOINTS: Final = 64
MIN_STRIDE: Final = 500
"""Datagrams between two checkpoints, at least."""

Fits = Callable[[Part], bool]


class Timeline:
    """The datagrams of a capture, in which one can go back and forth.

    Going to a time decodes the datagrams since the last checkpoint before it, at most a 64th of the capture.

    Raises:
        ConfigError: the capture is damaged before its first datagram, or has none.
    """

    def __init__(self, datagrams: Iterable[Datagram], registry: Registry) -> None:
        self._registry = registry
        self._datagrams: list[Datagram] = []
        self._times: list[float] = []
        self.peers = PeerRecogniser()
        """Notes on the implementations at their hosts."""
        self.problem = ""
        """Why it ends before the capture does, if so."""
        self._read(datagrams)
        if not self._datagrams:
            raise ConfigError(self.problem or "the capture has no JAUS datagrams")
        self.start, self.end = self._times[0], self._times[-1]
        self.index(None)

    def index(self, fits: Fits | None) -> None:
        """Decode everything once and remember checkpoints; only messages that fit are listed."""
        self._fits = fits
        self._checkpoints: list[tuple[int, Observed]] = [(0, Observed())]
        stride = max(MIN_STRIDE, -(-len(self._datagrams) // CHECKPOINTS))
        observed, due = Observed(), stride
        for position, seen in self._messages(0):
            if position >= due:
                self._checkpoints.append((position, observed.copy()))
                due = position + stride
            self._add(observed, seen)

    def at(self, time: float) -> Observed:
        """What the messages up to a time tell."""
        end = bisect_right(self._times, time)
        number = bisect_right(self._checkpoints, end, key=lambda checkpoint: checkpoint[0]) - 1
        start, checkpoint = self._checkpoints[number]
        observed = checkpoint.copy()
        for position, seen in self._messages(start):
            if position >= end:
                break
            self._add(observed, seen)
        return observed

    def between(self, after: float, until: float) -> Iterator[SeenMessage]:
        """The messages that fit after a time, up to another one."""
        end = bisect_right(self._times, until)
        for position, seen in self._messages(bisect_right(self._times, after)):
            if position >= end:
                break
            if self._fits is None or self._fits(seen.part):
                yield seen

    def _add(self, observed: Observed, seen: SeenMessage) -> None:
        observed.add(seen, listed=self._fits is None or self._fits(seen.part))

    def _messages(self, start: int) -> Iterator[tuple[int, SeenMessage]]:
        """Messages with the numbers of their datagrams; those just before are read, too, to know copies."""
        if start >= len(self._datagrams):
            return
        position = first = bisect_left(self._times, self._times[start] - COPY_TIME, 0, start)

        def datagrams() -> Iterator[Datagram]:
            nonlocal position
            for position in range(first, len(self._datagrams)):
                yield self._datagrams[position]

        for seen in seen_messages(datagrams(), self._registry):
            if position >= start:
                yield position, seen

    def _read(self, datagrams: Iterable[Datagram]) -> None:
        size = 0
        try:
            for datagram in datagrams:
                size += len(datagram.payload)
                if size > MAX_BYTES or len(self._datagrams) >= MAX_DATAGRAMS:
                    self.problem = f"only the first {len(self._datagrams)} datagrams are shown"
                    return
                time = max(datagram.time, self._times[-1]) if self._times else datagram.time
                self._times.append(time)
                self._datagrams.append(datagram._replace(time=time))
                self.peers.see(datagram.payload, datagram.source, datagram.destination)
        except ConfigError as error:  # what was read before the damage is shown
            self.problem = str(error)
