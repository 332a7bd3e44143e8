"""Speed of the node manager, compared in the same run with a forwarder that does not route (`floor.py`).

python tools/bench/node_manager.py [--rounds 5] [--messages 30000] [--seconds 1] [--uvloop]

For three routes: messages per second with 64 and 256 in flight, CPU seconds of the router per 100,000 messages, and
round trips at a steady rate. A lost message ends it. The driver shares the machine, and others may, too: routers take
turns, and the ratio is the median of those of each round.
"""

from __future__ import annotations

import argparse
import select
import shutil
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import psutil

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

A, B = JausID.parse("126.1.11"), JausID.parse("126.1.20")
ROUTES = (("unix", "unix"), ("udp", "unix"), ("unix", "udp"))
WINDOWS = (64, 256)
RATES = (500, 5000)
UVLOOP = "import uvloop; uvloop.install(); from jauspy.cli.main import main; main()"


class End:
    """One end of a route: its socket, and the address that it sends to."""

    def __init__(self, kind: str, id: JausID, root: Path) -> None:
        self.id = id
        self.kind = kind
        family = socket.AF_UNIX if kind == "unix" else socket.AF_INET
        self.socket = socket.socket(family, socket.SOCK_DGRAM)
        self.socket.setblocking(False)
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
        self.socket.bind(str(root / str(int(id))) if kind == "unix" else ("127.0.0.1", 0))
        name = self.socket.getsockname()
        self.name = f"unix:{name}" if kind == "unix" else f"udp:{name[1]}"
        self.target: str | tuple[str, int] = ""

    def send(self, datagram: bytes) -> bool:
        """Send; false when the queue of the router is full."""
        try:
            self.socket.sendto(datagram, self.target)
        except BlockingIOError:
            return False
        return True

    def receive(self, timeout: float) -> bytes | None:
        """The next datagram."""
        try:
            return self.socket.recv(65536)
        except BlockingIOError:
            if select.select([self.socket], [], [], timeout)[0]:
                return self.socket.recv(65536)
        return None


def free_port() -> int:
    """A free UDP port."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("127.0.0.1", 0))
        return int(sock.getsockname()[1])


@contextmanager
def process(command: list[str]) -> Iterator[psutil.Process]:
    """A running router."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as child:
        try:
            assert child.stdout is not None
            assert "ready" in child.stdout.readline()
            yield psutil.Process(child.pid)
        finally:
            child.kill()


@contextmanager
def connected_ends(kinds: tuple[str, str], router: str) -> Iterator[tuple[End, End, psutil.Process]]:
    """Both ends, connected by the node manager or by the floor."""
    root = Path(tempfile.mkdtemp(prefix="jb"))
    a, b = End(kinds[0], A, root), End(kinds[1], B, root)
    try:
        if router == "floor":
            ins = [
                f"unix:{root / name}" if kind == "unix" else f"udp:{free_port()}"
                for kind, name in zip(kinds, "ab", strict=True)
            ]
            floor = str(Path(__file__).with_name("floor.py"))
            with process([sys.executable, floor, ins[0], a.name, ins[1], b.name]) as child:
                for end, text in zip((a, b), ins, strict=True):
                    rest = text.partition(":")[2]
                    end.target = rest if end.kind == "unix" else ("127.0.0.1", int(rest))
                yield a, b, child
            return
        port = free_port()
        start = ["-c", UVLOOP] if router == "uvloop" else ["-m", "jauspy.cli.main"]
        options = ["node-manager", "--address", "127.0.0.1", "--port", str(port), "--local-root", str(root)]
        with process([sys.executable, *start, *options]) as child:
            for end in (a, b):
                end.target = str(root / junior.SOCKET_NAME) if end.kind == "unix" else ("127.0.0.1", port)
                if end.kind == "unix":
                    end.send(junior.connect(end.id))
                    assert end.receive(5.0) == junior.accept(end.id)
            for one, other in ((a, b), (b, a)):
                if one.kind == "udp":
                    one.send(judp.pack(Packet(one.id, other.id, b"\x02\x20")))
                    assert other.receive(5.0)
            yield a, b, child
    finally:
        for end in (a, b):
            end.socket.close()
        shutil.rmtree(root)


