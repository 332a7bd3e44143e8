"""Receives one RTP stream over UDP."""

from __future__ import annotations

import secrets
import socket
from collections import Counter
from collections.abc import Mapping
from types import TracebackType
from typing import Final, Self

from jauspy.errors import ProtocolError, TransportError
from jauspy.video.h264_payload import Depacketiser, Picture
from jauspy.video.rtp import CLOCK_RATE, RtpPacket, picture_loss_indication, sender_clock

MAX_DATAGRAMS: Final = 256
"""Datagrams that are read at once."""

RECEIVE_BUFFER: Final = 1 << 20
"""Bytes of the socket's receive buffer, enough for a large picture."""


class RtpReceiver:
    """Receives at an address from its creation until `close`; port 0 stands for any free one.

    After a loss, a whole picture is requested at the address from which the sender's reports arrive.
    """

    def __init__(self, host: str = "127.0.0.1", port: int = 0) -> None:
        self._counters: Counter[str] = Counter()
        self._depacketiser = Depacketiser()
        self._ssrc = secrets.randbits(32)
        self._rtp, self._rtcp = _pair(host, port)
        self._reporter: tuple[object, ...] | None = None
        self._source = 0
        self._clock: tuple[float, int] | None = None

    @property
    def port(self) -> int:
        """Where RTP is to be sent."""
        return int(self._rtp.getsockname()[1])

    @property
    def counters(self) -> Mapping[str, int]:
        """Those of `Depacketiser`, with `not_rtp` datagrams and how often whole pictures were `asked` for."""
        return self._depacketiser.counters + self._counters

    def fileno(self) -> int:
        """For a selector or an event loop: readable when there is something to `take`."""
        return self._rtp.fileno()

    def take(self) -> list[Picture]:
        """The pictures that what has arrived completes; never waits."""
        pictures: list[Picture] = []
        self._learn()
        for _ in range(MAX_DATAGRAMS):
            try:
                datagram = self._rtp.recv(65536)
            except OSError:
                break
            pictures += self._feed(datagram)
        if not all(picture.whole for picture in pictures):
            self._ask()
        return pictures

    def taken(self, picture: Picture) -> float | None:
        """When the picture was taken, in seconds since 1970 of the sender's clock; None before its first report."""
        if self._clock is None:
            return None
        utc, timestamp = self._clock
        since = (picture.timestamp - timestamp + (1 << 31)) % (1 << 32) - (1 << 31)
        return utc + since / CLOCK_RATE

    def close(self) -> None:
        """Give the ports back; twice is fine."""
        self._rtp.close()
        self._rtcp.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _feed(self, datagram: bytes) -> list[Picture]:
        try:
            packet = RtpPacket.decode(datagram)
        except ProtocolError as error:
            self._counters[error.reason] += 1
            return []
        self._source = packet.ssrc
        return self._depacketiser.feed(packet)

    def _learn(self) -> None:
        for _ in range(MAX_DATAGRAMS):
            try:
                heard, self._reporter = self._rtcp.recvfrom(2048)
            except OSError:
                break
            self._clock = sender_clock(heard) or self._clock

    def _ask(self) -> None:
        if self._reporter is None:
            return
        try:
            self._rtcp.sendto(picture_loss_indication(self._ssrc, self._source), self._reporter)
        except OSError:  # the next IDR comes without it, too
            return
        self._counters["asked"] += 1


def _pair(host: str, port: int) -> tuple[socket.socket, socket.socket]:
    """Sockets for RTP, at an even port if it may choose, and RTCP at the port above."""
    for _ in range(1 if port else 32):
        rtp = _bound(host, port)
        number = int(rtp.getsockname()[1])
        try:
            if port or number % 2 == 0:
                return rtp, _bound(host, number + 1)
        except TransportError:
            if port:
                rtp.close()
                raise
        rtp.close()
    raise TransportError(f"video: found no pair of free ports at {host}; name one")


def _bound(host: str, port: int) -> socket.socket:
    opened = socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_DGRAM)
    try:
        opened.setblocking(False)
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)
        opened.bind((host, port))
    except (OSError, OverflowError) as error:
        opened.close()
        raise TransportError(f"video: cannot listen at {host} port {port}: {error}") from error
    return opened
