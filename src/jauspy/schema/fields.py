"""Fields: what a record is made of."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from lxml.etree import _Element as Element

from jauspy.schema.document import bounded, child, flag, prose, required, wrong
from jauspy.schema.library import Scope
from jauspy.schema.model import (
    Array,
    BitField,
    Dimension,
    Field,
    FixedField,
    FixedString,
    Format,
    SimpleField,
    SubField,
    TypeChoice,
    VariableField,
    VariableFormatField,
    VariableLengthField,
    VariableString,
)
from jauspy.schema.sizes import sizes
from jauspy.schema.values import BITS, read_count, read_scale, read_values, scalar, unsigned

LARGEST: Final = 1 << 20
"""Bytes of a string or array of fixed size: each message has them all, and must be taken apart in memory."""


def read_field(element: Element, scope: Scope) -> Field:
    """A field of a record, written out or declared."""
    if element.tag == "array":
        return _array(element, scope)
    if element.tag == "declared_array":
        return scope.declared(element, read_field)
    return read_simple(element, scope)


def read_simple(element: Element, scope: Scope) -> SimpleField:
    """A field that is no array, written out or declared."""
    reader = _READERS.get(element.tag)
    return scope.declared(element, read_simple) if reader is None else reader(element, scope)


def _fixed_field(element: Element, scope: Scope) -> FixedField:
    return FixedField(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        type=scalar(element),
        units=required(element, "field_units"),
        scale=read_scale(element, scope),
        values=read_values(element, scope),
    )


def _bit_field(element: Element, scope: Scope) -> BitField:
    kind = unsigned(element)
    return BitField(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        type=kind,
        subfields=tuple(_sub_field(part, BITS[kind], scope) for part in element.iterchildren("sub_field")),
    )


def _sub_field(element: Element, bits: int, scope: Scope) -> SubField:
    bit_range = child(element, "bit_range")
    first = bounded(bit_range, "from_index", 0, bits - 1)
    last = bounded(bit_range, "to_index", first, bits - 1)
    return SubField(required(element, "name"), first, last, read_values(element, scope), prose(element))


def _variable_field(element: Element, scope: Scope) -> VariableField:
    choices = tuple(_type_choice(part, scope) for part in child(element, "type_and_units_field"))
    return VariableField(
        name=required(element, "name"), optional=flag(element, "optional"), doc=prose(element), choices=choices
    )


def _type_choice(element: Element, scope: Scope) -> TypeChoice:
    return TypeChoice(
        index=bounded(element, "index", 0, 255),
        type=scalar(element),
        units=required(element, "field_units"),
        scale=read_scale(element, scope),
        values=read_values(element, scope),
        name=element.get("name", ""),
        doc=prose(element),
    )


def _fixed_string(element: Element, scope: Scope) -> FixedString:
    length = scope.integer(element, "string_length")
    if not 1 <= length <= LARGEST:
        raise wrong(element, f"string_length: expected 1 to {LARGEST}, got {length}")
    return FixedString(
        name=required(element, "name"), optional=flag(element, "optional"), doc=prose(element), length=length
    )


def _variable_string(element: Element, scope: Scope) -> VariableString:
    return VariableString(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        count=read_count(child(element, "count_field"), scope),
    )


def _variable_length_field(element: Element, scope: Scope) -> VariableLengthField:
    return VariableLengthField(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        format=required(element, "field_format"),
        count=read_count(child(element, "count_field"), scope),
    )


def _variable_format_field(element: Element, scope: Scope) -> VariableFormatField:
    formats = child(element, "format_field")
    return VariableFormatField(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        formats=tuple(Format(bounded(part, "index", 0, 255), required(part, "field_format")) for part in formats),
        count=read_count(child(element, "count_field"), scope),
    )


def _array(element: Element, scope: Scope) -> Array:
    array = Array(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        element=read_simple(element[0], scope),
        dimensions=tuple(_dimension(part, scope) for part in element.iterchildren("dimension")),
    )
    size, _ = sizes(array)
    if size > LARGEST:
        raise wrong(element, f"array '{array.name}' takes {size} bytes; {LARGEST} are the most")
    return array


def _dimension(element: Element, scope: Scope) -> Dimension:
    size = scope.integer(element, "size")
    if size < 1:
        raise wrong(element, f"size: expected at least 1, got {size}")
    return Dimension(required(element, "name"), size)


_READERS: Mapping[str, Callable[[Element, Scope], SimpleField]] = {
    "fixed_field": _fixed_field,
    "bit_field": _bit_field,
    "variable_field": _variable_field,
    "fixed_length_string": _fixed_string,
    "variable_length_string": _variable_string,
    "variable_length_field": _variable_length_field,
    "variable_format_field": _variable_format_field,
}
