"""Source of the straight-line decoders: `_unpack` of messages, `_read` of what is inside them.

They accept valid bytes only and raise something out of `FAST_ERRORS` for all others. Local variables end in an
underscore where they hold a field.
"""

from __future__ import annotations

import re

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
    size_of,
)
from jauspy.codec.generator_text import annotation, indent, needs_keywords
from jauspy.codec.plan import (
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
from jauspy.codec.planner import minimum
from jauspy.codec.undefined import undefined_bits, undefined_presence
from jauspy.codec.wire import CODES, FLOATS, SIZES, limits
from jauspy.schema.model import Count

REJECT = "raise rt.Reject"


def decode_method(plan: ClassPlan, constants: Constants) -> list[str]:
    """The lines of `_unpack` of a message, or `_read` of what is inside one; bit fields are read in place."""
    if plan.kind == "bits":
        return []
    writer = _Decoder(plan, constants)
    if plan.kind == "message":
        return ["@classmethod", "def _unpack(cls, data: bytes, depth: int) -> Self:", *indent(writer.message())]
    head = "def _read(cls, data: bytes, at: int, depth: int) -> tuple[Self, int]:"
    return ["@classmethod", head, *indent(writer.inner())]


class _Decoder:
    def __init__(self, plan: ClassPlan, constants: Constants) -> None:
        self.plan = plan
        self.constants = constants
        self.bits = bits_by_name(plan)
        self.counter = 0

    def message(self) -> list[str]:
        assert self.plan.message is not None
        code = self.plan.message.code
        fixed = class_codes(self.plan)
        if fixed is not None:
            names, lines, arguments = self._flat_slots(list(self.plan.slots))
            packer = self.constants.packer("H" + "".join(fixed))
            targets = ", ".join(["code", *names]) + ("," if not names else "")
            return [
                f"{targets} = {packer}.unpack(data)",
                *_if(f"code != 0x{code:04X}"),
                *lines,
                self._return(arguments),
            ]
        if self.plan.presence and self._is_one_run():
            return self._masked_message(code)
        body = self._body()
        check = _if(f"data[0] != 0x{code & 255:02X} or data[1] != 0x{code >> 8:02X}")
        return [*check, "at = 2", *self._sized(body), *_if("at != len(data)"), self._return(self._arguments())]

    def inner(self) -> list[str]:
        if self.plan.kind == "choice":
            return self._choice()
        if self.plan.kind == "format":
            return self._format()
        return [*self._sized(self._body()), self._return(self._arguments(), "at")]

    @staticmethod
    def _sized(body: list[str]) -> list[str]:
        return (["size = len(data)"] if any(re.search(r"(?<![.\w])size\b", line) for line in body) else []) + body

    def _is_one_run(self) -> bool:
        found = runs(self.plan.slots)
        return len(found) == 1 and is_fixed_run(found[0])

    def _masked_message(self, code: int) -> list[str]:
        """Only numbers behind a presence vector: one `unpack` for each mask, exact in length."""
        presence = str(self.plan.presence)
        head = self.constants.packer("H" + presence)
        lines = [f"code, mask = {head}.unpack_from(data)", *_if(f"code != 0x{code:04X}")]
        masks = self._masks(self.plan.path, f"{2 + SIZES[presence]}x", list(self.plan.slots))
        lines.append(f"raw = iter({masks}[mask & 0x{self._optional_bits():X}].unpack(data)).__next__")
        for slot in self.plan.slots:
            lines += self._masked_slot(slot)
        return [*lines, self._return(self._arguments())]

    def _optional_bits(self) -> int:
        return sum(self.bits.values())

    def _masks(self, path: str, head: str, slots: list[SlotPlan]) -> str:
        there = [slot for slot in slots if self.bits.get(slot.name) != 0]
        codes = [(self.bits.get(slot.name, 0), code) for slot in there for code in fixed_codes(slot.item) or []]
        return self.constants.masks(path, head, codes)

    def _masked_slot(self, slot: SlotPlan) -> list[str]:
        name = f"{slot.name}_"
        bit = self.bits.get(slot.name)
        if bit is None:
            names, lines, arguments = self._flat(slot.item, name)
            return [*(f"{n} = raw()" for n in names), *lines, *([] if arguments == name else [f"{name} = {arguments}"])]
        if not bit:
            return [f"{name} = None"]
        number = slot.item
        if isinstance(number, NumberPlan) and free(number):
            value = self._value(number, "raw()")
            if value is not None:
                return [f"{name} = {value} if mask & {bit} else None"]
        names, lines, argument = self._flat(slot.item, name)
        body = [f"{names[0]} = raw()", *lines, *([] if argument == name else [f"{name} = {argument}"])]
        return [f"if mask & {bit}:", *indent(body), "else:", f"    {name} = None"]

    def _value(self, number: NumberPlan, raw: str) -> str | None:
        """One expression that needs the raw value once."""
        scale = number.scaling
        if scale:
            step = f"{raw} * {scale.step!r}"
            return (f"{scale.lower!r} + {step}" if scale.lower else step) if scale.top_is_exact else None
        return None if number.allowed.enum else raw

    def _body(self) -> list[str]:
        lines: list[str] = []
        if self.plan.presence:
            presence = self.plan.presence
            if presence == "B":
                lines += ["mask = data[at]", "at += 1"]
            else:
                lines += [f"(mask,) = {self.constants.packer(presence)}.unpack_from(data, at)"]
                lines += [f"at += {SIZES[presence]}"]
        for number, run in enumerate(runs(self.plan.slots)):
            lines += self._run(run, number) if is_fixed_run(run) else self._single(run[0])
        return lines

    def _run(self, run: list[SlotPlan], number: int) -> list[str]:
        if not any(slot.optional for slot in run):
            names, lines, values = self._flat_slots(run)
            codes = [code for slot in run for code in fixed_codes(slot.item) or []]
            fields = [f"{slot.name}_" for slot in run]
            lines += [f"{field} = {value}" for field, value in zip(fields, values, strict=True) if field != value]
            return [*(self._unpack(codes, names) if codes else []), *lines]
        bits = sum(self.bits[slot.name] for slot in run if slot.optional)
        masks = self._masks(f"{self.plan.path}_{number}", "", run)
        lines = [f"packer = {masks}[mask & 0x{bits:X}]", "raw = iter(packer.unpack_from(data, at)).__next__"]
        lines.append("at += packer.size")
        for slot in run:
            lines += self._masked_slot(slot)
        return lines

    def _unpack(self, codes: list[str], names: list[str]) -> list[str]:
        if codes == ["B"]:
            return [f"{names[0]} = data[at]", "at += 1"]
        targets = f"({names[0]},)" if len(names) == 1 else ", ".join(names)
        packer = self.constants.packer("".join(codes))
        return [f"{targets} = {packer}.unpack_from(data, at)", f"at += {size_of(codes)}"]

    def _flat_slots(self, slots: list[SlotPlan], prefix: str = "") -> tuple[list[str], list[str], list[str]]:
        """Names of the raw values, lines that turn them into fields, and the fields as expressions."""
        names: list[str] = []
        lines: list[str] = []
        arguments: list[str] = []
        for slot in slots:
            name = f"{prefix}{slot.name}_"
            inner_names, inner_lines, argument = self._flat(slot.item, name)
            names += inner_names
            lines += inner_lines
            arguments.append(argument)
        return names, lines, arguments

    def _flat(self, item: ItemPlan, name: str) -> tuple[list[str], list[str], str]:
        match item:
            case NumberPlan():
                return [name], self._checks(item, name), self._converted(item, name)
            case TextPlan():
                return [name], [], f'{name}.rstrip(b"\\0").decode("latin-1")'
            case ObjectPlan() if item.cls.kind == "bits":
                return [name], self._bit_checks(item.cls, name), self._bits_value(item.cls, name)
            case ObjectPlan():
                names: list[str] = []
                lines: list[str] = []
                arguments: list[str] = []
                for slot in item.cls.slots:
                    inner_names, inner_lines, argument = self._flat(slot.item, f"{name}{slot.name}_")
                    names, lines = names + inner_names, lines + inner_lines
                    arguments.append(f"{slot.name}={argument}" if needs_keywords(item.cls) else argument)
                return names, lines, f"{item.cls.path}({', '.join(arguments)})"
            case _:
                raise AssertionError(item)

    def _checks(self, number: NumberPlan, name: str) -> list[str]:
        if number.code in FLOATS:
            lines = _if(f"{name} - {name} != 0.0")  # infinities and NaN
            return lines + (_if(outside(number.allowed, name, self.constants)) if not number.allowed.anything else [])
        if free(number) or (number.allowed.enum and not number.allowed.intervals):
            return []  # a lookup of the member fails by itself
        if number.scaling:
            return _if(f"{name} < 0")
        return _if(outside(number.allowed, name, self.constants, *limits(number.code)))

    def _converted(self, number: NumberPlan, name: str) -> str:
        if number.scaling:
            value = self._value(number, name)
            scale = number.scaling
            return value or f"{scale.upper!r} if {name} == {scale.top} else {scale.lower!r} + {name} * {scale.step!r}"
        enum = number.allowed.enum
        if enum is None:
            return name
        members = self.constants.members(enum)
        return f"{members}.get({name}, {name})" if number.allowed.intervals or free(number) else f"{members}[{name}]"

    def _bit_checks(self, plan: ClassPlan, name: str) -> list[str]:
        lines: list[str] = []
        for bit in plan.bits:
            if not covers(bit.allowed, 0, bit.mask):
                lines += [
                    f"part = {_part(name, bit.shift, bit.mask)}",
                    *_if(outside(bit.allowed, "part", self.constants, 0, bit.mask)),
                ]
        return lines

    def _bits_value(self, plan: ClassPlan, name: str) -> str:
        parts = []
        for bit in plan.bits:
            part = _part(name, bit.shift, bit.mask)
            members = self.constants.members(bit.allowed.enum) if bit.allowed.enum else ""
            parts.append(f"{members}.get({part}, {part})" if members else part)
        if undefined_bits(plan):
            parts.append(f"{name} & 0x{undefined_bits(plan):X}")
        return f"{plan.path}({', '.join(parts)})"

    def _single(self, slot: SlotPlan) -> list[str]:
        name = f"{slot.name}_"
        bit = self.bits.get(slot.name)
        lines = self._item(slot.item, name)
        if bit is None:
            return lines
        if not bit:
            return [f"{name} = None"]
        declared = f"{name}: {annotation(slot.item)} | None = None"
        lines = [line for line in lines if not line.startswith(f"{name}: ")]
        return [declared, f"if mask & {bit}:", *indent(lines)]

    def _item(self, item: ItemPlan, name: str) -> list[str]:
        codes = fixed_codes(item)
        if codes:
            names, lines, argument = self._flat(item, name)
            unpack = self._unpack(codes, names)
            return [*unpack, *lines, *([] if argument == name else [f"{name} = {argument}"])]
        match item:
            case TextPlan() if item.count:
                chunk, end = self._chunk(item.count, name)
                return [*chunk, f'{name} = data[at:{end}].decode("latin-1")', f"at = {end}"]
            case TextPlan():
                return [f'{name} = ""']
            case BlobPlan():
                chunk, end = self._chunk(item.count, name)
                value = f"_registry.nested(data[at:{end}], depth)" if item.is_message else f"data[at:{end}]"
                return [*chunk, f"{name} = {value}", f"at = {end}"]
            case ObjectPlan() if item.cls.kind == "composite" and not item.cls.presence:
                return self._inline(item.cls, name)
            case ObjectPlan():
                return [f"{name}, at = {item.cls.path}._read(data, at, depth)"]
            case UnionPlan():
                return self._union(item, name)
            case RepeatPlan():
                return self._repeat(item, name)
            case GridPlan():
                inner = GridPlan(item.item, item.sizes[1:]) if len(item.sizes) > 1 else item.item
                return self._loop(inner, name, str(item.sizes[0]))
            case _:
                raise AssertionError(item)

    def _inline(self, plan: ClassPlan, name: str) -> list[str]:
        """A composite without presence vector, read in place: calls cost as much as a small record."""
        lines: list[str] = []
        arguments: list[str] = []
        for run in runs(plan.slots):
            if is_fixed_run(run):
                names, inner, found = self._flat_slots(run, name)
                codes = [code for slot in run for code in fixed_codes(slot.item) or []]
                lines += [*(self._unpack(codes, names) if codes else []), *inner]
                arguments += found
            else:
                lines += self._item(run[0].item, f"{name}{run[0].name}_")
                arguments.append(f"{name}{run[0].name}_")
        return [*lines, f"{name} = {plan.path}({', '.join(arguments)})"]

    def _count(self, count: Count, name: str) -> list[str]:
        code = CODES[count.type]
        if code == "B":
            lines = [f"{name} = data[at]", "at += 1"]
        else:
            lines = [f"({name},) = {self.constants.packer(code)}.unpack_from(data, at)", f"at += {SIZES[code]}"]
        low = f"{name} < {count.minimum}" if count.minimum else ""
        high = f"{name} > {count.maximum}" if count.maximum < limits(code)[1] else ""
        return lines + (_if(" or ".join(part for part in (low, high) if part)) if low or high else [])

    def _chunk(self, count: Count, name: str) -> tuple[list[str], str]:
        end = f"{name}end"
        return [*self._count(count, end), f"{end} += at", *_if(f"{end} > size")], end

    def _repeat(self, item: RepeatPlan, name: str) -> list[str]:
        counted = f"{name}count"
        codes = fixed_codes(item.item)
        if codes and isinstance(item.item, ObjectPlan):
            return [*self._count(item.count, counted), *self._table(item.item, codes, name, counted)]
        guard = _if(f"{counted} * {minimum(item.item)} > size - at")
        return [*self._count(item.count, counted), *guard, *self._loop(item.item, name, counted)]

    def _table(self, item: ObjectPlan, codes: list[str], name: str, counted: str) -> list[str]:
        """Elements of fixed size: one call unpacks them all."""
        end = f"{name}end"
        names, lines, argument = self._flat(item, f"{name}item_")
        targets = f"({names[0]},)" if len(names) == 1 else ", ".join(names)
        rows = f"{self.constants.packer(''.join(codes))}.iter_unpack(data[at:{end}])"
        head = [f"{end} = at + {counted} * {size_of(codes)}", *_if(f"{end} > size")]
        if lines:
            body = [f"{name} = []", f"for {targets} in {rows}:", *indent([*lines, f"{name}.append({argument})"])]
        else:
            body = [f"{name} = [{argument} for {targets} in {rows}]"]
        return [*head, *body, f"at = {end}"]

    def _loop(self, item: ItemPlan, name: str, counted: str) -> list[str]:
        inner = f"{name}item_"
        body = [*self._item(item, inner), f"{name}.append({inner})"]
        return [f"{name} = []", f"for _ in range({counted}):", *indent(body)]

    def _union(self, item: UnionPlan, name: str) -> list[str]:
        if item.code == "B":
            lines = ["tag = data[at]", "at += 1"]
        else:
            lines = [f"(tag,) = {self.constants.packer(item.code)}.unpack_from(data, at)", f"at += {SIZES[item.code]}"]
        lines.append(f"{name}: {annotation(item)}")
        for number, arm in enumerate(item.arms):
            head = f"{'el' if number else ''}if tag == {number}:"
            lines += [head, f"    {name}, at = {arm.path}._read(data, at, depth)"]
        return [*lines, "else:", f"    {REJECT}"]

    def _choice(self) -> list[str]:
        lines = ["choice = data[at]", "at += 1"]
        for number, (index, plan) in enumerate(self.plan.choices):
            body = [*self._unpack([plan.code], ["value_"]), *self._checks(plan, "value_")]
            body.append(f"value = {self._converted(plan, 'value_')}")
            lines += [f"{'el' if number else ''}if choice == {index}:", *indent(body)]
        lines += ["else:", f"    {REJECT}"]
        enum = self.plan.allowed.enum
        chosen = f"{self.constants.members(enum)}[choice]" if enum else "choice"
        return [*lines, f"return cls({chosen}, value), at"]

    def _format(self) -> list[str]:
        assert self.plan.count is not None
        chunk, end = self._chunk(self.plan.count, "data_")
        lines = ["size = len(data)", "format = data[at]", "at += 1", *chunk, f"chunk = data[at:{end}]"]
        if self.plan.message_formats:
            chosen = " or ".join(f"format == {number}" for number in self.plan.message_formats)
            lines += ["content: rt.Message | bytes = chunk", f"if {chosen}:"]
            lines += ["    content = _registry.nested(chunk, depth)"]
        content = "content" if self.plan.message_formats else "chunk"
        enum = self.plan.allowed.enum
        value = f"{self.constants.members(enum)}[format]" if enum else "format"
        return [*lines, f"return cls({value}, {content}), {end}"]

    def _arguments(self) -> list[str]:
        undefined = undefined_presence(self.plan)
        return [f"{slot.name}_" for slot in self.plan.slots] + ([f"mask & 0x{undefined:X}"] if undefined else [])

    def _return(self, arguments: list[str], more: str = "") -> str:
        if needs_keywords(self.plan):
            names = [slot.name for slot in self.plan.slots] + ["reserved_presence"]
            arguments = [f"{name}={argument}" for name, argument in zip(names, arguments, strict=False)]
        return f"return cls({', '.join(arguments)}){', ' + more if more else ''}"


def _part(name: str, shift: int, mask: int) -> str:
    return f"{name} >> {shift} & 0x{mask:X}" if shift else f"{name} & 0x{mask:X}"


def _if(condition: str) -> list[str]:
    return [f"if {condition}:", f"    {REJECT}"]
