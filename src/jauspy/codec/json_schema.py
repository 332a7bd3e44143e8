"""JSON Schema of messages, in the form that `to_dict` gives them."""

from __future__ import annotations

from typing import Any

from jauspy.codec.items import ANY, Bits, Blob, Choice, Formatted, Item, Number, Real, Text, Values
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Struct
from jauspy.codec.names import unit_symbol
from jauspy.codec.scalars import FLOATS

BYTES: dict[str, Any] = {"type": "object", "description": "bytes as hexadecimal text, or a message"}


def json_schema(kind: type[Struct]) -> dict[str, Any]:
    """The schema of a message class; units are in the descriptions. Values that are not finite do not fit it."""
    schema = _schema(kind.layout())
    name = getattr(kind, "NAME", kind.__name__)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": name, **schema}


def _schema(item: Item) -> dict[str, Any]:
    match item:
        case Composite():
            return {
                "type": "object",
                "properties": {slot.name: _schema(slot.item) for slot in item.slots},
                "required": [slot.name for slot in item.slots if not slot.optional],
            }
        case Repeat():
            return {"type": "array", "items": _schema(item.item)}
        case Grid():
            inner = _schema(item.item)
            for _ in item.sizes:
                inner = {"type": "array", "items": inner}
            return inner
        case Union():
            return {"type": "object", "properties": {name: _schema(arm) for name, arm in item.arms.items()}}
        case Number():
            return _number("number" if item.code in FLOATS else "integer", item.values, item.units)
        case Real():
            return _number("number", ANY, item.units)
        case Bits():
            return {"type": "object", "properties": {bit.name: _number("integer", bit.values) for bit in item.bits}}
        case Choice():
            number = {"choice": _number("integer", item.index), "value": {"type": "number"}}
            return {"type": "object", "properties": number}
        case Text():
            return {"type": "string"}
        case Formatted():
            return {"type": "object", "properties": {"format": _number("integer", item.formats), "data": BYTES}}
        case Blob():
            return BYTES
    return {}


def _number(kind: str, values: Values, units: str = "one") -> dict[str, Any]:
    """A number, or the name of a value that has one."""
    unit = {} if units == "one" else {"description": unit_symbol(units)}
    if values.enum is None:
        return {"type": kind, **unit}
    return {"anyOf": [{"type": "string", "enum": [member.name for member in values.enum]}, {"type": kind}], **unit}
