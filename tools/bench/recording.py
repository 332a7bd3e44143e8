"""What recording `inc1` with cameras, lidar and reports costs: as MCAP, as pcapng, and by a flight recorder.

python tools/bench/recording.py [--seconds 10] [--rate 20] [--backend kinematic] [--rounds 1]

A node manager, the robot, and a client that receives two videos and events of all reports of poses, speeds, joints and
forces with this rate, and each scan of the lidar (10 Hz). Recorders take turns, and nobody records in between. Shown
are what the recorder wrote, its processor time in percent of a core, and packets that it lost.

Then the robot's clock, which pauses when the robot cannot keep up: seconds that the robot advanced in a second of the
wall clock, steps that began late, and steps that were skipped, with each recorder and without; 1 is real time. All
share the machine, so that rounds differ by its other work: those without a recorder, too.
"""

from __future__ import annotations

import argparse
import asyncio
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import AsyncIterator, Iterator
from contextlib import AsyncExitStack, ExitStack, asynccontextmanager, contextmanager
from typing import Any, NamedTuple

import psutil
from _processes import free_port

from jauspy.codec.message import Message
from jauspy.messages import core, environment_sensing as sensing, manipulator, mobility
from jauspy.ocu import OCU
from jauspy.robot.realtime import STEP

QUERIES: dict[str, tuple[Message, ...]] = {
    "101.1.102": (
        mobility.QueryLocalPose(presence_vector=0xFFFF),
        mobility.QueryGlobalPose(presence_vector=0xFFFF),
        mobility.QueryVelocityState(presence_vector=0xFFFF),
        mobility.QueryAccelerationState(presence_vector=0xFFFF),
        mobility.QueryWrenchEffort(presence_vector=0xFFFF),
        core.QueryStatus(),
        core.QueryControl(),
    ),
    "101.1.103": (manipulator.QueryJointPositions(),),
    "101.1.104": (
        manipulator.QueryJointPositions(),
        manipulator.QueryJointVelocities(),
        manipulator.QueryJointForceTorques(),
        manipulator.QueryEndEffectorPose(),
        manipulator.QueryEndEffectorVelocityState(),
    ),
    "101.1.105": (manipulator.QueryJointPositions(),),
    "101.1.107": (manipulator.QueryPanTiltJointPositions(), manipulator.QueryPanTiltJointVelocities()),
}
SCAN = sensing.QueryRangeSensorData.QueryRangeSensorDataRec(1, 0, 0xFFFF)
LIDAR_RATE = 10.0


@contextmanager
def child(*command: str, said: str) -> Iterator[subprocess.Popen[str]]:
    """A verb once it has said this; it is stopped in order."""
    process = subprocess.Popen(
        [sys.executable, "-m", "jauspy.cli.main", *command], stdout=-1, stderr=subprocess.STDOUT, text=True
    )
    try:
        assert process.stdout is not None
        if not any(said in line for line in process.stdout):
            raise SystemExit(f"jauspy {' '.join(command)} did not start")
        yield process
    finally:
        process.terminate()
        process.communicate(timeout=30)


class RobotClock(NamedTuple):
    """What the robot's clock has counted up to a time of the wall clock (s), or between two."""

    wall: float
    steps: int
    late: int
    skipped: int

    def since(self, before: RobotClock) -> RobotClock:
        """What was counted between two times."""
        return RobotClock(
            self.wall - before.wall, self.steps - before.steps, self.late - before.late, self.skipped - before.skipped
        )

    def __str__(self) -> str:
        pace = self.steps * STEP / self.wall
        return f"{pace:.4f} s a second, {self.late / self.steps:6.2%} of the steps late, {self.skipped} skipped"


def read_clock(robot: subprocess.Popen[str]) -> RobotClock:
    """The clock of a robot now, from the counters that it prints in the order of their names."""
    robot.send_signal(signal.SIGUSR1)
    assert robot.stdout is not None
    counters = dict.fromkeys(("late", "skipped", "steps"), 0)
    for line in robot.stdout:
        found = re.search(r"realtime\.(late|skipped|steps)\s+(\d+)", line)
        if found:
            counters[found[1]] = int(found[2])
        if counters["steps"]:
            return RobotClock(time.monotonic(), counters["steps"], counters["late"], counters["skipped"])
    raise SystemExit("the robot has ended")


