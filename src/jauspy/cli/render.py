"""Messages as indented lines: `name: value unit`, or valid YAML with the units in comments."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator, Mapping
from enum import IntEnum
from functools import cache
from typing import Any, Final, NamedTuple, TypeAlias

from rich.text import Text

from jauspy.codec.items import Bits, Blob, Choice, Formatted, Item, Number, Real
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.names import unit_symbol
from jauspy.codec.wire import FLOATS

_PLAIN: Final = re.compile(r"[A-Za-z/][\w./-]*(?::[\w./-]+)*(?: [\w./-]+)*")  # text that needs no quotes in YAML
_YAML_WORDS: Final = frozenset({"y", "n", "yes", "no", "on", "off", "true", "false", "null"})
_INDENT: Final = "  "


class Leaf(NamedTuple):
    """A single value as text; `note` is its unit, or the number of a name."""

    text: str
    note: str = ""


Tree: TypeAlias = "Leaf | dict[str, Tree] | list[Tree]"


class _Line(NamedTuple):
    indent: str
    name: str
    leaf: Leaf


Styled: TypeAlias = "list[tuple[str, str]]"
"""A line: texts, and their styles on terminals."""


def styled_fields(message: Message, *, yaml: bool = False) -> Iterator[Styled]:
    """The fields of a message, one line each; with `yaml` the lines together are valid YAML."""
    tree = tree_of(message.layout(), message)
    assert isinstance(tree, dict)
    mark = "  # " if yaml else " "
    for line in _entries(tree, ""):
        leaf = line.leaf
        name = f"{line.name}: " if leaf.text else f"{line.name}:"
        yield [
            (line.indent, ""),
            (name if line.name else "", "cyan"),
            (leaf.text, ""),
            (f"{mark}{leaf.note}" if leaf.note else "", "dim"),
        ]


def field_lines(message: Message, *, yaml: bool = False) -> Iterator[Text]:
    """The same as texts of rich."""
    for parts in styled_fields(message, yaml=yaml):
        yield Text.assemble(*parts)


# --- from a value to a tree -----------------------------------------------------------------------------------------


def tree_of(item: Item, value: Any) -> Tree:
    """Names, texts and units of a value with the layout `item`."""
    return _renderer(type(item))(item, value)


@cache
def _renderer(kind: type[Item]) -> Callable[[Any, Any], Tree]:
    """How values of a kind of layout become trees; asked once for each, since a message has many fields."""
    return next((render for base, render in _RENDERERS.items() if issubclass(kind, base)), _leaf)


def _composite(item: Composite, value: Any) -> Tree:
    found: dict[str, Tree] = {}
    for slot in item.slots:
        part = getattr(value, slot.name)
        if part is not None:
            found[slot.name] = tree_of(slot.item, part)
    return found | _reserved_bits(value)


def _bits(item: Bits, value: Any) -> Tree:
    return {bit.name: _integer(getattr(value, bit.name)) for bit in item.bits} | _reserved_bits(value)


def _union(item: Union, value: Any) -> Tree:
    return {name: tree_of(arm, value) for name, arm in item.arms.items() if arm.cls is type(value)}


def _repeat(item: Repeat, value: Any) -> Tree:
    return [tree_of(item.item, part) for part in value]


def _grid(item: Grid, value: Any) -> Tree:
    inner = Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
    return [tree_of(inner, part) for part in value]


def _choice(item: Choice, value: Any) -> Tree:
    chosen = item.items.get(value.choice)
    return {"choice": _integer(value.choice), "value": _number(chosen, value.value)}


def _formatted(_item: Formatted, value: Any) -> Tree:
    return {"format": _integer(value.format), "data": _blob(value.data)}


def _leaf(item: Item, value: Any) -> Tree:
    return Leaf(_quoted(value)) if isinstance(value, str) else _number(item, value)


_RESERVED: Final = ("reserved_bits", "reserved_presence")


def _reserved_bits(value: Any) -> dict[str, Tree]:
    """Reserved bits, if they are set."""
    return {name: Leaf(f"0x{getattr(value, name):X}") for name in _RESERVED if getattr(value, name, 0)}


def _number(item: Item | None, value: float) -> Leaf:
    if isinstance(item, Real):
        return Leaf(_real(value, _decimals(item.scaling.factor)), _symbol(item.units))
    if isinstance(item, Number) and item.code in FLOATS:
        return Leaf(_float(value, 7 if item.code == "f" else 15), _symbol(item.units))
    if isinstance(item, Number):
        named = _integer(value)
        return named if named.note else Leaf(named.text, _symbol(item.units))
    return Leaf(str(value))


_symbol: Final = cache(unit_symbol)


@cache
def _decimals(steps_per_unit: float) -> int:
    """Decimals that the encoding resolves."""
    return min(12, max(0, math.floor(math.log10(steps_per_unit))))


def _real(value: float, decimals: int) -> str:
    """With at most as many decimals, without trailing zeros."""
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


_RENDERERS: Final[Mapping[type[Item], Callable[[Any, Any], Tree]]] = {
    Composite: _composite,
    Bits: _bits,
    Union: _union,
    Repeat: _repeat,
    Grid: _grid,
    Choice: _choice,
    Formatted: _formatted,
    Blob: lambda _, value: _blob(value),
}


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
            yield first._replace(indent=f"{indent}- {first.indent.removeprefix(deeper)}")
            yield from rest
