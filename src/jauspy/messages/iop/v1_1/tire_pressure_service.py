"""urn:jaus:jss:iop:TirePressureService 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:TirePressureService", "1.1")


@jd.message(_SERVICE, 0xD7B3)
class ReportTirePressureCapabilities(jd.Message):
    """ReportTirePressureCapabilities (0xD7B3): Tells for every tire what the hardware can do.

    tire_pressure_capabilities_list: 0..255 items. Tire pressure capabilities
    """

    @jd.bit_field("B")
    class TireCapabilities(jd.Struct):
        """Bit set = the hardware has this function.

        air_pressure_measurement: bit 0. Air pressure measurement.
        low_pressure_alert: bit 1. Low pressure alert.
        tire_inflate_deflate_control: bit 2. Tire inflate deflate control.
        run_flat_capabable: bit 3. Run flat capabable.
        """
        air_pressure_measurement: int = jd.bits(0, 0x1)
        low_pressure_alert: int = jd.bits(1, 0x1)
        tire_inflate_deflate_control: int = jd.bits(2, 0x1)
        run_flat_capabable: int = jd.bits(3, 0x1)
        reserved_bits: int = 0

    @jd.record()
    class TirePressureCapabilityRec(jd.Struct):
        """tire_id: Number of the tire; never 0
        description: up to 255 characters. Text for people that says which tire this is
        nominal_tire_pressure: 0..10 bar. Pressure in usual running, in bar
        tire_capabilities: Bit set = the hardware has this function
        """
        tire_id: int = jd.field("TireID", jd.Number("B"))
        description: str = jd.field("Description", jd.Text(count=jd.Count("B", 0, 255)))
        nominal_tire_pressure: float = jd.field("NominalTirePressure", jd.real("B", 0.0, 10.0, "bar"))
        tire_capabilities: ReportTirePressureCapabilities.TireCapabilities = jd.field("TireCapabilities", lambda: ReportTirePressureCapabilities.TireCapabilities.layout())

    tire_pressure_capabilities_list: list[ReportTirePressureCapabilities.TirePressureCapabilityRec] = jd.field("TirePressureCapabilitiesList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportTirePressureCapabilities.TirePressureCapabilityRec.layout()))


@jd.message(_SERVICE, 0xD7B0, query=True)
class QueryTirePressureCapabilities(jd.Message):
    """QueryTirePressureCapabilities (0xD7B0): Asks what the hardware can do for each tire."""
    REPORT = ReportTirePressureCapabilities


@jd.message(_SERVICE, 0xD7B4)
class ReportTirePressureStatus(jd.Message):
    """ReportTirePressureStatus (0xD7B4): Tells the state of some or all tires.

    tire_pressure_status_list: 0..255 items. Tire pressure status
    """

    class LowPressureAlert(IntEnum):
        NORMAL = 0
        LOW_PRESSURE_ALERT = 1
        RUN_FLAT_ACTIVE = 2

    class PressureControlStatus(IntEnum):
        INACTIVE = 0
        INFLATING = 1
        DEFLATING = 2

    @jd.record("B")
    class TirePressureStatuRec(jd.Struct):
        """tire_id: Number of the tire; never 0
        tire_pressure: 0..10 bar, optional. Pressure now, in bar
        low_pressure_alert: LowPressureAlert, optional. Whether the pressure is too low
        pressure_control_status: PressureControlStatus, optional. What the pressure control is doing to this tire
        """
        tire_id: int = jd.field("TireID", jd.Number("B"))
        tire_pressure: float | None = jd.field("TirePressure", jd.real("B", 0.0, 10.0, "bar"), default=None)
        low_pressure_alert: ReportTirePressureStatus.LowPressureAlert | int | None = jd.field("LowPressureAlert", lambda: jd.Number("B", jd.Values(ReportTirePressureStatus.LowPressureAlert)), default=None)
        pressure_control_status: ReportTirePressureStatus.PressureControlStatus | int | None = jd.field("PressureControlStatus", lambda: jd.Number("B", jd.Values(ReportTirePressureStatus.PressureControlStatus)), default=None)
        reserved_presence: int = 0

    tire_pressure_status_list: list[ReportTirePressureStatus.TirePressureStatuRec] = jd.field("TirePressureStatusList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportTirePressureStatus.TirePressureStatuRec.layout()))


@jd.message(_SERVICE, 0xD7B1, query=True)
class QueryTirePressureStatus(jd.Message):
    """QueryTirePressureStatus (0xD7B1): Asks for the state of some or all tires.

    query_tire_list: 0..255 items. Query tire
    """
    REPORT = ReportTirePressureStatus

    @jd.record()
    class QueryTireRec(jd.Struct):
        """tire_id: Number of a tire asked for; 0 = every tire"""
        tire_id: int = jd.field("TireID", jd.Number("B"))

    query_tire_list: list[QueryTirePressureStatus.QueryTireRec] = jd.field("QueryTireList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryTirePressureStatus.QueryTireRec.layout()))


@jd.message(_SERVICE, 0xD7B2, command=True)
class SetTirePressureStatus(jd.Message):
    """SetTirePressureStatus (0xD7B2): Lets air into or out of some or all tires.

    set_tire_pressure_list: 0..255 items. Set tire pressure
    """

    @jd.record()
    class SetTirePressureRec(jd.Struct):
        """tire_id: Number of the tire to change; 0 = every tire
        tire_pressure: 0..10 bar. Pressure to be reached, in bar
        """
        tire_id: int = jd.field("TireID", jd.Number("B"))
        tire_pressure: float = jd.field("TirePressure", jd.real("B", 0.0, 10.0, "bar"))

    set_tire_pressure_list: list[SetTirePressureStatus.SetTirePressureRec] = jd.field("SetTirePressureList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetTirePressureStatus.SetTirePressureRec.layout()))
