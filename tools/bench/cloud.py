"""Coloured clouds of 100,000 points from a depth camera's process, as a subscriber receives them.

python tools/bench/cloud.py [--seconds 10] [--rate 10] [--backend sim]

The arm of inc1 is turned so that its camera looks down: every pixel is a point. Lost are numbers that were left out.
The delay is from the robot's state that a cloud shows until a subscriber has it.
"""

from __future__ import annotations

import argparse
import asyncio
import statistics
import time

from jauspy import backends
from jauspy.cloud.depth import DepthProcess, DepthSettings, DepthStream
from jauspy.cloud.stream import Cloud, CloudSubscriber
from jauspy.platform.contract import Robot
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.realtime import RealTime
from jauspy.robot.robot_files import load, robot_model

ADDRESS = "ipc:///tmp/jauspy-bench-cloud", "tcp://127.0.0.1:5569"
WARM_UP = 5.0
"""Seconds until the camera is open."""
LOOKING_DOWN = (0.0, 1.2, -1.2, -1.2, 0.0)
"""Positions of the arm's joints, in radians."""


def receive(address: str, seconds: float) -> tuple[list[tuple[Cloud, float]], int]:
    """Clouds, when each came, and how many were lost."""
    found = []
    with CloudSubscriber(address) as subscriber:
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            if (cloud := subscriber.receive(1.0)) is not None:
                found.append((cloud, time.time()))
        return found, subscriber.counters["lost"]


async def measure(robot: Robot, address: str, settings: DepthSettings, seconds: float) -> str:
    """A line."""
    with RealTime(robot) as realtime:
        async with DepthProcess(DepthStream(realtime.cameras["arm"], settings, address)) as process:
            await asyncio.sleep(WARM_UP)
            found, lost = await asyncio.to_thread(receive, address, seconds)
            begin, end = found[0][1], found[-1][1]
            delays = sorted(came - cloud.time for cloud, came in found)
            points = statistics.median(len(cloud) for cloud, _ in found)
            rate = (len(found) - 1) / (end - begin)
            late = realtime.counters["skipped"]
            return (
                f"{address.partition(':')[0]:6}{len(found):8}{lost:6}{points:10.0f}{rate:8.2f}"
                f"{1e3 * statistics.median(delays):11.1f}{1e3 * delays[int(0.95 * len(delays))]:8.1f}{late:8}"
                f"  {process.description}"
            )


def main() -> None:
    """A line for each kind of address."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--rate", type=float, default=10.0)
    parser.add_argument("--backend", default="sim")
    options = parser.parse_args()
    config = load("inc1")
    robot = backends.find(options.backend).open(robot_model(config), "yard")
    robot.groups["arm"].command([Target(ControlMode.POSITION, value) for value in LOOKING_DOWN])
    robot.advance(5.0)
    settings = DepthSettings(rate=options.rate, range=(0.01, 10.0))
    print("address clouds  lost    points clouds/s  median ms    95 % skipped steps of the robot")
    for address in ADDRESS:
        print(asyncio.run(measure(robot, address, settings, options.seconds)))
    robot.close()


if __name__ == "__main__":
    main()
