"""Where contents of the screen come from: a thread that listens to a node manager, or a capture and a time in it."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from typing import Final

from jauspy.capture.filters import Filter
from jauspy.codec.registry import Registry
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.inspection.live import LiveCapture
from jauspy.inspection.observed import Observed
from jauspy.inspection.peers import PeerRecogniser
from jauspy.inspection.series import Series
from jauspy.inspection.timeline import Timeline
from jauspy.inspection.traffic import SeenMessage, seen_messages

MAX_WAITING: Final = 10_000
"""Messages that wait for the screen; further ones are dropped and counted."""
MAX_BATCH: Final = 2000
"""Messages taken at once, so that keys are answered in between."""
RECONNECT_SECONDS: Final = 1.0
SPEEDS: Final = (0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0)


class LiveSource:
    """What a node manager of this machine routes now; if it ends, the next one in the same local root is awaited.

    Raises:
        TransportError: none shows its traffic there.
    """

    def __init__(self, root: Path, registry: Registry) -> None:
        self.root = root
        self._registry = registry
        self._waiting: queue.Queue[SeenMessage] = queue.Queue(MAX_WAITING)
        self._stop = threading.Event()
        self._capture: LiveCapture | None = LiveCapture(root)
        self._thread = threading.Thread(target=self._listen, name="monitor", daemon=True)
        self._frozen: tuple[Observed, float] | None = None
        self._fits: Filter | None = None
        self._all = Observed()
        self.peers = PeerRecogniser()
        self.series: Series | None = None
        self.dropped = 0
        self.problem = ""
        self._thread.start()

    @property
    def lost(self) -> int:
        """Packets that were not shown, because they were not read in time."""
        capture = self._capture
        return self.dropped + (0 if capture is None else capture.lost)

    @property
    def observed(self) -> Observed:
        """What is known now, or when it was frozen."""
        return self._all if self._frozen is None else self._frozen[0]

    @property
    def ids(self) -> list[JausID]:
        """The components that are known."""
        return sorted(self._all.components)

    @property
    def now(self) -> float:
        """The time to which ages refer."""
        return time.time() if self._frozen is None else self._frozen[1]

    @property
    def frozen(self) -> bool:
        """True while what is shown stands still; listening goes on."""
        return self._frozen is not None

    def freeze(self) -> None:
        """Stand still, or go on."""
        self._frozen = (self._all.copy(), time.time()) if self._frozen is None else None

    def poll(self) -> None:
        """Take messages that have arrived."""
        for _ in range(MAX_BATCH):
            try:
                seen = self._waiting.get_nowait()
            except queue.Empty:
                return
            listed = self._fits is None or self._fits(seen.part)
            self._all.add(seen, listed=listed)
            if self.series is not None and listed:
                self.series.add(seen)

    def set_filter(self, fits: Filter | None) -> None:
        """List only messages that fit from now on."""
        self._fits = fits
        self._all.clear_streams()
        if self._frozen is not None:
            self._frozen[0].clear_streams()

    def plot(self, series: Series | None) -> None:
        """Collect the values of a field from now on, beginning with the latest."""
        self.series = series
        if series is not None and (stream := self.observed.streams.get(series.route)) is not None:
            series.add(stream.latest)

    def close(self) -> None:
        """Stop listening."""
        self._stop.set()
        capture = self._capture
        if capture is not None:
            capture.interrupt()
        self._thread.join(timeout=2.0)

    def _listen(self) -> None:
        while not self._stop.is_set():
            try:
                capture = self._capture or LiveCapture(self.root)
                self._capture, self.problem = capture, ""
                with closing(capture):
                    for seen in seen_messages(capture, self._registry, peers=self.peers):
                        try:
                            self._waiting.put_nowait(seen)
                        except queue.Full:
                            self.dropped += 1
                self.dropped += capture.lost
            except JausError as error:
                self.problem = str(error).partition(":")[0]
            else:
                self.problem = "the node manager has ended; waiting for the next one"
            self._capture = None
            self._stop.wait(RECONNECT_SECONDS)


class CaptureSource:
    """A capture with a position in time; decoding is done by `work`, in another thread."""

    def __init__(self, timeline: Timeline) -> None:
        self.timeline, self.peers = timeline, timeline.peers
        self.position = timeline.end  # all that the capture tells
        self.playing = False
        self.speed = 1.0
        self.observed = timeline.at(timeline.end)
        self.ids = sorted(self.observed.components)
        """All components of the capture, also before they are heard."""
        self.series: Series | None = None
        self.problem = timeline.problem
        self.lost = 0
        self._shown = timeline.end
        self._jobs: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()

    @property
    def now(self) -> float:
        """The time to which ages refer."""
        return self._shown

    @property
    def busy(self) -> bool:
        """True if there is something to do for `work`."""
        return self._shown != self.position or not self._jobs.empty()

    def move(self, seconds: float) -> None:
        """Go to a time; the ends are the limits."""
        self.position = min(self.timeline.end, max(self.timeline.start, seconds))

    def advance(self, seconds: float) -> None:
        """Go on if it plays, for a time of the wall clock; stop at the end."""
        if self.playing:
            self.move(self.position + seconds * self.speed)
            self.playing = self.position < self.timeline.end

    def play(self) -> None:
        """Play or pause; at the end, play from the beginning."""
        self.playing = not self.playing
        if self.playing and self.position >= self.timeline.end:
            self.position = self.timeline.start

    def change_speed(self, steps: int) -> None:
        """Play faster or more slowly."""
        number = SPEEDS.index(self.speed) + steps
        self.speed = SPEEDS[min(len(SPEEDS) - 1, max(0, number))]

    def set_filter(self, fits: Filter | None) -> None:
        """List only messages that fit."""
        self._jobs.put(lambda: self.timeline.index(fits))

    def plot(self, series: Series | None) -> None:
        """Collect the values of a field in the whole capture."""

        def collect() -> None:
            if series is not None:
                for seen in self.timeline.between(self.timeline.start - 1.0, self.timeline.end):
                    series.add(seen)
            self.series = series

        self._jobs.put(collect)

    def work(self) -> None:
        """Decode what is to be shown; takes up to seconds for a large capture."""
        changed = False
        while not self._jobs.empty():
            self._jobs.get()()
            changed = True
        position = self.position
        if changed or position != self._shown:
            self.observed = self.timeline.at(position)
            self._shown = position
