"""The tab Plots without a browser: what has not changed keeps its elements, so that no click on them is lost."""

from __future__ import annotations

from itertools import count
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from nicegui import Client, ui
from nicegui.page import page as make_page

from jauspy.console.conventions import Conventions
from jauspy.console.plots import PlotsPanel, Trace
from jauspy.ids import JausID
from jauspy.messages.core import QueryStatus

NUMBERS = count()


def panel_of(*paths: str) -> PlotsPanel:
    ocu: Any = SimpleNamespace()
    with Client(make_page(""), request=None):
        panel = PlotsPanel(ocu, Conventions())
    for path in paths:
        add(panel, path)
    update(panel)
    return panel


def update(panel: PlotsPanel) -> None:
    panel._show_chips(list(panel.recorder.traces.values()))


def add(panel: PlotsPanel, path: str) -> Trace:
    trace = Trace(next(NUMBERS), JausID(101, 1, 102), QueryStatus(), path, "m")
    panel.recorder.traces[trace.number] = trace
    return trace


def buttons(panel: PlotsPanel) -> list[ui.button]:
    return [element for element in panel._chips.descendants() if isinstance(element, ui.button)]


def texts(panel: PlotsPanel) -> list[list[str]]:
    """The colour of each trace, and its texts, as the page shows them."""
    return [
        [chip.props["data-place"], *(label.text for label in chip if isinstance(label, ui.label) and label.visible)]
        for chip in panel._chips
    ]


def name(path: str) -> str:
    return f"101.1.102 Status.{path}"


async def test_a_problem_that_comes_and_goes_replaces_no_button() -> None:
    panel = panel_of("x", "y", "z")
    first = buttons(panel)
    trace = list(panel.recorder.traces.values())[1]
    trace.problem = "it does not answer\n<b>"
    update(panel)
    assert texts(panel) == [[0, name("x")], [1, name("y"), "it does not answer\\n<b>"], [2, name("z")]]
    assert buttons(panel) == first
    trace.problem = ""
    update(panel)
    assert texts(panel) == [[0, name("x")], [1, name("y")], [2, name("z")]]
    assert buttons(panel) == first
    assert not any(button.is_deleted for button in first)


async def test_a_trace_that_comes_or_goes_leaves_the_others() -> None:
    panel = panel_of("x", "y", "z")
    first = buttons(panel)
    panel.recorder.remove(next(iter(panel.recorder.traces)))
    add(panel, "w")
    update(panel)
    assert texts(panel) == [[0, name("y")], [1, name("z")], [2, name("w")]], "with the colours of the chart"
    assert buttons(panel)[:2] == first[1:]
    assert first[0].is_deleted
