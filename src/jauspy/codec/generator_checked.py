"""Source that turns values into what `struct` packs, and checks what `struct` does not."""

from __future__ import annotations

from collections.abc import Iterable

from jauspy.codec.generator_fixed import Constants, covers, free, outside
from jauspy.codec.generator_locals import Locals
from jauspy.codec.generator_raw import reject_if
from jauspy.codec.plan import BitPlan, ClassPlan, ItemPlan, NumberPlan, ObjectPlan, SlotPlan, TextPlan
from jauspy.codec.scaling import NEAR_TIE, Scaling
from jauspy.codec.undefined import undefined_bits
from jauspy.codec.wire import FLOATS, limits

Source = tuple[list[str], list[str]]
"""Lines that check, and the raw values as expressions."""


class CheckedWriter:
    """Writes these sources for one method. What needs no check becomes an expression without a line of its own."""

    def __init__(self, constants: Constants, names: Locals) -> None:
        self._constants = constants
        self._locals = names

    def local(self, source: str, hint: str) -> tuple[list[str], str]:
        """A value as a local variable; one that is a variable already stays."""
        if source.isidentifier():
            return [], source
        name = self._locals.name(hint)
        return [f"{name} = {source}"], name

    def slots(self, slots: Iterable[SlotPlan], owner: str) -> Source:
        """Several slots of fixed size."""
        lines: list[str] = []
        values: list[str] = []
        for slot in slots:
            inner, found = self.flat(slot.item, f"{owner}.{slot.name}", slot.name)
            lines += inner
            values += found
        return lines, values

    def flat(self, item: ItemPlan, source: str, hint: str) -> Source:
        """One item of fixed size."""
        match item:
            case NumberPlan() if item.scaling is None and item.code not in FLOATS and free(item):
                return [], [source]
            case NumberPlan() if item.scaling:
                return self._real(item.scaling, *self.local(source, hint), hint)
            case NumberPlan():
                lines, name = self.local(source, hint)
                return [*lines, *self._checks(item, name)], [name]
            case TextPlan():
                raw = self._locals.name(f"{hint}_raw")
                return [f'{raw} = {source}.encode("latin-1")', *reject_if(f"len({raw}) > {item.length}")], [raw]
            case ObjectPlan():
                lines, name = self.local(source, hint)
                lines += reject_if(f"type({name}) is not {item.cls.path}")
                if item.cls.kind == "bits":
                    return self._bits(item.cls, lines, name)
                inner, values = self.slots(item.cls.slots, name)
                return [*lines, *inner], values
            case _:
                raise AssertionError(item)

    def _real(self, scale: Scaling, lines: list[str], name: str, hint: str) -> Source:
        lines += reject_if(f"not {scale.lower!r} <= {name} <= {scale.upper!r}")
        raw = self._locals.name(f"{hint}_raw")
        exact = f"{raw} = rt.exact_raw({name}, {self._constants.scaling(scale)})"
        if scale.function != "round" or scale.top > 0xFFFFFFFF:
            return [*lines, exact], [raw]
        base = f"({name} - {scale.lower!r})" if scale.lower > 0 else f"({name} + {-scale.lower!r})"
        return [
            *lines,
            f"near = {base if scale.lower else name} * {scale.factor!r} + 0.5",
            f"{raw} = int(near)",
            f"if not {NEAR_TIE!r} < near - {raw} < {1 - NEAR_TIE!r}: {exact}",
        ], [raw]

    def _checks(self, number: NumberPlan, name: str) -> list[str]:
        outside_set = reject_if(outside(number.allowed, name, self._constants)) if not number.allowed.anything else []
        if number.code in FLOATS:
            return [*reject_if(f"{name} - {name} != 0.0"), *outside_set]  # infinities and NaN
        return [] if free(number) else outside_set

    def _bits(self, plan: ClassPlan, lines: list[str], name: str) -> Source:
        parts = []
        for bit in plan.bits:
            checks, part = self.local(f"{name}.{bit.name}", bit.name)
            lines += [*checks, *self._bit_checks(bit, part)]
            parts.append(f"{part} << {bit.shift}" if bit.shift else part)
        undefined = undefined_bits(plan)
        if undefined:
            checks, rest = self.local(f"{name}.reserved_bits", "reserved_bits")
            named = limits(plan.code)[1] & ~undefined
            lines += [*checks, *(reject_if(f"{rest} & 0x{named:X}") if named else [])]
            parts.append(rest)
        return lines, [" | ".join(parts) or "0"]

    def _bit_checks(self, bit: BitPlan, part: str) -> list[str]:
        if covers(bit.allowed, 0, bit.mask):
            return reject_if(f"not 0 <= {part} <= {bit.mask}")
        return reject_if(outside(bit.allowed, part, self._constants))
