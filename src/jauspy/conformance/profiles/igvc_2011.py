"""IGVC JAUS challenge, rules of 2011: six tasks, ten points each.

The judge's console is 42.1.1; there are no events. The console waits until the robot queries it (task 1). Shutdown
belongs to task 3, but comes last, since nothing can be driven after it.
"""

from __future__ import annotations

import math
from typing import Final

from jauspy.conformance import waypoint_drive
from jauspy.conformance.checks import carries, carries_only, has, near, that
from jauspy.conformance.profile import ALL_SERVICES, Action, Profile, Step, ask, tell
from jauspy.conformance.tester import Tester
from jauspy.messages.core import (
    ConfirmControl,
    ConfirmElementRequest,
    QueryControl,
    QueryElementCount,
    QueryElementList,
    QueryIdentification,
    QueryStatus,
    RejectControl,
    ReportControl,
    ReportElementCount,
    ReportElementList,
    ReportIdentification,
    ReportServices,
    ReportStatus,
    RequestControl,
    Resume,
    Shutdown,
    Standby,
)
from jauspy.messages.mobility import (
    ExecuteList,
    QueryActiveElement,
    QueryLocalPose,
    QueryLocalWaypoint,
    QueryTravelSpeed,
    QueryVelocityState,
    ReportActiveElement,
    ReportLocalPose,
    ReportLocalWaypoint,
    ReportTravelSpeed,
    ReportVelocityState,
    SetLocalPose,
)

COP: Final = "42.1.1"
"""The judge's console."""
AUTHORITY: Final = 0xDC
PERIOD: Final = 5.0
"""s; between two queries of the robot."""
X, Y, YAW = 10.0, 20.0, 0.5
"""m and rad; the pose that the judge sets."""
CLOSE: Final = 0.1
"""m."""
FASTEST: Final = 5.0
"""m/s; above the speed limit of the competition, with room for the clocks."""
Status = ReportStatus.Status

IDENTIFICATION: Final = ReportIdentification(
    QueryIdentification.QueryType.SUBSYSTEM, ReportIdentification.Type.VEHICLE, "jauspy conformance test"
)


# --- task 1: transport discovery ------------------------------------------------------------------------------------


def robot_asks(tester: Tester) -> None:
    """The robot queries the console."""
    timeouts = (PERIOD + tester.timeout) / tester.timeout
    tester.client(COP).expect(QueryIdentification, within=timeouts)


def robot_asks_again(tester: Tester) -> None:
    """The robot repeats its query every five seconds until it is answered."""
    robot_asks(tester)
    first = tester.now
    robot_asks(tester)
    late = abs(tester.now - first - PERIOD)
    tester.check(
        "it repeats its query every 5 s", "" if late < 0.2 * PERIOD else f"it asked after {tester.now - first:.1f} s"
    )


def robot_is_answered(tester: Tester) -> None:
    """Once answered, the robot stops its queries."""
    client = tester.client(COP)
    client.send(IDENTIFICATION, to=tester.component)
    tester.wait(0.1 * tester.timeout)
    client.forget(QueryIdentification)
    came = client.collect(QueryIdentification, 1.2 * PERIOD)
    tester.check("it stops its queries once it is answered", f"it asked {len(came)} times" if came else "")


# --- task 3: system management --------------------------------------------------------------------------------------


def becomes(command: Resume | Standby | Shutdown, status: ReportStatus.Status) -> Action:
    """Send a command without an answer and check its effect in the status."""

    def action(tester: Tester) -> None:
        client = tester.client(COP)
        client.send(command)
        client.silence(besides=(RejectControl,))
        client.ask(QueryStatus(), ReportStatus, has(status=status))

    return action


def in_control(tester: Tester) -> None:
    """The console requests control, which is confirmed."""
    accepted = has(response_code=ConfirmControl.ResponseCode.CONTROL_ACCEPTED)
    tester.client(COP).ask(RequestControl(AUTHORITY), ConfirmControl, accepted)


# --- task 5: pose ---------------------------------------------------------------------------------------------------

POSE_FIELDS: Final = 0x0103


def pose_progresses(tester: Tester) -> None:
    """Check that positions and times of two reports are consistent."""
    client = tester.client(COP)
    fields = carries("x", "y", "time_stamp")
    first = client.ask(QueryLocalPose(POSE_FIELDS), ReportLocalPose, fields)
    before = tester.now
    tester.wait(1.0)
    second = client.ask(QueryLocalPose(POSE_FIELDS), ReportLocalPose, fields)
    seconds = tester.now - before
    moved = math.dist((first.x or 0, first.y or 0), (second.x or 0, second.y or 0))
    tester.check("the position moves no faster than a robot", f"{moved:.1f} m" if moved > FASTEST * seconds else "")
    tester.check("the time goes on", "the time stamp stays" if first.time_stamp == second.time_stamp else "")


