"""Simulated drives in one process and the robot in another one, on a multicast bus; the robot is killed or stopped."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

ROBOT_FILE = """
extends = "inc1"
name = "onbus"
[can]
sync_rate = 50.0
heartbeat_timeout = 0.5
status_timeout = 2.0
[can.drives]
"""
"""Slower than inc1, for tests on machines that are busy."""

ROBOT = """
import sys, time
from dataclasses import replace
from jauspy.cli.options import on_bus
from jauspy.robot.robot_files import load, robot_model
from jauspy.backends import find
robot = find("can").open(robot_model(on_bus(load(sys.argv[1]), sys.argv[2])), "empty")
robot.drive.set_effort(0.3, 0.0)
print("drives", flush=True)
while True:
    robot.advance(0.01)
    time.sleep(0.01)
"""


def has_multicast() -> bool:
    try:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
            group = socket.inet_aton("239.0.0.99") + socket.inet_aton("0.0.0.0")
            probe.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, group)
            probe.sendto(b"", ("239.0.0.99", 9))
    except OSError:
        return False
    return True


pytestmark = [
    pytest.mark.slow,
    pytest.mark.alone,
    pytest.mark.skipif(not has_multicast(), reason="this machine has no route for multicast"),
]


def free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("", 0))
        return int(probe.getsockname()[1])


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGTERM])
def test_simulated_drives_that_a_script_started_end_in_order(sent: signal.Signals) -> None:
    simulate = [sys.executable, "-m", "jauspy.cli.main", "can", "simulate", "inc1", "--bus"]
    script = 'trap "" INT; exec "$@"'  # as the shell does for a program that a script starts with &
    command = ["sh", "-c", script, "sh", *simulate, f"udp_multicast:239.0.0.99,port={free_port()}"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    try:
        assert process.stdout is not None
        assert "stop it:   Ctrl-C\n" in iter(process.stdout.readline, "")
        process.send_signal(sent)
        assert process.wait(10.0) == 128 + sent
    finally:
        process.kill()
        process.communicate()


@pytest.fixture
def on_bus(tmp_path: Path) -> Iterator[list[str]]:
    """The arguments `ROBOT --bus BUS`, with simulated drives on that bus."""
    file = tmp_path / "onbus.toml"
    drives = (Path(__file__).parents[3] / "src/jauspy/robots/inc1.toml").read_text().partition("[can.drives]")[2]
    file.write_text(ROBOT_FILE + drives.partition("\n")[2])
    arguments = [str(file), "--bus", f"udp_multicast:239.0.0.99,port={free_port()}"]
    process = subprocess.Popen(
        [sys.executable, "-m", "jauspy.cli.main", "can", "simulate", *arguments], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert "11 simulated drives" in process.stdout.readline()
    yield arguments
    process.terminate()
    process.communicate()


def states(on_bus: list[str]) -> dict[str, tuple[str, str]]:
    command = [sys.executable, "-m", "jauspy.cli.main", "can", "drives", *on_bus, "--json"]
    lines = subprocess.run(command, capture_output=True, text=True, check=False).stdout.splitlines()
    return {row["drive"]: (row["state"], row.get("error", "")) for row in map(json.loads, lines)}


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGSTOP], ids=["killed", "stopped"])
def test_drives_stop_without_the_robots_process(on_bus: list[str], how: signal.Signals) -> None:
    robot = subprocess.Popen([sys.executable, "-c", ROBOT, on_bus[0], on_bus[2]], stdout=subprocess.PIPE, text=True)
    try:
        assert robot.stdout is not None
        assert robot.stdout.readline() == "drives\n"
        time.sleep(0.5)
        assert {state for state, _ in states(on_bus).values()} <= {"Operation Enabled", "Quick Stop Active"}
        os.kill(robot.pid, how)
        time.sleep(1.5)
        after = states(on_bus)
        assert len(after) == 11
        assert {state for state, _ in after.values()} == {"Fault"}
    finally:
        robot.kill()
        robot.communicate()
