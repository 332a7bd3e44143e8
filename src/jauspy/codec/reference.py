"""The reference codec: a construct tree made from the schema model, slow and simple, with the offset of every field.

It explains bytes field by field, up to the damage if there is any, and differential tests compare the other codec with
it. Neither encoding nor decoding uses it. Values have the form of `codec.message.Message.to_dict`, except that messages
inside messages stay bytes.
"""

from __future__ import annotations

import io
import math
import struct
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any, NoReturn, TypeAlias

from construct import (
    Array,
    Bytes,
    Const,
    Construct,
    ConstructError,
    Container,
    FormatField,
    IfThenElse,
    Pass,
    RawCopy,
    Struct,
    Switch,
    Tell,
)

from jauspy.codec.names import attributes, members
from jauspy.codec.rounding import shortest
from jauspy.codec.scalars import CODES, FLOATS, Scaling, as_sent, limits, nearest_raw
from jauspy.errors import DecodeError, EncodeError
from jauspy.schema import model as m
from jauspy.schema.model import MessageDefinition

Tree: TypeAlias = Construct


@lru_cache(maxsize=1024)
def tree_of(message: m.MessageDefinition) -> Tree:
    """Id, body, end of the data."""
    body = Pass if message.body is None else node_tree(message.body)
    return Struct(
        "id" / RawCopy(Const(message.code, number("u16"))),
        "body" / body,
        "end" / Tell,
    )


def number(kind: m.Scalar) -> Tree:
    """The parser of a little-endian number."""
    code = {"u32": "L", "i32": "l"}.get(kind, CODES[kind])  # construct's names
    return FormatField("<", code)


def node_tree(node: m.Node) -> Tree:
    """The tree of a composite or field."""
    match node:
        case m.Record():
            return _parts(node.fields, node.presence)
        case m.Sequence():
            return _parts(node.items, node.presence)
        case m.List():
            return Struct("count" / _leaf(node.count.type), "items" / Array(_count, node_tree(node.element)))
        case m.Variant():
            arms = {tag: node_tree(arm) for tag, arm in enumerate(node.arms)}
            inner = Switch(lambda this: this.tag.value, arms) if arms else Pass
            return Struct("tag" / _leaf(node.tag.type), "arm" / inner)
        case m.FixedField() | m.BitField():
            return _leaf(node.type)
        case m.VariableField():
            kinds = {choice.index: _leaf(choice.type) for choice in node.choices}
            return Struct("index" / _leaf("u8"), "number" / Switch(lambda this: this.index.value, kinds))
        case m.FixedString():
            return RawCopy(Bytes(node.length))
        case m.VariableString() | m.VariableLengthField():
            return Struct("count" / _leaf(node.count.type), "bytes" / RawCopy(Bytes(_count)))
        case m.VariableFormatField():
            counted = ("count" / _leaf(node.count.type), "bytes" / RawCopy(Bytes(_count)))
            return Struct("format" / _leaf("u8"), *counted)
        case m.Array():
            tree = node_tree(node.element)
            for dimension in reversed(node.dimensions):
                tree = Array(dimension.size, tree)
            return tree
        case _:
            raise TypeError(type(node).__name__)


def _leaf(kind: m.Scalar) -> Tree:
    return RawCopy(number(kind))


def _count(this: Any) -> int:
    """A count as it is sent; of a padded message no more than can be there, and one, which is then the missing one."""
    count = int(this.count.value)
    stream = this["_io"]
    return min(count, stream.left + 1) if isinstance(stream, _Padded) else count


class _Padded(io.BytesIO):
    """The bytes of a message, followed by zeros without end, so that damaged messages can be read."""

    @property
    def left(self) -> int:
        """Bytes before the end."""
        return max(0, len(self.getbuffer()) - self.tell())

    def read(self, size: int | None = -1) -> bytes:
        """The next `size` bytes, padded with zeros."""
        assert size is not None
        found = super().read(size)
        if len(found) < size:
            self.seek(self.tell() + size - len(found))
            found = found.ljust(size, b"\0")
        return found


