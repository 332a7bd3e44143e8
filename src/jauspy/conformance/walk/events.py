"""The inputs of Events, and what its events must do afterwards."""

from __future__ import annotations

from typing import Final

from jauspy.conformance import streams
from jauspy.conformance.checks import has
from jauspy.conformance.outcome import Skipped
from jauspy.conformance.streams import ONE_HERTZ
from jauspy.conformance.walk.stimulus import EARLIEST, LONGEST, Aftermath, Stimulus
from jauspy.conformance.walk.walker import OBSERVER, Walker
from jauspy.messages.core import (
    AllEventsRec,
    CancelEvent,
    CommandEvent,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    Event,
    EventTypeRec,
    QueryEvents,
    QueryEventTimeout,
    ReportEventTimeout,
    SetAuthority,
    Standby,
    UpdateEvent,
)

CREATE, UPDATE, CANCEL, HELD = 1, 2, 3, 9
"""Request ids."""
UNKNOWN_ID: Final = 251
PERIODIC: Final = CreateEvent.EventType.PERIODIC
QUERY: Final = QueryEventTimeout()
"""Every component that has Events answers it."""
A_REPORT: Final = ReportEventTimeout(1)
DURATION: Final = 1
"""Seconds that a command may take."""
FAST: Final = 10.0
"""Hertz of a stream that is looked at."""


def hold_event(walker: Walker, role: str) -> None:
    """The sender has an event."""
    wanted = CreateEvent(HELD, CreateEvent.EventType.EVERY_CHANGE, 0.0, QUERY)
    confirmed = walker.client(role).ask(wanted, ConfirmEventRequest, has(request_id=HELD), to=walker.component)
    walker.tester.memory["held"] = confirmed.event_id


def held(walker: Walker) -> int:
    """Its id."""
    found: int = walker.tester.recall("held", "there is no event")
    return found


def drop_events(walker: Walker, role: str) -> None:
    """Cancel what the step made."""
    client = walker.client(role)
    for id in {walker.tester.memory.pop("held", None), *_confirmed(walker, role)} - {None}:
        client.send(CancelEvent(HELD, id), to=walker.component)
    walker.look()


def _confirmed(walker: Walker, role: str) -> set[int]:
    """The events that this client was told of in this step."""
    return {
        message.event_id
        for entry in walker.tester.entries[-64:]
        for packet in entry.packets
        if packet.destination == walker.client(role).id and packet.payload[:2] == b"\xf3\x01"
        for message in [ConfirmEventRequest.decode(packet.payload, strict=False)[0]]
    }


def _end_is_told(then: Aftermath) -> None:
    """A command event that was confirmed ends in time, one way or the other, and its client is told."""
    if any(output.message == "ConfirmEventRequest" for output in then.outcome.outputs):
        events = _confirmed(then.walker, then.role)
        within = 1.0 + DURATION / then.walker.tester.timeout
        taken = then.before.controller == then.role and "Available" in then.before.state
        result = CommandEvent.CommandResult.SUCCESSFUL if taken else CommandEvent.CommandResult.UNSUCCESSFUL
        then.walker.client(then.role).expect(
            CommandEvent, has(command_result=result), where=lambda end: end.event_id in events, within=within
        )


