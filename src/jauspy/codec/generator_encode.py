"""Source of the straight-line encoders: `_pack` of messages, `_write` of what is inside them.

They check what `struct` does not, and raise something out of `FAST_ERRORS` for every value that does not fit.
"""

from __future__ import annotations

from jauspy.codec.generator_fixed import (
    Constants,
    bits_by_name,
    class_codes,
    covers,
    fixed_codes,
    free,
    is_fixed_run,
    outside,
    runs,
)
from jauspy.codec.generator_text import indent
from jauspy.codec.plan import (
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
from jauspy.codec.scaling import NEAR_TIE, Scaling
from jauspy.codec.undefined import undefined_bits, undefined_presence
from jauspy.codec.wire import CODES, FLOATS, SIZES, limits
from jauspy.schema.model import Count

REJECT = "raise rt.Reject"


def encode_method(plan: ClassPlan, constants: Constants) -> list[str]:
    """The lines of `_pack` of a message, or `_write` of what is inside one; bit fields are written in place."""
    if plan.kind == "bits":
        return []
    encoder = _Encoder(plan, constants)
    if plan.kind == "message":
        return ["def _pack(self) -> bytes:", *indent(encoder.message())]
    return ["def _write(self, out: bytearray) -> None:", *indent(encoder.inner())]


class _Encoder:
    def __init__(self, plan: ClassPlan, constants: Constants) -> None:
        self.plan = plan
        self.constants = constants
        self.bits = bits_by_name(plan)

    def message(self) -> list[str]:
        assert self.plan.message is not None
        code = self.plan.message.code
        fixed = class_codes(self.plan)
        if fixed is not None:
            lines, values = self._flat_slots(list(self.plan.slots))
            packer = self.constants.packer("H" + "".join(fixed))
            return [*lines, f"return {packer}.pack({', '.join([f'0x{code:04X}', *values])})"]
        if self.plan.presence and len(runs(self.plan.slots)) == 1 and is_fixed_run(list(self.plan.slots)):
            return self._masked_message(code)
        head = f'out = bytearray(b"\\x{code & 255:02x}\\x{code >> 8:02x}")'
        return [head, *self._body(), "return bytes(out)"]

    def inner(self) -> list[str]:
        if self.plan.kind == "choice":
            return self._choice()
        if self.plan.kind == "format":
            return self._format()
        return self._body() or ["return"]

    def _mask_start(self) -> list[str]:
        undefined = undefined_presence(self.plan)
        if not undefined:
            return ["mask = 0"]
        defined = limits(str(self.plan.presence))[1] & ~undefined
        return ["mask = self.reserved_presence", *(_if(f"mask & 0x{defined:X}") if defined else [])]

    def _masked_message(self, code: int) -> list[str]:
        presence = str(self.plan.presence)
        lines = [*self._mask_start(), "raw: list[int | float | bytes] = []"]
        for slot in self.plan.slots:
            lines += self._masked_slot(slot)
        masks = self._masks(f"{self.plan.path}_pack", "H" + presence, list(self.plan.slots))
        return [*lines, f"return {masks}[mask & 0x{sum(self.bits.values()):X}].pack(0x{code:04X}, mask, *raw)"]

    def _masks(self, path: str, head: str, slots: list[SlotPlan]) -> str:
        there = [slot for slot in slots if self.bits.get(slot.name) != 0]
        codes = [(self.bits.get(slot.name, 0), code) for slot in there for code in fixed_codes(slot.item) or []]
        return self.constants.masks(path, head, codes)

    def _masked_slot(self, slot: SlotPlan) -> list[str]:
        name = f"{slot.name}_"
        lines, values = self._flat(slot.item, name)
        body = [*lines, *(f"raw.append({value})" for value in values)]
        return self._optional(slot, body)

    def _optional(self, slot: SlotPlan, body: list[str]) -> list[str]:
        name = f"{slot.name}_"
        start = f"{name} = self.{slot.name}"
        bit = self.bits.get(slot.name)
        if bit is None:
            return [start, *body]
        if not bit:
            return [start, *_if(f"{name} is not None")]
        return [start, f"if {name} is not None:", f"    mask |= {bit}", *indent(body)]

    def _body(self) -> list[str]:
        lines: list[str] = []
        presence = self.plan.presence
        if presence:
            zeros = "\\0" * SIZES[presence]
            lines += ["start = len(out)", f'out += b"{zeros}"', *self._mask_start()]
        for number, run in enumerate(runs(self.plan.slots)):
            lines += self._run(run, number) if is_fixed_run(run) else self._single(run[0])
        if presence:
            lines.append(f"{self.constants.packer(presence)}.pack_into(out, start, mask)")
        return lines

    def _run(self, run: list[SlotPlan], number: int) -> list[str]:
        if not any(slot.optional for slot in run):
            lines, values = self._flat_slots(run)
            codes = "".join(code for slot in run for code in fixed_codes(slot.item) or [])
            return [*lines, *([f"out += {self.constants.packer(codes)}.pack({', '.join(values)})"] if values else [])]
        lines = ["raw: list[int | float | bytes] = []" if number == 0 else "raw = []"]
        for slot in run:
            lines += self._masked_slot(slot)
        bits = sum(self.bits[slot.name] for slot in run if slot.optional)
        masks = self._masks(f"{self.plan.path}_{number}", "", run)
        return [*lines, f"out += {masks}[mask & 0x{bits:X}].pack(*raw)"]

    def _single(self, slot: SlotPlan) -> list[str]:
        return self._optional(slot, self._item(slot.item, f"{slot.name}_"))

    def _flat_slots(self, slots: list[SlotPlan], prefix: str = "", source: str = "self") -> tuple[list[str], list[str]]:
        lines: list[str] = []
        values: list[str] = []
        for slot in slots:
            name = f"{prefix}{slot.name}_"
            inner, found = self._flat(slot.item, name)
            lines += [f"{name} = {source}.{slot.name}", *inner]
            values += found
        return lines, values

    def _flat(self, item: ItemPlan, name: str) -> tuple[list[str], list[str]]:
        """Lines that check the value called `name`, and the raw values to pack."""
        match item:
            case NumberPlan() if item.scaling:
                return self._real(item.scaling, name)
            case NumberPlan():
                return self._checks(item, name), [name]
            case TextPlan():
                raw = f"{name}raw"
                return [f'{raw} = {name}.encode("latin-1")', *_if(f"len({raw}) > {item.length}")], [raw]
            case ObjectPlan() if item.cls.kind == "bits":
                return self._packed_bits(item.cls, name)
            case ObjectPlan():
                lines = _if(f"type({name}) is not {item.cls.path}")
                values: list[str] = []
                for slot in item.cls.slots:
                    inner = f"{name}{slot.name}_"
                    more, found = self._flat(slot.item, inner)
                    lines += [f"{inner} = {name}.{slot.name}", *more]
                    values += found
                return lines, values
            case _:
                raise AssertionError(item)

    def _real(self, scale: Scaling, name: str) -> tuple[list[str], list[str]]:
        lines = _if(f"not {scale.lower!r} <= {name} <= {scale.upper!r}")
        raw = f"{name}raw"
        constant = self.constants.scaling(scale)
        if scale.function != "round" or scale.top > 0xFFFFFFFF:
            return [*lines, f"{raw} = rt.exact_raw({name}, {constant})"], [raw]
        base = f"({name} - {scale.lower!r})" if scale.lower > 0 else f"({name} + {-scale.lower!r})"
        near = f"not {NEAR_TIE!r} < {name}pos - {raw} < {1 - NEAR_TIE!r}"
        return [
            *lines,
            f"{name}pos = {base if scale.lower else name} * {scale.factor!r} + 0.5",
            f"{raw} = int({name}pos)",
            f"if {near}:",
            f"    {raw} = rt.exact_raw({name}, {constant})",
        ], [raw]

    def _checks(self, number: NumberPlan, name: str) -> list[str]:
        if number.code in FLOATS:
            lines = _if(f"{name} - {name} != 0.0")  # infinities and NaN
            return lines + (_if(outside(number.allowed, name, self.constants)) if not number.allowed.anything else [])
        return [] if free(number) else _if(outside(number.allowed, name, self.constants))

    def _packed_bits(self, plan: ClassPlan, name: str) -> tuple[list[str], list[str]]:
        lines = _if(f"type({name}) is not {plan.path}")
        parts = []
        for bit in plan.bits:
            part = f"{name}{bit.name}_"
            lines += [f"{part} = {name}.{bit.name}", *self._bit_checks(bit, part)]
            parts.append(f"{part} << {bit.shift}" if bit.shift else part)
        undefined = undefined_bits(plan)
        if undefined:
            lines += [f"{name}rest = {name}.reserved_bits"]
            named = limits(plan.code)[1] & ~undefined
            lines += _if(f"{name}rest & 0x{named:X}") if named else []
            parts.append(f"{name}rest")
        return lines, [" | ".join(parts) or "0"]

    def _bit_checks(self, bit: BitPlan, part: str) -> list[str]:
        if covers(bit.allowed, 0, bit.mask):
            return _if(f"not 0 <= {part} <= {bit.mask}")
        return _if(outside(bit.allowed, part, self.constants))

    def _item(self, item: ItemPlan, name: str) -> list[str]:
        codes = fixed_codes(item)
        if codes:
            lines, values = self._flat(item, name)
            return [*lines, f"out += {self.constants.packer(''.join(codes))}.pack({', '.join(values)})"]
        match item:
            case TextPlan() if item.count:
                raw = f"{name}raw"
                return [f'{raw} = {name}.encode("latin-1")', *self._counted(item.count, raw), f"out += {raw}"]
            case TextPlan():
                return _if(f'{name} != ""')
            case BlobPlan():
                raw = f"{name}raw"
                source = f"rt.message_bytes({name})" if item.is_message else f"rt.plain_bytes({name})"
                return [f"{raw} = {source}", *self._counted(item.count, raw), f"out += {raw}"]
            case ObjectPlan() if item.cls.kind == "composite" and not item.cls.presence:
                return self._inline(item.cls, name)
            case ObjectPlan():
                return [*_if(f"type({name}) is not {item.cls.path}"), f"{name}._write(out)"]
            case UnionPlan():
                return self._union(item, name)
            case RepeatPlan():
                lines = [*_if(f"type({name}) is not list"), *self._counted(item.count, name)]
                return [*lines, *self._loop(item.item, name)]
            case GridPlan():
                inner = GridPlan(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
                head = _if(f"type({name}) is not list or len({name}) != {item.sizes[0]}")
                return [*head, *self._loop(inner, name)]
            case _:
                raise AssertionError(item)

    def _inline(self, plan: ClassPlan, name: str) -> list[str]:
        """A composite without presence vector, written in place."""
        lines = _if(f"type({name}) is not {plan.path}")
        for run in runs(plan.slots):
            if is_fixed_run(run):
                inner, values = self._flat_slots(run, name, name)
                codes = "".join(code for slot in run for code in fixed_codes(slot.item) or [])
                lines += [
                    *inner,
                    *([f"out += {self.constants.packer(codes)}.pack({', '.join(values)})"] if values else []),
                ]
            else:
                inner_name = f"{name}{run[0].name}_"
                lines += [f"{inner_name} = {name}.{run[0].name}", *self._item(run[0].item, inner_name)]
        return lines

    def _counted(self, count: Count, name: str) -> list[str]:
        code = CODES[count.type]
        low = f"len({name}) < {count.minimum}" if count.minimum else ""
        high = f"len({name}) > {count.maximum}" if count.maximum < limits(code)[1] else ""
        checks = _if(" or ".join(part for part in (low, high) if part)) if low or high else []
        append = (
            f"out.append(len({name}))" if code == "B" else f"out += {self.constants.packer(code)}.pack(len({name}))"
        )
        return [*checks, append]

    def _loop(self, item: ItemPlan, name: str) -> list[str]:
        inner = f"{name}item_"
        return [f"for {inner} in {name}:", *indent(self._item(item, inner))]

    def _union(self, item: UnionPlan, name: str) -> list[str]:
        kind = f"{name}kind"
        lines = [f"{kind} = type({name})"]
        for number, arm in enumerate(item.arms):
            tag = (
                f"out.append({number})"
                if item.code == "B"
                else f"out += {self.constants.packer(item.code)}.pack({number})"
            )
            lines += [f"{'el' if number else ''}if {kind} is {arm.path}:", f"    {tag}"]
        return [*lines, "else:", f"    {REJECT}", f"{name}._write(out)"]

    def _choice(self) -> list[str]:
        lines = ["choice = self.choice", "value_ = self.value"]
        for number, (index, plan) in enumerate(self.plan.choices):
            inner, values = self._flat(plan, "value_")
            packer = self.constants.packer("B" + plan.code)
            body = [*inner, f"out += {packer}.pack(choice, {values[0]})"]
            lines += [f"{'el' if number else ''}if choice == {index}:", *indent(body)]
        return [*lines, "else:", f"    {REJECT}"]

    def _format(self) -> list[str]:
        assert self.plan.count is not None
        lines = ["format = self.format"]
        if self.plan.allowed.enum:
            lines += _if(f"format not in {self.constants.members(self.plan.allowed.enum)}")
        if self.plan.message_formats:
            chosen = " or ".join(f"format == {number}" for number in self.plan.message_formats)
            lines.append(f"raw = rt.message_bytes(self.data) if {chosen} else rt.plain_bytes(self.data)")
        else:
            lines.append("raw = rt.plain_bytes(self.data)")
        return [*lines, "out.append(format)", *self._counted(self.plan.count, "raw"), "out += raw"]


def _if(condition: str) -> list[str]:
    return [f"if {condition}:", f"    {REJECT}"]
