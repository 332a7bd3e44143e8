"""The tab Log without a browser: its filter, its pause, and the message that is opened."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from nicegui import Client, ui
from nicegui.page import page as make_page

from jauspy.console.panels.log import LogPanel
from jauspy.console.traffic import MAX_OF_KIND, Traffic
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import QueryStatus, ReportStatus

HERE, THERE = JausID.parse("42.1.1"), JausID.parse("101.1.102")


class Bench:
    """The panel as one page shows it, and the traffic that it lists."""

    def __init__(self, client: Client) -> None:
        self.traffic = Traffic(registry)
        with client:
            self.panel = LogPanel(self.traffic)
        self.panel.visible = True
        self.panel._routine.set_value(True)

    @property
    def names(self) -> list[str]:
        return [str(row["name"]) for row in self.panel._table.rows]

    def note(self, name: str, *, times: int = 1) -> None:
        for _ in range(times):
            if name == "ReportStatus":
                self.traffic.note(THERE, HERE, ReportStatus(1, 0).encode(), sent=False)
            else:
                self.traffic.note(HERE, THERE, QueryStatus().encode(), sent=True)

    def choose(self, number: object) -> str:
        """Click on the row of this line; returns the title of what is opened."""
        self.panel._choose(SimpleNamespace(args=number))
        return self.panel._title.text


@pytest.fixture
async def bench() -> Bench:
    return Bench(Client(make_page(""), request=None))


async def test_what_is_typed_filters_at_once_so_that_a_pause_keeps_what_is_filtered(bench: Bench) -> None:
    bench.note("ReportStatus")
    bench.note("QueryStatus")
    bench.panel._update()
    assert bench.names == ["QueryStatus", "ReportStatus"]
    bench.panel._words.set_value("reportstatus")
    bench.panel._toggle()
    assert bench.names == ["ReportStatus"]


async def test_a_paused_list_is_filtered_and_gets_nothing_new(bench: Bench) -> None:
    bench.note("ReportStatus")
    bench.panel._toggle()
    bench.note("QueryStatus")
    bench.panel._update()
    assert bench.names == ["ReportStatus"]
    bench.panel._words.set_value("querystatus")
    assert bench.names == []
    bench.panel._words.set_value("")
    assert bench.names == ["ReportStatus"]
    bench.panel._toggle()
    assert bench.names == ["QueryStatus", "ReportStatus"]


async def test_a_line_that_is_shown_opens_also_when_the_traffic_keeps_it_no_longer(bench: Bench) -> None:
    bench.note("ReportStatus")
    bench.panel._update()
    bench.panel._toggle()
    shown = bench.panel._table.rows[0]["number"]
    bench.note("ReportStatus", times=2 * MAX_OF_KIND)
    assert bench.choose(shown).endswith("ReportStatus")
    texts = [each.text for each in bench.panel._fields.descendants() if isinstance(each, ui.label)]
    assert any("READY" in each.upper() for each in texts), texts


@pytest.mark.parametrize("number", ["0", None, -1, 10**9, [0], 1.5])
async def test_a_click_on_no_line_says_so(bench: Bench, number: object) -> None:
    bench.note("ReportStatus")
    assert bench.choose(number) == "this line is no longer kept"
