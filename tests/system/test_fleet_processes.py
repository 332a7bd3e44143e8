"""The part of the fleet's benchmark that starts real processes, with few robots."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

pytestmark = [pytest.mark.slow, pytest.mark.alone]

BENCH = Path(__file__).parents[2] / "tools" / "bench" / "fleet.py"
COMMAND = (sys.executable, str(BENCH), "--robots", "--processes", "2", "--per-node-manager", "1", "--seconds", "3")


def test_robots_are_discovered_controlled_driven_and_released(tmp_path: Path) -> None:
    file = tmp_path / "fleet.json"
    output = subprocess.run([*COMMAND, "--json", str(file)], capture_output=True, text=True, check=True, timeout=280)
    (row,) = json.loads(file.read_text())
    assert row["failures"] == []
    done = [row[what] for what in ("started", "discovered", "controlled", "driven", "released")]
    assert done == [2] * 5
    assert row["node_managers"] == 3, "one of each robot, and one of the operator"
    assert row["events"] > 0
    assert len(row["latencies"]) == 2
    assert row["memory"] > 0
    assert row["idle_cpu"] > 0
    assert min(row["cpu"].values()) > 0
    assert "all started, were discovered, controlled, drove and were released" in output.stdout
    assert "projection" in output.stdout


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_no_process_is_left_when_it_is_stopped(number: signal.Signals, tmp_path: Path) -> None:
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    with subprocess.Popen(COMMAND, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment) as bench:
        while not (robots := [each for each in children_of(bench) if "inc1" in each.cmdline()]):
            assert bench.poll() is None
            time.sleep(0.1)
        everything = children_of(bench)
        bench.send_signal(number)
        assert bench.wait(120) != 0
    gone, alive = psutil.wait_procs(everything, timeout=60)
    for process in alive:
        process.kill()
    assert not alive
    assert set(robots) <= set(gone)
    if number != signal.SIGKILL:
        assert list(tmp_path.glob("jauspy-*")) == []


def children_of(bench: subprocess.Popen[bytes]) -> list[psutil.Process]:
    return psutil.Process(bench.pid).children(recursive=True)
