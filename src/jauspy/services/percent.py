"""Efforts in percent, as messages carry them."""

from __future__ import annotations

from typing import Final

STEP: Final = 200.0 / 65535.0
"""Of a percentage from -100 to 100 in 16 bits. Zero lies between two steps: it arrives half a step off."""


def percent(value: float | None) -> float:
    """An effort that a message holds; zero when it was meant to be, or was left out."""
    return 0.0 if value is None or abs(value) < STEP else value
