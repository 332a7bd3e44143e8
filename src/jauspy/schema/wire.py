"""What of a definition matters on the wire: everything but names, units, prose and where it was declared."""

from __future__ import annotations

from typing import TypeAlias

from jauspy.schema.model import (
    Array,
    BitField,
    Composite,
    FixedField,
    FixedString,
    List,
    Node,
    Record,
    Sequence,
    SubField,
    TypeChoice,
    ValueSet,
    VariableField,
    VariableFormatField,
    VariableLengthField,
    VariableString,
    Variant,
)

Shape: TypeAlias = tuple[object, ...]
"""Equal for what has the same bytes with the same meaning; otherwise of no use."""


def same_wire(one: Composite | None, other: Composite | None) -> bool:
    """True when two message bodies have the same bytes for the same numbers, within the same limits."""
    return shape(one) == shape(other)


def shape(node: Node | None) -> Shape:
    """The wire shape of a field, a composite or a body."""
    match node:
        case None:
            return ()
        case FixedField():
            return ("number", *_number(node))
        case BitField():
            return ("bits", node.type, tuple(sorted(map(_bits, node.subfields))))
        case VariableField():
            return ("choice", tuple(sorted((choice.index, *map(repr, _number(choice))) for choice in node.choices)))
        case FixedString():
            return ("text", node.length)
        case VariableString():
            return ("text", node.count)
        case VariableLengthField():
            return ("bytes", node.format.lower(), node.count)
        case VariableFormatField():
            return ("format", tuple(sorted((f.index, f.name.lower()) for f in node.formats)), node.count)
        case Array():
            return ("array", shape(node.element), tuple(dimension.size for dimension in node.dimensions))
        case Record(fields=members) | Sequence(items=members):
            return _container(node.presence, members)
        case List():
            return ("list", node.count, shape(node.element))
        case Variant():
            return ("variant", node.tag.type, tuple(map(shape, node.arms)))
    raise TypeError(node)


def _container(presence: str | None, members: tuple[Node, ...]) -> Shape:
    """A record or a sequence: on the wire they are the same."""
    parts = tuple((member.optional, shape(member)) for member in members)
    return ("one after the other", presence, parts)


def _number(field: FixedField | TypeChoice) -> Shape:
    return field.type, field.scale, value_shape(field.values)


def _bits(part: SubField) -> tuple[int, int, str]:
    return part.first, part.last, repr(value_shape(part.values))


def value_shape(values: ValueSet | None) -> Shape:
    """The allowed values; a name for a value that a range allows anyway changes nothing."""
    if values is None:
        return ()
    ranges = tuple(sorted((r.lower, r.upper, r.lower_inclusive, r.upper_inclusive) for r in values.ranges))
    single = {enum.value for enum in values.enums if not any(low <= enum.value <= high for low, high, _, _ in ranges)}
    return tuple(sorted(single)), ranges
