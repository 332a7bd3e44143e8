"""Numbers with the fewest digits that are encoded as the same bytes, such as 0.0 for 2.3283064365386963e-05."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from dataclasses import replace
from typing import Any, Final, TypeVar

from jauspy.codec.items import Blob, Choice, Formatted, Item, Number, Real
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.scalars import Scaling, exact_raw

SAFE_PART: Final = 0.49
"""Part of a step by which a number may differ from the decoded one; half a step is the limit."""
EXTRA_DIGITS: Final = 3
"""Decimals beyond those of the step that are tried; two are enough for a number that is rounded to the nearest step."""
SINGLE_DIGITS: Final = 9
"""Significant digits that identify a float of 32 bits."""

M = TypeVar("M", bound=Message)


def rounded(message: M) -> M:
    """A copy of a decoded message with the fewest digits in each number that are encoded as the same bytes."""
    found: M = _composite(message.layout(), message)
    return found


def shortest(value: float, scaling: Scaling) -> float:
    """The number with the fewest decimals that is encoded as the same raw value; outside of the range, the value."""
    if not scaling.contains(value):
        return value
    first = math.floor(math.log10(scaling.factor))
    for decimals in range(first, first + EXTRA_DIGITS):
        number = round(value, decimals) + 0.0  # no negative zero
        if scaling.contains(number) and _same_raw(number, value, scaling):
            return number
    return value


def _same_raw(number: float, value: float, scaling: Scaling) -> bool:
    if scaling.function == "round" and number:  # zero is halfway between two steps of a symmetric range
        centre = scaling.real(min(scaling.top, math.floor((value - scaling.lower) * scaling.factor + 0.5)))
        return abs(number - centre) <= SAFE_PART * scaling.step
    return exact_raw(number, scaling) == exact_raw(value, scaling)


def _single(value: float) -> float:
    """The shortest number that is the same float of 32 bits."""
    if not math.isfinite(value):
        return value
    packed = struct.pack("<f", value)
    for digits in range(1, SINGLE_DIGITS):
        number = float(f"{value:.{digits}g}")
        if struct.pack("<f", number) == packed:
            return number
    return value


def _rounded(item: Item, value: Any) -> Any:
    if isinstance(item, Real):
        return shortest(value, item.scaling)
    if isinstance(item, Number):
        return _single(value) if item.code == "f" and isinstance(value, float) else value
    make = _CONTAINERS.get(type(item))
    return make(item, value) if make else value


def _composite(item: Any, value: Any) -> Any:
    parts = {slot.name: getattr(value, slot.name) for slot in item.slots}
    changed = {slot.name: _rounded(slot.item, parts[slot.name]) for slot in item.slots if parts[slot.name] is not None}
    return replace(value, **changed)


def _list(item: Any, value: Any) -> Any:
    return [_rounded(item.item, part) for part in value]


def _grid(item: Any, value: Any) -> Any:
    inner = Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
    return [_rounded(inner, part) for part in value]


def _union(item: Any, value: Any) -> Any:
    arm = next((arm for arm in item.arms.values() if arm.cls is type(value)), None)
    return value if arm is None else _composite(arm, value)


def _choice(item: Any, value: Any) -> Any:
    chosen = item.items.get(value.choice)
    return value if chosen is None else replace(value, value=_rounded(chosen, value.value))


def _blob(_: Any, value: Any) -> Any:
    return rounded(value) if isinstance(value, Message) else value


def _formatted(_: Any, value: Any) -> Any:
    return replace(value, data=rounded(value.data)) if isinstance(value.data, Message) else value


_CONTAINERS: Final[dict[type[Item], Callable[[Any, Any], Any]]] = {
    Composite: _composite,
    Repeat: _list,
    Grid: _grid,
    Union: _union,
    Choice: _choice,
    Blob: _blob,
    Formatted: _formatted,
}
