"""Source of the straight-line decoders: `_unpack` of messages, `_read` of what is inside them.

They accept valid bytes only and raise something out of `FAST_ERRORS` for all others. Attributes are set on an object
made by `rt.new`, which costs less than a constructor; local variables end in an underscore where they hold a field.
"""

from __future__ import annotations

import re

from jauspy.codec.generator_fixed import (
    Constants,
    bits_by_name,
    class_codes,
    fixed_codes,
    is_fixed_run,
    runs,
    size_of,
)
from jauspy.codec.generator_grid import grid_codes, grid_values, is_plain
from jauspy.codec.generator_locals import Locals, Position
from jauspy.codec.generator_raw import Raw, RawReader, one_expression, reject_if
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
from jauspy.codec.planner import minimum
from jauspy.codec.undefined import undefined_presence
from jauspy.codec.wire import CODES, SIZES, limits
from jauspy.schema.model import Count


def decode_method(plan: ClassPlan, constants: Constants) -> list[str]:
    """The lines of `_unpack` of a message, or `_read` of what is inside one; most of that is read in place."""
    if plan.kind == "message":
        lines = _Decoder(plan, constants, Position("", 2)).message()
        return ["@classmethod", "def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:", *indent(lines)]
    if plan.kind == "bits" or not plan.called:
        return []
    lines = _Decoder(plan, constants, Position("at", 0)).inner()
    head = "def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:"
    return ["@classmethod", head, *indent(lines)]


