"""Sends the pictures of one encoder to all receivers over UDP."""

from __future__ import annotations

import secrets
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from types import TracebackType
from typing import Final, Self

from jauspy.errors import ConfigError
from jauspy.video import h264_payload
from jauspy.video.camera_protocol import Address
from jauspy.video.h264_payload import packetise
from jauspy.video.parity import ParityEncoder
from jauspy.video.rtp import (
    CLOCK_RATE,
    REPORT_INTERVAL,
    RtpPacket,
    requested_parity,
    requests_picture,
    sender_report,
    source_note,
)
from jauspy.video.rtp_sockets import RtpSockets, numeric_address

_NEVER: Final = float("-inf")


class RtpStream:
    """The RTP stream of one receiver; starts with an IDR picture. Sequence numbers have no gap after a pause."""

    def __init__(self, name: str) -> None:
        self._name = name
        self.ssrc: Final = secrets.randbits(32)
        self.share = 0.0
        """Parity packets for each packet."""
        self._parity = ParityEncoder(self.ssrc ^ secrets.randbits(31) + 1, secrets.randbits(16))
        self._sequence = secrets.randbits(16)
        self._epoch = secrets.randbits(32)
        self._packets = self._octets = 0
        self._reported = _NEVER
        self._note = ""
        self._waiting = True

    @property
    def waiting(self) -> bool:
        """True when it needs an IDR picture to start, or to resume after a pause."""
        return self._waiting

    def pause(self) -> None:
        """Send nothing until the next IDR picture."""
        self._waiting = True

    def packets(self, payloads: Sequence[bytes], *, idr: bool, now: float) -> Iterator[bytes]:
        """The packets of a picture taken at `now` (seconds of a monotonic clock)."""
        if self._waiting and not idr:
            return
        self._waiting = False
        timestamp = self._timestamp(now)
        for number, payload in enumerate(payloads, start=1):
            packet = RtpPacket(self._sequence, timestamp, self.ssrc, payload, marker=number == len(payloads))
            self._sequence = (self._sequence + 1) & 0xFFFF
            self._packets += 1
            self._octets += len(payload)
            yield packet.encode()
            if self.share:
                yield from self._parity.add(packet, self.share, now)

    def report(self, now: float, utc: float, note: str) -> bytes | None:
        """The sender report, if one is due, or has another note; `utc` is `now` in seconds since 1970."""
        is_due = now - self._reported >= REPORT_INTERVAL or note != self._note
        if not is_due or not self._packets:
            return None
        self._reported, self._note = now, note
        return sender_report(
            self.ssrc,
            self._name,
            note,
            utc=utc,
            timestamp=self._timestamp(now),
            packets=self._packets,
            octets=self._octets,
        )

    def notice(self, note: str) -> bytes:
        """A note before the first picture."""
        return source_note(self.ssrc, self._name, note)

    def _timestamp(self, now: float) -> int:
        return (self._epoch + round(now * CLOCK_RATE)) & 0xFFFFFFFF


MAX_RECEIVERS: Final = 8

MIN_IDR_INTERVAL: Final = 0.5
"""Seconds between two IDR pictures that receivers request."""

SEND_BUFFER: Final = 1 << 20
"""Bytes of the socket's send buffer: a picture is sent in one burst."""

MAX_FEEDBACK_PACKETS: Final = 64
"""RTCP packets of receivers that are read after each picture."""

REQUEST_TIMEOUT: Final = 10.0
"""Seconds after which a request for parity ends, unless it is repeated."""


@dataclass(slots=True)
class _Receiver:
    rtp: tuple[object, ...]
    rtcp: tuple[object, ...]
    stream: RtpStream
    playing: bool = True
    requested_at: float = _NEVER
    """When it asked for parity."""


