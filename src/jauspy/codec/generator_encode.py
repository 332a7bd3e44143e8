"""Source of the straight-line encoders: `_pack` of messages, `_write` of what is inside them.

They check what `struct` does not, and raise something out of `FAST_ERRORS` for every value that does not fit.
"""

from __future__ import annotations

from jauspy.codec.generator_checked import CheckedWriter
from jauspy.codec.generator_fixed import Constants, bits_by_name, class_codes, fixed_codes, is_fixed_run, runs
from jauspy.codec.generator_grid import finite, grid_codes, is_plain
from jauspy.codec.generator_locals import Locals
from jauspy.codec.generator_raw import reject_if
from jauspy.codec.generator_text import indent
from jauspy.codec.plan import (
    BlobPlan,
    ClassPlan,
    GridPlan,
    ItemPlan,
    ObjectPlan,
    RepeatPlan,
    SlotPlan,
    TextPlan,
    UnionPlan,
)
from jauspy.codec.undefined import undefined_presence
from jauspy.codec.wire import CODES, SIZES, limits
from jauspy.schema.model import Count


def encode_method(plan: ClassPlan, constants: Constants) -> list[str]:
    """The lines of `_pack` of a message, or `_write` of what is inside one; most of that is written in place."""
    if plan.kind == "message":
        return ["def _pack(self) -> bytes:", *indent(_Encoder(plan, constants).message())]
    if plan.kind == "bits" or not plan.called:
        return []
    return ["def _write(self, out: bytearray) -> None:", *indent(_Encoder(plan, constants).inner())]


