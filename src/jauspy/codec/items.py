"""Items of layouts that hold one value: numbers, bit fields, strings, bytes, messages inside messages.

`Item` is what they and the containers in `jauspy.codec.layout` have in common.
"""

from __future__ import annotations

import math
import re
import struct
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import IntEnum
from functools import lru_cache
from operator import index
from typing import Any, Final

from jauspy.codec.message import Message, Nesting, NestingSource, Struct, counted
from jauspy.codec.scalars import FLOATS, SIZES, Rounding, Scaling, exact_raw, limits
from jauspy.codec.slow_path import MessageReader, MessageWriter, codec_of
from jauspy.errors import EncodeError

MAX_SHOWN: Final = 100
"""Characters of an invalid value that an error shows."""


def join(path: str, name: str) -> str:
    """The path of a field inside another."""
    return f"{path}.{name}" if path else name


class Item(ABC):
    """The wire form of one value; every method takes the field path for its errors."""

    __slots__ = ()

    @property
    @abstractmethod
    def minimum(self) -> int:
        """Minimal size in bytes."""

    @abstractmethod
    def read(self, reader: MessageReader, path: str) -> Any:
        """Read the next value; returns a default if the reader has stopped."""

    @abstractmethod
    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        """Append the value; raises `EncodeError`."""

    def to_json(self, value: Any) -> Any:
        """Convert the value to its JSON form."""
        return value

    @abstractmethod
    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Any:
        """The inverse of `to_json`; raises `EncodeError` for another type. Limits are checked when it is encoded."""


def shown(value: object) -> str:
    """The text of a value in an error, shortened if it is long."""
    try:
        text = repr(value)
    except (ValueError, RecursionError):  # an integer of more digits than Python prints, or a list that contains itself
        text = f"this {type(value).__name__}"
    return cut(text)


def cut(text: str) -> str:
    """The beginning and the end of a long text."""
    return text if len(text) <= MAX_SHOWN else f"{text[: MAX_SHOWN - 13]}...{text[-10:]}"


def number_of(value: Any, path: str) -> float:
    """A finite float, or `EncodeError`."""
    if isinstance(value, (str, bytes, bytearray)):
        raise EncodeError(f"{shown(value)} is not a number", path=path)
    try:
        number = float(value)
    except OverflowError as error:
        raise EncodeError(f"{shown(value)} is too large", path=path) from error
    except (TypeError, ValueError) as error:
        raise EncodeError(f"{shown(value)} is not a number", path=path) from error
    return number


def integer_of(value: Any, path: str) -> int:
    """An int, or `EncodeError`."""
    try:
        return index(value)
    except TypeError as error:
        raise EncodeError(f"{shown(value)} is not an integer", path=path) from error


def check_class(value: Any, cls: type[Struct], path: str) -> None:
    """Raise `EncodeError` unless `value` is a `cls`."""
    if not isinstance(value, cls):
        raise EncodeError(f"{shown(value)} is not a {cls.__qualname__}", path=path)


def check_keys(data: Any, required: list[str], optional: list[str], path: str) -> None:
    """Raise `EncodeError` unless `data` is a dict with these keys."""
    if not isinstance(data, dict):
        raise EncodeError(f"{shown(data)} is not a mapping with {', '.join(required + optional)}", path=path)
    unknown = [key for key in data if key not in required and key not in optional]
    if unknown:
        known = ", ".join(required + optional) or "no fields"
        raise EncodeError(f"unknown field {shown(unknown[0])}, expected {known}", path=path)
    missing = [key for key in required if key not in data]
    if missing:
        raise EncodeError("a value is required", path=join(path, missing[0]))


# ruff: noqa: D102 - the methods are documented once, in `Item`


Intervals = tuple[tuple[float, float], ...]


MAX_NAMES = 12
"""Names that an error lists; a message may have an error in every byte, so errors must be cheap."""