EVENTS: Final = (
    Stimulus(
        "CreateEvent",
        lambda _: CreateEvent(CREATE, PERIODIC, ONE_HERTZ, QUERY),
        "a new one",
        {"isSupported": True, "eventExists": False},
        after=drop_events,
        checks={"ConfirmEventRequest": has(request_id=CREATE)},
    ),
    Stimulus(
        "CreateEvent",
        lambda _: CreateEvent(CREATE, CreateEvent.EventType.EVERY_CHANGE, 0.0, QUERY),
        "one that is there",
        {"isSupported": True, "eventExists": True},
        before=hold_event,
        after=drop_events,
        checks={"ConfirmEventRequest": has(request_id=CREATE)},
    ),
    Stimulus(
        "CreateEvent",
        lambda _: CreateEvent(CREATE, PERIODIC, ONE_HERTZ, A_REPORT),
        "a report instead of a query",
        {"isSupported": False, "eventExists": False},
        checks={"RejectEventRequest": has(request_id=CREATE)},
    ),
    Stimulus(
        "UpdateEvent",
        lambda walker: UpdateEvent(UPDATE, UpdateEvent.EventType.PERIODIC, ONE_HERTZ, held(walker), QUERY),
        "one that is there",
        {"isSupported": True, "eventExists": True},
        before=hold_event,
        after=drop_events,
        checks={"ConfirmEventRequest": has(request_id=UPDATE)},
    ),
    Stimulus(
        "UpdateEvent",
        lambda _: UpdateEvent(UPDATE, UpdateEvent.EventType.PERIODIC, ONE_HERTZ, UNKNOWN_ID, QUERY),
        "an unknown one",
        {"isSupported": True, "eventExists": False},
        checks={"RejectEventRequest": has(request_id=UPDATE)},
    ),
    Stimulus(
        "UpdateEvent",
        lambda walker: UpdateEvent(UPDATE, UpdateEvent.EventType.PERIODIC, ONE_HERTZ, held(walker), A_REPORT),
        "to a report instead of a query",
        {"isSupported": False, "eventExists": True},
        before=hold_event,
        after=drop_events,
        checks={"RejectEventRequest": has(request_id=UPDATE)},
    ),
    Stimulus(
        "CancelEvent",
        lambda walker: CancelEvent(CANCEL, held(walker)),
        "one that is there",
        {"eventExists": True},
        before=hold_event,
        after=drop_events,
        checks={"ConfirmEventRequest": has(request_id=CANCEL)},
    ),
    Stimulus(
        "CancelEvent",
        lambda _: CancelEvent(CANCEL, UNKNOWN_ID),
        "an unknown one",
        {"eventExists": False},
        checks={"RejectEventRequest": has(request_id=CANCEL)},
    ),
    Stimulus(
        "CreateCommandEvent",
        lambda _: CreateCommandEvent(CREATE, DURATION, Standby()),
        "a new one",
        {"eventExists": False},
        after=drop_events,
        verify=_end_is_told,
    ),
    Stimulus(
        "CreateCommandEvent",
        lambda walker: CreateCommandEvent(CREATE, DURATION, SetAuthority(walker.authority)),
        "of a command that ends at once",
        {"eventExists": False},
        after=drop_events,
        verify=_end_is_told,
        by_controller=True,
    ),
    *(
        Stimulus("QueryEvents", lambda _, part=part: QueryEvents(part), name)  # type: ignore[misc]  # a bound loop variable
        for name, part in (
            ("all", AllEventsRec(0)),
            ("by message", QueryEvents.MessageIDRec(QUERY.CODE)),
            ("by kind", EventTypeRec(0)),
            ("by id", QueryEvents.EventIDRec(UNKNOWN_ID)),
        )
    ),
)


# --- what comes by itself -------------------------------------------------------------------------------------------


def fast_event(walker: Walker, role: str) -> None:
    """The sender has a periodic event, and its first report has come."""
    wanted = CreateEvent(HELD, PERIODIC, FAST, QUERY)
    client = walker.client(role)
    confirmed = client.ask(wanted, ConfirmEventRequest, has(request_id=HELD), to=walker.component)
    walker.tester.memory["held"] = confirmed.event_id
    walker.tester.memory["rate"] = confirmed.confirmed_periodic_rate
    client.expect(Event)


def _stream_is_right(then: Aftermath) -> None:
    walker = then.walker
    streams.look(walker.client(then.role), held(walker), walker.tester.memory["rate"], ReportEventTimeout)


def event_time(walker: Walker) -> float:
    """Seconds until an event ends."""
    report = walker.client(OBSERVER).ask(QueryEventTimeout(), ReportEventTimeout, to=walker.component)
    minutes = int(report.timeout)
    if not 0 < minutes * 60 <= LONGEST:
        raise Skipped(f"events time out after {minutes} min" if minutes else "events never time out")
    return minutes * 60.0


NOT_RENEWED: Final = Stimulus(
    "Timeout",
    None,
    "an event is not renewed",
    before=hold_event,
    after=drop_events,
    seconds=event_time,
    earliest=EARLIEST,
    once=True,
)
DUE: Final = Stimulus(
    "EventOccurred",
    None,
    "an event is due",
    {"eventExists": True},
    before=fast_event,
    after=drop_events,
    verify=_stream_is_right,
    seconds=lambda _: 1.0,
)
PROVOKED: Final = frozenset({"CommandCompleted"})
"""Internal events that steps with other names bring about: a command event of a command that ends at once."""
