"""State tables of services, written by hand from AS5710 and AS6009: state, message, answer, next state.

They use neither the JSIDL definitions nor the merged state machine, so they find a mistake in these that the engine and
the generated state tests share. Each row is one step. The generated tests cover what the tables leave out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.conformance.checks import Check, has, near
from jauspy.conformance.profile import ALL_SERVICES, ServiceKey, Step
from jauspy.conformance.results import Failed, Skipped, StepOutcome
from jauspy.conformance.steering import (
    ACCESS_CONTROL,
    MANAGEMENT,
    MIN_AUTHORITY,
    STOP,
    WAIT_FOR_NOTHING,
    ObservedState,
    Path,
    StateGoal,
    Status,
    Steering,
    judged_at_pace,
)
from jauspy.conformance.tester import CLIENTS, CONTROLLER, EMERGENCY_CLIENT, OBSERVER, OTHER_CLIENT, Client, Tester
from jauspy.ids import JausID
from jauspy.messages.core import (
    AllEventsRec,
    CancelEvent,
    ClearEmergency,
    ConfirmControl,
    ConfirmEventRequest,
    CreateEvent,
    DeleteElement,
    ElementRec,
    QueryAuthority,
    QueryControl,
    QueryElement,
    QueryElementCount,
    QueryElementList,
    QueryEvents,
    QueryEventTimeout,
    QueryHeartbeatPulse,
    QueryIdentification,
    QueryStatus,
    QueryTime,
    QueryTimeout,
    RejectControl,
    RejectElementRequest,
    RejectEventRequest,
    ReleaseControl,
    ReportAuthority,
    ReportControl,
    ReportElementCount,
    ReportElementList,
    ReportEvents,
    ReportEventTimeout,
    ReportHeartbeatPulse,
    ReportIdentification,
    ReportServices,
    ReportStatus,
    ReportTime,
    ReportTimeout,
    RequestControl,
    Reset,
    Resume,
    SetAuthority,
    SetElement,
    SetEmergency,
    SetTime,
    Shutdown,
    Standby,
    UpdateEvent,
)
from jauspy.messages.mobility import (
    QueryLocalWaypoint,
    QueryTravelSpeed,
    QueryWrenchEffort,
    ReportLocalWaypoint,
    ReportTravelSpeed,
    ReportWrenchEffort,
    SetLocalWaypoint,
    SetTravelSpeed,
    SetWrenchEffort,
)

OTHER: Final = OTHER_CLIENT
ACCEPTED, NOT_AVAILABLE, INSUFFICIENT = ConfirmControl.ResponseCode


@dataclass(frozen=True, slots=True)
class TableState:
    """A state as seen from outside, and the messages that lead there from `FREE`."""

    name: str
    status: Status
    controller: str | None = None
    """The role of the client in control."""
    route: Path = ()


FREE: Final = TableState("NotControlled.Standby", Status.STANDBY)
STANDBY: Final = TableState("Controlled.Standby", Status.STANDBY, CONTROLLER, (("RequestControl", CONTROLLER),))
READY: Final = TableState("Controlled.Ready", Status.READY, CONTROLLER, (*STANDBY.route, ("Resume", CONTROLLER)))
EMERGENCY: Final = TableState(
    "Controlled.Emergency", Status.EMERGENCY, CONTROLLER, (*STANDBY.route, ("SetEmergency", EMERGENCY_CLIENT))
)
FREE_EMERGENCY: Final = TableState(
    "NotControlled.Emergency", Status.EMERGENCY, None, (("SetEmergency", EMERGENCY_CLIENT),)
)
TAKEN_OVER: Final = TableState("Controlled.Standby by the other client", Status.STANDBY, OTHER)
EVERYWHERE: Final = (FREE, STANDBY, READY, EMERGENCY, FREE_EMERGENCY)

Checks: TypeAlias = tuple[Check, ...]


@dataclass(frozen=True, slots=True)
class Answer:
    """A message with these field values."""

    kind: type[Message]
    checks: Checks = ()


@dataclass(frozen=True, slots=True)
class Effect:
    """Answer that the observer must get afterwards. `checks` may depend on the authority of the controller."""

    query: Message
    report: type[Message]
    checks: Checks | Callable[[int], Checks]


@dataclass(frozen=True, slots=True)
class TableRow:
    """One line of a table. `message` may depend on the authority of the controller."""

    state: TableState
    sender: str
    message: Message | Callable[[int], Message]
    answer: Answer | None
    next: TableState
    variant: str = ""
    notice: Answer | None = None
    """Answer to the client that was in control."""
    effect: Effect | None = None


@dataclass(frozen=True, slots=True)
class StateTable:
    """The rows of one service."""

    service: str
    version: str
    source: str
    rows: tuple[TableRow, ...]


def answer(kind: type[Message], **fields: object) -> Answer:
    """A message whose fields have these values."""
    return Answer(kind, has(**fields))


def everywhere(sender: str, message: Message, right: Answer, variant: str = "") -> Iterator[TableRow]:
    """Rows for a message that has the same answer in every state and changes none."""
    return (TableRow(state, sender, message, right, state, variant=variant) for state in EVERYWHERE)


def ignored(message: Message, *places: tuple[TableState, str], variant: str = "") -> Iterator[TableRow]:
    """Rows for a message without answer or effect in these states, from these senders."""
    return (TableRow(state, sender, message, None, state, variant=variant) for state, sender in places)


# --- AS5710: Management, AccessControl --------------------------------------------------------------------------------

RELEASED: Final = answer(RejectControl, response_code=RejectControl.ResponseCode.CONTROL_RELEASED)
NOT_RELEASED: Final = answer(RejectControl, response_code=RejectControl.ResponseCode.NOT_AVAILABLE)


def _controlled_by(role: str | None) -> Answer:
    id = JausID.parse(CLIENTS[role]) if role else JausID(0, 0, 0)
    return answer(ReportControl, subsystem_id=id.subsystem, node_id=id.node, component_id=id.component)


MANAGEMENT_TABLE: Final = StateTable(
    MANAGEMENT,
    "1.1",
    "AS5710 rev. A, Management",
    (
        *(
            TableRow(state, OTHER, QueryStatus(), answer(ReportStatus, status=state.status), state)
            for state in EVERYWHERE
        ),
        TableRow(STANDBY, CONTROLLER, Resume(), None, READY),
        *ignored(Resume(), (FREE, OTHER), (STANDBY, OTHER), (READY, CONTROLLER), (EMERGENCY, CONTROLLER)),
        TableRow(READY, CONTROLLER, Standby(), None, STANDBY),
        *ignored(Standby(), (FREE, OTHER), (STANDBY, CONTROLLER), (READY, OTHER), (EMERGENCY, CONTROLLER)),
        TableRow(STANDBY, CONTROLLER, Reset(), RELEASED, FREE),
        TableRow(READY, CONTROLLER, Reset(), RELEASED, FREE),
        *ignored(Reset(), (FREE, OTHER), (STANDBY, OTHER), (READY, OTHER), (EMERGENCY, CONTROLLER)),
        *ignored(
            Shutdown(),
            (FREE, OTHER),
            (STANDBY, OTHER),
            (READY, OTHER),
            (EMERGENCY, CONTROLLER),
            (FREE_EMERGENCY, OTHER),
        ),
        TableRow(FREE, EMERGENCY_CLIENT, SetEmergency(STOP), None, FREE_EMERGENCY),
        TableRow(STANDBY, EMERGENCY_CLIENT, SetEmergency(STOP), None, EMERGENCY),
        TableRow(READY, EMERGENCY_CLIENT, SetEmergency(STOP), None, EMERGENCY),
        TableRow(READY, CONTROLLER, SetEmergency(STOP), None, EMERGENCY),
        TableRow(FREE_EMERGENCY, EMERGENCY_CLIENT, ClearEmergency(STOP), None, FREE),
        TableRow(EMERGENCY, EMERGENCY_CLIENT, ClearEmergency(STOP), None, STANDBY),
        *ignored(ClearEmergency(STOP), (FREE_EMERGENCY, OTHER), (EMERGENCY, CONTROLLER), (EMERGENCY, OTHER)),
    ),
)


def _confirm(code: ConfirmControl.ResponseCode) -> Answer:
    return answer(ConfirmControl, response_code=code)


def _less(authority: int) -> Message:
    return RequestControl(authority - 1)


def _more(authority: int) -> Message:
    return RequestControl(authority + 1)


def _lowered(authority: int) -> Message:
    return SetAuthority(authority - 1)


AUTHORITY_LOWERED: Final = Effect(
    QueryAuthority(), ReportAuthority, lambda authority: has(authority_code=authority - 1)
)
AUTHORITY_KEPT: Final = Effect(QueryAuthority(), ReportAuthority, lambda authority: has(authority_code=authority))
ACCESS_CONTROL_TABLE: Final = StateTable(
    ACCESS_CONTROL,
    "1.1",
    "AS5710 rev. A, AccessControl",
    (
        *(TableRow(state, OTHER, QueryControl(), _controlled_by(state.controller), state) for state in EVERYWHERE),
        *everywhere(OTHER, QueryTimeout(), answer(ReportTimeout)),
        *everywhere(OTHER, QueryAuthority(), answer(ReportAuthority)),
        TableRow(FREE, CONTROLLER, RequestControl, _confirm(ACCEPTED), STANDBY, effect=AUTHORITY_KEPT),
        TableRow(STANDBY, CONTROLLER, RequestControl, _confirm(ACCEPTED), STANDBY, variant="again"),
        TableRow(READY, CONTROLLER, RequestControl, _confirm(ACCEPTED), READY, variant="again"),
        TableRow(STANDBY, OTHER, _less, _confirm(INSUFFICIENT), STANDBY, variant="less authority"),
        TableRow(READY, OTHER, _less, _confirm(INSUFFICIENT), READY, variant="less authority"),
        TableRow(STANDBY, OTHER, RequestControl, _confirm(INSUFFICIENT), STANDBY, variant="the same authority"),
        TableRow(STANDBY, OTHER, _more, _confirm(ACCEPTED), TAKEN_OVER, variant="more authority", notice=RELEASED),
        TableRow(EMERGENCY, CONTROLLER, RequestControl, _confirm(NOT_AVAILABLE), EMERGENCY),
        TableRow(EMERGENCY, OTHER, _more, _confirm(NOT_AVAILABLE), EMERGENCY, variant="more authority"),
        TableRow(FREE_EMERGENCY, OTHER, RequestControl, _confirm(NOT_AVAILABLE), FREE_EMERGENCY),
        TableRow(STANDBY, CONTROLLER, ReleaseControl(), RELEASED, FREE),
        TableRow(READY, CONTROLLER, ReleaseControl(), RELEASED, FREE),
        TableRow(FREE, OTHER, ReleaseControl(), RELEASED, FREE),
        TableRow(EMERGENCY, CONTROLLER, ReleaseControl(), NOT_RELEASED, EMERGENCY),
        *ignored(ReleaseControl(), (STANDBY, OTHER), (READY, OTHER)),
        TableRow(STANDBY, CONTROLLER, _lowered, None, STANDBY, variant="less authority", effect=AUTHORITY_LOWERED),
        TableRow(READY, CONTROLLER, _lowered, None, READY, variant="less authority", effect=AUTHORITY_LOWERED),
        TableRow(READY, OTHER, _lowered, None, READY, variant="less authority", effect=AUTHORITY_KEPT),
        TableRow(EMERGENCY, CONTROLLER, _lowered, None, EMERGENCY, variant="less authority", effect=AUTHORITY_KEPT),
    ),
)

# --- AS5710: Events, Liveness, Time, Discovery, ListManager -----------------------------------------------------------

QUERY: Final = QueryEventTimeout()
A_REPORT: Final = ReportEventTimeout(1)
UNKNOWN_ID: Final = 251
REQUEST: Final = 7
EVERY_CHANGE: Final = CreateEvent.EventType.EVERY_CHANGE
REJECTED: Final = answer(RejectEventRequest, request_id=REQUEST)
EVENTS_TABLE: Final = StateTable(
    "urn:jaus:jss:core:Events",
    "1.1",
    "AS5710 rev. A, Events",
    (
        *everywhere(OTHER, QueryEvents(AllEventsRec(0)), answer(ReportEvents)),
        *everywhere(OTHER, QueryEventTimeout(), answer(ReportEventTimeout)),
        *everywhere(
            OTHER,
            CreateEvent(REQUEST, EVERY_CHANGE, 0.0, QUERY),
            answer(ConfirmEventRequest, request_id=REQUEST),
            "of a query",
        ),
        *everywhere(OTHER, CreateEvent(REQUEST, EVERY_CHANGE, 0.0, A_REPORT), REJECTED, "of a report"),
        *everywhere(
            OTHER,
            UpdateEvent(REQUEST, UpdateEvent.EventType.EVERY_CHANGE, 0.0, UNKNOWN_ID, QUERY),
            REJECTED,
            "an unknown one",
        ),
        *everywhere(OTHER, CancelEvent(REQUEST, UNKNOWN_ID), REJECTED, "an unknown one"),
    ),
)
LIVENESS_TABLE: Final = StateTable(
    "urn:jaus:jss:core:Liveness",
    "1.1",
    "AS5710 rev. A, Liveness",
    tuple(everywhere(OTHER, QueryHeartbeatPulse(), answer(ReportHeartbeatPulse))),
)
TIME_TABLE: Final = StateTable(
    "urn:jaus:jss:core:Time",
    "1.1",
    "AS5710 rev. A, Time",
    (
        *everywhere(OTHER, QueryTime(1), answer(ReportTime)),
        *ignored(SetTime(), (FREE, OTHER), (STANDBY, OTHER), (READY, OTHER)),
    ),
)
DISCOVERY_TABLE: Final = StateTable(
    "urn:jaus:jss:core:Discovery",
    "1.1",
    "AS5710 rev. A, Discovery",
    (
        *everywhere(OTHER, QueryIdentification(4), answer(ReportIdentification, query_type=4)),
        *everywhere(OTHER, ALL_SERVICES, answer(ReportServices)),
    ),
)


def _delete(uid: int) -> DeleteElement:
    return DeleteElement(DeleteElement.RequestIDRec(REQUEST), [DeleteElement.DeleteElementRec(uid)])


UNKNOWN_MESSAGE: Final = bytes.fromhex("ffee")
"""A message that no service defines, so no list can carry it out."""
UNSUPPORTED_ELEMENT: Final = SetElement(
    SetElement.RequestIDRec(REQUEST), [ElementRec(REQUEST, 0, 0, ElementRec.ElementData(0, UNKNOWN_MESSAGE))]
)
ELEMENT_REJECTED: Final = answer(RejectElementRequest, request_id=REQUEST)
LIST_TABLE: Final = StateTable(
    "urn:jaus:jss:core:ListManager",
    "1.1",
    "AS5710 rev. A, ListManager",
    (
        *everywhere(OTHER, QueryElementCount(), answer(ReportElementCount)),
        *everywhere(OTHER, QueryElementList(), answer(ReportElementList)),
        *ignored(QueryElement(UNKNOWN_ID), *((state, OTHER) for state in EVERYWHERE), variant="an unknown one"),
        TableRow(STANDBY, CONTROLLER, UNSUPPORTED_ELEMENT, ELEMENT_REJECTED, STANDBY, variant="an unknown message"),
        TableRow(READY, CONTROLLER, UNSUPPORTED_ELEMENT, ELEMENT_REJECTED, READY, variant="an unknown message"),
        *ignored(UNSUPPORTED_ELEMENT, (FREE, OTHER), (STANDBY, OTHER), variant="an unknown message"),
        TableRow(STANDBY, CONTROLLER, _delete(UNKNOWN_ID), ELEMENT_REJECTED, STANDBY, variant="an unknown one"),
        TableRow(READY, CONTROLLER, _delete(UNKNOWN_ID), ELEMENT_REJECTED, READY, variant="an unknown one"),
        *ignored(_delete(UNKNOWN_ID), (FREE, OTHER), (STANDBY, OTHER), variant="an unknown one"),
    ),
)

# --- AS6009: PrimitiveDriver, LocalWaypointDriver ---------------------------------------------------------------------

EFFORT: Final = SetWrenchEffort(propulsive_linear_effort_x=1.0)
"""Percent; moves no robot."""
FAR: Final = 1000.0
"""m; of a waypoint that is not driven to: it is set in Standby, with a travel speed of 0."""


def _effort_is(percent: float) -> Effect:
    return Effect(QueryWrenchEffort(1), ReportWrenchEffort, near(0.1, propulsive_linear_effort_x=percent))


DRIVER_TABLE: Final = StateTable(
    "urn:jaus:jss:mobility:PrimitiveDriver",
    "1.1",
    "AS6009 rev. A, PrimitiveDriver",
    (
        *everywhere(OTHER, QueryWrenchEffort(1), answer(ReportWrenchEffort)),
        TableRow(READY, CONTROLLER, EFFORT, None, READY, effect=_effort_is(1.0)),
        TableRow(READY, OTHER, EFFORT, None, READY, effect=_effort_is(0.0)),
        TableRow(STANDBY, CONTROLLER, EFFORT, None, STANDBY, effect=_effort_is(0.0)),
        TableRow(EMERGENCY, CONTROLLER, EFFORT, None, EMERGENCY, effect=_effort_is(0.0)),
        TableRow(FREE, OTHER, EFFORT, None, FREE, effect=_effort_is(0.0)),
    ),
)
WAYPOINT: Final = SetLocalWaypoint(x=FAR, y=FAR)
WAYPOINT_IS_SET: Final = Effect(QueryLocalWaypoint(3), ReportLocalWaypoint, near(0.01, x=FAR, y=FAR))
WAYPOINT_TABLE: Final = StateTable(
    "urn:jaus:jss:mobility:LocalWaypointDriver",
    "1.1",
    "AS6009 rev. A, LocalWaypointDriver",
    (
        *everywhere(OTHER, QueryTravelSpeed(), answer(ReportTravelSpeed)),
        *ignored(WAYPOINT, (FREE, OTHER), (STANDBY, OTHER), (READY, OTHER)),
        *ignored(SetTravelSpeed(0.0), (FREE, OTHER), (STANDBY, CONTROLLER), (READY, OTHER)),
        TableRow(STANDBY, CONTROLLER, WAYPOINT, None, STANDBY, effect=WAYPOINT_IS_SET),
    ),
)
TABLES: Final = (
    MANAGEMENT_TABLE,
    ACCESS_CONTROL_TABLE,
    EVENTS_TABLE,
    LIVENESS_TABLE,
    TIME_TABLE,
    DISCOVERY_TABLE,
    LIST_TABLE,
    DRIVER_TABLE,
    WAYPOINT_TABLE,
)

# --- steps ------------------------------------------------------------------------------------------------------------


def table_steps(component: JausID, offered: Iterable[ServiceKey], wanted: Iterable[ServiceKey]) -> list[Step]:
    """A step for each row of the `wanted` services whose state a component that offers these services can be in."""
    services = frozenset(urn for urn, _ in offered)
    tables = [table for table in TABLES if (table.service, table.version) in wanted]
    return [
        _step(component, services, table, row)
        for table in tables
        for row in table.rows
        if _is_possible(row.state, services)
    ]


def _is_possible(state: TableState, services: frozenset[str]) -> bool:
    needed = {MANAGEMENT} if state.status is not Status.STANDBY else {ACCESS_CONTROL} if state.controller else set()
    return needed <= services


def _step(component: JausID, services: frozenset[str], table: StateTable, row: TableRow) -> Step:
    example = row.message if isinstance(row.message, Message) else row.message(MIN_AUTHORITY)
    parts = ("table", table.service.rpartition(":")[2], row.state.name, example.NAME, row.sender, row.variant)
    variant = f", {row.variant}" if row.variant else ""
    return Step(
        "/".join(part.replace(" ", "-") for part in parts if part),
        f"{example.NAME} from the {row.sender} in {row.state.name}{variant}",
        partial(_run, RowTest(component, services, row)),
        why=table.source,
        moves=row.state is READY and ":core:" not in table.service and example.IS_COMMAND,
    )


@dataclass(frozen=True, slots=True)
class RowTest:
    """One row as a test of one component."""

    component: JausID
    services: frozenset[str]
    row: TableRow


def _run(test: RowTest, tester: Tester) -> None:
    """Bring the component to the state, and run the row."""
    steering = _steering_of(test, tester)
    try:
        judged_at_pace(tester, lambda: _bring(test, steering), lambda: _attempt(test, steering))
    finally:
        with tester.unreported(), suppress(StepOutcome):  # the verdict of the row stands
            _cancel_events(test, tester.client(CLIENTS[test.row.sender]))


def _attempt(test: RowTest, steering: Steering) -> None:
    row, authority = test.row, steering.authority
    message = row.message if isinstance(row.message, Message) else row.message(authority)
    with steering.silences.of_input(message.NAME, row.state.name):
        attempt(test, steering, message)


def _steering_of(test: RowTest, tester: Tester) -> Steering:
    """The one steering of this component for all tables of this run."""
    known: dict[JausID, Steering] = tester.memory.setdefault("steering of tables", {})
    if test.component not in known:
        known[test.component] = Steering(tester, test.component, test.services)
    return known[test.component]


def _cancel_events(test: RowTest, client: Client) -> None:
    for packet in list(client.confirmed):
        if packet.code == ConfirmEventRequest.CODE:
            event = ConfirmEventRequest.decode(packet.payload, strict=False)[0].event_id
            client.ask(CancelEvent(REQUEST, event), ConfirmEventRequest, to=test.component)


def _bring(test: RowTest, steering: Steering) -> None:
    """Lead the component to the state of the row.

    The first step that cannot get there fails; later ones for the same state are skipped.
    """
    tester, state = steering.tester, test.row.state
    lost: set[str] = tester.memory.setdefault(f"states out of reach of {test.component}", set())
    kind: type[StepOutcome] = Failed
    try:
        seen = steering.travel(_goal(FREE), state.route, _goal(state))
        problem = "" if _fits(seen, state) else f"it reports {seen}"
    except StepOutcome as outcome:
        problem, kind = str(outcome), type(outcome)
    if problem:
        kind = Skipped if state.name in lost else kind
        lost.add(state.name)
        raise kind(f"the component cannot be brought to {state.name}: {problem}")
    tester.keep_pace()
    for role in CLIENTS:
        client = tester.client(CLIENTS[role])
        client.pending.clear()
        client.confirmed.clear()
    for notes in (tester.why, tester.checks, tester.expected):
        notes.clear()


def _goal(state: TableState) -> StateGoal:
    return StateGoal(state.name, lambda seen: _fits(seen, state))


def _fits(seen: ObservedState, state: TableState) -> bool:
    """True if this state was observed. A value that is not reported counts as right."""
    controller = JausID.parse(CLIENTS[state.controller]) if state.controller else None
    return seen.status in (None, state.status) and (not seen.is_controller_known or seen.controller == controller)


def attempt(test: RowTest, steering: Steering, message: Message) -> None:
    """Send the message of the row, and compare the answers and the state afterwards with the row."""
    row, tester = test.row, steering.tester
    client = tester.client(CLIENTS[row.sender])
    if row.answer is None:
        client.send(message, to=test.component)
    else:
        client.ask(message, row.answer.kind, *row.answer.checks, to=test.component)
    if row.notice is not None:
        tester.client(CLIENTS[CONTROLLER]).expect(row.notice.kind, *row.notice.checks, source=test.component)
    with tester.unreported():
        if _shows_state(test):
            seen = steering.settle_on(_goal(row.next))
            problem = "" if _fits(seen, row.next) else f"it reports {seen}"
        else:  # it has time to answer
            tester.wait(WAIT_FOR_NOTHING * tester.timeout)
            problem = ""
    _check_no_other_messages(tester, answered=row.answer is not None)
    name = f"the state is {row.next.name}"
    tester.expected.append(name)
    tester.check(name, f"afterwards {problem}; {name} was expected" if problem else "")
    if row.effect is not None:
        checks = row.effect.checks
        observer = tester.client(CLIENTS[OBSERVER])
        right = checks(steering.authority) if callable(checks) else checks
        observer.ask_until_right(row.effect.query, row.effect.report, *right, to=test.component)


def _shows_state(test: RowTest) -> bool:
    return bool(test.services & {MANAGEMENT, ACCESS_CONTROL})


def _check_no_other_messages(tester: Tester, *, answered: bool) -> None:
    """Check that no client but the observer has received a message that the row does not name."""
    came = [
        f"{name} to the {role}"
        for role in CLIENTS
        if role != OBSERVER
        for name in tester.client(CLIENTS[role]).unasked()
    ]
    name = "nothing else comes" if answered else "there is no answer"
    tester.expected.append(name)
    tester.check(name, f"{', '.join(came)} came, where nothing should" if came else "")
