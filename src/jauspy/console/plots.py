"""Values of reports over time: which are recorded, how long they are kept, and as CSV."""

from __future__ import annotations

import asyncio
import csv
import io
import time
from collections import deque
from collections.abc import Callable
from contextlib import aclosing
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Final

from jauspy.codec.message import Message
from jauspy.console.fields import numbers_of
from jauspy.console.reports import reports_of
from jauspy.errors import ConfigError, JausError
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.ocu.subsystems import ComponentInfo

MAX_TRACES: Final = 12
MAX_SAMPLES: Final = 6000
"""Values that are kept of each trace: ten minutes at 10 Hz; older ones are dropped."""
MAX_RATE: Final = 50.0
"""Hz."""
RETRY_INTERVAL: Final = 1.0
"""Seconds until a component is asked again that did not answer."""


@dataclass(slots=True)
class Trace:
    """A field of a report over time."""

    number: int
    component: JausID
    query: Message
    path: str
    unit: str
    samples: deque[tuple[float, float]] = field(default_factory=lambda: deque(maxlen=MAX_SAMPLES))
    """Seconds since 1970 (when it was received here) and value."""
    total: int = 0
    """Values so far, those that were dropped too."""
    problem: str = ""
    """Why no values come, in words."""

    @property
    def name(self) -> str:
        """As in `101.1.102 LocalPose.x`."""
        return f"{self.component} {self.query.NAME.removeprefix('Query')}.{self.path}"

    def add(self, at: float, value: float) -> None:
        """Record a value."""
        self.samples.append((at, value))
        self.total += 1


Source = tuple[JausID, str]
"""A component and the name of a query: the traces of one report share a subscription."""


class Recorder:
    """The traces of one page. `close` ends all subscriptions."""

    def __init__(self, ocu: OCU, now: Callable[[], float] = time.time) -> None:
        self.traces: dict[int, Trace] = {}
        self._ocu = ocu
        self._now = now
        self._next = 0
        self._tasks: dict[Source, asyncio.Task[None]] = {}
        self._rates: dict[Source, float] = {}

    def add(self, component: ComponentInfo, query: Message, path: str, unit: str, rate: float) -> Trace:
        """Record a field at a rate in Hz, which then holds for all fields of this report."""
        if not 0 < rate <= MAX_RATE:
            raise ConfigError(f"a rate of {rate:g} Hz is outside 0..{MAX_RATE:g} Hz")
        source = (component.id, query.NAME)
        same = next((each for each in self._of(source) if each.path == path), None)
        if same is None and len(self.traces) >= MAX_TRACES:
            raise ConfigError(f"{MAX_TRACES} traces are shown, and not more; remove one first")
        trace = same or Trace(self._next, component.id, query, path, unit)
        self._next += same is None
        self.traces[trace.number] = trace
        if self._rates.get(source) != rate:
            self._end(source)
            self._rates[source] = rate
            recording = self._record(source, query, rate, events=component.find("Events") is not None)
            self._tasks[source] = asyncio.create_task(recording, name=f"console: {component.id} {query.NAME}")
        return trace

    def remove(self, number: int) -> None:
        """Remove a trace; the subscription ends with the last one of its report."""
        trace = self.traces.pop(number, None)
        if trace is not None and not self._of(source := (trace.component, trace.query.NAME)):
            self._end(source)

    def clear(self) -> None:
        """Forget all values, and go on recording."""
        for trace in self.traces.values():
            trace.samples.clear()

    def close(self) -> None:
        """End all subscriptions. May be called twice."""
        for source in list(self._tasks):
            self._end(source)

    def csv(self) -> str:
        """All values as CSV: one line for each time at which a report came, one column for each trace."""
        traces = list(self.traces.values())
        rows: dict[float, dict[int, float]] = {}
        for trace in traces:
            for at, value in trace.samples:
                rows.setdefault(at, {})[trace.number] = value
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["time"] + [f"{each.name} [{each.unit}]" if each.unit else each.name for each in traces])
        for at in sorted(rows):
            stamp = datetime.fromtimestamp(at, UTC).isoformat(timespec="milliseconds")
            writer.writerow([stamp] + [rows[at].get(each.number, "") for each in traces])
        return text.getvalue()

    def _of(self, source: Source) -> list[Trace]:
        return [each for each in self.traces.values() if (each.component, each.query.NAME) == source]

    def _end(self, source: Source) -> None:
        self._rates.pop(source, None)
        if (task := self._tasks.pop(source, None)) is not None:
            task.cancel()

    async def _record(self, source: Source, query: Message, rate: float, *, events: bool) -> None:
        while True:
            try:
                async with aclosing(reports_of(self._ocu, source[0], query, rate, events=events)) as reports:
                    async for report in reports:
                        self._take(source, report)
            except JausError as error:
                for trace in self._of(source):
                    trace.problem = str(error)
            await asyncio.sleep(RETRY_INTERVAL)

    def _take(self, source: Source, report: Message) -> None:
        at, values = self._now(), numbers_of(report)
        for trace in self._of(source):
            value = values.get(trace.path)
            trace.problem = "" if value is not None else "the last report has no such field"
            if value is not None:
                trace.add(at, value)
