"""Events: clients subscribe to queries, and are sent the reports periodically or on change (AS5710)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any, Final, TypeAlias

from jauspy.arguments import check_number
from jauspy.codec.message import Message
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
from jauspy.services.core.event_clients import EventClients
from jauspy.services.core.subscriptions import (
    EVERY_CHANGE,
    EXTRA_KINDS,
    FIRST_CHANGE,
    KINDS,
    ONE_TIME,
    PERIODIC,
    ClientEvent,
    EventSubscription,
    PendingCommand,
    Subscriptions,
)
from jauspy.services.deferred import PendingReply
from jauspy.services.state_machine import TriggerOutcome

MAX_QUERY: Final = 4096
"""Bytes of a query that a subscription may hold."""
EventRequest: TypeAlias = CreateEvent | UpdateEvent | CancelEvent
EventSetup: TypeAlias = CreateEvent | UpdateEvent
EventRejectCode: TypeAlias = RejectEventRequest.ResponseCode


class Events(CommandEvents, urn="urn:jaus:jss:core:Events", private=True):
    """Subscriptions to every query that the component answers, and command events for every command that it takes.

    `min_rate` and `max_rate` (Hz) bound periodic events, `max_change_rate` how often every-change events check for a
    change; 0 refuses events of that kind. The confirmation contains the applied rate. Events end `timeout` minutes
    (1..255, 0: never) after they were last created or updated. `limit` bounds the events of the component,
    `limit_per_client` those of one client. `more_kinds` also accepts two kinds of event that AS5710 does not number: 2
    reports the first change, 3 reports once; both end then.
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
        self.completed = CompletedCommands()
        self._kinds = KINDS | EXTRA_KINDS if more_kinds else KINDS
        self._current: ClientEvent | None = None

    def attached(self) -> None:
        """Notice which clients are heard."""
        self._clients = EventClients(self.host)
        self.host.heard_by.append(self._clients.heard)

    def leaving(self) -> None:
        """End all events, since clients know them by the id of the component, and confirm that to the clients."""
        for subscription in self.subscriptions.all():
            self._end(subscription)
            self.host.send(subscription.client, _confirmation(subscription, subscription.request_id))
        self.completed.clear()

    # --- actions

    def create_event(self, msg: CreateEvent, source: JausID) -> None:
        """Add a subscription. The first report is sent immediately, except for first-change events."""
        subscription = EventSubscription(
            self.subscriptions.free_id(),
            client=source,
            request_id=msg.request_id,
            kind=msg.event_type,
            query=self._query(msg),
            content=encoded(msg.query_message),
            due=self.host.now,
        )
        self._set_rate(subscription, msg.requested_periodic_rate)
        self.subscriptions.add(subscription)
        self._clients.add(source)
        self._current = subscription
        self._schedule(subscription)

    def update_event(self, msg: EventSetup, source: JausID) -> None:
        """Change rate, kind or query of an event; an every-change event reports immediately."""
        subscription = self._find(msg, source)
        if not isinstance(subscription, EventSubscription):
            return
        subscription.request_id, subscription.kind = msg.request_id, msg.event_type
        subscription.query, subscription.last = self._query(msg), None
        subscription.content = encoded(msg.query_message)
        self._set_rate(subscription, msg.requested_periodic_rate)
        subscription.due = self.host.now + subscription.period
        self._current = subscription
        self._schedule(subscription)

    def cancel_event(self, msg: CancelEvent | ClientEvent, source: JausID) -> None:
        """End the event; the command of a command event is carried out, but its end is not reported."""
        self._current = self._find(msg, source)
        if self._current is not None:
            self._end(self._current)

    def client_lost(self, client: JausID) -> None:
        """End the events of the client."""
        for entry in self.subscriptions.of(client):
            self._end(entry)
        self.completed.forget_of(client)

    def reset_event_timer(self) -> None:
        """Restart the time-out of the event."""
        current = self._current
        if self.timeout and current is not None:
            self.host.set_timer(
                ("event timeout", current.id),
                self.host.now + self.timeout * 60.0,
                lambda: self.host.fire("Timeout", current, current.client),
            )

    def stop_event_timer(self) -> None:
        """Do nothing: `cancel_event` has cancelled the timer."""

    # --- requests

    def is_supported(self, msg: EventSetup, source: JausID) -> bool:
        """The event can be set up as requested."""
        return self._refusal(msg, source) is None

    def event_exists(self, msg: EventRequest | CreateCommandEvent | ClientEvent, source: JausID) -> bool:
        """The client has this event."""
        return self._find(msg, source) is not None

    def reject_event_request(self, msg: EventRequest | CreateCommandEvent, source: JausID) -> RejectEventRequest:
        """The request is rejected, with the reason."""
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
            is_repeated = isinstance(msg, PendingCommand) and self.completed.holds(msg)
            return msg if is_repeated or self.subscriptions.holds(msg) else None
        if msg.CODE == CreateEvent.CODE:
            return self.subscriptions.same(source, msg.event_type, encoded(msg.query_message))
        if msg.CODE == CreateCommandEvent.CODE:
            return self._find_command(msg, source)
        found = self.subscriptions.find(msg.event_id, source)
        return found if msg.CODE == CancelEvent.CODE or isinstance(found, EventSubscription) else None

    def _refusal(self, msg: EventSetup, source: JausID) -> EventRejectCode | None:
        """Reason why the event cannot be set up as requested; None when it can."""
        if (kind := self._refused_kind(msg)) is not None:
            return kind
        query = self.host.read(msg.query_message)
        if query is None or not self.host.is_query(query):
            return EventRejectCode.MESSAGE_NOT_SUPPORTED
        if msg.event_type == PERIODIC and msg.requested_periodic_rate <= 0:
            return EventRejectCode.INVALID_EVENT_SETUP
        is_new = msg.CODE == CreateEvent.CODE and self._find(msg, source) is None
        if len(encoded(msg.query_message)) > MAX_QUERY or (is_new and self._is_full_for(source)):
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
        """The query of a request that `is_supported` has accepted."""
        query = self.host.read(msg.query_message)
        assert query is not None
        return query

    # --- events that are due

    def send_event(self, msg: EventSubscription) -> None:
        """Send the present answer to the query; for events on change, only if it has changed."""
        if self._clients.is_gone(msg.client):
            self._end_unheard(msg.client)
            return
        if not self._clients.may_report(msg.client):
            return
        if msg.pending_query is msg.query:
            self.host.count("event_skipped", f"{msg.query.NAME}: the reply to the previous query is still pending")
            return
        outcome, answer = self.host.ask(msg.query, msg.client)
        if outcome is TriggerOutcome.FAILED:
            self.host.fire("EventError", msg, msg.client)
        if isinstance(answer, PendingReply):
            msg.pending_query = msg.query
            answer.add_done_callback(partial(self._on_reply, msg, msg.query))
        elif answer is not None and _is_due(msg, answer):
            self._report(msg, answer)

    def _on_reply(self, msg: EventSubscription, query: Message, answer: bytes | None) -> None:
        """Handle a deferred reply; meanwhile the event may have ended or changed its query."""
        if msg.pending_query is query:
            msg.pending_query = None
        is_wanted = msg.query is query and self.subscriptions.holds(msg) and self._clients.may_report(msg.client)
        if is_wanted and answer is not None and _is_due(msg, answer):
            self._report(msg, answer)

    def _end_unheard(self, client: JausID) -> None:
        """End the events of a client that shows no sign of life: somebody may have forged its id."""
        for entry in self.subscriptions.queries(client):
            self.host.count("events.unheard_ended", f"that of {client}, which acknowledges nothing")
            self._end(entry)

    def _report(self, msg: EventSubscription, answer: bytes) -> None:
        event = Event(event_id=msg.id, sequence_number=msg.sequence, report_message=answer)
        # Where a client does not keep up, periodic reports are dropped before replies and changes, which are sent once.
        priority = Priority.LOW if msg.kind == PERIODIC else Priority.STANDARD
        self.host.send(msg.client, event, priority=priority, on_acknowledged=self._clients.report(msg.client))
        msg.sequence = msg.sequence + 1 & 0xFF
        if msg.kind in EXTRA_KINDS:
            self._end(msg)

    def send_reject_event_request(self, msg: EventSubscription) -> None:
        """End an event whose report failed, and reject it to its client."""
        code = RejectEventRequest.ResponseCode.MESSAGE_NOT_SUPPORTED
        self.host.send(msg.client, RejectEventRequest(request_id=msg.request_id, response_code=code))
        self._end(msg)

    def _set_rate(self, subscription: EventSubscription, asked: float) -> None:
        if subscription.kind == PERIODIC:
            subscription.confirmed = self.rates.periodic(asked)
        else:
            subscription.confirmed = self.rates.on_change(asked)
        subscription.period = 1.0 / (subscription.confirmed or self.rates.change or self.rates.highest or 1.0)

    def _schedule(self, subscription: EventSubscription) -> None:
        may_wait = subscription.client != self.host.controller
        tick = partial(self._tick, subscription)
        self.host.set_timer(("event", subscription.id), subscription.due, tick, may_wait=may_wait)

    def _tick(self, subscription: EventSubscription) -> None:
        # From due time to due time, so that the rate does not drift; after a stall what was missed is left out.
        missed = max(0, int((self.host.now - subscription.due) / subscription.period))
        subscription.due += (missed + 1) * subscription.period
        self._schedule(subscription)
        self.host.fire("EventOccurred", subscription, subscription.client)

    def _end(self, entry: ClientEvent) -> None:
        self.subscriptions.remove(entry)
        if not self.subscriptions.has(entry.client):
            self._clients.remove(entry.client)
        for timer in ("event", "event timeout", "command"):
            self.host.cancel_timer((timer, entry.id))

    # --- reports

    def confirm_event_request(self, msg: EventRequest | CreateCommandEvent | ClientEvent) -> ConfirmEventRequest | None:
        """The event with the rate that is applied (Hz), 0 for a command."""
        if isinstance(self._current, PendingCommand):
            self._confirm_command(self._current, msg.request_id)
            return None
        return None if self._current is None else _confirmation(self._current, msg.request_id)

    def report_events(self, query: QueryEvents, source: JausID) -> ReportEvents:
        """The client's subscriptions: all, or by id, kind or query message."""
        chosen = [subscription for subscription in self.subscriptions.queries(source) if _matches(subscription, query)]
        return ReportEvents(
            event_list=[
                ReportEvents.ReportEventRec(
                    # The report has no numbers for the other two; one is like a change that happens once.
                    event_type=PERIODIC if subscription.kind == PERIODIC else EVERY_CHANGE,
                    event_id=subscription.id,
                    query_message=subscription.query,
                )
                for subscription in chosen[:255]
            ]
        )

    def report_event_timeout(self) -> ReportEventTimeout:
        """The time-out in minutes; 0 when events do not time out."""
        return ReportEventTimeout(timeout=self.timeout)


