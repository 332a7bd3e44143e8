"""urn:jaus:jss:iop:GeneralSensor 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:GeneralSensor", "1.1")


@jd.message(_SERVICE, 0xDAB3)
class ReportGeneralSensorCapabilities(jd.Message):
    """ReportGeneralSensorCapabilities (0xDAB3): What each sensor of the component can do.

    general_sensor_capabilities_list: 0..255 items. One element per sensor
    """

    @jd.bit_field("B")
    class SupportedSensorStates(jd.Struct):
        """Power states the sensor can take.

        active: bit 0. Active.
        standby: bit 1. Standby.
        off: bit 2. Off.
        """
        active: int = jd.bits(0, 0x1)
        standby: int = jd.bits(1, 0x1)
        off: int = jd.bits(2, 0x1)
        reserved_bits: int = 0

    @jd.bit_field("B")
    class SupportedCoordinateFrames(jd.Struct):
        """Frames the sensor can give its data in.

        sensor_relative: bit 0. Sensor relative.
        vehicle_relative: bit 1. Vehicle relative.
        global_relative: bit 2. Global relative.
        """
        sensor_relative: int = jd.bits(0, 0x1)
        vehicle_relative: int = jd.bits(1, 0x1)
        global_relative: int = jd.bits(2, 0x1)
        reserved_bits: int = 0

    @jd.record()
    class GeneralSensorCapabilityRec(jd.Struct):
        """sensor_id: Sensor that the element is about; zero is not allowed
        description: up to 255 characters. Text that tells people which sensor it is
        supported_sensor_states: Power states the sensor can take
        supported_coordinate_frames: Frames the sensor can give its data in
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        description: str = jd.field("Description", jd.Text(count=jd.Count("B", 0, 255)))
        supported_sensor_states: ReportGeneralSensorCapabilities.SupportedSensorStates = jd.field("SupportedSensorStates", lambda: ReportGeneralSensorCapabilities.SupportedSensorStates.layout())
        supported_coordinate_frames: ReportGeneralSensorCapabilities.SupportedCoordinateFrames = jd.field("SupportedCoordinateFrames", lambda: ReportGeneralSensorCapabilities.SupportedCoordinateFrames.layout())

    general_sensor_capabilities_list: list[ReportGeneralSensorCapabilities.GeneralSensorCapabilityRec] = jd.field("GeneralSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportGeneralSensorCapabilities.GeneralSensorCapabilityRec.layout()))


@jd.message(_SERVICE, 0xDAB0, query=True)
class QueryGeneralSensorCapabilities(jd.Message):
    """QueryGeneralSensorCapabilities (0xDAB0): Asks what the component's sensors can do."""
    REPORT = ReportGeneralSensorCapabilities


@jd.message(_SERVICE, 0xDAB4)
class ReportGeneralSensorConfiguration(jd.Message):
    """ReportGeneralSensorConfiguration (0xDAB4): Settings in use of the listed sensors.

    general_sensor_configuration_list: 0..255 items. One element per sensor
    """

    class SensorStateEnum(IntEnum):
        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    class CoordinateFrameEnum(IntEnum):
        SENSOR_RELATIVE = 0
        VEHICLE_RELATIVE = 1
        GLOBAL_RELATIVE = 2

    @jd.record("B")
    class GeneralSensorConfigurationRec(jd.Struct):
        """sensor_id: Sensor that the element is about
        sensor_state_enum: SensorStateEnum, optional. Power state
        coordinate_frame_enum: CoordinateFrameEnum, optional. Frame of the sensor's data
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        sensor_state_enum: ReportGeneralSensorConfiguration.SensorStateEnum | int | None = jd.field("SensorStateEnum", lambda: jd.Number("B", jd.Values(ReportGeneralSensorConfiguration.SensorStateEnum)), default=None)
        coordinate_frame_enum: ReportGeneralSensorConfiguration.CoordinateFrameEnum | int | None = jd.field("CoordinateFrameEnum", lambda: jd.Number("B", jd.Values(ReportGeneralSensorConfiguration.CoordinateFrameEnum)), default=None)
        reserved_presence: int = 0

    general_sensor_configuration_list: list[ReportGeneralSensorConfiguration.GeneralSensorConfigurationRec] = jd.field("GeneralSensorConfigurationList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportGeneralSensorConfiguration.GeneralSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0xDAB1, query=True)
class QueryGeneralSensorConfiguration(jd.Message):
    """QueryGeneralSensorConfiguration (0xDAB1): Asks for the settings in use of the listed sensors.

    query_general_sensor_list: 0..255 items. One element per sensor asked about
    """
    REPORT = ReportGeneralSensorConfiguration

    @jd.record()
    class QueryGeneralSensorRec(jd.Struct):
        """sensor_id: Sensor asked about; zero stands for all of them"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    query_general_sensor_list: list[QueryGeneralSensorConfiguration.QueryGeneralSensorRec] = jd.field("QueryGeneralSensorList", lambda: jd.Repeat(jd.Count("B", 0, 255), QueryGeneralSensorConfiguration.QueryGeneralSensorRec.layout()))


@jd.message(_SERVICE, 0xDAB2, command=True)
class SetGeneralSensorConfiguration(jd.Message):
    """SetGeneralSensorConfiguration (0xDAB2): Changes the settings of one or more sensors.

    set_general_sensor_list: 0..255 items. One element per sensor to change
    """

    class SensorStateEnum(IntEnum):
        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    class CoordinateFrameEnum(IntEnum):
        SENSOR_RELATIVE = 0
        VEHICLE_RELATIVE = 1
        GLOBAL_RELATIVE = 2

    @jd.record("B")
    class SetGeneralSensorRec(jd.Struct):
        """sensor_id: Sensor to change; zero stands for all of them
        sensor_state_enum: SensorStateEnum, optional. Power state to take
        coordinate_frame_enum: CoordinateFrameEnum, optional. Frame to use for the sensor's data
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        sensor_state_enum: SetGeneralSensorConfiguration.SensorStateEnum | int | None = jd.field("SensorStateEnum", lambda: jd.Number("B", jd.Values(SetGeneralSensorConfiguration.SensorStateEnum)), default=None)
        coordinate_frame_enum: SetGeneralSensorConfiguration.CoordinateFrameEnum | int | None = jd.field("CoordinateFrameEnum", lambda: jd.Number("B", jd.Values(SetGeneralSensorConfiguration.CoordinateFrameEnum)), default=None)
        reserved_presence: int = 0

    set_general_sensor_list: list[SetGeneralSensorConfiguration.SetGeneralSensorRec] = jd.field("SetGeneralSensorList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetGeneralSensorConfiguration.SetGeneralSensorRec.layout()))
