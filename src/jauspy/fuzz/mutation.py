"""Seeds of a campaign, and mutations of their bytes: at the offsets of counts, tags and numbers, or anywhere."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Final, Literal, TypeAlias

from jauspy.capture.dissect import dissect
from jauspy.capture.reader import CaptureReader, from_lines, is_capture
from jauspy.codec.items import Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.scalars import FLOATS, SIZES
from jauspy.errors import ConfigError
from jauspy.fuzz.messages import FuzzTarget, MessageMaker, Style
from jauspy.messages import registry

ANY_PER_MESSAGE: Final = 3
"""Random seeds of each message, beside the shortest one and the one with all fields."""


@dataclass(frozen=True, slots=True)
class Seed:
    """Bytes to start from, their message, and the offsets of its parts."""

    target: int
    data: bytes
    offsets: tuple[ByteSpan, ...]


def file_payloads(path: Path) -> list[bytes]:
    """The messages in a pcap, pcapng or hex file, possibly none; `ConfigError` for other files."""
    try:
        with path.open("rb") as file:
            if is_capture(file.peek(4)):
                found = [
                    p for datagram in CaptureReader(file, name=str(path), port=None) for p in _of(datagram.payload)
                ]
            else:
                found = [p for _, data in from_lines(file.read().decode("ascii")) for p in _of(data) or [data]]
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None
    except (UnicodeDecodeError, ConfigError) as error:
        reason = f": {error}" if isinstance(error, ConfigError) else ""
        raise ConfigError(f"{path} is neither a pcap or pcapng file nor hex text{reason}") from None
    return list(dict.fromkeys(payload for payload in found if len(payload) >= 2))


def _of(datagram: bytes) -> list[bytes]:
    return [bytes(part.packet.payload) for part in dissect(datagram, registry).parts]


def from_payloads(targets: Sequence[FuzzTarget], payloads: Iterable[bytes]) -> Iterator[Seed]:
    """A seed for every message that has the id of a payload."""
    for payload in payloads:
        for number, target in enumerate(targets):
            if payload.startswith(target.id):
                yield Seed(number, payload, offsets_of(target.layout, payload))


def from_schemas(targets: Sequence[FuzzTarget]) -> Iterator[Seed]:
    """Seeds of every message, always the same ones."""
    rng = Random(0)  # noqa: S311 - chance, not secrets
    styles = (Style.SHORTEST, Style.FULL, *(Style.ANY,) * ANY_PER_MESSAGE)
    for number, target in enumerate(targets):
        made = {MessageMaker(rng, style, targets).message(target) for style in styles}
        for data in sorted(made):
            yield Seed(number, data, offsets_of(target.layout, data))


MAX_INPUT_SIZE: Final = 65536
"""Size of the largest input in bytes: more does not fit into a datagram."""

_FLOATS: Final = tuple(
    bytes.fromhex(text)
    for text in ("0000807f", "000080ff", "0000c07f", "0100807f", "ffff7f7f", "00000080", "01000000")  # inf, NaN, edges
)
_DOUBLES: Final = tuple(
    bytes.fromhex(text)[::-1]
    for text in ("7ff0000000000000", "fff0000000000000", "7ff8000000000000", "7fefffffffffffff", "8000000000000000")
)

Mutation: TypeAlias = "Callable[[Random, bytearray, ByteSpan, Sequence[Seed]], None]"


def mutate(rng: Random, seed: Seed, others: Sequence[Seed]) -> bytes:
    """The seed's bytes, changed one to four times; the message id is kept."""
    data = bytearray(seed.data)
    for _ in range(rng.choice((1, 1, 1, 2, 2, 3, 4))):
        whole = len(data) == len(seed.data)  # the offsets are no longer valid
        if seed.offsets and whole and rng.random() < 0.7:
            offset = rng.choice(seed.offsets)
            rng.choice(_AT_OFFSET[offset.kind])(rng, data, offset, others)
        else:
            rng.choice(_UNSTRUCTURED)(rng, data, others)
    if rng.random() < 0.003:
        _grow(rng, data)
    return bytes(data[:MAX_INPUT_SIZE])