class _Encoder:
    def __init__(self, plan: ClassPlan, constants: Constants) -> None:
        self.plan = plan
        self.constants = constants
        self.bits = bits_by_name(plan)
        self.locals = Locals()
        self.checked = CheckedWriter(constants, self.locals)

    def message(self) -> list[str]:
        assert self.plan.message is not None
        code = self.plan.message.code
        fixed = class_codes(self.plan)
        if fixed is not None:
            lines, values = self.checked.slots(self.plan.slots, "self")
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
        return ["mask = self.reserved_presence", *(reject_if(f"mask & 0x{defined:X}") if defined else [])]

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
        if not slot.optional:
            lines, values = self.checked.flat(slot.item, f"self.{slot.name}", slot.name)
            return [*lines, *(f"raw.append({value})" for value in values)]
        name = self.locals.name(slot.name)
        lines, values = self.checked.flat(slot.item, name, slot.name)
        return self._optional(slot, name, [*lines, *(f"raw.append({value})" for value in values)])

    def _optional(self, slot: SlotPlan, name: str, body: list[str]) -> list[str]:
        start = f"{name} = self.{slot.name}"
        bit = self.bits[slot.name]
        if not bit:
            return [start, *reject_if(f"{name} is not None")]
        return [start, f"if {name} is not None:", f"    mask |= {bit}", *indent(body)]

    def _body(self) -> list[str]:
        lines: list[str] = []
        presence = self.plan.presence
        if presence:
            zeros = "\\0" * SIZES[presence]
            lines += ["start = len(out)", f'out += b"{zeros}"', *self._mask_start()]
        declared = False
        for number, run in enumerate(runs(self.plan.slots)):
            if not is_fixed_run(run):
                lines += self._single(run[0])
            elif any(slot.optional for slot in run):
                lines += self._masked_run(
                    run, number, "raw = []" if declared else "raw: list[int | float | bytes] = []"
                )
                declared = True
            else:
                lines += self._run(run, "self")
        if presence:
            lines.append(f"{self.constants.packer(presence)}.pack_into(out, start, mask)")
        return lines

    def _masked_run(self, run: list[SlotPlan], number: int, start: str) -> list[str]:
        lines = [start]
        for slot in run:
            lines += self._masked_slot(slot)
        bits = sum(self.bits[slot.name] for slot in run if slot.optional)
        masks = self._masks(f"{self.plan.path}_{number}", "", run)
        return [*lines, f"out += {masks}[mask & 0x{bits:X}].pack(*raw)"]

    def _run(self, run: list[SlotPlan], owner: str) -> list[str]:
        lines, values = self.checked.slots(run, owner)
        codes = [code for slot in run for code in fixed_codes(slot.item) or []]
        return [*lines, *self._append(codes, values)]

    def _append(self, codes: list[str], values: list[str]) -> list[str]:
        if len(codes) <= 3 and set(codes) == {"B"}:  # costs less than to pack them
            return [f"out.append({value})" for value in values]
        return [f"out += {self.constants.packer(''.join(codes))}.pack({', '.join(values)})"] if values else []

    def _single(self, slot: SlotPlan) -> list[str]:
        if not slot.optional:
            return self._item(slot.item, f"self.{slot.name}", slot.name)
        name = self.locals.name(slot.name)
        return self._optional(slot, name, self._item(slot.item, name, slot.name))

    def _item(self, item: ItemPlan, source: str, hint: str) -> list[str]:
        codes = fixed_codes(item)
        if codes:
            lines, values = self.checked.flat(item, source, hint)
            return [*lines, *self._append(codes, values)]
        match item:
            case TextPlan() if item.count:
                return self._bytes(item.count, f'{source}.encode("latin-1")', hint)
            case TextPlan():
                return reject_if(f'{source} != ""')
            case BlobPlan():
                kind = "message" if item.is_message else "plain"
                return self._bytes(item.count, f"rt.{kind}_bytes({source})", hint)
            case GridPlan() if is_plain(item) and len(item.sizes) == 1:
                lines, name = self.checked.local(source, hint)
                checks = reject_if(f"type({name}) is not list or len({name}) != {item.sizes[0]}")
                return [*lines, *checks, *finite(item, name), *self._append(grid_codes(item), [f"*{name}"])]
            case GridPlan():
                inner = GridPlan(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
                return self._grid(inner, item.sizes[0], *self.checked.local(source, hint))
            case ObjectPlan():
                return self._object(item.cls, *self.checked.local(source, hint))
            case UnionPlan():
                return self._union(item, *self.checked.local(source, hint))
            case RepeatPlan():
                lines, name = self.checked.local(source, hint)
                head = [*lines, *reject_if(f"type({name}) is not list"), *self._counted(item.count, name)]
                return [*head, *(self._numbers(item.item, name) or self._loop(item.item, name))]
            case _:
                raise AssertionError(item)

    def _bytes(self, count: Count, source: str, hint: str) -> list[str]:
        raw = self.locals.name(f"{hint}_raw")
        return [f"{raw} = {source}", *self._counted(count, raw), f"out += {raw}"]

    def _object(self, plan: ClassPlan, lines: list[str], name: str) -> list[str]:
        """A composite without presence vector is written in place."""
        lines += reject_if(f"type({name}) is not {plan.path}")
        if plan.kind != "composite" or plan.presence:
            return [*lines, f"{name}._write(out)"]
        for run in runs(plan.slots):
            if is_fixed_run(run):
                lines += self._run(run, name)
            else:
                lines += self._item(run[0].item, f"{name}.{run[0].name}", run[0].name)
        return lines

    def _grid(self, item: ItemPlan, size: int, lines: list[str], name: str) -> list[str]:
        check = reject_if(f"type({name}) is not list or len({name}) != {size}")
        return [*lines, *check, *self._loop(item, name)]

    def _union(self, item: UnionPlan, lines: list[str], name: str) -> list[str]:
        tag = f"{self.constants.tags([arm.path for arm in item.arms])}[type({name})]"
        return [*lines, *self._append([item.code], [tag]), f"{name}._write(out)"]

    def _counted(self, count: Count, name: str) -> list[str]:
        code = CODES[count.type]
        low = f"len({name}) < {count.minimum}" if count.minimum else ""
        high = f"len({name}) > {count.maximum}" if count.maximum < limits(code)[1] else ""
        checks = reject_if(" or ".join(part for part in (low, high) if part)) if low or high else []
        return [*checks, *self._append([code], [f"len({name})"])]

    def _loop(self, item: ItemPlan, name: str) -> list[str]:
        one = self.locals.name("item")
        return [f"for {one} in {name}:", *indent(self._item(item, one, "item"))]

    def _numbers(self, item: ItemPlan, name: str) -> list[str]:
        """Elements that are numbers of one type: one call packs them all. Nothing for other elements."""
        codes = fixed_codes(item) or []
        if len(set(codes)) != 1 or codes[0] not in SIZES:
            return []
        one, raw = self.locals.name("item"), self.locals.name("raw")
        lines, values = self.checked.flat(item, one, "item")
        collect = f"{raw}.append({values[0]})" if len(values) == 1 else f"{raw} += ({', '.join(values)})"
        loop = [f"for {one} in {name}:", *indent([*lines, collect])]
        return [
            f"{raw}: list[int | float] = []",
            *loop,
            f"out += {self.constants.rows(codes[0])}[len({raw})].pack(*{raw})",
        ]

    def _choice(self) -> list[str]:
        lines = ["choice = self.choice"]
        for number, (index, plan) in enumerate(self.plan.choices):
            inner, values = self.checked.flat(plan, "self.value", "value")
            body = [*inner, f"out += {self.constants.packer(f'B{plan.code}')}.pack(choice, {values[0]})"]
            lines += [f"{'el' if number else ''}if choice == {index}:", *indent(body)]
        return [*lines, "else: raise rt.Reject"]

    def _format(self) -> list[str]:
        assert self.plan.count is not None
        lines = ["format = self.format"]
        if self.plan.allowed.enum:
            lines += reject_if(f"format not in {self.constants.members(self.plan.allowed.enum)}")
        source = "rt.plain_bytes(self.data)"
        if self.plan.message_formats:
            source = f"rt.message_bytes(self.data) if format in {set(self.plan.message_formats)} else {source}"
        return [*lines, "out.append(format)", *self._bytes(self.plan.count, source, "data")]
