"""A file author has a robot write its audit log into files of his victim; a thief of traces empties the log."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from jauspy.errors import ConfigError
from jauspy.robot import robot_files
from jauspy.robot.audit import AuditLog, head_file, verify
from jauspy.robot.config import RobotConfig
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime

VICTIM = "alias ll='ls -l'\n"
NAME = "$(id > PWNED)"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The folder of a robot, in the victim's home."""
    folder = tmp_path / "home" / "robot"
    (folder / "logs").mkdir(parents=True)
    (folder / "operators.toml").write_text("[operators]\n")
    for path in (folder.parent / ".bashrc", folder / "notes.txt", folder / ".profile"):
        path.write_text(VICTIM)
    (folder / "link").symlink_to("../.bashrc")
    (folder / "dangling").symlink_to("../.zshrc")
    (folder / "out").symlink_to("..")
    os.link(folder.parent / ".bashrc", folder / "other_name")
    os.mkfifo(folder / "pipe")
    (folder / "secret.head").symlink_to("../.bashrc")
    (folder / "taken.head").write_text(VICTIM)
    return folder


def _config(folder: Path, log: str) -> RobotConfig:
    keys = [f'name = "{NAME}"', 'extends = "inc1"', 'backend = "kinematic"', 'world = "empty"']
    (folder / "it.toml").write_text("\n".join([*keys, 'operators = "operators.toml"', f'audit_log = "{log}"']))
    return robot_files.load(folder / "it.toml")


def _start(folder: Path, log: str) -> None:
    config = _config(folder, log)
    assert config.audit_log is not None
    with AuditLog(Path(config.audit_log), config.name):
        pass


@pytest.mark.parametrize(
    "log",
    [
        *("../.bashrc", "../new", "{home}/.bashrc", "{home}/new", "logs/../../new", "out/new", "out/.bashrc", "link"),
        *("dangling", "notes.txt", ".profile", ".new", "logs/.new", "other_name", "pipe", "logs", ".", "/dev/null"),
        *("secret", "taken", "none/new", "it.toml", "operators.toml"),
    ],
)
def test_nothing_else_is_written(folder: Path, log: str) -> None:
    before = sorted(folder.parent.iterdir())
    with pytest.raises(ConfigError, match="audit_log") as caught:
        _start(folder, log.format(home=folder.parent))
    assert "\n" not in str(caught.value)
    assert [path.read_text() for path in (folder.parent / ".bashrc", folder / "notes.txt")] == [VICTIM] * 2
    assert sorted(folder.parent.iterdir()) == before
    assert NAME not in "".join(
        path.read_text() for path in folder.iterdir() if path.is_file() and path.suffix != ".toml"
    )


@pytest.mark.parametrize("log", ["new", "logs/new", "logs/../new"])
def test_a_log_below_the_folder_is_written_and_continued(folder: Path, log: str) -> None:
    _start(folder, log)
    _start(folder, log)
    report = verify(folder / log)
    assert (report.head.number, report.problem) == (4, "")


@pytest.mark.slow
async def test_the_user_may_name_any_file(folder: Path) -> None:
    chosen, mistake = folder.parent / "chosen", folder / "notes.txt"
    (folder.parent / "link").symlink_to(chosen)
    config = _config(folder, "new")
    async with VirtualNetwork() as network:
        async with RobotRunner(config, network.transport, realtime=VirtualTime, audit_log=folder.parent / "link"):
            pass
        assert verify(chosen).head.number == verify(folder.parent / "link").head.number == 2
        assert not (folder / "new").exists()
        with pytest.raises(ConfigError, match="is a file with something else"):
            await RobotRunner(config, network.transport, realtime=VirtualTime, audit_log=mistake).open()


async def test_an_audit_log_without_operators_is_refused(tmp_path: Path) -> None:
    async with VirtualNetwork() as network:
        for options in ({"audit_log": tmp_path / "log"}, {"audit_heads_to": "syslog://127.0.0.1"}):
            runner = RobotRunner(
                robot_files.load("inc1"), network.transport, backend="kinematic", realtime=VirtualTime, **options
            )
            with pytest.raises(ConfigError, match=r"an audit log needs operators|the robot has none"):
                await runner.open()


@pytest.fixture
def log(tmp_path: Path) -> Path:
    path = tmp_path / "log"
    with AuditLog(path, "inc1"):
        pass
    return path


def test_emptying_both_files_is_reported(log: Path) -> None:
    log.write_bytes(b"")
    head_file(log).write_bytes(b"")
    assert verify(log).problem.startswith("has no lines: all were removed")
    with AuditLog(log, "inc1"):
        pass
    assert "all lines before line 1 were removed" in verify(log).problem


@pytest.mark.parametrize("added", [b"\0", b"\0" * 70_000, b" ", b"\xff", b"{", b'{"n": 4, "time": "x'])
def test_bytes_at_the_end_are_reported(log: Path, added: bytes) -> None:
    with log.open("ab") as stream:
        stream.write(added)
    assert "line 3" in verify(log).problem or added == b"{"
    with AuditLog(log, "inc1"):
        pass
    assert verify(log).problem or added == b"{"
