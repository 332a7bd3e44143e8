"""The summary of the demo."""

import io
import json
from pathlib import Path

from rich.console import Console

from jauspy.demo.report import Report, StageResult

DRIVE = StageResult("drive", "2 m, 3.0 cm off", True, {"distance_error": 0.03})
TIME = StageResult("real time", "99.0 % held", None, {"held": 0.99})
LIFT = StageResult("lift", "0.1 cm", False, {"lifted": 0.001})


def shown(report: Report) -> str:
    page = Console(file=io.StringIO(), width=100)
    page.print(report.panel("demo_out"))
    return page.file.getvalue()


def test_report_is_successful_if_all_goals_are_reached(tmp_path: Path) -> None:
    report = Report([DRIVE, TIME], ["map.pgm"])
    report.save(tmp_path)
    assert report.reached
    text = shown(report)
    assert "all goals were reached" in text
    assert "✓  drive" in text
    assert "demo_out/: map.pgm" in text
    saved = json.loads((tmp_path / "summary.json").read_text())
    assert saved["reached"] is True
    assert saved["results"][0]["figures"] == {"distance_error": 0.03}


def test_report_fails_if_one_goal_is_not_reached() -> None:
    report = Report([DRIVE, LIFT, TIME])
    assert not report.reached
    assert "not all goals were reached" in shown(report)
    assert "✗  lift" in shown(report)


def test_a_reduced_goal_is_no_plain_success(tmp_path: Path) -> None:
    video = StageResult("arm video", "50 pictures (5.0 of 15 Hz)", True, {"rate": 5.0}, reduced=True)
    report = Report([DRIVE, video])
    report.save(tmp_path)
    assert report.reached
    text = shown(report)
    assert "all goals were reached" not in text
    assert "the goals were reached, 1 reduced: this machine is too slow" in text
    assert "~  arm video" in text
    assert json.loads((tmp_path / "summary.json").read_text())["results"][1]["reduced"] is True
    assert Report([video, LIFT]).verdict == "not all goals were reached"
