"""The symbols of units that JSIDL writes in words."""

from __future__ import annotations

from typing import Final

_SYMBOLS: Final = {
    "one": "",
    "meter": "m",
    "meter per second": "m/s",
    "meter per second squared": "m/s²",
    "radian": "rad",
    "radian per second": "rad/s",
    "second": "s",
    "minute": "min",
    "hertz": "Hz",
    "percent": "%",
    "rotations per minute": "rpm",
    "newton": "N",
    "newton meter": "N·m",
    "degree Celsius": "°C",
    "volt": "V",
    "ampere": "A",
    "pascal": "Pa",
    "kilogram": "kg",
}


def unit_symbol(units: str) -> str:
    """`m/s` for `meter per second`; units without a symbol are returned unchanged."""
    return _SYMBOLS.get(units, units)
