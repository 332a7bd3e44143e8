"""The same messages for construct, compiled, as one would write them by its documentation; value sets unchecked."""

from __future__ import annotations

from typing import Any

from construct import (
    Array,
    BitsInteger,
    BitStruct,
    Bytes,
    ByteSwapped,
    Const,
    Construct,
    Enum,
    ExprAdapter,
    FormatField,
    If,
    Int16ul,
    PaddedString,
    PascalString,
    Pass,
    Struct,
    Switch,
    obj_,
    this,
)

from jauspy.codec.names import attributes, members
from jauspy.codec.scalars import CODES, SIZES, limits
from jauspy.schema import model as m

FORMATS = {"u32": "L", "i32": "l"}


class Trees:
    """Makes constructs; with `values` they give real numbers, names, strings and bits instead of raw numbers."""

    def __init__(self, *, values: bool) -> None:
        self.values = values

    def tree(self, node: m.Node) -> Construct:
        """A field or composite."""
        match node:
            case m.Record():
                return self.parts(node.fields, node.presence)
            case m.Sequence():
                return self.parts(node.items, node.presence)
            case m.List():
                return Struct("count" / number(node.count.type), "items" / Array(this.count, self.tree(node.element)))
            case m.Variant():
                arms = {tag: self.tree(arm) for tag, arm in enumerate(node.arms)}
                return Struct("tag" / number(node.tag.type), "arm" / Switch(this.tag, arms))
            case m.FixedField():
                return self.value(node.type, node.scale, node.values)
            case m.BitField():
                return self.bits(node)
            case m.VariableField():
                kinds = {choice.index: self.value(choice.type, choice.scale, choice.values) for choice in node.choices}
                return Struct("index" / number("u8"), "number" / Switch(this.index, kinds))
            case m.FixedString():
                return PaddedString(node.length, "ascii") if self.values else Bytes(node.length)
            case m.VariableString() if self.values:
                return PascalString(number(node.count.type), "ascii")
            case m.VariableString() | m.VariableLengthField():
                return Struct("count" / number(node.count.type), "bytes" / Bytes(this.count))
            case m.VariableFormatField():
                return Struct("format" / number("u8"), "count" / number(node.count.type), "bytes" / Bytes(this.count))
            case m.Array():
                made = self.tree(node.element)
                for dimension in reversed(node.dimensions):
                    made = Array(dimension.size, made)
                return made
            case _:
                raise TypeError(type(node).__name__)

    def value(self, kind: m.Scalar, scale: m.Scale | None, values: m.ValueSet | None) -> Construct:
        """A number."""
        raw = number(kind)
        if self.values and scale is not None:
            step = (scale.upper - scale.lower) / limits(CODES[kind])[1]
            return ExprAdapter(raw, obj_ * step + scale.lower, lambda obj, _: round((obj - scale.lower) / step))
        if self.values and values is not None and values.enums:
            return Enum(raw, **members((named.value, named.name) for named in values.enums))
        return raw

    def bits(self, node: m.BitField) -> Construct:
        """A bit field, the highest bits first."""
        if not self.values:
            return number(node.type)
        parts: list[Any] = []
        top = 8 * SIZES[CODES[node.type]]
        names = attributes(sub.name for sub in node.subfields)
        for name, sub in sorted(zip(names, node.subfields, strict=True), key=lambda pair: -pair[1].first):
            if top > sub.last + 1:
                parts.append(f"spare{top}" / BitsInteger(top - sub.last - 1))
            parts.append(f"f_{name}" / BitsInteger(sub.last - sub.first + 1))
            top = sub.first
        return ByteSwapped(BitStruct(*parts, *(["spare0" / BitsInteger(top)] if top else [])))

    def parts(self, nodes: tuple[m.Node, ...], presence: m.Unsigned | None) -> Construct:
        """Fields or composites one after the other."""
        subcons: list[Any] = ["presence" / number(presence)] if presence else []
        bit = 1
        for name, node in zip(attributes(node.name for node in nodes), nodes, strict=True):
            made = self.tree(node)
            if presence and node.optional:
                made, bit = If(this.presence & bit, made), bit << 1
            subcons.append(f"f_{name}" / made)
        return Struct(*subcons)


def compiled(message: m.MessageDefinition, *, values: bool) -> Construct:
    """The compiled construct of a message."""
    body = Pass if message.body is None else Trees(values=values).tree(message.body)
    return Struct("id" / Const(message.code, Int16ul), "body" / body).compile()


def number(kind: m.Scalar) -> Construct:
    """A raw number."""
    return FormatField("<", FORMATS.get(kind, CODES[kind]))
