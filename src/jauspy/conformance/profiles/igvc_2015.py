"""IGVC IOP challenge 2015, the judge's interface test: 72 automated steps and 8 performance steps, a point each.

The judge is subsystem 42, with five clients. It multicasts to the wildcard component, and continues when it is answered
or after 1.5 s. The bytes sent are those of a judge's console of 2015.
"""

from __future__ import annotations

from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance import event_streams, waypoint_drive
from jauspy.conformance.checks import Check, carries, carries_only, has, near, that
from jauspy.conformance.profile import ALL_SERVICES, Action, Profile, Step, ask, tell
from jauspy.conformance.tester import Tester
from jauspy.ids import EVERYONE
from jauspy.messages.core import (
    AllEventsRec,
    CancelEvent,
    ClearEmergency,
    ConfirmControl,
    ConfirmElementRequest,
    ConfirmEventRequest,
    CreateEvent,
    ElementRec,
    QueryAuthority,
    QueryConfiguration,
    QueryControl,
    QueryElementCount,
    QueryElementList,
    QueryEvents,
    QueryHeartbeatPulse,
    QueryIdentification,
    QueryStatus,
    QuerySubsystemList,
    QueryTimeout,
    RejectControl,
    RejectEventRequest,
    ReleaseControl,
    ReportAuthority,
    ReportConfiguration,
    ReportControl,
    ReportElementCount,
    ReportElementList,
    ReportEvents,
    ReportHeartbeatPulse,
    ReportIdentification,
    ReportServices,
    ReportStatus,
    ReportSubsystemList,
    ReportTimeout,
    RequestControl,
    Reset,
    Resume,
    SetAuthority,
    SetElement,
    SetEmergency,
    Standby,
    UpdateEvent,
)
from jauspy.messages.mobility import (
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
    SetLocalWaypoint,
)

COP, C1, C2, C3, C4 = "42.1.1", "42.2.1", "42.2.2", "42.2.3", "42.2.4"
"""The judge's clients."""

ACCEPTED, NOT_AVAILABLE, INSUFFICIENT = ConfirmControl.ResponseCode
RELEASED = RejectControl.ResponseCode.CONTROL_RELEASED
Status = ReportStatus.Status
STOP: Final = SetEmergency.EmergencyCode.STOP
EVERYTHING: Final = 0xFFFF


def in_control(client: str | None, authority: int = 0) -> tuple[Check, ...]:
    """The fields of ReportControl; without a controller all are zero."""
    subsystem, node, component = map(int, client.split(".")) if client else (0, 0, 0)
    return has(subsystem_id=subsystem, node_id=node, component_id=component, authority_code=authority)


def control(client: str, authority: int, *codes: ConfirmControl.ResponseCode) -> Action:
    """Request control; one of the `codes` must be confirmed."""
    names = " or ".join(code.name for code in codes)
    right = that(f"says {names}", lambda answer: answer.response_code in codes)
    return ask(client, RequestControl(authority), ConfirmControl, right)


def release(client: str) -> Action:
    """Release control."""
    return ask(client, ReleaseControl(), RejectControl, has(response_code=RELEASED))


def status(*right: ReportStatus.Status) -> Action:
    """Query the status, which must be one of these."""
    names = " or ".join(service.name for service in right)
    return ask(C1, QueryStatus(), ReportStatus, that(f"says {names}", lambda answer: answer.status in right))


def preempt(tester: Tester) -> None:
    """Step 29: a client with more authority takes over; the client that loses control is notified."""
    loser = tester.client(C1)
    tester.client(C3).ask(RequestControl(0xE7), ConfirmControl, has(response_code=ACCEPTED))
    loser.expect(RejectControl, has(response_code=RELEASED))


def reset(tester: Tester) -> None:
    """Step 42: control ends with it (AS5710), and the client may be notified."""
    tester.client(C1).send(Reset())
    tester.client(C1).silence(besides=(RejectControl,))


def _of(*uris: str) -> Check:
    def listed(report: ReportServices) -> bool:
        found = {
            service.uri for node in report.node_list for part in node.component_list for service in part.service_list
        }
        return found >= set(uris)

    return that("lists the core services", listed)


