"""Layouts of containers: records and sequences, lists, variants, arrays."""

from __future__ import annotations

from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Any

from jauspy.codec.items import Count, Item, check_class, cut, integer_of, join, shown
from jauspy.codec.message import Nesting, Struct, counted
from jauspy.codec.scalars import SIZES, limits
from jauspy.codec.slow_path import MessageReader, MessageWriter
from jauspy.errors import EncodeError

# ruff: noqa: D102 - the methods are documented once, in `Item`


@dataclass(frozen=True, slots=True)
class Slot:
    """One attribute of a class: its Python name, its JAUS name, and its wire form."""

    name: str
    jaus: str
    item: Item
    optional: bool = False


@dataclass(frozen=True, slots=True)
class Composite(Item):
    """A record or sequence: an optional presence vector, then the attributes of `cls`.

    `undefined` are the presence bits without a field.
    """

    cls: type[Struct]
    slots: tuple[Slot, ...]
    presence: str | None = None
    undefined: int = field(init=False)

    def __post_init__(self) -> None:
        defined = (1 << sum(slot.optional for slot in self.slots)) - 1
        object.__setattr__(self, "undefined", limits(self.presence)[1] & ~defined if self.presence else 0)

    @property
    def minimum(self) -> int:
        vector = SIZES[self.presence] if self.presence else 0
        return vector + sum(slot.item.minimum for slot in self.slots if not slot.optional)

    def read(self, reader: MessageReader, path: str) -> Struct:
        mask = (reader.count(self.presence, join(path, "presence_vector")) or 0) if self.presence else 0
        values: dict[str, Any] = {}
        bit = 1
        for slot in self.slots:
            if slot.optional:
                present, bit = mask & bit and not reader.stopped, bit << 1
                values[slot.name] = slot.item.read(reader, join(path, slot.name)) if present else None
            else:
                values[slot.name] = slot.item.read(reader, join(path, slot.name))
        if self.undefined:
            values["reserved_presence"] = mask & self.undefined
        return self.cls(**values)

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        check_class(value, self.cls, path)
        if self.presence:
            writer.number(self.presence, self._mask(value, path))
        for slot in self.slots:
            part = getattr(value, slot.name)
            if part is None and slot.optional:
                continue
            if part is None:
                raise EncodeError("a value is required", path=join(path, slot.name))
            slot.item.write(writer, part, join(path, slot.name))

    def _mask(self, value: Any, path: str) -> int:
        mask = 0
        if self.undefined:
            mask = integer_of(value.reserved_presence, join(path, "reserved_presence"))
            if mask & ~self.undefined:
                reason = f"{cut(f'0x{mask:X}')} has bits outside 0x{self.undefined:X}"
                raise EncodeError(reason, path=join(path, "reserved_presence"))
        bit = 1
        for slot in self.slots:
            if slot.optional:
                present = getattr(value, slot.name) is not None
                if present and bit > limits(str(self.presence))[1]:
                    raise EncodeError("the presence vector has no bit for it", path=join(path, slot.name))
                mask |= bit if present else 0
                bit <<= 1
        return mask

    def to_json(self, value: Any) -> Any:
        data = {}
        for slot in self.slots:
            part = getattr(value, slot.name)
            if part is not None:
                data[slot.name] = slot.item.to_json(part)
        if self.undefined and value.reserved_presence:
            data["reserved_presence"] = value.reserved_presence
        return data

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Struct:
        names = [slot.name for slot in self.slots]
        if not isinstance(data, dict):
            raise EncodeError(f"{shown(data)} is not a mapping of fields", path=path)
        for key in data:
            if key not in names and not (key == "reserved_presence" and self.undefined):
                raise EncodeError(f"unknown field {shown(key)}{_hint(key, names)}", path=path)
        values: dict[str, Any] = {}
        for slot in self.slots:
            part = data.get(slot.name)
            if part is None and not slot.optional:
                raise EncodeError("a value is required", path=join(path, slot.name))
            values[slot.name] = None if part is None else slot.item.from_json(part, join(path, slot.name), nesting)
        if "reserved_presence" in data:
            values["reserved_presence"] = integer_of(data["reserved_presence"], join(path, "reserved_presence"))
        return self.cls(**values)


def _hint(key: object, names: list[str]) -> str:
    close = get_close_matches(str(key), names, 1)
    if close:
        return f", did you mean {close[0]!r}?"
    return f", expected {', '.join(names)}" if names else ", there are no fields"


