"""The tab Log: messages, refusals and events, with a filter, and the fields of one message."""

from __future__ import annotations

import re
from typing import Any, Final

from nicegui import ui

from jauspy.console.languages import sentence
from jauspy.console.markup import breakable
from jauspy.console.page_language import _, translated
from jauspy.console.reports import fields_of
from jauspy.console.traffic import Line, Traffic
from jauspy.printable import printable

UPDATE_INTERVAL: Final = 0.5
MAX_ROWS: Final = 200
MAX_HEX: Final = 256
"""Bytes of a message that are shown as hex text."""
KINDS: Final = {
    "": sentence("all"),
    "sent received": sentence("messages"),
    "refused": sentence("refusals"),
    "event": sentence("events"),
}
_SIGNS: Final = {"sent": "\u2192", "received": "\u2190", "refused": "\u2716", "event": "\u2022"}
_COLUMNS: Final = [
    {"name": name, "label": label, "field": name, "align": "left"}
    for name, label in (
        ("time", sentence("time")),
        ("sign", ""),
        ("source", sentence("from")),
        ("destination", sentence("to")),
        ("user", sentence("user")),
        ("name", sentence("message or event")),
        ("size", sentence("bytes")),
    )
]


class LogPanel:
    """The filter, the list and the details, for one page."""

    def __init__(self, traffic: Traffic) -> None:
        self._traffic = traffic
        self._shown: tuple[object, ...] = ()
        self._lines: dict[int, Line] = {}
        """The lines of the list, which can be opened also when the traffic keeps them no longer."""
        self._paused_at: int | None = None
        """The number of lines when the list was paused; None while it follows the traffic."""
        self.visible = False
        """Set by the page; the list is sent only while it is shown."""
        with ui.element("div").classes("choice"):
            self._words = ui.input(_("filter"), placeholder=_("words; -word leaves out"), on_change=self._update)
            self._words.props("dense outlined clearable").classes("wide")
            self._kind = ui.toggle(
                {kind: translated(label) for kind, label in KINDS.items()}, value="", on_change=self._update
            ).props("no-caps dense unelevated")
            self._routine = ui.checkbox(_("routine"), on_change=self._update).props("dense")
            self._pause = ui.button(_("pause"), on_click=self._toggle).props("outline no-caps")
        with ui.element("div").classes("split"):
            self._table = (
                ui.table(
                    columns=[{**column, "label": translated(column["label"])} for column in _COLUMNS],
                    rows=[],
                    row_key="number",
                )
                .classes("traffic")
                .props('dense flat hide-bottom :rows-per-page-options="[0]"')
                .on("row-click", self._choose, js_handler="(event, row) => emit(row.number)")
            )
            with ui.element("div").classes("details"):
                self._title = ui.label(_("click a message for its fields")).classes("hint")
                self._fields = ui.element("div").classes("fields")
                self._hex = ui.label("").classes("hex")
        self._count = ui.label("").classes("hint")
        ui.timer(UPDATE_INTERVAL, self._update)

    def _update(self) -> None:
        if not self.visible:
            return
        total = self._traffic.total if self._paused_at is None else self._paused_at
        wanted = (total, self._words.value, self._kind.value, self._routine.value)
        if wanted == self._shown:
            return
        self._shown = wanted
        words, routine = str(self._words.value or ""), bool(self._routine.value)
        kind = str(self._kind.value or "")
        lines = self._traffic.lines(words, kind, routine=routine, limit=MAX_ROWS, total=total)
        self._lines = {line.number: line for line in lines}
        rows = [_row(line) for line in lines]
        if rows != self._table.rows:
            self._table.rows = rows
        self._count.set_text(
            _(
                "{count} newest shown of {total} so far; the latest 200 of each kind are kept",
                count=len(lines),
                total=total,
            )
        )

    def _toggle(self) -> None:
        """Keep what comes from now on out of the list, or let it in again; the filter works in both cases."""
        self._paused_at = self._traffic.total if self._paused_at is None else None
        self._pause.set_text(_("pause") if self._paused_at is None else _("resume"))
        self._update()

    def _choose(self, event: Any) -> None:
        number = event.args if isinstance(event.args, int) else -1
        line = self._lines.get(number) or self._traffic.find(number)
        self._fields.clear()
        self._hex.set_text("")
        if line is None:
            self._title.set_text(_("this line is no longer kept"))
            return
        self._title.set_text(f"{line.time:%H:%M:%S.%f}"[:-3] + f"  {printable(line.name) if line.size else ''}")
        decoded = self._traffic.decoded(line)
        with self._fields:
            if isinstance(decoded, str):
                ui.label(printable(decoded)).classes("whole")
            else:
                for field in fields_of(decoded):
                    breakable(_path(field.path)).classes("path")
                    ui.label(f"{printable(field.text)} {field.unit}".rstrip()).classes("value")
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
