"""The robot `inc1` in a process of its own, which remembers when efforts were sent, applied and their effect read.

python tools/bench/_watched_robot.py BACKEND ROOT STEP
"""

from __future__ import annotations

import asyncio
import gc
import json
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from jauspy.geometry.poses import Twist
from jauspy.ids import JausID
from jauspy.platform.commands import DriveEffort
from jauspy.platform.contract import Command, PartId, Robot
from jauspy.robot import robot_files
from jauspy.robot.realtime import DriveProxy, RealTime
from jauspy.robot.runner import RobotRunner
from jauspy.transport import LocalTransport


class Sample(NamedTuple):
    """The effort along x; when it was sent, applied and followed by a step; and the speed then, in m/s."""

    effort: float
    sent: float
    applied: float
    moved: float
    speed: float


class Watch(RealTime):
    """A robot in real time that remembers when what happened."""

    commands: list[Sample]
    reads: list[tuple[float, float]]

    def __init__(self, robot: Robot, step: float) -> None:
        super().__init__(robot, step=step)
        self.commands, self.reads = [], []

        self._applied: list[tuple[float, float, float]] = []
        self.drive = _WatchedDrive(self)

    def _make_step(self) -> None:
        super()._make_step()
        moved, speed = time.monotonic(), self.snapshot.twist.vx
        self.commands += (Sample(*each, moved, speed) for each in self._applied)
        self._applied.clear()

    def submit(self, command: Command) -> None:
        """Submit it, with a note of when, if it is an effort."""
        super().submit(_WatchedEffort(command, time.monotonic(), self) if isinstance(command, DriveEffort) else command)

    def note(self, effort: float, sent: float) -> None:
        """An effort is applied now."""
        self._applied.append((effort, sent, time.monotonic()))


@dataclass(frozen=True)
class _WatchedEffort(Command):
    command: DriveEffort
    sent: float
    watch: Watch

    @property
    def part(self) -> PartId:
        return self.command.part

    def apply(self, robot: Robot) -> None:
        self.watch.note(self.command.linear_x, self.sent)
        self.command.apply(robot)


class _WatchedDrive(DriveProxy):
    def __init__(self, watch: Watch) -> None:
        super().__init__(watch)
        self._watch = watch

    def twist(self) -> Twist:
        """As it is, with a note."""
        at, twist = time.monotonic(), super().twist()
        self._watch.reads.append((at, twist.vx))
        return twist


async def serve(backend: str, root: str, step: float) -> None:
    """The robot's process; tells what it saw when its standard input closes."""
    watches: list[Watch] = []

    def watched(robot: Robot) -> Watch:
        watches.append(Watch(robot, step))
        return watches[0]

    def transport(component: JausID) -> LocalTransport:
        return LocalTransport(component, Path(root))

    async with RobotRunner(robot_files.load("inc1"), transport, backend=backend, realtime=watched):
        gc.freeze()
        print("ready", flush=True)
        await asyncio.to_thread(sys.stdin.read)
    times = dict(watches[0].counters)
    print(json.dumps({"commands": watches[0].commands, "reads": watches[0].reads, "counters": times}))


if __name__ == "__main__":
    asyncio.run(serve(sys.argv[1], sys.argv[2], float(sys.argv[3])))
