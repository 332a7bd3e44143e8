"""Events and command events: their requests, and what the component must send afterwards."""

from __future__ import annotations

from typing import Final

from jauspy.codec.message import Message
from jauspy.conformance import event_streams
from jauspy.conformance.checks import has, that
from jauspy.conformance.event_streams import ONE_HERTZ
from jauspy.conformance.results import Skipped, StepOutcome
from jauspy.conformance.state_tests.explorer import (
    MAX_TIMER_WAIT,
    MIN_TIMER_FRACTION,
    Explorer,
    Stimulus,
    StimulusResult,
)
from jauspy.conformance.tester import OBSERVER
from jauspy.messages.core import (
    AllEventsRec,
    CancelEvent,
    CommandEvent,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    Event,
    EventTypeRec,
    QueryAuthority,
    QueryEvents,
    QueryEventTimeout,
    QueryHeartbeatPulse,
    QueryIdentification,
    QueryTimeout,
    ReportAuthority,
    ReportEvents,
    ReportEventTimeout,
    ReportHeartbeatPulse,
    ReportIdentification,
    ReportTimeout,
    SetAuthority,
    Standby,
    UpdateEvent,
)
from jauspy.messages.mobility import SetLocalWaypoint, SetTravelSpeed

CREATE, UPDATE, CANCEL, PREPARED = 1, 2, 3, 9
"""Request ids."""
UNKNOWN_ID: Final = 251
PERIODIC, EVERY_CHANGE = CreateEvent.EventType.PERIODIC, CreateEvent.EventType.EVERY_CHANGE
QUERY: Final = QueryEventTimeout()
EVENT_QUERIES: Final[tuple[tuple[Message, type[Message]], ...]] = (
    (QUERY, ReportEventTimeout),
    (QueryTimeout(), ReportTimeout),
    (QueryHeartbeatPulse(), ReportHeartbeatPulse),
    (QueryIdentification(4), ReportIdentification),
    (QueryEvents(AllEventsRec(0)), ReportEvents),
)
"""Queries for the events of a test, and their reports. Components with Events 1.1 answer the first."""
A_REPORT: Final = ReportEventTimeout(1)
PAUSE: Final = 0.3
"""Timeouts in which no further event may arrive."""
FAST: Final = 10.0
"""Hertz of the streams that are checked."""


def event_query(explorer: Explorer) -> tuple[Message, type[Message]]:
    """A query that the component takes, and its report."""
    return next((candidate for candidate in EVENT_QUERIES if candidate[0].CODE in explorer.inputs), EVENT_QUERIES[-1])


def prepare_event(explorer: Explorer, role: str) -> None:
    """Create an event on every change for the sender."""
    wanted = CreateEvent(PREPARED, EVERY_CHANGE, 0.0, event_query(explorer)[0])
    made = explorer.client(role).ask(wanted, ConfirmEventRequest, has(request_id=PREPARED), to=explorer.component)
    explorer.tester.memory["prepared_event"] = made.event_id


def prepare_stream(explorer: Explorer, role: str) -> None:
    """Create a periodic event for the sender and wait for its first report."""
    wanted = CreateEvent(PREPARED, PERIODIC, FAST, event_query(explorer)[0])
    client = explorer.client(role)
    made = client.ask(wanted, ConfirmEventRequest, has(request_id=PREPARED), to=explorer.component)
    explorer.tester.memory["prepared_event"] = made.event_id
    explorer.tester.memory["rate"] = made.confirmed_periodic_rate
    client.expect(Event)


def prepared_event(explorer: Explorer) -> int:
    """The id of the prepared event."""
    found: int = explorer.tester.recall("prepared_event", "there is no event")
    return found


def drop_events(explorer: Explorer, role: str) -> None:
    """Cancel the events of the step."""
    client = explorer.client(role)
    for id in {explorer.tester.memory.pop("prepared_event", None), *confirmed(explorer, role)} - {None}:
        client.send(CancelEvent(PREPARED, id), to=explorer.component)
    explorer.observe()


