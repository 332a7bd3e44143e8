"""`jauspy up ROBOT --console`: one command, two processes, one end."""

from __future__ import annotations

import re
import signal
import socket
from pathlib import Path

import pytest
from tests.helpers.command_line import assert_gone, start, wait_for
from tests.helpers.console_visit import visit
from tests.helpers.ports import unused_port

from jauspy.cli import beside
from jauspy.errors import ConfigError


async def test_a_missing_extra_is_reported_before_anything_starts(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(beside, "find_spec", lambda _: None)
    with pytest.raises(ConfigError, match=r"pip install 'jauspy\[console\]'"):
        async with beside.console_beside(tmp_path, 0, 101):
            pass


def up(tmp_path: Path, console_port: int) -> tuple[str, ...]:
    where = ("--port", str(unused_port()), "--interface", "127.0.0.1", "--local-root", str(tmp_path / "root"))
    return ("up", "inc1", "--backend", "kinematic", *where, "--console", "--console-port", str(console_port))


@pytest.mark.slow
def test_the_console_starts_and_ends_with_the_robot(tmp_path: Path) -> None:
    pytest.importorskip("nicegui", reason="needs the extra 'console'")
    process = start(*up(tmp_path, 0))
    assert process.stdout is not None
    lines = iter(process.stdout.readline, "")
    found = (re.match(r"console: +(http://127\.0\.0\.1:\d+/\?token=\S+)$", line) for line in lines)
    url = next(each[1] for each in found if each)
    family = wait_for(process, "stop it")
    assert "data-token=" in visit(url).get()
    assert len(family) == 3, "the node manager, the console and its watchdog"
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=30)
    assert_gone(family)


@pytest.mark.slow
def test_a_port_that_is_taken_is_reported(tmp_path: Path) -> None:
    pytest.importorskip("nicegui", reason="needs the extra 'console'")
    with socket.create_server(("127.0.0.1", 0)) as taken:
        process = start(*up(tmp_path, taken.getsockname()[1]))
        _, said = process.communicate(timeout=60)
    assert process.returncode == 1
    assert "choose another one with --console-port" in said.replace("\n", " ")
