"""Sends sound to all receivers over UDP, encoded once for each coding. Import it after `need_audio`."""

from __future__ import annotations

import secrets
from collections import Counter
from dataclasses import dataclass, field
from types import TracebackType
from typing import Final, Self

from jauspy.audio.coding import CLOCK_RATES, FRAME_TIME, AudioEncoder, Sound
from jauspy.errors import ConfigError
from jauspy.platform.sound import Address, Coding
from jauspy.video.rtp import REPORT_INTERVAL, RtpPacket, sender_report
from jauspy.video.rtp_sockets import RtpSockets, numeric_address

MAX_RECEIVERS: Final = 8


@dataclass(slots=True)
class _Receiver:
    rtp: tuple[object, ...]
    rtcp: tuple[object, ...]
    coding: Coding
    playing: bool = True
    ssrc: int = field(default_factory=lambda: secrets.randbits(32))
    sequence: int = field(default_factory=lambda: secrets.randbits(16))
    epoch: int = field(default_factory=lambda: secrets.randbits(32))
    begins: bool = True
    packets: int = 0
    octets: int = 0
    reported: float = float("-inf")


@dataclass(slots=True)
class AudioSender:
    """Sends to receivers, which are added, paused and removed by address; `bit_rate` in kilobits per second.

    Counters: `frames`, `packets` sent, `dropped` (packets that the system refused: no buffer, no route).
    """

    name: str = "jauspy"
    bit_rate: int = 48
    counters: Counter[str] = field(default_factory=Counter)
    _receivers: dict[Address, _Receiver] = field(default_factory=dict)
    _sockets: RtpSockets = field(init=False)
    _encoders: dict[Coding, AudioEncoder] = field(default_factory=dict)
    _ticks: int = 0
    """Frames since the beginning, the sender's clock."""

    def __post_init__(self) -> None:
        self._sockets = RtpSockets("sound", self.counters)

    @property
    def playing(self) -> bool:
        """True when a receiver plays."""
        return any(receiver.playing for receiver in self._receivers.values())

    def add(self, address: Address, coding: Coding = Coding.OPUS, *, playing: bool = True) -> None:
        """Send to this address, or pause it.

        Raises `ConfigError` for an invalid address, or for one receiver too many.
        """
        known = self._receivers.get(address)
        if known is not None and known.coding is coding:
            known.begins = known.begins or not known.playing
            known.playing = playing
            return
        if known is None and len(self._receivers) >= MAX_RECEIVERS:
            raise ConfigError(f"sound: {MAX_RECEIVERS} receivers hear {self.name} already; one must leave first")
        family, rtp = numeric_address(*address, what="sound")
        self._sockets.open(family)
        self._receivers[address] = _Receiver(rtp, (rtp[0], address[1] + 1, *rtp[2:]), coding, playing)

    def remove(self, address: Address) -> None:
        """Stop sending to this address; without effect for an unknown one."""
        self._receivers.pop(address, None)

    def send(self, frame: Sound, now: float, utc: float) -> None:
        """Send a frame of 20 ms to all that play; `now` in monotonic seconds, `utc` in seconds since 1970."""
        self._ticks += 1
        self.counters["frames"] += 1
        codings = {receiver.coding for receiver in self._receivers.values() if receiver.playing}
        for coding in [coding for coding in self._encoders if coding not in codings]:
            del self._encoders[coding]
        for coding in codings:
            encoder = self._encoders.get(coding)
            if encoder is None or encoder.bit_rate != self.bit_rate:
                encoder = self._encoders[coding] = AudioEncoder(coding, self.bit_rate)
            for payload in encoder.encode(frame):
                for receiver in self._receivers.values():
                    if receiver.playing and receiver.coding is coding:
                        self._send_to(receiver, payload, now, utc)

    def local_port(self, address: Address) -> int:
        """The UDP port from which a receiver is sent to."""
        family, _ = numeric_address(*address, what="sound")
        return self._sockets.local_port(family)

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

    def _send_to(self, receiver: _Receiver, payload: bytes, now: float, utc: float) -> None:
        rate = CLOCK_RATES[receiver.coding]
        timestamp = (receiver.epoch + self._ticks * round(rate * FRAME_TIME)) & 0xFFFFFFFF
        packet = RtpPacket(receiver.sequence, timestamp, receiver.ssrc, payload, receiver.begins, receiver.coding.value)
        receiver.sequence, receiver.begins = (receiver.sequence + 1) & 0xFFFF, False
        receiver.packets, receiver.octets = receiver.packets + 1, receiver.octets + len(payload)
        self._sockets.send(packet.encode(), receiver.rtp)
        if now - receiver.reported >= REPORT_INTERVAL:
            receiver.reported = now
            report = sender_report(
                receiver.ssrc,
                self.name,
                utc=utc,
                timestamp=timestamp,
                packets=receiver.packets,
                octets=receiver.octets,
            )
            self._sockets.send(report, receiver.rtcp)
