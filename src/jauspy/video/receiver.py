"""Receives one RTP stream over UDP."""

from __future__ import annotations

import math
import secrets
import socket
import time
from collections import Counter, OrderedDict
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from types import TracebackType
from typing import Any, Final, Self

from jauspy.errors import ProtocolError, TransportError
from jauspy.printable import printable
from jauspy.video.h264_payload import PPS, SPS, Depacketiser, Picture, nal_type
from jauspy.video.parity import PacketRepair, ShareControl, parity_source
from jauspy.video.rtp import (
    CLOCK_RATE,
    RtpPacket,
    SenderClock,
    noted,
    parity_request,
    picture_loss_indication,
    sender_clock,
)

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
"""Seconds that a note is valid: some reports of its source may be lost."""
ASK_INTERVAL: Final = 0.8
"""Seconds after which a whole picture is asked for again: request and picture may take 0.3 s each, and be lost."""
PARITY_INTERVAL: Final = 1.0
"""Seconds after which parity is asked for again; at once when more is needed."""


@dataclass(slots=True)
class _Source:
    """One sender: its address and SSRC, and what was received of it."""

    host: str
    port: int
    ssrc: int
    depacketiser: Depacketiser = field(default_factory=Depacketiser)
    parameters: set[int] = field(default_factory=set)
    repair: PacketRepair = field(default_factory=PacketRepair)
    control: ShareControl = field(default_factory=ShareControl)
    pictures: int = 0
    """Since the first one with which a decoder can start: a whole IDR with parameter sets."""
    held: list[Picture] = field(default_factory=list)
    reporter: tuple[Any, ...] | None = None
    """The address from which its reports come."""
    clock: SenderClock | None = None
    is_broken: bool = False
    """True from a damaged picture to the next IDR."""
    asked_at: float = -math.inf
    requested: float = 0.0
    """The share of parity that was asked for last."""
    requested_at: float = -math.inf

    @property
    def counters(self) -> Counter[str]:
        """Counts of packets and pictures."""
        return self.depacketiser.counters + self.repair.counters

    def feed(self, packet: RtpPacket, now: float) -> list[Picture]:
        """The pictures that are complete with a packet of the stream, or of its parity."""
        is_parity = packet.ssrc != self.ssrc
        packets = self.repair.feed_parity(packet, now) if is_parity else self.repair.feed(packet, now)
        pictures = [picture for next_packet in packets for picture in self.depacketiser.feed(next_packet)]
        for picture in pictures:
            self.is_broken = not picture.whole or (self.is_broken and not picture.is_idr)
        return pictures

    def hold(self, packet: RtpPacket, now: float) -> None:
        """Keep the pictures from that one on."""
        for picture in self.feed(packet, now):
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
    loss, a whole picture is requested at the address from which the sender's reports arrive, until one comes, and with
    `parity` as many parity packets as the losses need; so of a source that has not sent a whole one. `clock`: seconds.
    """

    def __init__(
        self,
        host: str = "127.0.0.1",
        port: int = 0,
        *,
        parity: bool = True,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._counters: Counter[str] = Counter()
        self._candidates: OrderedDict[tuple[str, int, int], _Source] = OrderedDict()
        self._source: _Source | None = None
        self._last_packet_at = 0.0
        self._now, self._parity = clock, parity
        self._ssrc = secrets.randbits(32)
        self._rtp, self._rtcp = socket_pair(host, port)
        self._note = ""
        self._noted_at = -math.inf

    @property
    def port(self) -> int:
        """The UDP port that receives RTP."""
        return int(self._rtp.getsockname()[1])

    @property
    def counters(self) -> Mapping[str, int]:
        """The counters of `Depacketiser` and `PacketRepair` for the source.

        Also `not_rtp` datagrams, `foreign` ones (of other sources), and how often whole pictures were `asked` for.
        """
        return self._counters + (self._source.counters if self._source else Counter())

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
        now = self._now()
        for source in [self._source] if self._source is not None else self._candidates.values():
            if source.is_broken and now - source.asked_at >= ASK_INTERVAL:
                self._ask_for_idr(source, now)
            if self._parity:
                self._ask_for_parity(source, now)
        return pictures

    def taken(self, picture: Picture) -> float | None:
        """Time of the picture, in seconds since 1970 of the sender's clock; None before its first report."""
        clock = None if self._source is None else self._source.clock
        if clock is None:
            return None
        since = (picture.timestamp - clock.timestamp + (1 << 31)) % (1 << 32) - (1 << 31)
        return clock.utc + since / CLOCK_RATE

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
        if source is not None and (source.host, source.port) == (host, port) and _is_of(packet, source.ssrc):
            pictures = source.feed(packet, now)
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
        of_parity = parity_source(packet)
        is_parity = of_parity is not None and (host, port, of_parity) in self._candidates
        key = (host, port, of_parity if is_parity and of_parity is not None else packet.ssrc)
        candidate = self._candidates.pop(key, None) or _Source(*key)
        self._candidates[key] = candidate
        if len(self._candidates) > MAX_CANDIDATES:
            self._candidates.popitem(last=False)
        candidate.hold(packet, now)
        if not candidate.pictures or not self._is_replaceable(candidate, now - self._last_packet_at):
            return []
        if self._source is not None:
            self._counters += self._source.counters
        self._source, self._last_packet_at = candidate, now
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
            followed = [source] if source is not None else list(self._candidates.values())
            of = [] if clock is None else [one for one in followed if (one.host, one.ssrc) == (reporter[0], clock.ssrc)]
            if not of:
                self._counters["foreign"] += 1
            for one in of:
                one.reporter, one.clock = reporter, clock

    def ask_for_idr(self) -> None:
        """Ask the sender for a picture that can be decoded without others; without effect before its first report."""
        if self._source is not None:
            self._ask_for_idr(self._source, self._now())

    def _ask_for_idr(self, source: _Source, now: float) -> None:
        if source.reporter is None:
            return
        try:
            self._rtcp.sendto(picture_loss_indication(self._ssrc, source.ssrc), source.reporter)
        except OSError:  # the next IDR comes without it, too
            return
        source.asked_at = now
        self._counters["asked"] += 1

    def _ask_for_parity(self, source: _Source, now: float) -> None:
        """Ask for the parity that the losses need; without effect before the sender's first report."""
        if source.reporter is None:
            return
        counted, missing = source.depacketiser.counters, source.repair.counters["missing"]
        share = source.control.share(now, counted["packets"] + counted["lost"], missing, counted["lost"])
        if share <= source.requested and (now - source.requested_at < PARITY_INTERVAL or not source.requested):
            return
        source.requested, source.requested_at = share, now
        with suppress(OSError):  # asked for again soon
            self._rtcp.sendto(parity_request(self._ssrc, source.ssrc, share), source.reporter)


def _is_of(packet: RtpPacket, ssrc: int) -> bool:
    """True for a packet of that stream, and for one of its parity."""
    return packet.ssrc == ssrc or parity_source(packet) == ssrc


def socket_pair(host: str, port: int = 0) -> tuple[socket.socket, socket.socket]:
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
