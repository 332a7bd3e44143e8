"""Drive the robot 101 along a list of waypoints and back to where it started."""

import asyncio
import sys

import jauspy
from jauspy.messages.mobility import SetLocalWaypoint

TOUR = [SetLocalWaypoint(x=2.0, y=0.0), SetLocalWaypoint(x=2.0, y=1.0), SetLocalWaypoint(x=0.0, y=0.0)]  # metres


async def main(connect: str | None) -> None:
    async with jauspy.OCU("42.1.1", connect) as ocu:
        robot = await ocu.discover(subsystem=101)
        driver = robot.service("LocalWaypointListDriver")
        async with driver.control(authority=200):
            await driver.resume()
            waypoints = driver.waypoints
            await waypoints.upload(TOUR)
            await waypoints.execute(speed=0.8)  # m/s
            async for index in waypoints.progress():
                print(f"heading for waypoint {index}: {TOUR[index].x:.1f}, {TOUR[index].y:.1f}")
            print("arrived")


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
