"""Readers of fields, value sets and composites (records, lists, variants, sequences)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Final, Literal

from lxml.etree import _Element as Element

from jauspy.schema.digest import sizes
from jauspy.schema.document import DECLARED, bounded, child, choice, flag, prose, required, whole_number, wrong
from jauspy.schema.library import NameScope, bounded_node
from jauspy.schema.model import (
    Array,
    BitField,
    Composite,
    Count,
    Dimension,
    Field,
    FixedField,
    FixedString,
    Format,
    List,
    Node,
    Record,
    Scalar,
    Scale,
    Sequence,
    SimpleField,
    SubField,
    TypeChoice,
    Unsigned,
    ValueEnum,
    ValueRange,
    ValueSet,
    VariableField,
    VariableFormatField,
    VariableLengthField,
    VariableString,
    Variant,
)

UNSIGNED: Mapping[str, Unsigned] = {
    "unsigned byte": "u8",
    "unsigned short integer": "u16",
    "unsigned integer": "u32",
    "unsigned long integer": "u64",
}
SCALARS: Mapping[str, Scalar] = {
    **UNSIGNED,
    "byte": "i8",
    "short integer": "i16",
    "integer": "i32",
    "long integer": "i64",
    "float": "f32",
    "long float": "f64",
}
BITS: Mapping[Unsigned, int] = {"u8": 8, "u16": 16, "u32": 32, "u64": 64}

_FUNCTIONS: Mapping[str, Literal["round", "floor", "ceiling"]] = {
    "round": "round",
    "floor": "floor",
    "ceiling": "ceiling",
}
_INCLUSIVE: Mapping[str, bool] = {"inclusive": True, "exclusive": False}


def scalar(element: Element) -> Scalar:
    """The number type of a field."""
    return choice(element, "field_type", SCALARS)


def unsigned(element: Element) -> Unsigned:
    """The number type of a count, tag, presence vector or bit field."""
    return choice(element, "field_type_unsigned", UNSIGNED)


def read_count(element: Element, scope: NameScope) -> Count:
    """Read a count or tag field; without limits all values of its type are allowed."""
    kind = unsigned(element)
    largest = 2 ** BITS[kind] - 1
    minimum = scope.integer(element, "min_count") if "min_count" in element.attrib else 0
    maximum = scope.integer(element, "max_count") if "max_count" in element.attrib else largest
    if not 0 <= minimum <= maximum <= largest:
        raise wrong(element, f"expected 0 <= min_count <= max_count <= {largest}, got {minimum} and {maximum}")
    return Count(kind, minimum, maximum)


def read_scale(parent: Element, scope: NameScope) -> Scale | None:
    """Read the scale range inside a field, if there is one."""
    element = parent.find("scale_range")
    if element is None:
        return None
    lower, upper = read_limits(element, scope)
    if lower >= upper:
        raise wrong(element, f"expected real_lower_limit < real_upper_limit, got {lower} and {upper}")
    return Scale(lower, upper, choice(element, "integer_function", _FUNCTIONS))


def read_limits(element: Element, scope: NameScope) -> tuple[float, float]:
    """Read both ends of a scale range, as written."""
    return float(scope.number(element, "real_lower_limit")), float(scope.number(element, "real_upper_limit"))


def read_values(parent: Element, scope: NameScope) -> ValueSet | None:
    """Read the value set inside a field, if there is one, written out or declared."""
    for element in parent.iterchildren("value_set", "declared_value_set"):
        return read_value_set(element, scope)
    return None


def read_value_set(element: Element, scope: NameScope) -> ValueSet:
    """Read a value set, written out or declared."""
    if element.tag == "declared_value_set":
        home, found = scope.find(element)
        return home.once(required(found, "name"), element, lambda: read_value_set(found, home))
    values = ValueSet(
        tuple(_enum(enum) for enum in element.iterchildren("value_enum")),
        tuple(_range(interval, scope) for interval in element.iterchildren("value_range")),
        offset_to_lower_limit=flag(element, "offset_to_lower_limit"),
    )
    lowest = min([*(enum.value for enum in values.enums), *(range_.lower for range_ in values.ranges)])
    if values.offset_to_lower_limit and lowest:
        reason = f"offset_to_lower_limit: values that are sent as their distance from {lowest} are not supported"
        raise wrong(element, f"{reason}; set it to false if they are sent as they are")
    return values


def _enum(element: Element) -> ValueEnum:
    return ValueEnum(whole_number(element, "enum_index"), required(element, "enum_const"))


def _range(element: Element, scope: NameScope) -> ValueRange:
    lower = scope.number(element, "lower_limit")
    upper = scope.number(element, "upper_limit")
    if lower > upper:
        raise wrong(element, f"expected lower_limit <= upper_limit, got {lower} and {upper}")
    lower_inclusive = choice(element, "lower_limit_type", _INCLUSIVE)
    return ValueRange(lower, upper, lower_inclusive, choice(element, "upper_limit_type", _INCLUSIVE))


LARGEST: Final = 1 << 20
"""Maximal size of a string or array of fixed size, in bytes; each message contains all of it."""


def read_field(element: Element, scope: NameScope) -> Field:
    """Read a field of a record, written out or declared."""
    if element.tag == "array":
        return _array(element, scope)
    if element.tag == "declared_array":
        return scope.declared(element, read_field)
    return read_simple(element, scope)


def read_simple(element: Element, scope: NameScope) -> SimpleField:
    """Read a field that is not an array, written out or declared."""
    reader = _READERS.get(element.tag)
    return scope.declared(element, read_simple) if reader is None else reader(element, scope)


def _fixed_field(element: Element, scope: NameScope) -> FixedField:
    return FixedField(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        type=scalar(element),
        units=required(element, "field_units"),
        scale=read_scale(element, scope),
        values=read_values(element, scope),
    )


def _bit_field(element: Element, scope: NameScope) -> BitField:
    kind = unsigned(element)
    return BitField(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        type=kind,
        subfields=tuple(_sub_field(part, BITS[kind], scope) for part in element.iterchildren("sub_field")),
    )


def _sub_field(element: Element, bits: int, scope: NameScope) -> SubField:
    bit_range = child(element, "bit_range")
    first = bounded(bit_range, "from_index", 0, bits - 1)
    last = bounded(bit_range, "to_index", first, bits - 1)
    return SubField(required(element, "name"), first, last, read_values(element, scope), prose(element))


def _variable_field(element: Element, scope: NameScope) -> VariableField:
    choices = tuple(_type_choice(part, scope) for part in child(element, "type_and_units_field"))
    return VariableField(
        name=required(element, "name"), optional=flag(element, "optional"), doc=prose(element), choices=choices
    )


def _type_choice(element: Element, scope: NameScope) -> TypeChoice:
    return TypeChoice(
        index=bounded(element, "index", 0, 255),
        type=scalar(element),
        units=required(element, "field_units"),
        scale=read_scale(element, scope),
        values=read_values(element, scope),
        name=element.get("name", ""),
        doc=prose(element),
    )


def _fixed_string(element: Element, scope: NameScope) -> FixedString:
    length = scope.integer(element, "string_length")
    if not 1 <= length <= LARGEST:
        raise wrong(element, f"string_length: expected 1 to {LARGEST}, got {length}")
    return FixedString(
        name=required(element, "name"), optional=flag(element, "optional"), doc=prose(element), length=length
    )


def _variable_string(element: Element, scope: NameScope) -> VariableString:
    return VariableString(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        count=read_count(child(element, "count_field"), scope),
    )


def _variable_length_field(element: Element, scope: NameScope) -> VariableLengthField:
    return VariableLengthField(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        format=required(element, "field_format"),
        count=read_count(child(element, "count_field"), scope),
    )


def _variable_format_field(element: Element, scope: NameScope) -> VariableFormatField:
    formats = child(element, "format_field")
    return VariableFormatField(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        formats=tuple(Format(bounded(part, "index", 0, 255), required(part, "field_format")) for part in formats),
        count=read_count(child(element, "count_field"), scope),
    )


def _array(element: Element, scope: NameScope) -> Array:
    array = Array(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        element=read_simple(element[0], scope),
        dimensions=tuple(_dimension(part, scope) for part in element.iterchildren("dimension")),
    )
    size, _ = sizes(array)
    if size > LARGEST:
        raise wrong(element, f"array '{array.name}' takes {size} bytes; at most {LARGEST} are allowed")
    return array


def _dimension(element: Element, scope: NameScope) -> Dimension:
    size = scope.integer(element, "size")
    if size < 1:
        raise wrong(element, f"size: expected at least 1, got {size}")
    return Dimension(required(element, "name"), size)


_READERS: Mapping[str, Callable[[Element, NameScope], SimpleField]] = {
    "fixed_field": _fixed_field,
    "bit_field": _bit_field,
    "variable_field": _variable_field,
    "fixed_length_string": _fixed_string,
    "variable_length_string": _variable_string,
    "variable_length_field": _variable_length_field,
    "variable_format_field": _variable_format_field,
}


_AUXILIARY = frozenset(("presence_vector", "count_field", "vtag_field"))
_MAX_EMPTY_ARMS = 256


def read_composite(element: Element, scope: NameScope) -> Composite:
    """Read a composite, written out or declared."""
    reader = _COMPOSITE_READERS.get(element.tag)
    return scope.declared(element, read_composite) if reader is None else reader(element, scope)


def read_content(part: Element, scope: NameScope) -> Composite | None:
    """Read the content of a header, body or footer, written out or declared; None if it is empty."""
    if part.tag in DECLARED:
        home, found = scope.find(part)
        return read_content(found, home)
    for element in part:
        return bounded_node(read_composite(element, scope), element)
    return None


def _members(element: Element) -> list[Element]:
    return [part for part in element if part.tag not in _AUXILIARY]


def _record(element: Element, scope: NameScope) -> Record:
    fields = tuple(read_field(member, scope) for member in _members(element))
    return Record(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        fields=fields,
        presence=_presence(element, fields),
    )


def _sequence(element: Element, scope: NameScope) -> Sequence:
    items = tuple(read_composite(member, scope) for member in _members(element))
    return Sequence(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        items=items,
        presence=_presence(element, items),
    )


def _presence(element: Element, members: Iterable[Node]) -> Unsigned | None:
    """Read the presence vector of a container. One that is too small is accepted: some public definitions have one."""
    _check_names(element, members)
    vector = element.find("presence_vector")
    if vector is not None:
        return unsigned(vector)
    for member, part in zip(members, _members(element), strict=True):
        if member.optional:
            raise wrong(part, f"'{member.name}' is optional, but '{element.get('name')}' has no <presence_vector>")
    return None


def _check_names(element: Element, members: Iterable[Node]) -> None:
    seen: set[str] = set()
    for member, part in zip(members, _members(element), strict=True):
        if member.name in seen:
            raise wrong(part, f"duplicate name '{member.name}' in '{element.get('name')}'")
        seen.add(member.name)


def _list(element: Element, scope: NameScope) -> List:
    return List(
        name=required(element, "name"),
        optional=flag(element, "optional"),
        doc=prose(element),
        count=read_count(child(element, "count_field"), scope),
        element=read_composite(_members(element)[0], scope),
    )


def _variant(element: Element, scope: NameScope) -> Variant:
    tag = read_count(child(element, "vtag_field"), scope)
    arms = tuple(read_composite(member, scope) for member in _members(element))
    _check_names(element, arms)
    if len(arms) > 2 ** BITS[tag.type]:
        raise wrong(element, f"{len(arms)} arms, but its tag has only {2 ** BITS[tag.type]} values; use a larger type")
    if not arms:  # a public definition has a variant that consists of its tag only
        arms = tuple(Record(name=f"Empty{index}", fields=()) for index in range(min(tag.maximum + 1, _MAX_EMPTY_ARMS)))
    return Variant(
        name=required(element, "name"), optional=flag(element, "optional"), doc=prose(element), tag=tag, arms=arms
    )


_COMPOSITE_READERS: Mapping[str, Callable[[Element, NameScope], Composite]] = {
    "record": _record,
    "sequence": _sequence,
    "list": _list,
    "variant": _variant,
}
