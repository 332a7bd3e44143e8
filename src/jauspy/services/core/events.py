"""Events: a client asks once and is told again and again, at a rate or when something changes (AS5710)."""

from __future__ import annotations

from typing import Any, Final, TypeAlias

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
from jauspy.services.core.command_events import CommandEvents, encoded
from jauspy.services.core.rates import Rates
from jauspy.services.core.subscriptions import Entry, Subscription, Subscriptions
from jauspy.services.machine import Outcome

PERIODIC: Final = 0
EVERY_CHANGE: Final = 1
FIRST_CHANGE: Final = 2
ONE_TIME: Final = 3
_KINDS: Final = frozenset({PERIODIC, EVERY_CHANGE})
_MORE_KINDS: Final = frozenset({FIRST_CHANGE, ONE_TIME})

# Response codes of RejectEventRequest (AS5710)
NO_PERIODIC: Final = 1
NO_CHANGE: Final = 2
REFUSED: Final = 3
INVALID_SETUP: Final = 4
NOT_SUPPORTED: Final = 5
UNKNOWN_EVENT: Final = 6

MAX_QUERY: Final = 4096
"""Bytes of a query that a subscription may hold."""

Request: TypeAlias = CreateEvent | UpdateEvent | CancelEvent
Setup: TypeAlias = CreateEvent | UpdateEvent


