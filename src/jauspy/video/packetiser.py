"""Pictures to RTP payloads: H.264 as RFC 6184 packs it, in packetisation mode 1."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Final

MAX_PACKET: Final = 1400
"""Bytes of an RTP packet with its header: with UDP, IP and a tunnel it still fits into a frame of 1500."""

MAX_PAYLOAD: Final = MAX_PACKET - 12

STAP_A: Final = 24
FU_A: Final = 28
"""Types of payloads that are not just a NAL unit: several whole ones, and a part of one."""

FU_START: Final = 0x80
FU_END: Final = 0x40
_NRI: Final = 0x60


def packetise(nals: Sequence[bytes], limit: int = MAX_PAYLOAD) -> list[bytes]:
    """The payloads, in order, that carry the NAL units of one picture; none is longer than `limit` bytes."""
    made: list[bytes] = []
    for group in _payload_groups(nals, limit):
        if len(group) > 1:
            made.append(_aggregate(group))
        elif len(group[0]) <= limit:
            made.append(group[0])
        else:
            made.extend(_fragments(group[0], limit))
    return made


def _payload_groups(nals: Sequence[bytes], limit: int) -> Iterator[list[bytes]]:
    """Neighbours that fit into one payload."""
    group: list[bytes] = []
    size = 1
    for nal in nals:
        if group and size + 2 + len(nal) > limit:
            yield group
            group, size = [], 1
        group.append(nal)
        size += 2 + len(nal)
    if group:
        yield group


def _aggregate(nals: Sequence[bytes]) -> bytes:
    importance = max(nal[0] & _NRI for nal in nals)
    return bytes([importance | STAP_A]) + b"".join(len(nal).to_bytes(2, "big") + nal for nal in nals)


def _fragments(nal: bytes, limit: int) -> Iterator[bytes]:
    indicator, kind = nal[0] & _NRI | FU_A, nal[0] & 0x1F
    room = limit - 2
    for begin in range(1, len(nal), room):
        place = (FU_START if begin == 1 else 0) | (FU_END if begin + room >= len(nal) else 0)
        yield bytes([indicator, place | kind]) + nal[begin : begin + room]