def _put(data: bytearray, offset: ByteSpan, value: int) -> None:
    size = offset.size
    data[offset.at : offset.at + size] = (value & ((1 << 8 * size) - 1)).to_bytes(size, "little")


def _get(data: bytearray, offset: ByteSpan) -> int:
    return int.from_bytes(data[offset.at : offset.at + offset.size], "little")


# --- numbers ----------------------------------------------------------------------------------------------------------


def _edge(rng: Random, data: bytearray, offset: ByteSpan, _: Sequence[Seed]) -> None:
    top = (1 << 8 * offset.size) - 1
    _put(data, offset, rng.choice((0, 1, top, top - 1, top >> 1, (top >> 1) + 1)))


def _step(rng: Random, data: bytearray, offset: ByteSpan, _: Sequence[Seed]) -> None:
    _put(data, offset, _get(data, offset) + rng.choice((-2, -1, 1, 2)))


def _limit(rng: Random, data: bytearray, offset: ByteSpan, others: Sequence[Seed]) -> None:
    """A value next to an allowed one, or a special float."""
    item = offset.item
    if not isinstance(item, Number):
        _edge(rng, data, offset, others)
    elif item.code in FLOATS:
        data[offset.at : offset.at + offset.size] = rng.choice(_FLOATS if item.code == "f" else _DOUBLES)
    else:
        known = [member.value for member in item.values.enum or ()]
        known += [round(end) for interval in item.values.intervals for end in interval]
        _put(data, offset, rng.choice(known or [0]) + rng.choice((-1, 0, 1)))


# --- counts -----------------------------------------------------------------------------------------------------------


def _wrong_count(rng: Random, data: bytearray, offset: ByteSpan, _: Sequence[Seed]) -> None:
    """A count that does not match the elements."""
    count, top = _get(data, offset), (1 << 8 * offset.size) - 1
    choices = [0, count + 1, count - 1, top, top >> 1, count << 8]
    if isinstance(offset.item, Repeat):
        choices += [offset.item.count.maximum, offset.item.count.maximum + 1, offset.item.count.minimum - 1]
    _put(data, offset, rng.choice(choices))


def _repeat(rng: Random, data: bytearray, offset: ByteSpan, _: Sequence[Seed]) -> None:
    """Repeat or remove an element, with the right count."""
    if len(offset.cuts) < 2:
        return
    number = rng.randrange(len(offset.cuts) - 1)
    start, end = offset.cuts[number : number + 2]
    by_element = isinstance(offset.item, Repeat)
    if rng.random() < 0.5:
        times = rng.choice((1, 1, 2, 7))
        _put(data, offset, _get(data, offset) + times * (1 if by_element else end - start))
        data[end:end] = data[start:end] * times
    else:
        _put(data, offset, _get(data, offset) - (1 if by_element else end - start))
        del data[start:end]


def _nest(rng: Random, data: bytearray, offset: ByteSpan, others: Sequence[Seed]) -> None:
    """Put another message, or this one, into a field of bytes, with the right count."""
    if isinstance(offset.item, Repeat) or len(offset.cuts) != 2:
        return
    inner = bytes(data) if rng.random() < 0.2 else rng.choice(others).data
    _put(data, offset, len(inner))
    data[offset.cuts[0] : offset.cuts[1]] = inner


# --- tags and presence vectors ----------------------------------------------------------------------------------------


def _retag(rng: Random, data: bytearray, offset: ByteSpan, _: Sequence[Seed]) -> None:
    known = [0]
    if isinstance(offset.item, Union):
        known = [*range(len(offset.item.arms) + 1)]
    elif isinstance(offset.item, Choice):
        known = list(offset.item.items)
    elif isinstance(offset.item, Formatted):
        known = [member.value for member in offset.item.formats.enum or ()]
    _put(data, offset, rng.choice([*known, 255]))


