"""Rules about fields: their bits, limits, scales and values."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Final

from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.schema.digest import sizes
from jauspy.schema.document import location, suggestion
from jauspy.schema.fields import BITS, SCALARS, UNSIGNED, read_composite, read_count, read_limits, read_value_set
from jauspy.schema.library import NameScope
from jauspy.schema.lint.context import LintContext, Problem
from jauspy.schema.model import List, Scalar, ValueSet

COUNTS = ("count_field", "vtag_field")
_VALUE_SETS = ("value_set", "declared_value_set")


def named(element: Element) -> str:
    """The name of an element, or of the nearest one around it that has a name."""
    holder: Element | None = element
    while holder is not None and holder.get("name") is None:
        holder = holder.getparent()
    return f"'{holder.get('name')}'" if holder is not None else f"<{element.tag}>"


def bits_of(element: Element) -> int:
    """The bits of an unsigned type; 0 when it is not one."""
    kind = UNSIGNED.get(" ".join(element.get("field_type_unsigned", "").split()))
    return BITS[kind] if kind else 0


def _bits(sub_field: Element) -> tuple[int, int] | None:
    """First and last bit of a sub-field, as written."""
    for part in sub_field.iterchildren("bit_range"):
        try:
            return int(part.get("from_index", "")), int(part.get("to_index", ""))
        except ValueError:
            return None
    return None


def bits_beyond_type(context: LintContext) -> Iterator[Problem]:
    """Sub-fields outside their bit field."""
    for field, _ in context.elements("bit_field"):
        size = bits_of(field)
        for part in field.iterchildren("sub_field"):
            found, where = _bits(part), location(next(part.iterchildren("bit_range"), part))
            if found is None or not size:
                continue
            first, last = found
            if first > last:
                yield where, f"{named(part)} ends at bit {last}, before its first bit {first}; swap them"
            elif first < 0 or last >= size:
                reason = f"{named(part)} has bits {first}..{last}, but {named(field)} has only bits 0..{size - 1}"
                yield where, f"{reason}; move it or use a larger type"


def overlapping_bits(context: LintContext) -> Iterator[Problem]:
    """Sub-fields that share bits."""
    for field, _ in context.elements("bit_field"):
        taken: list[tuple[int, int, Element]] = []
        for part in field.iterchildren("sub_field"):
            found = _bits(part)
            if found is None:
                continue
            for first, last, other in taken:
                low, high = max(first, found[0]), min(last, found[1])
                if low <= high:
                    bits = f"bit {low}" if low == high else f"bits {low}..{high}"
                    yield location(part), f"{named(part)} and {named(other)} share {bits}; move one of them"
            taken.append((*found, part))


def count_limits(context: LintContext) -> Iterator[Problem]:
    """Counts whose limits are reversed or outside of their type."""
    for element, scope in context.elements(*COUNTS):
        limits = _limits(element, scope)
        size = bits_of(element)
        if limits is None or not size:
            continue
        low, high = limits
        if not 0 <= low <= high < 2**size:
            reason = f"{element.tag} of {named(element)}: limits {low}..{high} do not fit 0..{2**size - 1}"
            yield location(element), f"{reason}; correct them or take another type"


def _limits(element: Element, scope: NameScope) -> tuple[int, int] | None:
    """Both limits of a count, those of its type where one is not written; None when they are no numbers."""
    try:
        low = scope.integer(element, "min_count") if "min_count" in element.attrib else 0
        high = scope.integer(element, "max_count") if "max_count" in element.attrib else 2 ** bits_of(element) - 1
    except SchemaError:
        return None
    return low, high


def missing_count(context: LintContext) -> Iterator[Problem]:
    """Counts without limits, which are bounded by their type only."""
    for element, _ in context.elements("count_field"):
        missing = [name for name in ("min_count", "max_count") if name not in element.attrib]
        if missing:
            most = f", so up to {2 ** bits_of(element) - 1} are allowed" if "max_count" in missing else ""
            yield (
                location(element),
                f"count of {named(element)} has no {' and no '.join(missing)}{most}; set the limits",
            )


def tag_limits(context: LintContext) -> Iterator[Problem]:
    """Variant tags whose limits are not those of the arms."""
    for variant, scope in context.elements("variant"):
        arms = sum(1 for part in variant if part.tag != "vtag_field")
        for tag in variant.iterchildren("vtag_field"):
            count = context.attempt(lambda tag=tag, scope=scope: read_count(tag, scope))  # type: ignore[misc]
            if arms > 2 ** bits_of(tag):
                continue  # the loader rejects it
            if count is not None and arms and (count.minimum, count.maximum) != (0, arms - 1):
                reason = f"tag of {named(variant)} allows {count.minimum}..{count.maximum}, but its {arms} arms are "
                yield location(tag), f'{reason}0..{arms - 1}; write min_count="0" max_count="{arms - 1}"'


def small_presence_vector(context: LintContext) -> Iterator[Problem]:
    """Presence vectors with fewer bits than optional members, or none at all."""
    for element, _ in context.elements("record", "sequence"):
        optional = [part for part in element if part.get("optional", "").strip() in ("true", "1")]
        vector = element.find("presence_vector")
        if vector is None:
            for part in optional:
                reason = f"{named(part)} is optional, but {named(element)} has no <presence_vector>"
                yield location(part), f"{reason}; add one or make it mandatory"
            continue
        size = bits_of(vector)
        if size and len(optional) > size:
            lost = ", ".join(named(part) for part in optional[size:])
            reason = f"presence vector of {named(element)} has {size} bits for {len(optional)} optional members"
            yield location(vector), f"{reason}: {lost} can never be sent; use a larger type"


def unbounded_list(context: LintContext) -> Iterator[Problem]:
    """Lists of empty items: a count of four thousand million fits into four bytes."""
    for element, scope in context.elements("list"):
        if not context.is_sound(element):
            continue
        found = context.attempt(lambda element=element, scope=scope: read_composite(element, scope))  # type: ignore[misc]
        if isinstance(found, List) and not sizes(found.element)[0]:
            reason = f"{named(element)} repeats an item that may have no content, so the data cannot bound its count"
            yield location(element), f"{reason}; give the item a mandatory field"


def scale_limits(context: LintContext) -> Iterator[Problem]:
    """Scales with equal limits."""
    for element, scope in context.elements("scale_range"):
        limits = context.attempt(lambda element=element, scope=scope: read_limits(element, scope))  # type: ignore[misc]
        if limits is not None and limits[0] >= limits[1]:
            what = "swap them" if limits[0] > limits[1] else "they need a distance"
            yield location(element), f"scale of {named(element)} goes from {limits[0]:g} to {limits[1]:g}; {what}"


_WORDS: Final = (
    "one ampere becquerel candela coulomb farad gray henry hertz joule katal kelvin kilogram lumen lux meter mole",
    "newton ohm pascal radian second siemens sievert steradian tesla volt watt weber minute hour day degree liter bar",
    "percent knot neper bel hectare are curie roentgen rad rem gram",
)
UNITS: Final = frozenset(" ".join(_WORDS).split()) | {
    "degree Celsius",
    "nautical mile",
    "metric ton",
    "square meter",
    "cubic meter",
    "rotations per minute",
}
"""Units of JSIDL (AS5684) that are not composed of others."""
_POWER: Final = re.compile(r"(square |cubic |reciprocal )?(.+?)( squared| cubed)?")


def unknown_unit(context: LintContext) -> Iterator[Problem]:
    """Units that JSIDL does not have: tools cannot convert them."""
    for element, _ in context.elements("fixed_field", "variable_field", "type_and_units_enum"):
        unit = " ".join(element.get("field_units", "one").split())
        if not _is_unit(unit):
            reason = f"{unit!r}, the unit of {named(element)}, is not one of JSIDL"
            yield location(element), f"{reason}{suggestion(unit, UNITS)}"


def _is_unit(text: str) -> bool:
    """True for a unit, products and quotients of units, as in `newton meter` and `meter per second squared`."""
    if text in UNITS:
        return True
    return all(all(map(_is_factor, _factors(part))) for part in text.split(" per "))


def _factors(text: str) -> list[str]:
    """The factors of a product: words, with the powers that belong to them."""
    found = re.findall(r"(?:square |cubic |reciprocal )?(?:degree Celsius|\S+)(?: squared| cubed)?", text)
    return found if " ".join(found) == text else [""]


def _is_factor(text: str) -> bool:
    match = _POWER.fullmatch(text)
    return match is not None and match[2] in UNITS


def scale_types(context: LintContext) -> Iterator[Problem]:
    """Scales of floats, which are meaningless, and scales with finer steps than floats have."""
    for element, scope in context.elements("scale_range"):
        holder = element.getparent()
        kind = None if holder is None else SCALARS.get(" ".join(holder.get("field_type", "").split()))
        limits = context.attempt(lambda element=element, scope=scope: read_limits(element, scope))  # type: ignore[misc]
        if kind is None or limits is None:
            continue
        top = 2 ** (int(kind[1:]) - (not kind.startswith("u"))) - 1
        if kind.startswith("f"):
            yield location(element), f"scale of {named(element)} means nothing, it is a float; write a value_set"
        elif (limits[1] - limits[0]) / top < 2 * math.ulp(max(map(abs, limits))):
            reason = f"steps of {named(element)} are finer than those of a float, so bytes change when they are sent on"
            yield location(element), f"{reason}; take a smaller type"


def duplicate_name(context: LintContext) -> Iterator[Problem]:
    """Members of one container, or arms of one variant, with one name."""
    for element, _ in context.elements("record", "sequence", "variant"):
        seen: dict[str, Element] = {}
        for part in element.iterchildren():
            name = part.get("name")
            if name is not None and seen.setdefault(name, part) is not part:
                yield location(part), f"{named(element)} has two members called '{name}'; rename one"


def duplicate_index(context: LintContext) -> Iterator[Problem]:
    """Alternatives of a variable field or format with one index."""
    for element, _ in context.elements("type_and_units_field", "format_field"):
        seen: dict[str, Element] = {}
        for part in element:
            index = part.get("index", "").strip()
            first = seen.setdefault(index, part)
            if first is not part:
                reason = f"{named(element)} has two alternatives with index {index}"
                yield location(part), f"{reason}; the second can never be sent, give it another"


# --- value sets -----------------------------------------------------------------------------------------------------


def value_range_limits(context: LintContext) -> Iterator[Problem]:
    """Ranges of allowed values with reversed limits."""
    for element, scope in context.elements("value_range"):
        limits = context.attempt(
            lambda element=element, scope=scope: (  # type: ignore[misc]
                scope.number(element, "lower_limit"),
                scope.number(element, "upper_limit"),
            )
        )
        if limits is not None and limits[0] > limits[1]:
            yield location(element), f"range of {named(element)} goes from {limits[0]:g} to {limits[1]:g}; swap them"


def values_beyond_type(context: LintContext) -> Iterator[Problem]:
    """Values and ranges that do not fit into the field's bytes or bits."""
    for holder, scope in context.elements("fixed_field", "type_and_units_enum", "sub_field"):
        limits = _value_limits(holder)
        if limits is None:
            continue
        for element in holder.iterchildren(*_VALUE_SETS):
            values = context.attempt(
                lambda element=element, scope=scope: read_value_set(element, scope)  # type: ignore[misc]
            )
            for what in _beyond(values or ValueSet(), *limits):
                reason = f"{named(holder)}: {what} is outside {limits[0]}..{limits[1]}, which is all its type can carry"
                yield location(element), f"{reason}; correct it or use a larger type"