SERVICES: Final = (
    that("lists a node", lambda report: bool(report.node_list)),
    that("lists a component of each node", lambda report: all(node.component_list for node in report.node_list)),
    _of(*(f"urn:jaus:jss:core:{name}" for name in ("Transport", "Events", "AccessControl", "Management", "Discovery"))),
)
CONFIGURATION: Final = that(
    "lists nodes with components",
    lambda report: bool(report.node_list) and all(n.component_list for n in report.node_list),
)
LISTED: Final = that("lists a subsystem", lambda report: bool(report.subsystem_list))


def identification(level: int) -> Action:
    """Steps 13 to 16."""
    named = that("has a name", lambda report: bool(report.identification.strip("\0 ")))
    return ask(COP, QueryIdentification(level), ReportIdentification, has(query_type=level), named)


def hello(tester: Tester) -> None:
    """Steps 1, 73 and 74: a query to all components."""
    tester.client(COP).ask(QueryIdentification(4), ReportIdentification, has(query_type=4), to=EVERYONE)


POSE: Final = "pose of step 64"
ELEMENT: Final = bytes.fromhex("0d0400ffffff0fffffff0f")
"""SetLocalWaypoint, far away; the robot does not drive there in this test."""
SOMEWHERE: Final = -1000.0
"""m; x and y of the pose that the judge sets."""
CLOSE: Final = 0.05
"""m; allowed deviation of the reported position of a stationary robot."""
WHERE: Final = (*carries("x", "y"), that("has no undefined fields", lambda report: not report.reserved_presence))


def remember_pose(tester: Tester) -> None:
    """Step 64."""
    pose = tester.client(COP).ask(QueryLocalPose(EVERYTHING), ReportLocalPose, WHERE)
    tester.memory[POSE] = (pose.x, pose.y)


def pose_unchanged(tester: Tester) -> None:
    """Steps 66 and 68."""
    x, y = tester.recall(POSE, "step 64 got no pose")
    tester.client(COP).ask(QueryLocalPose(EVERYTHING), ReportLocalPose, near(CLOSE, x=x, y=y))


VELOCITIES: Final = ("velocity_x", "velocity_y", "velocity_z", "roll_rate", "pitch_rate", "yaw_rate", "time_stamp")
SUPPORTED: Final = (
    that("carries something", lambda report: any(getattr(report, name) is not None for name in VELOCITIES)),
    that("has no undefined fields", lambda report: not report.reserved_presence),
)

ONE_ELEMENT: Final = SetElement(
    request_id_rec=SetElement.RequestIDRec(0x2C),
    element_list=[ElementRec(1, 0, 0, ElementRec.ElementData(0, ELEMENT))],
)
AT_ONE_METRE: Final = SetLocalWaypoint(x=1.0, y=1.0)
ELSEWHERE: Final = SetLocalPose(x=SOMEWHERE, y=SOMEWHERE)
THERE: Final = near(CLOSE, x=SOMEWHERE, y=SOMEWHERE)


EVENT: Final = "event of step 4"
PERIODIC: Final = CreateEvent.EventType.PERIODIC
A_REPORT: Final = bytes.fromhex("02440000")
"""A report in place of a query."""
UNSUPPORTED: Final = CreateEvent(3, PERIODIC, event_streams.HALF_HERTZ, A_REPORT)
NOT_A_QUERY: Final = has(request_id=3, response_code=RejectEventRequest.ResponseCode.MESSAGE_NOT_SUPPORTED)


def create_event(tester: Tester) -> None:
    """Step 4."""
    judge = tester.client(COP)
    confirmed = event_streams.subscribe(judge, 1, QueryHeartbeatPulse())
    tester.memory[EVENT] = confirmed.event_id
    event_streams.watch(judge, confirmed.event_id, event_streams.ONE_HERTZ, ReportHeartbeatPulse)


def the_event(tester: Tester) -> int:
    """The event id of step 4."""
    found: int = tester.recall(EVENT, "step 4 got no event")
    return found


def update_event(tester: Tester) -> None:
    """Step 8."""
    judge, event = tester.client(COP), the_event(tester)
    wanted = UpdateEvent(4, UpdateEvent.EventType.PERIODIC, event_streams.HALF_HERTZ, event, QueryHeartbeatPulse())
    half = near(0.01, confirmed_periodic_rate=0.5)
    judge.ask(wanted, ConfirmEventRequest, has(request_id=4, event_id=event), half)
    tester.wait(0.1)
    event_streams.watch(judge, event, event_streams.HALF_HERTZ, ReportHeartbeatPulse)


