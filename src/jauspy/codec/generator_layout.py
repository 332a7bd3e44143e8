"""Source of the `_layout` methods: what the careful codec walks over."""

from __future__ import annotations

from jauspy.codec.generator_text import indent, quote, tuple_of
from jauspy.codec.plan import (
    Allowed,
    BitPlan,
    BlobPlan,
    ClassPlan,
    GridPlan,
    ItemPlan,
    NumberPlan,
    ObjectPlan,
    RepeatPlan,
    SlotPlan,
    TextPlan,
    UnionPlan,
)
from jauspy.codec.scaling import Scaling
from jauspy.codec.wire import CODES
from jauspy.schema.model import Count


def layout_method(plan: ClassPlan) -> list[str]:
    """The lines of a `_layout` classmethod."""
    return ["@classmethod", "def _layout(cls) -> rt.Item:", *indent(_body(plan))]


def _body(plan: ClassPlan) -> list[str]:
    match plan.kind:
        case "bits":
            return _call("rt.Bits", ["cls", quote(plan.code)], [_bit(bit) for bit in plan.bits])
        case "choice":
            pairs = [f"{index}: {item(number)}," for index, number in plan.choices]
            return ["return rt.Choice(", "    cls,", "    {", *indent(pairs, 2), "    },", *_last(plan)]
        case "format":
            assert plan.count is not None
            formats = f"frozenset({{{', '.join(map(str, plan.message_formats))}}})"
            nested = f", _registry, {formats}" if plan.message_formats else ""
            return [f"return rt.Formatted(cls, {values(plan.allowed)}, {count(plan.count)}{nested})"]
        case _:
            tail = f", {quote(plan.presence)}" if plan.presence else ""
            if not plan.slots:
                return [f"return rt.Composite(cls, (){tail})"]
            presence = quote(plan.presence) if plan.presence else "None"
            return [
                "return rt.composite(",
                f"    cls, {presence},",
                *indent(f"{_slot(slot)}," for slot in plan.slots),
                ")",
            ]


def _last(plan: ClassPlan) -> list[str]:
    return [f"    {values(plan.allowed)},", ")"]


def _call(name: str, head: list[str], rows: list[str]) -> list[str]:
    lines = [f"return {name}(", *indent(f"{part}," for part in head), "    ("]
    return [*lines, *indent([f"{row}," for row in rows], 2), "    ),", ")"]


def _slot(slot: SlotPlan) -> str:
    return f"({quote(slot.jaus)}, {item(slot.item)}{', True' if slot.optional else ''})"


def _bit(bit: BitPlan) -> str:
    return f"rt.Bit({quote(bit.name)}, {bit.shift}, 0x{bit.mask:X}, {values(bit.allowed)})"


def values(allowed: Allowed) -> str:
    """The source of a value set."""
    if allowed.anything:
        return "rt.ANY"
    enum = allowed.enum.path if allowed.enum else "None"
    ranges = tuple_of(f"({low!r}, {high!r})" for low, high in allowed.intervals) if allowed.intervals else ""
    return f"rt.Values({enum}{', ' + ranges if ranges else ''})"


def count(limits: Count) -> str:
    """The source of a count."""
    return f"rt.Count({quote(CODES[limits.type])}, {limits.minimum}, {limits.maximum})"


def scaling(scale: Scaling) -> str:
    """The source of a scale range."""
    function = "" if scale.function == "round" else f", {quote(scale.function)}"
    return f"rt.Scaling({scale.lower!r}, {scale.upper!r}, {scale.top}{function})"


def item(plan: ItemPlan) -> str:
    """The source of one item."""
    match plan:
        case NumberPlan() if plan.scaling:
            units = "" if plan.units == "one" else f", {quote(plan.units)}"
            scale = plan.scaling
            function = "" if scale.function == "round" else f", function={quote(scale.function)}"
            return f"rt.real({quote(plan.code)}, {scale.lower!r}, {scale.upper!r}{units}{function})"
        case NumberPlan():
            units = "" if plan.units == "one" else f", {quote(plan.units)}"
            checked = "" if plan.allowed.anything and not units else f", {values(plan.allowed)}"
            return f"rt.Number({quote(plan.code)}{checked}{units})"
        case TextPlan():
            return f"rt.Text(count={count(plan.count)})" if plan.count else f"rt.Text({plan.length})"
        case BlobPlan():
            return f"rt.Blob({count(plan.count)}{', _registry' if plan.is_message else ''})"
        case ObjectPlan():
            return f"{plan.cls.path}.layout()"
        case RepeatPlan():
            return f"rt.Repeat({count(plan.count)}, {item(plan.item)})"
        case UnionPlan():
            arms = [f"{name}={arm.path}" for name, arm in zip(plan.names, plan.arms, strict=True)]
            return f"rt.Union.of({', '.join([quote(plan.code), *arms])})"
        case GridPlan():
            return f"rt.Grid({item(plan.item)}, {tuple_of(map(str, plan.sizes))})"