@lru_cache(maxsize=1024)
def describe(intervals: Intervals, enum: type[IntEnum] | None) -> str:
    """The allowed values, for errors."""
    named = list(enum or ())
    parts = [f"{m.value} {m.name}" for m in named[:MAX_NAMES]]
    parts += [f"{len(named) - MAX_NAMES} more names"] if len(named) > MAX_NAMES else []
    parts += [f"{lower}..{upper}" if lower != upper else f"{lower}" for lower, upper in intervals]
    return ", ".join(parts)


@dataclass(frozen=True, slots=True)
class Values:
    """A value set: named values and intervals, both ends included; empty allows all."""

    enum: type[IntEnum] | None = None
    intervals: Intervals = ()

    @property
    def anything(self) -> bool:
        """True when every value is allowed."""
        return self.enum is None and not self.intervals

    def named(self, value: float) -> Any:
        """The enum member of a value, or the value."""
        # A call of the class costs three times as much, and 64 kB may be a million small values.
        return value if self.enum is None else self.enum._value2member_map_.get(value, value)

    def allows(self, value: float) -> bool:
        """True when the value is in the set."""
        if self.enum is None:
            return not self.intervals or self._within(value)
        return value in self.enum._value2member_map_ or self._within(value)

    def _within(self, value: float) -> bool:
        return any(lower <= value <= upper for lower, upper in self.intervals)

    def clamp(self, value: float) -> float:
        """The nearest number between the smallest and the largest allowed one."""
        named = [float(m) for m in self.enum] if self.enum else []
        ends = [*named, *(end for interval in self.intervals for end in interval)]
        return min(max(value, min(ends)), max(ends)) if ends else value

    def __str__(self) -> str:
        return describe(self.intervals, self.enum)

    def to_json(self, value: Any) -> Any:
        """The member's name if the value has one, else the value."""
        return self.named(value).name if isinstance(self.named(value), IntEnum) else value

    def from_json(self, data: Any, path: str) -> Any:
        """Accepts names and integers."""
        if isinstance(data, str) and self.enum:
            if data not in self.enum.__members__:
                raise EncodeError(f"{shown(data)} is none of {', '.join(self.enum.__members__)}", path=path)
            return self.enum[data]
        return self.named(integer_of(data, path))


ANY = Values()


_NAN: Final = "nan:"


def non_finite_to_json(value: float) -> str:
    """The JSON text of a float that is no JSON number: `inf`, `-inf`, `nan`, or `nan:` and 64 bits."""
    bits = struct.pack(">d", value).hex()
    return f"{_NAN}{bits}" if math.isnan(value) and bits != struct.pack(">d", math.nan).hex() else str(value)


def non_finite_from_json(text: str) -> float | None:
    """The inverse; None for all else."""
    if text in ("nan", "inf", "-inf"):
        return float(text)
    bits = text.removeprefix(_NAN)
    if bits == text or not re.fullmatch(r"[0-9a-f]{16}", bits):
        return None
    value: float = struct.unpack(">d", bytes.fromhex(bits))[0]
    return value if math.isnan(value) else None


