"""Conveyor, PartSensor and ModulePower: the belt, the poses of parts, and the power of modules.

The world's z axis is up.
"""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import quaternion
from jauspy.messages.cell import (
    ReportConveyorState,
    ReportModuleEnergy,
    ReportModulePower,
    ReportPartObservations,
    SetConveyorSpeed,
    SetModulePower,
)
from jauspy.platform.modular.cell import Conveyor, ModulePower, ObservedPart, PartSensor
from jauspy.services.service import Service
from jauspy.services.units import sent_text


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


_Record: Final = ReportModulePower.ModulePowerRec


class PartSensorService(Service, urn="urn:jauspy:cell:PartSensor"):
    """A sensor of the poses of parts."""

    def __init__(self, sensor: PartSensor) -> None:
        self._sensor = sensor

    def report_part_observations(self) -> ReportPartObservations:
        """The last observations: poses of parts in metres and radians."""
        seen = self._sensor.state()
        time = ReportPartObservations.ObservationTimeRec(seen.time)
        return ReportPartObservations(time, [_observed(part) for part in seen.parts])


def _observed(part: ObservedPart) -> ReportPartObservations.ObservedPartRec:
    frame = Transform.from_pose(part.pose)
    return ReportPartObservations.ObservedPartRec(
        sent_text(part.name), sent_text(part.type), *frame.position, *quaternion(frame.rotation)
    )


class ModulePowerService(Service, urn="urn:jauspy:cell:ModulePower"):
    """The switches and meters of modules' supplies. Switches stay as they are when control is lost."""

    def __init__(self, power: ModulePower) -> None:
        self._power = power

    def set_module_power(self, msg: SetModulePower) -> None:
        """Switch modules on or off; names that are unknown are left out, and counted."""
        known = self._power.state().switches
        for module in msg.module_list:
            if module.name not in known:
                self.host.count("unknown_module", f"{module}")
            else:
                self._power.switch(module.name, module.power == ReportModulePower.Power.SWITCHED_ON)

    def report_module_power(self) -> ReportModulePower:
        """The modules that are switched on."""
        return ReportModulePower(
            [_Record(sent_text(name), ReportModulePower.Power(on)) for name, on in self._power.state().switches.items()]
        )

    def report_module_energy(self) -> ReportModuleEnergy:
        """What modules draw, and what batteries have left."""
        state, kind = self._power.state(), ReportModuleEnergy
        return kind(
            [kind.ModuleEnergyRec(sent_text(name), row.power, row.energy) for name, row in state.consumption.items()],
            [
                kind.BatteryRec(sent_text(name), 100.0 * row.charge, row.energy, row.voltage, row.current)
                for name, row in state.batteries.items()
            ],
        )
