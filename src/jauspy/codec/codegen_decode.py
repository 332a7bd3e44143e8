"""Source of the straight-line decoders: `_unpack` of messages, `_read` of what is inside them.

They accept valid bytes only and raise one of `FAST_ERRORS` for all others. Attributes are set on an object
made by `new`, which costs less than a constructor; local variables end in an underscore where they hold a field.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from jauspy.codec.codegen import (
    Locals,
    Namespace,
    Position,
    Run,
    count_checks,
    covers,
    fixed_codes,
    free,
    grid_codes,
    grid_values,
    identifier,
    indent,
    inner_grid,
    is_one_run,
    is_plain,
    keywords_only,
    member,
    outside,
    presence_bits,
    reject_if,
    run_masks,
    runs,
    scaled,
    size_of,
)
from jauspy.codec.items import Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union
from jauspy.codec.message import NestingSource
from jauspy.codec.scalars import FLOATS, SIZES, limits


def unpack_source(layout: Composite, code: int, namespace: Namespace) -> list[str]:
    """The lines of `_unpack` of a message with this id."""
    return ["def _unpack(cls, data, nesting):", *indent(_Decoder(namespace, Position("", 2)).message(layout, code))]


def read_source(layout: Composite | Choice | Formatted, namespace: Namespace) -> list[str]:
    """The lines of `_read` of what is inside a message."""
    return ["def _read(cls, data, at, nesting):", *indent(_Decoder(namespace, Position("at", 0)).inner(layout))]


@dataclass(frozen=True, slots=True)
class _Raw:
    """Variables for the raw values, and the lines that convert them to attributes."""

    targets: list[str]
    lines: list[str]


class _RawReader:
    """Source that converts unpacked raw values to values: checks, scaling, members, bit fields, small records."""

    def __init__(self, namespace: Namespace, names: Locals) -> None:
        self._namespace = namespace
        self._locals = names

    def expression(self, item: Item, raw: str) -> str | None:
        """The value of a number that takes any raw value, if it is an expression that needs the raw value only once."""
        match item:
            case Real() if free(item):
                return scaled(item.scaling, raw, self._namespace) if item.scaling.top_is_exact else None
            case Number() if free(item):
                return None if item.values.enum else raw
            case _:
                return None

    def into(self, item: Item, hint: str, target: str) -> _Raw:
        """Read an item of fixed size into an attribute or variable; directly if it needs no conversion."""
        if isinstance(item, Number) and self.expression(item, "") == "":
            return _Raw([target], [])
        names, lines, value = self.flat(item, hint)
        return _Raw(names, [*lines, f"{target} = {value}"])

    def flat(self, item: Item, hint: str) -> tuple[list[str], list[str], str]:
        """Names of the raw values, lines that check them, and the value as an expression."""
        if isinstance(item, Composite):
            return self._record(item)
        name = self._locals.name(hint)
        match item:
            case Number():
                return [name], self._number_checks(item, name), self._named(item, name)
            case Real():
                return [name], [] if free(item) else reject_if(f"{name} < 0"), self._real(item, name)
            case Text():
                return [name], [], f'{name}.rstrip(b"\\0").decode("latin-1")'
            case Bits():
                return [name], *self._bits(item, name)
            case _:
                raise AssertionError(item)

    def _record(self, item: Composite) -> tuple[list[str], list[str], str]:
        names: list[str] = []
        lines: list[str] = []
        arguments: list[str] = []
        keywords = keywords_only(item.slots)
        for slot in item.slots:
            inner_names, inner_lines, argument = self.flat(slot.item, slot.name)
            names, lines = names + inner_names, lines + inner_lines
            arguments.append(f"{identifier(slot.name)}={argument}" if keywords else argument)
        return names, lines, f"{self._namespace.cls(item.cls)}({', '.join(arguments)})"

    def _number_checks(self, number: Number, name: str) -> list[str]:
        values = number.values
        if number.code in FLOATS:
            lines = reject_if(f"{name} - {name} != 0.0")  # infinities and NaN
            return lines + ([] if values.anything else reject_if(outside(values, name, self._namespace)))
        if free(number) or (values.enum and not values.intervals):
            return []  # a lookup of the member fails by itself
        return reject_if(outside(values, name, self._namespace, *limits(number.code)))

    def _real(self, item: Real, name: str) -> str:
        scaling, value = item.scaling, scaled(item.scaling, name, self._namespace)
        if scaling.top_is_exact:
            return value
        return f"{self._namespace.number(scaling.upper)} if {name} == {scaling.top} else {value}"

    def _named(self, number: Number, name: str) -> str:
        if number.values.enum is None:
            return name
        members = self._namespace.members(number.values.enum)
        return f"{members}.get({name}, {name})" if number.values.intervals or free(number) else f"{members}[{name}]"

    def _bits(self, item: Bits, name: str) -> tuple[list[str], str]:
        """Lines that check the parts of a bit field, and its value."""
        lines: list[str] = []
        parts = []
        for bit in item.bits:
            part = f"{name} >> {bit.shift} & 0x{bit.mask:X}" if bit.shift else f"{name} & 0x{bit.mask:X}"
            if not covers(bit.values, 0, bit.mask):
                checked = self._locals.name(bit.name)
                lines += [f"{checked} = {part}"]
                lines += reject_if(outside(bit.values, checked, self._namespace, 0, bit.mask))
                part = checked
            members = self._namespace.members(bit.values.enum) if bit.values.enum else ""
            parts.append(f"{members}.get({part}, {part})" if members else part)
        if item.reserved:
            parts.append(f"{name} & 0x{item.reserved:X}")
        return lines, f"{self._namespace.cls(item.cls)}({', '.join(parts)})"


class _Decoder:
    def __init__(self, namespace: Namespace, position: Position) -> None:
        self.namespace = namespace
        self.locals = Locals()
        self.position = position
        self.raw = _RawReader(namespace, self.locals)

    def message(self, layout: Composite, code: int) -> list[str]:
        fixed = fixed_codes(layout)
        if fixed is not None:
            return self._fixed_message(layout, code, fixed)
        if is_one_run(layout):
            return self._masked_message(layout, code)
        check = reject_if(f"data[0] != 0x{code & 255:02X} or data[1] != 0x{code >> 8:02X}")
        body = [*self._body(layout), *reject_if(f"{self.position.here()} != size")]
        return [*check, "size = len(data)", "self = new(cls)", *body, "return self"]

    def inner(self, layout: Composite | Choice | Formatted) -> list[str]:
        match layout:
            case Choice():
                lines = self._choice(layout)
            case Formatted():
                lines = self._format(layout)
            case Composite():
                lines = self._body(layout)
        sized = any(re.search(r"(?<![.\w])size\b", line) for line in lines)
        head = [*(["size = len(data)"] if sized else []), "self = new(cls)"]
        return [*head, *lines, f"return self, {self.position.here()}"]

    def _fixed_message(self, layout: Composite, code: int, codes: list[str]) -> list[str]:
        if not codes:
            return [*reject_if(f"data != {code.to_bytes(2, 'little')!r}"), "return new(cls)"]
        raw = self._raw_slots(layout.slots, "self")
        targets = ", ".join(["code", *raw.targets])
        return [
            "self = new(cls)",
            f"{targets} = {self.namespace.packer(['H', *codes])}.unpack(data)",
            *reject_if(f"code != 0x{code:04X}"),
            *raw.lines,
            "return self",
        ]

    def _masked_message(self, layout: Composite, code: int) -> list[str]:
        """Only numbers behind a presence vector: one `unpack` for each mask, exact in length."""
        presence, bits = str(layout.presence), presence_bits(layout)
        masks = run_masks(self.namespace, f"{2 + SIZES[presence]}x", layout.slots, bits)
        lines = [
            f"code, mask = {self.namespace.packer(['H', presence])}.unpack_from(data)",
            *reject_if(f"code != 0x{code:04X}"),
            f"raw = iter({masks}[mask & 0x{sum(bits.values()):X}].unpack(data)).__next__",
            "self = new(cls)",
        ]
        for slot in layout.slots:
            lines += self._masked_slot(slot, bits)
        return [*lines, *_reserved(layout), "return self"]

    def _masked_slot(self, slot: Slot, bits: dict[str, int]) -> list[str]:
        target = member("self", slot.name)
        bit = bits.get(slot.name)
        if bit is None:
            return self._next_raw(slot, target)
        if not bit:
            return [f"{target} = None"]
        value = self.raw.expression(slot.item, "raw()")
        if value is not None:
            return [f"{target} = {value} if mask & {bit} else None"]
        return [f"if mask & {bit}:", *indent(self._next_raw(slot, target)), f"else: {target} = None"]

    def _next_raw(self, slot: Slot, target: str) -> list[str]:
        raw = self.raw.into(slot.item, slot.name, target)
        return [*(f"{name} = raw()" for name in raw.targets), *raw.lines]

    def _body(self, layout: Composite) -> list[str]:
        bits = presence_bits(layout)
        lines = self._number(layout.presence, "mask") if layout.presence else []
        for run, fixed in runs(layout.slots):
            lines += self._run(run, bits) if fixed else self._single(run[0], bits)
        return [*lines, *_reserved(layout)]

    def _number(self, code: str, name: str) -> list[str]:
        """A single unsigned number."""
        position = self.position.here()
        self.position.skip(SIZES[code])
        if code == "B":
            return [f"{name} = data[{position}]"]
        return [f"({name},) = {self.namespace.packer(code)}.unpack_from(data, {position})"]

    def _run(self, run: Run, bits: dict[str, int]) -> list[str]:
        if not any(slot.optional for slot in run):
            return self._unpack_slots(run, "self")
        mask = sum(bits[slot.name] for slot in run if slot.optional)
        position = self.position.here()
        lines = [
            f"packer = {run_masks(self.namespace, '', run, bits)}[mask & 0x{mask:X}]",
            f"raw = iter(packer.unpack_from(data, {position})).__next__",
            "at += packer.size" if position == "at" else f"at = {position} + packer.size",
        ]
        self.position.settled()
        for slot in run:
            lines += self._masked_slot(slot, bits)
        return lines

    def _raw_slots(self, slots: tuple[Slot, ...] | Run, owner: str) -> _Raw:
        """All raw values of some slots, and the lines that turn them into attributes."""
        targets: list[str] = []
        lines: list[str] = []
        for slot in slots:
            raw = self.raw.into(slot.item, slot.name, member(owner, slot.name))
            targets += raw.targets
            lines += raw.lines
        return _Raw(targets, lines)

    def _unpack_slots(self, slots: Run, owner: str) -> list[str]:
        raw = self._raw_slots(slots, owner)
        codes = [code for slot in slots for code in fixed_codes(slot.item) or []]
        return [*self._unpack(codes, raw.targets), *raw.lines]

    def _unpack(self, codes: list[str], targets: list[str]) -> list[str]:
        if not codes:
            return []
        position = self.position.here()
        if len(codes) <= 3 and set(codes) == {"B"}:  # indexing costs less than a call
            places = [self.position.here(number) for number in range(len(codes))]
            self.position.skip(len(codes))
            return [f"{target} = data[{place}]" for target, place in zip(targets, places, strict=True)]
        self.position.skip(size_of(codes))
        names = f"({targets[0]},)" if len(targets) == 1 else ", ".join(targets)
        return [f"{names} = {self.namespace.packer(codes)}.unpack_from(data, {position})"]

    def _single(self, slot: Slot, bits: dict[str, int]) -> list[str]:
        target = member("self", slot.name)
        bit = bits.get(slot.name)
        if bit is None:
            return self._item(slot.item, slot.name, target)
        if not bit:
            return [f"{target} = None"]
        before = self.position.settle()
        lines = [*self._item(slot.item, slot.name, target), *self.position.settle()]
        return [*before, f"if mask & {bit}:", *indent(lines), f"else: {target} = None"]

    def _item(self, item: Item, hint: str, target: str) -> list[str]:
        codes = fixed_codes(item)
        if codes:
            raw = self.raw.into(item, hint, target)
            return [*self._unpack(codes, raw.targets), *raw.lines]
        match item:
            case Text(count=None):
                return [f'{target} = ""']
            case Text(count=Count() as count):
                lines, chunk = self._chunk(count, hint)
                return [*lines, f'{target} = {chunk}.decode("latin-1")']
            case Blob():
                lines, chunk = self._chunk(item.count, hint)
                return [*lines, f"{target} = {self._inside(item.nested, chunk) if item.nested else chunk}"]
            case Composite(presence=None):
                return self._inline(item, hint, target)
            case Composite() | Choice() | Formatted():
                read = f"{target}, at = {self.namespace.cls(item.cls)}._read(data, at, nesting)"
                return [*self.position.settle(), read]
            case Union():
                arms = self.namespace.arms(arm.cls for arm in item.arms.values())
                read = f"{target}, at = {arms}[tag]._read(data, at, nesting)"
                return [*self._number(item.code, "tag"), *self.position.settle(), read]
            case Repeat():
                return self._repeat(item, hint, target)
            case Grid() if is_plain(item):
                return self._grid(item, hint, target)
            case Grid():
                return self._loop(inner_grid(item), hint, str(item.sizes[0]), target)
            case _:
                raise AssertionError(item)

    def _inline(self, layout: Composite, hint: str, target: str) -> list[str]:
        """A composite without presence vector, read in place: calls cost as much as a small record."""
        owner = target if target.isidentifier() else self.locals.name(hint)
        lines = [f"{target} = {f'{owner} = ' if owner != target else ''}new({self.namespace.cls(layout.cls)})"]
        for run, fixed in runs(layout.slots):
            if fixed:
                lines += self._unpack_slots(run, owner)
            else:
                lines += self._item(run[0].item, run[0].name, member(owner, run[0].name))
        return lines

    def _count(self, count: Count, name: str) -> list[str]:
        return [*self._number(count.code, name), *count_checks(name, count.minimum, count.maximum, count.code)]

    def _chunk(self, count: Count, hint: str) -> tuple[list[str], str]:
        """Lines that read a count and compute the end, and the counted bytes as an expression.

        The end is not checked here: a slice beyond the data is short, every later read fails, and finally the length of
        the message is compared with that of the data.
        """
        end = self.locals.name(f"{hint}_end")
        lines = self._count(count, end)
        start = self.position.here()
        self.position.move(end)
        if len(lines) == 1 and count.code == "B":
            lines = [f"{end} = {start} + {lines[0].partition(' = ')[2]}"]
        else:
            lines.append(f"{end} += {start}")
        return lines, f"data[{start}:{end}]"

    def _repeat(self, item: Repeat, hint: str, target: str) -> list[str]:
        counted = self.locals.name(f"{hint}_count")
        lines = self._count(item.count, counted)
        codes = fixed_codes(item.item)
        if codes and isinstance(item.item, Composite | Bits):
            return [*lines, *self._table(item.item, codes, hint, counted, target)]
        guard = reject_if(f"{counted} * {item.each} > size - {self.position.parenthesized()}")
        return [*lines, *guard, *self._loop(item.item, hint, counted, target)]

    def _table(self, item: Item, codes: list[str], hint: str, counted: str, target: str) -> list[str]:
        """Elements of fixed size: one call unpacks them all."""
        start, end = self.position.here(), self.locals.name(f"{hint}_end")
        self.position.move(end)
        names, lines, argument = self.raw.flat(item, hint)
        targets = f"({names[0]},)" if len(names) == 1 else ", ".join(names)
        if len(codes) == 1 and codes[0] in SIZES:
            targets, elements = names[0], f"{self.namespace.rows(codes[0])}[{counted}].unpack_from(data, {start})"
        else:
            elements = f"{self.namespace.packer(codes)}.iter_unpack(data[{start}:{end}])"
        head = [f"{end} = {start} + {counted} * {size_of(codes)}"]
        if not lines:
            return [*head, f"{target} = [{argument} for {targets} in {elements}]"]
        made = self.locals.name(hint)
        body = indent([*lines, f"{made}.append({argument})"])
        return [*head, f"{made} = []", f"for {targets} in {elements}:", *body, f"{target} = {made}"]

    def _loop(self, item: Item, hint: str, counted: str, target: str) -> list[str]:
        made = self.locals.name(hint)
        one = self.locals.name("item")
        before = self.position.settle()
        body = [*self._item(item, "item", one), *self.position.settle(), f"{made}.append({one})"]
        return [*before, f"{made} = []", f"for _ in range({counted}):", *indent(body), f"{target} = {made}"]

    def _grid(self, item: Grid, hint: str, target: str) -> list[str]:
        """Numbers: one call unpacks them all."""
        raw, position, codes = self.locals.name(hint), self.position.here(), grid_codes(item)
        self.position.skip(size_of(codes))
        return [
            f"{raw} = {self.namespace.packer(codes)}.unpack_from(data, {position})",
            *grid_values(item, raw, target),
        ]

    def _choice(self, layout: Choice) -> list[str]:
        lines = ["choice = data[at]"]
        for number, (index, item) in enumerate(layout.items.items()):
            self.position.settled()
            self.position.skip(1)
            raw = self.raw.into(item, "value", "self.value")
            body = [*self._unpack([item.code], raw.targets), *raw.lines, *self.position.settle()]
            lines += [f"{'el' if number else ''}if choice == {int(index)}:", *indent(body)]
        enum = layout.index.enum
        chosen = f"{self.namespace.members(enum)}[choice]" if enum else "choice"
        return [*lines, "else: raise Reject", f"self.choice = {chosen}"]

    def _format(self, layout: Formatted) -> list[str]:
        enum = layout.formats.enum
        chosen = f"{self.namespace.members(enum)}[format]" if enum else "format"
        lines = ["format = data[at]", f"self.format = {chosen}"]
        self.position.skip(1)
        found, chunk = self._chunk(layout.count, "data")
        if layout.nested is None:
            return [*lines, *found, f"self.data = {chunk}"]
        chosen = f"format in {self.namespace.indices(layout.nested_formats)}"
        return [*lines, *found, f"self.data = {self._inside(layout.nested, chunk)} if {chosen} else {chunk}"]

    def _inside(self, known: NestingSource, chunk: str) -> str:
        """Decode a message inside this one by the registry that decodes this one, else by the registry of the class."""
        return f"(nesting or {self.namespace.source(known)}.nesting).message({chunk})"


def _reserved(layout: Composite) -> list[str]:
    return [f"self.reserved_presence = mask & 0x{layout.undefined:X}"] if layout.undefined else []
