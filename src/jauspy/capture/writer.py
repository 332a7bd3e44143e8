"""Writing pcapng: UDP datagrams with synthetic IPv4 and UDP headers."""

from __future__ import annotations

import socket
import struct
from functools import lru_cache
from typing import Final

LINKTYPE_RAW: Final = 101
"""Raw IP."""
_PREAMBLE: Final = struct.pack("<IIIHHqI", 0x0A0D0D0A, 28, 0x1A2B3C4D, 1, 0, -1, 28) + struct.pack(
    "<IIHHIHHB3xHHI", 1, 32, LINKTYPE_RAW, 0, 0, 9, 1, 9, 0, 0, 32
)
"""A section header, and an interface with timestamps in nanoseconds."""
_BLOCK: Final = struct.Struct("<IIIIIII")
_IP: Final = struct.Struct(">BBHHHBBHII")
_UDP: Final = struct.Struct(">HHHH")
_STATISTICS: Final = struct.Struct("<IIIIIHHQII")
"""With one option, `isb_ifdrop`."""
_LENGTH: Final = struct.Struct("<I")
_MAX_PAYLOAD: Final = 65507

Endpoint = tuple[str, int]
"""IPv4 address and UDP port."""


def preamble() -> bytes:
    """The start of a file: section header and interface."""
    return _PREAMBLE


def packet(source: Endpoint, destination: Endpoint, payload: bytes, nanoseconds: int) -> bytes:
    """The packet block of one datagram; `nanoseconds` since 1970."""
    data = ip_packet(source, destination, payload)
    padding = -len(data) % 4
    total = 32 + len(data) + padding
    head = _BLOCK.pack(6, total, 0, nanoseconds >> 32, nanoseconds & 0xFFFFFFFF, len(data), len(data))
    return b"".join((head, data, bytes(padding), _LENGTH.pack(total)))


def ip_packet(source: Endpoint, destination: Endpoint, payload: bytes) -> bytes:
    """The IPv4 packet of one datagram."""
    payload = payload[:_MAX_PAYLOAD]
    size = 28 + len(payload)
    sender, receiver, base = _addresses(source[0], destination[0])
    checksum = base + size
    checksum = (checksum & 0xFFFF) + (checksum >> 16)
    checksum = ~((checksum & 0xFFFF) + (checksum >> 16)) & 0xFFFF
    head = _IP.pack(0x45, 0, size, 0, 0, 64, 17, checksum, sender, receiver)
    return head + _UDP.pack(source[1], destination[1], 8 + len(payload), 0) + payload


def statistics(lost: int, nanoseconds: int) -> bytes:
    """The statistics block that tells how many packets were lost so far; `nanoseconds` since 1970."""
    return _STATISTICS.pack(5, 40, 0, nanoseconds >> 32, nanoseconds & 0xFFFFFFFF, 5, 8, lost, 0, 40)


@lru_cache(maxsize=1024)
def _addresses(source: str, destination: str) -> tuple[int, int, int]:
    """Both addresses as numbers, and the sum of the IP header without its length."""
    sender, receiver = (int.from_bytes(socket.inet_aton(text), "big") for text in (source, destination))
    words = (0x4500, 64 << 8 | 17, sender >> 16, sender & 0xFFFF, receiver >> 16, receiver & 0xFFFF)
    return sender, receiver, sum(words)
