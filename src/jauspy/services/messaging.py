"""The messages of a component: inputs are decoded, reports are restricted to the requested fields, encoded and queued.

Messages leave through the state machine of the service Transport, which puts them into the `OutputQueue`. Presence
vectors (AS5710): a report carries the optional fields that were requested and that the service has, and nothing else.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from typing import Any, Final, NamedTuple, TypeAlias, TypeVar

from jauspy.codec.layout import Composite, Repeat, Slot
from jauspy.codec.message import Message, Struct
from jauspy.codec.registry import Registry
from jauspy.errors import DecodeError, EncodeError
from jauspy.ids import JausID
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Broadcast, Priority
from jauspy.services.deferred import Deferred, PendingReply
from jauspy.services.state_machine import ActionErrors, BoundAction, MachineInstance, Trigger, TriggerOutcome

_SUFFIX: Final = "presence_vector"
_SENSOR_VECTOR: Final = "query_presence_vector"
"""In the records of a query about several sensors (AS6060): for the record with the same SensorID; 0 is all."""
_VECTORS: Final[dict[type[Message], tuple[tuple[str, str], ...]]] = {}
_OPTIONAL: Final[dict[type[Struct], tuple[str, ...]]] = {}
_SENSOR_LISTS: Final[dict[type[Message], tuple[str, ...]]] = {}
_SEND_EVENTS: Final = ("Send", "BroadcastLocal", "BroadcastGlobal")
"""The internal events of Transport, by `Broadcast`."""

S = TypeVar("S", bound=Struct)
Reply: TypeAlias = bytes | PendingReply | None
"""The encoded answer to a query, now or deferred; None: nothing."""


class InputDecoder:
    """Decodes the inputs of a component, in the versions of its services; malformed messages are counted."""

    def __init__(
        self, kinds: Mapping[int, type[Message]], registry: Registry, count: Callable[[str, str], None]
    ) -> None:
        self._kinds = kinds
        self._registry = registry
        self._count = count

    def decode(self, payload: bytes, source: JausID) -> Message | None:
        """Decode a received message; None, and counted, when the component does not take it."""
        if source.is_wildcard:
            self._count("bad_source", str(source))
        elif len(payload) < 2:
            self._count("too_short", payload.hex())
        elif (kind := self._kinds.get(int.from_bytes(payload[:2], "little"))) is None:
            self._count("unknown_message", payload[:2].hex())
        else:
            try:
                return self._registry.decode_as(kind, payload)
            except DecodeError as error:
                return self._decode_lenient(kind, payload, f"from {source}: {error}")
        return None

    def read(self, content: Message | bytes) -> Message | None:
        """Decode a message inside another one; None when the component does not take it."""
        if isinstance(content, Message):
            if self._kinds.get(content.CODE) is type(content):
                return content
            content = content.encode(strict=False)
        kind = self._kinds.get(int.from_bytes(content[:2], "little"))
        try:
            return self._registry.decode_as(kind, content) if kind and len(content) >= 2 else None
        except DecodeError:
            return None

    def _decode_lenient(self, kind: type[Message], payload: bytes, detail: str) -> Message | None:
        """Accept values that are merely outside of their value sets: an emergency counts whatever its code."""
        message, deviations = self._registry.decode_as(kind, payload, strict=False)
        if any(deviation.lost for deviation in deviations):
            self._count(f"malformed_{kind.NAME}", detail)
            return None
        self._count(f"deviating_{kind.NAME}", detail)
        return message


class Outgoing(NamedTuple):
    """One encoded message to be sent."""

    destination: JausID
    payload: bytes
    priority: Priority = Priority.STANDARD
    broadcast: Broadcast = Broadcast.NONE
    on_acknowledged: Callable[[bool], None] | None = None
    """With it, the message is resent until it is acknowledged (called with True) or given up (False)."""


class OutputQueue:
    """First in, first out; when full, the oldest message of the lowest priority is dropped and counted."""

    def __init__(self, limit: int, counters: Counters) -> None:
        self._limit = limit
        self._counters = counters
        self._queue: deque[Outgoing] = deque()

    def put(self, outgoing: Outgoing) -> None:
        """Queue a message."""
        self._queue.append(outgoing)
        if len(self._queue) > self._limit:
            self._queue.remove(min(self._queue, key=lambda each: each.priority))
            self._counters["output_dropped"] += 1

    def drain(self) -> list[Outgoing]:
        """All queued messages, oldest first; the queue is empty afterwards."""
        taken = list(self._queue)
        self._queue.clear()
        return taken


class MessageSender:
    """Encodes messages and passes them to `dispatch`, or, while a query is only asked, captures them."""

    def __init__(self, dispatch: Callable[[Trigger], TriggerOutcome], errors: ActionErrors, counters: Counters) -> None:
        self._dispatch = dispatch
        self._errors = errors
        self._counters = counters
        self._captured: list[Outgoing | Deferred] | None = None

    def send(
        self,
        destination: JausID,
        message: Message,
        priority: Priority,
        broadcast: Broadcast,
        on_acknowledged: Callable[[bool], None] | None,
    ) -> None:
        """Send a message; one that cannot be encoded is recorded as an error and not sent."""
        payload = self._encode(message)
        if payload is None:
            return
        outgoing = Outgoing(destination, payload, priority, broadcast, on_acknowledged)
        if self._captured is not None:
            self._captured.append(outgoing)
        else:
            self._dispatch(Trigger(_SEND_EVENTS[broadcast], outgoing))

    def ask(self, machine: MachineInstance, trigger: Trigger) -> tuple[TriggerOutcome, Reply]:
        """What a query leads to, and the first message that its source would be sent for it; nothing is sent."""
        outer, self._captured = self._captured, []
        try:
            action = machine.sole_action(trigger.key)
            if action is None or action.report is None:
                outcome, reply = machine.ask(trigger), None
            else:
                outcome, reply = self._report(action, action.report, trigger)
            for each in self._captured:
                if isinstance(each, Deferred):
                    return outcome, self._pending(each, trigger)
                if each.destination == trigger.source:
                    return outcome, each.payload
            return outcome, reply
        finally:
            self._captured = outer

    def captures(self, deferred: Deferred, *, to_source: bool) -> bool:
        """True while a query is only asked: then the deferred report is sent to nobody."""
        if self._captured is not None and to_source:
            self._captured.append(deferred)
        return self._captured is not None

    def _report(
        self, action: BoundAction, make: Callable[[Trigger], object], trigger: Trigger
    ) -> tuple[TriggerOutcome, Reply]:
        """The fast path of most queries: the report itself, without the state machine that would send it."""
        try:
            report = make(trigger)
            if isinstance(report, Deferred):
                return TriggerOutcome.TAKEN, self._pending(report, trigger)
            return TriggerOutcome.TAKEN, self._encode_requested(report, trigger)
        except Exception as error:  # noqa: BLE001 - any bug of a service
            self._errors.record(action.name, trigger, error)
            return TriggerOutcome.FAILED, None

    def _pending(self, deferred: Deferred, trigger: Trigger) -> PendingReply:
        return PendingReply(deferred, lambda report: self._encode_requested(report, trigger))

    def _encode_requested(self, report: object, trigger: Trigger) -> bytes | None:
        return self._encode(requested_report(report, trigger)) if isinstance(report, Message) else None

    def _encode(self, message: Message) -> bytes | None:
        try:
            return message.encode()
        except EncodeError as error:
            self._counters["unencodable"] += 1
            self._errors.record(f"encoding {message.NAME}", Trigger("send", message), error)
            return None


# --- presence vectors -------------------------------------------------------------------------------------------------


def requested_report(report: Message, trigger: Trigger) -> Message:
    """The report with the fields that its query requests; all of it when no query triggered it."""
    query = trigger.msg
    return apply_presence_vectors(report, query) if isinstance(query, Message) and not query.IS_COMMAND else report


def apply_presence_vectors(report: Message, query: Message) -> Message:
    """The report without the optional fields that the query does not request.

    A query's `presence_vector` applies to the report's body, or, when nothing in that is optional, to the first record
    in it that has optional fields. A vector named after a part of the body, as `VelocityVarPresenceVector` is after
    `VelocityVar` and `LocalPosePresenceVector` after `ReportLocalPoseExtRec`, applies to the record in that part, and
    to all records in it when it requests nothing; one of a sensor applies to the records of that sensor.
    """
    for vector, part in _vectors(type(query)):
        requested = getattr(query, vector)
        if not part and _optional(type(report)):
            report = requested_fields(report, requested)
        else:
            report = _requested_in(report, part, requested) or report
    for name in _sensor_lists(type(query)):
        report = _sensors_requested(report, getattr(query, name))
    return report


def _requested_in(whole: S, part: str, requested: int) -> S | None:
    """`whole` with the vector applied to its first record with optional fields in `part`; None: there is no such."""
    for slot in _slots(type(whole)):
        member = getattr(whole, slot.name)
        if part in slot.name and isinstance(member, Struct):
            changed = (
                requested_fields(member, requested)
                if _optional(type(member))
                else _requested_inside(member, part, requested)
            )
            if changed is not None:
                whole = copy(whole)
                setattr(whole, slot.name, changed)
                return whole
    return None


def _requested_inside(whole: S, part: str, requested: int) -> S | None:
    if requested or not part:
        return _requested_in(whole, part, requested)
    whole = copy(whole)
    for slot in _slots(type(whole)):
        if isinstance(member := getattr(whole, slot.name), Struct):
            setattr(whole, slot.name, requested_fields(member, 0))
    return whole


def _sensors_requested(report: Message, records: Sequence[Any]) -> Message:
    """The report with the first vector that is for its sensor applied to each record of its lists."""
    report = copy(report)
    for slot in _slots(type(report)):
        if isinstance(slot.item, Repeat):
            setattr(report, slot.name, [_sensor_requested(each, records) for each in getattr(report, slot.name)])
    return report


def _sensor_requested(record: Any, requested: Sequence[Any]) -> Any:
    sensor = getattr(record, "sensor_id", None)
    found = next((each for each in requested if each.sensor_id in (0, sensor)), None)
    return record if sensor is None or found is None else requested_fields(record, found.query_presence_vector)


def _sensor_lists(query: type[Message]) -> tuple[str, ...]:
    """The lists of a query whose records have a vector for each sensor."""
    if (found := _SENSOR_LISTS.get(query)) is None:
        lists = {slot.name: slot.item.item for slot in _slots(query) if isinstance(slot.item, Repeat)}
        found = _SENSOR_LISTS[query] = tuple(
            name
            for name, record in lists.items()
            if isinstance(record, Composite) and any(slot.name == _SENSOR_VECTOR for slot in record.slots)
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


def requested_fields(record: S, requested: int) -> S:
    """The record without the optional fields that were not requested: bit i requests the i-th of them."""
    optional = enumerate(_optional(type(record)))
    unrequested = [name for bit, name in optional if not requested >> bit & 1 and getattr(record, name) is not None]
    if unrequested:
        record = copy(record)
        for name in unrequested:
            setattr(record, name, None)
    return record