def _parts(nodes: tuple[m.Node, ...], presence: m.Unsigned | None) -> Tree:
    names = attributes((node.name for node in nodes), "reserved_presence")
    subcons = ["_presence" / _leaf(presence)] if presence else []
    bit = 0
    for name, node in zip(names, nodes, strict=True):
        tree = node_tree(node)
        if presence and node.optional:
            tree = IfThenElse(_has(bit if bit < 8 * struct.calcsize(CODES[presence]) else None), tree, Pass)
            bit += 1
        subcons.append(f"f_{name}" / tree)
    return Struct(*subcons)


def _has(bit: int | None) -> Any:
    if bit is None:
        return lambda this: False  # noqa: ARG005 - construct passes its context
    return lambda this: this["_presence"].value >> bit & 1


Number = m.FixedField | m.TypeChoice | m.SubField


@dataclass(frozen=True, slots=True, kw_only=True)
class ExplainedValue:
    """One number or string on the wire: offset, field, raw form and value."""

    offset: int
    length: int
    path: str
    raw: int | float | bytes
    value: Any
    problem: str = ""
    """Requirement of the definition that this value or these bytes do not meet."""
    damaged: bool = False
    """True for the field that cannot be read; no field after it can be read, either."""


class Explainer:
    """Walks a parsed tree along its model; collects a row per leaf and returns values."""

    def __init__(self, size: int, *, strict: bool) -> None:
        self.strict = strict
        self.rows: list[ExplainedValue] = []
        self._size = size
        """Bytes of the message."""
        self._unusual = ""
        """Problem of the value of the next row."""

    def message(self, message: m.MessageDefinition, tree: Container) -> dict[str, Any]:
        """The values of the body."""
        self._row(tree.id, "message_id", message.name)
        body = message.body
        if body is None:
            return {}
        if isinstance(body, (m.List, m.Variant)):
            (name,) = attributes([body.name])
            return {name: self._node(body, tree.body, name)}
        values = self._node(body, tree.body, "")
        assert isinstance(values, dict)
        return values

    def _row(self, leaf: Container, path: str, value: Any, needed: int | None = None, kind: str = "") -> None:
        """Add a row; raises `DecodeError` if the message ends within its bytes.

        `needed`: how many there should be; `kind`: of what.
        """
        needed = leaf.length if needed is None else needed
        if leaf.offset1 + needed > self._size:
            left = max(0, self._size - leaf.offset1)
            reason = f"needs {needed} byte{'s' * (needed != 1)}{kind}, {left} left"
            self._damaged(reason, leaf.offset1, left, path)
        self.rows.append(
            ExplainedValue(
                offset=leaf.offset1, length=leaf.length, path=path, raw=leaf.value, value=value, problem=self._unusual
            )
        )
        self._unusual = ""

    def _damaged(self, reason: str, offset: int, length: int, path: str) -> NoReturn:
        self.rows.append(
            ExplainedValue(offset=offset, length=length, path=path, raw=b"", value=None, problem=reason, damaged=True)
        )
        raise DecodeError(reason, offset=offset, path=path)

    def _wrong(self, reason: str, leaf: Container, path: str) -> None:
        if self.strict:
            raise DecodeError(reason, offset=leaf.offset1, path=path)
        self._unusual = reason

    def end(self, offset: int) -> None:
        """Raise `DecodeError` if bytes follow the end of the message."""
        if offset < self._size:
            rest = self._size - offset
            self._damaged(f"{rest} byte{'s' * (rest != 1)} more than the definition has", offset, rest, "")

    def _node(self, node: m.Node, tree: Any, path: str) -> Any:
        match node:
            case m.Record():
                return self._parts(node.fields, node.presence, tree, path)
            case m.Sequence():
                return self._parts(node.items, node.presence, tree, path)
            case m.List():
                self._counted(node.count, tree.count, path)
                return [self._node(node.element, item, f"{path}[{n}]") for n, item in enumerate(tree["items"])]
            case m.Variant():
                return self._variant(node, tree, path)
            case m.FixedField():
                return self._number(node, tree, path, node.name)
            case m.BitField():
                return self._bits(node, tree, path)
            case m.VariableField():
                return self._choice(node, tree, path)
            case m.FixedString():
                text = tree.value.rstrip(b"\0").decode("latin-1")
                self._row(tree, path, text)
                return text
            case m.VariableString():
                self._counted(node.count, tree.count, path)
                text = tree.bytes.value.decode("latin-1")
                self._row(tree.bytes, path, text, tree.count.value)
                return text
            case m.VariableLengthField():
                low = 0 if node.format.lower() == "jaus message" else node.count.minimum
                return self._bytes(m.Count(node.count.type, low, node.count.maximum), tree, path)
            case m.VariableFormatField():
                return self._format(node, tree, path)
            case m.Array():
                return self._array(node, tree, path, len(node.dimensions))
            case _:
                raise TypeError(type(node).__name__)

    def _parts(self, nodes: Iterable[m.Node], presence: Any, tree: Container, path: str) -> dict[str, Any]:
        listed = list(nodes)
        values: dict[str, Any] = {}
        names = attributes((n.name for n in listed), "reserved_presence")
        if presence:
            optional = [name for name, node in zip(names, listed, strict=True) if node.optional]
            present = [name for bit, name in enumerate(optional) if tree["_presence"].value >> bit & 1]
            self._row(tree["_presence"], f"{path}.presence_vector" if path else "presence_vector", present)
        for name, node in zip(names, listed, strict=True):
            part = tree[f"f_{name}"]
            if part is not None:
                values[name] = self._node(node, part, f"{path}.{name}" if path else name)
        if presence:
            defined = (1 << sum(node.optional for node in listed)) - 1
            if tree["_presence"].value & ~defined:
                values["reserved_presence"] = tree["_presence"].value & ~defined
        return values

    def _counted(self, count: m.Count, leaf: Container, path: str) -> None:
        if not count.minimum <= leaf.value <= count.maximum:
            self._wrong(f"count {leaf.value} is outside {count.minimum}..{count.maximum}", leaf, path)
        self._row(leaf, f"{path}.count", leaf.value)

    def _variant(self, node: m.Variant, tree: Container, path: str) -> Any:
        names = attributes((arm.name for arm in node.arms), "code")
        if not node.arms:
            self._row(tree.tag, f"{path}.tag", tree.tag.value)
            return {"tag": tree.tag.value}
        self._known(tree.tag, range(len(names)), f"{path}.tag", "alternative")
        name = names[tree.tag.value]
        self._row(tree.tag, f"{path}.tag", name)
        arm = node.arms[tree.tag.value]
        inner = self._node(arm, tree.arm, f"{path}.{name}")
        return {name: wrapped(arm, inner)}

    def _known(self, leaf: Container, known: Collection[int], path: str, what: str) -> None:
        """Raise `DecodeError` for the number of an unknown alternative; the fields after it cannot be read."""
        if leaf.offset1 < self._size and leaf.value not in known:
            numbers = ", ".join(map(str, known))
            self._damaged(f"{what} {leaf.value} is not defined, only {numbers}", leaf.offset1, leaf.length, path)

    def _number(self, kind: Number, leaf: Container, path: str, name: str) -> Any:
        assert not isinstance(kind, m.SubField)
        raw = leaf.value
        code = CODES[kind.type]
        if kind.scale is not None and code not in FLOATS:
            value: Any = real(raw, kind.scale, limits(code)[1])
            shown = shortest(value, Scaling(kind.scale.lower, kind.scale.upper, limits(code)[1], kind.scale.function))
            if raw < 0:
                self._wrong("raw value below 0", leaf, path)
        else:
            value = named(raw, kind.values)
            if code in FLOATS and not math.isfinite(raw):
                self._wrong(f"{name} is not finite", leaf, path)
                value = str(raw)
            elif not allows(kind.values, raw, code):
                self._wrong(f"{raw} is not allowed", leaf, path)
            shown = value
        self._row(leaf, path, shown, kind=_kind(kind))
        return value

    def _bits(self, node: m.BitField, leaf: Container, path: str) -> dict[str, Any]:
        values: dict[str, Any] = {}
        rest = leaf.value
        for name, sub in zip(
            attributes((s.name for s in node.subfields), "reserved_bits"), node.subfields, strict=True
        ):
            mask = (1 << (sub.last - sub.first + 1)) - 1
            part = leaf.value >> sub.first & mask
            rest &= ~(mask << sub.first)
            values[name] = named(part, sub.values)
            if not allows(sub.values, part):
                self._wrong(f"{part} is not allowed", leaf, f"{path}.{name}")
        if rest:
            values["reserved_bits"] = rest
        self._row(leaf, path, values)
        return values

    def _choice(self, node: m.VariableField, tree: Container, path: str) -> dict[str, Any]:
        names = members([(c.index, c.name or c.units) for c in node.choices])
        by_index = {index: name for name, index in names.items()}
        self._known(tree.index, by_index, f"{path}.choice", "type")
        name = by_index.get(tree.index.value)  # unknown only behind the end of the message
        self._row(tree.index, f"{path}.choice", name)
        choice = next(c for c in node.choices if c.index == tree.index.value)
        value = self._number(choice, tree.number, f"{path}.value", choice.name)
        return {"choice": name, "value": value}

    def _bytes(self, count: m.Count, tree: Container, path: str) -> dict[str, str]:
        self._counted(count, tree.count, path)
        value = {"hex": tree.bytes.value.hex()}
        self._row(tree.bytes, path, value["hex"], tree.count.value)
        return value

    def _format(self, node: m.VariableFormatField, tree: Container, path: str) -> dict[str, Any]:
        names = members([(f.index, f.name) for f in node.formats])
        by_index = {index: name for name, index in names.items()}
        index = tree.format.value
        if node.formats and index not in by_index:
            self._wrong(f"format {index} is unknown", tree.format, f"{path}.format")
        self._row(tree.format, f"{path}.format", by_index.get(index, index))
        return {"format": by_index.get(index, index), "data": self._bytes(node.count, tree, f"{path}.data")}

    def _array(self, node: m.Array, tree: Any, path: str, depth: int) -> Any:
        if not depth:
            return self._node(node.element, tree, path)
        return [self._array(node, part, f"{path}[{n}]", depth - 1) for n, part in enumerate(tree)]


