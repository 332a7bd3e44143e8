"""Driving a robot through the house over a slow link: contacts, time, false stops, and from the key to the motion.

python tools/bench/slow_link.py [--delays 0 100 300] [--loss 0.02] [--seed 1] [--presses 20] [--json FILE]

The link between console and robot carries JAUS: each datagram is delayed (milliseconds, each way) and lost at random,
by the network in memory, on virtual time, so that the load of the machine changes nothing. inc1 drives in MuJoCo's
physics. The operator is a program that has what a person has: the pose and the lidar's scans that the robot has
reported, late by the link, and the deflection of a stick, 20 times a second, through the same `Operation` as that of a
browser. As a person sees in the map where the walls are beside the robot, the program corrects the pose, which drifts
by more than a door leaves, by matching the scans. It drives through three doors, slower on slower links.

    contacts     steps of the physics in which the robot touches walls or movable things
    false stops  stops for silence, refused commands, and times in which the robot stands for 0.3 s after the stick was
                 deflected for 1 s and the delay of the link
    key          from a press while the robot stands until it moves with 0.02 m/s: link and robot, without the browser,
                 whose part `tools/bench/console.py` measures

Pictures need cameras' processes and real time, and are not part of this.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import math
import statistics
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any, Final

import numpy as np

from jauspy.console.operation import MAX_TURN_RATE, Operation
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.live import LiveMapping
from jauspy.mapping.mapper import Mapper
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.navigation_trials.groups import STARTS, robot_without_media
from jauspy.navigation_trials.judge import PlacingBackend
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.planning.mobility import mobility_of
from jauspy.platform.contract import Robot as SimulatedRobot
from jauspy.robot.robot_files import robot_model
from jauspy.robot.runner import RobotRunner
from jauspy.testing import VirtualNetwork
from jauspy.virtual.environment import VirtualTime

WORLD: Final = "house"
PERIOD: Final = 0.05
"""Seconds between two messages of the stick."""
AHEAD: Final = 0.3
"""Metres along the way at which the operator looks."""
COURSE: Final = (((2.78, 0.1), (2.78, -1.7)), ((2.78, -1.7), (2.78, 1.6)))
"""The course in the house, as ways of points in metres: from the corridor through the middle of a door of 0.95 m into
the room on the right, and back through it and the door across the corridor into the room on the left."""
REACHED: Final = 0.25
"""Metres from the end of a way."""
MAP_SIZE: Final = 40.0
"""Side of the operator's map, metres."""
SCAN_RATE: Final = 10.0
"""Hz of the scans that the operator sees."""
LIMIT: Final = 240.0
"""Seconds for one goal."""
MOVES: Final = 0.02
"""m/s with which a robot counts as moving."""
PAGE: Final = "operator"
"""Stands for the token of a page."""


def speed_for(delay: float) -> float:
    """The speed that the operator chooses, m/s, for seconds of delay each way."""
    return 0.4 / (1.0 + 4.0 * delay)


class Operator:
    """Sees what the robot reports, and deflects the stick."""

    def __init__(self, robot: Robot, operation: Operation, simulated: SimulatedRobot, delay: float) -> None:
        self.operation, self.robot, self.simulated = operation, robot, simulated
        self.delay = delay
        """Seconds that the link takes."""
        self.pose = PlanarPose()
        """Pose in the map, which is the local frame without its drift since the first scan."""
        self.mapper = Mapper(OccupancyGrid(MAP_SIZE))
        self.problems: list[str] = []
        self._deflected = self._stood = 0.0
        self._stands = False

    async def look(self) -> None:
        """Follow the reported pose for ever, as the page does."""
        sensor = self.robot.service("mobility:LocalPoseSensor")
        async for report in sensor.subscribe(QueryLocalPose(0x1FF), rate=1.0 / PERIOD, expects=ReportLocalPose):
            local = PlanarPose(report.x or 0.0, -(report.y or 0.0), -(report.yaw or 0.0))
            self.pose = self.mapper.correction @ local

    async def map(self) -> None:
        """Match the scans for ever."""
        await LiveMapping(self.robot, self.mapper, rate=SCAN_RATE).run()

    async def deflect(self, forward: float, left: float) -> None:
        """Deflect the stick for one period, and note whether the robot stands although it should not."""
        if why_not := self.operation.drive(PAGE, forward, left):
            self.problems.append(why_not)
        await asyncio.sleep(PERIOD)
        moving = speed_of(self.simulated)
        self._deflected = self._deflected + PERIOD if max(abs(forward), abs(left)) > 0.3 else 0.0
        self._stood = self._stood + PERIOD if self._deflected > 1.0 + self.delay and moving < MOVES else 0.0
        if self._stood > 0.3 and not self._stands:
            self.problems.append("the robot stood although the stick was deflected")
        self._stands = self._stood > 0.3

    async def follow(self, way: Sequence[PlanarPose]) -> bool:
        """Drive along a way of the map; false if it took too long."""
        began = asyncio.get_running_loop().time()
        at = 0
        while asyncio.get_running_loop().time() - began < LIMIT:
            here = self.pose
            if math.dist(here[:2], way[-1][:2]) < REACHED:
                await self.deflect(0.0, 0.0)
                return True
            while at < len(way) - 1 and math.dist(here[:2], way[at][:2]) < AHEAD:
                at += 1
            off = math.remainder(math.atan2(way[at].y - here.y, way[at].x - here.x) - here.yaw, math.tau)
            turn = max(-1.0, min(1.0, 1.2 * off / MAX_TURN_RATE))
            await self.deflect(max(0.0, 1.0 - abs(off) / 0.5), turn)
        return False

    async def stand(self, seconds: float) -> None:
        """Release the stick, which a page tells once, and wait."""
        await self.deflect(0.0, 0.0)
        await asyncio.sleep(seconds)


