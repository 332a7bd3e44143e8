"""A stranger on the CAN bus of a robot that drives: forged frames of all kinds, foreign datagrams, and floods."""

from __future__ import annotations

import contextlib
import json
import random
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import IO, Any

import psutil

import jauspy
from jauspy.errors import ConfigError

from ..arena import Arena
from ..attack import Attack, Attacker, Bounds, Layout, NotPossible, Victims

ROBOT = Path(__file__).parents[1] / "can_robot.py"
GROUP = "239.0.0.97"
NODES = range(1, 13)
RATE = 2000
PHASES = 6
"""Parts of the time, each with frames of another kind; the last one is a flood at any rate."""
RECOVERY = 20.0
"""Seconds in which the robot drives again after the attack."""
MAX_STEP = 5.0
"""Seconds that one step of the robot may take, with its Reset."""
MAX_LINES = 200
BASES = (0x80, 0x180, 0x200, 0x280, 0x300, 0x400, 0x580, 0x600, 0x700)
KNOWN = (
    "another master sends",
    "another program seems to send",
    "another program sends",
    "answer",
    "silent",
    "is in",
    "does not",
    "refuses",
    "moves while",
    "has moved",
    "beyond its limits",
    "did not run",
    "restarted",
    "NMT",
)
"""Parts of the reasons that are true on an attacked bus."""

ROBOT_FILE = """
extends = "inc1"
name = "attacked"
[can]
sync_rate = 50.0
heartbeat_timeout = 0.5
status_timeout = 1.0
[can.drives]
"""
"""Slower than inc1, for machines that are busy."""


def frames(chance: random.Random, phase: int) -> tuple[int, bytes]:
    """Identifier and bytes of one frame."""
    node = chance.choice(NODES)
    if phase == 0:  # wrong lengths
        return chance.choice(BASES) + node, chance.randbytes(chance.choice((0, 1, 2, 3, 4, 6)))
    if phase == 1:
        return chance.choice((0x80 + node, 0x100, 0x580 + node, 0x7E4, 0x7E5)), chance.randbytes(8)
    if phase == 2:
        return 0, bytes((chance.choice((1, 2, 128, 129, 130)), chance.choice((0, node))))
    if phase == 3:
        return 0x180 + node, chance.randbytes(8)
    if phase == 4:
        return chance.choice(((0x80, b""), (0x700 + node, chance.randbytes(1)), (0x200 + node, chance.randbytes(7))))
    return chance.randrange(0x800), chance.randbytes(chance.randrange(9))


def run(arena: Arena) -> None:
    """All kinds, one after the other; then the robot has to drive again."""
    if any(find_spec(each) is None for each in ("can", "canopen", "msgpack")):
        raise NotPossible("python-can and canopen are not installed")
    import can  # noqa: PLC0415 - only where the extra is installed

    from jauspy.backends.can.bus import open_bus  # noqa: PLC0415

    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("", 0))
        port = probe.getsockname()[1]
    bus = f"udp_multicast:{GROUP},port={port},hop_limit=0"
    try:
        stranger = open_bus(bus, 1_000_000)
    except ConfigError as error:
        raise NotPossible(str(error)) from None
    with stranger, processes(arena, bus) as robot:
        before = psutil.Process(robot.pid).memory_info().rss
        seconds = arena.left
        for number in arena.paced(RATE):
            phase = min(PHASES - 1, int(PHASES * (1.0 - arena.left / seconds)))
            for _ in range(20 if phase == PHASES - 1 else 1):
                cob_id, data = frames(arena.chance, phase)
                with contextlib.suppress(can.CanError):
                    stranger.send(can.Message(arbitration_id=cob_id, data=data, is_extended_id=number % 50 == 0))
                arena.sent += 1
            if number % 20 == 0:
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
                    sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
                    arena.send(sock, arena.chance.randbytes(arena.chance.randrange(200)), (GROUP, port))
        arena.asked, arena.lost = 1, 1
        state = recovered(robot)
        arena.lost = int(not state["running"])
        arena.memory = (psutil.Process(robot.pid).memory_info().rss - before) / (1 << 20)
    arena.require(state["alive"], "the robot's thread has ended with an exception")
    arena.require(state["running"], f"the robot did not drive within {RECOVERY:g} s: {state['reasons']}")
    arena.require(state["longest"] < MAX_STEP, f"a step of the robot took {state['longest']:.1f} s")
    arena.require(state["lines"] < MAX_LINES, f"the robot logged {state['lines']} lines")
    arena.require(state["counters"]["ignored"] > 0, "no frame has reached the robot")
    for reason in state["reasons"]:
        arena.require(any(each in reason for each in KNOWN), f"the robot stopped without a true reason: {reason}")


def recovered(robot: subprocess.Popen[str]) -> dict[str, Any]:
    """The state of the robot when it drives again, or after `RECOVERY`."""
    deadline = time.monotonic() + RECOVERY
    while True:
        state = ask(robot)
        if state["running"] or time.monotonic() > deadline:
            return state
        time.sleep(0.2)


def ask(robot: subprocess.Popen[str]) -> dict[str, Any]:
    """The state of the robot."""
    asked, answers = pipes(robot)
    asked.write("state\n")
    asked.flush()
    found: dict[str, Any] = json.loads(answers.readline())
    return found


def pipes(process: subprocess.Popen[str]) -> tuple[IO[str], IO[str]]:
    """Its input and output."""
    assert process.stdin is not None
    assert process.stdout is not None
    return process.stdin, process.stdout


@contextlib.contextmanager
def processes(arena: Arena, bus: str) -> Iterator[subprocess.Popen[str]]:
    """Simulated drives, and the robot that drives with them."""
    robots = Path(jauspy.__file__).parent / "robots"
    drives = (robots / "inc1.toml").read_text().partition("[can.drives]")[2].partition("\n")[2]
    file = arena.folder / "attacked.toml"
    file.write_text(ROBOT_FILE + drives)
    log = arena.open((arena.folder / "can.log").open("wb"))
    simulate = (sys.executable, "-m", "jauspy.cli.main", "can", "simulate", str(file), "--bus", bus)
    drive = (sys.executable, str(ROBOT), str(file), bus)
    with subprocess.Popen(simulate, stdout=subprocess.PIPE, stderr=log, text=True) as fleet:
        try:
            assert fleet.stdout is not None
            arena.require("simulated drives" in fleet.stdout.readline(), "the simulated drives did not start")
            with subprocess.Popen(
                drive, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log, text=True, cwd=arena.folder
            ) as robot:
                try:
                    arena.require(pipes(robot)[1].readline() == "ready\n", "the robot did not start")
                    arena.require(recovered(robot)["running"], "the robot does not drive")
                    yield robot
                finally:
                    robot.kill()
        finally:
            fleet.kill()


ATTACK = Attack(
    "can-bus", Attacker.REMOTE, "frames", run, Bounds(memory=32.0), layout=Layout(Victims.COMMANDS), restarts=True
)
