"""The wire form of definitions, independent of names: equality, digests, and sizes in bytes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from hashlib import sha256
from typing import TypeAlias

from jauspy.schema.model import (
    Array,
    BitField,
    Composite,
    Count,
    FixedField,
    FixedString,
    List,
    Node,
    Record,
    Scalar,
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
"""A value that is equal for definitions with the same bytes and meaning."""


def same_wire(one: Composite | None, other: Composite | None) -> bool:
    """True when two message bodies have the same bytes for the same numbers, within the same limits."""
    return shape(one) == shape(other)


def digest(body: Composite | None) -> str:
    """Eight hexadecimal digits of a message body's shape: equal for what `same_wire` finds equal."""
    return sha256(repr(shape(body)).encode()).hexdigest()[:8]


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
    scale = field.scale and (_exact(field.scale.lower), _exact(field.scale.upper), field.scale.function)
    return field.type, scale, value_shape(field.values)


def _exact(number: float) -> float:
    """One form for a number that may be written as 1 or 1.0."""
    return int(number) if math.isfinite(number) and number == int(number) else number


def _bits(part: SubField) -> tuple[int, int, str]:
    return part.first, part.last, repr(value_shape(part.values))


def value_shape(values: ValueSet | None) -> Shape:
    """The allowed values; a name for a value inside an allowed range has no effect."""
    if values is None:
        return ()
    ranges = tuple(
        sorted((_exact(r.lower), _exact(r.upper), r.lower_inclusive, r.upper_inclusive) for r in values.ranges)
    )
    single = {enum.value for enum in values.enums if not any(low <= enum.value <= high for low, high, _, _ in ranges)}
    return tuple(sorted(single)), ranges


Sizes = tuple[int, int]
"""Minimal and maximal number of bytes."""


def scalar_size(kind: Scalar) -> int:
    """Bytes of a number."""
    return int(kind[1:]) // 8


def sizes(node: Node | None) -> Sizes:
    """Minimal and maximal size of a field, a composite or a body in bytes, without its presence bit."""
    match node:
        case None:
            return 0, 0
        case FixedField() | BitField():
            return (scalar_size(node.type),) * 2
        case VariableField():
            found = [scalar_size(choice.type) for choice in node.choices]
            return 1 + min(found), 1 + max(found)
        case FixedString():
            return node.length, node.length
        case VariableString() | VariableLengthField():
            return _counted(node.count, (1, 1))
        case VariableFormatField():
            low, high = _counted(node.count, (1, 1))
            return 1 + low, 1 + high
        case Array():
            number = math.prod(dimension.size for dimension in node.dimensions)
            low, high = sizes(node.element)
            return low * number, high * number
        case Record(fields=members) | Sequence(items=members):
            return _container_sizes(node.presence, members)
        case List():
            return _counted(node.count, sizes(node.element))
        case Variant():
            arms = [sizes(arm) for arm in node.arms] or [(0, 0)]
            tag = scalar_size(node.tag.type)
            return tag + min(low for low, _ in arms), tag + max(high for _, high in arms)
    raise TypeError(node)


def _counted(count: Count, item: Sizes) -> Sizes:
    width = scalar_size(count.type)
    return width + count.minimum * item[0], width + count.maximum * item[1]


def _container_sizes(presence: Scalar | None, members: tuple[Node, ...]) -> Sizes:
    vector = scalar_size(presence) if presence else 0
    presences = zip(members, can_be_there(presence, members), strict=True)
    found = [(member.optional, *sizes(member)) for member, possible in presences if possible]
    low = sum(low for optional, low, _ in found if not optional)
    return vector + low, vector + sum(high for _, _, high in found)


def can_be_there(presence: Scalar | None, members: Iterable[Node]) -> Iterator[bool]:
    """List for each member of a container whether it can be present: false if the presence vector has no bit for it."""
    bits = 8 * scalar_size(presence) if presence else 0
    for member in members:
        counts = member.optional and presence is not None
        yield bits > 0 or not counts
        bits -= counts
