"""A component that reaches a node manager by JTCP."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Callable, Mapping

from jauspy.errors import ProtocolError, TransportError
from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.address_book import Address
from jauspy.protocol.counters import Counters
from jauspy.transport.base import Receiver, ignore
from jauspy.transport.stream import Dialer, StreamLink

_LOGGER = logging.getLogger(__name__)


class TcpTransport:
    """One connection to `peer`, opened again when it is lost. `open` waits at most `patience` seconds for it."""

    def __init__(self, id: JausID, peer: Address, *, patience: float | None = 5.0) -> None:
        self.id = id
        self.received: Receiver = ignore
        self._peer = peer
        self._patience = patience
        self._counters = Counters(_LOGGER)
        self._dialer: Dialer | None = None

    @property
    def connected(self) -> bool:
        """True while the connection is open."""
        return self._dialer is not None and self._dialer.link is not None

    @property
    def waiting(self) -> int:
        """Datagrams that the connection has not taken yet."""
        return 0 if self._dialer is None or self._dialer.link is None else self._dialer.link.waiting

    @property
    def counters(self) -> Mapping[str, int]:
        """What was sent, received and dropped, by reason."""
        return self._counters

    async def open(self) -> None:
        """Connect; raises `TransportError` when nobody answers. With `patience=None` it does not wait."""
        dialer = self._dialer = Dialer(self._peer, self._counters, self._take)
        if self._patience is None:
            return
        try:
            await asyncio.wait_for(dialer.connected.wait(), self._patience)
        except BaseException as error:
            await self.close()
            if not isinstance(error, TimeoutError):
                raise
            host, port = self._peer
            raise TransportError(
                f"no JTCP connection to {host}:{port}: {dialer.problem}; "
                "start a node manager there, with TCP switched on"
            ) from None

    async def close(self) -> None:
        """Close the connection."""
        dialer, self._dialer = self._dialer, None
        if dialer is not None:
            await dialer.close()

    def move(self, id: JausID, goodbye: Callable[[], None]) -> None:
        """Be another component; the way to it stays the same."""
        goodbye()
        self.id = id

    def send(self, datagram: bytes) -> None:
        """Send, or drop and count."""
        if self._dialer is None:
            self._counters.drop("closed")
            return
        try:
            for _ in judp.headers(datagram):
                pass
        except ProtocolError as error:
            self._counters.drop(f"malformed.{error.reason}", error)
            return
        if self._dialer.send(datagram):
            self._counters["sent"] += 1

    def _take(self, _link: StreamLink, datagram: bytes) -> None:
        self._counters["received"] += 1
        self.received(datagram)
