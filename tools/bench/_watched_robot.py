"""The robot `inc1` in a process of its own, which remembers when its drive was told, obeyed and read.

python tools/bench/_watched_robot.py BACKEND ROOT STEP
"""

from __future__ import annotations

import asyncio
import gc
import json
import sys
import time
from pathlib import Path
from typing import NamedTuple

from jauspy.geometry.poses import Twist
from jauspy.ids import JausID
from jauspy.modules import robots
from jauspy.modules.realtime import RealTime
from jauspy.modules.robot import RobotRunner
from jauspy.modules.shared import Order, SharedDrive
from jauspy.platform.contract import Robot
from jauspy.transport import LocalTransport


class Command(NamedTuple):
    """The effort along x; when the drive was told, began to obey and had moved; and how fast it moved then (m/s)."""

    effort: float
    told: float
    begun: float
    moved: float
    speed: float


class Watch(RealTime):
    """A robot in real time that remembers when what happened."""

    commands: list[Command]
    reads: list[tuple[float, float]]

    def __init__(self, robot: Robot, step: float) -> None:
        super().__init__(robot, step=step)
        self.commands, self.reads = [], []
        self._obeyed: list[tuple[float, float, float]] = []

    @property
    def drive(self) -> SharedDrive:
        """The chassis, watched."""
        return _WatchedDrive(self)

    def _make_step(self) -> None:
        super()._make_step()
        moved, speed = time.monotonic(), self.snapshot.twist.vx
        self.commands += (Command(*each, moved, speed) for each in self._obeyed)
        self._obeyed.clear()

    def told(self, effort: float, order: Order) -> Order:
        """The order, with a note of when it was given and is obeyed."""
        told = time.monotonic()

        def obey(robot: Robot) -> None:
            self._obeyed.append((effort, told, time.monotonic()))
            order(robot)

        return obey


class _WatchedDrive(SharedDrive):
    def __init__(self, watch: Watch) -> None:
        super().__init__(watch.order, lambda: watch.snapshot)
        self._watch = watch

    def set_effort(self, linear_x: float, rotational_z: float) -> None:
        """As it is, with a note."""
        order = self._watch.told(linear_x, lambda robot: robot.drive.set_effort(linear_x, rotational_z))
        self._watch.order("drive", order)

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

    async with RobotRunner(robots.load("inc1"), transport, backend=backend, realtime=watched):
        gc.freeze()
        print("ready", flush=True)
        await asyncio.to_thread(sys.stdin.read)
    times = dict(watches[0].counters)
    print(json.dumps({"commands": watches[0].commands, "reads": watches[0].reads, "counters": times}))


if __name__ == "__main__":
    asyncio.run(serve(sys.argv[1], sys.argv[2], float(sys.argv[3])))
