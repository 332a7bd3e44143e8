"""Receives one RTP stream over UDP."""

from __future__ import annotations

import math
import secrets
import socket
import time
from collections import Counter, OrderedDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import TracebackType
from typing import Any, Final, Self

from jauspy.errors import ProtocolError, TransportError
from jauspy.printable import printable
from jauspy.video.h264_payload import PPS, SPS, Depacketiser, Picture, nal_type
from jauspy.video.rtp import CLOCK_RATE, RtpPacket, SenderClock, noted, picture_loss_indication, sender_clock

MAX_DATAGRAMS: Final = 256
"""Datagrams that are read in one call."""

RECEIVE_BUFFER: Final = 1 << 20
"""Bytes of the socket's receive buffer, enough for a large picture."""


MAX_CANDIDATES: Final = 8
"""Sources that are followed until one is chosen; one more replaces the one that was silent for longest."""
MAX_HELD: Final = 1 << 20
"""Bytes of pictures that are kept of such a source."""

CONFIRMED: Final = 8
"""Pictures of a source after which its choice is final."""
UNCONFIRMED_TIMEOUT: Final = 0.2
"""Seconds without a packet after which a source that is not final may be replaced by one that has sent more."""
SOURCE_TIMEOUT: Final = 2.0
"""Seconds without a packet of the source after which another one of its host may take its place."""
HOST_TIMEOUT: Final = 10.0
"""The same for a source of another host."""
NOTE_TIMEOUT: Final = 15.0
"""Seconds that a note is valid: three reports of its source."""


@dataclass(slots=True)
class _Source:
    """One sender: its address and SSRC, and what was received of it."""

    host: str
    port: int
    ssrc: int
    depacketiser: Depacketiser = field(default_factory=Depacketiser)
    parameters: set[int] = field(default_factory=set)
    pictures: int = 0
    """Since the first one with which a decoder can start: a whole IDR with parameter sets."""
    held: list[Picture] = field(default_factory=list)

    def hold(self, packet: RtpPacket) -> None:
        """Keep the pictures from that one on."""
        for picture in self.depacketiser.feed(packet):
            self.parameters.update({SPS, PPS}.intersection(map(nal_type, picture.nals)))
            starts = picture.whole and picture.is_idr and len(self.parameters) == 2
            if self.pictures or starts:
                self.held.append(picture)
                self.pictures += 1
        if sum(len(nal) for picture in self.held for nal in picture.nals) > MAX_HELD:
            self.held.clear()
            self.pictures = 0


