"""Who waits for which message to be acknowledged."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final

from jauspy.errors import JausError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.protocol.endpoint import Endpoint

MAX_TOLD: Final = 64
"""Messages that services may have sent until acknowledged at once: of what may be under way, the rest is for others."""


class Deliveries:
    """Futures by ticket; an outcome that nobody waits for is only counted, by the endpoint.

    `lost` is told who did not acknowledge, unless the service that sent is told.
    """

    def __init__(self, endpoint: Endpoint, lost: Callable[[JausID], None]) -> None:
        self._endpoint = endpoint
        self._lost = lost
        self._futures: dict[int, asyncio.Future[bool]] = {}
        self._told: dict[int, Callable[[bool], None]] = {}

    @property
    def full(self) -> bool:
        """True when no further service can be told."""
        return len(self._told) >= MAX_TOLD

    def tell(self, ticket: int, told: Callable[[bool], None]) -> None:
        """Call `told` with whether the message of this ticket was acknowledged."""
        self._told[ticket] = told

    async def wait(self, ticket: int | None, problem: str) -> None:
        """Until the message of this ticket was acknowledged; raises `ResponseTimeout` when it never was."""
        assert ticket is not None
        future = self._futures[ticket] = asyncio.get_running_loop().create_future()
        try:
            if not await future:
                raise ResponseTimeout(f"{problem}; check that it runs and that the node manager is reachable")
        finally:
            self._futures.pop(ticket, None)

    def settle(self) -> None:
        """Hand the endpoint's outcomes to those who wait."""
        while (outcome := self._endpoint.next_outcome()) is not None:
            future = self._futures.get(outcome.ticket)
            if future is not None and not future.done():
                future.set_result(outcome.delivered)
            if (told := self._told.pop(outcome.ticket, None)) is not None:
                told(outcome.delivered)
            elif outcome.unresponsive is not None:
                self._lost(outcome.unresponsive)

    def fail(self, error: JausError) -> None:
        """End all waiting with this error."""
        for future in self._futures.values():
            if not future.done():
                future.set_exception(error)
