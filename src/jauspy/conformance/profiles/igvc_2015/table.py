"""IGVC IOP challenge 2015, the judge's interface test: 72 automated steps and 8 performance steps, a point each.

The judge is subsystem 42, with five clients. It multicasts to the wildcard component, and moves on when it is answered
or after 1.5 s. What is sent is, byte for byte, what a judge's console of 2015 sent.
"""

from __future__ import annotations

from typing import Final

from jauspy.conformance.checks import carries_only, has, near, that
from jauspy.conformance.offers import ALL_SERVICES
from jauspy.conformance.profile import Action, Profile, Step, ask, tell
from jauspy.conformance.profiles.igvc_2015.control import control, in_control, preempt, release, reset, status
from jauspy.conformance.profiles.igvc_2015.discovery import CONFIGURATION, LISTED, SERVICES, hello, identification
from jauspy.conformance.profiles.igvc_2015.driving import (
    AT_ONE_METRE,
    ELSEWHERE,
    ONE_ELEMENT,
    SUPPORTED,
    THERE,
    pose_unchanged,
    remember_pose,
)
from jauspy.conformance.profiles.igvc_2015.events import (
    NOT_A_QUERY,
    STREAMS,
    UNSUPPORTED,
    cancel_event,
    create_event,
    end_and_drive,
    events_are,
    stream,
    update_event,
)
from jauspy.conformance.profiles.igvc_2015.judge import (
    ACCEPTED,
    C1,
    C2,
    C3,
    C4,
    COP,
    EVERYTHING,
    INSUFFICIENT,
    NOT_AVAILABLE,
    STOP,
    Status,
)
from jauspy.ids import EVERYONE
from jauspy.messages.core import (
    AllEventsRec,
    ClearEmergency,
    ConfirmElementRequest,
    QueryAuthority,
    QueryConfiguration,
    QueryControl,
    QueryElementCount,
    QueryElementList,
    QueryEvents,
    QueryHeartbeatPulse,
    QuerySubsystemList,
    QueryTimeout,
    RejectEventRequest,
    ReportAuthority,
    ReportConfiguration,
    ReportControl,
    ReportElementCount,
    ReportElementList,
    ReportEvents,
    ReportHeartbeatPulse,
    ReportServices,
    ReportSubsystemList,
    ReportTimeout,
    Resume,
    SetAuthority,
    SetEmergency,
    Standby,
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
)

_TABLE: Final[tuple[tuple[str, Action], ...]] = (
    ("who is there, asked of everybody", hello),
    (
        "all nodes, components and services, asked of everybody",
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
    ("nobody is in control", ask(C1, QueryControl(), ReportControl, in_control(None))),
    ("control with no authority", control(C1, 0x00, ACCEPTED, INSUFFICIENT)),
    ("control with authority", control(C1, 0xDC, ACCEPTED)),
    ("the client is in control", ask(C1, QueryControl(), ReportControl, in_control(C1, 0xDC))),
    ("lower authority", tell(C1, SetAuthority(0xDB))),
    ("the lower authority holds", ask(C1, QueryAuthority(), ReportAuthority, has(authority_code=0xDB))),
    ("a client with less authority is refused", control(C2, 0xC8, INSUFFICIENT)),
    ("the first client is still in control", ask(C1, QueryControl(), ReportControl, in_control(C1, 0xDB))),
    ("a client with more authority takes over, and the loser is told", preempt),
    ("the new client is in control", ask(C1, QueryControl(), ReportControl, in_control(C3, 0xE7))),
    ("it gives control up", release(C3)),
    ("emergency, by a client not in control", tell(C4, SetEmergency(STOP))),
    ("status: emergency", status(Status.EMERGENCY)),
    ("no control during an emergency", control(C1, 0xD2, NOT_AVAILABLE)),
    ("the emergency is cleared by who set it", tell(C4, ClearEmergency(STOP))),
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
            that("lists element 1 alone", lambda report: [each.element_uid for each in report.element_list] == [1]),
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
    ("performance: who is there", hello),
    ("performance: who is still there", hello),
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
)