def _value_limits(holder: Element) -> tuple[int, int] | None:
    """Smallest and largest number of a field; None for floats and for fields with other mistakes."""
    if holder.tag == "sub_field":
        bits = _bits(holder)
        return None if bits is None or bits[0] > bits[1] else (0, 2 ** (bits[1] - bits[0] + 1) - 1)
    kind: Scalar | None = SCALARS.get(" ".join(holder.get("field_type", "").split()))
    if kind is None or kind.startswith("f"):
        return None
    bits_there = int(kind[1:])
    return (0, 2**bits_there - 1) if kind.startswith("u") else (-(2 ** (bits_there - 1)), 2 ** (bits_there - 1) - 1)


def _beyond(values: ValueSet, low: int, high: int) -> Iterator[str]:
    for enum in values.enums:
        if not low <= enum.value <= high:
            yield f"{enum.name} = {enum.value}"
    for part in values.ranges:
        if part.lower < low or part.upper > high:
            yield f"the range {part.lower:g}..{part.upper:g}"


def duplicate_value(context: LintContext) -> Iterator[Problem]:
    """Several names for one value, of which only the first is used."""
    for element, _ in context.elements("value_set"):
        seen: dict[str, Element] = {}
        for part in element.iterchildren("value_enum"):
            value = part.get("enum_index", "").strip()
            first = seen.setdefault(value, part)
            if first is not part:
                names = f"'{first.get('enum_const')}' and '{part.get('enum_const')}'"
                yield location(part), f"{names} of {named(element)} both stand for {value}; keep one"
