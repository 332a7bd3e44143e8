"""Many components in one process, each with ten periodic events at 10 Hz, against one subscriber.

python tools/bench/components.py [--counts 50 100 200] [--seconds 5] [--direct]

For each number of components: events per second, CPU of the components' process and of the node manager, lateness of an
event against its period, memory per component and per subscription. `--direct` puts the subscriber where the node
manager would be. The next lines say how cost grows with load. The subscriber shares the machine; trust the ratios.
The last line says what a command costs with the seal of an operator, in the client and in the component.
"""

from __future__ import annotations

import argparse
import asyncio
import gc
import select
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from datetime import UTC, datetime
from itertools import pairwise
from pathlib import Path

import psutil
from _processes import free_port, node_manager, ready

import jauspy
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import core
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet
from jauspy.protocol.seal import Operator, OperatorKey
from jauspy.services.core import CommandSeal, Liveness, Time
from jauspy.services.host import Host

ME = JausID(42, 1, 1)
RATE = 10.0
QUERIES: Sequence[Message] = (
    core.QueryTime(1),
    core.QueryTime(2),
    core.QueryTime(3),
    core.QueryStatus(),
    core.QueryControl(),
    core.QueryAuthority(),
    core.QueryTimeout(),
    core.QueryEventTimeout(),
    core.QueryHeartbeatPulse(),
    core.QueryIdentification(core.QueryIdentification.QueryType(4)),
)


