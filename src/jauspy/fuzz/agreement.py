"""Whether the values of a generated message and those of the reference codec mean the same."""

from __future__ import annotations

import math
from typing import Any

from jauspy.codec.base import Message
from jauspy.codec.items import Bits, Blob, Choice, Composite, Formatted, Grid, Item, Number, Real, Repeat, Union


def difference(item: Item, ours: Any, theirs: Any) -> str | None:
    """The path of the first value that differs, list positions left out; `None` when all agree.

    `theirs` has the form of `to_dict`, with bytes where `ours` may have a message.
    """
    match item:
        case Composite():
            return _composite(item, ours, theirs)
        case Bits():
            return None if item.to_json(ours) == theirs else ""
        case Real():
            return None if abs(ours - theirs) <= _rounding(item) else ""
        case Choice():
            if item.index.to_json(ours.choice) != theirs["choice"]:
                return "choice"
            return _inside("value", item.items[ours.choice], ours.value, theirs["value"])
        case Formatted():
            same = item.formats.to_json(ours.format) == theirs["format"]
            return None if same and _hex(ours.data) == theirs["data"]["hex"] else "data"
        case Blob():
            return None if _hex(ours) == theirs["hex"] else ""
        case Repeat():
            return _elements(item.item, ours, theirs)
        case Grid():
            inner = Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
            return _elements(inner, ours, theirs)
        case Union():
            ((name, value),) = theirs.items()
            arm = item.arms.get(name)
            return _inside(name, arm, ours, value) if arm and type(ours) is arm.cls else name
        case Number():
            return None if item.to_json(ours) == theirs else ""
        case _:
            return None if ours == theirs else ""


def _hex(data: Message | bytes) -> str:
    return (data.encode() if isinstance(data, Message) else data).hex()


def _inside(name: str, item: Item, ours: Any, theirs: Any) -> str | None:
    found = difference(item, ours, theirs)
    return None if found is None else f"{name}.{found}".rstrip(".")


def _elements(item: Item, ours: Any, theirs: Any) -> str | None:
    if len(ours) != len(theirs):
        return "length"
    found = (difference(item, mine, other) for mine, other in zip(ours, theirs, strict=True))
    return next((path for path in found if path is not None), None)


def _composite(item: Composite, ours: Any, theirs: dict[str, Any]) -> str | None:
    left = dict(theirs)
    for slot in item.slots:
        mine, other = getattr(ours, slot.name), left.pop(slot.name, None)
        if (mine is None) != (other is None):
            return slot.name
        found = None if mine is None else _inside(slot.name, slot.item, mine, other)
        if found is not None:
            return found
    spare = left.pop("reserved_presence", 0)
    if item.undefined and ours.reserved_presence != spare:
        return "reserved_presence"
    return next(iter(left), None)


def _rounding(item: Real) -> float:
    """How far two ways to compute a scaled value may be apart: a few steps of a float of the size of its limits."""
    return 8 * math.ulp(max(abs(item.scaling.lower), abs(item.scaling.upper)))