def speed_of(simulated: SimulatedRobot) -> float:
    """The true speed: metres, and half metres of a turn, per second."""
    twist = simulated.drive.twist()
    return math.hypot(twist.vx, twist.vy) + 0.5 * abs(twist.wz)


def dense(points: Sequence[PlanarPose]) -> list[PlanarPose]:
    """The way with points at most 0.1 m apart."""
    found = [points[0]]
    for begin, end in pairwise(points):
        steps = max(1, math.ceil(math.dist(begin[:2], end[:2]) / 0.1))
        for step in range(1, steps + 1):
            part = step / steps
            found.append(PlanarPose(begin.x + part * (end.x - begin.x), begin.y + part * (end.y - begin.y), end.yaw))
    return found


async def measure(delay: float, arguments: argparse.Namespace) -> dict[str, Any]:
    """The row of one delay, in seconds each way."""
    config = robot_without_media()
    mobility = mobility_of(robot_model(config))
    backend = PlacingBackend(STARTS[WORLD])
    async with (
        VirtualNetwork(seed=arguments.seed) as network,
        RobotRunner(config, network.transport, backend=backend, world=WORLD, realtime=VirtualTime),
        OCU("42.1.1", transport=network.transport("42.1.1")) as ocu,
    ):
        robot = await ocu.robot(101)
        events: list[str] = []
        operation = Operation(robot, events.append)
        operation.speed_limit = speed_for(delay)
        if problem := await operation.take(PAGE, 127):
            raise SystemExit(problem)
        network.delay, network.loss = delay, arguments.loss
        truth = backend.truth(mobility.flipper_step)
        operator = Operator(robot, operation, backend.robot, delay)
        seeing = [asyncio.create_task(operator.look()), asyncio.create_task(operator.map())]
        await operator.stand(3.0)
        clock = asyncio.get_running_loop().time
        true = truth.pose()
        to_local = operator.pose @ PlanarPose(true.x, true.y, true.yaw).inverse()
        course = [dense([to_local @ PlanarPose(*point) for point in way]) for way in COURSE]
        truth.begin()
        began, reached = clock(), 0
        for way in course:
            reached += await operator.follow(way)
            await operator.stand(2.0)
        seconds, contacts = clock() - began, dict(truth.contacts)
        presses = []
        for number in range(arguments.presses):
            began, forward = clock(), 1.0 if number % 2 else -1.0
            while speed_of(backend.robot) < MOVES and clock() - began < 5.0:
                operation.drive(PAGE, forward, 0.0)
                await asyncio.sleep(0.005)
            presses.append(1000.0 * (clock() - began))
            await operator.stand(2.0)
        for task in seeing:
            if task.done():
                task.result()
            task.cancel()
        network.delay = network.loss = 0.0
        await operation.release()
    stops = [event for event in events if "stopped" in event] + operator.problems
    return {
        "delay_ms": round(1000.0 * delay),
        "loss": arguments.loss,
        "speed": round(speed_for(delay), 2),
        "ways": len(course),
        "reached": reached,
        "seconds": round(seconds, 1),
        "contacts": contacts,
        "false_stops": len(stops),
        "said": sorted(set(stops))[:5],
        "key_p50_ms": round(statistics.median(presses)),
        "key_p95_ms": round(float(np.percentile(presses, 95))),
    }


def main() -> None:
    """Measure all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--delays", type=float, nargs="+", default=[0.0, 100.0, 300.0], help="ms, each way")
    parser.add_argument("--loss", type=float, default=0.02)
    parser.add_argument("--presses", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    rows = []
    for delay in arguments.delays:
        rows.append(asyncio.run(measure(delay / 1000.0, arguments)))
        print(json.dumps(rows[-1]), flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=2))


if __name__ == "__main__":
    main()
