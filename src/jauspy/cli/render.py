"""Messages as indented lines: `name: value unit`, or valid YAML with the units in comments."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import IntEnum
from typing import Any, Final, TypeAlias

from rich.text import Text

from jauspy.codec.items import Bits, Blob, Choice, Formatted, Item, Number, Real
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.names import unit_symbol
from jauspy.codec.wire import FLOATS

_PLAIN: Final = re.compile(r"[A-Za-z/][\w./-]*(?::[\w./-]+)*(?: [\w./-]+)*")  # text that needs no quotes in YAML
_YAML_WORDS: Final = frozenset({"y", "n", "yes", "no", "on", "off", "true", "false", "null"})
_INDENT: Final = "  "


@dataclass(frozen=True, slots=True)
class Leaf:
    """A single value as text; `note` is its unit, or the number of a name."""

    text: str
    note: str = ""


Tree: TypeAlias = "Leaf | dict[str, Tree] | list[Tree]"


@dataclass(frozen=True, slots=True)
class _Line:
    indent: str
    name: str
    leaf: Leaf


def field_lines(message: Message, *, yaml: bool = False) -> Iterator[Text]:
    """The fields of a message, one line each; with `yaml` the lines together are valid YAML."""
    tree = tree_of(message.layout(), message)
    assert isinstance(tree, dict)
    for line in _entries(tree, ""):
        name = f"{line.name}: " if line.leaf.text else f"{line.name}:"
        note = f"  # {line.leaf.note}" if yaml else f" {line.leaf.note}"
        yield Text.assemble(
            line.indent,
            (name if line.name else "", "cyan"),
            line.leaf.text,
            (note if line.leaf.note else "", "dim"),
        )


# --- from a value to a tree -----------------------------------------------------------------------------------------


def tree_of(item: Item, value: Any) -> Tree:
    """Names, texts and units of a value with the layout `item`."""
    if isinstance(item, Composite):
        parts = ((slot, getattr(value, slot.name)) for slot in item.slots)
        return {slot.name: tree_of(slot.item, part) for slot, part in parts if part is not None} | _reserved_bits(value)
    if isinstance(item, Bits):
        return {bit.name: _integer(getattr(value, bit.name)) for bit in item.bits} | _reserved_bits(value)
    if isinstance(item, Union):
        return {name: tree_of(arm, value) for name, arm in item.arms.items() if arm.cls is type(value)}
    if isinstance(item, Repeat):
        return [tree_of(item.item, part) for part in value]
    if isinstance(item, Grid):
        inner = Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
        return [tree_of(inner, part) for part in value]
    if isinstance(item, Choice):
        chosen = item.items.get(value.choice)
        return {"choice": _integer(value.choice), "value": _number(chosen, value.value)}
    if isinstance(item, Formatted):
        return {"format": _integer(value.format), "data": _blob(value.data)}
    if isinstance(item, Blob):
        return _blob(value)
    return Leaf(_quoted(value)) if isinstance(value, str) else _number(item, value)


def _reserved_bits(value: Any) -> dict[str, Tree]:
    """Reserved bits, if they are set."""
    names = ("reserved_bits", "reserved_presence")
    return {name: Leaf(f"0x{getattr(value, name):X}") for name in names if getattr(value, name, 0)}


def _number(item: Item | None, value: float) -> Leaf:
    if isinstance(item, Real):
        return Leaf(_real(value, item.scaling.factor), unit_symbol(item.units))
    if isinstance(item, Number) and item.code in FLOATS:
        return Leaf(_float(value, 7 if item.code == "f" else 15), unit_symbol(item.units))
    if isinstance(item, Number):
        named = _integer(value)
        return named if named.note else Leaf(named.text, unit_symbol(item.units))
    return Leaf(str(value))


def _real(value: float, steps_per_unit: float) -> str:
    """As many decimals as the encoding resolves, without trailing zeros."""
    decimals = min(12, max(0, math.floor(math.log10(steps_per_unit))))
    text = f"{value:.{decimals}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text


def _float(value: float, digits: int) -> str:
    if math.isfinite(value):
        return f"{value:.{digits}g}"
    return ".nan" if math.isnan(value) else ".inf" if value > 0 else "-.inf"


def _integer(value: Any) -> Leaf:
    return Leaf(value.name, f"({int(value)})") if isinstance(value, IntEnum) else Leaf(str(value))


def _blob(value: Message | bytes) -> Tree:
    if isinstance(value, Message):
        fields = tree_of(value.layout(), value)
        return {"message": Leaf(value.NAME, f"{value.CODE:04X}h"), "fields": fields}
    return {"hex": Leaf(f'"{value.hex()}"', f"{len(value)} bytes")}


def _quoted(text: str) -> str:
    plain = _PLAIN.fullmatch(text) and text.lower() not in _YAML_WORDS
    return text if plain else json.dumps(text)


# --- from a tree to lines -------------------------------------------------------------------------------------------


def _entries(tree: dict[str, Tree], indent: str) -> Iterator[_Line]:
    for name, part in tree.items():
        if isinstance(part, Leaf):
            yield _Line(indent, name, part)
        elif not part:
            yield _Line(indent, name, Leaf("[]" if isinstance(part, list) else "{}"))
        elif isinstance(part, dict):
            yield _Line(indent, name, Leaf(""))
            yield from _entries(part, indent + _INDENT)
        elif (inline := _inline(part)) is not None:
            yield _Line(indent, name, inline)
        else:
            yield _Line(indent, name, Leaf(""))
            yield from _elements(part, indent + _INDENT)


def _inline(parts: list[Tree]) -> Leaf | None:
    """Numbers that fit on one line, such as a covariance row."""
    leaves = [part for part in parts if isinstance(part, Leaf)]
    if len(leaves) < len(parts) or len({leaf.note for leaf in leaves}) > 1:
        return None
    return Leaf(f"[{', '.join(leaf.text for leaf in leaves)}]", leaves[0].note)


def _elements(parts: list[Tree], indent: str) -> Iterator[_Line]:
    for part in parts:
        if isinstance(part, Leaf):
            yield _Line(f"{indent}- ", "", part)
        elif (inline := _inline(part) if isinstance(part, list) else None if part else Leaf("{}")) is not None:
            yield _Line(f"{indent}- ", "", inline)
        else:
            deeper = indent + _INDENT
            first, *rest = _entries(part, deeper) if isinstance(part, dict) else _elements(part, deeper)
            yield replace(first, indent=f"{indent}- {first.indent.removeprefix(deeper)}")
            yield from rest
