"""Drives four waypoints in order, and checks that the robot comes within half a metre of each."""

from __future__ import annotations

import math
from typing import Final

from jauspy.conformance.checks import carries, has
from jauspy.conformance.tester import Client
from jauspy.ids import JausID
from jauspy.messages.core import (
    ConfirmControl,
    ConfirmElementRequest,
    ElementRec,
    QueryStatus,
    RejectControl,
    ReleaseControl,
    ReportStatus,
    RequestControl,
    Resume,
    SetElement,
    Standby,
)
from jauspy.messages.mobility import (
    ExecuteList,
    QueryActiveElement,
    QueryLocalPose,
    ReportActiveElement,
    ReportLocalPose,
    SetLocalWaypoint,
)

ARRIVAL_RADIUS: Final = 0.5
"""m; distance at which a waypoint counts as reached."""
SIDE: Final = 2.0
"""m; of the square."""
SPEED: Final = 1.0
"""m/s."""
SIDE_TIMEOUT: Final = 60.0
"""Timeouts for each side."""
POLL_INTERVAL: Final = 0.25
"""s; between two queries of the pose."""
CONTROL_INTERVAL: Final = 1.0
"""s; between two requests for control."""
AUTHORITY: Final = 0xDC
XY: Final = 0x03

Point = tuple[float, float]


def square(client: Client, robot: JausID) -> None:
    """Drive four waypoints around the robot's position as a list; the robot is left in Standby without a controller."""
    start = client.ask(QueryLocalPose(XY), ReportLocalPose, carries("x", "y"), to=robot)
    run(client, robot, corners(start.x or 0.0, start.y or 0.0))


def corners(x: float, y: float) -> list[Point]:
    """A square whose last corner is the start."""
    return [(x + SIDE, y), (x + SIDE, y + SIDE), (x, y + SIDE), (x, y)]


def run(client: Client, robot: JausID, points: list[Point]) -> None:
    """Take control, set the list, execute it, and watch the robot pass each point in order."""
    tester = client.tester
    take_control(client, robot)
    try:
        client.send(Resume(), to=robot)
        client.ask(QueryStatus(), ReportStatus, has(status=ReportStatus.Status.READY), to=robot)
        client.ask(element_list(points), ConfirmElementRequest, has(request_id=1), to=robot)
        client.send(ExecuteList(speed=SPEED, element_uid=1), to=robot)
        client.ask(QueryActiveElement(), ReportActiveElement, has(element_uid=1), to=robot)
        for number, point in enumerate(points, 1):
            tester.check(f"waypoint {number} is reached", approach(client, robot, point))
    finally:
        client.send(Standby(), to=robot)
        client.send(ReleaseControl(), to=robot)
    client.expect(RejectControl, has(response_code=RejectControl.ResponseCode.CONTROL_RELEASED))


def approach(client: Client, robot: JausID, point: Point) -> str:
    """Wait until the robot is near the point; returns an empty string, or the closest distance."""
    tester = client.tester
    nearest, end, renewed = math.inf, tester.now + SIDE_TIMEOUT * tester.timeout, tester.now
    while tester.now < end:
        if tester.now - renewed > CONTROL_INTERVAL:
            renewed = tester.now
            take_control(client, robot)
        pose = client.ask(QueryLocalPose(XY), ReportLocalPose, carries("x", "y"), to=robot)
        nearest = min(nearest, math.dist((pose.x or 0.0, pose.y or 0.0), point))
        if nearest <= ARRIVAL_RADIUS:
            return ""
        tester.wait(POLL_INTERVAL)
    return f"the robot came no nearer to {point[0]:.2f}, {point[1]:.2f} than {nearest:.2f} m"


def take_control(client: Client, robot: JausID) -> None:
    """Request control; repeated to keep it."""
    accepted = has(response_code=ConfirmControl.ResponseCode.CONTROL_ACCEPTED)
    client.ask(RequestControl(AUTHORITY), ConfirmControl, accepted, to=robot)


def element_list(points: list[Point]) -> SetElement:
    """Linked waypoints with UIDs from 1 on."""
    last = len(points)
    return SetElement(
        request_id_rec=SetElement.RequestIDRec(1),
        element_list=[
            ElementRec(
                number,
                number - 1,
                (number + 1) % (last + 1),
                ElementRec.ElementData(0, SetLocalWaypoint(x=x, y=y)),
            )
            for number, (x, y) in enumerate(points, 1)
        ],
    )
