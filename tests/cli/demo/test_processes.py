"""Checks before the demo starts processes, and the output of the robot's process."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli import demo as processes
from jauspy.cli.demo import RobotOutput, _whole_tour
from jauspy.cli.main import app
from jauspy.errors import ConfigError, RequestError
from jauspy.platform.frame_sizes import FrameSize

SIZE = FrameSize.VGA_640_X480


def test_missing_package_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(processes, "find_spec", lambda name: None if name in ("av", "matplotlib") else object())
    with pytest.raises(ConfigError, match=r"needs PyAV, matplotlib: pip install 'jauspy\[all\]'; --backend kinematic"):
        _whole_tour(tmp_path, SIZE)


def test_file_in_place_of_the_output_folder_is_an_error(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(processes, "find_spec", lambda _: object())
    (tmp_path / "out").touch()
    with pytest.raises(ConfigError, match=r"out: cannot be created: File exists; choose another"):
        _whole_tour(tmp_path / "out", SIZE)


def test_unsupported_size_error_lists_the_sizes() -> None:
    done = CliRunner().invoke(app, ["demo", "--size", "641x480"])
    assert done.exit_code == 2
    assert "640x480" in done.stderr


async def test_robot_process_counters_are_read() -> None:
    output = RobotOutput()
    for line in ("counters of inc1:", "  101.1.102.endpoint.sent  7", "  realtime.late    3", "  realtime.steps  120"):
        output.line(line)
    assert await output.counters() == {"realtime.late": 3, "realtime.steps": 120}


async def test_missing_counters_raise_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(processes, "COUNTERS_TIMEOUT", 0.1)
    with pytest.raises(RequestError, match="does not print its counters"):
        await RobotOutput().counters()
