"""Layouts of numbers, and the value sets that restrict them."""

# ruff: noqa: D102 - what the methods do is written once, at `Item`

from __future__ import annotations

import math
import re
import struct
from dataclasses import dataclass
from enum import IntEnum
from functools import lru_cache
from typing import Any, Final

from jauspy.codec.item import Item, integer_of, number_of, shown
from jauspy.codec.nesting import Nesting
from jauspy.codec.scaling import Rounding, Scaling, exact_raw
from jauspy.codec.streams import Reader, Writer, codec_of
from jauspy.codec.wire import FLOATS, SIZES, limits
from jauspy.errors import EncodeError

Intervals = tuple[tuple[float, float], ...]


MOST_NAMES = 12
"""Names that an error lists. A message may have an error in every byte, so they must cost little."""


@lru_cache(maxsize=1024)
def describe(intervals: Intervals, enum: type[IntEnum] | None) -> str:
    """The allowed values, for messages."""
    named = list(enum or ())
    parts = [f"{m.value} {m.name}" for m in named[:MOST_NAMES]]
    parts += [f"{len(named) - MOST_NAMES} more names"] if len(named) > MOST_NAMES else []
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
        """Names where there are names."""
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


def odd_to_json(value: float) -> str:
    """What JSON has no numbers for: `inf`, `-inf`, `nan`, or `nan:` and the 64 bits of one with a sign or a payload."""
    bits = struct.pack(">d", value).hex()
    return f"{_NAN}{bits}" if math.isnan(value) and bits != struct.pack(">d", math.nan).hex() else str(value)


def odd_from_json(text: str) -> float | None:
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

    def read(self, reader: Reader, path: str) -> Any:
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

    def write(self, writer: Writer, value: Any, path: str) -> None:
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

    def _float(self, writer: Writer, value: Any, path: str) -> float:
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

    def _check(self, writer: Writer, number: float, path: str) -> None:
        if writer.strict and not self.values.allows(number):
            raise EncodeError(f"{shown(number)} is none of {self.values}", path=path)

    def to_json(self, value: Any) -> Any:
        if isinstance(value, float) and not math.isfinite(value):
            return odd_to_json(value)
        return self.values.to_json(value)

    def from_json(self, data: Any, path: str, nesting: Nesting | None) -> Any:  # noqa: ARG002 - others need it
        if self.code not in FLOATS or (isinstance(data, str) and self.values.enum):
            return self.values.from_json(data, path)
        odd = odd_from_json(data) if isinstance(data, str) else None
        return self.values.named(number_of(data, path)) if odd is None else odd


@dataclass(frozen=True, slots=True)
class Real(Item):
    """A real number sent as a scaled integer."""

    code: str
    scaling: Scaling
    units: str = "one"

    @property
    def minimum(self) -> int:
        return SIZES[self.code]

    def read(self, reader: Reader, path: str) -> float:
        offset = reader.at
        raw = reader.count(self.code, path)
        if raw is None:
            return min(max(0.0, self.scaling.lower), self.scaling.upper)
        if raw < 0:
            reader.report(f"raw value {raw} is below 0", path, offset)
        return self.scaling.real(raw)

    def write(self, writer: Writer, value: Any, path: str) -> None:
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
