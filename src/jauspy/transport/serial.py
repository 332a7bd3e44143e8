"""A component that reaches a node manager over a serial line. Needs the extra `serial`."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.counters import Counters
from jauspy.transport.base import Receiver, ignore
from jauspy.transport.serial_link import SerialLine, SerialLink

_LOGGER = logging.getLogger(__name__)


class SerialTransport:
    """Speaks JSerial on one line."""

    def __init__(self, id: JausID, line: SerialLine) -> None:
        self.id = id
        self.received: Receiver = ignore
        self._line = line
        self._counters = Counters(_LOGGER)
        self._link: SerialLink | None = None

    @property
    def connected(self) -> bool:
        """True while the device is there; a serial line tells no more."""
        return self._link is not None and self._link.connected

    @property
    def waiting(self) -> int:
        """Packets that the line has not taken yet."""
        return 0 if self._link is None else self._link.waiting

    @property
    def counters(self) -> Mapping[str, int]:
        """What was sent, received and dropped, by reason."""
        return self._counters

    async def open(self) -> None:
        """Open the device; raises `TransportError` when it cannot be used."""
        link = SerialLink(self._line, self._counters, self._take)
        link.open()
        self._link = link

    async def close(self) -> None:
        """Give the device back."""
        link, self._link = self._link, None
        if link is not None:
            link.close()

    def move(self, id: JausID, goodbye: Callable[[], None]) -> None:
        """Be another component; the way to it stays the same."""
        goodbye()
        self.id = id

    def send(self, datagram: bytes) -> None:
        """Send each packet in a frame of its own, or drop and count."""
        if self._link is None:
            self._counters.drop("closed")
            return
        try:
            packets = [datagram[:1] + datagram[raw.start : raw.end] for raw in judp.headers(datagram)]
        except ProtocolError as error:
            self._counters.drop(f"malformed.{error.reason}", error)
            return
        for packet in packets:
            self._counters["sent"] += self._link.send(packet)

    def _take(self, datagram: bytes) -> None:
        self._counters["received"] += 1
        self.received(datagram)
