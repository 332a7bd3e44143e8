"""Drive the robot 101 two metres ahead of where it stands, as an operator control unit."""

import asyncio
import math
import sys

import jauspy
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort

DISTANCE = 2.0  # metres
TIMEOUT = 20.0  # seconds, after which the robot is stopped wherever it is


async def main(connect: str | None) -> None:
    async with jauspy.OCU("42.1.1", connect) as ocu:
        robot = await ocu.discover(subsystem=101)
        driver = robot.service("mobility:PrimitiveDriver")
        poses = robot.service("mobility:LocalPoseSensor")
        start = await poses.query(QueryLocalPose())
        # control is renewed until the block ends; then Standby, control is released
        async with driver.control(authority=200), asyncio.timeout(TIMEOUT):
            await driver.resume()
            async for pose in poses.subscribe(QueryLocalPose(), rate=10.0):  # all fields, ten times a second
                await driver.send(SetWrenchEffort(propulsive_linear_effort_x=40.0))  # percent, for 2 s
                driven = math.dist((pose.x, pose.y), (start.x, start.y))
                print(f"{driven:.2f} m")
                if driven >= DISTANCE:
                    break


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