@dataclass(slots=True)
class RtpSender:
    """Sends to receivers, which are added, paused, resumed and removed by address.

    Counters: `pictures` and `packets` sent, `dropped` (packets that the system refused: no buffer, no route),
    `idr_asked`.
    """

    name: str = "jauspy"
    counters: Counter[str] = field(default_factory=Counter)
    note: str = ""
    """Note for the receivers about the stream, with the sender reports; empty for none."""
    _receivers: dict[Address, _Receiver] = field(default_factory=dict)
    _sockets: RtpSockets = field(init=False)
    _asked: bool = False
    _last_idr: float = float("-inf")

    def __post_init__(self) -> None:
        self._sockets = RtpSockets("video", self.counters, SEND_BUFFER)

    @property
    def receivers(self) -> list[Address]:
        """The receivers, paused ones too, in the order in which they were added."""
        return list(self._receivers)

    @property
    def playing(self) -> bool:
        """True when a receiver plays."""
        return any(receiver.playing for receiver in self._receivers.values())

    @property
    def share(self) -> float:
        """The most parity packets for each packet that a receiver gets."""
        return max((receiver.stream.share for receiver in self._receivers.values() if receiver.playing), default=0.0)

    def add(self, address: Address) -> None:
        """Send to this address from the next IDR picture on; a known receiver starts again.

        Raises `ConfigError` for an invalid address, or for one receiver too many.
        """
        if address not in self._receivers and len(self._receivers) >= MAX_RECEIVERS:
            raise ConfigError(f"video: {MAX_RECEIVERS} receivers watch {self.name} already; one must leave first")
        family, rtp = numeric_address(*address)
        self._sockets.open(family)
        rtcp = (rtp[0], address[1] + 1, *rtp[2:])
        self._receivers[address] = _Receiver(rtp, rtcp, RtpStream(self.name))

    def remove(self, address: Address) -> None:
        """Stop sending to this address; without effect for an unknown one."""
        self._receivers.pop(address, None)

    def play(self, address: Address) -> None:
        """Resume sending, from an IDR picture on."""
        if (receiver := self._receivers.get(address)) is not None:
            receiver.playing = True
            receiver.stream.pause()

    def pause(self, address: Address) -> None:
        """Pause sending; the receiver stays registered."""
        if (receiver := self._receivers.get(address)) is not None:
            receiver.playing = False

    def needs_idr(self, now: float) -> bool:
        """True when the next picture should be an IDR: a receiver starts, or has requested it."""
        self._listen(now)
        begins = any(receiver.playing and receiver.stream.waiting for receiver in self._receivers.values())
        return begins or (self._asked and now - self._last_idr >= MIN_IDR_INTERVAL)

    def send(self, nals: Sequence[bytes], now: float, utc: float) -> None:
        """Send a picture taken at `now` (monotonic seconds), `utc` (seconds since 1970), to all that play."""
        idr = any(h264_payload.nal_type(unit) == h264_payload.IDR for unit in nals)
        if idr:
            self._asked, self._last_idr = False, now
        packed = packetise(nals)
        for receiver in self._receivers.values():
            if receiver.playing:
                self._send_to(receiver, packed, idr=idr, now=now, utc=utc)
        self.counters["pictures"] += 1

    def announce(self, note: str) -> None:
        """Tell all that play why there is no picture yet."""
        for receiver in self._receivers.values():
            if receiver.playing:
                self._sockets.send(receiver.stream.notice(note), receiver.rtcp)

    def close(self) -> None:
        """Remove all receivers and close the sockets; without effect when closed."""
        self._receivers.clear()
        self._sockets.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _send_to(self, receiver: _Receiver, packed: Sequence[bytes], *, idr: bool, now: float, utc: float) -> None:
        for packet in receiver.stream.packets(packed, idr=idr, now=now):
            self._sockets.send(packet, receiver.rtp)
        if (report := receiver.stream.report(now, utc, self.note)) is not None:
            self._sockets.send(report, receiver.rtcp)

    def _listen(self, now: float) -> None:
        """Read the feedback of receivers; requests of others are ignored."""
        for receiver in self._receivers.values():
            if now - receiver.requested_at >= REQUEST_TIMEOUT:
                receiver.stream.share = 0.0
        hosts = {receiver.rtcp[0] for receiver in self._receivers.values()}
        for opened in self._sockets:
            for _ in range(MAX_FEEDBACK_PACKETS):
                try:
                    heard, source = opened.recvfrom(2048)
                except BlockingIOError:
                    break
                except OSError:  # an ICMP error for an earlier packet
                    continue
                if source[0] not in hosts:
                    continue
                if requests_picture(heard):
                    self._asked = True
                    self.counters["idr_asked"] += 1
                self._protect(heard, source[0], now)

    def _protect(self, heard: bytes, host: object, now: float) -> None:
        """Send the parity that a receiver asks for, which names its stream by a number that it alone knows."""
        if (request := requested_parity(heard)) is None:
            return
        for receiver in self._receivers.values():
            if receiver.stream.ssrc == request.source and receiver.rtcp[0] == host:
                receiver.stream.share, receiver.requested_at = request.share, now
