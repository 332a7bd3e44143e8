"""The tab Plots: records any numeric field of any report over time, draws it, and exports CSV."""

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
from functools import partial
from typing import Final

from nicegui import ui

from jauspy.codec.message import Message
from jauspy.console.conventions import JAUS, RADIANS, Conventions
from jauspy.console.languages import sentence
from jauspy.console.markup import attributes, call
from jauspy.console.page_language import _, translated
from jauspy.console.reports import Field, fields_of, numbers_of, queries_of, reports_of
from jauspy.errors import ConfigError, JausError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.printable import printable

MAX_TRACES: Final = 12
MAX_SAMPLES: Final = 6000
"""Values that are kept of each trace: ten minutes at 10 Hz; older ones are dropped."""
MAX_RATE: Final = 50.0
"""Hz."""
RETRY_INTERVAL: Final = 1.0
"""Seconds until a component that did not answer is queried again."""


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
    """The number of values so far, including dropped ones."""
    problem: str = ""
    """Why no values arrive."""

    @property
    def name(self) -> str:
        """Label of the trace, as in `101.1.102 LocalPose.x`."""
        return f"{self.component} {self.query.NAME.removeprefix('Query')}.{self.path}"

    def shown(self, conventions: Conventions) -> tuple[float, str]:
        """Factor and unit with which the values are shown."""
        return conventions.plotted(self.query.NAME.removeprefix("Query"), self.path, self.unit)

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
            raise ConfigError(sentence("a rate of {rate:g} Hz is outside 0..{most:g} Hz", rate=rate, most=MAX_RATE))
        source = (component.id, query.NAME)
        same = next((trace for trace in self._of(source) if trace.path == path), None)
        if same is None and len(self.traces) >= MAX_TRACES:
            raise ConfigError(sentence("at most {most} traces are shown; remove one first", most=MAX_TRACES))
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
        """Delete all values, and continue recording."""
        for trace in self.traces.values():
            trace.samples.clear()

    def close(self) -> None:
        """End all subscriptions. May be called twice."""
        for source in list(self._tasks):
            self._end(source)

    def csv(self, axes: str = JAUS) -> str:
        """All values as CSV: one line for each time at which a report came, one column for each trace; SI units.

        Axes and sense of angles are those of JAUS, as in the reports, or of REP-103.
        """
        conventions = Conventions()
        conventions.set({"axes": axes, "angle": RADIANS})
        traces = list(self.traces.values())
        rows: dict[float, dict[int, float]] = {}
        for trace in traces:
            for moment, value in trace.samples:
                rows.setdefault(moment, {})[trace.number] = value * trace.shown(conventions)[0]
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(["time"] + [f"{trace.name} [{trace.unit}]" if trace.unit else trace.name for trace in traces])
        for moment in sorted(rows):
            stamp = datetime.fromtimestamp(moment, UTC).isoformat(timespec="milliseconds")
            writer.writerow([stamp] + [rows[moment].get(trace.number, "") for trace in traces])
        return text.getvalue()

    def _of(self, source: Source) -> list[Trace]:
        return [trace for trace in self.traces.values() if (trace.component, trace.query.NAME) == source]

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
        moment, values = self._now(), numbers_of(report)
        for trace in self._of(source):
            value = values.get(trace.path)
            trace.problem = "" if value is not None else sentence("the last report has no such field")
            if value is not None:
                trace.add(moment, value)


UPDATE_INTERVAL: Final = 0.25
"""Seconds between two updates of the chart."""
DEFAULT_RATE: Final = 10.0
SPANS: Final = {30: sentence("30 s"), 120: sentence("2 min"), 0: sentence("all")}
"""Seconds that the chart shows; 0 is all recorded values."""