# --- task 6: waypoints ----------------------------------------------------------------------------------------------

CORNERS: Final = "corners"
SPEED: Final = 1.0
"""m/s."""


def set_list(tester: Tester) -> None:
    """Four waypoints around the robot."""
    client = tester.client(COP)
    pose = client.ask(QueryLocalPose(waypoint_drive.XY), ReportLocalPose, carries("x", "y"))
    corners = tester.memory[CORNERS] = waypoint_drive.corners(pose.x or 0.0, pose.y or 0.0)
    client.ask(waypoint_drive.element_list(corners), ConfirmElementRequest, has(request_id=1))


def execute(tester: Tester) -> None:
    """Execute the list from its first element at a given speed."""
    client = tester.client(COP)
    client.send(Resume())
    client.ask(QueryStatus(), ReportStatus, has(status=Status.READY))
    client.send(ExecuteList(speed=SPEED, element_uid=1))
    client.silence()
    client.ask(QueryActiveElement(), ReportActiveElement, has(element_uid=1))
    client.ask(QueryTravelSpeed(), ReportTravelSpeed, near(0.01, speed=SPEED))
    x, y = tester.recall(CORNERS, "there is no list of waypoints")[0]
    client.ask(QueryLocalWaypoint(waypoint_drive.XY), ReportLocalWaypoint, near(0.01, x=x, y=y))


def follow(tester: Tester) -> None:
    """The robot passes each waypoint, in order."""
    client = tester.client(COP)
    corners = tester.recall(CORNERS, "there is no list of waypoints")
    for number, point in enumerate(corners, 1):
        tester.check(f"waypoint {number} is reached", waypoint_drive.approach(client, tester.component, point))
    client.send(Standby())


CONSOLE: Final = has(subsystem_id=42, node_id=1, component_id=1, authority_code=AUTHORITY)
LISTED: Final = that(
    "lists elements 1 to 4",
    lambda report: sorted(element.element_uid for element in report.element_list) == [1, 2, 3, 4],
)
OFFERS: Final = that(
    "lists a component with services",
    lambda report: any(part.service_list for node in report.node_list for part in node.component_list),
)
POSE: Final = ask(
    COP, QueryLocalPose(POSE_FIELDS), ReportLocalPose, near(CLOSE, x=X, y=Y), carries_only("x", "y", "time_stamp")
)

_STEPS: Final = (
    Step("1.1", "the robot queries the identification of the console", robot_asks, points=3),
    Step("1.2", "it repeats the query every five seconds", robot_asks_again, points=2),
    Step("1.3", "it is answered and stops its queries", robot_is_answered, points=2),
    Step("1.4", "identification", ask(COP, QueryIdentification(2), ReportIdentification, has(query_type=2)), points=3),
    Step("2", "services", ask(COP, ALL_SERVICES, ReportServices, OFFERS), points=10),
    Step("3.1", "no client is in control", ask(COP, QueryControl(), ReportControl, has(subsystem_id=0)), points=1),
    Step("3.2", "control", in_control, points=2),
    Step("3.3", "standby", becomes(Standby(), Status.STANDBY), points=2),
    Step("3.4", "resume", becomes(Resume(), Status.READY), points=2),
    Step("3.5", "the console is in control", ask(COP, QueryControl(), ReportControl, CONSOLE), points=1),
    Step(
        "4.1",
        "velocity state, as queried by judges",
        ask(
            COP,
            QueryVelocityState(0x0141),
            ReportVelocityState,
            carries("velocity_x", "yaw_rate", "time_stamp"),
            carries_only("velocity_x", "yaw_rate", "time_stamp"),
        ),
        points=5,
    ),
    Step(
        "4.2",
        "velocity state, as the rules print it",
        ask(
            COP,
            QueryVelocityState(0x0140),
            ReportVelocityState,
            carries("yaw_rate", "time_stamp"),
            carries_only("yaw_rate", "time_stamp"),
        ),
        points=5,
    ),
    Step("5.1", "a pose is set", tell(COP, SetLocalPose(x=X, y=Y, yaw=YAW)), points=2),
    Step("5.2", "the pose is that one", POSE, points=4),
    Step("5.3", "the pose progresses", pose_progresses, points=4),
    Step("6.1", "four waypoints", set_list, points=2),
    Step("6.2", "there are four", ask(COP, QueryElementCount(), ReportElementCount, has(element_count=4)), points=1),
    Step("6.3", "these", ask(COP, QueryElementList(), ReportElementList, LISTED), points=1),
    Step("6.4", "they are driven to", execute, points=2, moves=True),
    Step("6.5", "each is reached, in order", follow, points=4, moves=True),
    Step("3.6", "shutdown", becomes(Shutdown(), Status.SHUTDOWN), points=2),
)

PROFILE: Final = Profile(
    "igvc-2011", "IGVC JAUS challenge, rules of 2011: six tasks, ten points each; shuts the target down", _STEPS
)
