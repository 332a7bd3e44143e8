"""Soak test: under mixed load the node manager must lose no valid message, and its memory must not grow.

python tools/soak.py [--seconds 600]

The load: valid messages between two components, malformed datagrams, made-up sources and destinations, components
that start and end without Cancel. Memory is compared after a warm-up in which the bounded tables fill.
"""

from __future__ import annotations

import argparse
import random
import select
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import psutil

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Broadcast, Packet

HERE, THERE, FAR = JausID.parse("101.1.1"), JausID.parse("101.1.2"), JausID.parse("42.1.1")
TOLERANCE = 1.03


class Soak:
    """The load on one node manager."""

    def __init__(self, root: Path, port: int, seed: int) -> None:
        self._root = root
        self._node = ("127.0.0.1", port)
        self._chance = random.Random(seed)  # noqa: S311
        self._udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._here, self._there = self._component(HERE), self._component(THERE)
        self._number = 0

    def _component(self, id: JausID) -> socket.socket:
        path = self._root / str(int(id))
        path.unlink(missing_ok=True)
        sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        sock.settimeout(5.0)
        sock.bind(str(path))
        sock.sendto(junior.connect(id), str(self._root / junior.SOCKET_NAME))
        assert sock.recv(100) == junior.accept(id)
        return sock

    def turn(self) -> None:
        """Send one round of the load; raises `SystemExit` when a valid message is lost."""
        chance = self._chance
        valid = judp.pack(Packet(HERE, THERE, b"\x02\x20" + bytes(chance.randrange(200)), self._number & 0xFFFF))
        self._number += 1
        self._here.sendto(valid, str(self._root / junior.SOCKET_NAME))
        for _ in range(5):
            self._udp.sendto(chance.randbytes(chance.randrange(300)), self._node)
            unknown = JausID(chance.randrange(200, 60000), chance.randrange(1, 255), chance.randrange(1, 255))
            self._udp.sendto(judp.pack(Packet(unknown, JausID(999, 1, 1), b"\x02\x20")), self._node)
        self._udp.sendto(judp.pack(Packet(FAR, EVERYONE, b"\x02\x20", broadcast=Broadcast.GLOBAL)), self._node)
        unreachable = JausID(chance.randrange(300, 60000), 1, 1)
        self._here.sendto(judp.pack(Packet(HERE, unreachable, bytes(500))), str(self._root / junior.SOCKET_NAME))
        if self._number % 50 == 0:
            self._component(JausID(101, 2, chance.randrange(1, 255))).close()
        self._expect(valid)
        while select.select([self._here], [], [], 0)[0]:
            self._here.recv(70000)

    def _expect(self, datagram: bytes) -> None:
        try:
            while self._there.recv(70000) != datagram:
                pass
        except TimeoutError:
            raise SystemExit(f"message {self._number} was lost") from None


def main() -> None:
    """Run the load, and compare the memory."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=600.0)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    root = Path(tempfile.mkdtemp(prefix="js"))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = ["node-manager", "--address", "127.0.0.1", "--port", str(port), "--local-root", str(root)]
    with subprocess.Popen(
        [sys.executable, "-m", "jauspy.cli.main", *command],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as child:
        try:
            assert child.stdout is not None
            print(child.stdout.readline(), end="")
            compare(watch(Soak(root, port, options.seed), psutil.Process(child.pid), options.seconds))
        finally:
            child.terminate()
            child.wait(20)
            shutil.rmtree(root)


def watch(soak: Soak, child: psutil.Process, seconds: float) -> list[int]:
    """Twenty samples of the resident memory, in KiB."""
    samples: list[int] = []
    begin = time.monotonic()
    while (passed := time.monotonic() - begin) < seconds:
        soak.turn()
        if passed >= len(samples) * seconds / 20:
            samples.append(child.memory_info().rss // 1024)
            print(f"{passed:6.0f} s  {samples[-1]} KiB", flush=True)
    return samples


def compare(samples: list[int]) -> None:
    """Compare the last quarter with the second, when the tables are full; raises `SystemExit` when memory grows."""
    early, late = max(samples[5:10]), max(samples[-5:])
    if late > early * TOLERANCE:
        raise SystemExit(f"memory grows: {early} KiB, later {late} KiB")
    print(f"memory is flat: {early} KiB, later {late} KiB")


if __name__ == "__main__":
    main()
