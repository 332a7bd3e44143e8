"""Places that fill the room between joints' limits evenly, and are the same every time (Halton's sequence)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle
from typing import Final

PRIMES: Final = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)
"""The base of each joint's numbers."""


def spread(number: int, limits: Sequence[tuple[float, float]]) -> tuple[float, ...]:
    """The place of this number, from 1 on."""
    rows = zip(limits, cycle(PRIMES), strict=False)
    return tuple(low + (high - low) * _radical_inverse(number, prime) for (low, high), prime in rows)


def _radical_inverse(number: int, base: int) -> float:
    """The digits of a number behind the point, in reverse."""
    value, scale = 0.0, 1.0
    while number:
        scale /= base
        number, digit = divmod(number, base)
        value += digit * scale
    return value