@dataclass(frozen=True, slots=True)
class Repeat(Item):
    """A counted list of one item, which takes at least `each` bytes."""

    count: Count
    item: Item
    each: int = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "each", self.item.minimum)

    @property
    def minimum(self) -> int:
        return SIZES[self.count.code]

    def read(self, reader: MessageReader, path: str) -> list[Any]:
        values: list[Any] = []
        for number in range(self.count.read(reader, path, self.each)):
            if reader.stopped:
                break
            if not reader.left:
                reader.stop(f"the count says more than {counted(number, 'item')}", path)
                break
            values.append(self.item.read(reader, f"{path}[{number}]"))
        return values

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        if not isinstance(value, (list, tuple)):
            raise EncodeError(f"{shown(value)} is not a list", path=path)
        self.count.write(writer, len(value), path)
        for number, part in enumerate(value):
            self.item.write(writer, part, f"{path}[{number}]")

    def to_json(self, value: Any) -> Any:
        return [self.item.to_json(part) for part in value]

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> list[Any]:
        if not isinstance(data, (list, tuple)):
            raise EncodeError(f"{shown(data)} is not a list", path=path)
        return [self.item.from_json(part, f"{path}[{number}]", nesting) for number, part in enumerate(data)]


@dataclass(frozen=True, slots=True)
class Union(Item):
    """A tag, then the arm that it selects; the class of a value determines the arm."""

    code: str
    arms: dict[str, Composite]

    @classmethod
    def of(cls, code: str, /, **classes: type[Struct]) -> Union:
        """A variant of these classes in the order of their tags, under the names JSON and paths use."""
        layouts = {name: arm.layout() for name, arm in classes.items()}
        return cls(code, {name: layout for name, layout in layouts.items() if isinstance(layout, Composite)})

    @property
    def minimum(self) -> int:
        return SIZES[self.code] + min((arm.minimum for arm in self.arms.values()), default=0)

    def read(self, reader: MessageReader, path: str) -> Struct:
        offset = reader.at
        tag = reader.count(self.code, path) or 0
        if tag >= len(self.arms):
            reader.stop(f"tag {tag} is outside 0..{len(self.arms) - 1}", path, offset)
            tag = 0
        name, arm = list(self.arms.items())[tag]
        return arm.read(reader, join(path, name))

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        for tag, (name, arm) in enumerate(self.arms.items()):
            if type(value) is arm.cls:
                writer.number(self.code, tag)
                arm.write(writer, value, join(path, name))
                return
        classes = ", ".join(arm.cls.__qualname__ for arm in self.arms.values())
        raise EncodeError(f"{shown(value)} is none of {classes}", path=path)

    def to_json(self, value: Any) -> Any:
        return {name: arm.to_json(value) for name, arm in self.arms.items() if arm.cls is type(value)}

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Struct:
        if not isinstance(data, dict) or len(data) != 1 or next(iter(data)) not in self.arms:
            raise EncodeError(f"{shown(data)} is not a mapping with one of {', '.join(self.arms)}", path=path)
        name, fields = next(iter(data.items()))
        return self.arms[name].from_json(fields, join(path, name), nesting)


@dataclass(frozen=True, slots=True)
class Grid(Item):
    """An array: lists in lists, the first dimension outermost."""

    item: Item
    sizes: tuple[int, ...]

    @property
    def minimum(self) -> int:
        total = self.item.minimum
        for size in self.sizes:
            total *= size
        return total

    def _inner(self) -> Item:
        return Grid(self.item, self.sizes[1:]) if len(self.sizes) > 1 else self.item

    def read(self, reader: MessageReader, path: str) -> list[Any]:
        inner = self._inner()
        return [inner.read(reader, f"{path}[{number}]") for number in range(self.sizes[0])]

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        if not isinstance(value, (list, tuple)) or len(value) != self.sizes[0]:
            raise EncodeError(f"{shown(value)} is not a list of {self.sizes[0]}", path=path)
        inner = self._inner()
        for number, part in enumerate(value):
            inner.write(writer, part, f"{path}[{number}]")

    def to_json(self, value: Any) -> Any:
        inner = self._inner()
        return [inner.to_json(part) for part in value]

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> list[Any]:
        if not isinstance(data, (list, tuple)) or len(data) != self.sizes[0]:
            raise EncodeError(f"{shown(data)} is not a list of {self.sizes[0]}", path=path)
        inner = self._inner()
        return [inner.from_json(part, f"{path}[{number}]", nesting) for number, part in enumerate(data)]