def confirmed(explorer: Explorer, role: str) -> list[int]:
    """The ids of the events that were confirmed to this client in this step, in order."""
    return [confirmation.event_id for confirmation in _confirmations(explorer, role)]


def _confirmations(explorer: Explorer, role: str) -> list[ConfirmEventRequest]:
    return [
        ConfirmEventRequest.decode(heard.payload, strict=False)[0]
        for heard in explorer.client(role).confirmed
        if heard.code == ConfirmEventRequest.CODE and heard.source == explorer.component
    ]


def _known(then: StimulusResult, id: int, kind: int | None) -> None:
    """Check that the component lists this event with this kind; with None, that it does not list it any more."""
    wanted = [] if kind is None else [(id, kind)]
    right = that(
        "lists the event" if wanted else "does not list the event any more",
        lambda report: [(event.event_id, event.event_type) for event in report.event_list] == wanted,
    )
    client = then.explorer.client(then.role)
    client.ask(QueryEvents(QueryEvents.EventIDRec(id)), ReportEvents, right, to=then.explorer.component)


def _is_made(then: StimulusResult) -> None:
    _known(then, confirmed(then.explorer, then.role)[-1], PERIODIC)


def _is_kept(then: StimulusResult) -> None:
    _known(then, prepared_event(then.explorer), EVERY_CHANGE)


def _is_changed(then: StimulusResult) -> None:
    """Check that the event was changed and has its old id."""
    explorer, id = then.explorer, prepared_event(then.explorer)
    confirmation = _confirmations(explorer, then.role)[-1]
    same = confirmation.event_id == id
    explorer.tester.check("the event keeps its id", "" if same else f"{id} has become {confirmation.event_id}")
    _known(then, id, PERIODIC)
    _, report = event_query(explorer)
    event_streams.check_stream(explorer.client(then.role), id, confirmation.confirmed_periodic_rate, report)


def _is_gone(then: StimulusResult) -> None:
    _known(then, prepared_event(then.explorer), None)
    event_streams.check_stopped(
        then.explorer.client(then.role), prepared_event(then.explorer), PAUSE * then.explorer.tester.timeout
    )


def _changes_are_reported(then: StimulusResult) -> None:
    """Check that one change of the authority causes one report."""
    explorer, client = then.explorer, then.explorer.client(then.role)
    if not any(output.message == "ConfirmEventRequest" for output in then.outcome.outputs):
        return
    id = confirmed(explorer, then.role)[-1]
    explorer.tester.wait(0.1 * explorer.tester.timeout)
    client.forget(Event)  # the first report of such an event has the present value
    lower = explorer.authority - 1
    client.send(SetAuthority(lower), to=explorer.component)
    new = that("carries the new value", lambda event: _carried(event) == ReportAuthority(lower).encode())
    client.expect(Event, new, where=lambda event: event.event_id == id, source=explorer.component)
    more = client.collect(Event, PAUSE * explorer.tester.timeout, lambda event: event.event_id == id)
    explorer.tester.check("nothing is reported when nothing changes", f"{len(more)} events came" if more else "")
    then.took("EventOccurred")


def _carried(event: Event) -> bytes:
    inside = event.report_message
    return inside.encode(strict=False) if isinstance(inside, Message) else inside


