"""What services say: encoded, then sent by the machine of Transport; or kept for the one who only asked."""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Sequence
from copy import copy
from typing import Any, Final, NamedTuple, TypeAlias, TypeVar

from jauspy.codec.base import Message, Struct
from jauspy.codec.layout import Composite, Repeat, Slot
from jauspy.errors import EncodeError
from jauspy.ids import JausID
from jauspy.protocol.header import Broadcast, Priority
from jauspy.services.deferred import Deferred, PendingReply
from jauspy.services.state_machine import ActionErrors, BoundAction, MachineInstance, Trigger, TriggerOutcome


class Outgoing(NamedTuple):
    """One encoded message on its way out."""

    destination: JausID
    payload: bytes
    priority: Priority = Priority.STANDARD
    broadcast: Broadcast = Broadcast.NONE
    told: Callable[[bool], None] | None = None
    """With it, the message is sent again until it is acknowledged, or given up: this is told which."""


class OutputQueue:
    """First in, first out; when full, the oldest of the lowest priority is dropped and counted."""

    def __init__(self, limit: int, counters: Counter[str]) -> None:
        self._limit = limit
        self._counters = counters
        self._queue: deque[Outgoing] = deque()

    def put(self, outgoing: Outgoing) -> None:
        """Queue one more."""
        self._queue.append(outgoing)
        if len(self._queue) > self._limit:
            self._queue.remove(min(self._queue, key=lambda each: each.priority))
            self._counters["output_dropped"] += 1

    def drain(self) -> list[Outgoing]:
        """Everything that waits, oldest first; the queue is empty afterwards."""
        taken = list(self._queue)
        self._queue.clear()
        return taken


_SUFFIX: Final = "presence_vector"
_OF_SENSOR: Final = "query_presence_vector"
"""In the records of a query about several sensors (AS6060): it is about the record with the same SensorID; 0 is all."""
_VECTORS: Final[dict[type[Message], tuple[tuple[str, str], ...]]] = {}
_OPTIONAL: Final[dict[type[Struct], tuple[str, ...]]] = {}
_OF_SENSORS: Final[dict[type[Message], tuple[str, ...]]] = {}

S = TypeVar("S", bound=Struct)


def apply_presence_vectors(report: Message, query: Message) -> Message:
    """The report without the optional fields that the query did not ask for.

    A query's `presence_vector` masks the report's body, or when nothing in that is optional the first record in it that
    has optional fields. A vector named after a part of the body, as `VelocityVarPresenceVector` is after `VelocityVar`
    and `LocalPosePresenceVector` after `ReportLocalPoseExtRec`, masks the record in that part, and all records in it
    when it asks for nothing; one of a sensor masks the records of that sensor.
    """
    for vector, part in _vectors(type(query)):
        asked = getattr(query, vector)
        if not part and _optional(type(report)):
            report = without_fields(report, asked)
        else:
            report = _masked_in(report, part, asked) or report
    for name in _of_sensors(type(query)):
        report = _sensors_masked(report, getattr(query, name))
    return report


def _masked_in(whole: S, part: str, asked: int) -> S | None:
    """`whole`, its first record that has optional fields and lies in what is called `part` masked; None: no such."""
    for slot in _slots(type(whole)):
        member = getattr(whole, slot.name)
        if part in slot.name and isinstance(member, Struct):
            changed = without_fields(member, asked) if _optional(type(member)) else _masked_inside(member, part, asked)
            if changed is not None:
                whole = copy(whole)
                setattr(whole, slot.name, changed)
                return whole
    return None


def _masked_inside(whole: S, part: str, asked: int) -> S | None:
    if asked or not part:
        return _masked_in(whole, part, asked)
    whole = copy(whole)
    for slot in _slots(type(whole)):
        if isinstance(member := getattr(whole, slot.name), Struct):
            setattr(whole, slot.name, without_fields(member, 0))
    return whole


def _sensors_masked(report: Message, records: Sequence[Any]) -> Message:
    """The report with each record of its lists masked by the first of the query's records that is about its sensor."""
    report = copy(report)
    for slot in _slots(type(report)):
        if isinstance(slot.item, Repeat):
            setattr(report, slot.name, [_sensor_masked(each, records) for each in getattr(report, slot.name)])
    return report


def _sensor_masked(record: Any, asked: Sequence[Any]) -> Any:
    sensor = getattr(record, "sensor_id", None)
    found = next((each for each in asked if each.sensor_id in (0, sensor)), None)
    return record if sensor is None or found is None else without_fields(record, found.query_presence_vector)


def _of_sensors(query: type[Message]) -> tuple[str, ...]:
    """The lists of a query whose records have a vector for each sensor."""
    if (found := _OF_SENSORS.get(query)) is None:
        lists = {slot.name: slot.item.item for slot in _slots(query) if isinstance(slot.item, Repeat)}
        found = _OF_SENSORS[query] = tuple(
            name
            for name, record in lists.items()
            if isinstance(record, Composite) and any(slot.name == _OF_SENSOR for slot in record.slots)
        )
    return found


