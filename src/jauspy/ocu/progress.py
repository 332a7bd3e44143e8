"""How a component gets on with its list: the active element, as it changes."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncGenerator, AsyncIterator
from contextlib import aclosing
from typing import TYPE_CHECKING, Any, Final

from jauspy.codec.base import Message
from jauspy.errors import EventRejected

if TYPE_CHECKING:
    from jauspy.ocu.service import ServiceClient

POLL: Final = 0.2
"""Seconds between two questions to a component that does not tell by itself."""


async def progress(service: ServiceClient, query: Message, rate: float | None, grace: float) -> AsyncIterator[int]:
    """The number of each element that becomes active, until none is; none at first may last `grace` seconds."""
    clock = asyncio.get_running_loop().time
    last, give_up_at = 0, clock() + grace
    async with aclosing(_reports(service, query, rate)) as reports:
        while True:
            try:
                async with asyncio.timeout_at(None if last else give_up_at):
                    uid = (await anext(reports)).element_uid
            except TimeoutError:
                return
            if not uid and (last or clock() >= give_up_at):
                return
            if uid != last:
                last = uid
                yield uid


async def _reports(service: ServiceClient, query: Message, rate: float | None) -> AsyncGenerator[Any, None]:
    subscription = service.subscribe(query, rate=rate)
    try:
        await subscription.__aenter__()
    except EventRejected:
        while True:
            yield await service.query(query)
            await asyncio.sleep(POLL)
    try:
        while True:
            yield await subscription.get()
    finally:
        await subscription.__aexit__(None, None, None)
