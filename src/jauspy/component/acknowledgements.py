"""Waits for acknowledgements: futures for programs, callbacks for services, by the tickets of an endpoint."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final

from jauspy.errors import JausError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.protocol.endpoint import Endpoint

MAX_CALLBACKS: Final = 64
"""Messages with a callback that services may have pending; the endpoint's remaining ones are for others."""


class Acknowledgements:
    """Passes on the outcomes of reliable delivery.

    `on_unreachable` is called with a destination that did not acknowledge, unless the message has a callback.
    """

    def __init__(self, endpoint: Endpoint, on_unreachable: Callable[[JausID], None]) -> None:
        self._endpoint = endpoint
        self._on_unreachable = on_unreachable
        self._futures: dict[int, asyncio.Future[bool]] = {}
        self._callbacks: dict[int, Callable[[bool], None]] = {}

    @property
    def is_full(self) -> bool:
        """True when no further callback can be added."""
        return len(self._callbacks) >= MAX_CALLBACKS

    def add_callback(self, ticket: int, callback: Callable[[bool], None]) -> None:
        """Call `callback` with True if the message of this ticket is acknowledged, with False if it is given up."""
        self._callbacks[ticket] = callback

    async def wait(self, ticket: int | None, problem: str) -> None:
        """Wait for an acknowledgement; if there is none after all resends, `ResponseTimeout` is raised."""
        assert ticket is not None
        future = self._futures[ticket] = asyncio.get_running_loop().create_future()
        try:
            if not await future:
                raise ResponseTimeout(f"{problem}; check that it runs and that the node manager is reachable")
        finally:
            self._futures.pop(ticket, None)

    def process(self) -> None:
        """Pass on the outcomes of the endpoint; others are only counted, by the endpoint."""
        while (outcome := self._endpoint.next_outcome()) is not None:
            future = self._futures.get(outcome.ticket)
            if future is not None and not future.done():
                future.set_result(outcome.delivered)
            if (callback := self._callbacks.pop(outcome.ticket, None)) is not None:
                callback(outcome.delivered)
            elif outcome.unresponsive is not None:
                self._on_unreachable(outcome.unresponsive)

    def fail(self, error: JausError) -> None:
        """End all waiting with this error."""
        for future in self._futures.values():
            if not future.done():
                future.set_exception(error)
