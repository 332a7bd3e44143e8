"""Legacy headers: AS5669 version 1, and "JAUS01.0" (OPC 2.75). Both contain the header of the JAUS RA.

RA header, 16 bytes, little endian: properties u8 (priority 0-3, ack 4-5) | version u8 (2) | command code u16 |
destination u32 | source u32 | data size (12 bits) and data control (4 bits) u16 | sequence number u16.
Version 1 puts 5 bytes before it (01, header compression u16, length u16 BIG endian), OPC the text JAUS01.0.

A packet with command code 0 contains a message of AS5669A, which begins with its id. One with another command code is
a message of the JAUS RA, which is forwarded unchanged; only its outer header is converted to that of its receiver.
"""

from __future__ import annotations

import struct
from collections import OrderedDict
from enum import Enum
from typing import Final, NamedTuple

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.protocol.header import VERSION_BYTE, Ack, DataFlag, Packet, Priority, RawPacket, pack

V1: Final = 1
OPC_GREETING: Final = b"JAUS01.0"

_V1_HEAD: Final = struct.Struct(">B2sH")
_RA: Final = struct.Struct("<BBHIIHH")
V1_CODE_OFFSET: Final = _V1_HEAD.size + 2
"""Offset of the command code in a version 1 datagram; it corresponds to the message id of AS5669A."""
RA_VERSION: Final = 2
RA_SIZE: Final = _RA.size
_MAX_DATA: Final = 0xFFF
_FLAGS: Final = {0: DataFlag.SINGLE, 1: DataFlag.FIRST, 2: DataFlag.MIDDLE, 4: DataFlag.MIDDLE, 8: DataFlag.LAST}
"""Data flags by the field data control; 4 is a middle fragment that is resent."""
MAX_PEER_VERSIONS: Final = 1024


class LegacyVersion(Enum):
    """The outer header of a legacy packet."""

    V1 = "AS5669 1"
    OPC = "OPC 2.75"


class LegacyPacket(NamedTuple):
    """One legacy packet; `header` is its RA header, `payload` what follows."""

    version: LegacyVersion
    code: int
    raw: RawPacket
    header: bytes
    payload: bytes

    def as_datagram(self, version: LegacyVersion) -> bytes:
        """The same packet with this outer header."""
        body = self.header + self.payload
        if version is LegacyVersion.OPC:
            return OPC_GREETING + body
        return _V1_HEAD.pack(V1, b"\0\0", len(body)) + body

    def as_current(self) -> bytes:
        """The AS5669A datagram of a packet without a command code."""
        _, _, _, _, _, size, sequence = _RA.unpack(self.header)
        packet = Packet(
            JausID.from_int(self.raw.source),
            JausID.from_int(self.raw.destination),
            self.payload,
            sequence,
            Priority(self.raw.priority),
            ack=Ack(self.raw.ack),
            data_flag=_flag(size >> 12),
        )
        return VERSION_BYTE + pack(packet)

    def with_ack_required(self) -> LegacyPacket:
        """The same packet with an ACK requested; the ACK reveals the address of its destination."""
        if self.header[0] & 0x30:
            return self
        return self._replace(header=bytes([self.header[0] | Ack.REQUIRED << 4]) + self.header[1:])


def is_legacy(data: bytes) -> bool:
    """True when the data begins like a legacy header."""
    return data[:1] == b"\x01" or data.startswith(OPC_GREETING)


def parse(data: bytes) -> list[LegacyPacket]:
    """The packets of a datagram with a legacy header; raises `ProtocolError`."""
    if data.startswith(OPC_GREETING):
        return [_parse_ra(data[len(OPC_GREETING) :], LegacyVersion.OPC)]
    packets = []
    offset = 1
    while offset < len(data):
        head = (
            data[offset - 1 : offset - 1 + _V1_HEAD.size]
            if offset == 1
            else b"\x01" + data[offset : offset + _V1_HEAD.size - 1]
        )
        if len(head) < _V1_HEAD.size:
            raise ProtocolError("truncated", "too few bytes for a version 1 header")
        _, compression, length = _V1_HEAD.unpack(head)
        if compression[1] & 3 > 1:
            raise ProtocolError("compressed", "header compression was not agreed on")
        body = data[offset + _V1_HEAD.size - 1 :][:length]
        if len(body) < length:
            raise ProtocolError("truncated", f"a length of {length} in {len(body)} bytes")
        packets.append(_parse_ra(body, LegacyVersion.V1))
        offset += _V1_HEAD.size - 1 + length
    if not packets:
        raise ProtocolError("empty", "a datagram without a packet")
    return packets


def priority(data: bytes) -> int:
    """The AS5669A priority of a legacy datagram; LOW when it is truncated."""
    offset = len(OPC_GREETING) if data.startswith(OPC_GREETING) else _V1_HEAD.size
    return _priority(data[offset]) if offset < len(data) else Priority.LOW


class PeerVersions:
    """The legacy version that each id last used. AS5669A packets are never converted."""

    def __init__(self) -> None:
        self._known: OrderedDict[int, LegacyVersion] = OrderedDict()

    def learn(self, id: int, version: LegacyVersion) -> None:
        """Remember the version of a peer on a network."""
        self._known[id] = version
        self._known.move_to_end(id)
        if len(self._known) > MAX_PEER_VERSIONS:
            self._known.popitem(last=False)

    def convert(self, id: int, datagram: bytes) -> bytes:
        """The same packet in the version that `id` uses."""
        if datagram[0] != V1 or self._known.get(id) is not LegacyVersion.OPC:
            return datagram
        return parse(datagram)[0].as_datagram(LegacyVersion.OPC)


def _parse_ra(body: bytes, outer: LegacyVersion) -> LegacyPacket:
    if len(body) < RA_SIZE:
        raise ProtocolError("truncated", f"{len(body)} bytes are too few for a JAUS RA header")
    properties, version, code, destination, source, size, _ = _RA.unpack_from(body)
    if version != RA_VERSION:
        raise ProtocolError("ra_version", f"version {version} of the JAUS RA header is not {RA_VERSION}")
    payload = body[RA_SIZE:]
    if len(payload) & _MAX_DATA != size & _MAX_DATA:
        raise ProtocolError("size", f"a data size of {size & _MAX_DATA} with {len(payload)} bytes")
    control = _priority(properties) | (properties >> 4 & 3) << 4 | _flag(size >> 12) << 6
    raw = RawPacket(0, len(body), RA_SIZE, control, destination, source=source)
    return LegacyPacket(outer, code, raw, body[:RA_SIZE], payload)


def _flag(control: int) -> DataFlag:
    if control not in _FLAGS:
        raise ProtocolError("data_control", f"data control {control} has no meaning")
    return _FLAGS[control]


def _priority(properties: int) -> int:
    """Convert a priority from 0..15 to 0..3, as known node managers, without their error at 0."""
    return min(max((properties & 0x0F) - 3, 0) // 3, Priority.SAFETY_CRITICAL)
