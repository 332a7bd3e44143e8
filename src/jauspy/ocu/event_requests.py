"""What a client asks of a component about one of its events, and how it is refused."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from jauspy.arguments import check_number
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, EventRejected, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import (
    CancelEvent,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    QueryEventTimeout,
    RejectEventRequest,
    ReportEventTimeout,
    UpdateEvent,
)
from jauspy.ocu.link import Link
from jauspy.ocu.patience import Patience
from jauspy.protocol.header import Ack

MAX_RATE: Final = 1092.0
"""Hz; what fits the message."""
_MEANINGS: Final[Mapping[int, str]] = {
    RejectEventRequest.ResponseCode.PERIODIC_NOT_SUPPORTED: "it has no periodic events; subscribe with rate=None",
    RejectEventRequest.ResponseCode.EVERY_CHANGE_NOT_SUPPORTED: "it has no every-change events; subscribe with a rate",
    RejectEventRequest.ResponseCode.CONNECTION_REFUSED: "it refused; it may have as many events as it can hold",
    RejectEventRequest.ResponseCode.INVALID_EVENT_SETUP: "it cannot set the event up like this; try another rate",
    RejectEventRequest.ResponseCode.MESSAGE_NOT_SUPPORTED: "it does not answer this query, or take this command",
    RejectEventRequest.ResponseCode.INVALID_EVENT_ID: "it does not know the event any more",
}


@dataclass(frozen=True, slots=True)
class Request:
    """What is subscribed to: `rate` in Hz, None for every change; `silence` in seconds, None for any time."""

    id: JausID
    query: Message
    rate: float | None
    silence: float | None
    buffer: int

    def __post_init__(self) -> None:
        if self.rate is not None and not 0 < self.rate <= MAX_RATE:
            raise ConfigError(f"rate {self.rate} is outside 0..{MAX_RATE:g} Hz; leave it out to hear of every change")
        check_number(self.silence, "silence", optional=True)
        if self.silence is not None and not self.silence > 0:
            raise ConfigError(f"silence {self.silence} s must be above 0; leave it out for any time")
        check_number(self.buffer, "buffer", whole=True)
        if self.buffer < 1:
            raise ConfigError(f"a buffer of {self.buffer} reports holds nothing; use 1 or more")

    @property
    def kind(self) -> CreateEvent.EventType:
        """The type of the event."""
        kinds = CreateEvent.EventType
        return kinds.EVERY_CHANGE if self.rate is None else kinds.PERIODIC


class EventRequests:
    """Raise `EventRejected` with the reason, or `ResponseTimeout`. `number` is that of the last one."""

    def __init__(self, link: Link, request: Request, patience: Patience) -> None:
        self.number = 0
        self._link = link
        self._request = request
        self._patience = patience

    async def create(self) -> None:
        """A new event, or the one that is there for the same query."""
        request = self._request
        await self._ask(
            CreateEvent(
                request_id=self._next(),
                event_type=request.kind,
                requested_periodic_rate=request.rate or 0.0,
                query_message=request.query,
            )
        )

    async def update(self, event: int) -> None:
        """Give it its full time again."""
        request = self._request
        await self._ask(
            UpdateEvent(
                request_id=self._next(),
                event_type=request.kind,
                requested_periodic_rate=request.rate or 0.0,
                event_id=event,
                query_message=request.query,
            )
        )

    def cancel(self, event: int) -> None:
        """End it; raises `TransportError` when the OCU is closed."""
        cancel(self._link, self._request.id, event)

    async def end(self, event: int) -> None:
        """End it, and wait until that was heard: it must not come after the creation of a new one, and end that."""
        number = self._link.next_request_id(self._request.id)
        async with self._link.ends:
            await self._link.assure(self._request.id, CancelEvent(request_id=number, event_id=event))

    async def lifetime(self) -> float:
        """Seconds after which the component forgets the event; 0 when it never does."""
        try:
            report = await self._link.query(self._request.id, QueryEventTimeout(), patience=self._patience)
        except ResponseTimeout:
            return 60.0  # the shortest that can be
        return report.timeout * 60.0 if isinstance(report, ReportEventTimeout) else 60.0

    def _next(self) -> int:
        self.number = self._link.next_request_id(self._request.id)
        return self.number

    async def _ask(self, message: CreateEvent | UpdateEvent) -> None:
        await ask(self._link, self._request.id, message, self._request.query, self._patience)


async def ask(
    link: Link, id: JausID, request: CreateEvent | UpdateEvent | CreateCommandEvent, of: Message, patience: Patience
) -> ConfirmEventRequest:
    """The confirmation of an event of this query or command."""
    answer = await link.request(
        id,
        request,
        ConfirmEventRequest,
        RejectEventRequest,
        accept=lambda each: getattr(each, "request_id", None) == request.request_id,
        patience=patience,
    )
    if isinstance(answer, RejectEventRequest):
        raise EventRejected(f"{id} rejected the event for {of.NAME}: {reason(answer)}")
    assert isinstance(answer, ConfirmEventRequest)
    return answer


def cancel(link: Link, id: JausID, event: int) -> None:
    """End an event; sent again until acknowledged, since components may have them for ever."""
    number = link.next_request_id(id)
    link.send(id, CancelEvent(request_id=number, event_id=event), ack=Ack.REQUIRED)


def reason(answer: RejectEventRequest) -> str:
    """Why a component refuses an event, or ends it."""
    code = answer.response_code
    why = _MEANINGS.get(code, f"code {code}") if code is not None else "no reason given"
    return f"{why} ({answer.error_message})" if answer.error_message else why