def _presence(rng: Random, data: bytearray, offset: ByteSpan, _: Sequence[Seed]) -> None:
    mask, top = _get(data, offset), (1 << 8 * offset.size) - 1
    choices = [0, top, mask ^ 1 << rng.randrange(8 * offset.size)]
    if isinstance(offset.item, Composite):
        choices += [top & ~offset.item.undefined, mask | offset.item.undefined]
    _put(data, offset, rng.choice(choices))


def _cut_here(rng: Random, data: bytearray, offset: ByteSpan, _: Sequence[Seed]) -> None:
    del data[offset.at + rng.randint(0, offset.size) :]


_AT_OFFSET: Final[dict[str, tuple[Mutation, ...]]] = {
    "number": (_edge, _step, _limit, _limit, _cut_here),
    "count": (_wrong_count, _wrong_count, _step, _repeat, _repeat, _nest, _cut_here),
    "tag": (_retag, _retag, _edge, _cut_here),
    "presence": (_presence, _presence, _presence, _cut_here),
}


# --- anywhere ---------------------------------------------------------------------------------------------------------


def _flip(rng: Random, data: bytearray, _: Sequence[Seed]) -> None:
    if len(data) > 2:
        data[rng.randrange(2, len(data))] ^= 1 << rng.randrange(8)


def _byte(rng: Random, data: bytearray, _: Sequence[Seed]) -> None:
    if len(data) > 2:
        data[rng.randrange(2, len(data))] = rng.choice((0, 1, 127, 128, 255, rng.randrange(256)))


def _truncate(rng: Random, data: bytearray, _: Sequence[Seed]) -> None:
    del data[rng.randint(2, len(data)) :]


def _append(rng: Random, data: bytearray, _: Sequence[Seed]) -> None:
    data += rng.randbytes(rng.choice((1, 1, 2, 4, 16)))


def _block(rng: Random, data: bytearray, _: Sequence[Seed]) -> None:
    """Remove or repeat a block."""
    start = rng.randint(2, len(data))
    end = min(len(data), start + rng.choice((1, 2, 4, 16)))
    if rng.random() < 0.5:
        del data[start:end]
    else:
        data[end:end] = data[start:end]


def _splice(rng: Random, data: bytearray, others: Sequence[Seed]) -> None:
    """The beginning of this seed and the end of another."""
    tail = rng.choice(others).data
    data[rng.randint(2, len(data)) :] = tail[rng.randint(min(2, len(tail)), len(tail)) :]


_UNSTRUCTURED: Final = (_flip, _flip, _byte, _byte, _truncate, _append, _block, _splice)


def _grow(rng: Random, data: bytearray) -> None:
    """Grow to the maximal size with zeros or a repeated part, as for lists of lists of tiny items."""
    size = rng.choice((1024, 4096, 16384, MAX_INPUT_SIZE))
    start = rng.randint(2, len(data))
    part = bytes(data[start : start + rng.choice((1, 2, 3, 8))]) or b"\0"
    pattern = rng.choice((b"\0", b"\xff", b"\1\0", part))
    data[start:start] = (pattern * size)[:size]


OffsetKind = Literal["number", "count", "tag", "presence"]


@dataclass(frozen=True, slots=True)
class ByteSpan:
    """`size` bytes at `at`.

    `cuts` are, for a count, the boundaries of the elements that it counts, both ends included; for a presence vector,
    the start and the end of the field of each bit.
    """

    kind: OffsetKind
    at: int
    size: int
    item: Item | None = None
    cuts: tuple[int, ...] = ()
    nested: bool = False


class _OutOfData(Exception):
    """Raised if the bytes end before the message."""


def offsets_of(layout: Item, data: bytes) -> tuple[ByteSpan, ...]:
    """The offsets of a message, as far as it can be read, including nested messages."""
    scanner = _Scanner(data)
    with suppress(_OutOfData):
        scanner.item(layout, 2)
    return tuple(scanner.offsets)


