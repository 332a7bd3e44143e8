"""Receives the sound of one sender over UDP. Import it after `need_audio`."""

from __future__ import annotations

import ipaddress
import socket
import time
from collections import Counter, OrderedDict
from collections.abc import Callable, Mapping
from types import TracebackType
from typing import Final, NamedTuple, Self

from jauspy.audio.coding import Sound
from jauspy.audio.playout import Playout, coding_of
from jauspy.errors import ProtocolError, TransportError
from jauspy.video.rtp import RtpPacket

MAX_DATAGRAMS: Final = 256
"""Datagrams that are read in one call."""
MAX_DATAGRAM: Final = 2048
"""Bytes that are read of a datagram."""
RECEIVE_BUFFER: Final = 1 << 18
"""Bytes of the socket's buffer: some seconds of sound."""
MAX_CANDIDATES: Final = 8
"""Sources that are followed until one is chosen; one more replaces the oldest."""
SOURCE_TIMEOUT: Final = 2.0
"""Seconds without a packet of the source after which another one may take its place."""


class Source(NamedTuple):
    """A sender of RTP."""

    host: str
    port: int
    ssrc: int


class AudioReceiver:
    """Receives at an address from its creation until `close`; port 0 stands for any free one.

    The source is the first one that sends two packets of sound in a row (RFC 3550, A.1); packets of others are dropped
    until it is silent for `SOURCE_TIMEOUT`. With `only`, those of other addresses are dropped in any case. `clock`:
    seconds.
    """

    def __init__(
        self,
        host: str = "127.0.0.1",
        port: int = 0,
        *,
        only: Callable[[str, int], bool] = lambda _host, _port: True,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._counters: Counter[str] = Counter()
        self._candidates: OrderedDict[Source, RtpPacket] = OrderedDict()
        self._source: Source | None = None
        self._playout = Playout()
        self._heard_at = 0.0
        self._clock = clock
        self.only = only
        self._socket = _bound(host, port)

    @property
    def port(self) -> int:
        """UDP port that receives."""
        return int(self._socket.getsockname()[1])

    @property
    def source(self) -> Source | None:
        """The sender whose sound is taken."""
        return self._source

    @property
    def counters(self) -> Mapping[str, int]:
        """The counters of `Playout`.

        Also datagrams that are `not_rtp`, of other sources (`foreign`), and of addresses that may not send (`refused`).
        """
        return self._counters + Counter(self._playout.counters)

    def fileno(self) -> int:
        """File descriptor for a selector or an event loop: readable when there is something to `take`."""
        return self._socket.fileno()

    def take(self) -> list[Sound]:
        """The sound that is complete with the datagrams that have arrived; never waits."""
        sounds: list[Sound] = []
        for _ in range(MAX_DATAGRAMS):
            try:
                datagram, (host, port, *_) = self._socket.recvfrom(MAX_DATAGRAM)
            except OSError:
                break
            sounds += self._feed(datagram, host, port)
        return sounds

    def end(self) -> list[Sound]:
        """The rest of the sound; the next packet may be of another source."""
        rest = self._playout.end()
        self._forget()
        return rest

    def close(self) -> None:
        """Close the socket; without effect when closed."""
        self._socket.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _feed(self, datagram: bytes, host: str, port: int) -> list[Sound]:
        if not self.only(_plain(host), port):
            self._counters["refused"] += 1
            return []
        try:
            packet = RtpPacket.decode(datagram)
        except ProtocolError as error:
            self._counters[error.reason] += 1
            return []
        key, now = Source(host, port, packet.ssrc), self._clock()
        if self._source is not None and self._source != key:
            self._counters["foreign"] += 1
            if now - self._heard_at < SOURCE_TIMEOUT:
                return []
        before = None if self._source == key else self._choose(key, packet)
        if self._source != key:
            return []
        self._heard_at = now
        return [*(self._playout.feed(before) if before else ()), *self._playout.feed(packet)]

    def _choose(self, key: Source, packet: RtpPacket) -> RtpPacket | None:
        """Choose the source if this packet follows another one of it, which is returned."""
        if coding_of(packet.payload_type) is None:
            self._counters["other_coding"] += 1
            return None
        before = self._candidates.pop(key, None)
        if before is None or packet.sequence != (before.sequence + 1) & 0xFFFF:
            self._candidates[key] = packet
            if len(self._candidates) > MAX_CANDIDATES:
                self._candidates.popitem(last=False)
            return None
        self._forget()
        self._source = key
        return before

    def _forget(self) -> None:
        self._counters += Counter(self._playout.counters)
        self._playout, self._source = Playout(), None
        self._candidates.clear()


def _plain(host: str) -> str:
    """An address without its scope, that of IPv4 as such."""
    address = ipaddress.ip_address(host.partition("%")[0])
    mapped = address.ipv4_mapped if isinstance(address, ipaddress.IPv6Address) else None
    return str(mapped or address)


def _bound(host: str, port: int) -> socket.socket:
    opened = socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_DGRAM)
    try:
        opened.setblocking(False)
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER)
        opened.bind((host, port))
    except (OSError, OverflowError) as error:
        opened.close()
        raise TransportError(f"sound: cannot listen at {host} port {port}: {error}") from error
    return opened
