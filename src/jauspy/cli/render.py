"""Messages as indented lines: `name: value unit`, or valid YAML with the units in comments."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator
from enum import IntEnum
from typing import Any, Final, NamedTuple, TypeAlias

from rich.text import Text

from jauspy.codec.items import Bits, Blob, Choice, Formatted, Item, Number, Real
from jauspy.codec.layout import Composite, Grid, Repeat, Union
from jauspy.codec.message import Message
from jauspy.codec.names import unit_symbol
from jauspy.codec.scalars import FLOATS

_PLAIN: Final = re.compile(r"[A-Za-z/][\w./-]*(?::[\w./-]+)*(?: [\w./-]+)*")  # text that needs no quotes in YAML
_YAML_WORDS: Final = frozenset({"y", "n", "yes", "no", "on", "off", "true", "false", "null"})
_INDENT: Final = "  "


class Leaf(NamedTuple):
    """A single value as text; `note` is its unit, or the number of a name."""

    text: str
    note: str = ""


_NOTHING: Final = Leaf("")

Tree: TypeAlias = "Leaf | dict[str, Tree] | list[Tree]"

_Line: TypeAlias = tuple[str, str, Leaf]
"""Indentation, name, and value."""

Styled: TypeAlias = "list[tuple[str, str]]"
"""A line: texts, and their styles on terminals."""


def styled_fields(message: Message, *, yaml: bool = False, margin: str = "") -> Iterator[Styled]:
    """The fields of a message, one line each, behind `margin`; with `yaml` the lines together are valid YAML."""
    mark = "  # " if yaml else " "
    for indent, name, (text, note) in _entries(_fields_of(message), margin):
        yield [
            (indent, ""),
            ((f"{name}: " if text else f"{name}:") if name else "", "cyan"),
            (text, ""),
            (mark + note if note else "", "dim"),
        ]


def field_lines(message: Message, *, yaml: bool = False) -> Iterator[Text]:
    """The same as texts of rich."""
    for parts in styled_fields(message, yaml=yaml):
        yield Text.assemble(*parts)


# --- from a value to a tree -----------------------------------------------------------------------------------------

_Render: TypeAlias = "Callable[[Any], Tree]"
"""Makes names, texts and units of the values of one layout."""

_FIELDS: Final[dict[type[Message], Callable[[Message], dict[str, Tree]]]] = {}


def _fields_of(message: Message) -> dict[str, Tree]:
    """The fields of a message. The layout of each class is inspected once, since a capture has many messages."""
    kind = type(message)
    if kind not in _FIELDS:
        layout = kind.layout()
        assert isinstance(layout, Composite)
        _FIELDS[kind] = _composite(layout)
    return _FIELDS[kind](message)


def _renderer(item: Item) -> _Render:
    match item:
        case Composite():
            return _composite(item)
        case Bits():
            return _bits(item)
        case Union():
            return _union(item)
        case Repeat():
            return _list(_renderer(item.item))
        case Grid():
            return _list(_renderer(Grid(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item))
        case Choice():
            return _choice(item)
        case Formatted():
            return lambda value: {"format": _integer(value.format), "data": _blob(value.data)}
        case Blob():
            return _blob
        case Real():
            return _real_number(item)
        case Number():
            return _float_number(item) if item.code in FLOATS else _integer_number(item)
        case _:
            return lambda value: Leaf(_quoted(value) if isinstance(value, str) else str(value))


def _composite(item: Composite) -> Callable[[Any], dict[str, Tree]]:
    parts = [(slot.name, _renderer(slot.item)) for slot in item.slots]

    def render(value: Any) -> dict[str, Tree]:
        found: dict[str, Tree] = {}
        for name, render_part in parts:
            part = getattr(value, name)
            if part is not None:
                found[name] = render_part(part)
        if item.undefined and value.reserved_presence:
            found["reserved_presence"] = Leaf(f"0x{value.reserved_presence:X}")
        return found

    return render


def _bits(item: Bits) -> _Render:
    def render(value: Any) -> Tree:
        found: dict[str, Tree] = {bit.name: _integer(getattr(value, bit.name)) for bit in item.bits}
        if item.reserved and value.reserved_bits:
            found["reserved_bits"] = Leaf(f"0x{value.reserved_bits:X}")
        return found

    return render


def _union(item: Union) -> _Render:
    arms = {arm.cls: (name, _composite(arm)) for name, arm in item.arms.items()}

    def render(value: Any) -> Tree:
        name, render_arm = arms[type(value)]
        return {name: render_arm(value)}

    return render


def _list(render_part: _Render) -> _Render:
    return lambda value: [render_part(part) for part in value]


def _choice(item: Choice) -> _Render:
    numbers = {index: _renderer(number) for index, number in item.items.items()}
    return lambda value: {"choice": _integer(value.choice), "value": numbers[value.choice](value.value)}


def _real_number(item: Real) -> _Render:
    decimals, symbol = _decimals(item.scaling.factor), unit_symbol(item.units)
    return lambda value: Leaf(_real(value, decimals), symbol)


def _float_number(item: Number) -> _Render:
    digits, symbol = 7 if item.code == "f" else 15, unit_symbol(item.units)
    return lambda value: Leaf(_float(value, digits), symbol)


def _integer_number(item: Number) -> _Render:
    symbol = unit_symbol(item.units)

    def render(value: Any) -> Leaf:
        return _integer(value) if isinstance(value, IntEnum) else Leaf(str(value), symbol)

    return render


def _decimals(steps_per_unit: float) -> int:
    """Decimals that the encoding resolves."""
    return min(12, max(0, math.floor(math.log10(steps_per_unit))))


def _real(value: float, decimals: int) -> str:
    """A number with at most as many decimals, without trailing zeros."""
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
        return {"message": Leaf(value.NAME, f"{value.CODE:04X}h"), "fields": _fields_of(value)}
    return {"hex": Leaf(f'"{value.hex()}"', f"{len(value)} bytes")}


def _quoted(text: str) -> str:
    plain = _PLAIN.fullmatch(text) and text.lower() not in _YAML_WORDS
    return text if plain else json.dumps(text)


# --- from a tree to lines -------------------------------------------------------------------------------------------


def _entries(tree: dict[str, Tree], indent: str) -> list[_Line]:
    lines: list[_Line] = []
    for name, part in tree.items():
        if isinstance(part, Leaf):
            lines.append((indent, name, part))
        elif (inline := _inline(part)) is not None:
            lines.append((indent, name, inline))
        else:
            lines.append((indent, name, _NOTHING))
            deeper = indent + _INDENT
            lines += _entries(part, deeper) if isinstance(part, dict) else _elements(part, deeper)
    return lines


def _inline(part: dict[str, Tree] | list[Tree]) -> Leaf | None:
    """Text of a list that fits on one line: empty, or numbers such as a covariance row."""
    if not part:
        return Leaf("[]" if isinstance(part, list) else "{}")
    if isinstance(part, dict):
        return None
    leaves = [element for element in part if isinstance(element, Leaf)]
    if len(leaves) < len(part) or len({leaf.note for leaf in leaves}) > 1:
        return None
    return Leaf(f"[{', '.join(leaf.text for leaf in leaves)}]", leaves[0].note)


def _elements(parts: list[Tree], indent: str) -> list[_Line]:
    lines: list[_Line] = []
    for part in parts:
        if isinstance(part, Leaf):
            lines.append((f"{indent}- ", "", part))
        elif (inline := _inline(part)) is not None:
            lines.append((f"{indent}- ", "", inline))
        else:
            deeper = indent + _INDENT
            inner = _entries(part, deeper) if isinstance(part, dict) else _elements(part, deeper)
            first, name, leaf = inner[0]
            inner[0] = (f"{indent}- {first.removeprefix(deeper)}", name, leaf)
            lines += inner
    return lines
