"""JTCP packets in captured TCP segments, which may be reordered, repeated, missing, or begin in the middle."""

from __future__ import annotations

from collections import Counter, OrderedDict
from dataclasses import dataclass, field
from typing import Final

from jauspy.protocol import header
from jauspy.protocol.jtcp import StreamDecoder

MAX_STREAMS: Final = 64
"""Maximal number of directions of connections; the one without a segment for longest is dropped first."""
MAX_PENDING: Final = 256 << 10
"""Bytes of a direction that wait for a missing segment; more of them count it as lost."""
MAX_SEGMENTS: Final = 256
"""The same for the number of segments."""
_FIN, _SYN, _RST = 1, 2, 4
_MODULUS: Final = 1 << 32
_HEADER_FLAGS: Final = (0x00, 0x40)
"""First bytes of a packet: without header compression, or with a proposal of it."""

Direction = tuple[tuple[str, int], tuple[str, int]]
"""(address, port) of sender and receiver."""


@dataclass(slots=True)
class _Stream:
    next: int
    """Sequence number of the next byte."""
    decoder: StreamDecoder = field(default_factory=StreamDecoder)
    pending: dict[int, bytes] = field(default_factory=dict)
    has_begun: bool = True
    """False if the first bytes have not been captured, so that the next ones are taken for the start of a packet."""


class TcpStreams:
    """Puts the segments of each direction in order, and splits them; `skipped` counts what cannot be read."""

    def __init__(self, skipped: Counter[str]) -> None:
        self._skipped = skipped
        self._streams: OrderedDict[Direction, _Stream] = OrderedDict()

    def add(self, direction: Direction, sequence: int, flags: int, data: bytes) -> list[bytes]:
        """The datagrams that a segment completes; `flags` and `sequence` of its header."""
        if flags & _SYN:
            self._streams[direction] = _Stream((sequence + 1) % _MODULUS)
            sequence = (sequence + 1) % _MODULUS
        found: list[bytes] = []
        if data:
            stream = self._streams.get(direction)
            if stream is None:
                stream = self._streams[direction] = _Stream(sequence, has_begun=False)
            self._streams.move_to_end(direction)
            found = self._arrived(direction, stream, sequence, data)
        if flags & (_FIN | _RST):
            self._streams.pop(direction, None)
        if len(self._streams) > MAX_STREAMS:
            self._streams.popitem(last=False)
        return found

    def _arrived(self, direction: Direction, stream: _Stream, sequence: int, data: bytes) -> list[bytes]:
        ahead = (sequence - stream.next) % _MODULUS
        if ahead >= _MODULUS // 2:  # sent again, perhaps with more
            data, ahead = data[_MODULUS - ahead :], 0
            sequence = stream.next
        if not data:
            return []
        known = stream.pending.get(sequence, b"")
        stream.pending[sequence] = data if len(data) > len(known) else known
        waiting = stream.pending.values()
        if ahead and (len(waiting) > MAX_SEGMENTS or sum(map(len, waiting)) > MAX_PENDING):
            self._skipped["TCP stream with a missing segment"] += 1
            first = min(stream.pending, key=lambda number: (number - stream.next) % _MODULUS)
            renewed = _Stream(first, pending=stream.pending, has_begun=False)
            stream = self._streams[direction] = renewed
        return self._read(direction, stream)

    def _read(self, direction: Direction, stream: _Stream) -> list[bytes]:
        found: list[bytes] = []
        while data := self._following(stream):
            if not stream.has_begun:
                stream.has_begun = True
                if data[0] in _HEADER_FLAGS:
                    stream.decoder.feed(header.VERSION_BYTE)
            datagrams, error = stream.decoder.feed(data)
            found += datagrams
            if error is not None:
                self._skipped["TCP stream whose packets cannot be told apart"] += 1
                renewed = _Stream(stream.next, pending=stream.pending, has_begun=False)
                stream = self._streams[direction] = renewed
        return found

    @staticmethod
    def _following(stream: _Stream) -> bytes:
        """The pending bytes that are next, which are no longer pending; none if they have not arrived."""
        for sequence, data in list(stream.pending.items()):
            behind = (stream.next - sequence) % _MODULUS
            if behind < _MODULUS // 2:
                del stream.pending[sequence]
                if behind < len(data):
                    stream.next = (sequence + len(data)) % _MODULUS
                    return data[behind:]
        return b""
