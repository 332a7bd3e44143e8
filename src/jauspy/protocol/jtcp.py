"""JTCP framing (AS5669A): one version byte per direction, then packets back to back, told apart by their data size.

Nothing marks where a packet begins. Whoever has lost the boundary can only close the connection and start again, so
everything that does not look like a header is an error.
"""

from __future__ import annotations

import struct
from typing import Final

from jauspy.errors import ProtocolError
from jauspy.protocol import header

GREETING: Final = bytes([header.VERSION])
"""The first byte of a stream, in each direction."""

_START: Final = struct.Struct("<BH")


def frame(datagram: bytes) -> bytes:
    """The bytes of a checked datagram in a stream."""
    return datagram[1:]


class StreamDecoder:
    """Cuts a stream into datagrams of one packet each. Memory is bounded by the largest packet and what is fed."""

    def __init__(self) -> None:
        self._greeted = False
        self._buffer = bytearray()

    def feed(self, data: bytes) -> list[bytes]:
        """Take bytes as they come; returns the packets they complete. `ProtocolError` is the end of the stream."""
        self._buffer += data
        if not self._greeted and self._buffer:
            if self._buffer[0] != header.VERSION:
                raise ProtocolError("stream_version", f"the stream begins with version {self._buffer[0]}")
            del self._buffer[0]
            self._greeted = True
        datagrams: list[bytes] = []
        start = 0
        while len(self._buffer) - start >= _START.size:
            end = start + self._size(start)
            if end > len(self._buffer):
                break
            datagrams.append(GREETING + self._buffer[start:end])
            start = end
        del self._buffer[:start]
        return datagrams

    def _size(self, start: int) -> int:
        flags, size = _START.unpack_from(self._buffer, start)
        if flags not in (0, 0x40) or size < header.OVERHEAD:
            raise ProtocolError("stream_lost", f"flags {flags:02x} and size {size} are no header")
        return int(size)