def _kind(kind: m.FixedField | m.TypeChoice) -> str:
    """` (u16, -3.2 to 3.2 radian)`."""
    span = f", {kind.scale.lower:g} to {kind.scale.upper:g}" if kind.scale is not None else ""
    units = f" {kind.units}" if kind.units != "one" else ""
    return f" ({kind.type}{span}{units})"


class Stacker:
    """Converts values to the objects that construct builds."""

    def message(self, message: m.MessageDefinition, values: dict[str, Any]) -> dict[str, Any]:
        """The tree of a message."""
        body = message.body
        if body is None:
            tree = None
        elif isinstance(body, (m.List, m.Variant)):
            tree = self._node(body, values[attributes([body.name])[0]])
        else:
            tree = self._node(body, values)
        return {"id": leaf(message.code), "body": tree, "end": None}

    def _node(self, node: m.Node, value: Any) -> Any:
        match node:
            case m.Record():
                return self._parts(node.fields, node.presence, value)
            case m.Sequence():
                return self._parts(node.items, node.presence, value)
            case m.List():
                return {"count": leaf(len(value)), "items": [self._node(node.element, part) for part in value]}
            case m.Variant():
                return self._variant(node, value)
            case m.FixedField():
                return leaf(raw_number(node, value))
            case m.BitField():
                return leaf(self._bits(node, value))
            case m.VariableField():
                index = members([(c.index, c.name or c.units) for c in node.choices])[value["choice"]]
                choice = next(c for c in node.choices if c.index == index)
                return {"index": leaf(index), "number": leaf(raw_number(choice, value["value"]))}
            case m.FixedString():
                return leaf(value.encode("latin-1").ljust(node.length, b"\0"))
            case m.VariableString():
                return counted(value.encode("latin-1"))
            case m.VariableLengthField():
                return counted(bytes.fromhex(value["hex"]))
            case m.VariableFormatField():
                index = members([(f.index, f.name) for f in node.formats]).get(value["format"], value["format"])
                return {"format": leaf(index), **counted(bytes.fromhex(value["data"]["hex"]))}
            case m.Array():
                return self._array(node, value, len(node.dimensions))
            case _:
                raise TypeError(type(node).__name__)

    def _parts(self, nodes: tuple[m.Node, ...], presence: Any, values: dict[str, Any]) -> dict[str, Any]:
        tree: dict[str, Any] = {}
        mask, bit = values.get("reserved_presence", 0), 0
        for name, node in zip(attributes((n.name for n in nodes), "reserved_presence"), nodes, strict=True):
            value = values.get(name)
            tree[f"f_{name}"] = None if value is None else self._node(node, value)
            if node.optional:
                mask |= (value is not None) << bit
                bit += 1
        if presence:
            tree["_presence"] = leaf(mask)
        return tree

    def _variant(self, node: m.Variant, value: dict[str, Any]) -> dict[str, Any]:
        if not node.arms:
            return {"tag": leaf(value["tag"]), "arm": None}
        ((name, inner),) = value.items()
        tag = attributes((arm.name for arm in node.arms), "code").index(name)
        return {"tag": leaf(tag), "arm": self._node(node.arms[tag], unwrapped(node.arms[tag], inner))}

    def _bits(self, node: m.BitField, value: dict[str, Any]) -> int:
        raw: int = value.get("reserved_bits", 0)
        for name, sub in zip(
            attributes((s.name for s in node.subfields), "reserved_bits"), node.subfields, strict=True
        ):
            raw |= number_of(value[name], sub.values) << sub.first
        return raw

    def _array(self, node: m.Array, value: Any, depth: int) -> Any:
        return [self._array(node, part, depth - 1) for part in value] if depth else self._node(node.element, value)


