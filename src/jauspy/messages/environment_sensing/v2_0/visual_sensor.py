"""urn:jaus:jss:environmentSensing:VisualSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types
from jauspy.messages.environment_sensing.v2_0 import digital_audio_output as environment_sensing_v2_0_digital_audio_output
from jauspy.messages.environment_sensing.v2_0 import range_sensor as environment_sensing_v2_0_range_sensor

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:VisualSensor", "2.0")

@jd.derived(_SERVICE)
class ReportSensorGeometricProperties(environment_sensing_v2_0_range_sensor.ReportSensorGeometricProperties): ...

@jd.derived(_SERVICE)
class QuerySensorGeometricProperties(environment_sensing_v2_0_range_sensor.QuerySensorGeometricProperties):
    REPORT = ReportSensorGeometricProperties


@jd.message(_SERVICE, 0x4807)
class ReportVisualSensorConfiguration(jd.Message):
    """ReportVisualSensorConfiguration (0x4807): Tells the configuration of cameras.

    visual_sensor_configuration_list: 0..65535 items. The cameras
    """

    class SensorState(IntEnum):
        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    class ZoomMode(IntEnum):
        MIXED = 0
        ANALOG_ONLY = 1
        DIGITAL_ONLY = 2
        OFF = 3

    class FocusMode(IntEnum):
        AUTO_FOCUS = 0
        MANUAL_FOCUS = 1

    class WhiteBalance(IntEnum):
        AUTO = 0
        DAYLIGHT = 1
        CLOUDY = 2
        SHADE = 3
        TUNGSTEN = 4
        FLUORESCENT = 5
        FLASH = 6

    class ImagingMode(IntEnum):
        COLOR = 0
        GREYSCALE = 1
        INFRARED = 2
        LOW_LIGHT = 3
        THERMAL_WHITE_HOT = 4
        THERMAL_BLACK_HOT = 5
        THERMAL_RAINBOW = 6

    class ExposureMode(IntEnum):
        AUTO = 0
        MANUAL = 1
        SHUTTER_PRIORITY = 2
        APERTURE_PRIORITY = 3

    class MeteringMode(IntEnum):
        AUTO = 0
        CENTER_WEIGHTED = 1
        SPOT = 2

    class LightSensitivity(IntEnum):
        AUTO = 0
        ISO_100 = 1
        ISO_200 = 2
        ISO_400 = 3
        ISO_800 = 4
        ISO_1600 = 5
        ISO_3200 = 6

    class ImageStabilization(IntEnum):
        OFF = 0
        ON = 1

    @jd.record("H")
    class VisualSensorConfigurationRec(jd.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        sensor_state: SensorState, optional. Whether the sensor works
        zoom_mode: ZoomMode, optional. Whether lens, computation or both zoom
        zoom_level: 0..100 percent, optional. Zoom, in percent from widest to narrowest
        focal_length: 0..2 meter, optional. Focal length, in metres
        horizontal_field_of_view: -3.14159265359..3.14159265359 radian, optional. Field of view from left to right, in radians
        vertical_field_of_view: -3.14159265359..3.14159265359 radian, optional. Field of view from top to bottom, in radians
        focus_mode: FocusMode, optional. Who focuses
        focus_value: 0..100 percent, optional. Focus, in percent from nearest to farthest
        white_balance: WhiteBalance, optional. Kind of light that is taken for white
        imaging_mode: ImagingMode or 7..20 or 21..31, optional. Kind of image
        exposure_mode: ExposureMode, optional. What of the exposure is automatic
        metering_mode: MeteringMode, optional. Part of the image that the exposure is measured in
        shutter_speed: 0..60 second, optional. Exposure time, in seconds
        aperture: 0.1..128, optional. Aperture as an f-number
        light_sensitivity: LightSensitivity, optional. Sensitivity as on the ISO scale
        image_stabilization: ImageStabilization, optional. Whether the image is steadied
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        sensor_state: ReportVisualSensorConfiguration.SensorState | int | None = jd.field("SensorState", lambda: jd.Number("B", jd.Values(ReportVisualSensorConfiguration.SensorState)), default=None)
        zoom_mode: ReportVisualSensorConfiguration.ZoomMode | int | None = jd.field("ZoomMode", lambda: jd.Number("B", jd.Values(ReportVisualSensorConfiguration.ZoomMode)), default=None)
        zoom_level: float | None = jd.field("ZoomLevel", jd.real("H", 0.0, 100.0, "percent"), default=None)
        focal_length: float | None = jd.field("FocalLength", jd.real("I", 0.0, 2.0, "meter"), default=None)
        horizontal_field_of_view: float | None = jd.field("HorizontalFieldOfView", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        vertical_field_of_view: float | None = jd.field("VerticalFieldOfView", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        focus_mode: ReportVisualSensorConfiguration.FocusMode | int | None = jd.field("FocusMode", lambda: jd.Number("B", jd.Values(ReportVisualSensorConfiguration.FocusMode)), default=None)
        focus_value: float | None = jd.field("FocusValue", jd.real("H", 0.0, 100.0, "percent"), default=None)
        white_balance: ReportVisualSensorConfiguration.WhiteBalance | int | None = jd.field("WhiteBalance", lambda: jd.Number("B", jd.Values(ReportVisualSensorConfiguration.WhiteBalance)), default=None)
        imaging_mode: ReportVisualSensorConfiguration.ImagingMode | int | None = jd.field("ImagingMode", lambda: jd.Number("B", jd.Values(ReportVisualSensorConfiguration.ImagingMode, ((7, 20), (21, 31)))), default=None)
        exposure_mode: ReportVisualSensorConfiguration.ExposureMode | int | None = jd.field("ExposureMode", lambda: jd.Number("B", jd.Values(ReportVisualSensorConfiguration.ExposureMode)), default=None)
        metering_mode: ReportVisualSensorConfiguration.MeteringMode | int | None = jd.field("MeteringMode", lambda: jd.Number("B", jd.Values(ReportVisualSensorConfiguration.MeteringMode)), default=None)
        shutter_speed: float | None = jd.field("ShutterSpeed", jd.real("H", 0.0, 60.0, "second"), default=None)
        aperture: float | None = jd.field("Aperture", jd.real("H", 0.1, 128.0), default=None)
        light_sensitivity: ReportVisualSensorConfiguration.LightSensitivity | int | None = jd.field("LightSensitivity", lambda: jd.Number("B", jd.Values(ReportVisualSensorConfiguration.LightSensitivity)), default=None)
        image_stabilization: ReportVisualSensorConfiguration.ImageStabilization | int | None = jd.field("ImageStabilization", lambda: jd.Number("B", jd.Values(ReportVisualSensorConfiguration.ImageStabilization)), default=None)

    visual_sensor_configuration_list: list[ReportVisualSensorConfiguration.VisualSensorConfigurationRec] = jd.field("VisualSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportVisualSensorConfiguration.VisualSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x2807, query=True)
class QueryVisualSensorConfiguration(jd.Message):
    """QueryVisualSensorConfiguration (0x2807): Asks for the configuration of cameras.

    query_visual_sensor_configuration_list: 0..65535 items. The cameras
    """
    REPORT = ReportVisualSensorConfiguration

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    @jd.record()
    class QueryVisualSensorConfigurationRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryVisualSensorConfiguration.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryVisualSensorConfiguration.SensorID, ((1, 65535),))))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("H"))

    query_visual_sensor_configuration_list: list[QueryVisualSensorConfiguration.QueryVisualSensorConfigurationRec] = jd.field("QueryVisualSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryVisualSensorConfiguration.QueryVisualSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x4806)
class ReportVisualSensorCapabilities(jd.Message):
    """ReportVisualSensorCapabilities (0x4806): Tells what cameras can do.

    visual_sensor_capabilities_list: 0..65535 items. The cameras
    """
    SupportedStates = environment_sensing_v1_0_types.SupportedStates
    ZoomModes = environment_sensing_v1_0_types.ZoomModes
    FocusModes = environment_sensing_v1_0_types.FocusModes
    SupportedWhiteBalance = environment_sensing_v1_0_types.SupportedWhiteBalance
    ExposureModes = environment_sensing_v1_0_types.ExposureModes
    MeteringModes = environment_sensing_v1_0_types.MeteringModes
    LightSensitivityLevels = environment_sensing_v1_0_types.LightSensitivityLevels

    class Color(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Greyscale(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Infrared(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Lowlight(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ThermalWhiteHot(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ThermalBlackHot(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ThermalRainbow(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ReservedForFutureUse(IntEnum):
        RESERVED = 0

    @jd.bit_field("B")
    class ImagingModes(jd.Struct):
        """Kinds of image that the camera offers.

        color: bit 0. Colour.
        greyscale: bit 1. Greyscale.
        infrared: bit 2. Infrared.
        lowlight: bit 3. Weak light.
        thermal_white_hot: bit 4. Thermal, hot is white.
        thermal_black_hot: bit 5. Thermal, hot is black.
        thermal_rainbow: bit 6. Thermal in colours.
        reserved_for_future_use: bit 7. Sent as 0, ignored when received.
        """
        color: ReportVisualSensorCapabilities.Color | int = jd.bits(0, 0x1, lambda: jd.Values(ReportVisualSensorCapabilities.Color))
        greyscale: ReportVisualSensorCapabilities.Greyscale | int = jd.bits(1, 0x1, lambda: jd.Values(ReportVisualSensorCapabilities.Greyscale))
        infrared: ReportVisualSensorCapabilities.Infrared | int = jd.bits(2, 0x1, lambda: jd.Values(ReportVisualSensorCapabilities.Infrared))
        lowlight: ReportVisualSensorCapabilities.Lowlight | int = jd.bits(3, 0x1, lambda: jd.Values(ReportVisualSensorCapabilities.Lowlight))
        thermal_white_hot: ReportVisualSensorCapabilities.ThermalWhiteHot | int = jd.bits(4, 0x1, lambda: jd.Values(ReportVisualSensorCapabilities.ThermalWhiteHot))
        thermal_black_hot: ReportVisualSensorCapabilities.ThermalBlackHot | int = jd.bits(5, 0x1, lambda: jd.Values(ReportVisualSensorCapabilities.ThermalBlackHot))
        thermal_rainbow: ReportVisualSensorCapabilities.ThermalRainbow | int = jd.bits(6, 0x1, lambda: jd.Values(ReportVisualSensorCapabilities.ThermalRainbow))
        reserved_for_future_use: ReportVisualSensorCapabilities.ReservedForFutureUse | int = jd.bits(7, 0x1, lambda: jd.Values(ReportVisualSensorCapabilities.ReservedForFutureUse))

    class ImageStabilization(IntEnum):
        FALSE = 0
        TRUE = 1

    @jd.record("H")
    class VisualSensorCapabilitiesRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        sensor_name: up to 255 characters. Name of the sensor, for people
        supported_states: optional. States that the sensor offers
        zoom_modes: optional. Ways of zooming that the camera offers
        focus_modes: optional. Ways of focusing that the camera offers
        white_balance: optional. Kinds of light that can be taken for white
        imaging_modes: optional. Kinds of image that the camera offers
        exposure_modes: optional. Ways of exposing that the camera offers
        metering_modes: optional. Ways of metering that the camera offers
        minimum_shutter_speed: 0..60 second, optional. Shortest exposure time, in seconds
        maximum_shutter_speed: 0..60 second, optional. Longest exposure time, in seconds
        minimum_aperture: 0.1..128, optional. Smallest f-number
        maximum_aperture: 0.1..128, optional. Largest f-number
        minimum_focal_length: 0..2 meter, optional. Smallest focal length, in metres
        maximum_focal_length: 0..2 meter, optional. Largest focal length, in metres
        light_sensitivity_levels: optional. Sensitivities that the camera offers
        image_stabilization: ImageStabilization, optional. Whether the camera can steady its image
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        sensor_name: str = jd.field("SensorName", jd.Text(count=jd.Count("B", 0, 255)))
        supported_states: environment_sensing_v1_0_types.SupportedStates | None = jd.field("SupportedStates", lambda: environment_sensing_v1_0_types.SupportedStates.layout(), default=None)
        zoom_modes: environment_sensing_v1_0_types.ZoomModes | None = jd.field("ZoomModes", lambda: environment_sensing_v1_0_types.ZoomModes.layout(), default=None)
        focus_modes: environment_sensing_v1_0_types.FocusModes | None = jd.field("FocusModes", lambda: environment_sensing_v1_0_types.FocusModes.layout(), default=None)
        white_balance: environment_sensing_v1_0_types.SupportedWhiteBalance | None = jd.field("WhiteBalance", lambda: environment_sensing_v1_0_types.SupportedWhiteBalance.layout(), default=None)
        imaging_modes: ReportVisualSensorCapabilities.ImagingModes | None = jd.field("ImagingModes", lambda: ReportVisualSensorCapabilities.ImagingModes.layout(), default=None)
        exposure_modes: environment_sensing_v1_0_types.ExposureModes | None = jd.field("ExposureModes", lambda: environment_sensing_v1_0_types.ExposureModes.layout(), default=None)
        metering_modes: environment_sensing_v1_0_types.MeteringModes | None = jd.field("MeteringModes", lambda: environment_sensing_v1_0_types.MeteringModes.layout(), default=None)
        minimum_shutter_speed: float | None = jd.field("MinimumShutterSpeed", jd.real("H", 0.0, 60.0, "second"), default=None)
        maximum_shutter_speed: float | None = jd.field("MaximumShutterSpeed", jd.real("H", 0.0, 60.0, "second"), default=None)
        minimum_aperture: float | None = jd.field("MinimumAperture", jd.real("H", 0.1, 128.0), default=None)
        maximum_aperture: float | None = jd.field("MaximumAperture", jd.real("H", 0.1, 128.0), default=None)
        minimum_focal_length: float | None = jd.field("MinimumFocalLength", jd.real("I", 0.0, 2.0, "meter"), default=None)
        maximum_focal_length: float | None = jd.field("MaximumFocalLength", jd.real("I", 0.0, 2.0, "meter"), default=None)
        light_sensitivity_levels: environment_sensing_v1_0_types.LightSensitivityLevels | None = jd.field("LightSensitivityLevels", lambda: environment_sensing_v1_0_types.LightSensitivityLevels.layout(), default=None)
        image_stabilization: ReportVisualSensorCapabilities.ImageStabilization | int | None = jd.field("ImageStabilization", lambda: jd.Number("B", jd.Values(ReportVisualSensorCapabilities.ImageStabilization)), default=None)
        reserved_presence: int = 0

    visual_sensor_capabilities_list: list[ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec] = jd.field("VisualSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x2806, query=True)
class QueryVisualSensorCapabilities(jd.Message):
    """QueryVisualSensorCapabilities (0x2806): Asks what cameras can do.

    query_visual_sensor_capabilities_list: 0..65535 items. The cameras
    """
    REPORT = ReportVisualSensorCapabilities

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    @jd.record()
    class QueryVisualSensorCapabilitiesRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryVisualSensorCapabilities.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryVisualSensorCapabilities.SensorID, ((1, 65535),))))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("H"))

    query_visual_sensor_capabilities_list: list[QueryVisualSensorCapabilities.QueryVisualSensorCapabilitiesRec] = jd.field("QueryVisualSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryVisualSensorCapabilities.QueryVisualSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x480A)
class ReportVisualSensorCapabilitiesExt(jd.Message):
    """ReportVisualSensorCapabilitiesExt (0x480A): Tells what cameras can do, least field of view included.

    visual_sensor_capabilities_list: 0..65535 items. The cameras
    """
    SupportedStates = environment_sensing_v1_0_types.SupportedStates
    ZoomModes = environment_sensing_v1_0_types.ZoomModes
    FocusModes = environment_sensing_v1_0_types.FocusModes
    SupportedWhiteBalance = environment_sensing_v1_0_types.SupportedWhiteBalance
    ExposureModes = environment_sensing_v1_0_types.ExposureModes
    MeteringModes = environment_sensing_v1_0_types.MeteringModes
    LightSensitivityLevels = environment_sensing_v1_0_types.LightSensitivityLevels

    class Color(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Greyscale(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Infrared(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class Lowlight(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ThermalWhiteHot(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ThermalBlackHot(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ThermalRainbow(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    class ReservedForFutureUse(IntEnum):
        RESERVED = 0

    class ReservedForProgramSpecificUse(IntEnum):
        RESERVED = 0

    @jd.bit_field("I")
    class ImagingModes(jd.Struct):
        """Kinds of image that the camera offers.

        color: bit 0. Colour.
        greyscale: bit 1. Greyscale.
        infrared: bit 2. Infrared.
        lowlight: bit 3. Weak light.
        thermal_white_hot: bit 4. Thermal, hot is white.
        thermal_black_hot: bit 5. Thermal, hot is black.
        thermal_rainbow: bit 6. Thermal in colours.
        reserved_for_future_use: bits 7..20. Sent as 0, ignored when received.
        reserved_for_program_specific_use: bits 21..31. Of meaning to the maker alone.
        """
        color: ReportVisualSensorCapabilitiesExt.Color | int = jd.bits(0, 0x1, lambda: jd.Values(ReportVisualSensorCapabilitiesExt.Color))
        greyscale: ReportVisualSensorCapabilitiesExt.Greyscale | int = jd.bits(1, 0x1, lambda: jd.Values(ReportVisualSensorCapabilitiesExt.Greyscale))
        infrared: ReportVisualSensorCapabilitiesExt.Infrared | int = jd.bits(2, 0x1, lambda: jd.Values(ReportVisualSensorCapabilitiesExt.Infrared))
        lowlight: ReportVisualSensorCapabilitiesExt.Lowlight | int = jd.bits(3, 0x1, lambda: jd.Values(ReportVisualSensorCapabilitiesExt.Lowlight))
        thermal_white_hot: ReportVisualSensorCapabilitiesExt.ThermalWhiteHot | int = jd.bits(4, 0x1, lambda: jd.Values(ReportVisualSensorCapabilitiesExt.ThermalWhiteHot))
        thermal_black_hot: ReportVisualSensorCapabilitiesExt.ThermalBlackHot | int = jd.bits(5, 0x1, lambda: jd.Values(ReportVisualSensorCapabilitiesExt.ThermalBlackHot))
        thermal_rainbow: ReportVisualSensorCapabilitiesExt.ThermalRainbow | int = jd.bits(6, 0x1, lambda: jd.Values(ReportVisualSensorCapabilitiesExt.ThermalRainbow))
        reserved_for_future_use: ReportVisualSensorCapabilitiesExt.ReservedForFutureUse | int = jd.bits(7, 0x3FFF, lambda: jd.Values(ReportVisualSensorCapabilitiesExt.ReservedForFutureUse))
        reserved_for_program_specific_use: ReportVisualSensorCapabilitiesExt.ReservedForProgramSpecificUse | int = jd.bits(21, 0x7FF, lambda: jd.Values(ReportVisualSensorCapabilitiesExt.ReservedForProgramSpecificUse))

    class ImageStabilization(IntEnum):
        FALSE = 0
        TRUE = 1

    @jd.record("I")
    class VisualSensorCapabilitiesRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        sensor_name: up to 255 characters. Name of the sensor, for people
        supported_states: optional. States that the sensor offers
        zoom_modes: optional. Ways of zooming that the camera offers
        focus_modes: optional. Ways of focusing that the camera offers
        white_balance: optional. Kinds of light that can be taken for white
        imaging_modes: optional. Kinds of image that the camera offers
        exposure_modes: optional. Ways of exposing that the camera offers
        metering_modes: optional. Ways of metering that the camera offers
        minimum_shutter_speed: 0..60 second, optional. Shortest exposure time, in seconds
        maximum_shutter_speed: 0..60 second, optional. Longest exposure time, in seconds
        minimum_aperture: 0.1..128, optional. Smallest f-number
        maximum_aperture: 0.1..128, optional. Largest f-number
        minimum_focal_length: 0..2 meter, optional. Smallest focal length, in metres
        maximum_focal_length: 0..2 meter, optional. Largest focal length, in metres
        light_sensitivity_levels: optional. Sensitivities that the camera offers
        image_stabilization: ImageStabilization, optional. Whether the camera can steady its image
        minimum_horizontal_field_of_view: -3.14159265359..3.14159265359 radian, optional. Smallest field of view from left to right, in radians
        maximum_horizontal_field_of_view: -3.14159265359..3.14159265359 radian, optional. Largest field of view from left to right, in radians
        minimum_vertical_field_of_view: -3.14159265359..3.14159265359 radian, optional. Smallest field of view from top to bottom, in radians
        maximum_vertical_field_of_view: -3.14159265359..3.14159265359 radian, optional. Largest field of view from top to bottom, in radians
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        sensor_name: str = jd.field("SensorName", jd.Text(count=jd.Count("B", 0, 255)))
        supported_states: environment_sensing_v1_0_types.SupportedStates | None = jd.field("SupportedStates", lambda: environment_sensing_v1_0_types.SupportedStates.layout(), default=None)
        zoom_modes: environment_sensing_v1_0_types.ZoomModes | None = jd.field("ZoomModes", lambda: environment_sensing_v1_0_types.ZoomModes.layout(), default=None)
        focus_modes: environment_sensing_v1_0_types.FocusModes | None = jd.field("FocusModes", lambda: environment_sensing_v1_0_types.FocusModes.layout(), default=None)
        white_balance: environment_sensing_v1_0_types.SupportedWhiteBalance | None = jd.field("WhiteBalance", lambda: environment_sensing_v1_0_types.SupportedWhiteBalance.layout(), default=None)
        imaging_modes: ReportVisualSensorCapabilitiesExt.ImagingModes | None = jd.field("ImagingModes", lambda: ReportVisualSensorCapabilitiesExt.ImagingModes.layout(), default=None)
        exposure_modes: environment_sensing_v1_0_types.ExposureModes | None = jd.field("ExposureModes", lambda: environment_sensing_v1_0_types.ExposureModes.layout(), default=None)
        metering_modes: environment_sensing_v1_0_types.MeteringModes | None = jd.field("MeteringModes", lambda: environment_sensing_v1_0_types.MeteringModes.layout(), default=None)
        minimum_shutter_speed: float | None = jd.field("MinimumShutterSpeed", jd.real("H", 0.0, 60.0, "second"), default=None)
        maximum_shutter_speed: float | None = jd.field("MaximumShutterSpeed", jd.real("H", 0.0, 60.0, "second"), default=None)
        minimum_aperture: float | None = jd.field("MinimumAperture", jd.real("H", 0.1, 128.0), default=None)
        maximum_aperture: float | None = jd.field("MaximumAperture", jd.real("H", 0.1, 128.0), default=None)
        minimum_focal_length: float | None = jd.field("MinimumFocalLength", jd.real("I", 0.0, 2.0, "meter"), default=None)
        maximum_focal_length: float | None = jd.field("MaximumFocalLength", jd.real("I", 0.0, 2.0, "meter"), default=None)
        light_sensitivity_levels: environment_sensing_v1_0_types.LightSensitivityLevels | None = jd.field("LightSensitivityLevels", lambda: environment_sensing_v1_0_types.LightSensitivityLevels.layout(), default=None)
        image_stabilization: ReportVisualSensorCapabilitiesExt.ImageStabilization | int | None = jd.field("ImageStabilization", lambda: jd.Number("B", jd.Values(ReportVisualSensorCapabilitiesExt.ImageStabilization)), default=None)
        minimum_horizontal_field_of_view: float | None = jd.field("MinimumHorizontalFieldOfView", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        maximum_horizontal_field_of_view: float | None = jd.field("MaximumHorizontalFieldOfView", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        minimum_vertical_field_of_view: float | None = jd.field("MinimumVerticalFieldOfView", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        maximum_vertical_field_of_view: float | None = jd.field("MaximumVerticalFieldOfView", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        reserved_presence: int = 0

    visual_sensor_capabilities_list: list[ReportVisualSensorCapabilitiesExt.VisualSensorCapabilitiesRec] = jd.field("VisualSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportVisualSensorCapabilitiesExt.VisualSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x280A, query=True)
class QueryVisualSensorCapabilitiesExt(jd.Message):
    """QueryVisualSensorCapabilitiesExt (0x280A): Asks what cameras can do, least field of view included.

    query_visual_sensor_capabilities_list: 0..65535 items. The cameras
    """
    REPORT = ReportVisualSensorCapabilitiesExt

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    @jd.record()
    class QueryVisualSensorCapabilitiesRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryVisualSensorCapabilitiesExt.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryVisualSensorCapabilitiesExt.SensorID, ((1, 65535),))))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("I"))

    query_visual_sensor_capabilities_list: list[QueryVisualSensorCapabilitiesExt.QueryVisualSensorCapabilitiesRec] = jd.field("QueryVisualSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryVisualSensorCapabilitiesExt.QueryVisualSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x0803, command=True)
class SetVisualSensorConfiguration(jd.Message):
    """SetVisualSensorConfiguration (0x0803): Sets the configuration of cameras.

    visual_sensor_configuration_list: 0..65535 items. The cameras
    """

    @jd.record()
    class RequestIdRec(jd.Struct):
        """request_id: Repeated in the answer, to match it with its request"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class SensorState(IntEnum):
        ACTIVE = 0
        STANDBY = 1
        OFF = 2

    class ZoomMode(IntEnum):
        MIXED = 0
        ANALOG_ONLY = 1
        DIGITAL_ONLY = 2
        OFF = 3

    class FocusMode(IntEnum):
        AUTO_FOCUS = 0
        MANUAL_FOCUS = 1

    class WhiteBalance(IntEnum):
        AUTO = 0
        DAYLIGHT = 1
        CLOUDY = 2
        SHADE = 3
        TUNGSTEN = 4
        FLUORESCENT = 5
        FLASH = 6

    class ImagingMode(IntEnum):
        COLOR = 0
        GREYSCALE = 1
        INFRARED = 2
        LOW_LIGHT = 3
        THERMAL_WHITE_HOT = 4
        THERMAL_BLACK_HOT = 5
        THERMAL_RAINBOW = 6

    class ExposureMode(IntEnum):
        AUTO = 0
        MANUAL = 1
        SHUTTER_PRIORITY = 2
        APERTURE_PRIORITY = 3

    class MeteringMode(IntEnum):
        AUTO = 0
        CENTER_WEIGHTED = 1
        SPOT = 2

    class LightSensitivity(IntEnum):
        AUTO = 0
        ISO_100 = 1
        ISO_200 = 2
        ISO_400 = 3
        ISO_800 = 4
        ISO_1600 = 5
        ISO_3200 = 6

    class ImageStabilization(IntEnum):
        OFF = 0
        ON = 1

    @jd.record("H")
    class VisualSensorConfigurationRec(jd.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        sensor_state: SensorState, optional. Whether the sensor works
        zoom_mode: ZoomMode, optional. Whether lens, computation or both zoom
        zoom_level: 0..100 percent, optional. Zoom, in percent from widest to narrowest
        focal_length: 0..2 meter, optional. Focal length, in metres
        horizontal_field_of_view: -3.14159265359..3.14159265359 radian, optional. Field of view from left to right, in radians
        vertical_field_of_view: -3.14159265359..3.14159265359 radian, optional. Field of view from top to bottom, in radians
        focus_mode: FocusMode, optional. Who focuses
        focus_value: 0..100 percent, optional. Focus, in percent from nearest to farthest
        white_balance: WhiteBalance, optional. Kind of light that is taken for white
        imaging_mode: ImagingMode or 7..20 or 21..31, optional. Kind of image
        exposure_mode: ExposureMode, optional. What of the exposure is automatic
        metering_mode: MeteringMode, optional. Part of the image that the exposure is measured in
        shutter_speed: 0..60 second, optional. Exposure time, in seconds
        aperture: 0.1..128, optional. Aperture as an f-number
        light_sensitivity: LightSensitivity, optional. Sensitivity as on the ISO scale
        image_stabilization: ImageStabilization, optional. Whether the image is steadied
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        sensor_state: SetVisualSensorConfiguration.SensorState | int | None = jd.field("SensorState", lambda: jd.Number("B", jd.Values(SetVisualSensorConfiguration.SensorState)), default=None)
        zoom_mode: SetVisualSensorConfiguration.ZoomMode | int | None = jd.field("ZoomMode", lambda: jd.Number("B", jd.Values(SetVisualSensorConfiguration.ZoomMode)), default=None)
        zoom_level: float | None = jd.field("ZoomLevel", jd.real("H", 0.0, 100.0, "percent"), default=None)
        focal_length: float | None = jd.field("FocalLength", jd.real("I", 0.0, 2.0, "meter"), default=None)
        horizontal_field_of_view: float | None = jd.field("HorizontalFieldOfView", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        vertical_field_of_view: float | None = jd.field("VerticalFieldOfView", jd.real("I", -3.141592653589793, 3.141592653589793, "radian"), default=None)
        focus_mode: SetVisualSensorConfiguration.FocusMode | int | None = jd.field("FocusMode", lambda: jd.Number("B", jd.Values(SetVisualSensorConfiguration.FocusMode)), default=None)
        focus_value: float | None = jd.field("FocusValue", jd.real("H", 0.0, 100.0, "percent"), default=None)
        white_balance: SetVisualSensorConfiguration.WhiteBalance | int | None = jd.field("WhiteBalance", lambda: jd.Number("B", jd.Values(SetVisualSensorConfiguration.WhiteBalance)), default=None)
        imaging_mode: SetVisualSensorConfiguration.ImagingMode | int | None = jd.field("ImagingMode", lambda: jd.Number("B", jd.Values(SetVisualSensorConfiguration.ImagingMode, ((7, 20), (21, 31)))), default=None)
        exposure_mode: SetVisualSensorConfiguration.ExposureMode | int | None = jd.field("ExposureMode", lambda: jd.Number("B", jd.Values(SetVisualSensorConfiguration.ExposureMode)), default=None)
        metering_mode: SetVisualSensorConfiguration.MeteringMode | int | None = jd.field("MeteringMode", lambda: jd.Number("B", jd.Values(SetVisualSensorConfiguration.MeteringMode)), default=None)
        shutter_speed: float | None = jd.field("ShutterSpeed", jd.real("H", 0.0, 60.0, "second"), default=None)
        aperture: float | None = jd.field("Aperture", jd.real("H", 0.1, 128.0), default=None)
        light_sensitivity: SetVisualSensorConfiguration.LightSensitivity | int | None = jd.field("LightSensitivity", lambda: jd.Number("B", jd.Values(SetVisualSensorConfiguration.LightSensitivity)), default=None)
        image_stabilization: SetVisualSensorConfiguration.ImageStabilization | int | None = jd.field("ImageStabilization", lambda: jd.Number("B", jd.Values(SetVisualSensorConfiguration.ImageStabilization)), default=None)

    request_id_rec: SetVisualSensorConfiguration.RequestIdRec = jd.field("RequestIdRec", lambda: SetVisualSensorConfiguration.RequestIdRec.layout())
    visual_sensor_configuration_list: list[SetVisualSensorConfiguration.VisualSensorConfigurationRec] = jd.field("VisualSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetVisualSensorConfiguration.VisualSensorConfigurationRec.layout()))

@jd.derived(_SERVICE)
class ConfirmSensorConfiguration(environment_sensing_v2_0_digital_audio_output.ConfirmSensorConfiguration): ...
