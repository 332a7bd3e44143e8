"""urn:jaus:jss:ugv:PowerPlantManager 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:ugv:PowerPlantManager", "1.0")


@jd.message(_SERVICE, 0x0506, command=True)
class SetPowerPlantConfiguration(jd.Message):
    """SetPowerPlantConfiguration (0x0506): Switches power plants and sets what they are to do.

    power_plant_configuration_list: 0..255 items. The power plants
    """

    @jd.record()
    class PowerPlantID(jd.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """
        power_plant_id: int = jd.field("powerPlantID", jd.Number("B", jd.Values(None, ((0, 255),))))

    class PowerState(IntEnum):
        POWER_ON = 1
        POWER_OFF = 2
        POWER_STANDBY = 3

    @jd.record("B")
    class GasEngineConfigurationRec(jd.Struct):
        """Settings of a petrol engine.

        power_state: PowerState. Whether it is on
        rpm: optional. Wanted revolutions per minute
        throttle: 0..100, optional. Throttle, in percent of the maximum
        """
        power_state: SetPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(SetPowerPlantConfiguration.PowerState)))
        rpm: int | None = jd.field("rpm", jd.Number("H"), default=None)
        throttle: float | None = jd.field("throttle", jd.real("H", 0.0, 100.0), default=None)
        reserved_presence: int = 0

    class PlugState(IntEnum):
        GLOWPLUG_ON = 1
        GLOWPLUG_OFF = 2

    @jd.record("B")
    class DieselEngineConfigurationRec(jd.Struct):
        """Settings of a diesel engine.

        power_state: PowerState. Whether it is on
        rpm: optional. Wanted revolutions per minute
        throttle: 0..100, optional. Throttle, in percent of the maximum
        plug_state: PlugState, optional. Whether the glow plugs are on
        """
        power_state: SetPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(SetPowerPlantConfiguration.PowerState)))
        rpm: int | None = jd.field("rpm", jd.Number("H"), default=None)
        throttle: float | None = jd.field("throttle", jd.real("H", 0.0, 100.0), default=None)
        plug_state: SetPowerPlantConfiguration.PlugState | int | None = jd.field("plugState", lambda: jd.Number("B", jd.Values(SetPowerPlantConfiguration.PlugState)), default=None)
        reserved_presence: int = 0

    @jd.record()
    class BatteryConfigurationRec(jd.Struct):
        """Settings of a battery.

        power_state: PowerState. Whether it is on
        """
        power_state: SetPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(SetPowerPlantConfiguration.PowerState)))

    @jd.record()
    class HydraulicConfigurationRec(jd.Struct):
        """Settings of a hydraulic pump.

        power_state: PowerState. Whether it is on
        """
        power_state: SetPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(SetPowerPlantConfiguration.PowerState)))

    @jd.record()
    class FuelCellConfigurationRecs(jd.Struct):
        """Settings of a fuel cell.

        power_state: PowerState. Whether it is on
        """
        power_state: SetPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(SetPowerPlantConfiguration.PowerState)))

    @jd.record()
    class PowerPlantConfigurationSeq(jd.Struct):
        """power_plant_id: Identifies the power plant
        power_plant_configuration_var: Settings, by kind of power plant
        """
        power_plant_id: SetPowerPlantConfiguration.PowerPlantID = jd.field("powerPlantID", lambda: SetPowerPlantConfiguration.PowerPlantID.layout())
        power_plant_configuration_var: SetPowerPlantConfiguration.GasEngineConfigurationRec | SetPowerPlantConfiguration.DieselEngineConfigurationRec | SetPowerPlantConfiguration.BatteryConfigurationRec | SetPowerPlantConfiguration.HydraulicConfigurationRec | SetPowerPlantConfiguration.FuelCellConfigurationRecs = jd.field("powerPlantConfigurationVar", lambda: jd.Union.of("B", gas_engine_configuration_rec=SetPowerPlantConfiguration.GasEngineConfigurationRec, diesel_engine_configuration_rec=SetPowerPlantConfiguration.DieselEngineConfigurationRec, battery_configuration_rec=SetPowerPlantConfiguration.BatteryConfigurationRec, hydraulic_configuration_rec=SetPowerPlantConfiguration.HydraulicConfigurationRec, fuel_cell_configuration_recs=SetPowerPlantConfiguration.FuelCellConfigurationRecs))

    power_plant_configuration_list: list[SetPowerPlantConfiguration.PowerPlantConfigurationSeq] = jd.field("powerPlantConfigurationList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetPowerPlantConfiguration.PowerPlantConfigurationSeq.layout()))


@jd.message(_SERVICE, 0x4506)
class ReportPowerPlantConfiguration(jd.Message):
    """ReportPowerPlantConfiguration (0x4506): Tells what power plants are to do.

    power_plant_configuration_list: 0..255 items. The power plants
    """

    @jd.record()
    class PowerPlantID(jd.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """
        power_plant_id: int = jd.field("powerPlantID", jd.Number("B", jd.Values(None, ((0, 255),))))

    class PowerState(IntEnum):
        POWER_ON = 1
        POWER_OFF = 2
        POWER_STANDBY = 3

    @jd.record("B")
    class GasEngineConfigurationRec(jd.Struct):
        """Settings of a petrol engine.

        power_state: PowerState. Whether it is on
        rpm: optional. Wanted revolutions per minute
        throttle: 0..100, optional. Throttle, in percent of the maximum
        """
        power_state: ReportPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(ReportPowerPlantConfiguration.PowerState)))
        rpm: int | None = jd.field("rpm", jd.Number("H"), default=None)
        throttle: float | None = jd.field("throttle", jd.real("H", 0.0, 100.0), default=None)
        reserved_presence: int = 0

    class PlugState(IntEnum):
        GLOWPLUG_ON = 1
        GLOWPLUG_OFF = 2

    @jd.record("B")
    class DieselEngineConfigurationRec(jd.Struct):
        """Settings of a diesel engine.

        power_state: PowerState. Whether it is on
        rpm: optional. Wanted revolutions per minute
        throttle: 0..100, optional. Throttle, in percent of the maximum
        plug_state: PlugState, optional. Whether the glow plugs are on
        """
        power_state: ReportPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(ReportPowerPlantConfiguration.PowerState)))
        rpm: int | None = jd.field("rpm", jd.Number("H"), default=None)
        throttle: float | None = jd.field("throttle", jd.real("H", 0.0, 100.0), default=None)
        plug_state: ReportPowerPlantConfiguration.PlugState | int | None = jd.field("plugState", lambda: jd.Number("B", jd.Values(ReportPowerPlantConfiguration.PlugState)), default=None)
        reserved_presence: int = 0

    @jd.record()
    class BatteryConfigurationRec(jd.Struct):
        """Settings of a battery.

        power_state: PowerState. Whether it is on
        """
        power_state: ReportPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(ReportPowerPlantConfiguration.PowerState)))

    @jd.record()
    class HydraulicConfigurationRec(jd.Struct):
        """Settings of a hydraulic pump.

        power_state: PowerState. Whether it is on
        """
        power_state: ReportPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(ReportPowerPlantConfiguration.PowerState)))

    @jd.record()
    class FuelCellConfigurationRecs(jd.Struct):
        """Settings of a fuel cell.

        power_state: PowerState. Whether it is on
        """
        power_state: ReportPowerPlantConfiguration.PowerState | int = jd.field("powerState", lambda: jd.Number("B", jd.Values(ReportPowerPlantConfiguration.PowerState)))

    @jd.record()
    class PowerPlantConfigurationSeq(jd.Struct):
        """power_plant_id: Identifies the power plant
        power_plant_configuration_var: Settings, by kind of power plant
        """
        power_plant_id: ReportPowerPlantConfiguration.PowerPlantID = jd.field("powerPlantID", lambda: ReportPowerPlantConfiguration.PowerPlantID.layout())
        power_plant_configuration_var: ReportPowerPlantConfiguration.GasEngineConfigurationRec | ReportPowerPlantConfiguration.DieselEngineConfigurationRec | ReportPowerPlantConfiguration.BatteryConfigurationRec | ReportPowerPlantConfiguration.HydraulicConfigurationRec | ReportPowerPlantConfiguration.FuelCellConfigurationRecs = jd.field("powerPlantConfigurationVar", lambda: jd.Union.of("B", gas_engine_configuration_rec=ReportPowerPlantConfiguration.GasEngineConfigurationRec, diesel_engine_configuration_rec=ReportPowerPlantConfiguration.DieselEngineConfigurationRec, battery_configuration_rec=ReportPowerPlantConfiguration.BatteryConfigurationRec, hydraulic_configuration_rec=ReportPowerPlantConfiguration.HydraulicConfigurationRec, fuel_cell_configuration_recs=ReportPowerPlantConfiguration.FuelCellConfigurationRecs))

    power_plant_configuration_list: list[ReportPowerPlantConfiguration.PowerPlantConfigurationSeq] = jd.field("powerPlantConfigurationList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPowerPlantConfiguration.PowerPlantConfigurationSeq.layout()))


@jd.message(_SERVICE, 0x2506, query=True)
class QueryPowerPlantConfiguration(jd.Message):
    """QueryPowerPlantConfiguration (0x2506): Asks what power plants are to do.

    id_list: 0..255 items. The power plants
    """
    REPORT = ReportPowerPlantConfiguration

    @jd.record()
    class PowerPlantID(jd.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """
        power_plant_id: int = jd.field("powerPlantID", jd.Number("B", jd.Values(None, ((0, 255),))))

    id_list: list[QueryPowerPlantConfiguration.PowerPlantID] = jd.field("idList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryPowerPlantConfiguration.PowerPlantID.layout()))


@jd.message(_SERVICE, 0x4507)
class ReportPowerPlantCapabilities(jd.Message):
    """ReportPowerPlantCapabilities (0x4507): Tells limits of power plants.

    power_plant_capabilities_list: 0..255 items. The power plants
    """

    @jd.record()
    class PowerPlantDescRec(jd.Struct):
        """One power plant and its description.

        power_plant_id: Identifies the power plant
        description: up to 255 characters. Description, for people
        """
        power_plant_id: int = jd.field("powerPlantID", jd.Number("B"))
        description: str = jd.field("description", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record("B")
    class GasEngineCapabilitiesRec(jd.Struct):
        """fuel_capacity: 0..256 liter, optional. Amount of fuel when full, in litres
        oil_capacity: 0..256 liter, optional. Amount of oil when full, in litres
        max_oil_pressure: 0..512 bar, optional. Largest pressure of the oil, in bar
        max_oil_temp: -75..180 degree Celsius, optional. Largest temperature of the oil, in degrees Celsius
        max_engine_temp: 0..256 degree Celsius, optional. Largest temperature of the engine, in degrees Celsius
        max_coolant_level: 0..256 liter, optional. Amount of coolant when full, in litres
        max_coolant_temp: -75..180 degree Celsius, optional. Largest temperature of the coolant, in degrees Celsius
        """
        fuel_capacity: float | None = jd.field("fuelCapacity", jd.real("H", 0.0, 256.0, "liter"), default=None)
        oil_capacity: float | None = jd.field("oilCapacity", jd.real("H", 0.0, 256.0, "liter"), default=None)
        max_oil_pressure: float | None = jd.field("maxOilPressure", jd.real("H", 0.0, 512.0, "bar"), default=None)
        max_oil_temp: float | None = jd.field("maxOilTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        max_engine_temp: float | None = jd.field("maxEngineTemp", jd.real("H", 0.0, 256.0, "degree Celsius"), default=None)
        max_coolant_level: float | None = jd.field("maxCoolantLevel", jd.real("H", 0.0, 256.0, "liter"), default=None)
        max_coolant_temp: float | None = jd.field("maxCoolantTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        reserved_presence: int = 0

    @jd.record("H")
    class DieselEngineCapabilitiesRec(jd.Struct):
        """fuel_capacity: 0..256 liter, optional. Amount of fuel when full, in litres
        oil_capacity: 0..256 liter, optional. Amount of oil when full, in litres
        max_oil_pressure: 0..512 bar, optional. Largest pressure of the oil, in bar
        max_oil_temp: -75..180 degree Celsius, optional. Largest temperature of the oil, in degrees Celsius
        max_engine_temp: 0..256 degree Celsius, optional. Largest temperature of the engine, in degrees Celsius
        max_coolant_level: 0..256 liter, optional. Amount of coolant when full, in litres
        max_coolant_temp: -75..180 degree Celsius, optional. Largest temperature of the coolant, in degrees Celsius
        max_glow_plug_temp: 0..256 degree Celsius, optional. Largest temperature of the glow plugs, in degrees Celsius
        glow_plug_time: 0..256 second, optional. Time that the glow plugs need, in seconds
        """
        fuel_capacity: float | None = jd.field("fuelCapacity", jd.real("H", 0.0, 256.0, "liter"), default=None)
        oil_capacity: float | None = jd.field("oilCapacity", jd.real("H", 0.0, 256.0, "liter"), default=None)
        max_oil_pressure: float | None = jd.field("maxOilPressure", jd.real("H", 0.0, 512.0, "bar"), default=None)
        max_oil_temp: float | None = jd.field("maxOilTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        max_engine_temp: float | None = jd.field("maxEngineTemp", jd.real("H", 0.0, 256.0, "degree Celsius"), default=None)
        max_coolant_level: float | None = jd.field("maxCoolantLevel", jd.real("H", 0.0, 256.0, "liter"), default=None)
        max_coolant_temp: float | None = jd.field("maxCoolantTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        max_glow_plug_temp: float | None = jd.field("maxGlowPlugTemp", jd.real("H", 0.0, 256.0, "degree Celsius"), default=None)
        glow_plug_time: float | None = jd.field("glowPlugTime", jd.real("H", 0.0, 256.0, "second"), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class BatteryCapabilitiesRec(jd.Struct):
        """nominal_voltage: 0..1000 volt, optional. Voltage that the battery is made for, in volts
        max_charge: 0..3600000 coulomb, optional. Charge when full, in coulombs
        max_cranking_amps: 0..5000 ampere, optional. Largest current for starting, in amperes
        """
        nominal_voltage: float | None = jd.field("nominalVoltage", jd.real("H", 0.0, 1000.0, "volt"), default=None)
        max_charge: float | None = jd.field("maxCharge", jd.real("I", 0.0, 3600000.0, "coulomb"), default=None)
        max_cranking_amps: float | None = jd.field("maxCrankingAmps", jd.real("H", 0.0, 5000.0, "ampere"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class BatteryCapabilitiesList(jd.Struct):
        """The batteries.

        battery_capabilities_list: 0..255 items. The batteries
        """
        battery_capabilities_list: list[ReportPowerPlantCapabilities.BatteryCapabilitiesRec] = jd.field("batteryCapabilitiesList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPowerPlantCapabilities.BatteryCapabilitiesRec.layout()))

    @jd.record("B")
    class HydraulicCapabilitiesRec(jd.Struct):
        """fluid_capacity: 0..256 liter, optional. Amount of fluid when full, in litres
        max_pressure: 0..512 bar, optional. Largest pressure of the fluid, in bar
        max_temp: -75..180 degree Celsius, optional. Largest temperature of the fluid, in degrees Celsius
        """
        fluid_capacity: float | None = jd.field("fluidCapacity", jd.real("H", 0.0, 256.0, "liter"), default=None)
        max_pressure: float | None = jd.field("maxPressure", jd.real("H", 0.0, 512.0, "bar"), default=None)
        max_temp: float | None = jd.field("maxTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class FuelCellCapabilitiesRec(jd.Struct):
        """fuel_capacity: 0..256 kilogram, optional. Amount of fuel when full, in kilograms"""
        fuel_capacity: float | None = jd.field("fuelCapacity", jd.real("H", 0.0, 256.0, "kilogram"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class PowerPlantCapabilitiesSeq(jd.Struct):
        """power_plant_desc_rec: One power plant and its description
        power_plant_capabilities_var: Limits, by kind of power plant
        """
        power_plant_desc_rec: ReportPowerPlantCapabilities.PowerPlantDescRec = jd.field("PowerPlantDescRec", lambda: ReportPowerPlantCapabilities.PowerPlantDescRec.layout())
        power_plant_capabilities_var: ReportPowerPlantCapabilities.GasEngineCapabilitiesRec | ReportPowerPlantCapabilities.DieselEngineCapabilitiesRec | ReportPowerPlantCapabilities.BatteryCapabilitiesList | ReportPowerPlantCapabilities.HydraulicCapabilitiesRec | ReportPowerPlantCapabilities.FuelCellCapabilitiesRec = jd.field("powerPlantCapabilitiesVar", lambda: jd.Union.of("B", gas_engine_capabilities_rec=ReportPowerPlantCapabilities.GasEngineCapabilitiesRec, diesel_engine_capabilities_rec=ReportPowerPlantCapabilities.DieselEngineCapabilitiesRec, battery_capabilities_list=ReportPowerPlantCapabilities.BatteryCapabilitiesList, hydraulic_capabilities_rec=ReportPowerPlantCapabilities.HydraulicCapabilitiesRec, fuel_cell_capabilities_rec=ReportPowerPlantCapabilities.FuelCellCapabilitiesRec))

    power_plant_capabilities_list: list[ReportPowerPlantCapabilities.PowerPlantCapabilitiesSeq] = jd.field("powerPlantCapabilitiesList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPowerPlantCapabilities.PowerPlantCapabilitiesSeq.layout()))


@jd.message(_SERVICE, 0x2507, query=True)
class QueryPowerPlantCapabilities(jd.Message):
    """QueryPowerPlantCapabilities (0x2507): Asks for limits of power plants.

    id_list: 0..255 items. The power plants
    """
    REPORT = ReportPowerPlantCapabilities

    @jd.record()
    class PowerPlantID(jd.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """
        power_plant_id: int = jd.field("powerPlantID", jd.Number("B", jd.Values(None, ((0, 255),))))

    id_list: list[QueryPowerPlantCapabilities.PowerPlantID] = jd.field("idList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryPowerPlantCapabilities.PowerPlantID.layout()))


@jd.message(_SERVICE, 0x4508)
class ReportPowerPlantStatus(jd.Message):
    """ReportPowerPlantStatus (0x4508): Tells the state of power plants.

    power_plant_status_list: 0..255 items. The power plants
    """

    @jd.record()
    class PowerPlantDescRec(jd.Struct):
        """One power plant and its description.

        power_plant_id: Identifies the power plant
        description: up to 255 characters. Description, for people
        """
        power_plant_id: int = jd.field("powerPlantID", jd.Number("B"))
        description: str = jd.field("description", jd.Text(count=jd.Count("B", 0, 255)))

    @jd.record("H")
    class GasEngineStatus(jd.Struct):
        """percent_remaining_fuel: 0..100, optional. Amount of fuel, in percent of full
        percent_oil_pressure: 0..200, optional. Pressure of the oil, in percent of the usual
        percent_oil_level: 0..100, optional. Amount of oil, in percent of full
        oil_temp: -75..180 degree Celsius, optional. Temperature of the oil, in degrees Celsius
        engine_temp: -75..180 degree Celsius, optional. Temperature of the engine, in degrees Celsius
        engine_hours: in hour, optional. Hours that the engine has worked
        tachometer: optional. Revolutions per minute
        coolant_level: 0..256 liter, optional. Amount of coolant, in litres
        coolant_temp: -75..180 degree Celsius, optional. Temperature of the coolant, in degrees Celsius
        air_intake_pressure: 0..512 bar, optional. Pressure of the intake air, in bar
        air_intake_temp: -75..180 degree Celsius, optional. Temperature of the intake air, in degrees Celsius
        exhaust_temp: -75..180 degree Celsius, optional. Temperature of the exhaust, in degrees Celsius
        """
        percent_remaining_fuel: float | None = jd.field("percentRemainingFuel", jd.real("H", 0.0, 100.0), default=None)
        percent_oil_pressure: float | None = jd.field("percentOilPressure", jd.real("H", 0.0, 200.0), default=None)
        percent_oil_level: float | None = jd.field("percentOilLevel", jd.real("H", 0.0, 100.0), default=None)
        oil_temp: float | None = jd.field("oilTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        engine_temp: float | None = jd.field("engineTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        engine_hours: int | None = jd.field("engineHours", jd.Number("I", jd.ANY, "hour"), default=None)
        tachometer: int | None = jd.field("tachometer", jd.Number("H"), default=None)
        coolant_level: float | None = jd.field("coolantLevel", jd.real("H", 0.0, 256.0, "liter"), default=None)
        coolant_temp: float | None = jd.field("coolantTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        air_intake_pressure: float | None = jd.field("airIntakePressure", jd.real("H", 0.0, 512.0, "bar"), default=None)
        air_intake_temp: float | None = jd.field("airIntakeTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        exhaust_temp: float | None = jd.field("exhaustTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        reserved_presence: int = 0

    @jd.record("H")
    class DieselEngineStatus(jd.Struct):
        """percent_remaining_fuel: 0..100, optional. Amount of fuel, in percent of full
        percent_oil_pressure: 0..200, optional. Pressure of the oil, in percent of the usual
        percent_oil_level: 0..100, optional. Amount of oil, in percent of full
        oil_temp: -75..180 degree Celsius, optional. Temperature of the oil, in degrees Celsius
        engine_temp: -75..180 degree Celsius, optional. Temperature of the engine, in degrees Celsius
        engine_hours: in hour, optional. Hours that the engine has worked
        tachometer: optional. Revolutions per minute
        coolant_level: 0..256 liter, optional. Amount of coolant, in litres
        coolant_temp: -75..180 degree Celsius, optional. Temperature of the coolant, in degrees Celsius
        air_intake_pressure: 0..512 bar, optional. Pressure of the intake air, in bar
        air_intake_temp: -75..180 degree Celsius, optional. Temperature of the intake air, in degrees Celsius
        exhaust_temp: -75..180 degree Celsius, optional. Temperature of the exhaust, in degrees Celsius
        glow_plug_temp: -75..180 degree Celsius, optional. Temperature of the glow plugs, in degrees Celsius
        """
        percent_remaining_fuel: float | None = jd.field("percentRemainingFuel", jd.real("B", 0.0, 100.0), default=None)
        percent_oil_pressure: float | None = jd.field("percentOilPressure", jd.real("B", 0.0, 200.0), default=None)
        percent_oil_level: float | None = jd.field("percentOilLevel", jd.real("H", 0.0, 100.0), default=None)
        oil_temp: float | None = jd.field("oilTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        engine_temp: float | None = jd.field("engineTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        engine_hours: int | None = jd.field("engineHours", jd.Number("I", jd.ANY, "hour"), default=None)
        tachometer: int | None = jd.field("tachometer", jd.Number("H"), default=None)
        coolant_level: float | None = jd.field("coolantLevel", jd.real("H", 0.0, 256.0, "liter"), default=None)
        coolant_temp: float | None = jd.field("coolantTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        air_intake_pressure: float | None = jd.field("airIntakePressure", jd.real("H", 0.0, 512.0, "bar"), default=None)
        air_intake_temp: float | None = jd.field("airIntakeTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        exhaust_temp: float | None = jd.field("exhaustTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        glow_plug_temp: float | None = jd.field("glowPlugTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class BatteryStatusRec(jd.Struct):
        """percent_charge_remaining: 0..100, optional. Charge, in percent of full
        voltage: 0..1000 volt, optional. Voltage, in volts
        current_draw: 0..1000 ampere, optional. Current taken from the battery, in amperes
        battery_temp: -75..180 degree Celsius, optional. Temperature of the battery, in degrees Celsius
        battery_hours: in hour, optional. Hours that the battery has worked
        """
        percent_charge_remaining: float | None = jd.field("percentChargeRemaining", jd.real("H", 0.0, 100.0), default=None)
        voltage: float | None = jd.field("voltage", jd.real("H", 0.0, 1000.0, "volt"), default=None)
        current_draw: float | None = jd.field("currentDraw", jd.real("H", 0.0, 1000.0, "ampere"), default=None)
        battery_temp: float | None = jd.field("batteryTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        battery_hours: int | None = jd.field("batteryHours", jd.Number("I", jd.ANY, "hour"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class BatteryStatus(jd.Struct):
        """The batteries.

        battery_status: 0..255 items. The batteries
        """
        battery_status: list[ReportPowerPlantStatus.BatteryStatusRec] = jd.field("batteryStatus", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPowerPlantStatus.BatteryStatusRec.layout()))

    @jd.record("B")
    class HydraulicStatus(jd.Struct):
        """fluid_level: 0..256 liter, optional. Amount of fluid, in litres
        percent_fluid_pressure: 0..200, optional. Pressure of the fluid, in percent of the usual
        fluid_temp: -75..180 degree Celsius, optional. Temperature of the fluid, in degrees Celsius
        total_hours: in hour, optional. Hours that it has worked
        """
        fluid_level: float | None = jd.field("fluidLevel", jd.real("H", 0.0, 256.0, "liter"), default=None)
        percent_fluid_pressure: float | None = jd.field("percentFluidPressure", jd.real("H", 0.0, 200.0), default=None)
        fluid_temp: float | None = jd.field("fluidTemp", jd.real("H", -75.0, 180.0, "degree Celsius"), default=None)
        total_hours: int | None = jd.field("totalHours", jd.Number("I", jd.ANY, "hour"), default=None)
        reserved_presence: int = 0

    @jd.record("B")
    class FuelCellStatus(jd.Struct):
        """percent_remaining_fuel: 0..100, optional. Amount of fuel, in percent of full
        total_hours: in hour, optional. Hours that it has worked
        """
        percent_remaining_fuel: float | None = jd.field("percentRemainingFuel", jd.real("H", 0.0, 100.0), default=None)
        total_hours: int | None = jd.field("totalHours", jd.Number("I", jd.ANY, "hour"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class PowerPlantStatus(jd.Struct):
        """power_plant_desc_rec: One power plant and its description
        power_plant_status_var: State, by kind of power plant
        """
        power_plant_desc_rec: ReportPowerPlantStatus.PowerPlantDescRec = jd.field("PowerPlantDescRec", lambda: ReportPowerPlantStatus.PowerPlantDescRec.layout())
        power_plant_status_var: ReportPowerPlantStatus.GasEngineStatus | ReportPowerPlantStatus.DieselEngineStatus | ReportPowerPlantStatus.BatteryStatus | ReportPowerPlantStatus.HydraulicStatus | ReportPowerPlantStatus.FuelCellStatus = jd.field("powerPlantStatusVar", lambda: jd.Union.of("B", gas_engine_status=ReportPowerPlantStatus.GasEngineStatus, diesel_engine_status=ReportPowerPlantStatus.DieselEngineStatus, battery_status=ReportPowerPlantStatus.BatteryStatus, hydraulic_status=ReportPowerPlantStatus.HydraulicStatus, fuel_cell_status=ReportPowerPlantStatus.FuelCellStatus))

    power_plant_status_list: list[ReportPowerPlantStatus.PowerPlantStatus] = jd.field("powerPlantStatusList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPowerPlantStatus.PowerPlantStatus.layout()))


@jd.message(_SERVICE, 0x2508, query=True)
class QueryPowerPlantStatus(jd.Message):
    """QueryPowerPlantStatus (0x2508): Asks for the state of power plants.

    id_list: 0..255 items. The power plants
    """
    REPORT = ReportPowerPlantStatus

    @jd.record()
    class PowerPlantID(jd.Struct):
        """Identifies the power plant.

        power_plant_id: 0..255. Identifies the power plant
        """
        power_plant_id: int = jd.field("powerPlantID", jd.Number("B", jd.Values(None, ((0, 255),))))

    id_list: list[QueryPowerPlantStatus.PowerPlantID] = jd.field("idList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryPowerPlantStatus.PowerPlantID.layout()))