EVENTS: Final = (
    Stimulus(
        "CreateEvent",
        lambda explorer: CreateEvent(CREATE, PERIODIC, ONE_HERTZ, event_query(explorer)[0]),
        "a new one",
        {"isSupported": True, "eventExists": False},
        after=drop_events,
        checks={"ConfirmEventRequest": has(request_id=CREATE)},
        verify=_is_made,
    ),
    Stimulus(
        "CreateEvent",
        lambda explorer: CreateEvent(CREATE, EVERY_CHANGE, 0.0, event_query(explorer)[0]),
        "one that is there",
        {"isSupported": True, "eventExists": True},
        before=prepare_event,
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
        lambda explorer: UpdateEvent(
            UPDATE, UpdateEvent.EventType.PERIODIC, FAST, prepared_event(explorer), event_query(explorer)[0]
        ),
        "one that is there",
        {"isSupported": True, "eventExists": True},
        before=prepare_event,
        after=drop_events,
        checks={"ConfirmEventRequest": has(request_id=UPDATE)},
        verify=_is_changed,
    ),
    Stimulus(
        "UpdateEvent",
        lambda explorer: UpdateEvent(
            UPDATE, UpdateEvent.EventType.PERIODIC, ONE_HERTZ, UNKNOWN_ID, event_query(explorer)[0]
        ),
        "an unknown one",
        {"isSupported": True, "eventExists": False},
        checks={"RejectEventRequest": has(request_id=UPDATE)},
    ),
    Stimulus(
        "UpdateEvent",
        lambda explorer: UpdateEvent(
            UPDATE, UpdateEvent.EventType.PERIODIC, ONE_HERTZ, prepared_event(explorer), A_REPORT
        ),
        "to a report instead of a query",
        {"isSupported": False, "eventExists": True},
        before=prepare_event,
        after=drop_events,
        checks={"RejectEventRequest": has(request_id=UPDATE)},
        verify=_is_kept,
    ),
    Stimulus(
        "CancelEvent",
        lambda explorer: CancelEvent(CANCEL, prepared_event(explorer)),
        "one that is there",
        {"eventExists": True},
        before=prepare_stream,
        after=drop_events,
        checks={"ConfirmEventRequest": has(request_id=CANCEL)},
        verify=_is_gone,
    ),
    Stimulus(
        "CancelEvent",
        lambda _: CancelEvent(CANCEL, UNKNOWN_ID),
        "an unknown one",
        {"eventExists": False},
        checks={"RejectEventRequest": has(request_id=CANCEL)},
    ),
    Stimulus(
        "CreateEvent",
        lambda _: CreateEvent(CREATE, EVERY_CHANGE, 0.0, QueryAuthority()),
        "of changes",
        {"eventExists": False},
        after=drop_events,
        verify=_changes_are_reported,
        by_controller=True,
        only_in="Ready",
        also=("EventOccurred",),
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


def _stream_is_right(then: StimulusResult) -> None:
    explorer = then.explorer
    event_streams.check_stream(
        explorer.client(then.role), prepared_event(explorer), explorer.tester.memory["rate"], event_query(explorer)[1]
    )


def event_time(explorer: Explorer) -> float:
    """Seconds until an event expires."""
    report = explorer.client(OBSERVER).ask(QueryEventTimeout(), ReportEventTimeout, to=explorer.component)
    minutes = int(report.timeout)
    if not 0 < minutes * 60 <= MAX_TIMER_WAIT:
        raise Skipped(f"events time out after {minutes} min" if minutes else "events never time out")
    return minutes * 60.0


NOT_RENEWED: Final = Stimulus(
    "Timeout",
    None,
    "an event is not renewed",
    before=prepare_event,
    after=drop_events,
    seconds=event_time,
    earliest=MIN_TIMER_FRACTION,
    once=True,
)
DUE: Final = Stimulus(
    "EventOccurred",
    None,
    "an event is due",
    {"eventExists": True},
    before=prepare_stream,
    after=drop_events,
    verify=_stream_is_right,
    seconds=lambda _: 1.0,
)


DURATION: Final = 1
"""Seconds that a command may take."""
WAYPOINTS: Final = "urn:jaus:jss:mobility:LocalWaypointDriver"
FAR: Final = 1000.0
"""m; of a waypoint that is not driven to, because the speed is zero."""
ENDLESS_COMMAND: Final = SetTravelSpeed(0.0)
"""A command to drive to a waypoint at speed 0, so it does not end by itself."""
IMMEDIATE_TIME: Final = 0.1
"""Timeouts within which an immediate command ends."""
Result = CommandEvent.CommandResult


def start_endless_command(explorer: Explorer, role: str) -> None:
    """Start a command with a command event that does not end by itself."""
    if WAYPOINTS not in explorer.services:
        raise Skipped("no endless command is known for a component without LocalWaypointDriver")
    client = explorer.client(role)
    client.send(SetLocalWaypoint(x=FAR, y=FAR), to=explorer.component)
    try:
        event = client.ask(
            CreateCommandEvent(PREPARED, DURATION, ENDLESS_COMMAND), ConfirmEventRequest, to=explorer.component
        )
    except StepOutcome as outcome:
        raise Skipped(f"the component makes no command event for a waypoint: {outcome}") from outcome
    explorer.tester.memory["prepared_event"] = event.event_id
    explorer.tester.wait(IMMEDIATE_TIME * explorer.tester.timeout)
    if any(packet.code == CommandEvent.CODE for packet in client.pending):
        raise Skipped("the component reports at once that it has reached the waypoint, so no endless command is known")


def stop_endless_command(explorer: Explorer, role: str) -> None:
    """Cancel the command event and stop driving."""
    drop_events(explorer, role)
    explorer.client(role).send(Standby(), to=explorer.component)
    explorer.where = None


def _end_is_reported(then: StimulusResult) -> None:
    """Check that the end of a confirmed command event is reported to its client in time."""
    if any(output.message == "ConfirmEventRequest" for output in then.outcome.outputs):
        events = confirmed(then.explorer, then.role)
        within = 1.0 + DURATION / then.explorer.tester.timeout
        taken = then.before.controller == then.role and "Available" in then.before.state
        right = has(command_result=Result.SUCCESSFUL if taken else Result.UNSUCCESSFUL)
        client = then.explorer.client(then.role)
        client.expect(CommandEvent, right, where=lambda end: end.event_id in events, within=within)
        then.took("CommandCompleted")


def _is_the_same(then: StimulusResult) -> None:
    explorer = then.explorer
    before, after = prepared_event(explorer), confirmed(explorer, then.role)[-1]
    explorer.tester.check("the event keeps its id", "" if before == after else f"{before} has become {after}")


COMMANDS: Final = (
    Stimulus(
        "CreateCommandEvent",
        lambda _: CreateCommandEvent(CREATE, DURATION, Standby()),
        "a new one",
        {"eventExists": False},
        after=drop_events,
        verify=_end_is_reported,
        also=("CommandCompleted",),
    ),
    Stimulus(
        "CreateCommandEvent",
        lambda explorer: CreateCommandEvent(CREATE, DURATION, SetAuthority(explorer.authority)),
        "of a command that ends at once",
        {"eventExists": False},
        after=drop_events,
        verify=_end_is_reported,
        by_controller=True,
        also=("CommandCompleted",),
    ),
    Stimulus(
        "CreateCommandEvent",
        lambda _: CreateCommandEvent(CREATE, DURATION, QUERY),
        "of a query",
        {"isCommandSupported": False},
        checks={"RejectEventRequest": has(request_id=CREATE)},
    ),
    Stimulus(
        "CreateCommandEvent",
        lambda _: CreateCommandEvent(CREATE, DURATION, ENDLESS_COMMAND),
        "one that is there",
        {"isCommandSupported": True, "eventExists": True},
        before=start_endless_command,
        after=stop_endless_command,
        checks={"ConfirmEventRequest": has(request_id=CREATE)},
        verify=_is_the_same,
        by_controller=True,
        only_in="Ready",
        moves=True,
    ),
)
EXPIRED: Final = Stimulus(
    "CommandExpired",
    None,
    "a command does not end",
    before=start_endless_command,
    after=stop_endless_command,
    checks={"CommandEvent": has(command_result=Result.UNSUCCESSFUL)},
    by_controller=True,
    only_in="Ready",
    moves=True,
    seconds=lambda _: DURATION,
    earliest=0.5,
)
