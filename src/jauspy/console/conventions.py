"""How one page shows quantities: axes of REP-103 or of JAUS, metres or feet, degrees or radians.

REP-103: x forward, y to the left, z up; angles counterclockwise. JAUS (AS6009): x forward, y to the right, z down;
angles clockwise. Inside the console everything is SI units in the axes of REP-103; only texts and plots change.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, Final

from jauspy.console.languages import sentence

REP_103, JAUS = "REP-103", "JAUS"
METRES, FEET = "m", "ft"
DEGREES, RADIANS = "deg", "rad"
CHOICES: Final[Mapping[str, tuple[str, str]]] = {
    "axes": (REP_103, JAUS),
    "length": (METRES, FEET),
    "angle": (DEGREES, RADIANS),
}
"""What can be chosen; the first of each is the default."""
AXES: Final = {
    REP_103: sentence("x forward, y left, z up; angles counterclockwise (REP-103)"),
    JAUS: sentence("x forward, y right, z down; angles clockwise (JAUS)"),
}
FOOT: Final = 0.3048
"""Metres of a foot (international)."""
_RATES: Final = ("pitch_rate", "yaw_rate", "rotational_acceleration_y", "rotational_acceleration_z")
_ALONG: Final = ("y", "z", "velocity_y", "velocity_z", "acceleration_y", "acceleration_z")
_TURNED: Final = frozenset((*_ALONG, *_RATES, "pitch", "yaw"))
_VEHICLE: Final = frozenset(("LocalPose", "VelocityState", "AccelerationState", "LocalVector"))
"""Reports with axes of the vehicle or its local frame; a global pose has true north, in both conventions."""
_SCALES: Final[Mapping[str, Mapping[str, tuple[str, float]]]] = {
    FEET: {"m": ("ft", 1.0 / FOOT), "m/s": ("ft/s", 1.0 / FOOT), "m/s\u00b2": ("ft/s\u00b2", 1.0 / FOOT)},
    DEGREES: {"rad": ("\u00b0", math.degrees(1.0)), "rad/s": ("\u00b0/s", math.degrees(1.0))},
}


class Conventions:
    """The choice of one page; `on_change` is called after each change."""

    def __init__(self) -> None:
        self.axes, self.length, self.angle = (choices[0] for choices in CHOICES.values())
        self.on_change: list[Callable[[], None]] = []

    def set(self, asked: object) -> None:
        """Take a choice of a browser: names and values of `CHOICES`; what is not valid is ignored."""
        if not isinstance(asked, dict):
            return
        before = self.chosen
        for name, choices in CHOICES.items():
            if asked.get(name) in choices:
                setattr(self, name, asked[name])
        if self.chosen != before:
            for changed in self.on_change:
                changed()

    @property
    def chosen(self) -> dict[str, str]:
        """The choice, as `set` takes it."""
        return {"axes": self.axes, "length": self.length, "angle": self.angle}

    @property
    def axes_text(self) -> str:
        """The axes and the sense of angles, in words."""
        return AXES[self.axes]

    def position(self, x: float, y: float) -> str:
        """A position in metres as text."""
        x, y = self._length(x), self._turned(self._length(y))
        return f"x {x:.2f} {self.length}, y {y:.2f} {self.length}"

    def place(self, x: float, y: float) -> str:
        """A position in metres as a short text, without names of the axes."""
        return f"{self._length(x):.2f}, {self._turned(self._length(y)):.2f} {self.length}"

    def distance(self, metres: float, digits: int = 2) -> str:
        """A distance in metres as text."""
        return f"{self._scaled(metres):.{digits}f} {self.length}"

    def yaw(self, yaw: float) -> str:
        """A yaw of REP-103 in radians as text: of JAUS as a heading from 0 up to less than 360 degrees."""
        if self.axes == REP_103:
            return sentence("yaw {angle}", angle=self.angle_text(math.remainder(yaw, math.tau)))
        heading = -yaw % math.tau
        is_full = self.angle_text(heading) == self.angle_text(math.tau)
        return sentence("heading {angle}", angle=self.angle_text(0.0 if is_full else heading))

    def attitude(self, pitch: float, roll: float) -> str:
        """Pitch and roll of REP-103 in radians as text."""
        return sentence(
            "pitch {pitch}, roll {roll}",
            pitch=self.angle_text(self._turned(pitch)),
            roll=self.angle_text(roll),
        )

    def angle_text(self, angle: float) -> str:
        """An angle in radians as text."""
        if self.angle == RADIANS:
            return f"{round(angle, 2) + 0.0:.2f} rad"
        return f"{round(math.degrees(angle))}\u00b0"

    def speed(self, speed: float) -> str:
        """A speed in m/s as text."""
        return f"{self._length(speed):.1f} {self.length}/s"

    def exact_speed(self, speed: float) -> str:
        """A speed in m/s as text, with as many digits as were entered, at most two."""
        return f"{self._length(speed):g} {self.length}/s"

    def unit(self, kind: str) -> str:
        """The unit of a `length` (with "/s" that of a speed) or an `angle`."""
        return self.length if kind == "length" else "\u00b0" if self.angle == DEGREES else self.angle

    def factor(self, kind: str) -> float:
        """How many of this unit are a metre or a radian."""
        if kind == "length":
            return self._scaled(1.0)
        return math.degrees(1.0) if self.angle == DEGREES else 1.0

    def plotted(self, report: str, path: str, unit: str) -> tuple[float, str]:
        """Factor and unit with which a field of a report, as `LocalPose` and `y`, is shown."""
        factor = -1.0 if self.axes == REP_103 and report in _VEHICLE and path in _TURNED else 1.0
        for chosen in (self.length, self.angle):
            if unit in (scales := _SCALES.get(chosen, {})):
                unit, scale = scales[unit]
                return factor * scale, unit
        return factor, unit

    def for_browser(self) -> dict[str, Any]:
        """What the page's scripts need."""
        return self.chosen

    def _scaled(self, metres: float) -> float:
        return metres if self.length == METRES else metres / FOOT

    def _length(self, metres: float) -> float:
        return round(self._scaled(metres), 2) + 0.0

    def _turned(self, value: float) -> float:
        return (-value if self.axes == JAUS else value) + 0.0
