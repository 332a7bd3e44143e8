"""Large messages in pieces (AS5669A): how a payload is cut, and how far pieces that follow each other reach."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from jauspy.protocol import header
from jauspy.protocol.header import DataFlag, Packet

FRAGMENT_OVERHEAD: Final = 256
"""Bytes of memory that a piece is charged with beyond its payload."""


def fragment_count(size: int) -> int:
    """How many packets a payload of this size takes."""
    return max(1, -(-size // header.MAX_PAYLOAD))


def fragment_at(payload: bytes, index: int) -> tuple[bytes, DataFlag]:
    """One piece of a payload, and what it is among the others."""
    last = fragment_count(len(payload)) - 1
    part = payload[index * header.MAX_PAYLOAD : (index + 1) * header.MAX_PAYLOAD]
    if last == 0:
        return part, DataFlag.SINGLE
    if index == 0:
        return part, DataFlag.FIRST
    return part, DataFlag.LAST if index == last else DataFlag.MIDDLE


@dataclass(slots=True)
class FragmentRun:
    """Pieces with consecutive numbers from `first` to `last`; a whole message when it `begins` and `ends`."""

    first: int
    last: int
    begins: bool
    ends: bool
    pieces: deque[bytes]
    size: int
    touched: float
    head: Packet

    @classmethod
    def of(cls, packet: Packet, now: float) -> FragmentRun:
        """The run of one piece."""
        flag, payload = packet.data_flag, packet.payload
        begins, ends = flag is DataFlag.FIRST, flag is DataFlag.LAST
        return cls(packet.sequence, packet.sequence, begins, ends, deque((payload,)), len(payload), now, packet)

    def __len__(self) -> int:
        return len(self.pieces)

    @property
    def whole(self) -> bool:
        """True when nothing is missing."""
        return self.begins and self.ends

    @property
    def cost(self) -> int:
        """Bytes of memory."""
        return self.size + FRAGMENT_OVERHEAD * len(self.pieces)

    def numbers(self) -> Iterator[int]:
        """The sequence numbers of the pieces."""
        return ((self.first + step) & 0xFFFF for step in range(len(self.pieces)))

    def join(self, after: FragmentRun) -> FragmentRun:
        """One run of this and the one that follows it; the longer one takes up the shorter one's pieces."""
        if len(after) > len(self):
            after.pieces.extendleft(reversed(self.pieces))
            pieces = after.pieces
        else:
            self.pieces.extend(after.pieces)
            pieces = self.pieces
        size, touched = self.size + after.size, max(self.touched, after.touched)
        return FragmentRun(self.first, after.last, self.begins, after.ends, pieces, size, touched, self.head)
