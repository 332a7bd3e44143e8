"""Events as an async iterator: a component reports at a rate, or on every change (Events service, AS5710)."""

from __future__ import annotations

import asyncio
import math
from collections import deque
from collections.abc import AsyncIterator, Mapping
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from types import TracebackType
from typing import TYPE_CHECKING, Final, Generic, NoReturn, Self, TypeVar

from jauspy.arguments import async_only, check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, DecodeError, EventRejected, JausError, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.messages.core import (
    CancelEvent,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    Event,
    QueryEventTimeout,
    RejectEventRequest,
    ReportEventTimeout,
    UpdateEvent,
)
from jauspy.ocu.connection import Connection, RetryPolicy
from jauspy.protocol.header import Ack

R = TypeVar("R", bound=Message)

MAX_RATE: Final = 1092.0
"""Hz; the highest rate that fits the message."""
RENEWAL_INTERVAL: Final = 5.0
"""Seconds between two renewals of an every-change event, which the component, or the network, may have lost."""
FIRST_RENEWAL: Final = 1.0
"""Seconds before the first renewal of an every-change event when no report has arrived at all."""
LATE_CONFIRMATION_TIME: Final = 2.0
"""Seconds after a failed request in which the event may still be confirmed, so that it can be cancelled."""
MIN_EVENT_LIFETIME: Final = 60.0
"""Seconds; the shortest event timeout that a component can have."""
MAX_UNCONFIRMED_REPORTS: Final = 16
"""Reports that arrived before their confirmation and are kept until it identifies their event."""
MAX_DELAY: Final = 2.0
"""Seconds after which a report does not count as overtaken, whatever its sequence number."""

_REJECTION_REASONS: Final[Mapping[int, str]] = {
    RejectEventRequest.ResponseCode.PERIODIC_NOT_SUPPORTED: "it has no periodic events; subscribe with rate=None",
    RejectEventRequest.ResponseCode.EVERY_CHANGE_NOT_SUPPORTED: "it has no every-change events; subscribe with a rate",
    RejectEventRequest.ResponseCode.CONNECTION_REFUSED: "it refused; it may have as many events as it can hold",
    RejectEventRequest.ResponseCode.INVALID_EVENT_SETUP: "it cannot set the event up like this; try another rate",
    RejectEventRequest.ResponseCode.MESSAGE_NOT_SUPPORTED: "it does not answer this query, or take this command",
    RejectEventRequest.ResponseCode.INVALID_EVENT_ID: "it does not know the event any more",
}
_HALF_RANGE: Final = 0x80
"""Half of the sequence numbers 0..255: a number that is further ahead counts as behind."""


# --- requests ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class EventRequest:
    """Request of a subscription: `rate` in Hz, None for every change; `silence` in seconds, None for no limit."""

    id: JausID
    query: Message
    rate: float | None
    silence: float | None
    buffer: int

    def __post_init__(self) -> None:
        if self.rate is not None and not 0 < self.rate <= MAX_RATE:
            raise ConfigError(f"rate {self.rate} is outside 0..{MAX_RATE:g} Hz; omit it to subscribe to every change")
        check_number(self.silence, "silence", optional=True)
        if self.silence is not None and not self.silence > 0:
            raise ConfigError(f"silence {self.silence} s must be above 0; omit it for no limit")
        check_number(self.buffer, "buffer", whole=True)
        if self.buffer < 1:
            raise ConfigError(f"a buffer of {self.buffer} reports holds nothing; use 1 or more")

    @property
    def kind(self) -> CreateEvent.EventType:
        """The type of the event."""
        kinds = CreateEvent.EventType
        return kinds.EVERY_CHANGE if self.rate is None else kinds.PERIODIC

    def has_same_event(self, other: EventRequest) -> bool:
        """True when a component has one event for both requests."""
        return self.kind == other.kind and self.query.encode() == other.query.encode()


