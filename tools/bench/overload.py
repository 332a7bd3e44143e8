"""How long a robot takes to obey Standby while clients have it send more events than it can, or flood it with requests.

python tools/bench/overload.py [--seconds 10]

`inc1` on the kinematic backend, with all modules in one process, and a node manager. Three runs: nobody else; four
clients with all events that they get at 100 Hz of each of seven modules (896 asked); four clients with 10,000
CreateEvents again and again, paused for a second. Measured is the time from Standby to the report of the status that
it leads to, by an operator in control. The last line compares with the first run. Clients share the machine; trust the
ratios. `abandoned` counts steps of the robot without a heartbeat of the event loop for a second, after the start.
"""

from __future__ import annotations

import argparse
import asyncio
import select
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from itertools import count, cycle
from pathlib import Path

from _processes import free_port

from jauspy.ids import JausID
from jauspy.messages import core
from jauspy.ocu import OCU
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

MODULES = [JausID(101, 1, component) for component in range(102, 109)]
STRANGERS = [JausID(66, 1, number) for number in range(1, 5)]
DRIVER = MODULES[0]
EVENTS = 32
FLOOD = 10_000


class Stranger:
    """A client by a local socket of its own, which reads and ignores what it gets."""

    def __init__(self, root: str, id: JausID) -> None:
        self._node = f"{root}/{junior.SOCKET_NAME}"
        self._id, self._numbers = id, count()
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self._socket.bind(f"{root}/{int(id)}")
        self._socket.setblocking(False)
        self._send(junior.connect(id))

    def create(self, module: JausID, number: int, rate: float) -> None:
        """Ask for an event."""
        query = core.QueryTime(number % 250).encode()
        request = core.CreateEvent(number & 0xFF, core.CreateEvent.EventType.PERIODIC, rate, query)
        self._send(judp.pack(Packet(self._id, module, request.encode(), next(self._numbers) & 0xFFFF)))

    def read(self) -> None:
        """Read what waits."""
        while select.select([self._socket], [], [], 0.0)[0]:
            self._socket.recv(65536)

    def _send(self, datagram: bytes) -> None:
        while True:
            try:
                self._socket.sendto(datagram, self._node)
            except BlockingIOError:
                self.read()
                time.sleep(0.0005)
            else:
                return


def attack(root: str, how: str) -> None:
    """The process of the strangers, until it is killed."""
    strangers = [Stranger(root, id) for id in STRANGERS]
    if how == "events":
        for number in range(EVENTS):
            for stranger in strangers:
                for module in MODULES:
                    stranger.create(module, number, 100.0)
            time.sleep(0.02)
    print("ready", flush=True)
    while True:
        if how == "flood":
            for number, stranger in zip(range(FLOOD), cycle(strangers), strict=False):
                stranger.create(DRIVER, number, 1.0)
        end = time.monotonic() + 1.0
        while time.monotonic() < end:
            for stranger in strangers:
                stranger.read()
            time.sleep(0.002)


async def operate(root: str, seconds: float) -> list[float]:
    """The times, in seconds."""
    found = []
    async with OCU("42.1.1", connect=f"local:{root}", timeout=5.0) as ocu:
        driver = (await ocu.discover(101, timeout=60.0)).component(str(DRIVER)).service("PrimitiveDriver")
        async with driver.control(authority=200):
            end = time.monotonic() + seconds
            while time.monotonic() < end:
                await driver.resume()
                await asyncio.sleep(0.05)
                begin = time.monotonic()
                await ocu.send(DRIVER, core.Standby())
                while True:
                    report = await ocu.query(DRIVER, core.QueryStatus(), expects=core.ReportStatus)
                    if report.status == core.ReportStatus.Status.STANDBY:
                        break
                found.append(time.monotonic() - begin)
    return found


@contextmanager
def child(command: Sequence[str], said: str) -> Iterator[subprocess.Popen[str]]:
    """A Python child once it has said this."""
    with subprocess.Popen(
        [sys.executable, *command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    ) as process:
        try:
            assert process.stdout is not None
            assert any(said in line for line in process.stdout)
            yield process
        finally:
            process.terminate()
            process.communicate(timeout=20)


def abandoned(robot: subprocess.Popen[str]) -> int:
    """Steps without a heartbeat so far."""
    robot.send_signal(signal.SIGUSR1)
    assert robot.stdout is not None
    total = 0
    for line in robot.stdout:
        if "realtime.abandoned" in line:
            total = int(line.split()[-1])
        if "realtime.steps" in line:
            break
    return total


def measure(how: str, seconds: float) -> list[float]:
    """One run; prints a line."""
    with ExitStack() as stack:
        root = stack.enter_context(tempfile.TemporaryDirectory(prefix="jb"))
        where = ["--local-root", root, "--port", str(free_port()), "--address", "127.0.0.1"]
        up = ["-m", "jauspy.cli.main", "up", "inc1", "--backend", "kinematic", *where]
        robot = stack.enter_context(child(up, "stop it"))
        before = abandoned(robot)
        if how != "alone":
            stack.enter_context(child([str(Path(__file__)), "--attack", root, how], "ready"))
        times = sorted(asyncio.run(operate(root, seconds)))
        lost = abandoned(robot) - before
    p50, p90, worst = (1e3 * each for each in (statistics.median(times), times[int(0.9 * len(times))], times[-1]))
    print(
        f"  {how:6}: {len(times)} times, median {p50:.1f} ms, p90 {p90:.1f} ms, most {worst:.1f} ms; abandoned {lost}"
    )
    return times


def main() -> None:
    """All runs, then ratios."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--attack", nargs=2, metavar=("ROOT", "HOW"), help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.attack:
        attack(*options.attack)
        return
    alone, *others = (statistics.median(measure(how, options.seconds)) for how in ("alone", "events", "flood"))
    print("  medians, as multiples of the first: " + ", ".join(f"{each / alone:.1f}" for each in others))


if __name__ == "__main__":
    main()
