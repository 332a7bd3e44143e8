"""Waiting for so long and no longer."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

from jauspy.errors import RequestError


@asynccontextmanager
async def within(seconds: float, why: Callable[[], str]) -> AsyncIterator[None]:
    """What is in the block must end in that time; else `RequestError` with what `why` says then."""
    try:
        async with asyncio.timeout(seconds) as limit:
            yield
    except TimeoutError:
        if not limit.expired():
            raise
        raise RequestError(why()) from None
