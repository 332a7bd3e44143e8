"""How a component gets on with its list: the active element, as it changes."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncGenerator, AsyncIterator
from contextlib import aclosing
from typing import TYPE_CHECKING, Any, Final

from jauspy.codec.message import Message
from jauspy.errors import EventRejected

if TYPE_CHECKING:
    from jauspy.ocu.service import ServiceClient
    from jauspy.ocu.subscription import Subscription

POLL: Final = 0.2
"""Seconds between two questions to a component that does not tell by itself."""
RECHECK: Final = 1.0
"""Seconds without an event after which one may have been lost, perhaps the last one: then it is asked."""


async def progress(service: ServiceClient, query: Message, rate: float | None, grace: float) -> AsyncIterator[int]:
    """The number of each element that becomes active, until none is; none at first may last `grace` seconds.

    Silence says nothing: while no report comes, the list may well be carried out.
    """
    clock = asyncio.get_running_loop().time
    last, give_up_at = 0, clock() + grace
    async with aclosing(_reports(service, query, rate)) as reports:
        async for report in reports:
            uid = report.element_uid
            if not uid and (last or clock() >= give_up_at):
                return
            if uid != last:
                last = uid
                yield uid


async def _reports(service: ServiceClient, query: Message, rate: float | None) -> AsyncGenerator[Any, None]:
    yield await service.query(query)  # an event takes three messages and their answers to begin
    subscription = service.subscribe(query, rate=rate)
    try:
        await subscription.__aenter__()
    except EventRejected:
        while True:
            yield await service.query(query)
            await asyncio.sleep(POLL)
    try:
        while True:
            yield await _next(service, query, subscription)
    finally:
        await subscription.__aexit__(None, None, None)


async def _next(service: ServiceClient, query: Message, subscription: Subscription[Any]) -> Any:
    try:
        async with asyncio.timeout(RECHECK) as limit:
            return await subscription.get()
    except TimeoutError:
        if not limit.expired():
            raise
        return await service.query(query)
