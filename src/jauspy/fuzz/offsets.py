"""The offsets of counts, tags, presence vectors and numbers in the bytes of a message."""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import dataclass
from typing import Literal

from jauspy.codec.items import Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.wire import SIZES

OffsetKind = Literal["number", "count", "tag", "presence"]


@dataclass(frozen=True, slots=True)
class Offset:
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


def offsets_of(layout: Item, data: bytes) -> tuple[Offset, ...]:
    """The offsets of a message, as far as it can be read, including nested messages."""
    scanner = _Scanner(data)
    with suppress(_OutOfData):
        scanner.item(layout, 2)
    return tuple(scanner.offsets)


class _Scanner:
    def __init__(self, data: bytes) -> None:
        self.data = data
        self.offsets: list[Offset] = []

    def _add(self, kind: OffsetKind, at: int, code: str, item: Item | None = None) -> int:
        """Add the offset of a number; returns its value."""
        size = SIZES[code]
        if at + size > len(self.data):
            raise _OutOfData
        self.offsets.append(Offset(kind, at, size, item))
        return int.from_bytes(self.data[at : at + size], "little")

    def item(self, item: Item, at: int) -> int:
        """Add the offsets of an item; returns its end."""
        match item:
            case Composite():
                return self._composite(item, at)
            case Number() | Real() | Bits():
                self._add("number", at, item.code, item)
                return at + SIZES[item.code]
            case Choice():
                chosen = self._add("tag", at, "B", item)
                if chosen not in item.items:
                    raise _OutOfData
                return self.item(item.items[chosen], at + 1)
            case Formatted():
                chosen = self._add("tag", at, "B", item)
                return self._bytes(item.count, at + 1, nested=chosen in item.nested_formats)
            case Text(count=None):
                return at + item.length
            case Text():
                assert item.count is not None
                return self._bytes(item.count, at, nested=False)
            case Blob():
                return self._bytes(item.count, at, nested=item.nested is not None)
            case Repeat():
                return self._repeat(item, at)
            case Union():
                tag = self._add("tag", at, item.code, item)
                if tag >= len(item.arms):
                    raise _OutOfData
                return self._composite(list(item.arms.values())[tag], at + SIZES[item.code])
            case Grid():
                for _ in range(math.prod(item.sizes)):
                    at = self.item(item.item, at)
                return at
            case _:
                raise TypeError(item)

    def _composite(self, item: Composite, at: int) -> int:
        mask, place, vector = 0, len(self.offsets), at
        if item.presence:
            mask = self._add("presence", at, item.presence, item)
            at += SIZES[item.presence]
        cuts: list[int] = []
        for slot in item.slots:
            start = at
            if not slot.optional or mask >> len(cuts) // 2 & 1:
                at = self.item(slot.item, at)
            if slot.optional:
                cuts += [start, at]
        if item.presence:
            self.offsets[place] = Offset("presence", vector, SIZES[item.presence], item, tuple(cuts))
        return at

    def _counted(self, count: Count, at: int, cuts: list[int], *, nested: bool = False) -> None:
        self.offsets.append(Offset("count", at, SIZES[count.code], None, tuple(cuts), nested))

    def _bytes(self, count: Count, at: int, *, nested: bool) -> int:
        size = self._add("count", at, count.code)
        self.offsets.pop()
        start = at + SIZES[count.code]
        end = min(start + size, len(self.data))
        self._counted(count, at, [start, end], nested=nested)
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
                    Offset(offset.kind, offset.at + start, offset.size, offset.item, cuts, offset.nested)
                )

    def _repeat(self, item: Repeat, at: int) -> int:
        total = self._add("count", at, item.count.code)
        place = len(self.offsets) - 1
        start = at
        at += SIZES[item.count.code]
        cuts = [at]
        for _ in range(total):
            at = self.item(item.item, at)
            if at > len(self.data):
                raise _OutOfData
            cuts.append(at)
        self.offsets[place] = Offset("count", start, SIZES[item.count.code], item, tuple(cuts))
        return at
