"""Events as an async iterator: a component reports at a rate, or whenever something changes."""

from __future__ import annotations

import asyncio
import math
from collections import deque
from collections.abc import AsyncIterator
from contextlib import ExitStack, suppress
from types import TracebackType
from typing import TYPE_CHECKING, Final, Generic, Self, TypeVar

from jauspy.codec.base import Message
from jauspy.errors import ConfigError, DecodeError, EventRejected, JausError, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.messages.core import ConfirmEventRequest, Event
from jauspy.ocu.event_requests import EventRequests, Request
from jauspy.ocu.link import Link
from jauspy.ocu.only_async import use
from jauspy.ocu.patience import Patience
from jauspy.ocu.sequence import Sequence

R = TypeVar("R", bound=Message)

CHECK_INTERVAL: Final = 5.0
"""Seconds between looking whether the component still has the event."""
GRACE: Final = 2.0
"""Seconds in which an event that nobody wants any more may yet be confirmed, so that it can be cancelled."""


class Subscription(Generic[R]):
    """`async for report in subscription`, or `async with subscription` and `await subscription.get()`.

    The event is created on entering, renewed in time, made anew when the component has lost it, as after a restart, and
    cancelled on exit; entering raises `EventRejected` with the reason, or `ResponseTimeout`. When reports stay out,
    `get` raises `ResponseTimeout`, and may be called again: the component may come back. At most `buffer` reports wait
    to be read; the oldest is dropped for a new one.
    """

    def __init__(self, link: Link, request: Request, kind: type[R], patience: Patience) -> None:
        self.request = request
        self.confirmed_rate = 0.0
        """Hz, as the component confirmed it; 0 when it tells of every change."""
        self.received = 0
        """Reports that arrived."""
        self.lost = 0
        """Reports that were sent and did not arrive, by their sequence numbers, which begin anew after 255."""
        self.dropped = 0
        """Reports that arrived and were not read in time."""
        self.latest: R | None = None
        """The report that arrived last, whether it was read or not."""
        self.event_id: int | None = None
        self._link = link
        self._kind = kind
        self._wire = EventRequests(link, request, patience)
        self._sequence = Sequence()
        self._buffer: deque[R] = deque(maxlen=request.buffer)
        self._told: R | None = None
        self._news = asyncio.Event()
        self._error: Exception | None = None
        self._stack = ExitStack()
        self._keeper: asyncio.Task[None] | None = None
        self._farewell: asyncio.TimerHandle | None = None

    def __repr__(self) -> str:
        state = f"{self.received} reports" if self._keeper else "not open"
        return f"<subscription to {self.request.query.NAME} at {self.request.id}: {state}>"

    async def __aenter__(self) -> Self:
        if self._keeper is not None:
            raise ConfigError("this subscription is already open; subscribe once more for a second one")
        if self._farewell is not None:
            self._leave()
        self._error, self._told, self._sequence = None, None, Sequence()
        self._buffer.clear()
        tap = self._link.replies.tapped(self.request.id, self._heard, ConfirmEventRequest, Event)
        self._stack.enter_context(tap)
        self._stack.enter_context(self._link.before_closing(self._cut_off))
        try:
            await self._wire.create()
            lifetime = await self._wire.lifetime()
        except BaseException as error:
            if self.event_id is None and not isinstance(error, EventRejected):
                self._farewell = asyncio.get_running_loop().call_later(GRACE, self._leave)
            else:
                self._leave()
            raise
        self._keeper = asyncio.create_task(self._keep(lifetime), name=f"event at {self.request.id}")
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        keeper, self._keeper = self._keeper, None
        self._leave()
        if keeper is not None:
            keeper.cancel()
            await asyncio.wait({keeper})

    async def __aiter__(self) -> AsyncIterator[R]:
        if self._keeper is not None:
            while True:
                yield await self.get()
        async with self:
            while True:
                yield await self.get()

    async def get(self) -> R:
        """The next report, oldest first; raises `ResponseTimeout` when the component has gone silent."""
        while not self._buffer:
            if self._error is not None:
                raise self._error
            if self._keeper is None:
                raise ConfigError("this subscription is not open; use `async with` or `async for` on it first")
            self._news.clear()
            try:
                async with asyncio.timeout(self.request.silence) as limit:
                    await self._news.wait()
            except TimeoutError:
                if not limit.expired():
                    raise
                raise ResponseTimeout(self._silence()) from None
        return self._buffer.popleft()

    if not TYPE_CHECKING:
        __enter__ = __exit__ = use("`async with`")
        __iter__ = use("`async for`")

    # --- what arrives ---------------------------------------------------------------------------------------------

    def _heard(self, message: Message, source: JausID) -> None:  # noqa: ARG002 - the tap hears one source
        if isinstance(message, ConfirmEventRequest):
            if message.request_id == self._wire.number:
                self._confirmed(message)
        elif isinstance(message, Event) and message.event_id == self.event_id:
            self._arrived(message)

    def _confirmed(self, message: ConfirmEventRequest) -> None:
        """Here and not when it was asked for: the first report may come in the same wake-up as the confirmation."""
        if message.event_id != self.event_id:
            self._link.events.leave(self.request.id, self.event_id, self)
            self.event_id, self._sequence = message.event_id, Sequence()
            self._link.events.join(self.request.id, self.event_id, self)
        self.confirmed_rate = message.confirmed_periodic_rate

    def _arrived(self, message: Event) -> None:
        try:
            report = self._read(message.report_message)
        except DecodeError as error:
            self._link.malformed(f"event {self.event_id} of {self.request.id}: {error}")
            return
        now = asyncio.get_running_loop().time()
        missing = self._sequence.missing(message.sequence_number, self.confirmed_rate, now)
        if missing is None:
            return
        self.lost += missing
        self.received += 1
        self._news.set()
        if self.request.rate is None and report == self._told:
            return  # the event was renewed, or somebody else subscribed to it: that is reported anew, and no change
        self._told = report
        self.dropped += len(self._buffer) == self._buffer.maxlen
        self._buffer.append(report)
        self.latest = report

    def _read(self, content: Message | bytes) -> R:
        if isinstance(content, self._kind):
            return content
        data = content.encode(strict=False) if isinstance(content, Message) else content
        return self._kind.decode(data)

    # --- the event's life -----------------------------------------------------------------------------------------

    async def _renew(self) -> None:
        """Give it its full time again; an event that is gone, as after a restart, is made anew."""
        assert self.event_id is not None
        try:
            await self._wire.update(self.event_id)
        except EventRejected:
            self._told, self._sequence = None, Sequence()
            await self._wire.create()

    async def _keep(self, lifetime: float) -> None:
        """Renew at a third of the lifetime; when reports stay out, or the component has no event of ours, anew."""
        clock = asyncio.get_running_loop().time
        most = self._longest_gap()
        interval = min(CHECK_INTERVAL, lifetime / 3 or CHECK_INTERVAL, most)
        renewed, seen, seen_at = clock(), self.received, clock()
        while True:
            await asyncio.sleep(interval)
            if self.received > seen:
                seen_at = clock()
            try:
                dried_up = clock() - max(seen_at, renewed) >= most
                is_due = lifetime and clock() - renewed >= lifetime / 3
                if dried_up or is_due or not await self._is_known():
                    await self._renew()
                    renewed = clock()
            except (ResponseTimeout, EventRejected, TransportError) as error:
                # Reports with a rate tell by themselves whether they come; of the others nobody would miss any.
                if isinstance(error, ResponseTimeout) and (self.request.rate is not None or self.received > seen):
                    continue
                self._error = error
                self._news.set()
                return
            finally:
                seen = self.received

    def _longest_gap(self) -> float:
        """Seconds without a report after which the event may be gone; it is asked for before `get` complains."""
        if self.request.rate is None:
            return math.inf
        period = 1.0 / (self.confirmed_rate or self.request.rate)
        return max(3.0 * period, (self.request.silence or 2.0 * CHECK_INTERVAL) / 2)

    async def _is_known(self) -> bool:
        """True while the component has our every-change event; with a rate the reports themselves say so."""
        if self.request.rate is not None or self.event_id is None:
            return True
        return await self._wire.is_known(self.event_id)

    def _leave(self) -> None:
        if self._farewell is not None:
            self._farewell.cancel()
            self._farewell = None
        self._news.set()
        self._stack.close()
        event, self.event_id = self.event_id, None
        if event is not None and self._link.events.leave(self.request.id, event, self):
            with suppress(JausError):  # not open, or too much under way: it ends by its timeout
                self._wire.cancel(event)

    def _cut_off(self) -> None:
        """The OCU is being closed."""
        if self._keeper is not None:
            self._keeper.cancel()
        self._leave()
        self._error = TransportError(f"the OCU was closed, and with it the event on {self.request.query.NAME}")

    def _silence(self) -> str:
        return (
            f"no event with a report on {self.request.query.NAME} came from {self.request.id} for "
            f"{self.request.silence:g} s; check that it still runs, or subscribe with a longer `silence`"
        )