@dataclass(frozen=True, slots=True)
class Number(Item):
    """An integer or float of a `struct` code."""

    code: str
    values: Values = ANY
    units: str = "one"

    @property
    def minimum(self) -> int:
        return SIZES[self.code]

    def read(self, reader: MessageReader, path: str) -> Any:
        offset = reader.at
        value = reader.number(self.code, path)
        if value is None:
            return 0.0 if self.code in FLOATS else 0
        if not math.isfinite(value):
            # a signalling NaN of four bytes becomes a quiet one, as a float of Python has eight
            kept = codec_of(self.code).pack(value) == reader.data[offset : reader.at]
            reader.report(f"{value} is not a finite number", path, offset, lost=not kept)
        elif not self.values.allows(value):
            reader.report(f"{value} is none of {self.values}", path, offset)
        return self.values.named(value)

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        if self.code in FLOATS:
            writer.number(self.code, self._float(writer, value, path))
        else:
            number = integer_of(value, path)
            lowest, highest = limits(self.code)
            if writer.clamp:
                number = int(self.values.clamp(min(max(number, lowest), highest)))
            if not lowest <= number <= highest:
                raise EncodeError(f"{shown(number)} is outside {lowest}..{highest}", path=path)
            self._check(writer, number, path)
            writer.number(self.code, number)

    def _float(self, writer: MessageWriter, value: Any, path: str) -> float:
        number = number_of(value, path)
        if not math.isfinite(number):
            if writer.strict:
                raise EncodeError(f"{number} is not a finite number", path=path)
            return number
        if writer.clamp:
            number = self.values.clamp(number)
        self._check(writer, number, path)
        largest = 3.4028234663852886e38
        if self.code == "f" and abs(number) > largest:
            if not writer.clamp:
                raise EncodeError(f"{number} is outside {-largest}..{largest}", path=path)
            number = math.copysign(largest, number)
        return number

    def _check(self, writer: MessageWriter, number: float, path: str) -> None:
        if writer.strict and not self.values.allows(number):
            raise EncodeError(f"{shown(number)} is none of {self.values}", path=path)

    def to_json(self, value: Any) -> Any:
        if isinstance(value, float) and not math.isfinite(value):
            return non_finite_to_json(value)
        return self.values.to_json(value)

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Any:  # noqa: ARG002 - others need it
        if self.code not in FLOATS or (isinstance(data, str) and self.values.enum):
            return self.values.from_json(data, path)
        number = non_finite_from_json(data) if isinstance(data, str) else None
        return self.values.named(number_of(data, path)) if number is None else number


@dataclass(frozen=True, slots=True)
class Real(Item):
    """A real number sent as a scaled integer."""

    code: str
    scaling: Scaling
    units: str = "one"

    @property
    def minimum(self) -> int:
        return SIZES[self.code]

    def read(self, reader: MessageReader, path: str) -> float:
        offset = reader.at
        raw = reader.count(self.code, path)
        if raw is None:
            return min(max(0.0, self.scaling.lower), self.scaling.upper)
        if raw < 0:
            reader.report(f"raw value {raw} is below 0", path, offset)
        return self.scaling.real(raw)

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        number = number_of(value, path)
        lower, upper = self.scaling.lower, self.scaling.upper
        if writer.clamp and not math.isnan(number):
            number = min(max(number, lower), upper)
        if self.scaling.contains(number):
            writer.number(self.code, exact_raw(number, self.scaling))
            return
        raw = self._negative_raw(number)
        if writer.strict or raw is None:
            units = "" if self.units == "one" else f" {self.units}"
            raise EncodeError(f"{number} is outside {lower}..{upper}{units}", path=path)
        writer.number(self.code, raw)

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> float:  # noqa: ARG002 - others need it
        return number_of(data, path)

    def _negative_raw(self, number: float) -> int | None:
        """The raw value below 0 that a tolerant decoder read, for signed types."""
        if self.code.isupper() or not math.isfinite(number):
            return None
        raw = round((number - self.scaling.lower) * self.scaling.factor)
        return raw if limits(self.code)[0] <= raw < 0 else None


@lru_cache(maxsize=4096)
def real(code: str, lower: float, upper: float, units: str = "one", function: Rounding = "round") -> Real:
    """The layout of a real number with this range over all raw values of its type from 0."""
    return Real(code, Scaling(lower, upper, limits(code)[1], function), units)


# ruff: noqa: D102 - the methods are documented once, in `Item`


@dataclass(frozen=True, slots=True)
class Bit:
    """A sub-field of a bit field: the value is `raw >> shift & mask`."""

    name: str
    shift: int
    mask: int
    values: Values = ANY


@dataclass(frozen=True, slots=True)
class Bits(Item):
    """An integer with sub-fields; `cls` has them, and the other bits as `reserved`."""

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

    def read(self, reader: MessageReader, path: str) -> Struct:
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

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
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
    def _part(writer: MessageWriter, bit: Bit, value: Any, path: str) -> int:
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
    """A variable field: an index byte, then the number that it selects; `cls` has `choice` and `value`."""

    cls: type[Struct]
    items: Mapping[int, Number | Real]
    index: Values

    @property
    def minimum(self) -> int:
        return 1 + min((item.minimum for item in self.items.values()), default=0)

    def read(self, reader: MessageReader, path: str) -> Struct:
        offset = reader.at
        chosen = reader.count("B", path)
        if chosen is not None and chosen not in self.items:
            reader.stop(f"index {chosen} is none of {self.index}", join(path, "choice"), offset)
        if chosen is None or chosen not in self.items:
            chosen = next(iter(self.items))
        value = self.items[chosen].read(reader, join(path, "value"))
        return self.cls(choice=self.index.named(chosen), value=value)  # type: ignore[call-arg]  # generated fields

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
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