def wrapped(arm: m.Node, value: Any) -> Any:
    """A dictionary with the value under the arm's name, for arms that are lists or variants."""
    single = isinstance(arm, m.List) or (isinstance(arm, m.Variant) and arm.arms)
    return {attributes([arm.name])[0]: value} if single else value


def unwrapped(arm: m.Node, value: Any) -> Any:
    """The inverse of `wrapped`."""
    single = isinstance(arm, m.List) or (isinstance(arm, m.Variant) and arm.arms)
    return value[attributes([arm.name])[0]] if single else value


def leaf(value: Any) -> dict[str, Any]:
    """The argument of construct's RawCopy."""
    return {"value": value}


def counted(data: bytes) -> dict[str, Any]:
    """The tree of counted bytes."""
    return {"count": leaf(len(data)), "bytes": leaf(data)}


def real(raw: int, scale: m.Scale, top: int) -> float:
    """The real value, in rational arithmetic."""
    lower, upper = decimal_limits(scale)
    return float(lower + raw * (upper - lower) / top)


def decimal_limits(scale: m.Scale) -> tuple[Fraction, Fraction]:
    """Both ends of the range as decimals of their shortest form."""
    return Fraction(repr(float(scale.lower))), Fraction(repr(float(scale.upper)))


def raw_number(kind: m.FixedField | m.TypeChoice, value: Any) -> Any:
    """The raw form of a number."""
    code = CODES[kind.type]
    if kind.scale is not None and code not in FLOATS:
        lower, upper, top = *decimal_limits(kind.scale), limits(code)[1]
        nearest = nearest_raw(value, lower, upper, top)
        if real(nearest, kind.scale, top) == value:
            return nearest
        return nearest_raw(value, lower, upper, top, kind.scale.function)
    return float(value) if code in FLOATS else number_of(value, kind.values)