@asynccontextmanager
async def client(root: str, rate: float) -> AsyncIterator[None]:
    """Receives everything."""
    async with AsyncExitStack() as stack:
        ocu = await stack.enter_async_context(OCU("42.1.1", connect=f"local:{root}", timeout=10.0))
        robot = await ocu.discover(101, timeout=60.0)
        rows = [(id, query, rate) for id, queries in QUERIES.items() for query in queries]
        rows.append(("101.1.108", sensing.QueryRangeSensorData([SCAN]), LIDAR_RATE))
        for id, query, wanted in rows:
            kind: Any = type(query)
            subscription = robot.component(id).service("Events").subscribe(query, expects=kind.REPORT, rate=wanted)
            await stack.enter_async_context(subscription)
        for name in ("arm", "chassis"):
            pictures = robot.camera(name).encoded(address="127.0.0.1")
            await anext(pictures)
            task = asyncio.create_task(_drain(pictures))
            stack.callback(task.cancel)
        yield


async def _drain(pictures: AsyncIterator[Any]) -> None:
    async for _ in pictures:
        pass


@contextmanager
def recorder(how: str, root: str, run: int) -> Iterator[subprocess.Popen[str] | None]:
    """The process that records, once it has begun."""
    if how == "nobody":
        yield None
    elif how == "flight recorder":
        with child("flight-recorder", "--local-root", root, "-o", f"{root}/runs{run}", said="on emergency") as process:
            yield process
    else:
        with child("record", f"{root}/run{run}.{how}", "--local-root", root, said="recording") as process:
            yield process


async def measure(how: str, robot: subprocess.Popen[str], root: str, seconds: float, run: int) -> RobotClock:
    """One run; prints a line, and returns what the robot's clock counted."""
    said = ""
    with recorder(how, root, run) as process:
        await asyncio.sleep(1.0)  # its start is over
        watched = None if process is None else psutil.Process(process.pid)
        used = 0.0 if watched is None else sum(watched.cpu_times()[:2])
        before = read_clock(robot)
        await asyncio.sleep(seconds)
        clock = read_clock(robot).since(before)
        used = 0.0 if watched is None else sum(watched.cpu_times()[:2]) - used
        if process is not None:
            process.send_signal(signal.SIGINT)
            assert process.stdout is not None
            said = await asyncio.to_thread(process.stdout.read)
    found = re.search(r"(\d+) messages, (\d+) bytes", said)
    messages, size = (int(number) / (clock.wall + 1.0) for number in found.groups()) if found else (0.0, 0.0)
    wrote = f"{messages:5.0f} messages/s {size / 1e6:6.3f} MB/s written" if found else ""
    lost = max(map(int, re.findall(r"(\d+) packets were lost", said)), default=0)
    print(f"  {how:16}{wrote:40}{used / clock.wall:7.1%} of a core  lost {lost}", flush=True)
    return clock


async def measure_all(options: argparse.Namespace) -> dict[str, list[RobotClock]]:
    """The rounds, with one robot and one client."""
    clocks: dict[str, list[RobotClock]] = {how: [] for how in ("nobody", "mcap", "pcapng", "flight recorder")}
    with ExitStack() as stack:
        root = stack.enter_context(tempfile.TemporaryDirectory(prefix="jb"))
        where = ("--local-root", root, "--port", str(free_port()), "--address", "127.0.0.1", "--plain")
        robot = stack.enter_context(child("up", "inc1", "--backend", options.backend, *where, said="stop it"))
        async with client(root, options.rate):
            for number in range(options.rounds):
                for how, found in clocks.items():
                    found.append(await measure(how, robot, root, options.seconds, number))
    return clocks


def main() -> None:
    """All runs."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--rate", type=float, default=20.0)
    parser.add_argument("--backend", default="kinematic")
    parser.add_argument("--rounds", type=int, default=1)
    options = parser.parse_args()
    clocks = asyncio.run(measure_all(options))
    print("the robot's clock, recorded by")
    for how, found in clocks.items():
        print(f"  {how:16}{RobotClock(*map(sum, zip(*found, strict=True)))}")


if __name__ == "__main__":
    main()