# ruff: noqa: D102 - the methods are documented once, in `Item`


@dataclass(frozen=True, slots=True)
class Count:
    """A count on the wire: its `struct` code and its limits."""

    code: str
    minimum: int
    maximum: int

    def read(self, reader: MessageReader, path: str, each: int = 1) -> int:
        """The count, checked against its limits and the bytes left; 0 once stopped."""
        offset = reader.at
        count = reader.count(self.code, path)
        if count is None:
            return 0
        if not self.minimum <= count <= self.maximum:
            reader.report(f"count {count} is outside {self.minimum}..{self.maximum}", path, offset)
        if count * each > reader.left and reader.strict:
            reader.report(
                f"count {count} needs at least {counted(count * each, 'byte')}, {reader.left} left", path, offset
            )
        return count

    def write(self, writer: MessageWriter, count: int, path: str) -> None:
        """Raises `EncodeError` for a count beyond the limits."""
        _, highest = limits(self.code)
        low, high = (self.minimum, min(self.maximum, highest)) if writer.strict else (0, highest)
        if not low <= count <= high:
            raise EncodeError(f"count {count} is outside {low}..{high}", path=path)
        writer.number(self.code, count)


@dataclass(frozen=True, slots=True)
class Text(Item):
    """A string, one byte per character (Latin-1): of `length` bytes, NUL padded, or counted."""

    length: int = 0
    count: Count | None = None

    @property
    def minimum(self) -> int:
        return SIZES[self.count.code] if self.count else self.length

    def read(self, reader: MessageReader, path: str) -> str:
        size = self.count.read(reader, path) if self.count else self.length
        data = reader.take(size, path) or b""
        return (data if self.count else data.rstrip(b"\0")).decode("latin-1")

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        if not isinstance(value, str):
            raise EncodeError(f"{shown(value)} is not a string", path=path)
        try:
            data = value.encode("latin-1")
        except UnicodeEncodeError as error:
            raise EncodeError(f"{value[error.start]!r} is not a Latin-1 character", path=path) from error
        if self.count:
            self.count.write(writer, len(data), path)
        elif len(data) > self.length:
            raise EncodeError(f"{len(data)} characters are more than {self.length}", path=path)
        writer.out += data.ljust(self.length, b"\0")

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> str:  # noqa: ARG002 - others need it
        if not isinstance(data, str):
            raise EncodeError(f"{shown(data)} is not a string", path=path)
        return data


@dataclass(frozen=True, slots=True)
class Blob(Item):
    """Counted bytes; with `nested`, a message where the bytes are one."""

    count: Count
    nested: NestingSource | None = None

    @property
    def minimum(self) -> int:
        return SIZES[self.count.code]

    def read(self, reader: MessageReader, path: str) -> Message | bytes:
        data = reader.take(self.count.read(reader, path), path) or b""
        return (reader.nesting or self.nested.nesting).message(data) if self.nested and not reader.stopped else data

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        data = blob_bytes(writer, value, path, nested=self.nested is not None)
        self.count.write(writer, len(data), path)
        writer.out += data

    def to_json(self, value: Any) -> Any:
        return blob_to_json(value)

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Any:
        return blob_from_json(data, path, inside(self.nested, nesting))


