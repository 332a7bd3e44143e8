"""The tab Log: messages, refusals and events, with a filter, and the fields of one message."""

from __future__ import annotations

import re
from typing import Any, Final

from nicegui import ui

from jauspy.console.markup import breakable
from jauspy.console.reports import fields_of
from jauspy.console.traffic import Line, Traffic
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.5
MAX_ROWS: Final = 200
MAX_HEX: Final = 256
"""Bytes of a message that are shown as hex text."""
KINDS: Final = {"": "all", "sent received": "messages", "refused": "refusals", "event": "events"}
_SIGNS: Final = {"sent": "\u2192", "received": "\u2190", "refused": "\u2716", "event": "\u2022"}
_COLUMNS: Final = [
    {"name": name, "label": label, "field": name, "align": "left"}
    for name, label in (
        ("time", "time"),
        ("sign", ""),
        ("source", "from"),
        ("destination", "to"),
        ("user", "user"),
        ("name", "message or event"),
        ("size", "bytes"),
    )
]


class LogPanel:
    """The filter, the list and the details, for one page."""

    def __init__(self, traffic: Traffic) -> None:
        self._traffic = traffic
        self._shown: tuple[object, ...] = ()
        self._paused = False
        self.visible = False
        """Set by the page; the list is sent only while it is shown."""
        with ui.element("div").classes("choice"):
            self._words = ui.input("filter", placeholder="words; -word leaves out").props("dense outlined clearable")
            self._words.classes("wide")
            self._kind = ui.toggle(KINDS, value="").props("no-caps dense unelevated")
            self._routine = ui.checkbox("routine").props("dense")
            self._pause = ui.button("pause", on_click=self._toggle).props("outline no-caps")
        with ui.element("div").classes("split"):
            self._table = (
                ui.table(columns=_COLUMNS, rows=[], row_key="number")
                .classes("traffic")
                .props('dense flat hide-bottom :rows-per-page-options="[0]"')
                .on("row-click", self._choose, js_handler="(event, row) => emit(row.number)")
            )
            with ui.element("div").classes("details"):
                self._title = ui.label("click a message for its fields").classes("hint")
                self._fields = ui.element("div").classes("fields")
                self._hex = ui.label("").classes("hex")
        self._count = ui.label("").classes("hint")
        ui.timer(UPDATE_INTERVAL, self._update)

    def _update(self) -> None:
        if self._paused or not self.visible:
            return
        wanted = (self._traffic.total, self._words.value, self._kind.value, self._routine.value)
        if wanted == self._shown:
            return
        self._shown = wanted
        words, routine = str(self._words.value or ""), bool(self._routine.value)
        lines = self._traffic.lines(words, str(self._kind.value or ""), routine=routine, limit=MAX_ROWS)
        rows = [_row(each) for each in lines]
        if rows != self._table.rows:
            self._table.rows = rows
        self._count.set_text(
            f"{len(lines)} newest shown of {self._traffic.total} so far; the latest 200 of each kind are kept"
        )

    def _toggle(self) -> None:
        self._paused = not self._paused
        self._pause.set_text("resume" if self._paused else "pause")

    def _choose(self, event: Any) -> None:
        line = self._traffic.find(event.args) if isinstance(event.args, int) else None
        self._fields.clear()
        self._hex.set_text("")
        if line is None:
            self._title.set_text("this line is no longer kept")
            return
        self._title.set_text(f"{line.time:%H:%M:%S.%f}"[:-3] + f"  {printable(line.name) if line.size else ''}")
        decoded = self._traffic.decoded(line)
        with self._fields:
            if isinstance(decoded, str):
                ui.label(printable(decoded)).classes("whole")
            else:
                for each in fields_of(decoded):
                    breakable(_path(each.path)).classes("path")
                    ui.label(f"{printable(each.text)} {each.unit}".rstrip()).classes("value")
        more = " \u2026" if len(line.payload) > MAX_HEX else ""
        self._hex.set_text(line.payload[:MAX_HEX].hex(" ") + more)


def _path(path: str) -> list[str]:
    """The path of a field in parts after which a line may end."""
    return re.split(r"(?<=[._\]])", path.removeprefix("report_message."))


def _row(line: Line) -> dict[str, object]:
    return {
        "number": line.number,
        "time": f"{line.time:%H:%M:%S.%f}"[:-3],
        "sign": _SIGNS[line.kind],
        "source": line.source,
        "destination": line.destination,
        "user": line.user,
        "name": printable(line.name),
        "size": line.size or "",
    }
