"""A local user opens more components than the node manager has descriptors for, and lets them die."""

import asyncio
import contextlib
import resource
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import psutil
import pytest

from jauspy.ids import JausID
from jauspy.node import status
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

MAX_FILES = 80
TIMEOUT = 10.0


class Victim:
    """A node manager that may open few files."""

    def __init__(self, root: Path, port: int) -> None:
        self.root = root
        self.port = port
        self.log = root / "log"
        command = [sys.executable, "-m", "jauspy.cli.main", "node-manager", "--address", "127.0.0.1"]
        with self.log.open("wb") as log:
            self.process = subprocess.Popen(
                [*command, "--port", str(port), "--local-root", str(root)],
                stdout=subprocess.PIPE,
                stderr=log,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (MAX_FILES, MAX_FILES)),  # noqa: PLW1509 - no threads here
            )
        assert self.process.stdout is not None
        assert b"ready" in self.process.stdout.readline()

    def connect(self, id: JausID) -> socket.socket:
        sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        path = self.root / str(int(id))
        path.unlink(missing_ok=True)
        sock.bind(str(path))
        sock.sendto(junior.connect(id), str(self.root / junior.SOCKET_NAME))
        return sock

    def accepts(self, id: JausID) -> bool:
        """Connects again and again, as components do, until it is accepted."""
        until = time.monotonic() + TIMEOUT
        with self.connect(id) as sock:
            sock.settimeout(0.1)
            while time.monotonic() < until:
                with contextlib.suppress(TimeoutError):
                    return sock.recv(100) == junior.accept(id)
                sock.sendto(junior.connect(id), str(self.root / junior.SOCKET_NAME))
        return False


@pytest.fixture
def victim(root: Path, free_port: int) -> Iterator[Victim]:
    victim = Victim(root, free_port)
    yield victim
    victim.process.terminate()
    victim.process.communicate()


@pytest.mark.slow
def test_components_that_come_and_go_leave_room_for_others(victim: Victim) -> None:
    here = JausID(101, 1, 1)
    with contextlib.ExitStack() as stack:
        for number in range(1, 151):
            stack.enter_context(victim.connect(JausID(66, 1 + number // 200, 1 + number % 200)))
        for _ in range(20):  # there is a reserve for readers of the status
            state = asyncio.run(status.read(victim.root))
        assert 20 < len(state["components"]) < MAX_FILES
        assert state["counters"]["dropped.component_refused"] > 0
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as peer:
            peer.sendto(judp.pack(Packet(JausID(42, 1, 1), here, b"\x02\x20", 1)), ("127.0.0.1", victim.port))
    assert victim.accepts(here)
    assert asyncio.run(status.read(victim.root))["counters"]["received.udp"] == 1
    assert victim.log.stat().st_size < 4096


@pytest.mark.slow
def test_connections_without_a_descriptor_are_tried_again_at_a_limited_rate(victim: Victim) -> None:
    """When other programs use up the files of the whole system, or the limit is lowered."""
    before = asyncio.run(status.read(victim.root))["counters"].get("accept_failed", 0)
    limits = resource.prlimit(victim.process.pid, resource.RLIMIT_NOFILE, (4, MAX_FILES))
    with contextlib.ExitStack() as stack:
        for _ in range(8):
            reader = stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_STREAM))
            reader.connect(str(victim.root / status.SOCKET_NAME))
        time.sleep(1.0)
        assert victim.log.stat().st_size < 4096
        resource.prlimit(victim.process.pid, resource.RLIMIT_NOFILE, limits)
        reader.settimeout(TIMEOUT)
        assert reader.recv(1) == b"{"
    counted = asyncio.run(status.read(victim.root))["counters"]["accept_failed"] - before
    assert 1 <= counted <= 5


@pytest.mark.slow
def test_a_limit_that_is_lowered_below_what_is_open(victim: Victim) -> None:
    """Components that are connected are served; further ones are refused and counted, in one line and without haste."""
    here, client = JausID(101, 1, 1), JausID(101, 1, 2)
    with contextlib.ExitStack() as stack:
        first = stack.enter_context(victim.connect(here))
        first.settimeout(TIMEOUT)
        assert first.recv(100) == junior.accept(here)
        for number in range(1, 31):
            stack.enter_context(victim.connect(JausID(66, 1, number)))
        limits = resource.prlimit(victim.process.pid, resource.RLIMIT_NOFILE, (20, MAX_FILES))
        process = psutil.Process(victim.process.pid)
        begin = process.cpu_times()
        time.sleep(7.0)  # the addresses of the machine are read each 5 s, which needs a descriptor
        for number in range(31, 41):
            stack.enter_context(victim.connect(JausID(66, 1, number)))
        first.sendto(judp.pack(Packet(client, here, b"\x02\x20", 1)), str(victim.root / junior.SOCKET_NAME))
        assert first.recv(100)[-4:-2] == b"\x02\x20", "who is connected is served"
        used = process.cpu_times()
        assert used.user + used.system - begin.user - begin.system < 2.0
        resource.prlimit(victim.process.pid, resource.RLIMIT_NOFILE, limits)
        counters = asyncio.run(status.read(victim.root))["counters"]
        assert counters["dropped.component_refused"] >= 10
        assert counters["open_files.limit_changed"] in (1, 2), (
            "when it was lowered, and perhaps when it was raised again"
        )
        assert counters["multicast.not_refreshed"] >= 1
        log = victim.log.read_text()
        assert "Traceback" not in log
        assert log.count("limit of open files is now 20") == 1
    assert victim.accepts(JausID(66, 2, 1)), "with the old limit there is room again"