def _is_due(subscription: EventSubscription, report: bytes) -> bool:
    """True when this report is to be sent; remembers it for events on change."""
    if subscription.kind in (PERIODIC, ONE_TIME):
        return True
    before, subscription.last = subscription.last, report
    return report != before and not (subscription.kind == FIRST_CHANGE and before is None)


def _confirmation(entry: ClientEvent, request_id: int) -> ConfirmEventRequest:
    rate = entry.confirmed if isinstance(entry, EventSubscription) else 0.0
    return ConfirmEventRequest(request_id=request_id, event_id=entry.id, confirmed_periodic_rate=rate)


def _matches(subscription: EventSubscription, query: QueryEvents) -> bool:
    match query.query_events_var:
        case QueryEvents.EventIDRec(event_id=number):
            return subscription.id == number
        case EventTypeRec(event_type=kind):
            return subscription.kind == kind
        case QueryEvents.MessageIDRec(message_code=code):
            return code == subscription.query.CODE
        case _:
            return True


RATE_STEP: Final = 1092 / 65535
"""Step (Hz) of rates in messages: 0..1092 Hz in 16 bits."""


@dataclass(frozen=True, slots=True)
class EventRates:
    """Limits (Hz) of periodic events, and of how often every-change events check for a change; 0 refuses them."""

    lowest: float
    highest: float
    change: float

    def __post_init__(self) -> None:
        for name, value in (("min_rate", self.lowest), ("max_rate", self.highest), ("max_change_rate", self.change)):
            check_number(value, f"events: {name}")
        if not 0 < self.lowest <= 1092 or not 0 <= self.highest <= 1092 or not 0 <= self.change <= 1092:
            raise ConfigError(
                f"events: min_rate {self.lowest}, max_rate {self.highest} and max_change_rate {self.change} "
                "must be 0..1092 Hz, and min_rate more than 0"
            )

    def periodic(self, asked: float) -> float:
        """The rate (Hz) applied to a periodic event."""
        return _on_wire(max(asked, self.lowest), self.highest)

    def on_change(self, asked: float) -> float:
        """The rate (Hz) applied to an every-change event; 0, when requested, means as often as allowed."""
        return _on_wire(asked, self.change) if asked else 0.0


def _on_wire(rate: float, max_rate: float) -> float:
    """The nearest rate that a message can carry, at most the allowed one unless that is less than one step."""
    steps = min(round(rate / RATE_STEP), int(max_rate / RATE_STEP + 1e-6))
    return max(1, steps) * RATE_STEP
