"""JTCP framing (AS5669A): one version byte per direction, then packets back to back, delimited by their size.

Nothing marks the start of a packet. A receiver that has lost the boundary can only close the connection, so everything
that does not look like a header is an error.

A stream of AS5669 version 1 has `length u16 BIG endian | RA header | message` for each packet; the one other node
manager with JTCP of version 1 puts the two bytes of header compression, which are 0, before the length.
"""

from __future__ import annotations

import struct
from typing import Final

from jauspy.errors import ProtocolError
from jauspy.protocol import header, legacy

_START: Final = struct.Struct("<BH")
_V1_LENGTH: Final = struct.Struct(">H")
_COMPRESSION: Final = 2
"""Bytes of header compression in a version 1 packet."""
_HEAD_SIZES: Final = {header.VERSION: _START.size, legacy.V1: _COMPRESSION + _V1_LENGTH.size}
"""Bytes that must have arrived to know the size of a packet, by version."""
_PREFIX: Final = bytes([header.VERSION])
_PREFIX_V1: Final = bytes([legacy.V1]) + bytes(_COMPRESSION)


class StreamDecoder:
    """Splits a stream into datagrams of one packet each. Memory is bounded by the largest packet and what is fed."""

    def __init__(self) -> None:
        self.version: int | None = None
        """The first byte of the stream; None until it has arrived."""
        self._buffer = bytearray()
        self._has_compression = False

    def feed(self, data: bytes) -> tuple[list[bytes], ProtocolError | None]:
        """Add received bytes; returns the datagrams that they complete, and the error that ends the stream, if any."""
        self._buffer += data
        datagrams: list[bytes] = []
        start = 0
        try:
            self._read_version()
            while self.version is not None and len(self._buffer) - start >= _HEAD_SIZES[self.version]:
                head, body, end = self._locate(start) if self.version == header.VERSION else self._locate_v1(start)
                if end > len(self._buffer):
                    break
                datagrams.append(head + self._buffer[body:end])
                start = end
        except ProtocolError as error:
            return datagrams, error
        del self._buffer[:start]
        return datagrams, None

    def frame(self, datagram: bytes) -> bytes:
        """The bytes of a checked datagram in the stream to this peer."""
        if datagram[0] == legacy.V1 and not self._has_compression:
            return datagram[1 + _COMPRESSION :]
        return datagram[1:]

    def _read_version(self) -> None:
        if self.version is None and self._buffer:
            if self._buffer[0] not in _HEAD_SIZES:
                raise ProtocolError("stream_version", f"the stream begins with version {self._buffer[0]}")
            self.version = self._buffer.pop(0)

    def _locate(self, start: int) -> tuple[bytes, int, int]:
        """Split a datagram: the bytes before the packet, and the offsets where the packet begins and ends."""
        flags, size = _START.unpack_from(self._buffer, start)
        if flags not in (0, 0x40) or size < header.OVERHEAD:
            raise ProtocolError("stream_lost", f"flags {flags:02x} and size {size} are no header")
        return _PREFIX, start, start + size

    def _locate_v1(self, start: int) -> tuple[bytes, int, int]:
        (length,) = _V1_LENGTH.unpack_from(self._buffer, start)
        offset = start
        if not length:
            self._has_compression = True
            offset += _COMPRESSION
            (length,) = _V1_LENGTH.unpack_from(self._buffer, offset)
        body = offset + _V1_LENGTH.size
        if length < legacy.RA_SIZE or self._buffer[body + 1 : body + 2] not in (b"", bytes([legacy.RA_VERSION])):
            raise ProtocolError("stream_lost", f"a length of {length} without a header of version 1")
        return _PREFIX_V1 + _V1_LENGTH.pack(length), body, body + length
