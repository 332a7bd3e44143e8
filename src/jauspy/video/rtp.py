"""RTP packets (RFC 3550, 5.1)."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Final

from jauspy.errors import ProtocolError

CLOCK_RATE: Final = 90_000
"""Ticks of a video time stamp in a second (RFC 6184, 8.1)."""

PAYLOAD_TYPE: Final = 96
"""The first of the dynamic numbers; the SDP says what it stands for."""

HEADER: Final = struct.Struct("!BBHII")

_VERSION: Final = 0x80
_MARKER: Final = 0x80


@dataclass(frozen=True, slots=True)
class RtpPacket:
    """One packet. `marker`: the last of its picture. `timestamp`: in ticks of `CLOCK_RATE`, modulo 2**32."""

    sequence: int
    timestamp: int
    ssrc: int
    payload: bytes
    marker: bool = False
    payload_type: int = PAYLOAD_TYPE

    def encode(self) -> bytes:
        """Its bytes."""
        second = self.payload_type | (_MARKER if self.marker else 0)
        return HEADER.pack(_VERSION, second, self.sequence, self.timestamp, self.ssrc) + self.payload

    @classmethod
    def decode(cls, data: bytes) -> RtpPacket:
        """The packet that those bytes are, without extension and padding; `ProtocolError` if they are none."""
        if len(data) < HEADER.size or data[0] & 0xC0 != _VERSION:
            raise ProtocolError("not_rtp")
        first, second, sequence, timestamp, ssrc = HEADER.unpack_from(data)
        begin, end = _payload(data, first)
        return cls(sequence, timestamp, ssrc, data[begin:end], bool(second & _MARKER), second & 0x7F)


def _payload(data: bytes, first: int) -> tuple[int, int]:
    begin = HEADER.size + 4 * (first & 0x0F)
    if first & 0x10:
        if len(data) < begin + 4:
            raise ProtocolError("not_rtp", "its extension is cut off")
        begin += 4 + 4 * int.from_bytes(data[begin + 2 : begin + 4], "big")
    end = len(data) - (data[-1] if first & 0x20 else 0)
    if end <= begin:
        raise ProtocolError("not_rtp", "it has no payload")
    return begin, end
