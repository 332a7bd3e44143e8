"""What the demo shows while it runs."""

import io
import math
from types import SimpleNamespace

import pytest
from rich.console import Console

from jauspy.cli import console
from jauspy.demo.report import LiveView, StageResult, View


def test_plain_output_marks_results(capsys: pytest.CaptureFixture[str]) -> None:
    with View(console.print_lines) as view:
        view.step("Lift the can")
        view.add(StageResult("lift", "13 cm", reached=True))
        view.add(StageResult("look", "nothing red", reached=False))
    lines = capsys.readouterr().out
    assert "Lift the can" in lines
    assert "✓ lift: 13 cm" in lines
    assert "✗ look: nothing red" in lines
    assert "\x1b" not in lines


def test_table_shows_the_known_values() -> None:
    page = Console(file=io.StringIO(), width=120)
    view = LiveView(page)
    page.print(view.table())
    assert "robot" not in page.file.getvalue()
    state = view.state
    state.pose, state.width = (1.5, -0.25, math.pi / 2), 0.05
    state.moved([0.0, math.pi / 2])
    recording = SimpleNamespace(recorder=SimpleNamespace(pictures=77), camera=SimpleNamespace(counters={"lost": 3}))
    state.recordings["arm"] = recording
    page.print(view.table())
    shown = page.file.getvalue()
    for text in ("x +1.50 m  y -0.25 m  heading +90.0°", "+90.0°", "5.00 cm apart", "77 pictures, 3 packets lost"):
        assert text in shown


def test_end_message_tells_whether_control_was_released() -> None:
    view = View()
    assert view.end_message() == "stopped"
    view.state.controlled = True
    assert view.end_message() == "stopped; control was released"
