"""Events as an async iterator: a component reports at a rate, or whenever something changes."""

from __future__ import annotations

import asyncio
import math
from collections import deque
from collections.abc import AsyncIterator
from contextlib import ExitStack, suppress
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Generic, NoReturn, Self, TypeVar

from jauspy.codec.message import Message
from jauspy.errors import ConfigError, DecodeError, EventRejected, JausError, ResponseTimeout, TransportError
from jauspy.ids import JausID
from jauspy.messages.core import ConfirmEventRequest, Event, RejectEventRequest
from jauspy.ocu.event_requests import EventRequests, Request, reason
from jauspy.ocu.link import Link
from jauspy.ocu.only_async import use
from jauspy.ocu.patience import Patience
from jauspy.ocu.sequence import Sequence

R = TypeVar("R", bound=Message)

CHECK_INTERVAL: Final = 5.0
"""Seconds between two renewals of an every-change event: the component may have lost it, and a report gets lost."""
FIRST_CHECK: Final = 1.0
"""Seconds until that when not even the first report has come."""
GRACE: Final = 2.0
"""Seconds in which an event that nobody wants any more may yet be confirmed, so that it can be cancelled."""
EARLY: Final = 16
"""Reports that are kept until the confirmation that they have overtaken says whose they are."""


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
        self._early: deque[Event] = deque(maxlen=EARLY)
        self._asked_anew = False
        self._accepted: int | None = None
        """Which of all requests to the component was the last one that it confirmed."""
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
        self._error = self._accepted = None
        self._buffer.clear()
        tap = self._link.replies.tapped(self.request.id, self._heard, ConfirmEventRequest, RejectEventRequest, Event)
        self._stack.enter_context(tap)
        self._stack.enter_context(self._link.before_closing(self._cut_off))
        try:
            await self._create()
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
        if keeper is not None:
            keeper.cancel()
        left = asyncio.Event()
        try:
            with self._link.before_closing(left.wait):  # closing the OCU waits for this
                await self._end()
        finally:
            left.set()
            if keeper is not None:
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
                self._complain(self._error)
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
        elif isinstance(message, RejectEventRequest):
            if self._is_about_mine(message):
                self._ended(message)
        elif isinstance(message, Event):
            if message.event_id == self.event_id:
                self._arrived(message)
            elif not self._link.events.is_known(self.request.id, message.event_id):
                self._early.append(message)

    def _confirmed(self, message: ConfirmEventRequest) -> None:
        """Here and not when it was asked for: the first report may come in the same wake-up as the confirmation."""
        made = self._link.requests[self.request.id]
        self._accepted = made - (made - message.request_id & 0xFF)
        if message.event_id != self.event_id:
            self._link.events.leave(self.request.id, self.event_id, self)
            self.event_id, self._sequence = message.event_id, Sequence()
        self.confirmed_rate = message.confirmed_periodic_rate
        for other in self._link.events.join(self.request.id, message.event_id, self):
            if isinstance(other, Subscription) and not self._shares_with(other):
                # The component was started anew, and so are its numbers; the other event is not there any more.
                self._link.events.leave(self.request.id, message.event_id, other)
                other.event_id = None
        for each in self._early:
            if each.event_id == self.event_id:
                self._arrived(each)
        self._early.clear()

    def _is_about_mine(self, message: RejectEventRequest) -> bool:
        """It names a request of ours that was confirmed before; numbers come again after 256 requests."""
        made, accepted = self._link.requests[self.request.id], self._accepted
        return accepted is not None and made - accepted < 256 and accepted & 0xFF == message.request_id

    def _ended(self, message: RejectEventRequest) -> None:
        """The component had confirmed the event, and cannot go on with it: its report has a bug."""
        self._link.events.leave(self.request.id, self.event_id, self)
        self.event_id, self._accepted = None, None
        self._error = EventRejected(
            f"{self.request.id} ended the event for {self.request.query.NAME}: {reason(message)}; its log may say more"
        )
        if self._keeper is not None:
            self._keeper.cancel()
        self._news.set()

    def _shares_with(self, other: Subscription[Any]) -> bool:
        """True when a component has one event for both."""
        mine, its = self.request, other.request
        return mine.kind == its.kind and mine.query.encode() == its.query.encode()

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
        was_asked, self._asked_anew = self._asked_anew, False
        if was_asked and report == self.latest:
            return
        self.received += 1
        self.dropped += len(self._buffer) == self._buffer.maxlen
        self._buffer.append(report)
        self.latest = report
        self._news.set()

    def _read(self, content: Message | bytes) -> R:
        if isinstance(content, self._kind):
            return content
        data = content.encode(strict=False) if isinstance(content, Message) else content
        return self._kind.decode(data)

    # --- the event's life -----------------------------------------------------------------------------------------

    async def _create(self) -> None:
        self._early.clear()  # what came until now was of events that are gone
        self._sequence, self._asked_anew = Sequence(), False
        await self._wire.create()

    async def _renew(self) -> None:
        """Give it its full time again; an event that is gone, as after a restart, is made anew."""
        if self.event_id is not None:
            self._asked_anew = self.request.rate is None
            with suppress(EventRejected):
                await self._wire.update(self.event_id)
                return
        await self._create()

    async def _keep(self, lifetime: float) -> None:
        """Renew at a third of the lifetime, when reports stay out, and what reports changes always: one may be lost."""
        if self._error is not None:
            return  # the component has ended it already
        clock = asyncio.get_running_loop().time
        most, on_change = self._longest_gap(), self.request.rate is None
        interval = min(CHECK_INTERVAL, lifetime / 3 or CHECK_INTERVAL, most)
        renewed, seen, seen_at = clock(), self.received, clock()
        while True:
            await asyncio.sleep(min(interval, FIRST_CHECK) if on_change and not self.received else interval)
            if self.received > seen:
                seen_at = clock()
            try:
                dried_up = clock() - max(seen_at, renewed) >= most
                is_due = lifetime and clock() - renewed >= lifetime / 3
                if on_change or dried_up or is_due or self.event_id is None:
                    await self._renew()
                    renewed, self._error = clock(), None
            except ResponseTimeout as error:
                # Reports with a rate tell by themselves whether they come; of the others nobody would miss any.
                if on_change and self.received == seen:
                    self._error = error
                    self._news.set()
            except (EventRejected, TransportError) as error:
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

    def _complain(self, error: Exception) -> NoReturn:
        """Once of silence, since the component may come back; of what does not mend itself again and again."""
        if isinstance(error, ResponseTimeout):
            self._error = None
        raise error

    async def _end(self) -> None:
        """Nobody listens any more, and the component knows."""
        if (event := self._drop()) is not None:
            await self._wire.end(event)

    def _leave(self) -> None:
        """As when it is left; what reports to nobody may be this event, whose confirmation was lost."""
        own, unknown = self._drop(), {each.event_id for each in self._early}
        with suppress(JausError):  # not open, or too much under way: it ends by its timeout
            for event in unknown if own is None else (own,):
                if not self._link.events.is_known(self.request.id, event):
                    self._wire.cancel(event)

    def _drop(self) -> int | None:
        """Stop listening; the event when it is to be cancelled, since nobody else here listens to it."""
        if self._farewell is not None:
            self._farewell.cancel()
            self._farewell = None
        self._news.set()
        self._stack.close()
        event, self.event_id = self.event_id, None
        return event if self._link.events.leave(self.request.id, event, self) else None

    async def _cut_off(self) -> None:
        """The OCU is being closed."""
        if self._keeper is not None:
            self._keeper.cancel()
        self._error = TransportError(f"the OCU was closed, and with it the event on {self.request.query.NAME}")
        await self._end()

    def _silence(self) -> str:
        return (
            f"no event with a report on {self.request.query.NAME} came from {self.request.id} for "
            f"{self.request.silence:g} s; check that it still runs, or subscribe with a longer `silence`"
        )
