"""How often an event reports, and what its client is told about that: the same number."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from jauspy.arguments import check_number
from jauspy.errors import ConfigError

RATE_STEP: Final = 1092 / 65535
"""Rates travel as 16-bit numbers of 0..1092 Hz."""


@dataclass(frozen=True, slots=True)
class EventRates:
    """Limits (Hz) of periodic events, and of how often every-change events look for a change; 0 is never."""

    lowest: float
    highest: float
    change: float

    def __post_init__(self) -> None:
        for name, value in (("min_rate", self.lowest), ("max_rate", self.highest), ("max_change_rate", self.change)):
            check_number(value, f"events: {name}")
        if not 0 < self.lowest <= 1092 or not 0 <= self.highest <= 1092 or not 0 <= self.change <= 1092:
            raise ConfigError(
                f"events: min_rate {self.lowest}, max_rate {self.highest} and max_change_rate {self.change} "
                "must be 0..1092 Hz, and min_rate more than 0"
            )

    def periodic(self, asked: float) -> float:
        """The rate of a periodic event."""
        return _on_wire(max(asked, self.lowest), self.highest)

    def on_change(self, asked: float) -> float:
        """The most that an every-change event reports; 0, as asked for, leaves it open: as often as allowed."""
        return _on_wire(asked, self.change) if asked else 0.0


def _on_wire(rate: float, most: float) -> float:
    """The nearest rate that the wire can say, and not more than allowed unless that is less than one step."""
    steps = min(round(rate / RATE_STEP), int(most / RATE_STEP + 1e-6))
    return max(1, steps) * RATE_STEP
