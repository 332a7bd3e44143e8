"""One RTP stream to one receiver: numbers, time stamps and reports of its own."""

from __future__ import annotations

import secrets
from collections.abc import Iterator, Sequence
from typing import Final

from jauspy.video.rtp import CLOCK_RATE, REPORT_INTERVAL, RtpPacket, sender_report

_NEVER: Final = float("-inf")


class RtpStream:
    """Begins with an IDR, so what comes before one is not sent; numbers have no gaps where the sender made a pause."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._ssrc = secrets.randbits(32)
        self._sequence = secrets.randbits(16)
        self._epoch = secrets.randbits(32)
        self._packets = self._octets = 0
        self._reported = _NEVER
        self._waiting = True

    @property
    def waiting(self) -> bool:
        """It needs an IDR to begin, or to go on after a pause."""
        return self._waiting

    def pause(self) -> None:
        """What comes until the next IDR is of no use to the receiver."""
        self._waiting = True

    def packets(self, payloads: Sequence[bytes], *, idr: bool, now: float) -> Iterator[bytes]:
        """The packets of a picture taken at `now` (seconds of a monotonic clock)."""
        if self._waiting and not idr:
            return
        self._waiting = False
        timestamp = self._timestamp(now)
        for number, payload in enumerate(payloads, start=1):
            packet = RtpPacket(self._sequence, timestamp, self._ssrc, payload, marker=number == len(payloads))
            self._sequence = (self._sequence + 1) & 0xFFFF
            self._packets += 1
            self._octets += len(payload)
            yield packet.encode()

    def report(self, now: float, utc: float) -> bytes | None:
        """The sender report that is due, if one is; `utc`: seconds since 1970 at `now`."""
        if now - self._reported < REPORT_INTERVAL or not self._packets:
            return None
        self._reported = now
        return sender_report(
            self._ssrc,
            self._name,
            utc=utc,
            timestamp=self._timestamp(now),
            packets=self._packets,
            octets=self._octets,
        )

    def _timestamp(self, now: float) -> int:
        return (self._epoch + round(now * CLOCK_RATE)) & 0xFFFFFFFF