class EventClient:
    """Creates, updates and cancels one event; raises `EventRejected` with the reason, or `ResponseTimeout`.

    `last_request` is the id of the last request.
    """

    def __init__(self, connection: Connection, request: EventRequest, retry: RetryPolicy) -> None:
        self.last_request = 0
        self._connection = connection
        self._request = request
        self._retry = retry

    async def create(self) -> None:
        """Create the event, or join the one that exists for the same query."""
        request = self._request
        await self._send(
            CreateEvent(
                request_id=self._next(),
                event_type=request.kind,
                requested_periodic_rate=request.rate or 0.0,
                query_message=request.query,
            )
        )

    async def update(self, event: int) -> None:
        """Restart its lifetime."""
        request = self._request
        await self._send(
            UpdateEvent(
                request_id=self._next(),
                event_type=request.kind,
                requested_periodic_rate=request.rate or 0.0,
                event_id=event,
                query_message=request.query,
            )
        )

    async def cancel(self, event: int) -> None:
        """Cancel it and wait for the acknowledgement: a late CancelEvent could end an event that is created next."""
        number = self._connection.next_request_id(self._request.id)
        async with self._connection.pending_cancels:
            await self._connection.deliver(self._request.id, CancelEvent(request_id=number, event_id=event))

    async def lifetime(self) -> float:
        """Seconds after which the component removes the event unless it is updated; 0 when it never does."""
        try:
            report = await self._connection.query(self._request.id, QueryEventTimeout(), retry=self._retry)
        except ResponseTimeout:
            return MIN_EVENT_LIFETIME
        return report.timeout * 60.0 if isinstance(report, ReportEventTimeout) else MIN_EVENT_LIFETIME

    def _next(self) -> int:
        self.last_request = self._connection.next_request_id(self._request.id)
        return self.last_request

    async def _send(self, message: CreateEvent | UpdateEvent) -> None:
        await request_event(self._connection, self._request.id, message, self._request.query, self._retry)


async def request_event(
    connection: Connection,
    id: JausID,
    request: CreateEvent | UpdateEvent | CreateCommandEvent,
    of: Message,
    retry: RetryPolicy,
) -> None:
    """Send a request for an event of this query or command; raises `EventRejected` when the component rejects it."""
    answer = await connection.request(
        id,
        request,
        ConfirmEventRequest,
        RejectEventRequest,
        accept=lambda answer: getattr(answer, "request_id", None) == request.request_id,
        retry=retry,
    )
    if isinstance(answer, RejectEventRequest):
        raise EventRejected(f"{id} rejected the event for {of.NAME}: {rejection_reason(answer)}")


def cancel_event(connection: Connection, id: JausID, event: int) -> None:
    """Cancel an event; CancelEvent is resent in the background until acknowledged."""
    number = connection.next_request_id(id)
    connection.send(id, CancelEvent(request_id=number, event_id=event), ack=Ack.REQUIRED)


def rejection_reason(answer: RejectEventRequest) -> str:
    """Why a component rejects an event, or ends it."""
    code = answer.response_code
    why = _REJECTION_REASONS.get(code, f"code {code}") if code is not None else "no reason given"
    return f"{why} ({answer.error_message})" if answer.error_message else why


# --- reports ----------------------------------------------------------------------------------------------------------


class SequenceTracker:
    """Counts lost reports by their sequence numbers, which wrap after 255: gaps are known modulo 256."""

    def __init__(self) -> None:
        self._next: int | None = None
        self._at = 0.0

    def missing(self, number: int, rate: float, now: float) -> int | None:
        """How many reports are missing before this one; None for one that is late or a duplicate.

        `rate` is in Hz, 0 when it is not known. After a silence in which half of all numbers may have been sent, no
        report counts as late.
        """
        gap = 0 if self._next is None else number - self._next & 0xFF
        if gap >= _HALF_RANGE and now - self._at < (min(MAX_DELAY, _HALF_RANGE / rate) if rate else MAX_DELAY):
            return None
        self._next, self._at = number + 1 & 0xFF, now
        return gap