def number_of(value: Any, values: m.ValueSet | None) -> int:
    """The number of a member name, or the number itself."""
    if isinstance(value, str) and values is not None:
        return members([(e.value, e.name) for e in values.enums])[value]
    return int(value)


def named(raw: Any, values: m.ValueSet | None) -> Any:
    """The member name of a number, or the number itself."""
    if values is None:
        return raw
    return next(
        (name for name, number in members([(e.value, e.name) for e in values.enums]).items() if number == raw), raw
    )


def allows(values: m.ValueSet | None, raw: float, code: str = "Q") -> bool:
    """True if a value set contains the number; an empty one contains all."""
    if values is None or not (values.enums or values.ranges):
        return True
    if any(enum.value == raw for enum in values.enums):
        return True
    return any(_within(r, raw, code) for r in values.ranges)


def _within(r: m.ValueRange, raw: float, code: str) -> bool:
    lower, upper = (as_sent(r.lower, code), as_sent(r.upper, code)) if code in FLOATS else (r.lower, r.upper)
    above = raw >= lower if r.lower_inclusive else raw > lower
    below = raw <= upper if r.upper_inclusive else raw < upper
    return above and below


def explain(message: MessageDefinition, data: bytes) -> list[ExplainedValue]:
    """Every field of a message with its bytes; ids, presence vectors, counts and tags have separate rows.

    When the structure cannot be read, the last row is the field at which that begins. Values outside their set are
    shown as they are, with the problem.
    """
    explainer = Explainer(len(data), strict=False)
    try:
        found = _parse(message, _Padded(data))
        explainer.message(message, found)
        explainer.end(found.end)
    except DecodeError as error:
        if not (explainer.rows and explainer.rows[-1].damaged):
            offset = error.offset or 0
            explainer.rows.append(
                ExplainedValue(
                    offset=offset, length=0, path=error.path, raw=b"", value=None, problem=error.reason, damaged=True
                )
            )
    return explainer.rows


