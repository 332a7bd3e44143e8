"""Reals sent as integers: real = lower + raw * (upper - lower) / top, with top the largest raw value (AS5684).

Between floats and raw values there are two roads. The straight one is float arithmetic, inlined by the generator;
it is right except within `NEAR_TIE` of a half step, where `exact_raw` decides with rational numbers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Final, Literal

Rounding = Literal["round", "floor", "ceiling"]

NEAR_TIE: Final = 2.0**-16
"""Float arithmetic on raw values below 2**32, and on up to three times as much, errs by a few 2**-20 steps at most."""


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
        """Source of the raw position of `{}`, half a step added: one multiplication and one addition where it can be.

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
    def top_is_exact(self) -> bool:
        """True when `lower + top * step` is `upper` to the last bit."""
        return self.lower + self.top * self.step == self.upper

    def real(self, raw: int) -> float:
        """The real value of a raw one; both ends of the range are exact."""
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

    What a raw value is decoded to becomes that raw value again, also where floor or ceiling would take its neighbour.
    """
    lower, upper = Fraction(repr(scaling.lower)), Fraction(repr(scaling.upper))
    nearest = nearest_raw(value, lower, upper, scaling.top)
    if scaling.function == "round" or scaling.real(nearest) == value:
        return nearest
    return nearest_raw(value, lower, upper, scaling.top, scaling.function)
