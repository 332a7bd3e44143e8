"""The construct tree of a message: structure only, every leaf with its offsets."""

from __future__ import annotations

import struct
from functools import lru_cache
from typing import Any, TypeAlias

from construct import (
    Array,
    Bytes,
    Const,
    Construct,
    Error,
    FormatField,
    IfThenElse,
    Pass,
    RawCopy,
    Struct,
    Switch,
    Terminated,
)

from jauspy.codec.names import attributes
from jauspy.codec.wire import CODES
from jauspy.schema import model as m

Tree: TypeAlias = Construct


@lru_cache(maxsize=1024)
def tree_of(message: m.Message) -> Tree:
    """Id, body, end of the data."""
    body = Pass if message.body is None else node_tree(message.body)
    return Struct(
        "id" / RawCopy(Const(message.code, number("u16"))),
        "body" / body,
        "end" / Terminated,
    )


def number(kind: m.Scalar) -> Tree:
    """A little-endian number."""
    code = {"u32": "L", "i32": "l"}.get(kind, CODES[kind])  # the names construct has for them
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
            inner = Switch(lambda this: this.tag.value, arms, default=Error) if arms else Pass
            return Struct("tag" / _leaf(node.tag.type), "arm" / inner)
        case m.FixedField() | m.BitField():
            return _leaf(node.type)
        case m.VariableField():
            kinds = {choice.index: _leaf(choice.type) for choice in node.choices}
            return Struct("index" / _leaf("u8"), "number" / Switch(lambda this: this.index.value, kinds, default=Error))
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
    return int(this.count.value)


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
