"""The packets in a datagram, whatever header they came with, each as a datagram of its own that can be forwarded.

AS5669A packets stay as they came, but for a proposal of header compression, which is between two neighbours and is not
passed on. Old headers without a command code become AS5669A; those with one become version 1 (see `legacy`).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from jauspy.protocol import header, judp, legacy
from jauspy.protocol.header import Ack, RawPacket
from jauspy.protocol.legacy import LegacyVersion

_PLAIN: Final = bytes([header.VERSION, 0])
_ACK_REQUIRED: Final = Ack.REQUIRED << 4
_ACK_MASK: Final = 3 << 4
_HC_BYTES: Final = 2
_OLD_BEGINNINGS: Final = (bytes([legacy.V1]), legacy.OPC_GREETING[:1])


def packets(data: bytes) -> Iterator[tuple[RawPacket, bytes, LegacyVersion | None]]:
    """Header, datagram and old dialect of each packet; raises `ProtocolError` at the first that is wrong.

    The header's offsets are those in the datagram that comes with it.
    """
    alone = header.parse_alone(data)
    return iter(((alone, data, None),)) if alone is not None else _packets(data)


def _packets(data: bytes) -> Iterator[tuple[RawPacket, bytes, LegacyVersion | None]]:
    if legacy.is_legacy(data):
        yield from map(_old, legacy.parse(data))
        return
    for raw in judp.headers(data):
        if raw.start == 1 and raw.end == len(data) and not data[1]:
            yield raw, data, None
        else:
            single = _single(data, raw)
            yield header.parse_header(single, 1), single, None


def header_of(datagram: bytes) -> RawPacket:
    """The header of a datagram that `packets` gave."""
    return next(packets(datagram))[0]


def peek_priority(data: bytes, skip: int = 0) -> int:
    """The priority of a datagram that nobody has checked yet, whose version byte comes after `skip` bytes.

    Connects and Cancels count like what a component usually sends, so that they keep their place among it.
    """
    if len(data) > skip + header.OVERHEAD and data[skip : skip + 2] == _PLAIN:
        return data[skip + 4] & 3
    if data[skip : skip + 1] in _OLD_BEGINNINGS and legacy.is_legacy(data[skip:]):
        return legacy.priority(data[skip:])
    return header.peek_priority(data, skip)


def with_ack_required(datagram: bytes) -> bytes:
    """The same packet, asking for an ACK, by which its destination makes itself known."""
    if legacy.is_legacy(datagram):
        return legacy.parse(datagram)[0].asking().as_datagram(LegacyVersion.V1)
    at = header.control_offset(datagram)
    if datagram[at] & _ACK_MASK:
        return datagram
    return datagram[:at] + bytes([datagram[at] | _ACK_REQUIRED]) + datagram[at + 1 :]


def _single(data: bytes, raw: RawPacket) -> bytes:
    packet = data[raw.start : raw.end]
    if packet[0]:
        size = len(packet) - _HC_BYTES
        packet = b"\0" + size.to_bytes(2, "little") + packet[3 + _HC_BYTES :]
    return header.VERSION_BYTE + packet


def _old(packet: legacy.LegacyPacket) -> tuple[RawPacket, bytes, LegacyVersion | None]:
    if packet.code == 0:
        datagram = packet.as_current()
        return header.parse_header(datagram, 1), datagram, None
    datagram = packet.as_datagram(LegacyVersion.V1)
    return packet.raw._replace(start=1, end=len(datagram), payload_start=legacy.V1_CODE_AT), datagram, packet.dialect
