"""NAL units, the pieces that an H.264 stream is made of (ITU-T H.264, 7.4.1 and annex B)."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Final

IDR: Final = 5
SPS: Final = 7
PPS: Final = 8
"""Types of NAL units: a slice of a picture that needs no other, and the parameter sets that decoders need first."""

START_CODE: Final = b"\x00\x00\x00\x01"

_STARTS: Final = re.compile(rb"\x00\x00\x01")


def nal_type(nal: bytes) -> int:
    """The type of a NAL unit, 0..31."""
    return nal[0] & 0x1F


def split_nals(stream: bytes) -> list[bytes]:
    """The NAL units of a byte stream (annex B), without start codes and the zeros that may follow a unit."""
    marks = [match.span() for match in _STARTS.finditer(stream)]
    ends = [start for start, _ in marks[1:]] + [len(stream)]
    units = [stream[begin:end].rstrip(b"\x00") for (_, begin), end in zip(marks, ends, strict=True)]
    return [unit for unit in units if unit]


def join_nals(nals: Iterable[bytes]) -> bytes:
    """A byte stream (annex B) of NAL units."""
    return b"".join(START_CODE + nal for nal in nals)
