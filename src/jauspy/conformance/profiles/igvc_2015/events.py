"""Steps 3 to 10, and the streams of 75 to 80."""

from __future__ import annotations

from typing import Final

from jauspy.codec.base import Message
from jauspy.conformance import drive, streams
from jauspy.conformance.checks import has, near, that
from jauspy.conformance.profile import Action
from jauspy.conformance.profiles.igvc_2015.judge import COP, EVERYTHING
from jauspy.conformance.tester import Tester
from jauspy.messages.core import (
    CancelEvent,
    ConfirmEventRequest,
    CreateEvent,
    QueryControl,
    QueryEvents,
    QueryHeartbeatPulse,
    QueryStatus,
    RejectEventRequest,
    ReportControl,
    ReportEvents,
    ReportHeartbeatPulse,
    ReportStatus,
    UpdateEvent,
)
from jauspy.messages.mobility import (
    QueryLocalPose,
    QueryVelocityState,
    ReportLocalPose,
    ReportVelocityState,
)

EVENT: Final = "event of step 4"
PERIODIC: Final = CreateEvent.EventType.PERIODIC
A_REPORT: Final = bytes.fromhex("02440000")
"""A report where a query should be."""
UNSUPPORTED: Final = CreateEvent(3, PERIODIC, streams.HALF_HERTZ, A_REPORT)
NOT_A_QUERY: Final = has(request_id=3, response_code=RejectEventRequest.ResponseCode.MESSAGE_NOT_SUPPORTED)


def create_event(tester: Tester) -> None:
    """Step 4."""
    judge = tester.client(COP)
    confirmed = streams.subscribe(judge, 1, QueryHeartbeatPulse())
    tester.memory[EVENT] = confirmed.event_id
    streams.watch(judge, confirmed.event_id, streams.ONE_HERTZ, ReportHeartbeatPulse)


def the_event(tester: Tester) -> int:
    """The id that step 4 got."""
    found: int = tester.recall(EVENT, "step 4 got no event")
    return found


def update_event(tester: Tester) -> None:
    """Step 8."""
    judge, event = tester.client(COP), the_event(tester)
    wanted = UpdateEvent(4, UpdateEvent.EventType.PERIODIC, streams.HALF_HERTZ, event, QueryHeartbeatPulse())
    half = near(0.01, confirmed_periodic_rate=0.5)
    judge.ask(wanted, ConfirmEventRequest, has(request_id=4, event_id=event), half)
    tester.wait(0.1)
    streams.watch(judge, event, streams.HALF_HERTZ, ReportHeartbeatPulse)


def cancel_event(tester: Tester) -> None:
    """Step 9."""
    judge, event = tester.client(COP), the_event(tester)
    streams.cancel(judge, 7, event)
    streams.stopped(judge, event, 2.5 / streams.HALF_HERTZ)


def events_are(*, listed: bool) -> Action:
    """Steps 5 and 10: the event is known, and then it is not."""

    def action(tester: Tester) -> None:
        event = the_event(tester)
        right = that(
            "lists the event and no other" if listed else "lists no event",
            lambda report: [each.event_id for each in report.event_list] == [event] * listed,
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
    """Steps 75 to 79: one stream more, and its rate."""

    def action(tester: Tester) -> None:
        judge = tester.client(COP)
        confirmed = streams.subscribe(judge, request, query, to=tester.component)
        tester.memory[f"stream {request}"] = confirmed.event_id
        streams.watch(judge, confirmed.event_id, streams.ONE_HERTZ, report)

    return action


def end_and_drive(tester: Tester) -> None:
    """Step 80: the first stream ends, and the robot drives; the other streams go on meanwhile."""
    judge = tester.client(COP)
    event = tester.recall("stream 1", "step 75 got no event")
    streams.cancel(judge, 1, event, to=tester.component)
    streams.stopped(judge, event, 2.5)
    drive.square(judge, tester.component)
    for request in (2, 3, 4, 5):
        if (other := tester.memory.get(f"stream {request}")) is not None:
            judge.send(CancelEvent(request, other), to=tester.component)
