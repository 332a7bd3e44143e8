"""Mistakes of a whole kind, made only while a step looks: how every check that is made from JSIDL can be tripped.

A robot that says everything wrong cannot be led from state to state, and its steps are skipped. So these robots behave
until the input of a step is sent, and again once the step has seen enough.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, Final
from unittest.mock import patch

from tests.conformance.injectors import Injector, _spoilt, code, delayed, field, instead, patched, says
from tests.conformance.mistakes import goes_on, stuck, wrong_report

from jauspy.codec.layout import Composite
from jauspy.codec.message import Message, Struct
from jauspy.conformance import TargetComponent, VirtualTarget, silences, state_tables
from jauspy.conformance.state_tests import neutral_messages
from jauspy.conformance.state_tests.sensors import IMAGE_TIMEOUT as PICTURE_TIMEOUT
from jauspy.conformance.state_tests.state_test import StateTest
from jauspy.conformance.steering import MIN_AUTHORITY
from jauspy.conformance.tester import CLIENTS, OBSERVER
from jauspy.ids import JausID
from jauspy.messages import core, registry
from jauspy.messages.environment_sensing.v2_0.range_sensor import ConfirmSensorConfiguration
from jauspy.services.host import Host

WATCHING = JausID.parse(CLIENTS[OBSERVER])
ROLES = {JausID.parse(id) for id in CLIENTS.values()} - {WATCHING}
NONSENSE: Final = bytes.fromhex("ff4f")
"""An answer that nobody has defined."""


class Moment:
    """True while a step looks at what its input has done."""

    now = False


@contextmanager
def armed() -> Iterator[None]:
    """Make `Moment` follow the steps, and have each step tried however many were silent before."""
    attempt = StateTest.attempt

    def watched(self: StateTest, *arguments: Any) -> Any:
        Moment.now = True
        try:
            return attempt(self, *arguments)
        finally:
            Moment.now = False

    row = state_tables.attempt

    def watched_row(*arguments: Any) -> None:
        Moment.now = True
        try:
            row(*arguments)
        finally:
            Moment.now = False

    with (
        patch.object(StateTest, "attempt", watched),
        patch.object(state_tables, "attempt", watched_row),
        patch.object(silences, "MAX_SILENCES", sys.maxsize),
    ):
        yield


def answers(change: Callable[[bytes], Iterable[bytes]], *only: type[Message]) -> Injector:
    """What is said to those who act, or of it these kinds; the observer is told the truth."""
    return says(lambda payload, to: change(payload) if Moment.now and to in ROLES and _is(payload, only) else [payload])


def shown(change: Callable[[bytes], Iterable[bytes]]) -> Injector:
    """What the observer is told of effects, not of states."""
    return says(lambda payload, to: change(payload) if _shows(payload, to) else [payload])


def _is(payload: bytes, kinds: tuple[type[Message], ...]) -> bool:
    return not kinds or any(payload[:2] == code(each) for each in kinds)


def _shows(payload: bytes, to: JausID) -> bool:
    return Moment.now and to == WATCHING and not _is(payload, STATES)


def delays(condition: Callable[[bytes, JausID], bool], seconds: float = 2.9) -> Injector:
    """Said after the deadline, but so that it still counts as late."""
    return delayed(lambda outgoing: Moment.now and condition(outgoing.payload, outgoing.destination), seconds)


def talks_back() -> Injector:
    """Those who act are told something that nobody has asked for, before the observer is answered."""

    class Chatty(TargetComponent):
        def send(self, outgoing: Any, now: float) -> None:
            if Moment.now and outgoing.destination == WATCHING:
                for id in ROLES:
                    super().send(outgoing._replace(payload=NONSENSE, destination=id), now)
            super().send(outgoing, now)

    return lambda: (Chatty, VirtualTarget, [])


def silence(payload: bytes) -> list[bytes]:
    return []


def spoilt(payload: bytes) -> list[bytes]:
    return [_spoilt(payload)]


def changed(change: Callable[[Any], None]) -> Callable[[bytes], list[bytes]]:
    """The message, read, changed and written again."""

    def made(payload: bytes) -> list[bytes]:
        message, _ = registry.decode(payload, strict=False)
        change(message)
        return [message.encode(strict=False)]

    return made


def instead_of(kind: type[Message], change: Callable[[Any], None]) -> Callable[[bytes], list[bytes]]:
    """Only messages of this kind are changed."""
    return lambda payload: changed(change)(payload) if _is(payload, (kind,)) else [payload]


def fails(report: Any) -> None:
    report.status = core.ReportStatus.Status.FAILURE


def other_codes(message: Any) -> None:
    """Ids and codes are other ones that exist."""
    for part in (message, getattr(message, "request_id_rec", None)):
        for name in CODES:
            if (value := getattr(part, name, None)) is not None:
                others = list(type(value)) if isinstance(value, IntEnum) else [value ^ 1]
                setattr(part, name, next(each for each in others if each != value))


def twice(payload: bytes) -> list[bytes]:
    return [payload, payload]


def other_events(report: Any) -> None:
    """An event where there is none, and none where there is one."""
    none = core.ReportEvents.ReportEventRec(core.CreateEvent.EventType.PERIODIC, 1, core.QueryEventTimeout())
    report.event_list = [] if report.event_list else [none]


def other_elements(report: Any) -> None:
    """An element where there is none, and none where there is one."""
    report.element_list = [] if report.element_list else [core.ReportElementList.ElementListRec(99)]


def other_numbers(message: Any) -> None:
    """Every number is half a unit more, also those of a chosen kind."""
    for slot in message.layout().slots:
        value = getattr(message, slot.name)
        if isinstance(value, float):
            setattr(message, slot.name, value + 0.5)
        elif hasattr(value, "choice"):
            value.value += 0.5
        for each in value if isinstance(value, list) else ():
            other_numbers(each)


def other_settings(report: Any) -> None:
    """Of every sensor every number is another one."""
    (records,) = (value for slot in report.layout().slots if isinstance(value := getattr(report, slot.name), list))
    for record in (getattr(each, "h264_configuration_rec", each) for each in records):
        for name in (
            "update_rate",
            "horizontal_field_of_view",
            "frame_rate",
            "still_image_format",
            "group_of_pictures",
        ):
            if hasattr(record, name):
                setattr(record, name, getattr(record, name) + 1)


def other_sensors(confirmation: Any) -> None:
    for each in confirmation.confirm_sensor_list:
        each.sensor_id += 1


def another_id(message: Any) -> None:
    message.event_id ^= 64


def empty(message: Any) -> None:
    """Nothing optional is in it."""
    for part in (message, *(getattr(message, slot.name) for slot in message.layout().slots)):
        for slot in getattr(part.layout(), "slots", ()) if isinstance(part, Struct) else ():
            if slot.optional:
                setattr(part, slot.name, None)


def full(payload: bytes) -> list[bytes]:
    """The report with every optional field in it, each of them zero."""
    kind = type(registry.decode(payload, strict=False)[0])
    out = bytearray(payload[:2])
    _fill(kind.layout(), out)
    return [bytes(out)]


def _fill(item: Any, out: bytearray) -> None:
    if not isinstance(item, Composite):
        neutral_messages._write(item, out)
        return
    optional = sum(slot.optional for slot in item.slots)
    out += neutral_messages._packed(item.presence, (1 << optional) - 1) if item.presence else b""
    for slot in item.slots:
        _fill(slot.item, out)


def impatient() -> Injector:
    """Timers of control and of events are half as long as is said."""

    def hurried(self: Host, name: Any, at: float, action: Any, **options: Any) -> None:
        SET_TIMER(self, name, self.now + (at - self.now) / 2, action, **options)

    return patched(Host, set_timer=hurried)


def no_pictures(report: Any) -> None:
    report.still_image_data_list = []


def faster(confirmation: Any) -> None:
    confirmation.confirmed_periodic_rate *= 10


CODES: Final = (
    *("request_id", "response_code", "query_type", "command_result", "authority_code"),
    *("element_uid", "previous_uid", "next_uid", "element_count"),
    *("subsystem_id", "node_id", "component_id", "status"),
)
SET_TIMER: Final = Host.set_timer
STATES: Final[tuple[type[Message], ...]] = (core.ReportStatus, core.ReportControl, core.ReportEvents)
"""What the observer asks for in every step."""
SECOND: Final[tuple[type[Message], ...]] = (
    core.ConfirmControl,
    core.RejectControl,
    core.CommandEvent,
    core.ReportEvents,
    core.Event,
)
"""What comes after another answer."""
STREAM: Final = (core.Event,)
LOWER: Final = core.ReportAuthority(MIN_AUTHORITY - 1).encode()
"""What changes while a step looks for changes."""


@dataclass(frozen=True)
class Family:
    """`trips`: the names of the checks that it is for."""

    name: str
    trips: str
    inject: Injector


def _second(name: str, inject: Injector) -> Family:
    return Family(name, f"^({'|'.join(each.NAME for each in SECOND)}) ", inject)


def _effects(name: str, inject: Injector) -> Family:
    return Family(name, "^Report", inject)


def _stream(name: str, inject: Injector) -> Family:
    return Family(name, "^(a rate|they come at|the events|the sequence number)", inject)


LIES: Final = says(
    lambda payload, to: (
        changed(fails)(payload) if Moment.now and to == WATCHING and _is(payload, STATES[:1]) else [payload]
    )
)
FAMILIES: Final = (
    Family("talks back", "nothing else comes|there is no answer|what comes is", talks_back()),
    Family("is in another state", "^the state is", LIES),
    Family("sends all fields", "and (nothing else|no others)$", answers(full)),
    Family("is silent", " comes$", answers(silence)),
    Family("is short", "^[A-Z].* is as its definition says", answers(spoilt)),
    Family("is late", "in time$", delays(lambda payload, to: to in ROLES)),
    Family("has other ids and codes", rf"has (request_id_rec\.)?({'|'.join(CODES)})", answers(changed(other_codes))),
    Family("takes its time for a picture", "in time$", delays(lambda payload, to: to in ROLES, PICTURE_TIMEOUT * 1.5)),
    Family("has no pictures", "has a picture", answers(changed(no_pictures))),
    _second("gives no second answer", answers(silence, *SECOND)),
    _second("gives a short second answer", answers(spoilt, *SECOND)),
    _second("gives a late second answer", delays(lambda payload, to: _is(payload, SECOND))),
    _second("gives another second answer", answers(changed(other_codes), *SECOND)),
    *(
        Family(f"{how} to the client that was in control", "^RejectControl ", inject)
        for how, inject in (
            ("says nothing", answers(silence, core.RejectControl)),
            ("is short", answers(spoilt, core.RejectControl)),
            ("is late", delays(lambda payload, to: _is(payload, (core.RejectControl,)))),
            ("says something else", answers(changed(other_codes), core.RejectControl)),
        )
    ),
    _effects("does not show effects", shown(silence)),
    _effects("shows effects in short", shown(spoilt)),
    _effects("shows effects late", delays(_shows)),
    _effects("shows other effects", shown(changed(other_numbers))),
    _effects("shows another authority", shown(changed(other_codes))),
    _effects("shows nothing", shown(changed(empty))),
    _effects("shows everything", shown(full)),
    _stream("confirms a rate of zero", field(core.ConfirmEventRequest, confirmed_periodic_rate=0.0)),
    _stream("confirms ten times the rate", instead(core.ConfirmEventRequest, faster)),
    _stream("events have another id", answers(changed(another_id), *STREAM)),
    _stream("events do not count", answers(changed(stuck), *STREAM)),
    _stream("events carry another report", answers(changed(wrong_report), *STREAM)),
    Family("has other numbers", "has (x|y|latitude|longitude)", answers(changed(other_numbers))),
    Family("tells of changes that are none", "nothing is reported when", answers(twice, *STREAM)),
    Family("tells of changes late", "^Event .* in time", delays(lambda payload, to: payload.endswith(LOWER))),
    Family("sends no events", "^Event .* comes$", answers(silence, *STREAM)),
    Family("tells of other changes", "carries the new value", answers(changed(wrong_report), *STREAM)),
    Family("knows other events", "lists? the event", answers(changed(other_events), core.ReportEvents)),
    Family("gives other ids to events", "keeps its id", answers(changed(another_id), core.ConfirmEventRequest)),
    Family("does not end events", "^the events stop", goes_on()),
    Family("has another list", "^ReportElementList", shown(instead_of(core.ReportElementList, other_elements))),
    Family("has other settings", "^Report.* shows what was confirmed", shown(changed(other_settings))),
    Family(
        "confirms other sensors", "the answer is about", answers(changed(other_sensors), ConfirmSensorConfiguration)
    ),
    Family("is impatient", "come early$", impatient()),
    Family("is late after others were", "in time$", delays(lambda payload, to: to in ROLES)),
)
"""Late answers to one step may spoil the next; so the last one takes those once more."""
