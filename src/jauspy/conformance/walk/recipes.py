"""The inputs of the core services and of cameras, with everything that their guards distinguish."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from jauspy.codec.base import Message
from jauspy.conformance.checks import has
from jauspy.conformance.offers import ALL_SERVICES
from jauspy.conformance.outcome import Skipped
from jauspy.conformance.streams import ONE_HERTZ
from jauspy.conformance.walk.pictures import PICTURES
from jauspy.conformance.walk.stimulus import Stimulus
from jauspy.conformance.walk.walker import OBSERVER, STOP, Walker
from jauspy.messages.core import (
    AllEventsRec,
    CancelEvent,
    ClearEmergency,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    DeleteElement,
    ElementRec,
    EventTypeRec,
    QueryAuthority,
    QueryConfiguration,
    QueryElement,
    QueryEvents,
    QueryEventTimeout,
    QueryIdentification,
    ReportAuthority,
    ReportEventTimeout,
    RequestControl,
    SetAuthority,
    SetElement,
    SetEmergency,
    Standby,
    UpdateEvent,
)

LONGEST: Final = 70.0
"""Seconds that a step may wait for a timer of the component: the default of events is a minute."""

CREATE, UPDATE, CANCEL, HELD = 1, 2, 3, 9
"""Request ids."""
UNKNOWN_ID: Final = 251
PERIODIC: Final = CreateEvent.EventType.PERIODIC
QUERY: Final = QueryEventTimeout()
"""Every component that has Events answers it."""
A_REPORT: Final = ReportEventTimeout(1)


# --- access control -------------------------------------------------------------------------------------------------


def below_default(walker: Walker) -> int:
    """An authority that is too low for anybody."""
    if walker.default_authority == 0:
        raise Skipped("the default authority of the component is 0: nothing is below it")
    return walker.default_authority - 1


_LEVELS: Final[tuple[tuple[str, Callable[[Walker], int], bool, bool, bool], ...]] = (
    ("authority below the default", below_default, True, False, False),
    ("less authority", lambda walker: walker.authority - 1, False, False, True),
    ("the same authority", lambda walker: walker.authority, False, False, True),
    ("more authority", lambda walker: walker.authority + 1, False, True, False),
)
"""Name, value, below the default, above the current one, valid for SetAuthority."""


def _requests() -> tuple[Stimulus, ...]:
    return tuple(
        Stimulus(
            "RequestControl",
            lambda walker, level=level: RequestControl(level(walker)),  # type: ignore[misc]  # a bound loop variable
            name,
            {"isDefaultAuthorityGreater": below, "isCurrentAuthorityLess": above},
        )
        for name, level, below, above, _ in _LEVELS
    )


def _authorities() -> tuple[Stimulus, ...]:
    return tuple(
        Stimulus(
            "SetAuthority",
            lambda walker, level=level: SetAuthority(level(walker)),  # type: ignore[misc]  # a bound loop variable
            name,
            {"isAuthorityValid": valid},
            verify=_authority_is(level),
        )
        for name, level, _, _, valid in _LEVELS
    )


def _authority_is(level: Callable[[Walker], int]) -> Callable[[Walker, bool], None]:
    def verify(walker: Walker, taken: bool) -> None:
        wanted = level(walker) if taken else walker.authority
        walker.client(OBSERVER).ask(QueryAuthority(), ReportAuthority, has(authority_code=wanted), to=walker.component)

    return verify


# --- events ---------------------------------------------------------------------------------------------------------


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


_EVENTS: Final = (
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
        lambda _: CreateCommandEvent(CREATE, 1, Standby()),
        "a new one",
        {"eventExists": False},
        after=drop_events,
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
    """The sender has a periodic event."""
    confirmed = walker.client(role).ask(
        CreateEvent(HELD, PERIODIC, 10.0, QUERY), ConfirmEventRequest, has(request_id=HELD), to=walker.component
    )
    walker.tester.memory["held"] = confirmed.event_id


def control_time(walker: Walker) -> float:
    """Seconds until control ends."""
    if not 0 < walker.timeout <= LONGEST:
        raise Skipped(f"control times out after {walker.timeout} s" if walker.timeout else "control never times out")
    return float(walker.timeout)


def event_time(walker: Walker) -> float:
    """Seconds until an event ends."""
    report = walker.client(OBSERVER).ask(QueryEventTimeout(), ReportEventTimeout, to=walker.component)
    minutes = int(report.timeout)
    if not 0 < minutes * 60 <= LONGEST:
        raise Skipped(f"events time out after {minutes} min" if minutes else "events never time out")
    return minutes * 60.0


SPONTANEOUS: Final[Mapping[str, Stimulus]] = {
    "Timedout": Stimulus("Timedout", None, "the client is silent", seconds=control_time),
    "Timeout": Stimulus(
        "Timeout", None, "an event is not renewed", before=hold_event, after=drop_events, seconds=event_time
    ),
    "EventOccurred": Stimulus(
        "EventOccurred",
        None,
        "an event is due",
        {"eventExists": True},
        before=fast_event,
        after=drop_events,
        seconds=lambda _: 1.0,
    ),
}
"""Internal events that can be brought about from outside."""


# --- all of it ------------------------------------------------------------------------------------------------------


def _one(message: Message, variant: str = "", **fields: object) -> Stimulus:
    """A message with fields that matter; `fields` are what its report must say."""
    checks = {message.NAME.replace("Query", "Report", 1): has(**fields)} if fields else {}
    return Stimulus(message.NAME, lambda _: message, variant, checks=checks)


# --- lists ----------------------------------------------------------------------------------------------------------


def _element(uid: int, previous: int = 0) -> SetElement:
    data = ElementRec.ElementData(0, Standby())
    return SetElement(SetElement.RequestIDRec(CREATE), [ElementRec(uid, previous, 0, data)])


_LISTS: Final = (
    Stimulus(
        "SetElement",
        lambda _: _element(7, previous=UNKNOWN_ID),
        "after an unknown one",
        {"isValidElementRequest": False},
        checks={"RejectElementRequest": has(request_id=CREATE)},
    ),
    Stimulus("SetElement", lambda _: _element(7), "a command that may be none of a list"),
    Stimulus(
        "DeleteElement",
        lambda _: DeleteElement(DeleteElement.RequestIDRec(CREATE), [DeleteElement.DeleteElementRec(UNKNOWN_ID)]),
        "an unknown one",
        {"elementExists": False},
        checks={"RejectElementRequest": has(request_id=CREATE)},
    ),
    Stimulus(
        "DeleteElement",
        lambda _: DeleteElement(DeleteElement.RequestIDRec(CREATE), [DeleteElement.DeleteElementRec(7)]),
        "one that may be there",
    ),
    Stimulus("QueryElement", lambda _: QueryElement(UNKNOWN_ID), "an unknown one", {"elementExists": False}),
    Stimulus("QueryElement", lambda _: QueryElement(7), "one that may be there"),
)

RECIPES: Final[tuple[Stimulus, ...]] = (
    *_requests(),
    *_authorities(),
    *_EVENTS,
    *_LISTS,
    *PICTURES,
    _one(SetEmergency(STOP)),
    _one(ClearEmergency(STOP)),
    *(_one(QueryIdentification(level), f"level {level}", query_type=level) for level in (1, 2, 3, 4)),
    *(_one(QueryConfiguration(level), f"level {level}") for level in (2, 3)),
    _one(ALL_SERVICES, "everything"),
)
"""Of all other inputs the neutral message is sent; queries with presence vectors ask for all and for none."""
