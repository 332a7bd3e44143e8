"""What the demo says before it starts anything, and what it hears of the robot's process."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.cli import demo as processes
from jauspy.cli.demo import RobotOutput, _whole_tour
from jauspy.cli.main import app
from jauspy.errors import ConfigError, RequestError
from jauspy.services.environment_sensing.frame_sizes import FrameSize

SIZE = FrameSize.VGA_640_X480


def test_what_is_not_installed_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(processes, "find_spec", lambda name: None if name in ("av", "matplotlib") else object())
    with pytest.raises(ConfigError, match=r"needs PyAV, matplotlib: pip install 'jauspy\[all\]'; --backend kinematic"):
        _whole_tour(tmp_path, SIZE)


def test_a_file_in_place_of_the_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(processes, "find_spec", lambda _: object())
    (tmp_path / "out").touch()
    with pytest.raises(ConfigError, match=r"out: cannot be made: File exists; name another folder with --output"):
        _whole_tour(tmp_path / "out", SIZE)


def test_a_size_that_no_camera_has_lists_those_there_are() -> None:
    done = CliRunner().invoke(app, ["demo", "--size", "641x480"])
    assert done.exit_code == 2
    assert "640x480" in done.stderr


async def test_the_robot_tells_how_it_kept_time() -> None:
    heard = RobotOutput()
    for line in ("counters of inc1:", "  101.1.102.endpoint.sent  7", "  realtime.late    3", "  realtime.steps  120"):
        heard.line(line)
    assert await heard.counters() == {"realtime.late": 3, "realtime.steps": 120}


async def test_a_robot_that_does_not_tell_is_no_riddle(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(processes, "COUNTED", 0.1)
    with pytest.raises(RequestError, match="does not tell its counters"):
        await RobotOutput().counters()
