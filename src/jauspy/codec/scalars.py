"""Number types on the wire: `struct` codes, sizes, limits, and reals that are sent as integers (AS5684).

Everything is little-endian. A real is lower + raw * (upper - lower) / top, with top the largest raw value. The fast
path uses float arithmetic, which is right except within `NEAR_TIE` of a half step; there `exact_raw` decides with
rational numbers.
"""

from __future__ import annotations

import math
import re
import struct
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import groupby
from typing import TYPE_CHECKING, Final, Literal

if TYPE_CHECKING:  # the loader behind `jauspy.schema` is heavy, and messages do not need it
    from jauspy.schema.model import Scalar

CODES: Final[dict[Scalar, str]] = {
    "u8": "B",
    "u16": "H",
    "u32": "I",
    "u64": "Q",
    "i8": "b",
    "i16": "h",
    "i32": "i",
    "i64": "q",
    "f32": "f",
    "f64": "d",
}
SIZES: Final[dict[str, int]] = {"B": 1, "H": 2, "I": 4, "Q": 8, "b": 1, "h": 2, "i": 4, "q": 8, "f": 4, "d": 8}
FLOATS: Final = frozenset("fd")


def limits(code: str) -> tuple[int, int]:
    """The smallest and largest value of an integer code."""
    bits = 8 * SIZES[code]
    return (0, 2**bits - 1) if code.isupper() else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)


def as_sent(number: float, code: str) -> float:
    """The number rounded to this type, since limits in decimals apply to the numbers that can be sent."""
    rounded: float = struct.unpack(f"<{code}", struct.pack(f"<{code}", number))[0]
    return rounded


def compact(codes: str) -> str:
    """`BBBH` to `3BH`; counted codes such as `80s` stay."""
    parts = re.findall(r"\d+[sx]|[a-zA-Z]", codes)
    grouped = [(part, len(list(same))) for part, same in groupby(parts)]
    return "".join(part * n if part[0].isdigit() else f"{n}{part}" if n > 1 else part for part, n in grouped)


Rounding = Literal["round", "floor", "ceiling"]

NEAR_TIE: Final = 2.0**-16
"""Steps around a half step within which float arithmetic may round wrongly; its errors are a few 2**-20 steps."""

MOST_OF_FLOAT: Final = 2**53
"""The integer up to which a float of 64 bits holds all integers."""


@dataclass(frozen=True, slots=True, eq=False)
class Scaling:
    """A scale range over raw values 0..`top`; `step` is the float width of one raw step."""

    lower: float
    upper: float
    top: int
    function: Rounding = "round"

    @property
    def factor(self) -> float:
        """Raw steps per unit."""
        return self.top / (self.upper - self.lower)

    @property
    def position(self) -> str:
        """Source of the raw position of `{}` plus half a step: one multiplication and one addition if possible.

        Where the range is far away from 0 compared to its width, they would lose too many digits.
        """
        shift = -self.lower * self.factor
        if abs(shift) <= 2 * self.top:
            return f"{{}} * {self.factor!r} + {shift + 0.5!r}"
        return f"({{}} - {self.lower!r}) * {self.factor!r} + 0.5"

    @property
    def step(self) -> float:
        """Units per raw step, nudged by a few units in the last place so that the top raw value gives `upper`."""
        step = (self.upper - self.lower) / self.top
        for direction in (math.inf, -math.inf):
            candidate = step
            for _ in range(8):
                if self.lower + self.top * candidate == self.upper:
                    return candidate
                candidate = math.nextafter(candidate, direction)
        return step

    @property
    def is_finer_than_floats(self) -> bool:
        """True where neighbouring raw values are the same float of 64 bits, so that decoding loses the last bits."""
        return self.top > MOST_OF_FLOAT

    @property
    def top_is_exact(self) -> bool:
        """True when `lower + top * step` is `upper` to the last bit."""
        return self.lower + self.top * self.step == self.upper

    def real(self, raw: int) -> float:
        """The real value of a raw one; both ends of the range are exact."""
        if self.is_finer_than_floats:
            lower, upper = Fraction(repr(self.lower)), Fraction(repr(self.upper))
            return float(lower + raw * (upper - lower) / self.top)
        return self.upper if raw == self.top else self.lower + raw * self.step

    def contains(self, value: float) -> bool:
        """True for numbers within the range, ends included; false for NaN."""
        return self.lower <= value <= self.upper


def nearest_raw(value: float, lower: Fraction, upper: Fraction, top: int, function: Rounding = "round") -> int:
    """The raw value of a number in rational arithmetic; a half step rounds up."""
    position = (Fraction(value) - lower) * top / (upper - lower)
    if function == "floor":
        raw = math.floor(position)
    elif function == "ceiling":
        raw = math.ceil(position)
    else:
        raw = math.floor(position + Fraction(1, 2))
    return min(max(raw, 0), top)


@lru_cache(maxsize=4096)
def exact_raw(value: float, scaling: Scaling) -> int:
    """The raw value of a real within the range; the limits mean their shortest decimal form.

    The decoded value of a raw one is encoded as that raw value, also where floor or ceiling would give a neighbour.
    """
    lower, upper = Fraction(repr(scaling.lower)), Fraction(repr(scaling.upper))
    nearest = nearest_raw(value, lower, upper, scaling.top)
    if scaling.function == "round" or scaling.real(nearest) == value:
        return nearest
    return nearest_raw(value, lower, upper, scaling.top, scaling.function)
