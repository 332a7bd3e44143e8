"""Layouts of bit fields and of variable fields."""

# ruff: noqa: D102 - what the methods do is written once, at `Item`

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from jauspy.codec.base import Struct
from jauspy.codec.item import Item, check_class, check_keys, cut, integer_of, join, shown
from jauspy.codec.items_numbers import ANY, Number, Real, Values
from jauspy.codec.nesting import Nesting
from jauspy.codec.streams import Reader, Writer
from jauspy.codec.wire import SIZES, limits
from jauspy.errors import EncodeError


@dataclass(frozen=True, slots=True)
class Bit:
    """Some bits of a bit field: the value is `raw >> shift & mask`."""

    name: str
    shift: int
    mask: int
    values: Values = ANY


@dataclass(frozen=True, slots=True)
class Bits(Item):
    """An integer cut into sub-fields; `cls` holds them, and the bits no sub-field names (`reserved`)."""

    cls: type[Struct]
    code: str
    bits: tuple[Bit, ...]
    reserved: int = field(init=False)

    def __post_init__(self) -> None:
        named = 0
        for bit in self.bits:
            named |= bit.mask << bit.shift
        object.__setattr__(self, "reserved", limits(self.code)[1] & ~named)

    @property
    def minimum(self) -> int:
        return SIZES[self.code]

    def read(self, reader: Reader, path: str) -> Struct:
        offset = reader.at
        raw = reader.count(self.code, path)
        values: dict[str, Any] = {}
        for bit in self.bits:
            value = (raw or 0) >> bit.shift & bit.mask
            if raw is not None and not bit.values.allows(value):
                reader.report(f"{value} is none of {bit.values}", join(path, bit.name), offset)
            values[bit.name] = bit.values.named(value)
        if self.reserved:
            values["reserved_bits"] = (raw or 0) & self.reserved
        return self.cls(**values)

    def write(self, writer: Writer, value: Any, path: str) -> None:
        check_class(value, self.cls, path)
        raw = 0
        for bit in self.bits:
            raw |= self._part(writer, bit, getattr(value, bit.name), join(path, bit.name)) << bit.shift
        if self.reserved:
            reserved = integer_of(value.reserved_bits, join(path, "reserved_bits"))
            if reserved & ~self.reserved:
                reason = f"{cut(f'0x{reserved:X}')} has bits outside 0x{self.reserved:X}"
                raise EncodeError(reason, path=join(path, "reserved_bits"))
            raw |= reserved
        writer.number(self.code, raw)

    @staticmethod
    def _part(writer: Writer, bit: Bit, value: Any, path: str) -> int:
        part = integer_of(value, path)
        if writer.clamp:
            part = int(bit.values.clamp(min(max(part, 0), bit.mask)))
        if not 0 <= part <= bit.mask:
            raise EncodeError(f"{shown(part)} is outside 0..{bit.mask}", path=path)
        if writer.strict and not bit.values.allows(part):
            raise EncodeError(f"{shown(part)} is none of {bit.values}", path=path)
        return part

    def to_json(self, value: Any) -> Any:
        data = {bit.name: bit.values.to_json(getattr(value, bit.name)) for bit in self.bits}
        if self.reserved and value.reserved_bits:
            data["reserved_bits"] = value.reserved_bits
        return data

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Struct:  # noqa: ARG002 - others need it
        names = [bit.name for bit in self.bits]
        check_keys(data, names, ["reserved_bits"] if self.reserved else [], path)
        values = {bit.name: bit.values.from_json(data[bit.name], join(path, bit.name)) for bit in self.bits}
        if "reserved_bits" in data:
            values["reserved_bits"] = integer_of(data["reserved_bits"], join(path, "reserved_bits"))
        return self.cls(**values)


@dataclass(frozen=True, slots=True)
class Choice(Item):
    """A variable field: an index byte, then the number it stands for; `cls` has `choice` and `value`."""

    cls: type[Struct]
    items: Mapping[int, Number | Real]
    index: Values

    @property
    def minimum(self) -> int:
        return 1 + min((item.minimum for item in self.items.values()), default=0)

    def read(self, reader: Reader, path: str) -> Struct:
        offset = reader.at
        chosen = reader.count("B", path)
        if chosen is not None and chosen not in self.items:
            reader.stop(f"index {chosen} is none of {self.index}", join(path, "choice"), offset)
        if chosen is None or chosen not in self.items:
            chosen = next(iter(self.items))
        value = self.items[chosen].read(reader, join(path, "value"))
        return self.cls(choice=self.index.named(chosen), value=value)  # type: ignore[call-arg]  # generated fields

    def write(self, writer: Writer, value: Any, path: str) -> None:
        check_class(value, self.cls, path)
        chosen = integer_of(value.choice, join(path, "choice"))
        if chosen not in self.items:
            raise EncodeError(f"{shown(chosen)} is none of {self.index}", path=join(path, "choice"))
        writer.number("B", chosen)
        self.items[chosen].write(writer, value.value, join(path, "value"))

    def to_json(self, value: Any) -> Any:
        item = self.items.get(value.choice)
        return {
            "choice": self.index.to_json(value.choice),
            "value": item.to_json(value.value) if item else value.value,
        }

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Struct:
        check_keys(data, ["choice", "value"], [], path)
        chosen = self.index.from_json(data["choice"], join(path, "choice"))
        item = self.items.get(chosen)
        if item is None:
            raise EncodeError(f"{shown(chosen)} is none of {self.index}", path=join(path, "choice"))
        value = item.from_json(data["value"], join(path, "value"), nesting)
        return self.cls(choice=chosen, value=value)  # type: ignore[call-arg]  # generated fields
