"""Robots that igvc-2015 must catch: what teams' robots were seen to do wrong, and what they might."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from tests.conformance.injectors import (
    Fault,
    Injector,
    deaf_to,
    field,
    handles,
    instead,
    later,
    patched,
    says,
    short,
    slow,
    without,
)
from tests.conformance.mistakes import (
    ACCEPTED,
    UNAVAILABLE,
    Status,
    Still,
    anybody,
    chatty,
    confirmed,
    freezes,
    goes_on,
    half_listed,
    ignored,
    no_components,
    no_nodes,
    no_services,
    not_for_255,
    not_notified,
    nothing_in_it,
    obeys_everybody,
    reports_pass,
    short_inside,
    sixty_hertz,
    stuck,
    undefined_fields,
    unmasked,
    wrong_report,
)

from jauspy.codec.message import Message
from jauspy.conformance import TargetComponent
from jauspy.messages import core, mobility
from jauspy.services import presence_vectors
from jauspy.services.core import AccessControl, Events
from jauspy.services.core.subscriptions import Subscriptions
from jauspy.services.mobility import LocalPoseSensor


def igvc(name: str, trips: str, inject: Injector) -> Fault:
    return Fault(name, "igvc-2015", tuple(trips.split()), inject)


def _numbered(request: int) -> Callable[[Any], bool]:
    return lambda message: message.request_id == request


def driven(name: str, inject: Injector) -> Fault:
    return Fault(f"driving: {name}", "igvc-2015", ("80",), inject, motion=True, only=("01", "75", "80"))


DRIVE_REPORTS: Final[tuple[type[Message], ...]] = (
    core.ConfirmControl,
    core.ConfirmElementRequest,
    core.RejectControl,
    mobility.ReportActiveElement,
    mobility.ReportLocalPose,
    core.ReportStatus,
)
ENDING: Final = core.CancelEvent
"""What step 80 begins with."""

DRIVES: Final = (
    driven("the robot does not move", lambda: (TargetComponent, Still, [])),
    driven("the active element is always 3", field(mobility.ReportActiveElement, element_uid=3)),
    *(driven(f"the robot stops at waypoint {number}", freezes(number)) for number in (1, 2, 3)),
    *(driven(f"{kind.NAME} is late", slow(kind)) for kind in DRIVE_REPORTS),
    *(driven(f"{kind.NAME} is never sent", without(kind)) for kind in DRIVE_REPORTS),
    driven("the end is confirmed late", later(ENDING, 1, slow(core.ConfirmEventRequest))),
    driven("the end is confirmed in short", later(ENDING, 1, short(core.ConfirmEventRequest))),
    driven("the end is confirmed for event 99", later(ENDING, 1, field(core.ConfirmEventRequest, event_id=99))),
    driven("the end is confirmed as request 99", later(ENDING, 1, field(core.ConfirmEventRequest, request_id=99))),
    driven("the end is not confirmed", later(ENDING, 1, without(core.ConfirmEventRequest))),
    driven("poses lose their x", later(ENDING, 1, field(mobility.ReportLocalPose, x=None))),
    driven("poses lose their y", later(ENDING, 1, field(mobility.ReportLocalPose, y=None))),
    driven("lists are confirmed as request 99", field(core.ConfirmElementRequest, request_id=99)),
    driven("release is refused", field(core.RejectControl, response_code=1)),
    driven("control is never available", field(core.ConfirmControl, response_code=UNAVAILABLE)),
    driven("the status is always Standby", field(core.ReportStatus, status=Status.STANDBY)),
    driven("cancelled events go on", goes_on()),
    *(driven(f"{kind.NAME} is short", later(ENDING, 1, short(kind))) for kind in DRIVE_REPORTS),
)


IGVC_QUERIES: Final[tuple[type[Message], ...]] = (
    core.QueryIdentification,
    core.QueryConfiguration,
    core.QuerySubsystemList,
    core.QueryServices,
    core.QueryEvents,
    core.CreateEvent,
    core.UpdateEvent,
    core.CancelEvent,
    core.QueryHeartbeatPulse,
    core.QueryTimeout,
    core.QueryControl,
    core.QueryAuthority,
    core.QueryStatus,
    core.RequestControl,
    core.ReleaseControl,
    core.SetElement,
    core.QueryElementCount,
    core.QueryElementList,
    mobility.QueryTravelSpeed,
    mobility.QueryLocalWaypoint,
    mobility.QueryActiveElement,
    mobility.QueryVelocityState,
    mobility.QueryLocalPose,
)
IGVC_REPORTS: Final[tuple[type[Message], ...]] = (
    core.ReportIdentification,
    core.ReportConfiguration,
    core.ReportSubsystemList,
    core.ReportServices,
    core.ReportEvents,
    core.ConfirmEventRequest,
    core.RejectEventRequest,
    core.ReportHeartbeatPulse,
    core.ReportTimeout,
    core.ReportControl,
    core.ReportAuthority,
    core.ReportStatus,
    core.ConfirmControl,
    core.RejectControl,
    core.ConfirmElementRequest,
    core.ReportElementCount,
    core.ReportElementList,
    mobility.ReportTravelSpeed,
    mobility.ReportLocalWaypoint,
    mobility.ReportActiveElement,
    mobility.ReportVelocityState,
    mobility.ReportLocalPose,
)
LATE: Final = (
    igvc("ReportEvents is late", "05 10", slow(core.ReportEvents)),
    *(
        igvc(
            f"the confirmation of request {number} is late",
            step,
            slow(core.ConfirmEventRequest, where=_numbered(number)),
        )
        for number, step in ((4, "08"), (7, "09"))
    ),
    *(
        igvc(f"the confirmation of request {number} is short", step, later(kind, 1, short(core.ConfirmEventRequest)))
        for number, step, kind in ((4, "08", core.UpdateEvent), (7, "09", core.CancelEvent))
    ),
    igvc("RejectControl is late", "29", slow(core.RejectControl)),
    *(
        igvc(f"{name} from its {count}. on", step, later(mobility.QueryLocalPose, count, inner))
        for count, step in ((2, "66"), (3, "68"))
        for name, inner in (
            ("QueryLocalPose is not understood", deaf_to(mobility.QueryLocalPose)),
            ("ReportLocalPose is short", short(mobility.ReportLocalPose)),
            ("ReportLocalPose is late", slow(mobility.ReportLocalPose)),
        )
    ),
)
IGVC_2015: Final = (
    igvc("60 Hz instead of 1 Hz", "04 75 76 77 78 79", patched(Events, _set_rate=sixty_hertz)),
    igvc("a ReportStatus of three bytes", "33 37 39 45", short(core.ReportStatus)),
    igvc("a short ReportConfiguration", "17 18", short(core.ReportConfiguration)),
    igvc("component 255 ignored", "02 04 23", handles(not_for_255)),
    igvc("control not checked", "66", obeys_everybody()),
    igvc("the loser is not told", "29", says(not_notified)),
    igvc("reports ignore the presence vector", "63 71", patched(presence_vectors, apply_presence_vectors=unmasked)),
    igvc("one component of the answer is missing", "02 12", instead(core.ReportServices, no_components)),
    igvc("no node is listed", "02 12", instead(core.ReportServices, no_nodes)),
    igvc("no service is listed", "02 12", instead(core.ReportServices, no_services)),
    igvc("no node in the configuration", "17 18", instead(core.ReportConfiguration, no_nodes)),
    igvc("no subsystem is listed", "19", field(core.ReportSubsystemList, subsystem_list=[])),
    igvc(
        "events of somebody else are listed",
        "03 10",
        field(core.ReportEvents, event_list=[core.ReportEventRec(0, 9, b"")]),
    ),
    igvc("an event is forgotten at once", "05 08 09", patched(Subscriptions, add=ignored)),
    igvc("a cancelled event is still listed", "10", patched(Subscriptions, remove=ignored)),
    igvc("cancelled events go on", "09", goes_on()),
    igvc("the sequence number stands still", "04 75", instead(core.Event, stuck)),
    igvc("events carry another report", "04 75", instead(core.Event, wrong_report)),
    igvc("new events are confirmed at 10 Hz", "04 75", confirmed(1, confirmed_periodic_rate=10.0)),
    igvc("changed events are confirmed at 10 Hz", "08", confirmed(4, confirmed_periodic_rate=10.0)),
    igvc("confirmations of new events have request id 99", "04 75", confirmed(1, request_id=99)),
    *(
        igvc(f"confirmations of streams have request id 99 instead of {n}", f"{n + 74}", confirmed(n, request_id=99))
        for n in (2, 3, 4, 5)
    ),
    *(
        igvc(f"streams are confirmed at 10 Hz, request {n}", f"{n + 74}", confirmed(n, confirmed_periodic_rate=10.0))
        for n in (2, 3, 5)
    ),
    igvc("confirmations of changes have request id 99", "08", confirmed(4, request_id=99)),
    igvc("confirmations of the end have request id 99", "09", confirmed(7, request_id=99)),
    igvc("events carry short reports", "04 76 77 78 79", instead(core.Event, short_inside)),
    igvc("changed events come no more", "08", later(core.UpdateEvent, 1, without(core.Event))),
    igvc("changes are confirmed for event 99", "08", confirmed(4, event_id=99)),
    igvc("ends are confirmed for event 99", "09", confirmed(7, event_id=99)),
    igvc(
        "updates keep the old rate",
        "08",
        patched(Events, update_event=lambda self, msg, source: setattr(self, "_current", self._find(msg, source))),
    ),
    igvc("a report passes as a query", "07", reports_pass()),
    igvc("rejections have request id 99", "07", field(core.RejectEventRequest, request_id=99)),
    igvc("any event is refused as code 1", "07", field(core.RejectEventRequest, response_code=1)),
    igvc("identification is always of the subsystem", "13 15 16", field(core.ReportIdentification, query_type=2)),
    igvc("identification is always of type 9", "01 14 73 74", field(core.ReportIdentification, query_type=3)),
    igvc("it has no name", "13 14 15 16", field(core.ReportIdentification, identification="")),
    igvc(
        "ReportControl is always zero",
        "24 28 30",
        field(core.ReportControl, subsystem_id=0, node_id=0, component_id=0, authority_code=0),
    ),
    igvc(
        "ReportControl is never zero",
        "21",
        field(core.ReportControl, subsystem_id=9, node_id=9, component_id=9, authority_code=9),
    ),
    igvc("control is confirmed to everybody", "27 34", field(core.ConfirmControl, response_code=ACCEPTED)),
    igvc("control is never available", "22 23 29 36 50 55 67", field(core.ConfirmControl, response_code=UNAVAILABLE)),
    igvc("release is refused", "29 31 46 53 61 72", field(core.RejectControl, response_code=1)),
    igvc("SetAuthority is ignored", "26 28", patched(AccessControl, is_authority_valid=lambda self, msg: False)),
    igvc("any authority takes over", "27 28", patched(AccessControl, is_current_authority_less=anybody)),
    igvc("the status is always Ready", "33 37 41 48", field(core.ReportStatus, status=Status.READY)),
    igvc("the status is always Standby", "33 39 45", field(core.ReportStatus, status=Status.STANDBY)),
    igvc("the status is always Failure", "43", field(core.ReportStatus, status=Status.FAILURE)),
    igvc("emergency is ignored", "33 34 45", deaf_to(core.SetEmergency)),
    igvc("emergency is for ever", "36 37 48", deaf_to(core.ClearEmergency)),
    igvc("Resume is ignored", "39", deaf_to(core.Resume)),
    igvc("Standby is ignored", "41", deaf_to(core.Standby)),
    igvc(
        "commands are answered",
        "25 32 35 38 40 44 47 51 65 69",
        chatty(
            core.SetAuthority,
            core.SetEmergency,
            core.ClearEmergency,
            core.Resume,
            core.Standby,
            mobility.SetLocalWaypoint,
            mobility.SetLocalPose,
        ),
    ),
    igvc("Reset is answered", "42", chatty(core.Reset)),
    igvc("the waypoint is another one", "52", field(mobility.ReportLocalWaypoint, x=7.0, y=7.0)),
    igvc("waypoints come with a heading", "52 60", field(mobility.ReportLocalWaypoint, yaw=0.0)),
    igvc("element requests have id 99", "56", field(core.ConfirmElementRequest, request_id=99)),
    igvc("the list is always empty", "57", field(core.ReportElementCount, element_count=0)),
    igvc("no element is listed", "58", instead(core.ReportElementList, half_listed)),
    igvc("velocity has undefined fields", "62", instead(mobility.ReportVelocityState, undefined_fields)),
    igvc("velocity is empty", "62", instead(mobility.ReportVelocityState, nothing_in_it)),
    igvc("pose has undefined fields", "64", instead(mobility.ReportLocalPose, undefined_fields)),
    igvc("pose is empty", "64 70", instead(mobility.ReportLocalPose, nothing_in_it)),
    igvc("SetLocalPose is ignored", "70", deaf_to(mobility.SetLocalPose)),
    igvc(
        "half of SetLocalPose is ignored",
        "70",
        patched(LocalPoseSensor, _set=lambda self, x, y, z, yaw: _SET(self, x, None, z, yaw)),
    ),
    *DRIVES,
    *LATE,
    *(igvc(f"{kind.NAME} is not understood", "", deaf_to(kind)) for kind in IGVC_QUERIES),
    *(igvc(f"{kind.NAME} is spoilt", "", short(kind)) for kind in IGVC_REPORTS),
    igvc("every answer comes after two seconds", "01 02 06 24 49 62", slow()),
)
_SET: Final = LocalPoseSensor._set
