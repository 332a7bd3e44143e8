"""RTCP (RFC 3550, 6.4.1 and 6.5; RFC 4585, 6.3.1): tells receivers the time, and hears them ask for a whole picture."""

from __future__ import annotations

import struct
from typing import Final

REPORT_INTERVAL: Final = 5.0
"""Seconds between two reports to a receiver."""

_SENDER: Final = struct.Struct("!BBHIIIIII")
_NTP_EPOCH: Final = 2_208_988_800
"""Seconds from 1900, where NTP's time begins, to 1970."""

_SENDER_REPORT: Final = 200
_SOURCE_DESCRIPTION: Final = 202
_FEEDBACK: Final = 206
_PICTURE_LOSS, _FULL_INTRA = 1, 4
_CNAME: Final = 1


def sender_report(ssrc: int, name: str, *, utc: float, timestamp: int, packets: int, octets: int) -> bytes:
    """Report and name of a source: at `utc` (seconds since 1970) the stream's clock showed `timestamp`."""
    seconds, fraction = divmod(utc + _NTP_EPOCH, 1.0)
    counts = (packets & 0xFFFFFFFF, octets & 0xFFFFFFFF)
    ntp = (int(seconds) & 0xFFFFFFFF, int(fraction * 2**32))
    return _SENDER.pack(0x80, _SENDER_REPORT, 6, ssrc, *ntp, timestamp & 0xFFFFFFFF, *counts) + _source_description(
        ssrc, name
    )


def _source_description(ssrc: int, name: str) -> bytes:
    text = name.encode()[:255]
    item = bytes([_CNAME, len(text)]) + text
    chunk = ssrc.to_bytes(4, "big") + item + bytes(4 - len(item) % 4)
    return struct.pack("!BBH", 0x81, _SOURCE_DESCRIPTION, len(chunk) // 4) + chunk


def sender_clock(data: bytes) -> tuple[float, int] | None:
    """Seconds since 1970, and what the stream's clock showed then, of a sender report; None of anything else."""
    if len(data) < _SENDER.size or data[0] & 0xC0 != 0x80 or data[1] != _SENDER_REPORT:
        return None
    _, _, _, _, seconds, fraction, timestamp, _, _ = _SENDER.unpack_from(data)
    return seconds - _NTP_EPOCH + fraction / 2**32, timestamp


def picture_loss_indication(receiver: int, source: int) -> bytes:
    """A receiver asks a source for a whole picture (PLI)."""
    return struct.pack("!BBHII", 0x80 | _PICTURE_LOSS, _FEEDBACK, 2, receiver, source)


def requests_picture(data: bytes) -> bool:
    """Whether a receiver's packets ask for a whole picture (PLI or FIR); anything else does not."""
    while len(data) >= 4 and data[0] & 0xC0 == 0x80:
        length = 4 * (1 + int.from_bytes(data[2:4], "big"))
        if data[1] == _FEEDBACK and data[0] & 0x1F in {_PICTURE_LOSS, _FULL_INTRA} and length <= len(data):
            return True
        data = data[length:]
    return False
