"""Datagrams of a case: whole messages, damaged headers, and fragments that do not fit together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from random import Random
from typing import Final

from jauspy.ids import JausID
from jauspy.protocol import header
from jauspy.protocol.header import Ack, DataFlag

MAX_FRAGMENTS: Final = 8
MAX_DATAGRAM: Final = 65507
"""Bytes of the largest UDP datagram over IPv4."""
_SIZE_AT: Final = 2
_DESTINATION_AT: Final = 5
_SOURCE_AT: Final = 9


@dataclass(slots=True)
class Packer:
    """Puts messages into datagrams, with increasing sequence numbers."""

    destination: JausID
    sequence: int

    def whole(self, payload: bytes, source: JausID, *, ack: Ack = Ack.NONE) -> list[bytes]:
        """The datagrams of one message: fragments if it is large."""
        size = header.MAX_PAYLOAD
        parts = [payload[at : at + size] for at in range(0, len(payload), size)]
        if len(parts) == 1:
            return [self._packet(payload, source, DataFlag.SINGLE, ack)]
        flags = [DataFlag.FIRST, *(DataFlag.MIDDLE,) * (len(parts) - 2), DataFlag.LAST]
        return [self._packet(part, source, flag, ack) for part, flag in zip(parts, flags, strict=True)]

    def fragments(self, rng: Random, payload: bytes, source: JausID) -> list[bytes]:
        """Fragments of one message: one is missing, out of order, repeated, empty, or has a wrong flag."""
        size = max(1, -(-len(payload) // rng.randint(2, MAX_FRAGMENTS)))
        parts = [payload[at : at + size] for at in range(0, len(payload), size)][:MAX_FRAGMENTS]
        flags = [DataFlag.FIRST, *(DataFlag.MIDDLE,) * max(0, len(parts) - 2), DataFlag.LAST]
        pieces = list(zip(parts, flags, strict=False))
        number = rng.randrange(len(pieces))
        match rng.randrange(6):
            case 0:
                del pieces[number]
            case 1:
                rng.shuffle(pieces)
            case 2:
                pieces.insert(rng.randrange(len(pieces) + 1), pieces[number])
            case 3:
                pieces[number] = (b"", pieces[number][1])
            case 4:
                pieces[number] = (pieces[number][0], rng.choice(list(DataFlag)))
        ack = rng.choice((Ack.NONE, Ack.REQUIRED))
        return [self._packet(part, source, flag, ack, skip=rng.random() < 0.05) for part, flag in pieces]

    def damaged(self, rng: Random, payload: bytes, source: JausID) -> list[bytes]:
        """One datagram whose header is damaged once or twice."""
        data = bytearray(self._packet(payload[: header.MAX_PAYLOAD], source, DataFlag.SINGLE, Ack.NONE))
        for _ in range(rng.choice((1, 1, 2))):
            rng.choice(_DAMAGES)(rng, data)
        return [bytes(data[:MAX_DATAGRAM])]

    def _packet(self, payload: bytes, source: JausID, flag: DataFlag, ack: Ack, *, skip: bool = False) -> bytes:
        self.sequence = (self.sequence + 1 + skip) & 0xFFFF
        control = 1 | ack << 4 | flag << 6
        return header.pack_alone(int(source), int(self.destination), control, payload, self.sequence)


def _version(rng: Random, data: bytearray) -> None:
    data[:1] = bytes([rng.choice((0, 1, 3, 0x4A, 255))])


def _flags(rng: Random, data: bytearray) -> None:
    """Reserved message types and header compression that nobody agreed on."""
    if len(data) > 1:
        data[1] = rng.choice((1, 0x3F, 0x40, 0x80, 0xC0, rng.randrange(256)))


def _size(rng: Random, data: bytearray) -> None:
    if len(data) >= _SIZE_AT + 2:
        size = rng.choice((0, 1, 13, 14, 15, len(data), len(data) + 1, 0x7FFF, 0xFFFF))
        data[_SIZE_AT : _SIZE_AT + 2] = (size & 0xFFFF).to_bytes(2, "little")


def _control(rng: Random, data: bytearray) -> None:
    if len(data) > _DESTINATION_AT - 1:
        data[_DESTINATION_AT - 1] = rng.randrange(256)


def _ids(rng: Random, data: bytearray) -> None:
    at = rng.choice((_DESTINATION_AT, _SOURCE_AT))
    if len(data) >= at + 4:
        kept = bytes(data[_DESTINATION_AT : _DESTINATION_AT + 4])
        choices = (b"\0\0\0\0", b"\xff\xff\xff\xff", kept, b"\xff\xff" + kept[2:], rng.randbytes(4))
        data[at : at + 4] = rng.choice(choices)


def _cut(rng: Random, data: bytearray) -> None:
    del data[rng.randrange(len(data) + 1) :]


def _append(rng: Random, data: bytearray) -> None:
    data += rng.choice((b"\0", rng.randbytes(rng.randint(1, 40)), bytes(data[1:])))


def _garbage(rng: Random, data: bytearray) -> None:
    data[:] = rng.randbytes(rng.choice((0, 1, 2, 14, 15, 16, 400)))


_DAMAGES: Final[Sequence[Callable[[Random, bytearray], None]]] = (
    _version,
    _flags,
    _size,
    _size,
    _control,
    _ids,
    _cut,
    _append,
    _garbage,
)