class _Decoder:
    def __init__(self, plan: ClassPlan, constants: Constants, position: Position) -> None:
        self.plan = plan
        self.constants = constants
        self.bits = bits_by_name(plan)
        self.locals = Locals()
        self.position = position
        self.raw = RawReader(constants, self.locals)

    def message(self) -> list[str]:
        assert self.plan.message is not None
        code = self.plan.message.code
        fixed = class_codes(self.plan)
        if fixed is not None:
            return self._fixed_message(code, fixed)
        if self.plan.presence and self._is_one_run():
            return self._masked_message(code)
        check = reject_if(f"data[0] != 0x{code & 255:02X} or data[1] != 0x{code >> 8:02X}")
        body = [*self._body(), *reject_if(f"{self.position.here()} != size")]
        return [*check, "size = len(data)", "self = rt.new(cls)", *body, "return self"]

    def inner(self) -> list[str]:
        if self.plan.kind == "choice":
            lines = self._choice()
        elif self.plan.kind == "format":
            lines = self._format()
        else:
            lines = self._body()
        sized = any(re.search(r"(?<![.\w])size\b", line) for line in lines)
        head = [*(["size = len(data)"] if sized else []), "self = rt.new(cls)"]
        return [*head, *lines, f"return self, {self.position.here()}"]

    def _is_one_run(self) -> bool:
        found = runs(self.plan.slots)
        return len(found) == 1 and is_fixed_run(found[0])

    def _fixed_message(self, code: int, codes: list[str]) -> list[str]:
        if not codes:
            return [*reject_if(f"data != {code.to_bytes(2, 'little')!r}"), "return rt.new(cls)"]
        raw = self._raw_slots(list(self.plan.slots), "self")
        packer = self.constants.packer("H" + "".join(codes))
        targets = ", ".join(["code", *raw.targets])
        return [
            "self = rt.new(cls)",
            f"{targets} = {packer}.unpack(data)",
            *reject_if(f"code != 0x{code:04X}"),
            *raw.lines,
            "return self",
        ]

    def _masked_message(self, code: int) -> list[str]:
        """Only numbers behind a presence vector: one `unpack` for each mask, exact in length."""
        presence = str(self.plan.presence)
        head = self.constants.packer("H" + presence)
        masks = self._masks(self.plan.path, f"{2 + SIZES[presence]}x", list(self.plan.slots))
        lines = [
            f"code, mask = {head}.unpack_from(data)",
            *reject_if(f"code != 0x{code:04X}"),
            f"raw = iter({masks}[mask & 0x{sum(self.bits.values()):X}].unpack(data)).__next__",
            "self = rt.new(cls)",
        ]
        for slot in self.plan.slots:
            lines += self._masked_slot(slot)
        return [*lines, *self._reserved(), "return self"]

    def _reserved(self) -> list[str]:
        undefined = undefined_presence(self.plan)
        return [f"self.reserved_presence = mask & 0x{undefined:X}"] if undefined else []

    def _masks(self, path: str, head: str, slots: list[SlotPlan]) -> str:
        there = [slot for slot in slots if self.bits.get(slot.name) != 0]
        codes = [(self.bits.get(slot.name, 0), code) for slot in there for code in fixed_codes(slot.item) or []]
        return self.constants.masks(path, head, codes)

    def _masked_slot(self, slot: SlotPlan) -> list[str]:
        target = f"self.{slot.name}"
        bit = self.bits.get(slot.name)
        if bit is None:
            return self._next_raw(slot, target)
        if not bit:
            return [f"{target} = None"]
        value = one_expression(slot.item, "raw()")
        if value is not None:
            return [f"{target} = {value} if mask & {bit} else None"]
        return [f"if mask & {bit}:", *indent(self._next_raw(slot, target)), f"else: {target} = None"]

    def _next_raw(self, slot: SlotPlan, target: str) -> list[str]:
        raw = self.raw.into(slot.item, slot.name, target)
        return [*(f"{name} = raw()" for name in raw.targets), *raw.lines]

    def _body(self) -> list[str]:
        lines = self._number(str(self.plan.presence), "mask") if self.plan.presence else []
        for number, run in enumerate(runs(self.plan.slots)):
            lines += self._run(run, number) if is_fixed_run(run) else self._single(run[0])
        return [*lines, *self._reserved()]

    def _number(self, code: str, name: str) -> list[str]:
        """A single unsigned number."""
        here = self.position.here()
        self.position.skip(SIZES[code])
        if code == "B":
            return [f"{name} = data[{here}]"]
        return [f"({name},) = {self.constants.packer(code)}.unpack_from(data, {here})"]

    def _run(self, run: list[SlotPlan], number: int) -> list[str]:
        if not any(slot.optional for slot in run):
            return self._unpack_slots(run, "self")
        bits = sum(self.bits[slot.name] for slot in run if slot.optional)
        masks = self._masks(f"{self.plan.path}_{number}", "", run)
        here = self.position.here()
        lines = [f"packer = {masks}[mask & 0x{bits:X}]", f"raw = iter(packer.unpack_from(data, {here})).__next__"]
        lines.append("at += packer.size" if here == "at" else f"at = {here} + packer.size")
        self.position.settled()
        for slot in run:
            lines += self._masked_slot(slot)
        return lines

    def _raw_slots(self, slots: list[SlotPlan], owner: str) -> Raw:
        """All raw values of some slots, and the lines that turn them into attributes."""
        targets: list[str] = []
        lines: list[str] = []
        for slot in slots:
            raw = self.raw.into(slot.item, slot.name, f"{owner}.{slot.name}")
            targets += raw.targets
            lines += raw.lines
        return Raw(targets, lines)

    def _unpack_slots(self, slots: list[SlotPlan], owner: str) -> list[str]:
        raw = self._raw_slots(slots, owner)
        codes = [code for slot in slots for code in fixed_codes(slot.item) or []]
        return [*self._unpack(codes, raw.targets), *raw.lines]

    def _unpack(self, codes: list[str], targets: list[str]) -> list[str]:
        if not codes:
            return []
        here = self.position.here()
        if len(codes) <= 3 and set(codes) == {"B"}:  # indexing costs less than a call
            places = [self.position.here(number) for number in range(len(codes))]
            self.position.skip(len(codes))
            return [f"{target} = data[{place}]" for target, place in zip(targets, places, strict=True)]
        self.position.skip(size_of(codes))
        names = f"({targets[0]},)" if len(targets) == 1 else ", ".join(targets)
        return [f"{names} = {self.constants.packer(''.join(codes))}.unpack_from(data, {here})"]

    def _single(self, slot: SlotPlan) -> list[str]:
        target = f"self.{slot.name}"
        bit = self.bits.get(slot.name)
        if bit is None:
            return self._item(slot.item, slot.name, target)
        if not bit:
            return [f"{target} = None"]
        before = self.position.settle()
        lines = [*self._item(slot.item, slot.name, target), *self.position.settle()]
        return [*before, f"if mask & {bit}:", *indent(lines), f"else: {target} = None"]

    def _item(self, item: ItemPlan, hint: str, target: str) -> list[str]:
        codes = fixed_codes(item)
        if codes:
            raw = self.raw.into(item, hint, target)
            return [*self._unpack(codes, raw.targets), *raw.lines]
        match item:
            case TextPlan() if item.count:
                lines, chunk = self._chunk(item.count, hint)
                return [*lines, f'{target} = {chunk}.decode("latin-1")']
            case TextPlan():
                return [f'{target} = ""']
            case BlobPlan():
                lines, chunk = self._chunk(item.count, hint)
                return [*lines, f"{target} = {_inside(chunk) if item.is_message else chunk}"]
            case ObjectPlan() if item.cls.kind == "composite" and not item.cls.presence:
                return self._inline(item.cls, hint, target)
            case ObjectPlan():
                return [*self.position.settle(), f"{target}, at = {item.cls.path}._read(data, at, nesting)"]
            case UnionPlan():
                arms = self.constants.arms([arm.path for arm in item.arms])
                read = f"{target}, at = {arms}[tag]._read(data, at, nesting)"
                return [*self._number(item.code, "tag"), *self.position.settle(), read]
            case RepeatPlan():
                return self._repeat(item, hint, target)
            case GridPlan() if is_plain(item):
                return self._grid(item, hint, target)
            case GridPlan():
                inner = GridPlan(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
                return self._loop(inner, hint, str(item.sizes[0]), target)
            case _:
                raise AssertionError(item)

    def _inline(self, plan: ClassPlan, hint: str, target: str) -> list[str]:
        """A composite without presence vector, read in place: calls cost as much as a small record."""
        owner = target if target.isidentifier() else self.locals.name(hint)
        lines = [f"{target} = {f'{owner} = ' if owner != target else ''}rt.new({plan.path})"]
        for run in runs(plan.slots):
            if is_fixed_run(run):
                lines += self._unpack_slots(run, owner)
            else:
                lines += self._item(run[0].item, run[0].name, f"{owner}.{run[0].name}")
        return lines

    def _count(self, count: Count, name: str) -> list[str]:
        code = CODES[count.type]
        low = f"{name} < {count.minimum}" if count.minimum else ""
        high = f"{name} > {count.maximum}" if count.maximum < limits(code)[1] else ""
        checks = reject_if(" or ".join(part for part in (low, high) if part)) if low or high else []
        return [*self._number(code, name), *checks]

    def _chunk(self, count: Count, hint: str) -> tuple[list[str], str]:
        """Lines that read a count and find the end, and the counted bytes as an expression.

        Nothing checks that the end is within the data: a slice makes do with less, every read after it fails, and at
        the latest the message finds that it does not end where the data does.
        """
        end = self.locals.name(f"{hint}_end")
        lines = self._count(count, end)
        start = self.position.here()
        self.position.move(end)
        if len(lines) == 1 and CODES[count.type] == "B":
            lines = [f"{end} = {start} + {lines[0].partition(' = ')[2]}"]
        else:
            lines.append(f"{end} += {start}")
        return lines, f"data[{start}:{end}]"

    def _repeat(self, item: RepeatPlan, hint: str, target: str) -> list[str]:
        counted = self.locals.name(f"{hint}_count")
        lines = self._count(item.count, counted)
        codes = fixed_codes(item.item)
        if codes and isinstance(item.item, ObjectPlan):
            return [*lines, *self._table(item.item, codes, hint, counted, target)]
        guard = reject_if(f"{counted} * {minimum(item.item)} > size - {self.position.parenthesized()}")
        return [*lines, *guard, *self._loop(item.item, hint, counted, target)]

    def _table(self, item: ObjectPlan, codes: list[str], hint: str, counted: str, target: str) -> list[str]:
        """Elements of fixed size: one call unpacks them all."""
        start, end = self.position.here(), self.locals.name(f"{hint}_end")
        self.position.move(end)
        names, lines, argument = self.raw.flat(item, hint)
        targets = f"({names[0]},)" if len(names) == 1 else ", ".join(names)
        if len(codes) == 1 and codes[0] in SIZES:
            targets, rows = names[0], f"{self.constants.rows(codes[0])}[{counted}].unpack_from(data, {start})"
        else:
            rows = f"{self.constants.packer(''.join(codes))}.iter_unpack(data[{start}:{end}])"
        head = [f"{end} = {start} + {counted} * {size_of(codes)}"]
        if not lines:
            return [*head, f"{target} = [{argument} for {targets} in {rows}]"]
        made = self.locals.name(hint)
        body = indent([*lines, f"{made}.append({argument})"])
        return [*head, f"{made} = []", f"for {targets} in {rows}:", *body, f"{target} = {made}"]

    def _loop(self, item: ItemPlan, hint: str, counted: str, target: str) -> list[str]:
        made = self.locals.name(hint)
        one = self.locals.name("item")
        before = self.position.settle()
        body = [*self._item(item, "item", one), *self.position.settle(), f"{made}.append({one})"]
        return [*before, f"{made} = []", f"for _ in range({counted}):", *indent(body), f"{target} = {made}"]

    def _grid(self, item: GridPlan, hint: str, target: str) -> list[str]:
        """Numbers: one call unpacks them all."""
        raw, here = self.locals.name(hint), self.position.here()
        self.position.skip(size_of(grid_codes(item)))
        packer = self.constants.packer("".join(grid_codes(item)))
        return [f"{raw} = {packer}.unpack_from(data, {here})", *grid_values(item, raw, target)]

    def _choice(self) -> list[str]:
        lines = ["choice = data[at]"]
        for number, (index, plan) in enumerate(self.plan.choices):
            self.position.settled()
            self.position.skip(1)
            raw = self.raw.into(plan, "value", "self.value")
            body = [*self._unpack([plan.code], raw.targets), *raw.lines, *self.position.settle()]
            lines += [f"{'el' if number else ''}if choice == {index}:", *indent(body)]
        lines += ["else: raise rt.Reject"]
        enum = self.plan.allowed.enum
        return [*lines, f"self.choice = {f'{self.constants.members(enum)}[choice]' if enum else 'choice'}"]

    def _format(self) -> list[str]:
        assert self.plan.count is not None
        enum = self.plan.allowed.enum
        lines = [
            "format = data[at]",
            f"self.format = {f'{self.constants.members(enum)}[format]' if enum else 'format'}",
        ]
        self.position.skip(1)
        found, chunk = self._chunk(self.plan.count, "data")
        lines += found
        if not self.plan.message_formats:
            return [*lines, f"self.data = {chunk}"]
        chosen = f"format in {set(self.plan.message_formats)}"
        return [*lines, f"self.data = {_inside(chunk)} if {chosen} else {chunk}"]


def _inside(chunk: str) -> str:
    """A message inside this one, of the registry that decodes this one, else of the one this class is of."""
    return f"(nesting or _registry.nesting).message({chunk})"
