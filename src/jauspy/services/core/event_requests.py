"""What clients may ask of Events, and why they are refused (AS5710)."""

from __future__ import annotations

from typing import Any, Final, TypeAlias

from jauspy.codec.base import Message
from jauspy.ids import JausID
from jauspy.messages.core import CancelEvent, CreateCommandEvent, CreateEvent, RejectEventRequest, UpdateEvent
from jauspy.services.core.command_events import CommandEvents, encoded
from jauspy.services.core.subscriptions import (
    EVERY_CHANGE,
    FIRST_CHANGE,
    PERIODIC,
    ClientEvent,
    EventRates,
    PendingCommand,
    Subscription,
)

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
