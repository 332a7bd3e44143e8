"""Faults that a trial causes in a simulated cell; clients learn of them only by what components report."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from jauspy_sim.cell.connectors import Attachments
from jauspy_sim.cell.equipment import SimulatedPartSensor
from jauspy_sim.cell.servos import SimulatedServo


class Faults:
    """Breaks parts of a cell; `now` gives seconds of the robot's clock."""

    def __init__(
        self,
        attachments: Attachments,
        sensor: SimulatedPartSensor,
        servos: Mapping[str, SimulatedServo],
        now: Callable[[], float],
    ) -> None:
        self._attachments, self._sensor, self._servos, self._now = attachments, sensor, servos, now

    def vent(self, connector: str) -> None:
        """Have a connector, or the gripper, lose what it holds."""
        self._attachments.vent(self._attachments.connectors[connector], "the vacuum was lost: the line leaks")

    def blind(self, seconds: float) -> None:
        """Have the part sensor observe nothing for a while."""
        self._sensor.blind(self._now() + seconds)

    def seize(self, servo: str) -> None:
        """Block the gear of a servo module."""
        self._servos[servo].seize()