class Subscription(Generic[R]):
    """`async for report in subscription`, or `async with subscription` and `await subscription.get()`.

    The event is created on entering, renewed before its lifetime ends, created again when the component has lost it, as
    after a restart, and cancelled on exit. Entering raises `EventRejected` with the reason, or `ResponseTimeout`. If no
    report arrives for too long, `get` raises `ResponseTimeout`; it may be called again, since the component may come
    back. At most `buffer` reports wait to be read; a new one replaces the oldest.
    """

    def __init__(self, connection: Connection, request: EventRequest, kind: type[R], retry: RetryPolicy) -> None:
        self.request = request
        self.confirmed_rate = 0.0
        """Hz, as the component confirmed it; 0 for an every-change event."""
        self.received = 0
        """Reports that arrived."""
        self.lost = 0
        """Reports that were sent and did not arrive, by their sequence numbers, which wrap after 255."""
        self.dropped = 0
        """Reports that arrived and were not read in time."""
        self.latest: R | None = None
        """The report that arrived last, whether it was read or not."""
        self.event_id: int | None = None
        self._connection = connection
        self._kind = kind
        self._client = EventClient(connection, request, retry)
        self._sequence = SequenceTracker()
        self._buffer: deque[R] = deque(maxlen=request.buffer)
        self._unconfirmed: deque[Event] = deque(maxlen=MAX_UNCONFIRMED_REPORTS)
        self._renewal_sent = False
        """The next report may be the one that a renewal causes, which is no change."""
        self._confirmed_request: int | None = None
        """Number, without wrapping, of the last request to the component that it confirmed."""
        self._changed = asyncio.Event()
        self._error: Exception | None = None
        self._stack = ExitStack()
        self._renewal: asyncio.Task[None] | None = None
        self._late_cancel: asyncio.TimerHandle | None = None

    def __repr__(self) -> str:
        state = f"{self.received} reports" if self._renewal else "not open"
        return f"<subscription to {self.request.query.NAME} at {self.request.id}: {state}>"

    async def __aenter__(self) -> Self:
        if self._renewal is not None:
            raise ConfigError("this subscription is already open; subscribe once more for a second one")
        if self._late_cancel is not None:
            self._abandon()
        self._error = self._confirmed_request = None
        self._buffer.clear()
        kinds = (ConfirmEventRequest, RejectEventRequest, Event)
        self._stack.enter_context(self._connection.replies.listening(self.request.id, self._on_message, *kinds))
        self._stack.enter_context(self._connection.on_close(self._on_close))
        try:
            await self._create()
            lifetime = await self._client.lifetime()
        except BaseException as error:
            if self.event_id is None and not isinstance(error, EventRejected):
                loop = asyncio.get_running_loop()
                self._late_cancel = loop.call_later(LATE_CONFIRMATION_TIME, self._abandon)
            else:
                self._abandon()
            raise
        self._renewal = asyncio.create_task(self._renew_regularly(lifetime), name=f"event at {self.request.id}")
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        renewal, self._renewal = self._renewal, None
        if renewal is not None:
            renewal.cancel()
        left = asyncio.Event()
        try:
            with self._connection.on_close(left.wait):  # closing the OCU waits for this
                await self._end()
        finally:
            left.set()
            if renewal is not None:
                await asyncio.wait({renewal})

    async def __aiter__(self) -> AsyncIterator[R]:
        if self._renewal is not None:
            while True:
                yield await self.get()
        async with self:
            while True:
                yield await self.get()

    async def get(self) -> R:
        """The next report, oldest first; raises `ResponseTimeout` when no report arrives for `silence` seconds."""
        while not self._buffer:
            if self._error is not None:
                self._raise(self._error)
            if self._renewal is None:
                raise ConfigError("this subscription is not open; use `async with` or `async for` on it first")
            self._changed.clear()
            try:
                async with asyncio.timeout(self.request.silence) as limit:
                    await self._changed.wait()
            except TimeoutError:
                if not limit.expired():
                    raise
                raise ResponseTimeout(
                    f"no event with a report on {self.request.query.NAME} came from {self.request.id} for "
                    f"{self.request.silence:g} s; check that it still runs, or subscribe with a longer `silence`"
                ) from None
        return self._buffer.popleft()

    if not TYPE_CHECKING:
        __enter__ = __exit__ = async_only("`async with`")
        __iter__ = async_only("`async for`")

    # --- what arrives ---------------------------------------------------------------------------------------------

    def _on_message(self, message: Message, source: JausID) -> None:  # noqa: ARG002 - always the same source
        if isinstance(message, ConfirmEventRequest):
            if message.request_id == self._client.last_request:
                self._on_confirmed(message)
        elif isinstance(message, RejectEventRequest):
            if self._rejects_confirmed_request(message):
                self._on_ended(message)
        elif isinstance(message, Event):
            if message.event_id == self.event_id:
                self._on_event(message)
            elif not self._connection.events.is_used(self.request.id, message.event_id):
                self._unconfirmed.append(message)

    def _on_confirmed(self, message: ConfirmEventRequest) -> None:
        """Runs as soon as the confirmation arrives: the first report may follow before any task wakes up."""
        id, events = self.request.id, self._connection.events
        made = self._connection.request_counts[id]
        self._confirmed_request = made - (made - message.request_id & 0xFF)
        if message.event_id != self.event_id:
            events.remove(id, self.event_id, self)
            self.event_id, self._sequence = message.event_id, SequenceTracker()
        self.confirmed_rate = message.confirmed_periodic_rate
        for other in events.add(id, message.event_id, self):
            if isinstance(other, Subscription) and not self.request.has_same_event(other.request):
                # The component was restarted and counts events from the start; the other's event no longer exists.
                events.remove(id, message.event_id, other)
                other.event_id = None
        for subscription in self._unconfirmed:
            if subscription.event_id == self.event_id:
                self._on_event(subscription)
        self._unconfirmed.clear()

    def _rejects_confirmed_request(self, message: RejectEventRequest) -> bool:
        """True for the id of a request that was confirmed before; ids wrap after 256 requests."""
        made, confirmed = self._connection.request_counts[self.request.id], self._confirmed_request
        return confirmed is not None and made - confirmed < 256 and confirmed & 0xFF == message.request_id

    def _on_ended(self, message: RejectEventRequest) -> None:
        """The component had confirmed the event and ends it, since it cannot make the report."""
        self._connection.events.remove(self.request.id, self.event_id, self)
        self.event_id, self._confirmed_request = None, None
        if self._renewal is not None:
            self._renewal.cancel()
        why = rejection_reason(message)
        self._fail(
            EventRejected(
                f"{self.request.id} ended the event for {self.request.query.NAME}: {why}; its log may say more"
            )
        )

    def _on_event(self, message: Event) -> None:
        try:
            report = self._decoded(message.report_message)
        except DecodeError as error:
            self._connection.on_malformed(f"event {self.event_id} of {self.request.id}: {error}")
            return
        now = asyncio.get_running_loop().time()
        missing = self._sequence.missing(message.sequence_number, self.confirmed_rate, now)
        if missing is None:
            return
        self.lost += missing
        after_renewal, self._renewal_sent = self._renewal_sent, False
        if after_renewal and report == self.latest:
            return
        self.received += 1
        self.dropped += len(self._buffer) == self._buffer.maxlen
        self._buffer.append(report)
        self.latest = report
        self._changed.set()

    def _decoded(self, content: Message | bytes) -> R:
        if isinstance(content, self._kind):
            return content
        data = content.encode(strict=False) if isinstance(content, Message) else content
        return self._kind.decode(data)

    # --- the event's life -----------------------------------------------------------------------------------------

    async def _create(self) -> None:
        self._unconfirmed.clear()  # these are reports of earlier events
        self._sequence, self._renewal_sent = SequenceTracker(), False
        await self._client.create()

    async def _renew(self) -> None:
        """Update the event; create it again when the component does not know it, as after a restart."""
        if self.event_id is not None:
            self._renewal_sent = self.request.rate is None
            with suppress(EventRejected):
                await self._client.update(self.event_id)
                return
        await self._create()

    async def _renew_regularly(self, lifetime: float) -> None:
        """Renew the event at a third of its lifetime and when no reports arrive; on every change, at each interval."""
        if self._error is not None:
            return  # the component has ended it already
        clock = asyncio.get_running_loop().time
        max_gap, on_change = self._max_gap(), self.request.rate is None
        interval = min(RENEWAL_INTERVAL, lifetime / 3 or RENEWAL_INTERVAL, max_gap)
        received, received_at, renewed_at = self.received, clock(), clock()
        try:
            while True:
                await asyncio.sleep(min(interval, FIRST_RENEWAL) if on_change and not self.received else interval)
                if self.received > received:
                    received_at = clock()
                is_silent = clock() - max(received_at, renewed_at) >= max_gap
                expires = lifetime and clock() - renewed_at >= lifetime / 3
                if (on_change or is_silent or expires or self.event_id is None) and await self._try_renew(received):
                    renewed_at = clock()
                received = self.received
        except (EventRejected, TransportError) as error:
            self._fail(error)

    async def _try_renew(self, received: int) -> bool:
        """Renew the event; false without an answer, which fails an every-change event with no new report since."""
        try:
            await self._renew()
        except ResponseTimeout as error:
            # Whether periodic reports arrive is seen anyway; a missing report on change would go unnoticed.
            if self.request.rate is None and self.received == received:
                self._fail(error)
            return False
        self._error = None
        return True

    def _max_gap(self) -> float:
        """Seconds without a report after which the event is renewed; less than what `get` waits for."""
        if self.request.rate is None:
            return math.inf
        period = 1.0 / (self.confirmed_rate or self.request.rate)
        return max(3.0 * period, (self.request.silence or 2.0 * RENEWAL_INTERVAL) / 2)

    def _fail(self, error: Exception) -> None:
        """Make `get` raise this error."""
        self._error = error
        self._changed.set()

    def _raise(self, error: Exception) -> NoReturn:
        """Raise a timeout once, since the component may come back; other errors are raised by each `get`."""
        if isinstance(error, ResponseTimeout):
            self._error = None
        raise error

    async def _end(self) -> None:
        """Stop listening, and cancel the event unless other subscriptions use it."""
        if (event := self._detach()) is not None:
            await self._client.cancel(event)

    def _abandon(self) -> None:
        """End without waiting; an event of unconfirmed reports may be this one, so it is cancelled, too."""
        event_id, unconfirmed = self._detach(), {subscription.event_id for subscription in self._unconfirmed}
        with suppress(JausError):  # not open, or too many messages under way: the event ends by its timeout
            for event in unconfirmed if event_id is None else (event_id,):
                if not self._connection.events.is_used(self.request.id, event):
                    cancel_event(self._connection, self.request.id, event)

    def _detach(self) -> int | None:
        """Stop listening; returns the event when it is to be cancelled, since nobody else here uses it."""
        if self._late_cancel is not None:
            self._late_cancel.cancel()
            self._late_cancel = None
        self._changed.set()
        self._stack.close()
        event, self.event_id = self.event_id, None
        return event if self._connection.events.remove(self.request.id, event, self) else None

    async def _on_close(self) -> None:
        """The OCU is closed inside the block."""
        if self._renewal is not None:
            self._renewal.cancel()
        self._error = TransportError(f"the OCU was closed, and with it the event on {self.request.query.NAME}")
        await self._end()


def subscribe(
    connection: Connection,
    id: JausID,
    query: Message,
    kind: type[R],
    *,
    rate: float | None,
    buffer: int = 64,
    silence: float | None = None,
) -> Subscription[R]:
    """Subscribe to reports of class `kind`; without `silence`, reports may be missing for ten periods, at least 2 s."""
    check_number(rate, "rate", optional=True)
    if silence is None and rate:
        silence = max(2.0, 10.0 / rate)
    return Subscription(connection, EventRequest(id, query, rate, silence, buffer), kind, connection.retry)
