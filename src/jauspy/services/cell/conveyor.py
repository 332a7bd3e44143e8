"""Conveyor: runs a belt at a speed."""

from __future__ import annotations

import math

from jauspy.messages.cell import ReportConveyorState, SetConveyorSpeed
from jauspy.platform.modular.cell import Conveyor
from jauspy.services.service import Service


class ConveyorService(Service, urn="urn:jauspy:cell:Conveyor"):
    """A belt; `max_speed` in m/s. It stops when Ready is left, and when the client in control is lost."""

    def __init__(self, conveyor: Conveyor, max_speed: float) -> None:
        self._conveyor = conveyor
        self._max_speed = max_speed
        self._commanded = 0.0

    def set_conveyor_speed(self, msg: SetConveyorSpeed) -> None:
        """Run at a speed in m/s, limited to `max_speed`; infinite and NaN speeds are ignored and counted."""
        if not math.isfinite(msg.speed):
            self.host.count("invalid_speed", f"{msg}")
            return
        self._commanded = min(self._max_speed, max(-self._max_speed, msg.speed))
        self._conveyor.set_speed(self._commanded)

    def stop_conveyor(self) -> None:
        """Stop; runs when Ready is left."""
        self._commanded = 0.0
        self._conveyor.stop()

    def control_lost(self) -> None:
        """Stop."""
        super().control_lost()
        self.stop_conveyor()

    def report_conveyor_state(self) -> ReportConveyorState:
        """Commanded and present motion."""
        state = self._conveyor.state()
        return ReportConveyorState(self._commanded, state.speed, state.position, self._max_speed)
