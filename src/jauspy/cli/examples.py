"""Examples of messages as a person types them: required fields with values in range, nested ones as YAML."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import yaml

from jauspy.cli.fields import message_from
from jauspy.codec.items import Bits, Blob, Choice, Formatted, Item, Number, Real, Text, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.registry import Hints, Registry
from jauspy.errors import ConfigError

SAMPLES: Final = (0.5, 0.05, 0.0, 1.0)
"""Numbers of which the first that is in range is taken."""
WIDTH: Final = 100_000
"""Columns of YAML, so that it is one line."""


def example(registry: Registry, kind: type[Message], target: str = "ID") -> list[str]:
    """The words of a command that sends or queries such a message; empty if no example of it can be encoded."""
    layout = kind.layout()
    if not isinstance(layout, Composite):
        return []
    fields = [f"{name}={_text(value)}" for name, value in _fields(layout).items() if name != "presence_vector"]
    try:
        message_from(registry, kind.NAME, fields, Hints(kind.SERVICE, kind.VERSION))
    except ConfigError:
        return []
    verb = "query" if kind.IS_QUERY else "send"
    return ["jauspy", verb, target, kind.NAME, *fields]


def _text(value: Any) -> str:
    if isinstance(value, dict | list):
        return yaml.safe_dump(value, default_flow_style=True, width=WIDTH, sort_keys=False).strip()
    return str(value)


def _fields(layout: Composite) -> dict[str, Any]:
    """Required fields, or the first optional one when there is none."""
    required = [slot for slot in layout.slots if not slot.optional]
    return {slot.name: _value(slot.item) for slot in required or layout.slots[:1]}


def _value(item: Item) -> Any:
    match item:
        case Composite():
            return _fields(item)
        case Repeat():
            return [_value(item.item)] * max(1, item.count.minimum)
        case Grid():
            return _grid(item.sizes, _value(item.item))
        case Union():
            name, arm = next(iter(item.arms.items()))
            return {name: _fields(arm)}
        case Choice():
            index, number = next(iter(item.items.items()))
            return {"choice": _named(item.index, index), "value": _value(number)}
        case Bits():
            return {bit.name: _number(bit.values) for bit in item.bits}
        case Formatted():
            nested = next(iter(sorted(item.nested_formats)), None)
            if nested is not None:
                return {"format": _named(item.formats, nested), "data": {"message": "QueryStatus"}}
            return {"format": _number(item.formats), "data": {"hex": "00"}}
        case Blob():
            return {"message": "QueryStatus"} if item.nested else {"hex": "00" * max(1, item.count.minimum)}
        case Text():
            return "name"[: item.length or None]
        case Real():
            low, high = item.scaling.lower, item.scaling.upper
            return next((each for each in SAMPLES if low <= each <= high), low)
        case Number():
            return _number(item.values)
    raise AssertionError(item)


def _grid(sizes: Sequence[int], value: Any) -> Any:
    return [_grid(sizes[1:], value) for _ in range(sizes[0])] if sizes else value


def _number(values: Values) -> Any:
    if values.enum:
        return next(iter(values.enum)).name
    return next((int(low) for low, _ in values.intervals), 1)


def _named(values: Values, number: int) -> Any:
    return next((each.name for each in values.enum or () if each == number), number)
