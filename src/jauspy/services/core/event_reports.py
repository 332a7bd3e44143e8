"""When an event is due, and what its client is sent then."""

from __future__ import annotations

from functools import partial

from jauspy.codec.base import Message
from jauspy.messages.core import Event, RejectEventRequest
from jauspy.protocol.header import Priority
from jauspy.services.core.subscriptions import (
    EXTRA_KINDS,
    FIRST_CHANGE,
    ONE_TIME,
    PERIODIC,
    ClientEvent,
    EventRates,
    Subscription,
    Subscriptions,
)
from jauspy.services.deferred import PendingReply
from jauspy.services.service import Service
from jauspy.services.state_machine import TriggerOutcome


class EventReports(Service):
    """The part of Events that reports."""

    rates: EventRates
    subscriptions: Subscriptions

    def send_event(self, msg: Subscription) -> None:
        """Report to the subscriber what the component would answer it now; on change, only what is new to it."""
        if msg.asked is msg.query:
            self.host.count("event_skipped", f"{msg.query.NAME}: the answer before this one has not come yet")
            return
        outcome, answer = self.host.ask(msg.query, msg.client)
        if outcome is TriggerOutcome.FAILED:
            self.host.fire("EventError", msg, msg.client)
        if isinstance(answer, PendingReply):
            msg.asked = msg.query
            answer.add_done_callback(partial(self._came, msg, msg.query))
        elif answer is not None and _is_due(msg, answer):
            self._report(msg, answer)

    def _came(self, msg: Subscription, query: Message, answer: bytes | None) -> None:
        """An answer that took its time; meanwhile the event may have ended, or ask for something else."""
        if msg.asked is query:
            msg.asked = None
        is_wanted = msg.query is query and self.subscriptions.holds(msg)
        if is_wanted and answer is not None and _is_due(msg, answer):
            self._report(msg, answer)

    def _report(self, msg: Subscription, answer: bytes) -> None:
        event = Event(event_id=msg.id, sequence_number=msg.sequence, report_message=answer)
        # It comes again: where a client does not keep up, answers and changes, which are told once, are kept.
        self.host.send(msg.client, event, priority=Priority.LOW if msg.kind == PERIODIC else Priority.STANDARD)
        msg.sequence = msg.sequence + 1 & 0xFF
        if msg.kind in EXTRA_KINDS:
            self._end(msg)

    def send_reject_event_request(self, msg: Subscription) -> None:
        """The report has a bug, so the event ends, and its client is told that."""
        code = RejectEventRequest.ResponseCode.MESSAGE_NOT_SUPPORTED
        self.host.send(msg.client, RejectEventRequest(request_id=msg.request_id, response_code=code))
        self._end(msg)

    def _set_rate(self, subscription: Subscription, asked: float) -> None:
        if subscription.kind == PERIODIC:
            subscription.confirmed = self.rates.periodic(asked)
        else:
            subscription.confirmed = self.rates.on_change(asked)
        subscription.period = 1.0 / (subscription.confirmed or self.rates.change or self.rates.highest or 1.0)

    def _schedule(self, subscription: Subscription) -> None:
        self.host.set_timer(("event", subscription.id), subscription.due, partial(self._tick, subscription))

    def _tick(self, subscription: Subscription) -> None:
        # From due time to due time, so that the rate does not drift; after a stall what was missed is left out.
        missed = max(0, int((self.host.now - subscription.due) / subscription.period))
        subscription.due += (missed + 1) * subscription.period
        self._schedule(subscription)
        self.host.fire("EventOccurred", subscription, subscription.client)

    def _end(self, entry: ClientEvent) -> None:
        self.subscriptions.remove(entry)
        for timer in ("event", "event timeout", "command"):
            self.host.cancel_timer((timer, entry.id))


def _is_due(subscription: Subscription, report: bytes) -> bool:
    """True when the subscriber wants this report; remembers what it has then."""
    if subscription.kind in (PERIODIC, ONE_TIME):
        return True
    before, subscription.last = subscription.last, report
    return report != before and not (subscription.kind == FIRST_CHANGE and before is None)
