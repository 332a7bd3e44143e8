"""A periodic event of another component: what a service subscribes to that is itself a client (AS5710)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages.core import CancelEvent, ConfirmEventRequest, CreateEvent, Event, RejectEventRequest, UpdateEvent
from jauspy.services.service import ServiceHost

RETRY_INTERVAL: Final = 0.5
"""Seconds between two requests, while none is confirmed."""
RENEWAL_INTERVAL: Final = 10.0
"""Seconds between two renewals: a component ends events a minute after their last request, or later."""
SILENCE: Final = 2.0
"""Seconds without a report after which the event is requested anew, as from a component that has started again."""
LATE: Final = 0x80
"""Sequence numbers, of 256, that are further ahead than this belong to reports that were overtaken, or are repeated."""


class RemoteEvent:
    """Requests an event until it is confirmed, renews it, and requests it again when the component is silent.

    Taken are only reports of that component with the number of the event that it confirmed; others are counted.
    """

    def __init__(self, host: ServiceHost, query: Message, rate: float, take: Callable[[Message | bytes], None]) -> None:
        """`rate` is in Hz; `take` is called with each report."""
        self._host, self._query, self._rate, self._take = host, query, rate, take
        self._source: JausID | None = None
        self._event: int | None = None
        self._request = 0
        self._sequence: int | None = None
        self._heard = self._renewed = 0.0
        host.expect(Event, self._on_report)
        host.expect(ConfirmEventRequest, self._on_confirmation)
        host.expect(RejectEventRequest, self._on_rejection)

    @property
    def source(self) -> JausID | None:
        """The component whose event this is; None without one."""
        return self._source

    def begin(self, source: JausID) -> None:
        """Subscribe to the event of that component; a previous one is cancelled."""
        self.end()
        self._source = source
        self._heard = self._host.now
        self._maintain()

    def end(self) -> None:
        """Cancel the event. May be called twice."""
        self._host.cancel_timer(self._maintain)
        if self._source is not None and self._event is not None:
            self._host.send(self._source, CancelEvent(request_id=self._next_request(), event_id=self._event))
        self._source = self._event = self._sequence = None

    def _maintain(self) -> None:
        source, now = self._source, self._host.now
        if source is None:
            return
        if self._event is not None and now - self._heard > SILENCE:
            self._event = None
        kinds = CreateEvent.EventType
        if self._event is None:
            self._host.send(
                source,
                CreateEvent(
                    request_id=self._next_request(),
                    event_type=kinds.PERIODIC,
                    requested_periodic_rate=self._rate,
                    query_message=self._query,
                ),
            )
        elif now - self._renewed >= RENEWAL_INTERVAL:
            self._renewed = now
            self._host.send(
                source,
                UpdateEvent(
                    request_id=self._next_request(),
                    event_type=kinds.PERIODIC,
                    requested_periodic_rate=self._rate,
                    event_id=self._event,
                    query_message=self._query,
                ),
            )
        self._host.set_timer(self._maintain, now + RETRY_INTERVAL, self._maintain)

    def _next_request(self) -> int:
        self._request = self._request + 1 & 0xFF
        return self._request

    def _is_answer(self, msg: ConfirmEventRequest | RejectEventRequest, source: JausID) -> bool:
        return source == self._source and msg.request_id == self._request

    def _on_confirmation(self, msg: ConfirmEventRequest, source: JausID) -> None:
        if self._is_answer(msg, source):
            if self._event != msg.event_id:
                self._sequence = None
            self._event, self._heard, self._renewed = msg.event_id, self._host.now, self._host.now

    def _on_rejection(self, msg: RejectEventRequest, source: JausID) -> None:
        if self._is_answer(msg, source):
            self._host.count("remote_event_rejected", f"{source}: {msg}")
            self._event = None

    def _on_report(self, msg: Event, source: JausID) -> None:
        if self._source is None or source != self._source or msg.event_id != self._event:
            self._host.count("unrequested_event", f"event {msg.event_id} of {source}")
            return
        if self._sequence is not None and (msg.sequence_number - self._sequence - 1) & 0xFF >= LATE:
            self._host.count("late_event", f"event {msg.event_id} of {source}, number {msg.sequence_number}")
            return
        self._sequence, self._heard = msg.sequence_number, self._host.now
        self._take(msg.report_message)