class _Scanner:
    def __init__(self, data: bytes) -> None:
        self.data = data
        self.offsets: list[ByteSpan] = []

    def _add(self, kind: OffsetKind, offset: int, code: str, item: Item | None = None) -> int:
        """Add the offset of a number; returns its value."""
        size = SIZES[code]
        if offset + size > len(self.data):
            raise _OutOfData
        self.offsets.append(ByteSpan(kind, offset, size, item))
        return int.from_bytes(self.data[offset : offset + size], "little")

    def item(self, item: Item, offset: int) -> int:
        """Add the offsets of an item; returns its end."""
        match item:
            case Composite():
                return self._composite(item, offset)
            case Number() | Real() | Bits():
                self._add("number", offset, item.code, item)
                return offset + SIZES[item.code]
            case Choice():
                chosen = self._add("tag", offset, "B", item)
                if chosen not in item.items:
                    raise _OutOfData
                return self.item(item.items[chosen], offset + 1)
            case Formatted():
                chosen = self._add("tag", offset, "B", item)
                return self._bytes(item.count, offset + 1, nested=chosen in item.nested_formats)
            case Text(count=None):
                return offset + item.length
            case Text():
                assert item.count is not None
                return self._bytes(item.count, offset, nested=False)
            case Blob():
                return self._bytes(item.count, offset, nested=item.nested is not None)
            case Repeat():
                return self._repeat(item, offset)
            case Union():
                tag = self._add("tag", offset, item.code, item)
                if tag >= len(item.arms):
                    raise _OutOfData
                return self._composite(list(item.arms.values())[tag], offset + SIZES[item.code])
            case Grid():
                for _ in range(math.prod(item.sizes)):
                    offset = self.item(item.item, offset)
                return offset
            case _:
                raise TypeError(item)

    def _composite(self, item: Composite, offset: int) -> int:
        mask, place, vector = 0, len(self.offsets), offset
        if item.presence:
            mask = self._add("presence", offset, item.presence, item)
            offset += SIZES[item.presence]
        cuts: list[int] = []
        for slot in item.slots:
            start = offset
            if not slot.optional or mask >> len(cuts) // 2 & 1:
                offset = self.item(slot.item, offset)
            if slot.optional:
                cuts += [start, offset]
        if item.presence:
            self.offsets[place] = ByteSpan("presence", vector, SIZES[item.presence], item, tuple(cuts))
        return offset

    def _counted(self, count: Count, offset: int, cuts: list[int], *, nested: bool = False) -> None:
        self.offsets.append(
            ByteSpan(kind="count", at=offset, size=SIZES[count.code], item=None, cuts=tuple(cuts), nested=nested)
        )

    def _bytes(self, count: Count, offset: int, *, nested: bool) -> int:
        size = self._add("count", offset, count.code)
        self.offsets.pop()
        start = offset + SIZES[count.code]
        end = min(start + size, len(self.data))
        self._counted(count, offset, [start, end], nested=nested)
        if nested:
            self._message(start, end)
        return start + size

    def _message(self, start: int, end: int) -> None:
        """The offsets of a message inside the message."""
        from jauspy.messages import registry  # noqa: PLC0415 - what messages inside messages are looked up in

        found = registry.nesting.message(self.data[start:end])
        if isinstance(found, Message):
            for offset in offsets_of(type(found).layout(), self.data[start:end]):
                cuts = tuple(cut + start for cut in offset.cuts)
                self.offsets.append(
                    ByteSpan(
                        kind=offset.kind,
                        at=offset.at + start,
                        size=offset.size,
                        item=offset.item,
                        cuts=cuts,
                        nested=offset.nested,
                    )
                )

    def _repeat(self, item: Repeat, offset: int) -> int:
        total = self._add("count", offset, item.count.code)
        place = len(self.offsets) - 1
        start = offset
        offset += SIZES[item.count.code]
        cuts = [offset]
        for _ in range(total):
            offset = self.item(item.item, offset)
            if offset > len(self.data):
                raise _OutOfData
            cuts.append(offset)
        self.offsets[place] = ByteSpan("count", start, SIZES[item.count.code], item, tuple(cuts))
        return offset