def cpu(child: psutil.Process) -> float:
    """Seconds used so far; both routers have one thread. The ticks that psutil gives are too coarse."""
    return int(Path(f"/proc/{child.pid}/schedstat").read_text().split()[0]) / 1e9


def throughput(kinds: tuple[str, str], router: str, count: int, window: int) -> tuple[float, float]:
    """Messages per second, and CPU seconds per 100,000."""
    with connected_ends(kinds, router) as (a, b, child):
        datagram = judp.pack(Packet(A, B, bytes(32), 1))
        sent = received = 0
        used, begin = cpu(child), time.perf_counter()
        while received < count:
            while sent < count and sent - received < window and a.send(datagram):
                sent += 1
            if b.receive(2.0) is None:
                raise SystemExit(f"{router}, {'-'.join(kinds)}: {sent - received} of {sent} messages were lost")
            received += 1
            while received < sent and b.receive(0) is not None:
                received += 1
        seconds = time.perf_counter() - begin
        return count / seconds, (cpu(child) - used) / count * 1e5


def round_trips(kinds: tuple[str, str], router: str, rate: int, seconds: float) -> list[float]:
    """Microseconds; sent at a steady rate, later only when the one before is still under way."""
    there, back = (judp.pack(Packet(one, other, bytes(32), 1)) for one, other in ((A, B), (B, A)))
    with connected_ends(kinds, router) as (a, b, _):
        found = []
        due = time.perf_counter()
        for _ in range(int(rate * seconds)):
            due += 1 / rate
            while (left := due - time.perf_counter()) > 0:
                time.sleep(left)
            begin = time.perf_counter()
            a.send(there)
            if b.receive(2.0) is None or not b.send(back) or a.receive(2.0) is None:
                raise SystemExit(f"{router}, {'-'.join(kinds)}: a round trip was lost")
            found.append((time.perf_counter() - begin) * 1e6)
    return found


def percentiles(values: list[float]) -> str:
    """p50, p99 and p99.9."""
    values = sorted(values)
    return " / ".join(f"{values[int(len(values) * part)]:.0f}" for part in (0.5, 0.99, 0.999))


def main() -> None:
    """Measure in turn, print medians and ratios."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--messages", type=int, default=30000)
    parser.add_argument("--seconds", type=float, default=1.0)
    parser.add_argument(
        "--uvloop", action="store_true", help="the node manager on uvloop as well, when it is installed"
    )
    options = parser.parse_args()
    routers = ["floor", "jauspy", *(["uvloop"] if options.uvloop else [])]
    for kinds in ROUTES:
        print("-".join(kinds))
        for window in WINDOWS:
            compare_throughput(kinds, routers, options.rounds, options.messages, window)
        for rate in RATES:
            compare_round_trips(kinds, routers, options.rounds, rate, options.seconds)


def compare_throughput(kinds: tuple[str, str], routers: list[str], rounds: int, count: int, window: int) -> None:
    """In turn, then the medians."""
    results = [{router: throughput(kinds, router, count, window) for router in routers} for _ in range(rounds)]
    for router in routers:
        rate, used = (statistics.median(column) for column in zip(*(each[router] for each in results), strict=True))
        ratio = statistics.median(each[router][0] / each["floor"][0] for each in results)
        print(
            f"  {router:<7} {window:3} in flight {rate:8.0f} messages/s, {ratio:4.2f} of the floor, "
            f"{used:5.2f} CPU s per 100,000"
        )


def compare_round_trips(kinds: tuple[str, str], routers: list[str], rounds: int, rate: int, seconds: float) -> None:
    """In turn; the percentiles are those of all rounds together."""
    found: dict[str, list[float]] = {router: [] for router in routers}
    for _ in range(rounds):
        for router in routers:
            found[router] += round_trips(kinds, router, rate, seconds)
    for router in routers:
        print(f"  {router:<7} round trip at {rate}/s, p50 / p99 / p99.9: {percentiles(found[router])} us")


if __name__ == "__main__":
    main()
