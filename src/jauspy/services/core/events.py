"""Events: a client asks once and is told again and again, at a rate or when something changes (AS5710)."""

from __future__ import annotations

from functools import partial
from typing import Any, Final, TypeAlias

from jauspy.arguments import check_number
from jauspy.codec.base import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import (
    CancelEvent,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    Event,
    EventTypeRec,
    QueryEvents,
    RejectEventRequest,
    ReportEvents,
    ReportEventTimeout,
    UpdateEvent,
)
from jauspy.protocol.header import Priority
from jauspy.services.core.command_events import CommandEvents, CompletedCommands, encoded
from jauspy.services.core.subscriptions import (
    EVERY_CHANGE,
    EXTRA_KINDS,
    FIRST_CHANGE,
    KINDS,
    ONE_TIME,
    PERIODIC,
    ClientEvent,
    EventRates,
    PendingCommand,
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


MAX_QUERY: Final = 4096
"""Bytes of a query that a subscription may hold."""

EventRequest: TypeAlias = CreateEvent | UpdateEvent | CancelEvent
EventSetup: TypeAlias = CreateEvent | UpdateEvent
EventRejectCode: TypeAlias = RejectEventRequest.ResponseCode


class EventRequests(CommandEvents):
    """The part of Events that judges requests. `_kinds` are the kinds of event that there are here."""

    rates: EventRates
    _kinds: frozenset[int]

    def is_supported(self, msg: EventSetup, source: JausID) -> bool:
        """The event can be set up as asked for."""
        return self._refusal(msg, source) is None

    def event_exists(self, msg: EventRequest | CreateCommandEvent | ClientEvent, source: JausID) -> bool:
        """The client has this event."""
        return self._find(msg, source) is not None

    def reject_event_request(self, msg: EventRequest | CreateCommandEvent, source: JausID) -> RejectEventRequest:
        """Why not."""
        return RejectEventRequest(request_id=msg.request_id, response_code=self._reason(msg, source))

    def _reason(self, msg: Any, source: JausID) -> EventRejectCode:
        if msg.CODE == CreateCommandEvent.CODE:
            return (
                EventRejectCode.MESSAGE_NOT_SUPPORTED
                if self._command(msg) is None
                else EventRejectCode.CONNECTION_REFUSED
            )
        if msg.CODE != CreateEvent.CODE and self._find(msg, source) is None:
            return EventRejectCode.INVALID_EVENT_ID
        return self._refusal(msg, source) or EventRejectCode.MESSAGE_NOT_SUPPORTED

    def _find(self, msg: Any, source: JausID) -> ClientEvent | None:
        if isinstance(msg, ClientEvent):
            told_again = isinstance(msg, PendingCommand) and self.ended.holds(msg)
            return msg if told_again or self.subscriptions.holds(msg) else None
        if msg.CODE == CreateEvent.CODE:
            return self.subscriptions.same(source, msg.event_type, encoded(msg.query_message))
        if msg.CODE == CreateCommandEvent.CODE:
            return self._find_command(msg, source)
        found = self.subscriptions.find(msg.event_id, source)
        return found if msg.CODE == CancelEvent.CODE or isinstance(found, Subscription) else None

    def _refusal(self, msg: EventSetup, source: JausID) -> EventRejectCode | None:
        """Why the event cannot be set up as asked for: a response code, None when it can."""
        if (kind := self._refused_kind(msg)) is not None:
            return kind
        query = self.host.read(msg.query_message)
        if query is None or not self.host.is_query(query):
            return EventRejectCode.MESSAGE_NOT_SUPPORTED
        if msg.event_type == PERIODIC and msg.requested_periodic_rate <= 0:
            return EventRejectCode.INVALID_EVENT_SETUP
        is_new = msg.CODE == CreateEvent.CODE and self._find(msg, source) is None
        if len(encoded(msg.query_message)) > MAX_QUERY or (is_new and self.subscriptions.full_for(source)):
            return EventRejectCode.CONNECTION_REFUSED
        return None

    def _refused_kind(self, msg: EventSetup) -> EventRejectCode | None:
        if msg.event_type not in self._kinds:
            return EventRejectCode.INVALID_EVENT_SETUP
        if msg.event_type == PERIODIC and not self.rates.highest:
            return EventRejectCode.PERIODIC_NOT_SUPPORTED
        if msg.event_type in (EVERY_CHANGE, FIRST_CHANGE) and not self.rates.change:
            return EventRejectCode.EVERY_CHANGE_NOT_SUPPORTED
        return None

    def _query(self, msg: EventSetup) -> Message:
        """The query of a request that `is_supported` has let through."""
        query = self.host.read(msg.query_message)
        assert query is not None
        return query


class Events(EventReports, EventRequests, urn="urn:jaus:jss:core:Events", private=True):
    """Subscriptions to any query that the component answers, and to the end of any command that it takes.

    `min_rate` and `max_rate` (Hz) bound periodic events, `max_change_rate` how often every-change events look for a
    change; 0 refuses events of that kind. Clients are told the rate they really get. Events end by themselves
    `timeout` minutes (1..255, 0: never) after they were last created or updated. `limit` bounds the events of the
    component, `limit_per_client` those of one client. `more_kinds` also takes two kinds of event that AS5710 has no
    numbers for: 2 reports the first change, 3 reports once, and both end with that.
    """

    def __init__(
        self,
        *,
        min_rate: float = 0.001,
        max_rate: float = 100.0,
        max_change_rate: float = 25.0,
        timeout: int = 1,
        limit: int = 128,
        limit_per_client: int = 32,
        more_kinds: bool = False,
    ) -> None:
        for name, value, most in (
            ("timeout", timeout, 255),
            ("limit", limit, 256),
            ("limit_per_client", limit_per_client, 256),
        ):
            check_number(value, f"events: {name}", whole=True)
            if not 0 <= value <= most:
                raise ConfigError(f"events: {name} is {value}; it must be 0..{most}")
        self.rates = EventRates(min_rate, max_rate, max_change_rate)
        self.timeout = timeout
        self.subscriptions = Subscriptions(limit, limit_per_client)
        self.ended = CompletedCommands()
        self._kinds = KINDS | EXTRA_KINDS if more_kinds else KINDS
        self._current: ClientEvent | None = None

    def leaving(self) -> None:
        """Clients know events by the id of the component: all end with it, and their clients are told."""
        for each in self.subscriptions.all():
            self._end(each)
            self.host.send(each.client, _confirmation(each, each.request_id))
        self.ended.clear()

    # --- actions

    def create_event(self, msg: CreateEvent, source: JausID) -> None:
        """A new subscription; the first report comes at once, that of a first change when it is one."""
        subscription = Subscription(
            self.subscriptions.free_id(), source, msg.request_id, msg.event_type, self._query(msg), due=self.host.now
        )
        self._set_rate(subscription, msg.requested_periodic_rate)
        self.subscriptions.add(subscription)
        self._current = subscription
        self._schedule(subscription)

    def update_event(self, msg: EventSetup, source: JausID) -> None:
        """Another rate, kind or query for an event that is there; an every-change event reports anew."""
        subscription = self._find(msg, source)
        if not isinstance(subscription, Subscription):
            return
        subscription.request_id, subscription.kind = msg.request_id, msg.event_type
        subscription.query, subscription.last = self._query(msg), None
        self._set_rate(subscription, msg.requested_periodic_rate)
        subscription.due = self.host.now + subscription.period
        self._current = subscription
        self._schedule(subscription)

    def cancel_event(self, msg: CancelEvent | ClientEvent, source: JausID) -> None:
        """The event ends; a command goes on, without anybody being told how it ends."""
        self._current = self._find(msg, source)
        if self._current is not None:
            self._end(self._current)

    def client_lost(self, client: JausID) -> None:
        """Nobody listens to these events any more."""
        for entry in self.subscriptions.of(client):
            self._end(entry)
        self.ended.forget_of(client)

    def reset_event_timer(self) -> None:
        """The event has its full time again."""
        current = self._current
        if self.timeout and current is not None:
            self.host.set_timer(
                ("event timeout", current.id),
                self.host.now + self.timeout * 60.0,
                lambda: self.host.fire("Timeout", current, current.client),
            )

    def stop_event_timer(self) -> None:
        """The event that ended does not time out any more: `cancel_event` has seen to that."""

    # --- reports

    def confirm_event_request(self, msg: EventRequest | CreateCommandEvent | ClientEvent) -> ConfirmEventRequest | None:
        """The event as it is now, with the rate that is really kept; 0 for a command, which has none."""
        if isinstance(self._current, PendingCommand):
            self._confirm_command(self._current, msg.request_id)
            return None
        return None if self._current is None else _confirmation(self._current, msg.request_id)

    def report_events(self, query: QueryEvents, source: JausID) -> ReportEvents:
        """The client's own events that report: all, or by id, kind or query message."""
        chosen = [each for each in self.subscriptions.queries(source) if _matches(each, query)]
        return ReportEvents(
            event_list=[
                ReportEvents.ReportEventRec(
                    # The report has no numbers for the other two; one is like a change that happens once.
                    event_type=PERIODIC if each.kind == PERIODIC else EVERY_CHANGE,
                    event_id=each.id,
                    query_message=each.query,
                )
                for each in chosen[:255]
            ]
        )

    def report_event_timeout(self) -> ReportEventTimeout:
        """Minutes, 0 when events do not time out."""
        return ReportEventTimeout(timeout=self.timeout)


def _confirmation(entry: ClientEvent, request_id: int) -> ConfirmEventRequest:
    rate = entry.confirmed if isinstance(entry, Subscription) else 0.0
    return ConfirmEventRequest(request_id=request_id, event_id=entry.id, confirmed_periodic_rate=rate)


def _matches(subscription: Subscription, query: QueryEvents) -> bool:
    match query.query_events_var:
        case QueryEvents.EventIDRec(event_id=number):
            return subscription.id == number
        case EventTypeRec(event_type=kind):
            return subscription.kind == kind
        case QueryEvents.MessageIDRec(message_code=code):
            return code == subscription.query.CODE
        case _:
            return True
