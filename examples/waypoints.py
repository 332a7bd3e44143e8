"""Drive the robot 101 along a list of waypoints, ahead of where it stands, and back."""

import asyncio
import math
import sys

import jauspy
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose, SetLocalWaypoint

TOUR = [(2.0, 0.0), (2.0, 1.0), (0.0, 0.0)]  # metres ahead of the robot and to its right
TIMEOUT = 60.0  # seconds for each waypoint


def beside(start: ReportLocalPose, ahead: float, right: float) -> SetLocalWaypoint:
    """The waypoint at this place, seen from a pose: waypoints are in the frame in which poses are reported."""
    cosine, sine = math.cos(start.yaw), math.sin(start.yaw)
    return SetLocalWaypoint(x=start.x + cosine * ahead - sine * right, y=start.y + sine * ahead + cosine * right)


async def main(connect: str | None) -> None:
    async with jauspy.OCU("42.1.1", connect) as ocu:
        robot = await ocu.discover(subsystem=101)
        start = await robot.service("mobility:LocalPoseSensor").query(QueryLocalPose())
        tour = [beside(start, *place) for place in TOUR]
        driver = robot.service("LocalWaypointListDriver")
        async with driver.control(authority=200):
            await driver.resume()
            waypoints = driver.waypoints
            await waypoints.upload(tour)
            await waypoints.execute(speed=0.8)  # m/s
            async for index in waypoints.progress(timeout=TIMEOUT):
                print(f"heading for waypoint {index}: {tour[index].x:.1f}, {tour[index].y:.1f}")
            print("arrived")


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else None))
