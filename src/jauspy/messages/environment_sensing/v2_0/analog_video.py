"""urn:jaus:jss:environmentSensing:AnalogVideo 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:AnalogVideo", "2.0")


@jd.message(_SERVICE, 0x0806, command=True)
class SetAnalogVideoSensorConfiguration(jd.Message):
    """SetAnalogVideoSensorConfiguration (0x0806): Sets the configuration of analog cameras.

    analog_video_sensor_list: 0..65535 items. The cameras
    """

    @jd.record()
    class RequestIdRec(jd.Struct):
        """request_id: Repeated in the answer, to match it with its request"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class AnalogFormat(IntEnum):
        NTSC_M = 0
        NTSC_J = 1
        PAL_N = 2
        PAL_M = 3
        SECAM_L = 4
        SECAM_B_G = 5

    @jd.record()
    class AnalogVideoSensorConfigurationRec(jd.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        analog_format: AnalogFormat. Signal format
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        analog_format: SetAnalogVideoSensorConfiguration.AnalogFormat | int = jd.field("AnalogFormat", lambda: jd.Number("B", jd.Values(SetAnalogVideoSensorConfiguration.AnalogFormat)))

    request_id_rec: SetAnalogVideoSensorConfiguration.RequestIdRec = jd.field("RequestIdRec", lambda: SetAnalogVideoSensorConfiguration.RequestIdRec.layout())
    analog_video_sensor_list: list[SetAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec] = jd.field("AnalogVideoSensorList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x4811)
class ReportAnalogVideoSensorConfiguration(jd.Message):
    """ReportAnalogVideoSensorConfiguration (0x4811): Tells the configuration of analog cameras.

    analog_video_sensor_configuration_list: 0..65535 items. The cameras
    """

    class AnalogFormat(IntEnum):
        NTSC_M = 0
        NTSC_J = 1
        PAL_N = 2
        PAL_M = 3
        SECAM_L = 4
        SECAM_B_G = 5

    @jd.record()
    class AnalogVideoSensorConfigurationRec(jd.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        analog_format: AnalogFormat. Signal format
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        analog_format: ReportAnalogVideoSensorConfiguration.AnalogFormat | int = jd.field("AnalogFormat", lambda: jd.Number("B", jd.Values(ReportAnalogVideoSensorConfiguration.AnalogFormat)))

    analog_video_sensor_configuration_list: list[ReportAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec] = jd.field("AnalogVideoSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportAnalogVideoSensorConfiguration.AnalogVideoSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x2811, query=True)
class QueryAnalogVideoSensorConfiguration(jd.Message):
    """QueryAnalogVideoSensorConfiguration (0x2811): Asks for the configuration of analog cameras.

    sensor_id_list: 0..65535 items. The sensors
    """
    REPORT = ReportAnalogVideoSensorConfiguration
    SensorIDQueryRec = environment_sensing_v1_0_types.SensorIDQueryRec
    sensor_id_list: list[environment_sensing_v1_0_types.SensorIDQueryRec] = jd.field("SensorIdList", lambda: jd.Repeat(jd.Count("H", 0, 65535), environment_sensing_v1_0_types.SensorIDQueryRec.layout()))


@jd.message(_SERVICE, 0x4810)
class ReportAnalogVideoSensorCapabilities(jd.Message):
    """ReportAnalogVideoSensorCapabilities (0x4810): Tells what analog cameras can do.

    analog_video_sensor_capabilities_list: 0..65535 items. The cameras
    """
    SupportedAnalogFormats = environment_sensing_v1_0_types.SupportedAnalogFormats

    @jd.record()
    class AnalogVideoSensorCapabilitiesRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        supported_analog_formats: Signal formats that the camera offers
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        supported_analog_formats: environment_sensing_v1_0_types.SupportedAnalogFormats = jd.field("SupportedAnalogFormats", lambda: environment_sensing_v1_0_types.SupportedAnalogFormats.layout())

    analog_video_sensor_capabilities_list: list[ReportAnalogVideoSensorCapabilities.AnalogVideoSensorCapabilitiesRec] = jd.field("AnalogVideoSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportAnalogVideoSensorCapabilities.AnalogVideoSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x2810, query=True)
class QueryAnalogVideoSensorCapabilities(jd.Message):
    """QueryAnalogVideoSensorCapabilities (0x2810): Asks what analog cameras can do.

    sensor_id_list: 0..65535 items. The sensors
    """
    REPORT = ReportAnalogVideoSensorCapabilities
    SensorIDQueryRec = environment_sensing_v1_0_types.SensorIDQueryRec
    sensor_id_list: list[environment_sensing_v1_0_types.SensorIDQueryRec] = jd.field("SensorIdList", lambda: jd.Repeat(jd.Count("H", 0, 65535), environment_sensing_v1_0_types.SensorIDQueryRec.layout()))
