"""A hostile publisher of point clouds: wrong sizes, names that leave a header, a stream of nothing but nonsense."""

from __future__ import annotations

import contextlib
import json
import random
import struct
import subprocess
import sys
import time
from collections.abc import Iterator

import psutil

from jauspy.cloud.stream import MAGIC, Cloud, CloudPublisher
from jauspy.errors import ConfigError

from ..arena import Arena
from ..attack import Attack, Attacker, Bounds, Layout, NotPossible, Victims
from ..processes import SUBSCRIBER

RATE = 300
_BETWEEN = 10
"""Hostile messages between two honest ones."""
MAX_LATENESS = 1.0
"""Seconds after its timeout within which the subscriber has to return."""
_NONSENSE = 2.0
"""Seconds."""


def hostile(chance: random.Random) -> bytes:
    """A message that is no cloud, or one that is hard to bear."""
    points = chance.choice((0, 1, 3, 1000, 0xFFFFFFFF))
    name = chance.choice((b"", b"lidar", b"\xff\xfe", b"x\nelement vertex 9\n", b"\x1b[2J", bytes(60_000)))
    values = chance.choice((0, 1, 3, 6, 65535))
    time = chance.choice((0.0, float("nan"), float("inf"), -1e300, 1.8e9))
    number = chance.choice((0, 1, (1 << 64) - 1))
    length = len(name) if chance.random() < 0.7 else chance.randrange(65536)
    head = struct.pack("<4sHHIIQd", MAGIC, values, length, points, chance.randrange(3), number, time)
    body = chance.choice((b"\xff", b"\0", b"\x7f")) * (min(points, 1000) * values * 4 % 100_000)
    return chance.choice((head + name + body, head[: chance.randrange(32)], chance.randbytes(chance.randrange(200))))


def run(arena: Arena) -> None:
    """Honest clouds in between have to arrive; at the end comes only nonsense, and `receive` has to return."""
    address = f"ipc://{arena.folder / 'clouds'}"
    try:
        publisher = arena.open(CloudPublisher(address))
    except ConfigError as error:
        raise NotPossible(str(error)) from None
    send = publisher._socket.send  # noqa: SLF001 - there is no public way to send nonsense
    with subscriber(arena, address) as process:
        for number in arena.paced(RATE):
            if number % _BETWEEN == 0:
                arena.asked += 1
                send(Cloud(bytes(12), "honest", 0.0).encode())
            else:
                arena.sent += 1
                send(hostile(arena.chance))
        until = time.monotonic() + _NONSENSE
        while time.monotonic() < until:
            arena.sent += 1
            send(b"nonsense")
        time.sleep(0.5)
        used = psutil.Process(process.pid).memory_info().rss / (1 << 20)
        send(Cloud(bytes(12), "end", 0.0).encode())
        out, _ = process.communicate(timeout=20)
    last = (arena.folder / "subscriber.log").read_text(errors="replace").strip().rpartition("\n")[2]
    arena.require(process.returncode == 0, f"the subscriber ended with {last}")
    arena.memory = used
    found = json.loads(out)
    arena.lost += arena.asked - found["honest"]
    arena.require(found["late"] <= MAX_LATENESS, f"receive() returned {found['late']:.1f} s after its timeout")
    arena.require(not found["spoiled"], f"{found['spoiled']} files have a header that the publisher has written")


@contextlib.contextmanager
def subscriber(arena: Arena, address: str) -> Iterator[subprocess.Popen[str]]:
    """The victim."""
    command = (sys.executable, SUBSCRIBER, address)
    log = arena.open((arena.folder / "subscriber.log").open("wb"))
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=log, text=True, cwd=arena.folder) as process:
        try:
            assert process.stdout is not None
            arena.require(process.stdout.readline() == "ready\n", "the subscriber did not start")
            time.sleep(0.5)
            yield process
        finally:
            process.kill()


ATTACK = Attack(
    "clouds", Attacker.REMOTE, "messages", run, Bounds(lost=0.1, memory=300.0), layout=Layout(Victims.COMMANDS)
)
