"""Number types, scales, value sets and counts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from lxml.etree import _Element as Element

from jauspy.schema.document import choice, flag, required, whole_number, wrong
from jauspy.schema.library import Scope
from jauspy.schema.model import Count, Scalar, Scale, Unsigned, ValueEnum, ValueRange, ValueSet

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


def read_count(element: Element, scope: Scope) -> Count:
    """A count or tag field; without limits all values of its type are allowed."""
    kind = unsigned(element)
    largest = 2 ** BITS[kind] - 1
    minimum = scope.integer(element, "min_count") if "min_count" in element.attrib else 0
    maximum = scope.integer(element, "max_count") if "max_count" in element.attrib else largest
    if not 0 <= minimum <= maximum <= largest:
        raise wrong(element, f"expected 0 <= min_count <= max_count <= {largest}, got {minimum} and {maximum}")
    return Count(kind, minimum, maximum)


def read_scale(parent: Element, scope: Scope) -> Scale | None:
    """The scale range inside a field, if there is one."""
    element = parent.find("scale_range")
    if element is None:
        return None
    lower, upper = read_limits(element, scope)
    if lower >= upper:
        raise wrong(element, f"expected real_lower_limit < real_upper_limit, got {lower} and {upper}")
    return Scale(lower, upper, choice(element, "integer_function", _FUNCTIONS))


def read_limits(element: Element, scope: Scope) -> tuple[float, float]:
    """Both ends of a scale range, as they are written."""
    return float(scope.number(element, "real_lower_limit")), float(scope.number(element, "real_upper_limit"))


def read_values(parent: Element, scope: Scope) -> ValueSet | None:
    """The value set inside a field, if there is one, written out or declared."""
    for element in parent.iterchildren("value_set", "declared_value_set"):
        return read_value_set(element, scope)
    return None


def read_value_set(element: Element, scope: Scope) -> ValueSet:
    """A value set, written out or declared."""
    if element.tag == "declared_value_set":
        home, found = scope.find(element)
        return home.once(required(found, "name"), element, lambda: read_value_set(found, home))
    values = ValueSet(
        tuple(_enum(enum) for enum in element.iterchildren("value_enum")),
        tuple(_range(interval, scope) for interval in element.iterchildren("value_range")),
        offset_to_lower_limit=flag(element, "offset_to_lower_limit"),
    )
    lowest = min([*(enum.value for enum in values.enums), *(each.lower for each in values.ranges)])
    if values.offset_to_lower_limit and lowest:
        reason = f"offset_to_lower_limit: values that are sent as their distance from {lowest} are not supported"
        raise wrong(element, f"{reason}; say false if they are sent as they are")
    return values


def _enum(element: Element) -> ValueEnum:
    return ValueEnum(whole_number(element, "enum_index"), required(element, "enum_const"))


def _range(element: Element, scope: Scope) -> ValueRange:
    lower = scope.number(element, "lower_limit")
    upper = scope.number(element, "upper_limit")
    if lower > upper:
        raise wrong(element, f"expected lower_limit <= upper_limit, got {lower} and {upper}")
    lower_inclusive = choice(element, "lower_limit_type", _INCLUSIVE)
    return ValueRange(lower, upper, lower_inclusive, choice(element, "upper_limit_type", _INCLUSIVE))
