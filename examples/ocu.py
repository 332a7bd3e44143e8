"""Drive the robot 101 two metres ahead, as an operator control unit."""

import asyncio
import sys

import jauspy
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort


async def main(connect: str | None) -> None:
    async with jauspy.OCU("42.1.1", connect) as ocu:
        robot = await ocu.discover(subsystem=101)
        driver = robot.service("mobility:PrimitiveDriver")
        poses = robot.service("mobility:LocalPoseSensor")
        async with driver.control(authority=200):  # renewed until the block ends; then Standby, control is released
            await driver.resume()
            async for pose in poses.subscribe(QueryLocalPose(), rate=10.0):  # all fields, ten times a second
                await driver.send(SetWrenchEffort(propulsive_linear_effort_x=40.0))  # percent, for 2 s
                print(f"x {pose.x:.2f} m, y {pose.y:.2f} m")
                if pose.x >= 2.0:
                    break


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