class PlotsPanel:
    """The choice of fields, the chart and its buttons, for one page."""

    def __init__(self, ocu: OCU, conventions: Conventions) -> None:
        self.recorder = Recorder(ocu)
        self._conventions = conventions
        self._ocu = ocu
        self._components: dict[str, ComponentInfo] = {}
        self._queries: dict[str, Message] = {}
        self._fields: dict[str, Field] = {}
        self._sent: dict[int, int] = {}
        self._shown: dict[int, _Chip] = {}
        with ui.element("div").classes("choice"):
            self._component = _select(_("component"), self._choose_component).classes("wide named")
            self._message = _select(_("message"), self._choose_message).classes("wide")
            self._field = _select(_("fields"), lambda: None, multiple=True).classes("wide")
            self._rate = (
                ui.number("Hz", value=DEFAULT_RATE, min=0.1, max=MAX_RATE).props("dense outlined").classes("short")
            )
            self._add = ui.button(_("add"), on_click=self._add_traces).props("unelevated no-caps")
        self._problem = ui.label("").classes("problem")
        self._chips = ui.element("div").classes("chips")
        self._chart = ui.echart({"series": []}).classes("chart")
        with ui.element("div").classes("row"):
            self._span = ui.toggle({span: translated(label) for span, label in SPANS.items()}, value=30).props(
                "no-caps dense unelevated"
            )
            self._axes = ui.label("").classes("hint grow")
            self._pause = ui.button(_("pause"), on_click=self._toggle).props("outline no-caps")
            ui.button(_("clear"), on_click=self._clear).props("outline no-caps")
            ui.button("CSV", on_click=self._download).props("outline no-caps")
        self._paused = False
        conventions.on_change.append(self._show_conventions)
        self._show_axes()
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Offer the components of this robot; traces of others stay."""
        components = robot.components if robot is not None else ()
        self._components = {str(component.id): component for component in components if queries_of(component, registry)}
        self._component.set_options(
            {id: f"{id}  {printable(component.name)}" for id, component in self._components.items()},
            value=next(iter(self._components), None),
        )

    def close(self) -> None:
        """Handle the end of the page."""
        self.recorder.close()

    # --- choosing ---------------------------------------------------------------------------------------------------

    def _choose_component(self) -> None:
        component = self._components.get(str(self._component.value))
        self._queries = queries_of(component, registry) if component is not None else {}
        self._message.set_options({name: name.removeprefix("Query") for name in self._queries}, value=None)
        self._field.set_options([], value=[])

    async def _choose_message(self) -> None:
        """Query the report once: its fields are what this component reports."""
        query = self._queries.get(str(self._message.value))
        component = self._component.value
        self._field.set_options([], value=[])
        self._problem.set_text("")
        if query is None:
            return
        try:
            report = await self._ocu.query(component, query)
        except JausError as error:
            self._problem.set_text(translated(str(error)))
            return
        if (component, query.NAME) != (self._component.value, self._message.value):
            return  # another one was chosen meanwhile
        self._fields = {field.path: field for field in fields_of(report) if field.number is not None}
        self._field.set_options(
            {path: self._option(query.NAME, path, field) for path, field in self._fields.items()}, value=[]
        )
        if not self._fields:
            self._problem.set_text(_("{name} has no numbers now", name=report.NAME))

    def _option(self, query: str, path: str, field: Field) -> str:
        """A field with its present value, as the plot would show it."""
        factor, unit = self._conventions.plotted(query.removeprefix("Query"), path, field.unit)
        text = field.text if factor == 1.0 or field.number is None else f"{field.number * factor + 0.0:.6g}"
        return f"{path}  = {text} {unit}".rstrip()

    def _show_axes(self) -> None:
        self._axes.set_text(_("wheel: zoom, drag: move; {axes_text}", axes_text=self._conventions.axes_text))

    def _show_conventions(self) -> None:
        """Draw all anew, in other axes or units."""
        self._show_axes()
        self._sent = {}
        call("jauspy.clearPlot", self._chart.id)

    def _add_traces(self) -> None:
        component, query = self._components.get(str(self._component.value)), self._queries.get(str(self._message.value))
        paths = self._field.value or []
        if component is None or query is None or not paths:
            self._problem.set_text(_("choose a component, a message and one or several fields"))
            return
        self._problem.set_text("")
        try:
            for path in paths:
                self.recorder.add(component, query, path, self._fields[path].unit, float(self._rate.value or 0.0))
        except JausError as error:
            self._problem.set_text(translated(str(error)))

    # --- showing ----------------------------------------------------------------------------------------------------

    def _update(self) -> None:
        """Send the values that are new to the browser, which keeps as many as the recorder."""
        traces = list(self.recorder.traces.values())
        self._show_chips(traces)
        if traces or self._sent:
            parts = [self._part(trace) for trace in traces]
            self._sent = {trace.number: trace.total for trace in traces}
            span = int(self._span.value or 0)
            call("jauspy.plot", self._chart.id, parts, span, self._paused)

    def _part(self, trace: Trace) -> dict[str, object]:
        new = min(len(trace.samples), trace.total - self._sent.get(trace.number, 0))
        points = list(trace.samples)[-new:] if new else []
        factor, unit = trace.shown(self._conventions)
        return {
            "number": trace.number,
            "name": printable(trace.name),
            "unit": unit,
            "points": [[round(1e3 * moment), value * factor] for moment, value in points],
        }

    def _show_chips(self, traces: list[Trace]) -> None:
        """Add and remove what has changed; all else stays, so that a click on it is not lost."""
        for number in self._shown.keys() - self.recorder.traces.keys():
            self._shown.pop(number).element.delete()
        for place, trace in enumerate(traces):
            if trace.number not in self._shown:
                with self._chips:
                    self._shown[trace.number] = _Chip(trace, self.recorder)
            self._shown[trace.number].update(place)

    # --- buttons ----------------------------------------------------------------------------------------------------

    def _toggle(self) -> None:
        """Freeze the chart; recording continues."""
        self._paused = not self._paused
        self._pause.set_text(_("resume") if self._paused else _("pause"))

    def _clear(self) -> None:
        self.recorder.clear()
        call("jauspy.clearPlot", self._chart.id)

    def _download(self) -> None:
        ui.download.content(
            self.recorder.csv(self._conventions.axes),
            f"jauspy-{datetime.now().astimezone():%Y%m%d-%H%M%S}.csv",
            "text/csv",
        )


class _Chip:
    """The name of a trace, its problem, and the button that removes it."""

    def __init__(self, trace: Trace, recorder: Recorder) -> None:
        self._trace = trace
        with ui.element("div").classes("trace") as self.element:
            ui.label(printable(trace.name))
            self._problem = ui.label("").classes("problem")
            remove = ui.button("\u00d7", on_click=partial(recorder.remove, trace.number))
            attributes(remove.props("flat dense"), aria_label=_("remove"))

    def update(self, place: int) -> None:
        """Show the present problem, and the colour of this place in the chart."""
        attributes(self.element, data_place=place % 6)
        self._problem.set_text(printable(translated(self._trace.problem)))
        self._problem.set_visibility(bool(self._trace.problem))


def _select(label: str, on_change: Callable[[], object], *, multiple: bool = False) -> ui.select:
    return ui.select([], label=label, multiple=multiple, on_change=on_change).props("dense outlined options-dense")
