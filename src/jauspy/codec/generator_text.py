"""Small pieces of Python source the generator is made of."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable

from jauspy.codec.plan import (
    BlobPlan,
    ClassPlan,
    GridPlan,
    ItemPlan,
    NumberPlan,
    ObjectPlan,
    RepeatPlan,
    TextPlan,
    UnionPlan,
)
from jauspy.codec.wire import FLOATS

WIDTH = 120


def indent(lines: Iterable[str], levels: int = 1) -> list[str]:
    """The lines, moved right; empty ones stay empty."""
    return ["    " * levels + line if line else line for line in lines]


def quote(text: str) -> str:
    """A double-quoted string literal."""
    body = repr(text)[1:-1].replace("\\'", "'")
    return '"' + body.replace('"', '\\"').replace('\\\\"', '\\"') + '"' if '"' not in text else repr(text)


def tuple_of(parts: Iterable[str]) -> str:
    """A tuple display."""
    listed = list(parts)
    return f"({', '.join(listed)},)" if len(listed) == 1 else f"({', '.join(listed)})"


def docstring(summary: str, details: Iterable[str] = ()) -> list[str]:
    """A docstring; `details` become a block after it."""
    clean = [_plain(line) for line in details]
    head = textwrap.wrap(_plain(summary) or "No description.", WIDTH - 12) or [""]
    if not clean and len(head) == 1:
        return [f'"""{head[0]}"""']
    return [f'"""{head[0]}', *head[1:], *(["", *clean] if clean else []), '"""']


def _plain(text: str) -> str:
    return " ".join(text.split()).replace("\\", "\\\\").replace('"""', "'''")


def annotation(item: ItemPlan) -> str:
    """The type of an attribute."""
    match item:
        case NumberPlan():
            if item.scaling or item.code in FLOATS:
                return "float"
            return f"{item.allowed.enum.path} | int" if item.allowed.enum else "int"
        case TextPlan():
            return "str"
        case BlobPlan():
            return "rt.Message | bytes" if item.is_message else "bytes"
        case ObjectPlan():
            return item.cls.path
        case RepeatPlan():
            return f"list[{annotation(item.item)}]"
        case UnionPlan():
            return " | ".join(arm.path for arm in item.arms)
        case GridPlan():
            return "list[" * len(item.sizes) + annotation(item.item) + "]" * len(item.sizes)


def describe(item: ItemPlan) -> str:
    """Units, range and size of an attribute, for a docstring."""
    match item:
        case NumberPlan() if item.scaling:
            units = "" if item.units == "one" else f" {item.units}"
            return f"{item.scaling.lower:.12g}..{item.scaling.upper:.12g}{units}"
        case NumberPlan():
            units = "" if item.units == "one" else f" in {item.units}"
            ranges = [f"{low:.12g}..{high:.12g}" for low, high in item.allowed.intervals]
            return " or ".join(([item.allowed.enum.name] if item.allowed.enum else []) + ranges) + units
        case TextPlan():
            return f"up to {item.count.maximum if item.count else item.length} characters"
        case BlobPlan():
            return item.format
        case RepeatPlan():
            return f"{item.count.minimum}..{item.count.maximum} items"
        case GridPlan():
            inner = describe(item.item)
            return " x ".join(map(str, item.sizes)) + (f" of {inner}" if inner else "")
        case _:
            return ""


def needs_keywords(plan: ClassPlan) -> bool:
    """True when a required attribute follows an optional one, so that positions are of no use."""
    seen = False
    for slot in plan.slots:
        if seen and not slot.optional:
            return True
        seen = seen or slot.optional
    return False
