"""urn:jauspy:cell:ModulePower 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jauspy:cell:ModulePower", "1.0")


@jd.message(_SERVICE, 0xDA64, command=True)
class SetModulePower(jd.Message):
    """SetModulePower (0xDA64): Switches modules on or off.

    module_list: 1..255 items. The modules
    """

    class Power(IntEnum):
        SWITCHED_OFF = 0
        SWITCHED_ON = 1

    @jd.record()
    class ModulePowerRec(jd.Struct):
        """name: up to 255 characters. Name of the part
        power: Power. Whether its supply is switched on
        """
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
        power: SetModulePower.Power | int = jd.field("Power", lambda: jd.Number("B", jd.Values(SetModulePower.Power)))

    module_list: list[SetModulePower.ModulePowerRec] = jd.field("ModuleList", lambda: jd.Repeat(jd.Count("B", 1, 255), SetModulePower.ModulePowerRec.layout()))


@jd.message(_SERVICE, 0xFA67)
class ReportModulePower(jd.Message):
    """ReportModulePower (0xFA67): Tells which modules are switched on.

    module_list: 0..255 items. The modules
    """

    class Power(IntEnum):
        SWITCHED_OFF = 0
        SWITCHED_ON = 1

    @jd.record()
    class ModulePowerRec(jd.Struct):
        """name: up to 255 characters. Name of the part
        power: Power. Whether its supply is switched on
        """
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
        power: ReportModulePower.Power | int = jd.field("Power", lambda: jd.Number("B", jd.Values(ReportModulePower.Power)))

    module_list: list[ReportModulePower.ModulePowerRec] = jd.field("ModuleList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportModulePower.ModulePowerRec.layout()))


@jd.message(_SERVICE, 0xEA67, query=True)
class QueryModulePower(jd.Message):
    """QueryModulePower (0xEA67): Asks which modules are switched on."""
    REPORT = ReportModulePower


@jd.message(_SERVICE, 0xFA6B)
class ReportModuleEnergy(jd.Message):
    """ReportModuleEnergy (0xFA6B): Tells what modules draw, and what batteries have left.

    module_list: 0..255 items. The modules
    battery_list: 0..255 items. The batteries
    """

    @jd.record()
    class ModuleEnergyRec(jd.Struct):
        """name: up to 255 characters. Name of the part
        power: in watt. What it draws now
        energy: in joule. What it has drawn since the start
        """
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
        power: float = jd.field("Power", jd.Number("f", jd.ANY, "watt"))
        energy: float = jd.field("Energy", jd.Number("d", jd.ANY, "joule"))

    @jd.record()
    class BatteryRec(jd.Struct):
        """name: up to 255 characters. Name of the part
        charge: in percent. What is left of its capacity
        energy: in joule. What is left
        voltage: in volt. Voltage at its terminals; zero when it is empty
        current: in ampere. What it delivers
        """
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
        charge: float = jd.field("Charge", jd.Number("f", jd.ANY, "percent"))
        energy: float = jd.field("Energy", jd.Number("d", jd.ANY, "joule"))
        voltage: float = jd.field("Voltage", jd.Number("f", jd.ANY, "volt"))
        current: float = jd.field("Current", jd.Number("f", jd.ANY, "ampere"))

    module_list: list[ReportModuleEnergy.ModuleEnergyRec] = jd.field("ModuleList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportModuleEnergy.ModuleEnergyRec.layout()))
    battery_list: list[ReportModuleEnergy.BatteryRec] = jd.field("BatteryList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportModuleEnergy.BatteryRec.layout()))


@jd.message(_SERVICE, 0xEA6B, query=True)
class QueryModuleEnergy(jd.Message):
    """QueryModuleEnergy (0xEA6B): Asks what modules draw, and what batteries have left."""
    REPORT = ReportModuleEnergy
