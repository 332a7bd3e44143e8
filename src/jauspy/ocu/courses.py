"""Drives along several points, with directions and waits (waypoint list drivers of AS6009, and of IOP)."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says where the robot is

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.arguments import check_number, described
from jauspy.errors import ConfigError, RequestError
from jauspy.messages.iop import SetEnhancedLocalWaypointInformation
from jauspy.messages.mobility import ExecuteList, SetLocalWaypoint
from jauspy.ocu.commands import perform
from jauspy.ocu.connection import Connection
from jauspy.ocu.driving import TOLERANCE, Driving, Offering
from jauspy.ocu.explain import check_ready
from jauspy.ocu.lists import ListClient
from jauspy.ocu.state import RobotPose

LIST_DRIVER, ENHANCED_DRIVER = "mobility:LocalWaypointListDriver", "iop:EnhancedLocalWaypointListDriver"
MAX_WAIT: Final = 3600.0
"""Seconds of a wait."""
MAX_ENTRIES: Final = 255
"""Waypoints in one message about directions and waits."""


@dataclass(frozen=True, slots=True)
class CoursePoint:
    """A point of a course, in metres of the robot's local frame with the axes of REP-103 (y left)."""

    x: float
    y: float
    reverse: bool | None = None
    """True to drive there backward, False forward, None by the sign of the course's speed."""
    wait: float | None = None
    """Seconds to stand there."""
    tolerance: float = TOLERANCE
    """Metres within which it is reached."""
    path_tolerance: float | None = None
    """Metres to which the robot is to stay beside the line from the point before; None for the robot's choice."""

    def __post_init__(self) -> None:
        for value, use in ((self.x, "x"), (self.y, "y"), (self.tolerance, "tolerance")):
            check_number(value, use)
            if not math.isfinite(value):
                raise ConfigError(f"{use}={value:g} of a point of a course is no finite number; give metres")
        check_number(self.wait, "wait", optional=True)
        check_number(self.path_tolerance, "path_tolerance", optional=True)
        if self.wait is not None and not 0.0 < self.wait <= MAX_WAIT:
            raise ConfigError(f"wait={self.wait:g} is outside of 0..{MAX_WAIT:g} seconds; leave it out to drive on")


def course_points(points: object) -> list[CoursePoint]:
    """The points of a course, of which some may be pairs; raises `ConfigError` or `TypeError`."""
    if not isinstance(points, Iterable):
        raise TypeError(f"a course is made of points, as in [(1.0, 0.0), (2.0, 1.0)], not {described(points)}")
    found = []
    for point in points:
        if isinstance(point, CoursePoint):
            found.append(point)
        elif isinstance(point, Sequence) and len(point) == 2 and not isinstance(point, str | bytes):
            found.append(CoursePoint(point[0], point[1]))
        else:
            raise TypeError(f"a point is a pair of metres or a CoursePoint, not {described(point)}")
    if not found:
        raise ConfigError("a course needs at least one point")
    return found


async def drive_course(
    connection: Connection,
    offering: Offering,
    driving: Driving,
    points: Sequence[CoursePoint],
    *,
    speed: float,
    timeout: float,
) -> RobotPose:
    """See `Robot.drive_course`."""
    check_number(speed, "speed")
    check_number(timeout, "timeout")
    enhanced = offering(ENHANCED_DRIVER)
    driver = enhanced or offering(LIST_DRIVER)
    if driver is None:
        raise ConfigError(f"this robot cannot drive a course: it does not offer {LIST_DRIVER}")
    if enhanced is None and any(point.reverse is not None or point.wait is not None for point in points):
        raise ConfigError(f"this robot takes no directions and waits: it does not offer {ENHANCED_DRIVER}")
    await driving.close()
    await check_ready(connection, driver.id)
    may_stop = connection.begin_motion(driver.id)
    waypoints = [
        SetLocalWaypoint(x=point.x, y=-point.y, waypoint_tolerance=point.tolerance, path_tolerance=point.path_tolerance)
        for point in points
    ]
    async with connection.list_changes[driver.id]:
        await driver.elements.upload(waypoints)
        uids = await ListClient(connection, driver.id).uids()
    entries = [
        SetEnhancedLocalWaypointInformation.WaypointInformationRec(
            uid, None if point.reverse is None else int(point.reverse), point.wait
        )
        for uid, point in zip(uids, points, strict=True)
    ]
    for start in range(0, len(entries) if enhanced else 0, MAX_ENTRIES):  # also what takes back earlier information
        message = SetEnhancedLocalWaypointInformation(entries[start : start + MAX_ENTRIES])
        await connection.send_checked(driver.id, message, ack=True)
    try:
        await perform(connection, driver.id, ExecuteList(speed=speed, element_uid=uids[0]), timeout)
    except BaseException as error:
        if may_stop():
            await driving.stop()
        if isinstance(error, RequestError):
            pose = await driving.pose()
            error.add_note(f"the robot is at ({pose.x:.2f}, {pose.y:.2f})")
        raise
    return await driving.pose()