class RtpReceiver:
    """Receives at an address from its creation until `close`; port 0 stands for any free one.

    Anybody can send there. The source is the first one (address and SSRC) that sends a whole picture with which a
    decoder can start, and continues; packets of others are dropped until it is silent for `SOURCE_TIMEOUT`. After a
    loss, a whole picture is requested at the address from which the sender's reports arrive. `clock`: seconds.
    """

    def __init__(self, host: str = "127.0.0.1", port: int = 0, *, clock: Callable[[], float] = time.monotonic) -> None:
        self._counters: Counter[str] = Counter()
        self._candidates: OrderedDict[tuple[str, int, int], _Source] = OrderedDict()
        self._source: _Source | None = None
        self._last_packet_at = 0.0
        self._now = clock
        self._ssrc = secrets.randbits(32)
        self._rtp, self._rtcp = _pair(host, port)
        self._reporter: tuple[Any, ...] | None = None
        self._clock: SenderClock | None = None
        self._note = ""
        self._noted_at = -math.inf

    @property
    def port(self) -> int:
        """The UDP port that receives RTP."""
        return int(self._rtp.getsockname()[1])

    @property
    def counters(self) -> Mapping[str, int]:
        """The counters of `Depacketiser` for the source.

        Also `not_rtp` datagrams, `foreign` ones (of other sources), and how often whole pictures were `asked` for.
        """
        return self._counters + (self._source.depacketiser.counters if self._source else Counter())

    @property
    def note(self) -> str:
        """Note of the source about its stream, as that its machine is too slow; empty without one.

        Before there is a source it is what anybody says who sends reports here: printable, and not checked.
        """
        self._learn()
        return self._note if self._now() - self._noted_at < NOTE_TIMEOUT else ""

    def fileno(self) -> int:
        """File descriptor for a selector or an event loop: readable when there is something to `take`."""
        return self._rtp.fileno()

    def take(self) -> list[Picture]:
        """The pictures that are complete with the datagrams that have arrived; never waits."""
        pictures: list[Picture] = []
        for _ in range(MAX_DATAGRAMS):
            try:
                datagram, (host, port, *_) = self._rtp.recvfrom(65536)
            except OSError:
                break
            pictures += self._feed(datagram, host, port)
        self._learn()
        if not all(picture.whole for picture in pictures):
            self.ask_for_idr()
        return pictures

    def taken(self, picture: Picture) -> float | None:
        """Time of the picture, in seconds since 1970 of the sender's clock; None before its first report."""
        if self._clock is None:
            return None
        since = (picture.timestamp - self._clock.timestamp + (1 << 31)) % (1 << 32) - (1 << 31)
        return self._clock.utc + since / CLOCK_RATE

    def close(self) -> None:
        """Close the sockets; without effect when closed."""
        self._rtp.close()
        self._rtcp.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _feed(self, datagram: bytes, host: str, port: int) -> list[Picture]:
        try:
            packet = RtpPacket.decode(datagram)
        except ProtocolError as error:
            self._counters[error.reason] += 1
            return []
        now, source = self._now(), self._source
        if source is not None and (source.host, source.port, source.ssrc) == (host, port, packet.ssrc):
            pictures = source.depacketiser.feed(packet)
            self._last_packet_at, source.pictures = now, source.pictures + len(pictures)
            return pictures
        if source is not None:
            self._counters["foreign"] += 1
            if source.pictures >= CONFIRMED and now - self._last_packet_at < self._timeout(host):
                return []
        return self._try(packet, host, port, now)

    def _timeout(self, host: str) -> float:
        """Seconds of silence after which a source of this host may replace the present one."""
        return SOURCE_TIMEOUT if self._source is not None and host == self._source.host else HOST_TIMEOUT

    def _try(self, packet: RtpPacket, host: str, port: int, now: float) -> list[Picture]:
        """Follow a source that may be chosen; returns its pictures when it is."""
        key = (host, port, packet.ssrc)
        candidate = self._candidates.pop(key, None) or _Source(*key)
        self._candidates[key] = candidate
        if len(self._candidates) > MAX_CANDIDATES:
            self._candidates.popitem(last=False)
        candidate.hold(packet)
        if not candidate.pictures or not self._is_replaceable(candidate, now - self._last_packet_at):
            return []
        if self._source is not None:
            self._counters += self._source.depacketiser.counters
        self._source, self._last_packet_at = candidate, now
        self._reporter = self._clock = None
        self._note = ""
        self._candidates.clear()
        pictures, candidate.held = candidate.held, []
        return pictures

    def _is_replaceable(self, candidate: _Source, silence: float) -> bool:
        source = self._source
        if source is None or silence >= self._timeout(candidate.host):
            return True
        is_ahead = source.pictures < CONFIRMED and candidate.pictures > source.pictures
        return is_ahead and silence >= UNCONFIRMED_TIMEOUT

    def _learn(self) -> None:
        """Read the reports of the source: its clock, where it listens, and its note."""
        for _ in range(MAX_DATAGRAMS):
            try:
                heard, reporter = self._rtcp.recvfrom(2048)
            except OSError:
                break
            clock, note, source = sender_clock(heard), noted(heard), self._source
            if note is not None and (source is None or (reporter[0], note.ssrc) == (source.host, source.ssrc)):
                self._note, self._noted_at = printable(note.text), self._now()
            if source is None and note is not None and clock is None:
                continue  # a camera that starts
            if clock is None or source is None or (reporter[0], clock.ssrc) != (source.host, source.ssrc):
                self._counters["foreign"] += 1
                continue
            self._reporter, self._clock = reporter, clock

    def ask_for_idr(self) -> None:
        """Ask the sender for a picture that can be decoded without others; without effect before its first report."""
        if self._reporter is None or self._source is None:
            return
        try:
            self._rtcp.sendto(picture_loss_indication(self._ssrc, self._source.ssrc), self._reporter)
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