def cancel_event(tester: Tester) -> None:
    """Step 9."""
    judge, event = tester.client(COP), the_event(tester)
    event_streams.cancel(judge, 7, event)
    event_streams.check_stopped(judge, event, 2.5 / event_streams.HALF_HERTZ)


def events_are(*, listed: bool) -> Action:
    """Steps 5 and 10: the event is listed, or no longer listed."""

    def action(tester: Tester) -> None:
        event = the_event(tester)
        right = that(
            "lists the event and no other" if listed else "lists no event",
            lambda report: [event.event_id for event in report.event_list] == [event] * listed,
        )
        tester.client(COP).ask(QueryEvents(QueryEvents.EventIDRec(event)), ReportEvents, right)

    return action


STREAMS: Final[tuple[tuple[int, Message, type[Message]], ...]] = (
    (1, QueryHeartbeatPulse(), ReportHeartbeatPulse),
    (2, QueryControl(), ReportControl),
    (3, QueryVelocityState(EVERYTHING), ReportVelocityState),
    (4, QueryLocalPose(EVERYTHING), ReportLocalPose),
    (5, QueryStatus(), ReportStatus),
)


def stream(request: int, query: Message, report: type[Message]) -> Action:
    """Steps 75 to 79: create another stream and check its rate."""

    def action(tester: Tester) -> None:
        judge = tester.client(COP)
        confirmed = event_streams.subscribe(judge, request, query, to=tester.component)
        tester.memory[f"stream {request}"] = confirmed.event_id
        event_streams.watch(judge, confirmed.event_id, event_streams.ONE_HERTZ, report)

    return action


def end_and_drive(tester: Tester) -> None:
    """Step 80: the first stream ends, and the robot drives; the other streams continue."""
    judge = tester.client(COP)
    event = tester.recall("stream 1", "step 75 got no event")
    event_streams.cancel(judge, 1, event, to=tester.component)
    event_streams.check_stopped(judge, event, 2.5)
    waypoint_drive.square(judge, tester.component)
    for request in (2, 3, 4, 5):
        if (other := tester.memory.get(f"stream {request}")) is not None:
            judge.send(CancelEvent(request, other), to=tester.component)