def parse(message: MessageDefinition, data: bytes) -> dict[str, Any]:
    """The values of a message, strict; raises `DecodeError`."""
    found = _parse(message, io.BytesIO(data))
    explainer = Explainer(len(data), strict=True)
    values = explainer.message(message, found)
    explainer.end(found.end)
    return values


def build(message: MessageDefinition, values: dict[str, Any]) -> bytes:
    """The inverse of `parse`; raises `EncodeError`."""
    try:
        built = tree_of(message).build(Stacker().message(message, values))
    except (ConstructError, KeyError, ValueError, TypeError, AttributeError) as error:
        raise EncodeError(str(error).strip() or type(error).__name__) from error
    assert isinstance(built, bytes)
    return built


def _parse(message: MessageDefinition, stream: io.BytesIO) -> Container:
    tree: Tree = tree_of(message)
    try:
        found = tree.parse_stream(stream)
    except ConstructError as error:
        *_, reason = str(error).splitlines() or [type(error).__name__]
        raise DecodeError(reason, path=_path(error), offset=len(stream.getbuffer())) from error
    assert isinstance(found, Container)
    return found


def _path(error: ConstructError) -> str:
    """The path of the field that could not be read, without construct's own names."""
    parts = (error.path or "").split(" -> ")
    return ".".join(part.removeprefix("f_") for part in parts if part.startswith("f_"))
