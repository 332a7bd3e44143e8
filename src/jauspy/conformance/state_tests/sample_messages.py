"""Neutral messages: zeros where they are allowed, and no optional parts; variants of queries by presence vector."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, Final

from jauspy.codec.items import Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union
from jauspy.codec.message import Message, Struct
from jauspy.codec.wire import FLOATS, limits
from jauspy.conformance.checks import Check
from jauspy.conformance.state_tests.explorer import Stimulus, StimulusResult
from jauspy.conformance.tester import OBSERVER

PRESENCE: Final = "presence_vector"


def neutral(kind: type[Message], *, presence_bits: int = 0) -> Message:
    """The neutral message; presence vectors of queries get the value `presence_bits`, cut to their size."""
    out = bytearray(kind.CODE.to_bytes(2, "little"))
    _write(kind.layout(), out)
    message = kind.decode(bytes(out))
    for name, size in presence_fields(kind).items():
        setattr(message, name, presence_bits & limits(size)[1])
    return message


def presence_fields(kind: type[Message]) -> dict[str, str]:
    """The presence vectors of a query: their fields, and the codes of their sizes."""
    slots = getattr(kind.layout(), "slots", ())
    return {
        slot.name: slot.item.code
        for slot in slots
        if slot.name.endswith(PRESENCE) and isinstance(slot.item, Number) and not slot.optional
    }


def _write(item: Item, out: bytearray) -> None:
    """Append the neutral value of an item."""
    _WRITERS[type(item)](item, out)


def _write_composite(item: Composite, out: bytearray) -> None:
    out += _packed(item.presence, 0) if item.presence else b""
    for slot in item.slots:
        if not slot.optional:
            _write(slot.item, out)


def _write_real(item: Real, out: bytearray) -> None:
    zero = round(-item.scaling.lower * item.scaling.factor)
    out += _packed(item.code, min(max(zero, 0), item.scaling.top))


def _write_number(item: Number, out: bytearray) -> None:
    value = _float(item.values) if item.code in FLOATS else _nearest_zero(item.values, *limits(item.code))
    out += _packed(item.code, value)


def _write_bits(item: Bits, out: bytearray) -> None:
    out += _packed(item.code, sum(_nearest_zero(bit.values, 0, bit.mask) << bit.shift for bit in item.bits))


def _write_choice(item: Choice, out: bytearray) -> None:
    chosen = min(item.items)
    out.append(chosen)
    _write(item.items[chosen], out)


def _write_union(item: Union, out: bytearray) -> None:
    out += _packed(item.code, 0)
    _write(next(iter(item.arms.values())), out)


def _write_grid(item: Grid, out: bytearray) -> None:
    for _ in range(math.prod(item.sizes)):
        _write(item.item, out)


def _write_repeat(item: Repeat, out: bytearray) -> None:
    out += _packed(item.count.code, item.count.minimum)
    for _ in range(item.count.minimum):
        _write(item.item, out)


def _write_formatted(item: Formatted, out: bytearray) -> None:
    out.append(_nearest_zero(item.formats, 0, 255))
    _bytes(item.count, out)


def _write_text(item: Text, out: bytearray) -> None:
    if item.count is None:
        out += bytes(item.length)
    else:
        _bytes(item.count, out)


def _write_blob(item: Blob, out: bytearray) -> None:
    _bytes(item.count, out)


_WRITERS: Final[Mapping[type[Item], Callable[[Any, bytearray], None]]] = {
    Composite: _write_composite,
    Real: _write_real,
    Number: _write_number,
    Bits: _write_bits,
    Choice: _write_choice,
    Union: _write_union,
    Grid: _write_grid,
    Repeat: _write_repeat,
    Formatted: _write_formatted,
    Text: _write_text,
    Blob: _write_blob,
}


def _bytes(count: Count, out: bytearray) -> None:
    out += _packed(count.code, count.minimum) + bytes(count.minimum)


def _packed(code: str, value: float) -> bytes:
    return struct.pack(f"<{code}", value)


def _nearest_zero(values: Values, low: int, high: int) -> int:
    """Zero, or the allowed value nearest to it."""
    options = [int(member) for member in values.enum or ()]
    for lower, upper in values.intervals:
        options.append(max(math.ceil(lower), min(0, math.floor(upper))))
    fitting = [each for each in options if low <= each <= high]
    return min(fitting, key=abs) if fitting else max(low, 0)


def _float(values: Values) -> float:
    return min((max(lower, min(0.0, upper)) for lower, upper in values.intervals), key=abs, default=0.0)


EVERYTHING: Final = -1

Bit = tuple[str, int]
"""A presence vector of a query, and the number of a bit in it."""


def variants(kind: type[Message], report: type[Message]) -> tuple[Stimulus, ...]:
    """The query with all, no and some presence bits; empty if it has no presence vector."""
    vectors = presence_fields(kind)
    if not vectors:
        return ()
    everything = neutral(kind, presence_bits=EVERYTHING)
    nothing = neutral(kind)
    return (
        Stimulus(kind.NAME, lambda _: everything, "all fields"),
        Stimulus(kind.NAME, lambda _: nothing, "no fields", checks={report.NAME: (_carries(vectors, 0, frozenset()),)}),
        Stimulus(kind.NAME, lambda _: everything, "some fields", verify=_Parts(kind, report), once=True),
    )


class _Parts:
    """Queries half of the fields at a time, so that one of the queries distinguishes any two fields."""

    def __init__(self, kind: type[Message], report: type[Message]) -> None:
        self._kind = kind
        self._report = report

    def __call__(self, then: StimulusResult) -> None:
        if not then.outcome.outputs:
            return
        vectors, explorer = presence_fields(self._kind), then.explorer
        observer = explorer.client(OBSERVER)
        full = observer.ask(neutral(self._kind, presence_bits=EVERYTHING), self._report, to=explorer.component)
        has = frozenset(bit for bit, _, value in _fields(full, vectors) if value is not None)
        for asked in _halves(max((place for (_, place), _, _ in _fields(full, vectors)), default=0) + 1):
            query = neutral(self._kind, presence_bits=asked)
            right = _carries(vectors, asked, has)
            observer.ask(query, self._report, right, to=explorer.component)


def _halves(count: int) -> Iterator[int]:
    """Presence vectors with the bits whose number has bit 0 set, bit 1 set, and so on."""
    for place in range((count - 1).bit_length()):
        yield sum(1 << bit for bit in range(count) if bit >> place & 1)


def _carries(vectors: Iterable[str], asked: int, has: frozenset[Bit]) -> Check:
    """Check that the report has the requested optional fields that the component supports, and no others."""

    def problem(report: Message) -> str:
        wrong = [name for bit, name, value in _fields(report, vectors) if (value is not None) != _right(bit)]
        wrong += [] if asked else _inside(report, vectors)
        return f"asked for {asked:X}h it is wrong about {', '.join(dict.fromkeys(wrong))}" if wrong else ""

    def _right(bit: Bit) -> bool:
        return bit in has and bool(asked >> bit[1] & 1)

    return Check("has the requested fields and no others", problem)


def _fields(report: Message, vectors: Iterable[str]) -> Iterator[tuple[Bit, str, object]]:
    """Bit, name and value of each optional field that the presence vectors of the query select."""
    for vector in vectors:
        name = vector.removesuffix(PRESENCE).rstrip("_")
        part = report if not name and _optional(report) else _part(report, name)
        if part is not None:
            yield from (((vector, place), each, getattr(part, each)) for place, each in enumerate(_optional(part)))


def _inside(report: Message, vectors: Iterable[str]) -> list[str]:
    """All optional fields in parts of several records. Not each has a bit; without any bit, none is requested."""
    names = [each for vector in vectors if (each := vector.removesuffix(PRESENCE).rstrip("_"))]
    parts = (getattr(report, slot.name) for slot in _slots(report) if any(name in slot.name for name in names))
    several = (part for part in parts if isinstance(part, Struct) and not _optional(part))
    records = (getattr(part, slot.name) for part in several for slot in _slots(part))
    structs = (each for each in records if isinstance(each, Struct))
    return [each for record in structs for each in _optional(record) if getattr(record, each) is not None]


def _part(whole: Struct, name: str) -> Struct | None:
    """The first record with optional fields inside the part of `whole` with this name."""
    members = (getattr(whole, slot.name) for slot in _slots(whole) if name in slot.name)
    records = (each for each in members if isinstance(each, Struct))
    found = (each if _optional(each) else _part(each, name) for each in records)
    return next((each for each in found if each is not None), None)


def _optional(record: Struct) -> list[str]:
    """The optional fields in the order of their bits."""
    return [slot.name for slot in _slots(record) if slot.optional]


def _slots(record: Struct) -> tuple[Slot, ...]:
    layout = record.layout()
    return layout.slots if isinstance(layout, Composite) else ()
