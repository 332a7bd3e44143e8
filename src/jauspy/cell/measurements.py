"""The measurements of one run, as plain values for tables and files, and the text of a value with its unit."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, field
from typing import Any, Final

from jauspy.cell.physics import Physics

BATTERY_ENERGY: Final = "battery energy of "
BATTERY_CHARGE: Final = "battery charge of "
BATTERY_VOLTAGE: Final = "battery voltage of "
"""Beginnings of the names of a battery's figures: joules that it gave, the fraction and the volts that it has left."""

UNITS: Final[dict[str, tuple[str, ...]]] = {
    "rad": (
        "ap angle",
        "rp angle",
        "at angle",
        "rt angle",
        "largest_tilt",
        "arm_error",
        "attitude out of reach",
        "tracking error",
        "end error",
    ),
    "m": (
        "ap ",
        "rp ",
        "at ",
        "rt ",
        "dap ",
        "drp ",
        "clearance",
        "largest_error",
        "off_x",
        "off_y",
        "planned_clearance",
        "miss",
        "penetration",
        "first_error",
        "mean_error",
        "placement",
        "driven",
        "overshoot of",
    ),
    "s": (
        "lift_time",
        "there",
        "back",
        "build_time",
        "load_time",
        "order_time",
        "expected_time",
        "saved_by_schedule",
        "settled",
        "stabilisation",
        "drift time",
    ),
    "": ("settled_sooner", "overshoot_ratio"),
    "%": ("load of", "battery charge"),
    "m/s": ("release_speed", "path speed", "attach speed", "landing speed", "collision speed"),
    "rad/s": ("overshoot", "joint speed"),
    "kg": ("payload",),
    "N": ("car_force", "arm_force", "attach force", "landing force", "collision force"),
    "N m": ("arm_moment",),
    "J": ("energy", "build_energy", "battery energy"),
    "V": ("battery voltage",),
}
"""The unit of figures whose names begin like this; the longest beginning counts. Others are numbers."""
SMALL: Final = 0.1
"""Metres below which a length is shown in millimetres."""


@dataclass(slots=True)
class Measured:
    """Measurements of one run."""

    seed: int
    task: str
    success: bool = False
    failure: str = ""
    """Why the run failed; empty after a success."""
    duration: float = 0.0
    """Seconds of the cell's time."""
    cpu: float = 0.0
    """Seconds of CPU time of the process that ran it; differs from run to run."""
    values: dict[str, float] = field(default_factory=dict)
    """Figures by name, SI units."""
    rows: list[dict[str, Any]] = field(default_factory=list)
    """Lines of a table."""
    physics: Physics | None = None
    """What the simulation measured at each step; None for a cell elsewhere."""
    written: tuple[str, ...] = ()
    """What was put in place by writing positions, as the simulation saw it; empty when all was done by the task."""
    film_problem: str = ""
    """Why the film of the run is incomplete, as a sentence; empty if it is complete, or was not wanted."""

    def comparable(self) -> dict[str, Any]:
        """All that is the same in each run with this seed."""
        found = asdict(self)
        del found["cpu"], found["film_problem"]
        return found


def figure_text(name: str, value: float) -> str:
    """A figure for people: with its unit, small lengths in millimetres, angles in degrees, energy in watt hours."""
    matches = [(len(start), unit) for unit, starts in UNITS.items() for start in starts if name.startswith(start)]
    unit = max(matches)[1] if matches else ""
    if unit == "rad":
        value, unit = math.degrees(value), "degrees"
    elif unit == "%":
        value *= 100.0
    elif unit == "m" and abs(value) < SMALL:
        value, unit = 1000.0 * value, "mm"
    elif unit == "J":
        value, unit = value / 3600.0, "Wh"
    digits = ".0f" if 1000.0 <= abs(value) < 1e6 else ".3g"
    return f"{value:{digits}} {unit}".rstrip()
