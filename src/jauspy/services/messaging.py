"""The messages of a component: inputs are decoded, reports are restricted to the requested fields, encoded and queued.

Messages leave through the state machine of the service Transport, which puts them into the `OutputQueue`.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping
from typing import Final, NamedTuple, TypeAlias

from jauspy.codec.message import Message
from jauspy.codec.registry import Registry
from jauspy.errors import DecodeError, EncodeError
from jauspy.ids import JausID, message_id
from jauspy.protocol.addressing import ID_REQUESTS
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Broadcast, Priority
from jauspy.services.deferred import Deferred, PendingReply
from jauspy.services.presence_vectors import requested_report
from jauspy.services.state_machine import ActionErrors, BoundAction, MachineInstance, Trigger, TriggerOutcome

_SEND_EVENTS: Final = ("Send", "BroadcastLocal", "BroadcastGlobal")
"""The internal events of Transport, by `Broadcast`."""

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
        if source.is_wildcard and message_id(payload) not in ID_REQUESTS:  # these are answered by broadcast
            self._count("bad_source", str(source))
        elif len(payload) < 2:
            self._count("too_short", payload.hex())
        elif (kind := self._kinds.get(message_id(payload))) is None:
            self._count("unknown_message", payload[:2].hex())
        else:
            try:
                return self._registry.decode_as(kind, payload)
            except DecodeError as error:
                return self._decode_lenient(kind, payload, f"from {source}: {error}")
        return None

    def decode_answer(self, kind: type[Message], payload: bytes, source: JausID) -> Message | None:
        """Decode an answer that a service expects as a client of another component; None, and counted, if malformed."""
        if source.is_wildcard:
            self._count("bad_source", str(source))
            return None
        try:
            return self._registry.decode_as(kind, payload)
        except DecodeError as error:
            self._count(f"malformed_{kind.NAME}", f"from {source}: {error}")
            return None

    def read(self, content: Message | bytes) -> Message | None:
        """Decode a message inside another one; None when the component does not take it."""
        if isinstance(content, Message):
            if self._kinds.get(content.CODE) is type(content):
                return content
            content = content.encode(strict=False)
        kind = self._kinds.get(message_id(content))
        try:
            return self._registry.decode_as(kind, content) if kind and len(content) >= 2 else None
        except DecodeError:
            return None

    def _decode_lenient(self, kind: type[Message], payload: bytes, detail: str) -> Message | None:
        """Accept values that are merely outside of their value sets: an emergency is accepted with any code."""
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
    """Callback with which the message is resent until it is acknowledged (called with True) or given up (False)."""


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
            self._queue.remove(min(self._queue, key=lambda queued: queued.priority))
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
        """The outcome of a query and the first message that would be sent to its source; nothing is sent."""
        outer, self._captured = self._captured, []
        try:
            action = machine.sole_action(trigger.key)
            if action is None or action.report is None:
                outcome, reply = machine.ask(trigger), None
            else:
                outcome, reply = self._report(action, action.report, trigger)
            for output in self._captured:
                if isinstance(output, Deferred):
                    return outcome, self._pending(output, trigger)
                if output.destination == trigger.source:
                    return outcome, output.payload
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