def _vectors(query: type[Message]) -> tuple[tuple[str, str], ...]:
    """Each presence vector of a query, and the part of the report it is about (empty: all of it)."""
    if (found := _VECTORS.get(query)) is None:
        names = [slot.name for slot in _slots(query) if slot.name.endswith(_SUFFIX)]
        found = _VECTORS[query] = tuple((name, name.removesuffix(_SUFFIX).rstrip("_")) for name in names)
    return found


def _optional(record: type[Struct]) -> tuple[str, ...]:
    """The optional fields of a record in wire order, which is the order of their bits."""
    if (found := _OPTIONAL.get(record)) is None:
        found = _OPTIONAL[record] = tuple(slot.name for slot in _slots(record) if slot.optional)
    return found


def _slots(kind: type[Struct]) -> tuple[Slot, ...]:
    layout = kind.layout()
    return layout.slots if isinstance(layout, Composite) else ()


def without_fields(record: S, asked: int) -> S:
    """The record without the optional fields that were not asked for: bit i asks for the i-th of them."""
    optional = enumerate(_optional(type(record)))
    unasked = [name for bit, name in optional if not asked >> bit & 1 and getattr(record, name) is not None]
    if unasked:
        record = copy(record)
        for name in unasked:
            setattr(record, name, None)
    return record


Reply: TypeAlias = bytes | PendingReply | None
"""What a query is answered, now or later; None: nothing."""

_EVENTS: Final = ("Send", "BroadcastLocal", "BroadcastGlobal")
"""The internal events of Transport, by `Broadcast`."""


class MessageSender:
    """Encodes messages and hands them to `dispatch`."""

    def __init__(
        self, dispatch: Callable[[Trigger], TriggerOutcome], bugs: ActionErrors, counters: Counter[str]
    ) -> None:
        self._dispatch = dispatch
        self._bugs = bugs
        self._counters = counters
        self._kept: list[Outgoing | Deferred] | None = None

    def send(
        self,
        destination: JausID,
        message: Message,
        priority: Priority,
        broadcast: Broadcast,
        told: Callable[[bool], None] | None,
    ) -> None:
        """Send a message; one that cannot be encoded is a bug: it is logged, counted and not sent."""
        payload = self._encoded(message)
        if payload is None:
            return
        outgoing = Outgoing(destination, payload, priority, broadcast, told)
        if self._kept is not None:
            self._kept.append(outgoing)  # it is only asked for, so the machine that sends has no part in it
        else:
            self._dispatch(Trigger(_EVENTS[broadcast], outgoing))

    def answer(self, machine: MachineInstance, trigger: Trigger) -> tuple[TriggerOutcome, Reply]:
        """What becomes of a query, and the first message that its source would be sent for it; nothing is sent."""
        outer, self._kept = self._kept, []
        try:
            step = machine.only_step(trigger.key)
            if step is None or step.report is None:
                outcome, report = machine.ask(trigger), None
            else:
                outcome, report = self._made(step, step.report, trigger)
            for each in self._kept:
                if isinstance(each, Deferred):
                    return outcome, self._coming(each, trigger)
                if each.destination == trigger.source:
                    return outcome, each.payload
            return outcome, report
        finally:
            self._kept = outer

    def keeps(self, later: Deferred, *, to_source: bool) -> bool:
        """True when it is only asked for: then it is sent to nobody."""
        if self._kept is not None and to_source:
            self._kept.append(later)
        return self._kept is not None

    def _made(
        self, step: BoundAction, make: Callable[[Trigger], Message | Deferred | None], trigger: Trigger
    ) -> tuple[TriggerOutcome, Reply]:
        """The short cut of most queries: the report itself, not what a machine does to send it."""
        try:
            report = make(trigger)
            if isinstance(report, Deferred):
                return TriggerOutcome.TAKEN, self._coming(report, trigger)
            return TriggerOutcome.TAKEN, self._masked(report, trigger)
        except Exception as error:  # noqa: BLE001 - any bug of a service
            self._bugs.met(step.name, trigger, error)
            return TriggerOutcome.FAILED, None

    def _coming(self, later: Deferred, trigger: Trigger) -> PendingReply:
        return PendingReply(later, lambda report: self._masked(report, trigger))

    def _masked(self, report: Message | None, trigger: Trigger) -> bytes | None:
        return None if report is None else self._encoded(requested_part(report, trigger))

    def _encoded(self, message: Message) -> bytes | None:
        try:
            return message.encode()
        except EncodeError as error:
            self._counters["unencodable"] += 1
            self._bugs.met(f"encoding {message.NAME}", Trigger("send", message), error)
            return None


def requested_part(report: Message, trigger: Trigger) -> Message:
    """The report with what the query that triggered it asks for; all of it when something else did."""
    asked = trigger.msg
    return apply_presence_vectors(report, asked) if isinstance(asked, Message) and not asked.IS_COMMAND else report
