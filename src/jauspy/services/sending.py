"""What services say: encoded, then sent by the machine of Transport; or kept for the one who only asked."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Final, TypeAlias

from jauspy.codec.base import Message
from jauspy.errors import EncodeError
from jauspy.ids import JausID
from jauspy.protocol.header import Broadcast, Priority
from jauspy.services.later import Deferred, PendingReply
from jauspy.services.outbox import Outgoing
from jauspy.services.presence import apply_presence_vectors
from jauspy.services.state_machine import ActionErrors, BoundAction, MachineInstance, Trigger, TriggerOutcome

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
