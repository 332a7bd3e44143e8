"""JUDP framing (AS5669A): a version byte, then one or more packets back to back.

A received datagram may hold several packets. A sent datagram holds one, because widespread node managers read only
the first.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from jauspy.errors import ProtocolError
from jauspy.ids import message_id
from jauspy.protocol import header, junior, legacy
from jauspy.protocol.header import Ack, DataFlag, Packet, Priority, RawPacket
from jauspy.protocol.legacy import LegacyPacket, LegacyVersion

PORT: Final = 3794
"""The port that IANA registered for JAUS, UDP and TCP."""
MULTICAST_GROUP: Final = "239.255.0.1"
MULTICAST_TTL: Final = 16

_PLAIN: Final = bytes([header.VERSION, 0])
_ACK_REQUIRED: Final = Ack.REQUIRED << 4
_ACK_MASK: Final = 3 << 4
_COMPRESSION_BYTES: Final = 2
_QUERIES_AND_REPORTS: Final = range(0x2000, 0x6000)
"""Message ids of queries and reports (AS5710); commands are below, experimental messages above."""
_LEGACY_FIRST_BYTES: Final = (bytes([legacy.V1]), legacy.OPC_GREETING[:1])


def pack(packet: Packet) -> bytes:
    """The datagram of one packet."""
    return header.VERSION_BYTE + header.pack(packet)


def unpack_all(data: bytes | memoryview) -> tuple[list[Packet], list[ProtocolError]]:
    """Every packet that can be read, and the error that ended reading, if any; never raises."""
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
    """The packets of a datagram; raises `ProtocolError` when any of it is malformed."""
    packets, errors = unpack_all(data)
    if errors:
        raise errors[0]
    return packets


def check_version(data: bytes | memoryview) -> None:
    """Raise `ProtocolError` unless this is an AS5669A version 2 datagram that is not empty."""
    if data and data[0] != header.VERSION:
        raise ProtocolError("version", f"transport version {data[0]} is not {header.VERSION}")
    if len(data) < 2:
        raise ProtocolError("empty", "a datagram without a packet")


def headers(data: bytes | memoryview) -> Iterator[RawPacket]:
    """The headers of all packets of a datagram; raises `ProtocolError` at the first malformed one."""
    alone = header.parse_alone(data)
    return iter((alone,)) if alone is not None else _headers(data)


def _headers(data: bytes | memoryview) -> Iterator[RawPacket]:
    check_version(data)
    offset = 1
    while offset < len(data):
        raw = header.parse_header(data, offset)
        offset = raw.end
        yield raw


# --- datagrams of any version, for routing ---------------------------------------------------------------------------


def packets(data: bytes) -> Iterator[tuple[RawPacket, bytes, LegacyVersion | None]]:
    """Header, datagram and legacy version of each packet; raises `ProtocolError` at the first malformed one.

    Each packet becomes a datagram of its own, which can be forwarded; the header's offsets are those in it. AS5669A
    packets keep their bytes, except that a proposal of header compression, which concerns two neighbours only, is
    removed. Legacy packets without a command code become AS5669A; those with one become version 1.
    """
    alone = header.parse_alone(data)
    return iter(((alone, data, None),)) if alone is not None else _packets(data)


def _packets(data: bytes) -> Iterator[tuple[RawPacket, bytes, LegacyVersion | None]]:
    if legacy.is_legacy(data):
        yield from map(_convert, legacy.parse(data))
        return
    for raw in headers(data):
        if raw.start == 1 and raw.end == len(data) and not data[1]:
            yield raw, data, None
        else:
            single = _extract(data, raw)
            yield header.parse_header(single, 1), single, None


def _extract(data: bytes, raw: RawPacket) -> bytes:
    """The datagram of one packet, without the bytes of header compression."""
    packet = data[raw.start : raw.end]
    if packet[0]:
        size = len(packet) - _COMPRESSION_BYTES
        packet = b"\0" + size.to_bytes(2, "little") + packet[3 + _COMPRESSION_BYTES :]
    return header.VERSION_BYTE + packet


def _convert(packet: LegacyPacket) -> tuple[RawPacket, bytes, LegacyVersion | None]:
    if packet.code == 0:
        datagram = packet.as_current()
        return header.parse_header(datagram, 1), datagram, None
    datagram = packet.as_datagram(LegacyVersion.V1)
    return (
        packet.raw._replace(start=1, end=len(datagram), payload_start=legacy.V1_CODE_OFFSET),
        datagram,
        packet.version,
    )


def sequence_number(raw: RawPacket, datagram: bytes) -> int | None:
    """The source's own number of a packet that `packets` returned; None if it has none, like an ACK."""
    if raw.ack & Ack.NAK or datagram[0] != header.VERSION:
        return None
    return int.from_bytes(datagram[raw.end - 2 : raw.end], "little")


def first_header(datagram: bytes) -> RawPacket:
    """The header of a datagram that `packets` returned."""
    return next(packets(datagram))[0]


def with_ack_required(datagram: bytes) -> bytes:
    """The same packet with an ACK requested; the ACK reveals the address of its destination."""
    if legacy.is_legacy(datagram):
        return legacy.parse(datagram)[0].with_ack_required().as_datagram(LegacyVersion.V1)
    offset = header.control_offset(datagram)
    if datagram[offset] & _ACK_MASK:
        return datagram
    return datagram[:offset] + bytes([datagram[offset] | _ACK_REQUIRED]) + datagram[offset + 1 :]


def may_be_late(data: bytes, skip: int = 0) -> bool:
    """True if no packet of an unchecked datagram is a command whose sender does not learn that it was lost.

    Queries and reports do no harm when they are late. Packets that request an ACK, or are one, are repeated. Of a large
    command only the first fragment, which has its id, is late; without it the others are never put together.
    """
    datagram = data[skip:]
    if junior.parse(datagram) is not None:
        return True
    try:
        return all(_may_be_late(raw, packet) for raw, packet, _ in packets(datagram))
    except ProtocolError:
        return False


def _may_be_late(raw: RawPacket, packet: bytes) -> bool:
    if raw.ack or raw.control >> 6 in (DataFlag.MIDDLE, DataFlag.LAST):
        return True
    return message_id(packet, raw.payload_start) in _QUERIES_AND_REPORTS


def peek_priority(data: bytes, skip: int = 0) -> int:
    """The priority of an unchecked datagram whose version byte follows `skip` bytes; 0 when it is malformed.

    That of a compressed packet is in its template; it counts as STANDARD, because safety-critical packets are never
    compressed here. Connect and Cancel of the Junior protocol have the priority of what a component usually sends, so
    that they keep their order.
    """
    if len(data) > skip + header.OVERHEAD and data[skip : skip + 2] == _PLAIN:
        return data[skip + 4] & 3
    if data[skip : skip + 1] in _LEGACY_FIRST_BYTES and legacy.is_legacy(data[skip:]):
        return legacy.priority(data[skip:])
    if data[skip : skip + 1] != header.VERSION_BYTE or len(data) < skip + 2:
        return Priority.LOW
    if data[skip + 1] >= 0xC0:
        return Priority.STANDARD
    offset = skip + header.control_offset(data[skip : skip + 2])
    return data[offset] & 3 if len(data) > skip + header.OVERHEAD else Priority.LOW
