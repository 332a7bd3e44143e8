"""`jauspy up --also` and `jauspy follow`: two robots of one process, one behind the other."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.helpers.command_line import JAUSPY

pytestmark = pytest.mark.alone


@pytest.mark.slow
def test_a_robot_follows_the_other_of_one_up(free_port: int, root: Path, start: Callable[..., object]) -> None:
    local = str(root / "local")
    start(
        *("up", "inc1", "--also", "inc1", "--backend", "kinematic", "--local-root", local, "--port", str(free_port)),
        *("--address", "127.0.0.1", "--plain"),
        ready="stop it",
    )
    connect = ["--connect", f"local:{local}"]
    follow = subprocess.Popen(
        [*JAUSPY, "follow", "102", "101", "--gap", "1.5", "--json", *connect, "--id", "42.7.1"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        assert follow.stdout is not None
        first = json.loads(follow.stdout.readline())
        assert (first["robot"], first["leader"]) == (102, "101.1.102")
        drive = ["send", "101.1.102", "SetWrenchEffort", "propulsive_linear_effort_x=40", "--control", "200"]
        done = subprocess.run(
            [*JAUSPY, *drive, "--hold", "3", *connect, "--id", "42.7.2"], check=False, timeout=60, capture_output=True
        )
        assert done.returncode == 0, done.stderr
        rows = [json.loads(follow.stdout.readline()) for _ in range(4)]
        assert rows[-1]["distance"] == pytest.approx(1.5, abs=0.4)
    finally:
        follow.terminate()
        follow.communicate(timeout=20)
