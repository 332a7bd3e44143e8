"""Source that turns what `struct` unpacks into values: checks, scaling, members, bit fields, records of fixed size."""

from __future__ import annotations

from dataclasses import dataclass

from jauspy.codec.generator_fixed import Constants, covers, free, outside
from jauspy.codec.generator_locals import Locals
from jauspy.codec.generator_text import needs_keywords
from jauspy.codec.plan import ClassPlan, ItemPlan, NumberPlan, ObjectPlan, TextPlan
from jauspy.codec.undefined import undefined_bits
from jauspy.codec.wire import FLOATS, limits


@dataclass(frozen=True, slots=True)
class Raw:
    """Where the raw values go, and the lines that then make attributes of them."""

    targets: list[str]
    lines: list[str]


def reject_if(condition: str) -> list[str]:
    """The line that gives up."""
    return [f"if {condition}: raise rt.Reject"]


def one_expression(item: ItemPlan, raw: str) -> str | None:
    """The value of a number that takes any raw value, when an expression can make it that needs it only once."""
    if not isinstance(item, NumberPlan) or not free(item):
        return None
    scale = item.scaling
    if scale is None:
        return None if item.allowed.enum else raw
    step = f"{raw} * {scale.step!r}"
    return (f"{scale.lower!r} + {step}" if scale.lower else step) if scale.top_is_exact else None


class RawReader:
    """Writes these sources for one method."""

    def __init__(self, constants: Constants, names: Locals) -> None:
        self._constants = constants
        self._locals = names

    def into(self, item: ItemPlan, hint: str, target: str) -> Raw:
        """An item of fixed size into an attribute or variable; what needs no work is unpacked right into it."""
        if isinstance(item, NumberPlan) and one_expression(item, "") == "":
            return Raw([target], [])
        names, lines, value = self.flat(item, hint)
        return Raw(names, [*lines, f"{target} = {value}"])

    def flat(self, item: ItemPlan, hint: str) -> tuple[list[str], list[str], str]:
        """Names of the raw values, lines that check them, and the value as an expression."""
        if isinstance(item, ObjectPlan) and item.cls.kind != "bits":
            return self._record(item.cls)
        name = self._locals.name(hint)
        match item:
            case NumberPlan():
                return [name], self._checks(item, name), self._converted(item, name)
            case TextPlan():
                return [name], [], f'{name}.rstrip(b"\\0").decode("latin-1")'
            case ObjectPlan():
                return [name], self._bit_checks(item.cls, name), self._bits_value(item.cls, name)
            case _:
                raise AssertionError(item)

    def _record(self, plan: ClassPlan) -> tuple[list[str], list[str], str]:
        names: list[str] = []
        lines: list[str] = []
        arguments: list[str] = []
        for slot in plan.slots:
            inner_names, inner_lines, argument = self.flat(slot.item, slot.name)
            names, lines = names + inner_names, lines + inner_lines
            arguments.append(f"{slot.name}={argument}" if needs_keywords(plan) else argument)
        return names, lines, f"{plan.path}({', '.join(arguments)})"

    def _checks(self, number: NumberPlan, name: str) -> list[str]:
        if number.code in FLOATS:
            lines = reject_if(f"{name} - {name} != 0.0")  # infinities and NaN
            anything = number.allowed.anything
            return lines + ([] if anything else reject_if(outside(number.allowed, name, self._constants)))
        if free(number) or (number.allowed.enum and not number.allowed.intervals):
            return []  # a lookup of the member fails by itself
        if number.scaling:
            return reject_if(f"{name} < 0")
        return reject_if(outside(number.allowed, name, self._constants, *limits(number.code)))

    def _converted(self, number: NumberPlan, name: str) -> str:
        scale = number.scaling
        if scale:
            step = f"{name} * {scale.step!r}"
            value = f"{scale.lower!r} + {step}" if scale.lower else step
            return value if scale.top_is_exact else f"{scale.upper!r} if {name} == {scale.top} else {value}"
        enum = number.allowed.enum
        if enum is None:
            return name
        members = self._constants.members(enum)
        return f"{members}.get({name}, {name})" if number.allowed.intervals or free(number) else f"{members}[{name}]"

    def _bit_checks(self, plan: ClassPlan, name: str) -> list[str]:
        lines: list[str] = []
        for bit in plan.bits:
            if not covers(bit.allowed, 0, bit.mask):
                part = _part(name, bit.shift, bit.mask)
                lines += [f"part = {part}", *reject_if(outside(bit.allowed, "part", self._constants, 0, bit.mask))]
        return lines

    def _bits_value(self, plan: ClassPlan, name: str) -> str:
        parts = []
        for bit in plan.bits:
            part = _part(name, bit.shift, bit.mask)
            members = self._constants.members(bit.allowed.enum) if bit.allowed.enum else ""
            parts.append(f"{members}.get({part}, {part})" if members else part)
        if undefined_bits(plan):
            parts.append(f"{name} & 0x{undefined_bits(plan):X}")
        return f"{plan.path}({', '.join(parts)})"


def _part(name: str, shift: int, mask: int) -> str:
    return f"{name} >> {shift} & 0x{mask:X}" if shift else f"{name} & 0x{mask:X}"