_TABLE: Final[tuple[tuple[str, Action], ...]] = (
    ("identification, queried from all components", hello),
    (
        "all nodes, components and services, queried from all components",
        ask(COP, ALL_SERVICES, ReportServices, SERVICES, to=EVERYONE),
    ),
    (
        "no events yet",
        ask(COP, QueryEvents(AllEventsRec(0)), ReportEvents, that("is empty", lambda report: not report.event_list)),
    ),
    ("a heartbeat at 1 Hz", create_event),
    ("the event is known", events_are(listed=True)),
    ("alive beside the event", ask(COP, QueryHeartbeatPulse(), ReportHeartbeatPulse)),
    ("an event on a report is refused", ask(COP, UNSUPPORTED, RejectEventRequest, NOT_A_QUERY)),
    ("the event goes to 0.5 Hz", update_event),
    ("the event ends", cancel_event),
    ("the event is forgotten", events_are(listed=False)),
    ("alive", ask(COP, QueryHeartbeatPulse(), ReportHeartbeatPulse)),
    ("all services again", ask(COP, ALL_SERVICES, ReportServices, SERVICES)),
    ("identification of the system", identification(1)),
    ("identification of the subsystem", identification(2)),
    ("identification of the node", identification(3)),
    ("identification of the component", identification(4)),
    ("configuration of the subsystem", ask(COP, QueryConfiguration(2), ReportConfiguration, CONFIGURATION)),
    ("configuration of the node", ask(COP, QueryConfiguration(3), ReportConfiguration, CONFIGURATION)),
    ("list of subsystems", ask(COP, QuerySubsystemList(), ReportSubsystemList, LISTED)),
    ("timeout of control", ask(C1, QueryTimeout(), ReportTimeout)),
    ("no client is in control", ask(C1, QueryControl(), ReportControl, in_control(None))),
    ("control with no authority", control(C1, 0x00, ACCEPTED, INSUFFICIENT)),
    ("control with authority", control(C1, 0xDC, ACCEPTED)),
    ("the client is in control", ask(C1, QueryControl(), ReportControl, in_control(C1, 0xDC))),
    ("lower authority", tell(C1, SetAuthority(0xDB))),
    ("the lower authority holds", ask(C1, QueryAuthority(), ReportAuthority, has(authority_code=0xDB))),
    ("a client with less authority is refused", control(C2, 0xC8, INSUFFICIENT)),
    ("the first client is still in control", ask(C1, QueryControl(), ReportControl, in_control(C1, 0xDB))),
    ("a client with more authority takes over; the client that loses control is notified", preempt),
    ("the new client is in control", ask(C1, QueryControl(), ReportControl, in_control(C3, 0xE7))),
    ("it gives control up", release(C3)),
    ("emergency, by a client not in control", tell(C4, SetEmergency(STOP))),
    ("status: emergency", status(Status.EMERGENCY)),
    ("no control during an emergency", control(C1, 0xD2, NOT_AVAILABLE)),
    ("the emergency is cleared by the client that set it", tell(C4, ClearEmergency(STOP))),
    ("control afterwards", control(C1, 0xDC, ACCEPTED)),
    ("status: standby", status(Status.STANDBY)),
    ("resume", tell(C1, Resume())),
    ("status: ready", status(Status.READY)),
    ("standby", tell(C1, Standby())),
    ("status: standby again", status(Status.STANDBY)),
    ("reset", reset),
    ("status: up again", status(Status.INITIALIZE, Status.READY, Status.STANDBY)),
    ("emergency again", tell(C4, SetEmergency(STOP))),
    ("status: emergency again", status(Status.EMERGENCY)),
    ("release during the emergency", release(C1)),
    ("the emergency is cleared again", tell(C4, ClearEmergency(STOP))),
    ("status: standby after it", status(Status.STANDBY)),
    ("travel speed", ask(COP, QueryTravelSpeed(), ReportTravelSpeed)),
    ("control for a waypoint", control(COP, 0xDC, ACCEPTED)),
    ("a waypoint", tell(COP, AT_ONE_METRE)),
    ("the waypoint", ask(COP, QueryLocalWaypoint(0), ReportLocalWaypoint, near(0.001, x=1.0, y=1.0), carries_only())),
    ("release after the waypoint", release(COP)),
    ("travel speed again", ask(COP, QueryTravelSpeed(), ReportTravelSpeed)),
    ("control for a list", control(COP, 0xDC, ACCEPTED)),
    ("a list of one waypoint", ask(COP, ONE_ELEMENT, ConfirmElementRequest, has(request_id=0x2C))),
    ("it has one element", ask(COP, QueryElementCount(), ReportElementCount, has(element_count=1))),
    (
        "that one",
        ask(
            COP,
            QueryElementList(),
            ReportElementList,
            that(
                "lists element 1 alone", lambda report: [element.element_uid for element in report.element_list] == [1]
            ),
        ),
    ),
    ("active element", ask(COP, QueryActiveElement(), ReportActiveElement)),
    ("waypoint beside a list", ask(COP, QueryLocalWaypoint(0), ReportLocalWaypoint, carries_only())),
    ("release after the list", release(COP)),
    ("velocity, everything", ask(COP, QueryVelocityState(EVERYTHING), ReportVelocityState, SUPPORTED)),
    ("velocity, nothing", ask(COP, QueryVelocityState(0), ReportVelocityState, carries_only())),
    ("pose, everything", remember_pose),
    ("a pose set without control", tell(COP, ELSEWHERE)),
    ("the pose is unchanged", pose_unchanged),
    ("control for the pose", control(COP, 0xDC, ACCEPTED)),
    ("the pose is still unchanged", pose_unchanged),
    ("a pose set with control", tell(COP, ELSEWHERE)),
    (
        "the pose that was set",
        ask(COP, QueryLocalPose(EVERYTHING), ReportLocalPose, THERE),
    ),
    ("pose, nothing", ask(COP, QueryLocalPose(0), ReportLocalPose, carries_only())),
    ("release after the pose", release(COP)),
    ("performance: identification", hello),
    ("performance: identification again", hello),
    *((f"performance: {report.NAME} at 1 Hz", stream(number, query, report)) for number, query, report in STREAMS),
    ("performance: a stream ends, and four waypoints are driven to in order", end_and_drive),
)

PROFILE: Final = Profile(
    "igvc-2015",
    "IGVC IOP challenge 2015: the judge's interface test (72 steps) and performance test (8 steps)",
    tuple(
        Step(f"{number:02}", title, action, points=1.0, moves=action is end_and_drive)
        for number, (title, action) in enumerate(_TABLE, 1)
    ),
    one_component=True,
)
