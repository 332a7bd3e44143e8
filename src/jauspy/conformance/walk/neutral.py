"""The most harmless message of a kind: zero where zero is allowed, nothing where nothing is."""

from __future__ import annotations

import math
import struct
from typing import Final

from jauspy.codec.base import Message
from jauspy.codec.items import (
    Bits,
    Blob,
    Choice,
    Composite,
    Count,
    Formatted,
    Grid,
    Item,
    Number,
    Real,
    Repeat,
    Text,
    Union,
    Values,
)
from jauspy.codec.wire import FLOATS, limits

PRESENCE: Final = "presence_vector"


def neutral(kind: type[Message], *, asks_for: int = 0) -> Message:
    """The message; what queries call a presence vector is `asks_for`, cut to its size."""
    out = bytearray(kind.CODE.to_bytes(2, "little"))
    _write(kind.layout(), out)
    message = kind.decode(bytes(out))
    for name, size in presence_fields(kind).items():
        setattr(message, name, asks_for & limits(size)[1])
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
    match item:
        case Composite():
            out += _packed(item.presence, 0) if item.presence else b""
            for slot in item.slots:
                if not slot.optional:
                    _write(slot.item, out)
        case Real():
            zero = round(-item.scaling.lower * item.scaling.factor)
            out += _packed(item.code, min(max(zero, 0), item.scaling.top))
        case Number():
            value = _nearest_zero(item.values, *limits(item.code)) if item.code not in FLOATS else _float(item.values)
            out += _packed(item.code, value)
        case Bits():
            raw = sum(_nearest_zero(bit.values, 0, bit.mask) << bit.shift for bit in item.bits)
            out += _packed(item.code, raw)
        case Choice():
            chosen = min(item.items)
            out.append(chosen)
            _write(item.items[chosen], out)
        case Union():
            out += _packed(item.code, 0)
            _write(next(iter(item.arms.values())), out)
        case Grid():
            for _ in range(math.prod(item.sizes)):
                _write(item.item, out)
        case Repeat():
            out += _packed(item.count.code, item.count.minimum)
            for _ in range(item.count.minimum):
                _write(item.item, out)
        case Formatted():
            out.append(_nearest_zero(item.formats, 0, 255))
            _bytes(item.count, out)
        case Text() if item.count is None:
            out += bytes(item.length)
        case Text() | Blob():
            assert item.count is not None
            _bytes(item.count, out)
        case _:
            raise TypeError(item)


def _bytes(count: Count, out: bytearray) -> None:
    out += _packed(count.code, count.minimum) + bytes(count.minimum)


def _packed(code: str, value: float) -> bytes:
    return struct.pack(f"<{code}", value)


def _nearest_zero(values: Values, low: int, high: int) -> int:
    """Zero, or the allowed value that is nearest to it."""
    options = [int(member) for member in values.enum or ()]
    for lower, upper in values.intervals:
        options.append(max(math.ceil(lower), min(0, math.floor(upper))))
    fitting = [each for each in options if low <= each <= high]
    return min(fitting, key=abs) if fitting else max(low, 0)


def _float(values: Values) -> float:
    return min((max(lower, min(0.0, upper)) for lower, upper in values.intervals), key=abs, default=0.0)
