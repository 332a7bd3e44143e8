"""JSerial framing (AS5669A) and its checksum.

DLE SOH | version u8 | length u16 | DLE STX | header checksum u16 | message | DLE ETX | packet checksum u16, all little
endian. Any other DLE (10h) is sent twice. The header checksum covers version and length; the packet checksum continues
it over the header checksum and the message. The message is what follows the version byte of a datagram.

The checksum is CRC-16 with the reflected polynomial 8408h, start FFFFh, no final XOR ("MCRF4XX"). The standard library
has the same polynomial in the other bit order, so bits are mirrored before and after.
"""

from __future__ import annotations

import binascii
import struct
from typing import Final

from jauspy.errors import ProtocolError

CRC_START: Final = 0xFFFF
_MIRRORED: Final = bytes(int(f"{byte:08b}"[::-1], 2) for byte in range(256))


def crc16(data: bytes | bytearray, start: int = CRC_START) -> int:
    """The checksum of `data`, continued from `start`."""
    return _mirror(binascii.crc_hqx(data.translate(_MIRRORED), _mirror(start)))


def _mirror(value: int) -> int:
    return _MIRRORED[value & 0xFF] << 8 | _MIRRORED[value >> 8]


_DLE: Final = b"\x10"
_SOH, _STX, _ETX = b"\x01", b"\x02", b"\x03"
_HEADER: Final = struct.Struct("<BH")
_U16: Final = struct.Struct("<H")
_EXPLICIT_ADDRESS: Final = 2
"""Bytes that some senders put after the length; they are ignored."""
_V1: Final = 1
_V1_LENGTH: Final = slice(2, 4)
"""The length inside a version 1 message, which is big endian in every other framing."""
MAX_BODY: Final = 2 + 0xFFFF
_NEXT: Final = {1: _STX, 2: _ETX}
"""The mark that ends each part of a frame, by the number of parts so far."""


def frame(datagram: bytes) -> bytes:
    """The frame of a checked datagram of one packet."""
    version, message = datagram[0], _swap_v1_length(datagram[0], datagram[1:])
    head = _HEADER.pack(version, len(message))
    header_crc = crc16(head)
    body = _U16.pack(header_crc) + message
    tail = _U16.pack(crc16(body, header_crc))
    return b"".join((_DLE, _SOH, _stuff(head), _DLE, _STX, _stuff(body), _DLE, _ETX, _stuff(tail)))


class FrameDecoder:
    """Finds frames in received bytes. A malformed frame is skipped up to the next DLE SOH; memory is bounded."""

    def __init__(self) -> None:
        self._parts: list[bytearray] = []
        self._errors: list[ProtocolError] = []
        self._escaped = False

    def feed(self, data: bytes) -> tuple[list[bytes], list[ProtocolError]]:
        """Add received bytes; returns the datagrams that they complete, and the errors of skipped frames."""
        datagrams: list[bytes] = []
        for chunk, is_mark in self._unstuff(data):
            try:
                if is_mark:
                    self._mark(chunk)
                elif (datagram := self._take(chunk)) is not None:
                    datagrams.append(datagram)
            except ProtocolError as error:
                self._parts = []
                self._errors.append(error)
        errors, self._errors = self._errors, []
        return datagrams, errors

    def _unstuff(self, data: bytes) -> list[tuple[bytes, bool]]:
        """Runs of plain bytes, and the marks between them (true)."""
        chunks: list[tuple[bytes, bool]] = []
        offset = 0
        while offset < len(data):
            if self._escaped:
                self._escaped = False
                mark = data[offset : offset + 1]
                chunks.append((mark, mark != _DLE))
                offset += 1
                continue
            end = data.find(_DLE, offset)
            if end < 0:
                chunks.append((data[offset:], False))
                break
            if end > offset:
                chunks.append((data[offset:end], False))
            self._escaped = True
            offset = end + 1
        return chunks

    def _take(self, data: bytes) -> bytes | None:
        parts = self._parts
        if not parts:
            return None
        parts[-1] += data
        if len(parts) == 1 and len(parts[0]) > _HEADER.size + _EXPLICIT_ADDRESS:
            raise ProtocolError("serial_header", "a header that does not end")
        if len(parts) == 2 and len(parts[1]) > MAX_BODY:
            raise ProtocolError("serial_too_long", "a message that does not end")
        if len(parts) < 3 or len(parts[2]) < _U16.size:
            return None
        self._parts = []
        return _check(parts[0], parts[1], parts[2][: _U16.size])

    def _mark(self, mark: bytes) -> None:
        parts = self._parts
        if mark == _SOH:
            self._parts = [bytearray()]
            if parts:
                self._errors.append(ProtocolError("serial_unfinished", "the next frame begins inside of this one"))
        elif parts and mark == _NEXT.get(len(parts)):
            parts.append(bytearray())
        elif parts:
            raise ProtocolError("serial_mark", f"DLE {mark.hex()} in the wrong place")


def _check(head: bytearray, body: bytearray, tail: bytearray) -> bytes:
    if len(head) not in (_HEADER.size, _HEADER.size + _EXPLICIT_ADDRESS) or len(body) < _U16.size:
        raise ProtocolError("serial_header", f"a header of {len(head)} bytes")
    version, length = _HEADER.unpack_from(head)
    (header_crc,) = _U16.unpack_from(body)
    if header_crc not in (crc16(head), crc16(head[: _HEADER.size])):
        raise ProtocolError("serial_checksum", "the header's checksum is wrong")
    if crc16(body, header_crc) != _U16.unpack(tail)[0]:
        raise ProtocolError("serial_checksum", "the packet's checksum is wrong")
    if len(body) - _U16.size != length:
        raise ProtocolError("serial_length", f"{len(body) - _U16.size} bytes where {length} were announced")
    version &= 0x0F
    return bytes([version]) + _swap_v1_length(version, bytes(body[_U16.size :]))


def _swap_v1_length(version: int, message: bytes) -> bytes:
    """A version 1 message with its length in the other byte order; others as they are."""
    if version != _V1 or len(message) < _V1_LENGTH.stop:
        return message
    return message[: _V1_LENGTH.start] + message[_V1_LENGTH][::-1] + message[_V1_LENGTH.stop :]


def _stuff(data: bytes) -> bytes:
    return data.replace(_DLE, _DLE + _DLE)
