"""Neutral messages: zeros where they are allowed, and no optional parts."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Mapping
from typing import Any, Final

from jauspy.codec.items import Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.scalars import FLOATS, limits

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
    fitting = [option for option in options if low <= option <= high]
    return min(fitting, key=abs) if fitting else max(low, 0)


def _float(values: Values) -> float:
    return min((max(lower, min(0.0, upper)) for lower, upper in values.intervals), key=abs, default=0.0)
