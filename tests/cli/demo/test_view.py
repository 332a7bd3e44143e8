"""What the demo shows while it runs."""

import io
import math
from types import SimpleNamespace

import pytest
from rich.console import Console

from jauspy.cli.demo.report import LiveView, StageResult, View


def test_plain_lines_are_marked(capsys: pytest.CaptureFixture[str]) -> None:
    with View() as view:
        view.step("Lift the can")
        view.found(StageResult("lift", "13 cm", reached=True))
        view.found(StageResult("look", "nothing red", reached=False))
    said = capsys.readouterr().out
    assert "Lift the can" in said
    assert "✓ lift: 13 cm" in said
    assert "✗ look: nothing red" in said
    assert "\x1b" not in said


def test_the_table_has_what_is_known_so_far() -> None:
    view, page = LiveView(), Console(file=io.StringIO(), width=120)
    page.print(view.table())
    assert "robot" not in page.file.getvalue()
    scene = view.scene
    scene.pose, scene.finger = (1.5, -0.25, math.pi / 2), 0.025
    scene.moved([0.0, math.pi / 2])
    film = SimpleNamespace(recorder=SimpleNamespace(pictures=77), receiver=SimpleNamespace(counters={"lost": 3}))
    scene.films["arm"] = film
    page.print(view.table())
    shown = page.file.getvalue()
    for text in ("x +1.50 m  y -0.25 m  heading +90.0°", "+90.0°", "5.00 cm apart", "77 pictures, 3 packets lost"):
        assert text in shown


def test_who_stops_it_is_told_whether_control_was_given_back() -> None:
    view = View()
    assert view.farewell() == "stopped"
    view.scene.controlled = True
    assert view.farewell() == "stopped; control was given back"