@dataclass(frozen=True, slots=True)
class Formatted(Item):
    """A format index, a count, then bytes; `cls` has `format` and `data`."""

    cls: type[Struct]
    formats: Values
    count: Count
    nested: NestingSource | None = None
    nested_formats: frozenset[int] = frozenset()

    @property
    def minimum(self) -> int:
        return 1 + SIZES[self.count.code]

    def read(self, reader: MessageReader, path: str) -> Struct:
        offset = reader.at
        chosen = reader.count("B", path)
        if chosen is not None and not self.formats.allows(chosen):
            reader.report(f"format {chosen} is none of {self.formats}", join(path, "format"), offset)
        where = join(path, "data")
        data: Message | bytes = reader.take(self.count.read(reader, where), where) or b""
        if self.nested and chosen in self.nested_formats and isinstance(data, bytes):
            data = (reader.nesting or self.nested.nesting).message(data)
        return self.cls(format=self.formats.named(chosen or 0), data=data)  # type: ignore[call-arg]  # generated fields

    def write(self, writer: MessageWriter, value: Any, path: str) -> None:
        check_class(value, self.cls, path)
        chosen = integer_of(value.format, join(path, "format"))
        if not 0 <= chosen <= 255 or (writer.strict and not self.formats.allows(chosen)):
            raise EncodeError(f"{shown(chosen)} is none of {self.formats}", path=join(path, "format"))
        data = blob_bytes(writer, value.data, join(path, "data"), nested=chosen in self.nested_formats)
        writer.number("B", chosen)
        self.count.write(writer, len(data), join(path, "data"))
        writer.out += data

    def to_json(self, value: Any) -> Any:
        return {"format": self.formats.to_json(value.format), "data": blob_to_json(value.data)}

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Struct:
        check_keys(data, ["format", "data"], [], path)
        chosen = self.formats.from_json(data["format"], join(path, "format"))
        content = blob_from_json(data["data"], join(path, "data"), inside(self.nested, nesting))
        return self.cls(format=chosen, data=content)  # type: ignore[call-arg]  # generated fields


def inside(known: NestingSource | None, nesting: Nesting | None) -> Nesting | None:
    """The registry for messages inside a field: the one that decodes, else the one that the class belongs to."""
    return (nesting or known.nesting) if known else None


def blob_bytes(writer: MessageWriter, value: Any, path: str, *, nested: bool) -> bytes:
    """The bytes of a field that accepts bytes, or also a message if `nested`."""
    if nested and isinstance(value, Message):
        inner = MessageWriter(clamp=writer.clamp, strict=writer.strict)
        inner.depth = writer.depth
        inner.message(value, path)
        return bytes(inner.out)
    if not isinstance(value, (bytes, bytearray, memoryview)):
        raise EncodeError(f"{shown(value)} is not {'a message or ' if nested else ''}bytes", path=path)
    return bytes(value)


def message_to_dict(message: Message) -> dict[str, Any]:
    """The JSON form of a message: its name, service and version, and its `fields`."""
    head = {"message": message.NAME, "service": message.SERVICE, "version": message.VERSION}
    return {**head, "fields": message.to_dict()}


def blob_to_json(value: Any) -> Any:
    """`{"hex": ...}`, or `message_to_dict`."""
    return message_to_dict(value) if isinstance(value, Message) else {"hex": bytes(value).hex()}


def blob_from_json(data: Any, path: str, nesting: Nesting | None) -> Any:
    """The inverse of `blob_to_json`; also takes bytes and messages as they are."""
    if isinstance(data, (bytes, Message)):
        return data
    if isinstance(data, dict) and isinstance(data.get("hex"), str) and len(data) == 1:
        try:
            return bytes.fromhex(data["hex"])
        except ValueError as error:
            raise EncodeError(f"{shown(data['hex'])} is not hexadecimal", path=path) from error
    if nesting and isinstance(data, dict) and isinstance(data.get("message"), str):
        return nesting.from_dict(data, path)
    raise EncodeError(f'{shown(data)} is neither {{"hex": ...}} nor {{"message": ..., "fields": ...}}', path=path)


__all__ = [
    "ANY",
    "Bit",
    "Bits",
    "Blob",
    "Choice",
    "Count",
    "Formatted",
    "Item",
    "Number",
    "Real",
    "Text",
    "Values",
    "message_to_dict",
    "real",
]
