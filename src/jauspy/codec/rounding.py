"""Numbers with the fewest digits that are encoded as the same bytes, such as 0.0 for 2.3283064365386963e-05."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import Any, Final, TypeAlias, TypeVar
from weakref import WeakKeyDictionary

from jauspy.codec.items import Blob, Choice, Formatted, Item, Number, Real, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.scalars import FLOATS, Scaling, exact_raw

SAFE_PART: Final = 0.49
"""Part of a step by which a number may differ from the decoded one; half a step is the limit."""
EXTRA_DIGITS: Final = 3
"""Decimals beyond those of the step that are tried; two are enough for a number that is rounded to the nearest step."""
SINGLE_DIGITS: Final = 9
"""Significant digits that identify a float of 32 bits."""

GREATEST_SINGLE: Final = float.fromhex("0x1.fffffep127")
"""The greatest float of 32 bits; with fewer digits, numbers near it would be greater (IEEE 754)."""

M = TypeVar("M", bound=Message)

Rounder: TypeAlias = Callable[[Any], Any]
"""Function that rounds a value of one item."""

_rounders: WeakKeyDictionary[type[Message], Rounder] = WeakKeyDictionary()
"""Rounders of message classes, made at the first use of each."""


_converters: WeakKeyDictionary[type[Message], Rounder] = WeakKeyDictionary()
"""Functions of message classes for `rounded_dict`, made at the first use of each."""


def rounded(message: M) -> M:
    """A copy of a decoded message with the fewest digits in each number that are encoded as the same bytes.

    The message itself if no number gets shorter.
    """
    kind = type(message)
    rounder = _rounders.get(kind)
    if rounder is None:
        rounder = _rounders[kind] = _composite(kind.layout())
    found: M = rounder(message)
    return found


def rounded_dict(message: Message) -> dict[str, Any]:
    """The same as `rounded(message).to_dict()`, in half the time: no message is made."""
    kind = type(message)
    convert = _converters.get(kind)
    if convert is None:
        convert = _converters[kind] = _composite_converter(kind.layout())
    found: dict[str, Any] = convert(message)
    return found


def shortest(value: float, scaling: Scaling) -> float:
    """The number with the fewest decimals that is encoded as the same raw value; outside of the range, the value."""
    found: float = _real(scaling)(value)
    return found


@lru_cache(maxsize=1024)
def _real(scaling: Scaling) -> Rounder:
    """Round reals of one scaling: the first number of decimals that leaves the raw value as it is."""
    lower, upper, factor, step, top = scaling.lower, scaling.upper, scaling.factor, scaling.step, scaling.top
    first = math.floor(math.log10(factor))
    margin = SAFE_PART * step
    floor = math.floor
    if scaling.function != "round" or first < 0 or scaling.is_finer_than_floats:
        return lambda value: _with_decimals(value, scaling, first)
    scales = [10.0**decimals for decimals in range(first, first + EXTRA_DIGITS)]

    def rounder(value: float) -> float:
        if not lower <= value <= upper:
            return value
        raw = floor((value - lower) * factor + 0.5)
        centre = upper if raw >= top else lower + raw * step
        least, most = centre - margin, centre + margin
        for scale in scales:  # a whole number by a power of ten is the double that is nearest to the decimal
            number = floor(value * scale + 0.5) / scale
            if least <= number <= most and number and lower <= number <= upper:
                return number
            if not number and exact_raw(0.0, scaling) == exact_raw(value, scaling):
                return 0.0  # halfway between two steps of a symmetric range, so beyond the margin
        return value

    return rounder


def _with_decimals(value: float, scaling: Scaling, first: int) -> float:
    if not scaling.contains(value):
        return value
    for decimals in range(first, first + EXTRA_DIGITS):
        number = round(value, decimals) + 0.0  # no negative zero
        if scaling.contains(number) and exact_raw(number, scaling) == exact_raw(value, scaling):
            return number
    return value


def _single(values: Values) -> Rounder:
    """Round floats of 32 bits to the shortest number that is the same one; other values are returned as they are."""

    def rounder(value: Any) -> Any:
        if not isinstance(value, float) or not math.isfinite(value):
            return value
        packed = struct.pack("<f", value)
        for digits in range(1, SINGLE_DIGITS):
            number = float(f"{value:.{digits}g}")
            if abs(number) <= GREATEST_SINGLE and struct.pack("<f", number) == packed:
                # at a limit such as 2 pi, the shortest number can be beyond it by less than the float tells
                return number if values.allows(number) or not values.allows(value) else value
        return value

    return rounder


def _rounder(item: Item) -> Rounder | None:
    """The rounder of an item; None if it has no number with more digits than it needs."""
    if isinstance(item, Real):
        return _real(item.scaling)
    if isinstance(item, Number):
        return _single(item.values) if item.code == "f" else None
    make = _CONTAINERS.get(type(item))
    return None if make is None else make(item)


def _composite(item: Any) -> Rounder:
    rounders = [(slot.name, found) for slot in item.slots if (found := _rounder(slot.item)) is not None]

    def rounder(record: Any) -> Any:
        changed = {}
        for name, function in rounders:
            value = getattr(record, name)
            if value is not None and (new := function(value)) is not value:
                changed[name] = new
        return replace(record, **changed) if changed else record

    return rounder


def _list(item: Any) -> Rounder | None:
    function = _rounder(item.item)
    return None if function is None else lambda parts: [function(part) for part in parts]


def _grid(item: Any) -> Rounder | None:
    inner = Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
    function = _rounder(inner)
    return None if function is None else lambda parts: [function(part) for part in parts]


def _union(item: Any) -> Rounder:
    arms = {arm.cls: _composite(arm) for arm in item.arms.values()}

    def rounder(value: Any) -> Any:
        function = arms.get(type(value))
        return value if function is None else function(value)

    return rounder


def _choice(item: Any) -> Rounder:
    rounders = {choice: _rounder(chosen) for choice, chosen in item.items.items()}

    def rounder(choice: Any) -> Any:
        function = rounders.get(choice.choice)
        if function is None or (new := function(choice.value)) is choice.value:
            return choice
        return replace(choice, value=new)

    return rounder


def _blob(_: Any) -> Rounder:
    return lambda value: rounded(value) if isinstance(value, Message) else value


def _formatted(_: Any) -> Rounder:
    return lambda value: replace(value, data=rounded(value.data)) if isinstance(value.data, Message) else value


def _converter(item: Item) -> Rounder:
    """The function that rounds a value of an item and converts it to its JSON form."""
    if isinstance(item, Real):
        return _real(item.scaling)
    if isinstance(item, Composite):
        return _composite_converter(item)
    if isinstance(item, Repeat):
        convert = _converter(item.item)
        return lambda parts: [convert(part) for part in parts]
    if isinstance(item, Choice):
        return _choice_converter(item)
    if isinstance(item, Number) and item.code not in FLOATS:
        names = {member.value: member.name for member in item.values.enum or ()}
        return lambda value: names.get(value, value)
    rounder, to_json = _rounder(item), item.to_json
    return to_json if rounder is None else lambda value: to_json(rounder(value))


def _choice_converter(item: Choice) -> Rounder:
    converters = {choice: _converter(chosen) for choice, chosen in item.items.items()}
    to_json, name_of = item.to_json, item.index.to_json

    def convert(choice: Any) -> Any:
        function = converters.get(choice.choice)
        if function is None:
            return to_json(choice)
        return {"choice": name_of(choice.choice), "value": function(choice.value)}

    return convert


def _composite_converter(item: Any) -> Rounder:
    converters = [(slot.name, _converter(slot.item)) for slot in item.slots]

    def convert(record: Any) -> dict[str, Any]:
        data = {}
        for name, function in converters:
            value = getattr(record, name)
            if value is not None:
                data[name] = function(value)
        return data

    if not item.undefined:
        return convert

    def convert_with_reserved(record: Any) -> dict[str, Any]:
        data = convert(record)
        if record.reserved_presence:
            data["reserved_presence"] = record.reserved_presence
        return data

    return convert_with_reserved


_CONTAINERS: Final[dict[type[Item], Callable[[Any], Rounder | None]]] = {
    Composite: _composite,
    Repeat: _list,
    Grid: _grid,
    Union: _union,
    Choice: _choice,
    Blob: _blob,
    Formatted: _formatted,
}
