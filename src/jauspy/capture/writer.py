"""Writing pcapng: UDP datagrams with synthetic IP and UDP headers."""

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
_IPV6: Final = struct.Struct(">IHBB")
_UDP: Final = struct.Struct(">HHHH")
_STATISTICS: Final = struct.Struct("<IIIIIHHQII")
"""With one option, `isb_ifdrop`."""
_LENGTH: Final = struct.Struct("<I")
_MAX_PAYLOAD: Final = 65507

Endpoint = tuple[str, int]
"""IPv4 or IPv6 address, and UDP port; any other text counts as the address 0.0.0.0."""


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
    """The IP packet of one datagram."""
    payload = payload[:_MAX_PAYLOAD]
    if ":" in source[0]:
        return _ipv6_packet(source, destination, payload)
    size = 28 + len(payload)
    sender, receiver, base = _addresses(source[0], destination[0])
    checksum = base + size
    checksum = (checksum & 0xFFFF) + (checksum >> 16)
    checksum = ~((checksum & 0xFFFF) + (checksum >> 16)) & 0xFFFF
    head = _IP.pack(0x45, 0, size, 0, 0, 64, 17, checksum, sender, receiver)
    return head + _UDP.pack(source[1], destination[1], 8 + len(payload), 0) + payload


def _ipv6_packet(source: Endpoint, destination: Endpoint, payload: bytes) -> bytes:
    addresses = b"".join(socket.inet_pton(socket.AF_INET6, text) for text in (source[0], destination[0]))
    length = _UDP.size + len(payload)
    head = _UDP.pack(source[1], destination[1], length, 0)
    covered = addresses + struct.pack(">II", length, socket.IPPROTO_UDP) + head + payload
    checksum = sum(memoryview(covered + bytes(len(covered) % 2)).cast("H"))
    while checksum > 0xFFFF:
        checksum = (checksum & 0xFFFF) + (checksum >> 16)
    native = struct.pack("=H", ~checksum & 0xFFFF or 0xFFFF)
    return _IPV6.pack(0x60 << 24, length, socket.IPPROTO_UDP, 64) + addresses + head[:6] + native + payload


def statistics(lost: int, nanoseconds: int) -> bytes:
    """The statistics block that tells how many packets were lost so far; `nanoseconds` since 1970."""
    return _STATISTICS.pack(5, 40, 0, nanoseconds >> 32, nanoseconds & 0xFFFFFFFF, 5, 8, lost, 0, 40)


@lru_cache(maxsize=1024)
def _addresses(source: str, destination: str) -> tuple[int, int, int]:
    """Both addresses as numbers, and the sum of the IP header without its length."""
    sender, receiver = (int.from_bytes(_packed(text), "big") for text in (source, destination))
    words = (0x4500, 64 << 8 | 17, sender >> 16, sender & 0xFFFF, receiver >> 16, receiver & 0xFFFF)
    return sender, receiver, sum(words)


def _packed(address: str) -> bytes:
    try:
        return socket.inet_aton(address)
    except OSError:  # a JSerial line has no address
        return bytes(4)
