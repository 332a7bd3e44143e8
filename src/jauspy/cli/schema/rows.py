"""A message as rows: every field with its place, its size, its type and what it may hold."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from jauspy.cli.render import unit_symbol
from jauspy.codec.wire import CODES, FLOATS, limits
from jauspy.schema import model as m
from jauspy.schema.fields import BITS
from jauspy.schema.wire import Sizes, can_be_there, scalar_size, sizes

_LARGE = 100_000
"""Sizes above this say nothing but that there is no useful limit."""


@dataclass(frozen=True, slots=True)
class Place:
    """Where something starts: fewest and most bytes before it; `varies` when lengths, not presence, decide."""

    low: int
    high: int
    varies: bool = False
    inside: bool = False

    def __str__(self) -> str:
        sign = "≥" if self.varies else "≤" if self.low < self.high else ""
        return f"{'+' if self.inside else ''}{sign}{self.low if self.varies else self.high}"

    def after(self, node: m.Node, *, optional: bool) -> Place:
        """The place behind a member."""
        low, high = sizes(node)
        varies = self.varies or (low < high and not _only_presence(node))
        return replace(self, low=self.low + (0 if optional else low), high=self.high + high, varies=varies)

    def behind(self, size: int) -> Place:
        """The place so many bytes later."""
        return replace(self, low=self.low + size, high=self.high + size)


def _only_presence(node: m.Node) -> bool:
    """True when nothing but presence vectors makes the size of a node vary."""
    if isinstance(node, m.Record | m.Sequence):
        return all(map(_only_presence, node.fields if isinstance(node, m.Record) else node.items))
    low, high = sizes(node)
    return low == high


@dataclass(frozen=True, slots=True)
class Row:
    """One line of a layout; `depth` is how deep it is nested, `bit` its bit in the presence vector."""

    depth: int
    name: str
    place: str
    size: str
    type: str
    bit: int | None = None
    notes: tuple[str, ...] = ()
    doc: str = ""

    def as_object(self) -> dict[str, Any]:
        """The row as JSON carries it."""
        shown = {"depth": self.depth, "name": self.name, "offset": self.place, "size": self.size, "type": self.type}
        return {**shown, "presence_bit": self.bit, "values": list(self.notes), "doc": self.doc}


def rows(message: m.Message) -> list[Row]:
    """The layout of a message, from its id on; offsets as if all optional fields before were there (`≤`)."""
    head = Row(0, "message id", "0", "2", "u16", notes=(f"{message.code:04X}h",))
    if message.body is None:
        return [head]
    place = Place(2, 2)
    if isinstance(message.body, m.Record | m.Sequence):
        return [head, *_members(message.body, 0, place)]
    return [head, *_row(message.body, 0, place, None)]


def _members(node: m.Record | m.Sequence, depth: int, place: Place) -> Iterator[Row]:
    members: Sequence[m.Node] = node.fields if isinstance(node, m.Record) else node.items
    if node.presence:
        size = scalar_size(node.presence)
        optional = sum(member.optional for member in members)
        notes = (f"{optional} optional" if optional <= 8 * size else f"{8 * size} bits for {optional} optional",)
        yield Row(depth, "presence vector", str(place), str(size), node.presence, notes=notes)
        place = place.behind(size)
    bit = 0
    for member, possible in zip(members, can_be_there(node.presence, members), strict=True):
        has_bit = member.optional and node.presence is not None
        if not possible:
            yield Row(depth, member.name, "", "0", _type(member), notes=("never there: no presence bit is left",))
            continue
        yield from _row(member, depth, place, bit if has_bit else None)
        place = place.after(member, optional=has_bit)
        bit += has_bit


def _row(node: m.Node, depth: int, place: Place, bit: int | None) -> Iterator[Row]:
    notes, inside = _notes(node)
    yield Row(depth, node.name, str(place), size_text(sizes(node)), _type(node), bit, notes, node.doc)
    for name, type_, more, doc in inside:
        yield Row(depth + 1, name, "", "", type_, notes=more, doc=doc)
    match node:
        case m.Record() | m.Sequence():
            yield from _members(node, depth + 1, place)
        case m.List():
            yield from _row(node.element, depth + 1, Place(0, 0, inside=True), None)
        case m.Variant():
            for number, arm in enumerate(node.arms):
                first, *rest = _row(arm, depth + 1, place.behind(scalar_size(node.tag.type)), None)
                yield replace(first, notes=(f"tag {number}", *first.notes))
                yield from rest


def size_text(found: Sizes) -> str:
    """`4`, `4..26`, `4..` when there is no useful limit."""
    low, high = found
    return str(low) if low == high else f"{low}..{high if high < _LARGE else ''}"


def _type(node: m.Node) -> str:
    match node:
        case m.FixedField():
            return node.type
        case m.BitField():
            return f"{node.type} bits"
        case m.FixedString() | m.VariableString():
            return "text"
        case m.VariableLengthField():
            return "bytes"
        case m.VariableField():
            return "choice"
        case m.VariableFormatField():
            return "format"
        case m.Array():
            return _type(node.element) + "".join(f"[{dimension.size}]" for dimension in node.dimensions)
        case _:
            return type(node).__name__.lower()


_Inside = tuple[str, str, tuple[str, ...], str]
"""Name, type, notes and doc of a part that has no place of its own, such as a bit."""


def _notes(node: m.Node) -> tuple[tuple[str, ...], list[_Inside]]:
    match node:
        case m.FixedField():
            return tuple(_values(node.type, node.units, node.scale, node.values)), []
        case m.BitField():
            return _reserved(node), [_bits(part) for part in node.subfields]
        case m.FixedString():
            return ("NUL padded",), []
        case m.VariableString():
            return (_count(node.count, "characters"),), []
        case m.VariableLengthField():
            return (node.format, _count(node.count, "bytes")), []
        case m.VariableField():
            return ("u8 index, then",), [_choice(part) for part in node.choices]
        case m.VariableFormatField():
            formats = [(f"{part.index} {part.name}", "", (), "") for part in node.formats]
            return ("u8 index", _count(node.count, "bytes")), list[_Inside](formats)
        case m.Array():
            return _notes(node.element)
        case m.List():
            return (_count(node.count, "items"),), []
        case m.Variant():
            return (f"{node.tag.type} tag, then one of",), []
        case _:
            return (), []


def _count(count: m.Count, what: str) -> str:
    return f"{count.type} count, {count.minimum}..{count.maximum} {what}"


def _reserved(node: m.BitField) -> tuple[str, ...]:
    used = sum(part.last - part.first + 1 for part in node.subfields)
    left = BITS[node.type] - used
    return (f"{left} reserved bit{'s' if left > 1 else ''}",) if left > 0 else ()


def _bits(part: m.SubField) -> _Inside:
    bits = f"bit {part.first}" if part.first == part.last else f"{part.first}..{part.last}"
    return part.name, bits, tuple(_value_set(part.values)), part.doc


def _choice(part: m.TypeChoice) -> _Inside:
    name = f"{part.index} {part.name or part.units}"
    return name, part.type, tuple(_values(part.type, part.units, part.scale, part.values)), part.doc


def _values(kind: m.Scalar, units: str, scale: m.Scale | None, values: m.ValueSet | None) -> Iterator[str]:
    symbol = unit_symbol(units)
    unit = f" {symbol}" if symbol else ""
    if scale is not None and CODES[kind] not in FLOATS:
        step = (scale.upper - scale.lower) / limits(CODES[kind])[1]
        how = "" if scale.function == "round" else f", {scale.function}"
        yield f"{scale.lower:.9g}..{scale.upper:.9g}{unit}, step {step:.3g}{how}"
        return
    found = list(_value_set(values, unit))
    yield from found
    if symbol and not found:
        yield symbol


def _value_set(values: m.ValueSet | None, unit: str = "") -> Iterator[str]:
    if values is None:
        return
    yield from (f"{enum.value} {enum.name}" for enum in values.enums)
    for part in values.ranges:
        low, high = ("" if part.lower_inclusive else ">", "" if part.upper_inclusive else "<")
        yield f"{low}{_limit(part.lower)}..{high}{_limit(part.upper)}{unit}"


def _limit(value: float) -> str:
    return f"{value}" if isinstance(value, int) else f"{value:.9g}"
