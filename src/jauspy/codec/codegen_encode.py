"""Source of the straight-line encoders: `_pack` of messages, `_write` of what is inside them.

They check what `struct` does not, and raise one of `FAST_ERRORS` for every value that does not fit.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from jauspy.codec.codegen import (
    Locals,
    Namespace,
    Run,
    count_checks,
    covers,
    finite,
    fixed_codes,
    free,
    grid_codes,
    indent,
    inner_grid,
    is_one_run,
    is_plain,
    member,
    outside,
    presence_bits,
    reject_if,
    run_masks,
    runs,
)
from jauspy.codec.items import Bit, Bits, Blob, Choice, Count, Formatted, Item, Number, Real, Text
from jauspy.codec.layout import Composite, Grid, Repeat, Slot, Union
from jauspy.codec.scalars import FLOATS, NEAR_TIE, SIZES, limits


def pack_source(layout: Composite, code: int, namespace: Namespace) -> list[str]:
    """The lines of `_pack` of a message with this id."""
    return ["def _pack(self):", *indent(_Encoder(namespace).message(layout, code))]


def write_source(layout: Composite | Choice | Formatted, namespace: Namespace) -> list[str]:
    """The lines of `_write` of what is inside a message."""
    return ["def _write(self, out):", *indent(_Encoder(namespace).inner(layout))]


Checked = tuple[list[str], list[str]]
"""Lines that check, and the raw values as expressions."""


class _Checks:
    """Source that converts values to raw values. A value that needs no check is an expression without a line."""

    def __init__(self, namespace: Namespace, names: Locals) -> None:
        self._namespace = namespace
        self._locals = names

    def local(self, source: str, hint: str) -> tuple[list[str], str]:
        """A value as a local variable; a variable is returned unchanged."""
        if source.isidentifier():
            return [], source
        name = self._locals.name(hint)
        return [f"{name} = {source}"], name

    def slots(self, slots: Iterable[Slot], owner: str) -> Checked:
        """Several slots of fixed size."""
        lines: list[str] = []
        values: list[str] = []
        for slot in slots:
            inner, found = self.flat(slot.item, member(owner, slot.name), slot.name)
            lines += inner
            values += found
        return lines, values

    def flat(self, item: Item, source: str, hint: str) -> Checked:
        """One item of fixed size."""
        match item:
            case Number() if free(item):
                return [], [source]
            case Number():
                lines, name = self.local(source, hint)
                return [*lines, *self._number(item, name)], [name]
            case Real():
                return self._real(item, *self.local(source, hint), hint)
            case Text():
                raw = self._locals.name(f"{hint}_raw")
                return [f'{raw} = {source}.encode("latin-1")', *reject_if(f"len({raw}) > {item.length}")], [raw]
            case Bits() | Composite():
                lines, name = self.local(source, hint)
                lines += reject_if(f"type({name}) is not {self._namespace.cls(item.cls)}")
                inner, values = self._bits(item, name) if isinstance(item, Bits) else self.slots(item.slots, name)
                return [*lines, *inner], values
            case _:
                raise AssertionError(item)

    def _real(self, item: Real, lines: list[str], name: str, hint: str) -> Checked:
        scaling, number = item.scaling, self._namespace.number
        lines += reject_if(f"not {number(scaling.lower)} <= {name} <= {number(scaling.upper)}")
        raw = self._locals.name(f"{hint}_raw")
        exact = f"{raw} = exact_raw({name}, {self._namespace.scaling(scaling)})"
        if scaling.function != "round" or scaling.top > 0xFFFFFFFF or not 0 < scaling.factor < math.inf:
            return [*lines, exact], [raw]
        # raw = floor((value - lower) top / (upper - lower) + 1/2) in floats; near a tie, where their errors may decide,
        # in rational numbers
        return [
            *lines,
            f"near = {scaling.position.format(name)}",
            f"{raw} = int(near)",
            f"if not {NEAR_TIE!r} < near - {raw} < {1 - NEAR_TIE!r}: {exact}",
        ], [raw]

    def _number(self, number: Number, name: str) -> list[str]:
        values = number.values
        outside_set = [] if values.anything else reject_if(outside(values, name, self._namespace))
        if number.code in FLOATS:
            return [*reject_if(f"{name} - {name} != 0.0"), *outside_set]  # infinities and NaN
        return outside_set

    def _bits(self, item: Bits, name: str) -> Checked:
        lines: list[str] = []
        parts = []
        for bit in item.bits:
            checks, part = self.local(member(name, bit.name), bit.name)
            lines += [*checks, *self._bit(bit, part)]
            parts.append(f"{part} << {bit.shift}" if bit.shift else part)
        if item.reserved:
            checks, rest = self.local(f"{name}.reserved_bits", "reserved_bits")
            named = limits(item.code)[1] & ~item.reserved
            lines += [*checks, *(reject_if(f"{rest} & 0x{named:X}") if named else [])]
            parts.append(rest)
        return lines, [" | ".join(parts) or "0"]

    def _bit(self, bit: Bit, part: str) -> list[str]:
        if covers(bit.values, 0, bit.mask):
            return reject_if(f"not 0 <= {part} <= {bit.mask}")
        return reject_if(outside(bit.values, part, self._namespace))


class _Encoder:
    def __init__(self, namespace: Namespace) -> None:
        self.namespace = namespace
        self.locals = Locals()
        self.checks = _Checks(namespace, self.locals)

    def message(self, layout: Composite, code: int) -> list[str]:
        fixed = fixed_codes(layout)
        if fixed is not None:
            lines, values = self.checks.slots(layout.slots, "self")
            packer = self.namespace.packer(["H", *fixed])
            return [*lines, f"return {packer}.pack({', '.join([f'0x{code:04X}', *values])})"]
        if is_one_run(layout):
            return self._masked_message(layout, code)
        head = f'out = bytearray(b"\\x{code & 255:02x}\\x{code >> 8:02x}")'
        return [head, *self._body(layout), "return bytes(out)"]

    def inner(self, layout: Composite | Choice | Formatted) -> list[str]:
        match layout:
            case Choice():
                return self._choice(layout)
            case Formatted():
                return self._format(layout)
            case Composite():
                return self._body(layout) or ["return"]

    def _masked_message(self, layout: Composite, code: int) -> list[str]:
        bits = presence_bits(layout)
        lines = [*_mask_start(layout), "raw = []"]
        for slot in layout.slots:
            lines += self._masked_slot(slot, bits)
        masks = run_masks(self.namespace, f"H{layout.presence}", layout.slots, bits)
        return [*lines, f"return {masks}[mask & 0x{sum(bits.values()):X}].pack(0x{code:04X}, mask, *raw)"]

    def _masked_slot(self, slot: Slot, bits: dict[str, int]) -> list[str]:
        source = member("self", slot.name)
        name = self.locals.name(slot.name) if slot.optional else source
        lines, values = self.checks.flat(slot.item, name, slot.name)
        lines += [f"raw.append({value})" for value in values]
        return self._optional(slot, name, lines, bits) if slot.optional else lines

    def _optional(self, slot: Slot, name: str, body: list[str], bits: dict[str, int]) -> list[str]:
        start = f"{name} = {member('self', slot.name)}"
        bit = bits[slot.name]
        if not bit:
            return [start, *reject_if(f"{name} is not None")]
        return [start, f"if {name} is not None:", f"    mask |= {bit}", *indent(body)]

    def _body(self, layout: Composite) -> list[str]:
        lines: list[str] = []
        bits = presence_bits(layout)
        if layout.presence:
            zeros = "\\0" * SIZES[layout.presence]
            lines += ["start = len(out)", f'out += b"{zeros}"', *_mask_start(layout)]
        for run, fixed in runs(layout.slots):
            if not fixed:
                lines += self._single(run[0], bits)
            elif any(slot.optional for slot in run):
                lines += self._masked_run(run, bits)
            else:
                lines += self._run(run, "self")
        if layout.presence:
            lines.append(f"{self.namespace.packer(layout.presence)}.pack_into(out, start, mask)")
        return lines

    def _masked_run(self, run: Run, bits: dict[str, int]) -> list[str]:
        lines = ["raw = []"]
        for slot in run:
            lines += self._masked_slot(slot, bits)
        mask = sum(bits[slot.name] for slot in run if slot.optional)
        return [*lines, f"out += {run_masks(self.namespace, '', run, bits)}[mask & 0x{mask:X}].pack(*raw)"]

    def _run(self, run: Run, owner: str) -> list[str]:
        lines, values = self.checks.slots(run, owner)
        codes = [code for slot in run for code in fixed_codes(slot.item) or []]
        return [*lines, *self._append(codes, values)]

    def _append(self, codes: list[str], values: list[str]) -> list[str]:
        if len(codes) <= 3 and set(codes) == {"B"}:  # costs less than packing them
            return [f"out.append({value})" for value in values]
        return [f"out += {self.namespace.packer(codes)}.pack({', '.join(values)})"] if values else []

    def _single(self, slot: Slot, bits: dict[str, int]) -> list[str]:
        if not slot.optional:
            return self._item(slot.item, member("self", slot.name), slot.name)
        name = self.locals.name(slot.name)
        return self._optional(slot, name, self._item(slot.item, name, slot.name), bits)

    def _item(self, item: Item, source: str, hint: str) -> list[str]:
        codes = fixed_codes(item)
        if codes:
            lines, values = self.checks.flat(item, source, hint)
            return [*lines, *self._append(codes, values)]
        match item:
            case Text(count=None):
                return reject_if(f'{source} != ""')
            case Text(count=Count() as count):
                return self._bytes(count, f'{source}.encode("latin-1")', hint)
            case Blob():
                return self._bytes(item.count, f"{'message' if item.nested else 'plain'}_bytes({source})", hint)
            case Repeat():
                lines, name = self.checks.local(source, hint)
                head = [*lines, *reject_if(f"type({name}) is not list"), *self._counted(item.count, name)]
                return [*head, *(self._numbers(item.item, name) or self._loop(item.item, name))]
            case Grid():
                return self._grid(item, *self.checks.local(source, hint))
            case Composite() | Choice() | Formatted():
                return self._object(item, *self.checks.local(source, hint))
            case Union():
                return self._union(item, *self.checks.local(source, hint))
            case _:
                raise AssertionError(item)

    def _bytes(self, count: Count, source: str, hint: str) -> list[str]:
        raw = self.locals.name(f"{hint}_raw")
        return [f"{raw} = {source}", *self._counted(count, raw), f"out += {raw}"]

    def _object(self, item: Composite | Choice | Formatted, lines: list[str], name: str) -> list[str]:
        """A composite without presence vector is written in place."""
        lines += reject_if(f"type({name}) is not {self.namespace.cls(item.cls)}")
        if not isinstance(item, Composite) or item.presence:
            return [*lines, f"{name}._write(out)"]
        for run, fixed in runs(item.slots):
            if fixed:
                lines += self._run(run, name)
            else:
                lines += self._item(run[0].item, member(name, run[0].name), run[0].name)
        return lines

    def _grid(self, item: Grid, lines: list[str], name: str) -> list[str]:
        lines += reject_if(f"type({name}) is not list or len({name}) != {item.sizes[0]}")
        if is_plain(item) and len(item.sizes) == 1:
            return [*lines, *finite(item, name), f"out += {self.namespace.packer(grid_codes(item))}.pack(*{name})"]
        return [*lines, *self._loop(inner_grid(item), name)]

    def _union(self, item: Union, lines: list[str], name: str) -> list[str]:
        tag = f"{self.namespace.tags(arm.cls for arm in item.arms.values())}[type({name})]"
        return [*lines, *self._append([item.code], [tag]), f"{name}._write(out)"]

    def _counted(self, count: Count, name: str) -> list[str]:
        checks = count_checks(f"len({name})", count.minimum, count.maximum, count.code)
        return [*checks, *self._append([count.code], [f"len({name})"])]

    def _loop(self, item: Item, name: str) -> list[str]:
        one = self.locals.name("item")
        return [f"for {one} in {name}:", *indent(self._item(item, one, "item"))]

    def _numbers(self, item: Item, name: str) -> list[str]:
        """Elements that are numbers of one type: one call packs them all. Nothing for other elements."""
        codes = fixed_codes(item) or []
        if len(set(codes)) != 1 or codes[0] not in SIZES:
            return []
        one, raw = self.locals.name("item"), self.locals.name("raw")
        lines, values = self.checks.flat(item, one, "item")
        collect = f"{raw}.append({values[0]})" if len(values) == 1 else f"{raw} += ({', '.join(values)})"
        loop = [f"for {one} in {name}:", *indent([*lines, collect])]
        return [f"{raw} = []", *loop, f"out += {self.namespace.rows(codes[0])}[len({raw})].pack(*{raw})"]

    def _choice(self, layout: Choice) -> list[str]:
        lines = ["choice = self.choice"]
        for number, (index, item) in enumerate(layout.items.items()):
            inner, values = self.checks.flat(item, "self.value", "value")
            body = [*inner, f"out += {self.namespace.packer(['B', item.code])}.pack(choice, {values[0]})"]
            lines += [f"{'el' if number else ''}if choice == {int(index)}:", *indent(body)]
        return [*lines, "else: raise Reject"]

    def _format(self, layout: Formatted) -> list[str]:
        lines = ["format = self.format"]
        if layout.formats.enum:
            lines += reject_if(f"format not in {self.namespace.members(layout.formats.enum)}")
        source = "plain_bytes(self.data)"
        if layout.nested:
            chosen = f"format in {self.namespace.indices(layout.nested_formats)}"
            source = f"message_bytes(self.data) if {chosen} else {source}"
        return [*lines, "out.append(format)", *self._bytes(layout.count, source, "data")]


def _mask_start(layout: Composite) -> list[str]:
    if not layout.undefined:
        return ["mask = 0"]
    defined = limits(str(layout.presence))[1] & ~layout.undefined
    return ["mask = self.reserved_presence", *(reject_if(f"mask & 0x{defined:X}") if defined else [])]
