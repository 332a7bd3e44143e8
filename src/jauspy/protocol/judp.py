"""JUDP framing (AS5669A): a version byte, then one or more packets back to back.

On receive several packets in a datagram are understood. On send there is one per datagram, because widespread
node managers read only the first.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from jauspy.errors import ProtocolError
from jauspy.protocol import header
from jauspy.protocol.header import Packet, RawPacket

PORT: Final = 3794
"""IANA's port for JAUS, UDP and TCP."""
MULTICAST_GROUP: Final = "239.255.0.1"
MULTICAST_TTL: Final = 16


def pack(packet: Packet) -> bytes:
    """The datagram of one packet."""
    return header.VERSION_BYTE + header.pack(packet)


def check_version(data: bytes | memoryview) -> None:
    """Raise `ProtocolError` unless this is an AS5669A version 2 datagram with something in it."""
    if data and data[0] != header.VERSION:
        raise ProtocolError("version", f"transport version {data[0]} is not {header.VERSION}")
    if len(data) < 2:
        raise ProtocolError("empty", "a datagram without a packet")


def headers(data: bytes | memoryview) -> Iterator[RawPacket]:
    """The headers of all packets of a datagram; raises `ProtocolError` at the first that is wrong."""
    alone = header.parse_alone(data)
    return iter((alone,)) if alone is not None else _headers(data)


def _headers(data: bytes | memoryview) -> Iterator[RawPacket]:
    check_version(data)
    offset = 1
    while offset < len(data):
        raw = header.parse_header(data, offset)
        offset = raw.end
        yield raw


def unpack_all(data: bytes | memoryview) -> tuple[list[Packet], list[ProtocolError]]:
    """Every packet that can be read, and what was wrong with the rest; never raises."""
    packets: list[Packet] = []
    try:
        check_version(data)
        offset = 1
        while offset < len(data):
            packet, offset = header.parse(data, offset)
            packets.append(packet)
    except ProtocolError as error:
        return packets, [error]
    return packets, []


def unpack(data: bytes | memoryview) -> list[Packet]:
    """The packets of a datagram; raises `ProtocolError` when anything in it is wrong."""
    packets, errors = unpack_all(data)
    if errors:
        raise errors[0]
    return packets
