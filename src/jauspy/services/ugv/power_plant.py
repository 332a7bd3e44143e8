"""PowerPlantManager: reports the battery of the robot (AS6091)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from jauspy.messages.ugv import (
    QueryPowerPlantCapabilities,
    QueryPowerPlantConfiguration,
    QueryPowerPlantStatus,
    ReportPowerPlantCapabilities,
    ReportPowerPlantConfiguration,
    ReportPowerPlantStatus,
    SetPowerPlantConfiguration,
)
from jauspy.platform.battery import JOULES, Battery
from jauspy.services.service import Service

BATTERY_ID: Final = 1
"""The identifier of the battery among power plants."""
HOUR: Final = 3600.0


class PowerPlantManager(Service, urn="urn:jaus:jss:ugv:PowerPlantManager"):
    """One power plant, a battery, which is always on: what supplies this component cannot be switched off by it.

    A query that names no power plant asks for all; identifiers that do not exist are left out of the reports.
    """

    def __init__(self, battery: Battery, name: str = "battery") -> None:
        self._battery = battery
        self._name = name
        self._started: float | None = None

    def attached(self) -> None:
        """Count the hours from now on."""
        self._started = self.host.now

    def is_supported(self, msg: SetPowerPlantConfiguration) -> bool:
        """True if the message leaves everything as it is."""
        kind = SetPowerPlantConfiguration
        return all(
            row.power_plant_id.power_plant_id == BATTERY_ID
            and isinstance(row.power_plant_configuration_var, kind.BatteryConfigurationRec)
            and row.power_plant_configuration_var.power_state == kind.PowerState.POWER_ON
            for row in msg.power_plant_configuration_list
        )

    def set_power_plant_configuration(self, msg: SetPowerPlantConfiguration) -> None:
        """Do nothing: the only settings that `is_supported` lets pass are those in force."""

    def send_report_power_plant_configuration(self, msg: QueryPowerPlantConfiguration) -> ReportPowerPlantConfiguration:
        """The battery is on."""
        kind = ReportPowerPlantConfiguration
        row = kind.PowerPlantConfigurationSeq(
            kind.PowerPlantID(BATTERY_ID), kind.BatteryConfigurationRec(kind.PowerState.POWER_ON)
        )
        return kind([row] if _asks(plant.power_plant_id for plant in msg.id_list) else [])

    def send_report_power_plant_capabilities(self, msg: QueryPowerPlantCapabilities) -> ReportPowerPlantCapabilities:
        """Nominal voltage, and the charge of a full battery at that voltage."""
        kind, setup = ReportPowerPlantCapabilities, self._battery.setup
        volts = setup.nominal_voltage
        charge = min(MAX_CHARGE, setup.capacity * JOULES / volts)
        row = kind.PowerPlantCapabilitiesSeq(
            kind.PowerPlantDescRec(BATTERY_ID, self._name),
            kind.BatteryCapabilitiesList([kind.BatteryCapabilitiesRec(nominal_voltage=volts, max_charge=charge)]),
        )
        return kind([row] if _asks(plant.power_plant_id for plant in msg.id_list) else [])

    def send_report_power_plant_status(self, msg: QueryPowerPlantStatus) -> ReportPowerPlantStatus:
        """Charge, voltage and current of the battery, and for how long it has worked; no temperature is measured."""
        kind, state = ReportPowerPlantStatus, self._battery.state()
        hours = 0 if self._started is None else int((self.host.now - self._started) / HOUR)
        record = kind.BatteryStatusRec(
            percent_charge_remaining=100.0 * state.charge,
            voltage=min(MAX_VALUE, state.voltage),
            current_draw=min(MAX_VALUE, state.current),
            battery_hours=hours,
        )
        row = kind.PowerPlantStatus(kind.PowerPlantDescRec(BATTERY_ID, self._name), kind.BatteryStatus([record]))
        return kind([row] if _asks(plant.power_plant_id for plant in msg.id_list) else [])


MAX_VALUE: Final = 1000.0
"""Volts and amperes that the fields of the status hold."""
MAX_CHARGE: Final = 3.6e6
"""Coulombs that the field of the capacity holds."""


def _asks(ids: Iterable[int]) -> bool:
    """True if a query with these identifiers is about the battery."""
    asked = list(ids)
    return not asked or BATTERY_ID in asked
