"""Events: a client asks once and is told again and again, at a rate or when something changes (AS5710)."""

from __future__ import annotations

from typing import Final, TypeAlias

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
from jauspy.services.core.subscriptions import Subscription, Subscriptions
from jauspy.services.service import Service

PERIODIC: Final = CreateEvent.EventType.PERIODIC

# Response codes of RejectEventRequest (AS5710)
REFUSED: Final = 3
INVALID_SETUP: Final = 4
NOT_SUPPORTED: Final = 5
UNKNOWN_EVENT: Final = 6

MAX_QUERY: Final = 4096
"""Bytes of a query that a subscription may hold."""

Request: TypeAlias = CreateEvent | UpdateEvent | CancelEvent
Refusable: TypeAlias = Request | CreateCommandEvent


class Events(Service, urn="urn:jaus:jss:core:Events", private=True):
    """Subscriptions to any query that the component answers. Command events are refused as not supported.

    `max_rate` (Hz) bounds periodic events, `max_change_rate` how often every-change events look for a change;
    clients are told the rate they really get. Events end by themselves `timeout` minutes (1..255, 0: never) after they
    were last created or updated. `limit` bounds the events of the component, `limit_per_client` those of one client.
    """

    omits = frozenset(
        {
            "create_command_event",
            "update_command_event",
            "start_command_timer",
            "stop_command_timer",
            "send_command_event",
            "send_reject_event_request",
        }
    )

    def __init__(
        self,
        *,
        max_rate: float = 100.0,
        max_change_rate: float = 25.0,
        timeout: int = 1,
        limit: int = 128,
        limit_per_client: int = 32,
    ) -> None:
        if not 0 <= timeout <= 255:
            raise ConfigError(f"events: timeout is {timeout} minutes; it must be 0..255")
        if not (0 < max_rate <= 1092 and 0 < max_change_rate <= 1092):
            raise ConfigError(f"events: max_rate {max_rate} and max_change_rate {max_change_rate} must be 0..1092 Hz")
        self.max_rate = max_rate
        self.max_change_rate = max_change_rate
        self.timeout = timeout
        self.subscriptions = Subscriptions(limit, limit_per_client)
        self._current: Subscription | None = None

    def leaving(self) -> None:
        """Clients know events by the id of the component: all end, and their clients are told."""
        for each in self.subscriptions.all():
            self.host.fire("Timeout", each, each.client)

    # --- predicates

    def is_supported(self, msg: CreateEvent | UpdateEvent, source: JausID) -> bool:
        """The event can be set up as asked for."""
        return self._refusal(msg, source) is None

    def event_exists(self, msg: Request | Subscription, source: JausID) -> bool:
        """The client has this event."""
        return self._find(msg, source) is not None

    def is_command_supported(self) -> bool:
        """No service here tells when a command is done."""
        return False

    def _find(self, msg: object, source: JausID) -> Subscription | None:
        if isinstance(msg, Subscription):
            return msg if self.subscriptions.holds(msg) else None
        if isinstance(msg, UpdateEvent | CancelEvent):
            return self.subscriptions.find(msg.event_id, source)
        if isinstance(msg, CreateEvent):
            return self.subscriptions.same(source, msg.event_type, _bytes(msg.query_message))
        return None

    def _refusal(self, msg: CreateEvent | UpdateEvent, source: JausID) -> int | None:
        """Why the event cannot be set up as asked for: a response code, None when it can."""
        query = self.host.read(msg.query_message)
        if query is None or not self.host.is_query(query):
            return NOT_SUPPORTED
        if msg.event_type not in tuple(CreateEvent.EventType):
            return INVALID_SETUP
        if msg.event_type == PERIODIC and msg.requested_periodic_rate <= 0:
            return INVALID_SETUP
        is_new = isinstance(msg, CreateEvent) and self._find(msg, source) is None
        if len(_bytes(msg.query_message)) > MAX_QUERY or (is_new and self.subscriptions.full_for(source)):
            return REFUSED
        return None

    def _query(self, msg: CreateEvent | UpdateEvent) -> Message:
        """The query of a request that `is_supported` has let through."""
        query = self.host.read(msg.query_message)
        assert query is not None
        return query

    # --- actions

    def create_event(self, msg: CreateEvent, source: JausID) -> None:
        """A new subscription; the first report comes at once."""
        subscription = Subscription(
            self.subscriptions.free_id(), source, msg.request_id, msg.event_type, self._query(msg), due=self.host.now
        )
        self._set_rate(subscription, msg.requested_periodic_rate)
        self.subscriptions.add(subscription)
        self._current = subscription
        self._schedule(subscription)

    def update_event(self, msg: CreateEvent | UpdateEvent, source: JausID) -> None:
        """Another rate, kind or query for an event that is there; an every-change event reports anew."""
        subscription = self._find(msg, source)
        if subscription is None:
            return
        subscription.request_id, subscription.kind = msg.request_id, msg.event_type
        subscription.query, subscription.last = self._query(msg), None
        self._set_rate(subscription, msg.requested_periodic_rate)
        subscription.due = self.host.now + subscription.period
        self._current = subscription
        self._schedule(subscription)

    def cancel_event(self, msg: CancelEvent | Subscription, source: JausID) -> None:
        """The event ends."""
        self._current = self._find(msg, source)
        if self._current is not None:
            self.subscriptions.remove(self._current)
            self.host.cancel_timer(("event", self._current.id))

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
        """The event that ended does not time out any more."""
        if self._current is not None:
            self.host.cancel_timer(("event timeout", self._current.id))

    def send_event(self, msg: Subscription) -> None:
        """Report to the subscriber what the component would answer it now; on change, only what is new to it."""
        answer = self.host.ask(msg.query, msg.client)
        if answer is None or (msg.kind != PERIODIC and answer.payload == msg.last):
            return
        msg.last = answer.payload
        self.host.send(msg.client, Event(event_id=msg.id, sequence_number=msg.sequence, report_message=answer.payload))
        msg.sequence = msg.sequence + 1 & 0xFF

    # --- time

    def _set_rate(self, subscription: Subscription, asked: float) -> None:
        most = self.max_rate if subscription.kind == PERIODIC else self.max_change_rate
        # An every-change event may leave the rate open; it is then told 0, and looked at as often as allowed.
        subscription.confirmed = min(asked, most)
        subscription.period = 1.0 / (subscription.confirmed or most)

    def _schedule(self, subscription: Subscription) -> None:
        self.host.set_timer(("event", subscription.id), subscription.due, lambda: self._tick(subscription))

    def _tick(self, subscription: Subscription) -> None:
        # From due time to due time, so that the rate does not drift; after a stall what was missed is left out.
        missed = max(0, int((self.host.now - subscription.due) / subscription.period))
        subscription.due += (missed + 1) * subscription.period
        self._schedule(subscription)
        self.host.fire("EventOccurred", subscription, subscription.client)

    # --- reports

    def confirm_event_request(self, msg: Request | Subscription) -> ConfirmEventRequest | None:
        """The event as it is now, with the rate that is really kept."""
        current = self._current
        if current is None:
            return None
        return ConfirmEventRequest(
            request_id=msg.request_id, event_id=current.id, confirmed_periodic_rate=current.confirmed
        )

    def reject_event_request(self, msg: Refusable, source: JausID) -> RejectEventRequest:
        """Why not."""
        refusal = None
        if isinstance(msg, UpdateEvent | CancelEvent) and self._find(msg, source) is None:
            refusal = UNKNOWN_EVENT
        elif isinstance(msg, CreateEvent | UpdateEvent):
            refusal = self._refusal(msg, source)
        return RejectEventRequest(request_id=msg.request_id, response_code=refusal or NOT_SUPPORTED)

    def report_events(self, query: QueryEvents, source: JausID) -> ReportEvents:
        """The client's own events: all, or by id, kind or query message."""
        chosen = [each for each in self.subscriptions.of(source) if _matches(each, query)]
        return ReportEvents(
            event_list=[
                ReportEvents.ReportEventRec(event_type=each.kind, event_id=each.id, query_message=each.query)
                for each in chosen[:255]
            ]
        )

    def report_event_timeout(self) -> ReportEventTimeout:
        """Minutes, 0 when events do not time out."""
        return ReportEventTimeout(timeout=self.timeout)


def _bytes(message: Message | bytes) -> bytes:
    return message.encode() if isinstance(message, Message) else message


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
