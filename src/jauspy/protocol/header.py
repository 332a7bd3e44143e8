"""The general transport header of AS5669A (version 2): one packet, parsed and packed.

Layout after the version byte, little endian: flags u8 | data size u16 | [HC number u8, HC length u8] | control u8 |
destination u32 | source u32 | payload | sequence number u16. "Data size" counts all of it.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from enum import IntEnum
from functools import lru_cache
from typing import Final, NamedTuple

from jauspy.errors import ProtocolError
from jauspy.ids import JausID, message_id

VERSION: Final = 2
VERSION_BYTE: Final = bytes([VERSION])
OVERHEAD: Final = 14
"""Bytes of a packet without its payload (and without the version byte)."""
MAX_PAYLOAD: Final = 4079
"""Bytes of payload that are sent in one packet: 4096 on the wire with version byte and header compression."""

_HEADER: Final = struct.Struct("<BHBII")
_ALONE: Final = struct.Struct("<BBHBII")
"""Header of a datagram with one packet, with the version byte."""
_COMPRESSED: Final = struct.Struct("<BHBBBII")
_SEQUENCE: Final = struct.Struct("<H")
_NOT_PLAIN: Final = 0xF0
"""The bits of the control byte for an ACK and for a fragment."""
_MESSAGE_MIN: Final = 4
"""Bytes of a message id and of a sequence number."""


class Priority(IntEnum):
    """Bits 0-1 of the control byte."""

    LOW = 0
    STANDARD = 1
    HIGH = 2
    SAFETY_CRITICAL = 3


class Broadcast(IntEnum):
    """Bits 2-3 of the control byte. `RESERVED` is sent by faulty peers and must be accepted."""

    NONE = 0
    LOCAL = 1
    GLOBAL = 2
    RESERVED = 3


class Ack(IntEnum):
    """Bits 4-5 of the control byte."""

    NONE = 0
    REQUIRED = 1
    NAK = 2
    ACK = 3


class DataFlag(IntEnum):
    """Bits 6-7 of the control byte: which fragment of a large message this is."""

    SINGLE = 0
    FIRST = 1
    MIDDLE = 2
    LAST = 3


@dataclass(frozen=True, slots=True)
class Packet:
    """One packet. `payload` is a JAUS message (id first) or a fragment of one; empty in an ACK."""

    source: JausID
    destination: JausID
    payload: bytes
    sequence: int = 0
    priority: Priority = Priority.STANDARD
    broadcast: Broadcast = Broadcast.NONE
    ack: Ack = Ack.NONE
    data_flag: DataFlag = DataFlag.SINGLE


def pack(packet: Packet) -> bytes:
    """The bytes of a packet, without version byte; raises `ProtocolError` when the payload is too long."""
    size = OVERHEAD + len(packet.payload)
    if size > 0xFFFF:
        raise ProtocolError("oversize", f"a payload of {len(packet.payload)} bytes does not fit one packet")
    control = packet.priority | packet.broadcast << 2 | packet.ack << 4 | packet.data_flag << 6
    head = _HEADER.pack(0, size, control, int(packet.destination), int(packet.source))
    return head + packet.payload + _SEQUENCE.pack(packet.sequence)


def pack_alone(source: int, destination: int, control: int, payload: bytes, sequence: int) -> bytes:
    """The datagram of one packet whose payload is known to fit; half the time that `Packet` and `pack` take."""
    head = _ALONE.pack(VERSION, 0, OVERHEAD + len(payload), control, destination, source)
    return head + payload + _SEQUENCE.pack(sequence)


class RawPacket(NamedTuple):
    """The header of a packet as numbers, with its offsets in a datagram: all that routing needs."""

    start: int
    end: int
    payload_start: int
    control: int
    destination: int
    source: int

    @property
    def ack(self) -> int:
        """The ack field, as in `Ack`."""
        return self.control >> 4 & 3

    @property
    def broadcast(self) -> int:
        """The broadcast field, as in `Broadcast`."""
        return self.control >> 2 & 3

    @property
    def priority(self) -> int:
        """The priority field, as in `Priority`."""
        return self.control & 3


_new: Final = tuple.__new__  # a third of the time of RawPacket(...), which counts here


def control_offset(datagram: bytes) -> int:
    """The offset of the control byte in the datagram of a checked packet, version byte included."""
    return 6 if datagram[1] & 0xC0 else 4


def parse_alone(datagram: bytes | memoryview) -> RawPacket | None:
    """The header of a plain packet that is alone in its datagram, as nearly all are; None for any other datagram."""
    size = len(datagram)
    if size <= OVERHEAD or datagram[0] != VERSION or datagram[1]:
        return None
    _, _, data_size, control, destination, source = _ALONE.unpack_from(datagram)
    if data_size != size - 1:
        return None
    return _new(RawPacket, (1, size, _ALONE.size, control, destination, source))


def broadcast_code(datagram: bytes) -> int | None:
    """The message id of a broadcast that is alone and whole in its datagram, without an ACK; None for any other."""
    raw = parse_alone(datagram)
    if raw is None or not raw.broadcast or raw.control & _NOT_PLAIN or raw.end - raw.payload_start < _MESSAGE_MIN:
        return None
    return message_id(datagram, raw.payload_start)


def parse_header(data: bytes | memoryview, start: int = 0) -> RawPacket:
    """The header of the packet at `start` (after the version byte); raises `ProtocolError`.

    A peer may propose header compression (flag 1): the header is complete, and two more bytes in it are skipped.
    """
    left = len(data) - start
    if left < OVERHEAD:
        raise ProtocolError("truncated", f"{left} bytes are too few for a header")
    flags, size, control, destination, source = _HEADER.unpack_from(data, start)
    minimum = OVERHEAD
    payload_start = start + _HEADER.size
    if flags & 0xC0:
        if flags >> 6 != 1:
            raise ProtocolError("compressed", "header compression was not agreed on")
        minimum = OVERHEAD + 2
        payload_start = start + _COMPRESSED.size
        if left < minimum:
            raise ProtocolError("truncated", f"{left} bytes are too few for a header with compression")
        _, _, _, _, control, destination, source = _COMPRESSED.unpack_from(data, start)
    if size < minimum:
        raise ProtocolError("size", f"a data size of {size} is below the minimum of {minimum}")
    if size > left:
        raise ProtocolError("truncated", f"a data size of {size} in {left} bytes")
    if flags & 0x3F:
        raise ProtocolError("message_type", f"message type {flags & 0x3F} is reserved")
    return _new(RawPacket, (start, start + size, payload_start, control, destination, source))


_id: Final = lru_cache(maxsize=1024)(JausID.from_int)
"""The ids of a network are few, and are in every packet."""


_FIELDS: Final = tuple(
    (Priority(control & 3), Broadcast(control >> 2 & 3), Ack(control >> 4 & 3), DataFlag(control >> 6))
    for control in range(256)
)
"""The fields of each control byte."""


def parse(data: bytes | memoryview, start: int = 0) -> tuple[Packet, int]:
    """The packet at `start` and the offset behind it; raises `ProtocolError`."""
    raw = parse_header(data, start)
    (sequence,) = _SEQUENCE.unpack_from(data, raw.end - 2)
    packet = Packet(
        _id(raw.source),
        _id(raw.destination),
        bytes(data[raw.payload_start : raw.end - 2]),
        sequence,
        *_FIELDS[raw.control],
    )
    return packet, raw.end
