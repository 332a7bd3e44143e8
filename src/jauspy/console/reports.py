"""Reports of a component at a rate: as events, or by queries where it has none."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncGenerator
from contextlib import suppress

from jauspy.codec.message import Message
from jauspy.errors import EventRejected
from jauspy.ids import JausID
from jauspy.ocu import OCU


async def reports_of(
    ocu: OCU, component: JausID, query: Message, rate: float, *, events: bool
) -> AsyncGenerator[Message, None]:
    """Events of the component at `rate` Hz; queries at this rate if it has none of this report.

    Raises `JausError` when the component does not answer.
    """
    if events:
        with suppress(EventRejected):
            async with ocu.service(component, query.SERVICE).subscribe(query, rate=rate) as reports:
                async for report in reports:
                    yield report
    clock = asyncio.get_running_loop().time
    while True:
        began = clock()
        yield await ocu.query(component, query)
        await asyncio.sleep(max(0.0, began + 1.0 / rate - clock()))