class Events(CommandEvents, urn="urn:jaus:jss:core:Events", private=True):
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
        if not 0 <= timeout <= 255:
            raise ConfigError(f"events: timeout is {timeout} minutes; it must be 0..255")
        self.rates = Rates(min_rate, max_rate, max_change_rate)
        self.timeout = timeout
        self.subscriptions = Subscriptions(limit, limit_per_client)
        self._kinds = _KINDS | _MORE_KINDS if more_kinds else _KINDS
        self._current: Entry | None = None

    def leaving(self) -> None:
        """Clients know events by the id of the component: all end, and their clients are told."""
        for each in self.subscriptions.all():
            self.host.fire("Timeout", each, each.client)

    # --- predicates

    def is_supported(self, msg: Setup, source: JausID) -> bool:
        """The event can be set up as asked for."""
        return self._refusal(msg, source) is None

    def event_exists(self, msg: Request | CreateCommandEvent | Entry, source: JausID) -> bool:
        """The client has this event."""
        return self._find(msg, source) is not None

    def _find(self, msg: Any, source: JausID) -> Entry | None:
        if isinstance(msg, Entry):
            return msg if self.subscriptions.holds(msg) else None
        if msg.CODE == CreateEvent.CODE:
            return self.subscriptions.same(source, msg.event_type, encoded(msg.query_message))
        if msg.CODE == CreateCommandEvent.CODE:
            return self._find_command(msg, source)
        found = self.subscriptions.find(msg.event_id, source)
        return found if msg.CODE == CancelEvent.CODE or isinstance(found, Subscription) else None

    def _refusal(self, msg: Setup, source: JausID) -> int | None:
        """Why the event cannot be set up as asked for: a response code, None when it can."""
        if (kind := self._refused_kind(msg)) is not None:
            return kind
        query = self.host.read(msg.query_message)
        if query is None or not self.host.is_query(query):
            return NOT_SUPPORTED
        if msg.event_type == PERIODIC and msg.requested_periodic_rate <= 0:
            return INVALID_SETUP
        is_new = msg.CODE == CreateEvent.CODE and self._find(msg, source) is None
        if len(encoded(msg.query_message)) > MAX_QUERY or (is_new and self.subscriptions.full_for(source)):
            return REFUSED
        return None

    def _refused_kind(self, msg: Setup) -> int | None:
        if msg.event_type not in self._kinds:
            return INVALID_SETUP
        if msg.event_type == PERIODIC and not self.rates.highest:
            return NO_PERIODIC
        if msg.event_type in (EVERY_CHANGE, FIRST_CHANGE) and not self.rates.change:
            return NO_CHANGE
        return None

    def _query(self, msg: Setup) -> Message:
        """The query of a request that `is_supported` has let through."""
        query = self.host.read(msg.query_message)
        assert query is not None
        return query

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

    def update_event(self, msg: Setup, source: JausID) -> None:
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

    def cancel_event(self, msg: CancelEvent | Entry, source: JausID) -> None:
        """The event ends; a command goes on, without anybody being told how it ends."""
        self._current = self._find(msg, source)
        if self._current is not None:
            self._end(self._current)

    def client_lost(self, client: JausID) -> None:
        """Nobody listens to these events any more."""
        for entry in self.subscriptions.of(client):
            self._end(entry)

    def _end(self, entry: Entry) -> None:
        self.subscriptions.remove(entry)
        for timer in ("event", "event timeout", "command"):
            self.host.cancel_timer((timer, entry.id))

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

    def send_event(self, msg: Subscription) -> None:
        """Report to the subscriber what the component would answer it now; on change, only what is new to it."""
        outcome, answer = self.host.ask(msg.query, msg.client)
        if outcome is Outcome.FAILED:
            self.host.fire("EventError", msg, msg.client)
        if answer is None or not _is_due(msg, answer.payload):
            return
        self.host.send(msg.client, Event(event_id=msg.id, sequence_number=msg.sequence, report_message=answer.payload))
        msg.sequence = msg.sequence + 1 & 0xFF
        if msg.kind in _MORE_KINDS:
            self._end(msg)

    def send_reject_event_request(self, msg: Subscription) -> None:
        """The report has a bug, so the event ends, and its client is told that."""
        self.host.send(msg.client, RejectEventRequest(request_id=msg.request_id, response_code=NOT_SUPPORTED))
        self._end(msg)

    # --- time

    def _set_rate(self, subscription: Subscription, asked: float) -> None:
        if subscription.kind == PERIODIC:
            subscription.confirmed = self.rates.periodic(asked)
        else:
            subscription.confirmed = self.rates.on_change(asked)
        subscription.period = 1.0 / (subscription.confirmed or self.rates.change or self.rates.highest or 1.0)

    def _schedule(self, subscription: Subscription) -> None:
        self.host.set_timer(("event", subscription.id), subscription.due, lambda: self._tick(subscription))

    def _tick(self, subscription: Subscription) -> None:
        # From due time to due time, so that the rate does not drift; after a stall what was missed is left out.
        missed = max(0, int((self.host.now - subscription.due) / subscription.period))
        subscription.due += (missed + 1) * subscription.period
        self._schedule(subscription)
        self.host.fire("EventOccurred", subscription, subscription.client)

    # --- reports

    def confirm_event_request(self, msg: Request | CreateCommandEvent | Entry) -> ConfirmEventRequest | None:
        """The event as it is now, with the rate that is really kept; 0 for a command, which has none."""
        current = self._current
        if current is None:
            return None
        rate = current.confirmed if isinstance(current, Subscription) else 0.0
        return ConfirmEventRequest(request_id=msg.request_id, event_id=current.id, confirmed_periodic_rate=rate)

    def reject_event_request(self, msg: Request | CreateCommandEvent, source: JausID) -> RejectEventRequest:
        """Why not."""
        return RejectEventRequest(request_id=msg.request_id, response_code=self._reason(msg, source))

    def _reason(self, msg: Any, source: JausID) -> int:
        if msg.CODE == CreateCommandEvent.CODE:
            return NOT_SUPPORTED if self._command(msg) is None else REFUSED
        if msg.CODE != CreateEvent.CODE and self._find(msg, source) is None:
            return UNKNOWN_EVENT
        return self._refusal(msg, source) or NOT_SUPPORTED

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


def _is_due(subscription: Subscription, report: bytes) -> bool:
    """True when the subscriber wants this report; remembers what it has then."""
    if subscription.kind in (PERIODIC, ONE_TIME):
        return True
    before, subscription.last = subscription.last, report
    return report != before and not (subscription.kind == FIRST_CHANGE and before is None)


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
