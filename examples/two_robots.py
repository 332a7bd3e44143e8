"""Drive all robots of the network ahead at the same time, for two seconds, with one operator control unit."""

import asyncio
import math
import sys

import jauspy
from jauspy.messages.mobility import QueryLocalPose, SetWrenchEffort


async def drive(robot: jauspy.Robot, seconds: float) -> None:
    driver = robot.service("mobility:PrimitiveDriver")
    sensor = robot.service("mobility:LocalPoseSensor")
    before = await sensor.query(QueryLocalPose())
    async with driver.control(authority=200):
        await driver.resume()
        await driver.send(SetWrenchEffort(propulsive_linear_effort_x=50.0))  # percent
        await asyncio.sleep(seconds)
    after = await sensor.query(QueryLocalPose())
    print(f"{robot.id} drove {math.dist((after.x, after.y), (before.x, before.y)):.2f} m")


async def main(connect: str | None) -> None:
    async with jauspy.OCU("42.1.1", connect) as ocu:
        robots = [each for each in await ocu.discover_all() if list(each.info.offering("mobility:PrimitiveDriver"))]
        async with asyncio.TaskGroup() as group:
            for robot in robots:
                group.create_task(drive(robot, seconds=2.0))


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
