"""The battery of the chosen robot, in the bar of the page."""

from __future__ import annotations

from typing import Final

from nicegui import ui

from jauspy.console.languages import joined, sentence
from jauspy.console.markup import attributes
from jauspy.console.page_language import translated
from jauspy.errors import JausError
from jauspy.ocu.robot import POWER_PLANT, Robot
from jauspy.ocu.state import BatteryReport

UPDATE_INTERVAL: Final = 2.0
"""Seconds between two queries."""
LOW: Final = 0.2
"""Fraction of the capacity below which the text is shown as a warning."""
EMPTY: Final = 0.05
"""The same, as an alarm."""


class BatteryLabel:
    """A text such as `battery 87 %  33.1 V  128 W`; nothing for a robot that reports no battery."""

    def __init__(self) -> None:
        self.text, self.level = "", "unknown"
        """What is shown, and its level as in `battery_text`."""
        self._robot: Robot | None = None
        self._label = ui.label("").classes("battery").props('role="status"')
        self._label.set_visibility(False)
        ui.timer(UPDATE_INTERVAL, self._update)

    def show(self, robot: Robot | None) -> None:
        """Show this robot's battery from the next update on."""
        self._robot = robot
        self.text, self.level = "", "unknown"
        self._label.set_visibility(False)

    def close(self) -> None:
        """Query no more."""
        self._robot = None

    async def _update(self) -> None:
        robot = self._robot
        if robot is None or not any(component.find(POWER_PLANT) for component in robot.components):
            return
        try:
            text, level = battery_text(await robot.battery())
        except JausError:
            text, level = sentence("battery ?"), "unknown"  # the panel Fleet says which components are silent
        if robot is self._robot and not self._label.is_deleted:
            self.text, self.level = text, level
            self._label.set_text(translated(text))
            attributes(self._label, data_level=level)
            self._label.set_visibility(bool(text))


def battery_text(report: BatteryReport) -> tuple[str, str]:
    """The text for a report, and its level: `good`, `low`, `empty`, or `unknown`."""
    values = ((None if report.charge is None else 100.0 * report.charge, "%"), (report.voltage, "V"))
    shown = [f"{value:.{0 if unit == '%' else 1}f} {unit}" for value, unit in values if value is not None]
    if report.power is not None:
        shown.append(f"{report.power:.0f} W")
    if report.charge is None:
        return joined([sentence("battery"), *shown], "  "), "unknown"
    level = "empty" if report.charge < EMPTY else "low" if report.charge < LOW else "good"
    sign = {"good": "", "low": "\u26a0 ", "empty": "\u2716 "}[level]
    return joined([joined([sign, sentence("battery")], ""), *shown], "  "), level
