"""Events: a client asks once and is told again and again, at a rate or when something changes (AS5710)."""

from __future__ import annotations

from jauspy.arguments import check_number
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import (
    CancelEvent,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    EventTypeRec,
    QueryEvents,
    ReportEvents,
    ReportEventTimeout,
)
from jauspy.services.core.command_events import CompletedCommands
from jauspy.services.core.event_reports import EventReports
from jauspy.services.core.event_requests import EventRequest, EventRequests, EventSetup
from jauspy.services.core.subscriptions import (
    EVERY_CHANGE,
    EXTRA_KINDS,
    KINDS,
    PERIODIC,
    ClientEvent,
    EventRates,
    PendingCommand,
    Subscription,
    Subscriptions,
)


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
