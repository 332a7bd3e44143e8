"""The arrangement of the views: presets, changes, and what a browser sends as one."""

from __future__ import annotations

import json
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="the console needs the extra `console`")

from nicegui import Client, ui
from nicegui.page import page as make_page

from jauspy.console.arrangement import MAX_PANES, MIN_SHARE, PRESETS, Arrangement, arrangement_of
from jauspy.console.panels.desk import Desk

VIEWS = ("Video", "World", "Trajectory", "Tasks", "Plots", "Log", "Events")
FULL = Arrangement(columns=[["Video", "Plots"], ["World", "Events"]])


def test_presets_are_kept_by_the_browser_and_come_back() -> None:
    for preset in PRESETS.values():
        assert arrangement_of(preset.text(), VIEWS) == preset


def test_views_change_places_come_and_go() -> None:
    assert FULL.swapped("Video", "Events").columns == [["Events", "Plots"], ["World", "Video"]]
    assert FULL.moved("Events").columns == [["Events", "Plots"], ["World", "Video"]], "after the last comes the first"
    assert FULL.moved("Log") == FULL
    assert FULL.replaced("Plots", "Log").columns == [["Video", "Log"], ["World", "Events"]]
    assert FULL.replaced("Plots", "World").columns == [["Video", "World"], ["Plots", "Events"]]
    assert FULL.added("Log").columns == [["Video", "Plots"], ["World", "Log"]], "there is no more room"
    assert FULL.added("Plots") == FULL
    assert FULL.without("World").without("Events").columns == [["Video", "Plots"]]
    arrangement = Arrangement()
    for view in VIEWS:
        arrangement = arrangement.added(view)
    assert [len(column) for column in arrangement.columns] == [MAX_PANES] * MAX_PANES
    assert FULL.offered({"Video", "Events"}) == [["Video"], ["Events"]]
    assert FULL.offered({"World"}) == [["World"]]


def test_sizes_stay_within_the_window() -> None:
    assert FULL.resized("width", 0.3).width == 0.3
    assert FULL.resized("width", -7.0).width == MIN_SHARE
    assert FULL.resized("left", 2.0).heights == (1.0 - MIN_SHARE, FULL.heights[1])
    assert FULL.resized("right", 0.4).heights == (FULL.heights[0], 0.4)


def test_panels_are_put_away_once() -> None:
    away = FULL.put_away("Drive", away=True).put_away("Drive", away=True)
    assert away.away == ["Drive"]
    assert away.put_away("Drive", away=False) == FULL


def test_what_is_no_arrangement_is_refused() -> None:
    good = json.loads(FULL.text())
    for change in (
        {"columns": [["Video"], ["Video"]]},
        {"columns": [["Secrets"]]},
        {"columns": [["Video"] * 3]},
        {"columns": [[]]},
        {"columns": [["Video"]] * 3},
        {"columns": [["<img src=x>"]]},
        {"width": 0.0},
        {"width": "wide"},
        {"heights": [0.5]},
        {"world": "moon"},
        {"away": ["Drive"] * 17},
        {"away": [":onclick"]},
        {"more": 1},
    ):
        assert arrangement_of(json.dumps({**good, **change}), VIEWS) is None, change
    for text in (
        "",
        "[]",
        "null",
        "NaN",
        "{",
        "[" * 900,
        '{"width": 1e999}',
        "x" * 5000,
        None,
        3,
        b"{}",
        {"width": 0.5},
    ):
        assert arrangement_of(text, VIEWS) is None


def test_events_of_a_browser_that_are_none_change_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    kept: list[str] = []
    monkeypatch.setattr("jauspy.console.panels.desk.call", lambda _, text: kept.append(text))

    def send(desk: Desk, asked: object) -> None:
        event: Any = SimpleNamespace(args=asked)
        desk._take(event)

    with Client(make_page(""), request=None):
        desk = Desk(ui.element("main"), lambda: None)
        with desk.frame():
            for view in VIEWS:
                with desk.pane(view):
                    pass
        send(desk, {"kept": FULL.text()})
        assert desk.arrangement == FULL
        for asked in (
            None,
            [],
            "width",
            {"preset": 9},
            {"preset": "1"},
            {"split": ["width"], "share": 0.5},
            {"split": "width", "share": float("nan")},
            {"split": "width", "share": [0.5]},
            {"move": {}, "to": []},
            {"move": "Video", "to": "Secrets"},
            {"kept": FULL.text() + "x"},
            {"used": {}},
        ):
            send(desk, asked)
            assert desk.arrangement == FULL, asked
        send(desk, {"move": "Video", "to": "World"})
        assert desk.arrangement == FULL.swapped("Video", "World")
    assert kept == [FULL.text(), FULL.swapped("Video", "World").text()]