def ids(count: int) -> list[JausID]:
    """The components' ids, 250 to a node."""
    return [JausID(101, 1 + n // 250, 1 + n % 250) for n in range(count)]


async def serve(count: int, root: str) -> None:
    """The process with the components, until its standard input closes."""
    components = [jauspy.Component(id, [Liveness()], connect=f"local:{root}") for id in ids(count)]
    for component in components:
        await component.open()
    gc.freeze()
    print("ready", flush=True)
    await asyncio.to_thread(sys.stdin.read)


class Subscriber:
    """One socket: a component of the node manager, or in its place."""

    def __init__(self, root: Path, *, direct: bool) -> None:
        self._root, self._direct = root, direct
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
        self._socket.setblocking(False)
        self._socket.bind(str(root / (junior.SOCKET_NAME if direct else str(int(ME)))))

    def close(self) -> None:
        """Give the socket back."""
        self._socket.close()

    def send(self, id: JausID, datagram: bytes) -> None:
        """To this component."""
        name = str(int(id)) if self._direct else junior.SOCKET_NAME
        while True:
            try:
                self._socket.sendto(datagram, str(self._root / name))
            except BlockingIOError:
                self.wait(0.001)
            else:
                return

    def wait(self, seconds: float) -> None:
        """For what comes, at most this long."""
        select.select([self._socket], [], [], seconds)

    def receive(self) -> list[bytes]:
        """What has come; Connects are answered."""
        found: list[bytes] = []
        while len(found) < 256:
            try:
                datagram = self._socket.recv(65536)
            except BlockingIOError:
                break
            control = junior.parse(datagram)
            if control is None:
                found.append(datagram)
            elif self._direct and control.kind is junior.ControlKind.CONNECT:
                self.send(control.id, junior.accept(control.id))
        return found

    def pump(self, seconds: float) -> Iterator[tuple[float, bytes]]:
        """Every datagram of the next seconds, and when it was read."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            self.wait(left)
            for datagram in self.receive():
                yield time.monotonic(), datagram


@dataclass
class Result:
    """What one run was like; times in seconds, memory in bytes, CPU in cores."""

    count: int
    events: float
    lost: int
    cpu: float
    node_cpu: float
    lateness: list[float]
    per_component: float
    per_subscription: float


def measure(count: int, seconds: float, *, direct: bool) -> Result:
    """One run."""
    root = Path(tempfile.mkdtemp(prefix="jb"))
    with ExitStack() as stack:
        stack.callback(shutil.rmtree, root)
        node = None
        if not direct:
            node = psutil.Process(stack.enter_context(ready(*node_manager(str(root), free_port()))).pid)
        subscriber = Subscriber(root, direct=direct)
        stack.callback(subscriber.close)
        few = memory(1, root, subscriber)
        child = stack.enter_context(start(count, root, subscriber))
        before = child.memory_info().rss
        subscribe(count, subscriber)
        for _ in subscriber.pump(2.0):
            pass
        begin, used, node_used = time.monotonic(), cpu(child), cpu(node)
        arrivals = list(subscriber.pump(seconds))
        took = time.monotonic() - begin
        used, node_used = (cpu(child) - used) / took, (cpu(node) - node_used) / took
        lateness, lost, number = judge(arrivals)
        each = (before - few) / max(1, count - 1)
        subscription = (child.memory_info().rss - before) / (count * len(QUERIES))
        return Result(
            count=count,
            events=number / took,
            lost=lost,
            cpu=used,
            node_cpu=node_used,
            lateness=lateness,
            per_component=each,
            per_subscription=subscription,
        )


def memory(count: int, root: Path, subscriber: Subscriber) -> int:
    """Of the process when it has hardly any component."""
    with start(count, root, subscriber) as child:
        return int(child.memory_info().rss)


@contextmanager
def start(count: int, root: Path, subscriber: Subscriber) -> Iterator[psutil.Process]:
    """The components' process; in place of the node manager, somebody must answer its Connects."""
    command = [sys.executable, __file__, "--child", str(count), str(root)]
    with subprocess.Popen(command, stdin=-1, stdout=-1) as child:
        try:
            assert child.stdout is not None
            while not select.select([child.stdout], [], [], 0)[0]:
                for _ in subscriber.pump(0.01):
                    pass
            assert b"ready" in child.stdout.readline()
            yield psutil.Process(child.pid)
        finally:
            child.kill()


def cpu(child: psutil.Process | None) -> float:
    """Seconds used so far."""
    if child is None:
        return 0.0
    times = child.cpu_times()
    return float(times.user + times.system)


def subscribe(count: int, subscriber: Subscriber) -> None:
    """Ten events with each component, spread over a period."""
    number = 0
    for id in ids(count):
        for index, query in enumerate(QUERIES):
            create = core.CreateEvent(index, core.CreateEvent.EventType.PERIODIC, RATE, query.encode()).encode()
            subscriber.send(id, judp.pack(Packet(ME, id, create, number := number + 1 & 0xFFFF)))
        for _ in subscriber.pump(1.0 / RATE / count):
            pass


def judge(arrivals: list[tuple[float, bytes]]) -> tuple[list[float], int, int]:
    """Lateness of each event against the earliest of its subscription, sorted; how many are missing, and were there."""
    tracks: dict[tuple[int, int], list[tuple[float, int]]] = {}
    for at, datagram in arrivals:
        for packet in judp.unpack(datagram):
            payload = packet.payload
            if int.from_bytes(payload[:2], "little") == core.Event.CODE:
                tracks.setdefault((int(packet.source), payload[2]), []).append((at, payload[3]))
    lateness: list[float] = []
    lost = 0
    for track in tracks.values():
        step, last, offsets = 0, track[0][1], []
        for at, number in track:
            step += number - last & 0xFF
            last = number
            offsets.append(at - step / RATE)
        lost += step + 1 - len(track)
        best = min(offsets)
        lateness += (offset - best for offset in offsets)
    return sorted(lateness), lost, sum(map(len, tracks.values()))


def show(result: Result) -> None:
    """One line."""
    p50, p99 = (result.lateness[int(len(result.lateness) * part)] * 1e3 for part in (0.5, 0.99))
    print(
        f"  {result.count:4} components: {result.events:6.0f} of {result.count * len(QUERIES) * RATE:6.0f} events/s, "
        f"{result.lost} lost; CPU {result.cpu:.2f} cores ({result.cpu / result.events * 1e6:.0f} us an event), node "
        f"manager {result.node_cpu:.2f}; late p50 {p50:.1f} ms, p99 {p99:.1f} ms; {result.per_component / 1e3:.0f} kB "
        f"a component, {result.per_subscription / 1e3:.1f} kB a subscription"
    )


def seal_cost(commands: int = 3000) -> str:
    """What a command costs with a seal and without: CPU time of sealing it, and of `Host.receive`."""
    key, secret = OperatorKey.generate(), bytes(32)
    command, robot = core.SetTime(), JausID(101, 1, 1)
    times = {}
    for sealed in (False, True):
        seal = CommandSeal([Operator("bench", "operator", 127, key.public)], secret=secret, required=sealed)
        host = Host(robot, [Time(), seal], utc_now=lambda: datetime.now(UTC))
        challenge = seal.report_seal_challenge(ME)
        started = time.process_time()
        payloads = [
            key.seal(command, challenge, destination=robot, source=ME, elapsed=0.0, counter=number + 1).encode()
            if sealed
            else command.encode()
            for number in range(commands)
        ]
        received = time.process_time()
        for payload in payloads:
            host.receive(payload, ME, 0.0)
        times[sealed] = (received - started) / commands * 1e6, (time.process_time() - received) / commands * 1e6
        assert not [name for name in host.counters if "refused" in name]
    (plain_client, plain_host), (client, host_time) = times[False], times[True]
    return (
        f"  a sealed command: {client:.0f} us in the client, {host_time:.0f} us in the component; without a seal "
        f"{plain_client:.0f} and {plain_host:.0f} us"
    )


def main() -> None:
    """Measure each number of components, then print ratios."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--counts", type=int, nargs="+", default=[50, 100, 200])
    parser.add_argument("--seconds", type=float, default=5.0)
    parser.add_argument("--direct", action="store_true", help="without the node manager")
    parser.add_argument("--child", nargs=2, metavar=("COUNT", "ROOT"), help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.child:
        asyncio.run(serve(int(options.child[0]), options.child[1]))
        return
    results = []
    for count in options.counts:
        results.append(measure(count, options.seconds, direct=options.direct))
        show(results[-1])
    for one, other in pairwise(results):
        load, events, cost = other.count / one.count, other.events / one.events, other.cpu / one.cpu
        print(f"  {load:.1f} times the components, {events:.2f} times the events: {cost:.2f} times the CPU")
    print(seal_cost())


if __name__ == "__main__":
    main()
