"""The command line in tests: verbs in this process or in one of their own, and robots that run beside them."""

from __future__ import annotations

import json
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.resources import files
from pathlib import Path
from typing import Any

import psutil
import pytest
from tests.helpers.ports import unused_port
from typer.testing import CliRunner, Result

from jauspy.cli import client
from jauspy.cli.main import app
from jauspy.sync.portal import Portal
from jauspy.testing import LocalNode

JAUSPY = [sys.executable, "-m", "jauspy.cli.main"]
ENDS_WITH_TESTS = ["setpriv", "--pdeathsig", "KILL"] if shutil.which("setpriv") else []
"""Of util-linux: the kernel ends the process when the one that started it is gone, also if that was killed."""


def jauspy(*arguments: str, status: int = 0) -> Result:
    """Run a verb in this process, which must exit with this status; `stdout` and `stderr` are in the result."""
    result = jauspy_in_process(*arguments)
    while client._claims:  # of the client's id, which a process holds until it ends
        client._claims.pop().close()
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    assert result.exit_code == status, result.stderr
    return result


def jauspy_in_process(*arguments: str) -> Result:
    """Run a verb in this process, however it ends."""
    return CliRunner(env={"COLUMNS": "80"}).invoke(app, arguments)


def start(*arguments: str, **options: Any) -> subprocess.Popen[str]:
    """Start a verb in a process of its own, whose output is piped; it ends with that of the tests."""
    command = [*ENDS_WITH_TESTS, *JAUSPY, *arguments]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)


@contextmanager
def stopped(process: subprocess.Popen[str]) -> Iterator[subprocess.Popen[str]]:
    """Interrupt it at the end, and kill it if it does not end by that."""
    try:
        yield process
    finally:
        process.send_signal(signal.SIGINT)
        try:
            process.communicate(timeout=30)
        finally:
            process.kill()
            process.communicate()


def wait_for(process: subprocess.Popen[str], text: str) -> list[psutil.Process]:
    """Read lines until one has `text`; returns the processes below it that run by then."""
    assert process.stdout is not None
    assert process.stderr is not None
    for line in process.stdout:
        if text in line:
            return psutil.Process(process.pid).children(recursive=True)
    pytest.fail(f"{text!r} was never printed: {process.stderr.read()}")


def assert_gone(processes: list[psutil.Process]) -> None:
    _, alive = psutil.wait_procs(processes, timeout=30)
    assert not alive


class RunningRobot:
    """A process `jauspy up`, with its node manager."""

    def __init__(self, port: int, root: Path, name: str = "inc1", *options: str, backend: str = "kinematic") -> None:
        self.port = port
        self.root = root
        self.local = f"local:{root}"
        self.udp = f"udp://127.0.0.1:{port}"
        where = ("--port", str(port), "--interface", "127.0.0.1", "--local-root", str(root))
        where += ("--record-to", str(root / "recordings"))
        self.family: list[psutil.Process] = []
        self.process = start("up", name, "--backend", backend, *where, *options)
        try:
            self.family = wait_for(self.process, "stop it")
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """End it in order, so that coverage of it is written."""
        try:
            self.process.terminate()
            self.process.communicate(timeout=20)
        finally:
            self.process.kill()
            self.process.communicate()
        assert_gone(self.family)


def with_few_pictures(folder: Path) -> str:
    """The file of an inc1 that sends few and small pictures: its cameras and a browser take turns on two cores."""
    cameras = [
        camera | {"size": [320, 240], "rate": 5}
        for camera in tomllib.loads((files("jauspy.robots") / "inc1.toml").read_text())["cameras"]
    ]
    path = folder / "inc1.toml"
    path.write_text(f'extends = "inc1"\nname = "inc1"\ncameras = {_toml(cameras)}\n')
    return str(path)


def _toml(value: object) -> str:
    """A value as TOML, without line breaks."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{name} = {_toml(part)}" for name, part in value.items()) + " }"
    if isinstance(value, list):
        return f"[{', '.join(map(_toml, value))}]"
    return json.dumps(value)


@contextmanager
def shared_robot(
    name: str = "inc1", *, backend: str = "kinematic", few_pictures: bool = False
) -> Iterator[RunningRobot]:
    """A process `jauspy up` for several tests, which leave it as they found it; port and folder are its own."""
    root = Path(tempfile.mkdtemp(prefix="jauspy-"))
    if few_pictures:
        name = with_few_pictures(root)
    try:
        robot = RunningRobot(unused_port(), root, name, backend=backend)
        try:
            yield robot
        finally:
            robot.close()
    finally:
        shutil.rmtree(root)


@contextmanager
def robot_in_thread(name: str = "inc1") -> Iterator[LocalNode]:
    """A robot and its node manager in threads of this process, for tests of verbs that need no `jauspy up`."""
    with LocalNode() as node, Portal("opens the robot") as portal:
        running = node.robot(name)
        portal.run(running.__aenter__())
        try:
            yield node
        finally:
            portal.run(running.__aexit__(None, None, None))


def camera_direction(robot: RunningRobot) -> tuple[float, float]:
    """Of the chassis camera of inc1, radians to the right and upwards, as the robot reports it."""
    process = start("query", "101.1.107", "QueryPanTiltJointPositions", "--connect", robot.local, "--id", "42.9.1")
    output, _ = process.communicate()
    right, up = (float(re.search(rf"joint{number}_position\D*?(-?[\d.]+(e-?\d+)?)", output)[1]) for number in (1, 2))
    return right, up
