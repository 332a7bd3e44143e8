"""From an OCU's command to the robot's actuator, and from there to the report that shows the effect.

python tools/bench/latency.py [--backends kinematic sim] [--samples 300] [--cameras] [--step 0.002]

An OCU on UDP, a node manager and the robot `inc1` are three processes, as in `jauspy demo`. The OCU sends
SetWrenchEffort, each time with another effort, at random moments of the robot's step, and then asks
QueryVelocityState again and again. All clocks are the machine's monotonic one. The parts, which add up to the whole:

    command   the OCU calls `send`, until the service calls the drive     (what JAUS adds)
    step due  until the robot's thread begins its next step               (0..`--step`: how often it takes orders)
    step      until the state after that step is there to be reported     (physics)
    asked     until the OCU's next query reads that state                 (how often it asks; two messages at most)
    reply     until the OCU has that report                               (what JAUS adds)

`JAUS` is command and reply: what remains with a robot whose hardware takes and tells values at once. The velocity in
each report is checked to be the one that was read.

With `--cameras` both cameras of the robot stream to a receiver of their own meanwhile, which adds two processes that
render and encode, and one that receives. CPU, in cores, is that of the robot's process: with nobody connected, and
while it is driven and asked as fast as it answers.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import random
import subprocess
import tempfile
import time
from bisect import bisect_left
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TypeVar

import psutil
from _processes import free_port, node_manager, ready
from _watched_robot import Sample

from jauspy.messages.mobility import QueryVelocityState, SetWrenchEffort
from jauspy.ocu import OCU
from jauspy.robot.realtime import STEP

T = TypeVar("T")

ROBOT = Path(__file__).with_name("_watched_robot.py")
VIEWER = Path(__file__).with_name("_viewer.py")
IDLE = 4.0
"""Seconds over which the CPU of a robot with nobody connected is taken."""
GOAL = 0.010
WATCHED = 0.04
"""Seconds for which the OCU asks after a command."""
PARTS = ("command", "step due", "step", "asked", "reply", "whole", "JAUS")
X = 1
"""Presence vector: velocity x."""
SPACING = 0.05
"""Percent from one effort to the next, by which a command is known again."""


@dataclass
class Seen:
    """By the OCU: when each effort was sent, and when which velocity came."""

    sent: list[tuple[float, float]]
    replies: list[tuple[float, float]]


async def drive(port: int, samples: int) -> Seen:
    """Command and look, again and again: forth and back, so that the robot stays about where it is."""
    seen = Seen([], [])
    async with OCU(connect=f"udp://127.0.0.1:{port}") as ocu:
        robot = await ocu.discover(subsystem=101)
        driver, sensor = robot.service("mobility:PrimitiveDriver"), robot.service("mobility:VelocityStateSensor")
        async with driver.control():
            await driver.resume()
            for number in range(samples):
                await asyncio.sleep(random.uniform(0.0, 0.01))  # noqa: S311 - no secret
                effort = (20.0 + number * SPACING) * (-1) ** number
                seen.sent.append((time.monotonic(), effort / 100.0))
                await driver.send(SetWrenchEffort(propulsive_linear_effort_x=effort))
                while time.monotonic() < seen.sent[-1][0] + WATCHED:
                    report = await sensor.query(QueryVelocityState(presence_vector=X))
                    assert report.velocity_x is not None
                    seen.replies.append((time.monotonic(), report.velocity_x))
    return seen


def split(seen: Seen, commands: list[Sample], reads: list[tuple[float, float]]) -> tuple[list[list[float]], int]:
    """The parts of each command's way, in seconds; how many had no visible effect in time."""
    rows, unseen = [], 0
    for sent, effort in seen.sent:
        command = next((each for each in commands if abs(each.effort - effort) < SPACING / 300.0), None)
        read = command and _first(reads, command.moved)
        reply = read and _first(seen.replies, read[0])
        if command is None or read is None or reply is None or reply[0] > sent + 2 * WATCHED:
            unseen += 1
            continue
        if abs(reply[1] - read[1]) > 0.001:
            raise SystemExit(f"a report says {reply[1]} m/s where {read[1]} was read: the parts are not distinct")
        times = [sent, command.sent, command.applied, command.moved, read[0], reply[0]]
        parts = [after - before for before, after in pairwise(times)]
        rows.append([*parts, sum(parts), parts[0] + parts[-1]])
    return rows, unseen


def _first(timed: list[tuple[float, float]], at: float) -> tuple[float, float] | None:
    index = bisect_left(timed, (at, float("-inf")))
    return timed[index] if index < len(timed) else None


@dataclass
class Run:
    """What one run was like; CPU in cores."""

    rows: list[list[float]]
    unseen: int
    idle: float
    driven: float
    late: int
    steps: int
    pictures: str

    def show(self, backend: str) -> None:
        """A line for each percentile, and one for the rest."""
        for name, share in (("p50", 0.5), ("p99", 0.99)):
            values = [sorted(column)[int(len(column) * share)] for column in zip(*self.rows, strict=True)]
            print(f"  {backend + ' ' + name:20}" + "".join(f"{value * 1e3:10.2f}" for value in values))
        print(
            f"  {len(self.rows)} commands, {self.unseen} without an effect that was seen; robot's CPU {self.idle:.2f} "
            f"idle, {self.driven:.2f} driven; {self.late} of {self.steps} steps late{self.pictures}"
        )


def measure(backend: str, options: argparse.Namespace) -> Run:
    """One run."""
    port = free_port()
    with tempfile.TemporaryDirectory(prefix="jb") as root, ExitStack() as stack:
        stack.enter_context(ready(*node_manager(root, port)))
        robot = stack.enter_context(ready(str(ROBOT), backend, root, str(options.step)))
        idle = _cores(robot, lambda: time.sleep(IDLE))[0]
        viewer = stack.enter_context(ready(str(VIEWER), str(port))) if options.cameras else None
        driven, seen = _cores(robot, lambda: asyncio.run(drive(port, options.samples)))
        pictures = "" if viewer is None else f"; pictures {viewer.communicate()[0].decode().strip()}"
        announced = json.loads(robot.communicate()[0])
    commands = [Sample(*each) for each in announced["commands"]]
    rows, unseen = split(seen, commands, [(at, speed) for at, speed in announced["reads"]])
    counters = announced["counters"]
    return Run(
        rows=rows,
        unseen=unseen,
        idle=idle,
        driven=driven,
        late=counters["late"],
        steps=counters["steps"],
        pictures=pictures,
    )


def _cores(process: subprocess.Popen[bytes], do: Callable[[], T]) -> tuple[float, T]:
    """What the process uses while something is done."""
    used, begin = _used(process), time.monotonic()
    result = do()
    return (_used(process) - used) / (time.monotonic() - begin), result


def _used(process: subprocess.Popen[bytes]) -> float:
    times = psutil.Process(process.pid).cpu_times()
    return float(times.user + times.system)


def main() -> None:
    """A table for each backend."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--backends", nargs="+", default=["kinematic", "sim"])
    parser.add_argument("--samples", type=int, default=300, help="commands, up to 1500 (%(default)s)")
    parser.add_argument("--cameras", action="store_true", help="while both stream")
    parser.add_argument("--step", type=float, default=STEP, help="of the robot, seconds (%(default)s)")
    options = parser.parse_args()
    print(f"  {'ms':20}" + "".join(f"{part:>10}" for part in PARTS) + f"   goal: p99 below {GOAL * 1e3:g}")
    for backend in options.backends:
        measure(backend, options).show(backend)


if __name__ == "__main__":
    main()
