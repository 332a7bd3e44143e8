"""urn:jaus:jss:environmentSensing:VideoIlluminator 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v2_0 import digital_audio_output as environment_sensing_v2_0_digital_audio_output

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:VideoIlluminator", "2.0")


@jd.message(_SERVICE, 0x081A, command=True)
class SetVideoIlluminatorConfiguration(jd.Message):
    """SetVideoIlluminatorConfiguration (0x081A): Sets the configuration of lamps.

    illuminator_list: 0..65535 items. The lamps
    """

    @jd.record()
    class RequestIdRec(jd.Struct):
        """request_id: Repeated in the answer, to match it with its request"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class Mode(IntEnum):
        VISIBLE = 0
        INFRARED = 1
        GREYSCALE = 2
        LOWLIGHT = 3

    @jd.record("B")
    class IlluminatorRec(jd.Struct):
        """Settings of one lamp.

        illuminator_id: Identifies the lamp
        level: 0..100 percent. Brightness, in percent of the maximum
        mode: Mode or 4..20 or 21..31, optional. Kind of light
        beam_width: 0..360 degree, optional. Angle of the beam from left to right, in degrees
        beam_height: 0..360 degree, optional. Angle of the beam from top to bottom, in degrees
        """
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))
        level: float = jd.field("Level", jd.real("H", 0.0, 100.0, "percent"))
        mode: SetVideoIlluminatorConfiguration.Mode | int | None = jd.field("Mode", lambda: jd.Number("B", jd.Values(SetVideoIlluminatorConfiguration.Mode, ((4, 20), (21, 31)))), default=None)
        beam_width: float | None = jd.field("BeamWidth", jd.real("H", 0.0, 360.0, "degree"), default=None)
        beam_height: float | None = jd.field("BeamHeight", jd.real("H", 0.0, 360.0, "degree"), default=None)
        reserved_presence: int = 0

    request_id_rec: SetVideoIlluminatorConfiguration.RequestIdRec = jd.field("RequestIdRec", lambda: SetVideoIlluminatorConfiguration.RequestIdRec.layout())
    illuminator_list: list[SetVideoIlluminatorConfiguration.IlluminatorRec] = jd.field("IlluminatorList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetVideoIlluminatorConfiguration.IlluminatorRec.layout()))


@jd.message(_SERVICE, 0x481A)
class ReportVideoIlluminatorConfiguration(jd.Message):
    """ReportVideoIlluminatorConfiguration (0x481A): Tells the configuration of lamps.

    illumination_rec_list: 0..65535 items. The lamps
    """

    class Mode(IntEnum):
        VISIBLE = 0
        INFRARED = 1
        GREYSCALE = 2
        LOWLIGHT = 3

    @jd.record("B")
    class IlluminatorRec(jd.Struct):
        """Settings of one lamp.

        illuminator_id: Identifies the lamp
        level: 0..100 percent. Brightness, in percent of the maximum
        mode: Mode or 4..20 or 21..31, optional. Kind of light
        beam_width: 0..360 degree, optional. Angle of the beam from left to right, in degrees
        beam_height: 0..360 degree, optional. Angle of the beam from top to bottom, in degrees
        """
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))
        level: float = jd.field("Level", jd.real("H", 0.0, 100.0, "percent"))
        mode: ReportVideoIlluminatorConfiguration.Mode | int | None = jd.field("Mode", lambda: jd.Number("B", jd.Values(ReportVideoIlluminatorConfiguration.Mode, ((4, 20), (21, 31)))), default=None)
        beam_width: float | None = jd.field("BeamWidth", jd.real("H", 0.0, 360.0, "degree"), default=None)
        beam_height: float | None = jd.field("BeamHeight", jd.real("H", 0.0, 360.0, "degree"), default=None)
        reserved_presence: int = 0

    illumination_rec_list: list[ReportVideoIlluminatorConfiguration.IlluminatorRec] = jd.field("IlluminationRecList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportVideoIlluminatorConfiguration.IlluminatorRec.layout()))


@jd.message(_SERVICE, 0x281A, query=True)
class QueryVideoIlluminatorConfiguration(jd.Message):
    """QueryVideoIlluminatorConfiguration (0x281A): Asks for the configuration of lamps.

    illuminator_id_list: 0..65535 items. The lamps
    """
    REPORT = ReportVideoIlluminatorConfiguration

    @jd.record()
    class IlluminatorIDRec(jd.Struct):
        """illuminator_id: Identifies the lamp"""
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))

    illuminator_id_list: list[QueryVideoIlluminatorConfiguration.IlluminatorIDRec] = jd.field("IlluminatorIDList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryVideoIlluminatorConfiguration.IlluminatorIDRec.layout()))


@jd.message(_SERVICE, 0x481B)
class ReportVideoIlluminatorCapabilities(jd.Message):
    """ReportVideoIlluminatorCapabilities (0x481B): Tells what lamps can do.

    illuminator_capabilities_list: 0..65535 items. The lamps
    """

    class Visible(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Infrared(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class GreyScale(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class LowLight(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @jd.bit_field("I")
    class SupportedIlluminationModes(jd.Struct):
        """Kinds of light that the lamp offers.

        visible: bit 0. Visible light.
        infrared: bit 1. Infrared light.
        grey_scale: bit 2. Light for greyscale images.
        low_light: bit 3. Weak light.
        reserved_for_future_use: bits 4..20. Sent as 0, ignored when received.
        reserved_for_program_or_implementation_specific_use: bits 21..31. Of meaning to the maker alone.
        """
        visible: ReportVideoIlluminatorCapabilities.Visible | int = jd.bits(0, 0x1, lambda: jd.Values(ReportVideoIlluminatorCapabilities.Visible))
        infrared: ReportVideoIlluminatorCapabilities.Infrared | int = jd.bits(1, 0x1, lambda: jd.Values(ReportVideoIlluminatorCapabilities.Infrared))
        grey_scale: ReportVideoIlluminatorCapabilities.GreyScale | int = jd.bits(2, 0x1, lambda: jd.Values(ReportVideoIlluminatorCapabilities.GreyScale))
        low_light: ReportVideoIlluminatorCapabilities.LowLight | int = jd.bits(3, 0x1, lambda: jd.Values(ReportVideoIlluminatorCapabilities.LowLight))
        reserved_for_future_use: int = jd.bits(4, 0x1FFFF, jd.Values(None, ((0, 1),)))
        reserved_for_program_or_implementation_specific_use: int = jd.bits(21, 0x7FF, jd.Values(None, ((0, 1),)))

    @jd.record("B")
    class IlluminatorCapabilitiesRec(jd.Struct):
        """illuminator_id: Identifies the lamp
        illuminator_name: up to 255 characters. Name of the lamp, for people
        supported_illumination_modes: Kinds of light that the lamp offers
        minimum_intensity: in lumen, optional. Smallest brightness, in lumens
        maximum_intensity: in lumen, optional. Largest brightness, in lumens
        minimum_supported_beam_width: 0..360 degree, optional. Smallest angle of the beam from left to right, in degrees
        maximum_supported_beam_width: 0..360 degree, optional. Largest angle of the beam from left to right, in degrees
        minimum_supported_beam_height: 0..360 degree, optional. Smallest angle of the beam from top to bottom, in degrees
        maximum_supported_beam_height: 0..360 degree, optional. Largest angle of the beam from top to bottom, in degrees
        """
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))
        illuminator_name: str = jd.field("IlluminatorName", jd.Text(count=jd.Count("B", 0, 255)))
        supported_illumination_modes: ReportVideoIlluminatorCapabilities.SupportedIlluminationModes = jd.field("SupportedIlluminationModes", lambda: ReportVideoIlluminatorCapabilities.SupportedIlluminationModes.layout())
        minimum_intensity: int | None = jd.field("MinimumIntensity", jd.Number("H", jd.ANY, "lumen"), default=None)
        maximum_intensity: int | None = jd.field("MaximumIntensity", jd.Number("H", jd.ANY, "lumen"), default=None)
        minimum_supported_beam_width: float | None = jd.field("MinimumSupportedBeamWidth", jd.real("H", 0.0, 360.0, "degree"), default=None)
        maximum_supported_beam_width: float | None = jd.field("MaximumSupportedBeamWidth", jd.real("H", 0.0, 360.0, "degree"), default=None)
        minimum_supported_beam_height: float | None = jd.field("MinimumSupportedBeamHeight", jd.real("H", 0.0, 360.0, "degree"), default=None)
        maximum_supported_beam_height: float | None = jd.field("MaximumSupportedBeamHeight", jd.real("H", 0.0, 360.0, "degree"), default=None)
        reserved_presence: int = 0

    @jd.record()
    class SensorIDRec(jd.Struct):
        """One sensor.

        sensor_id: Identifies the sensor
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    @jd.record()
    class IlluminatorCapabilitiesSeq(jd.Struct):
        """sensor_id_list: 0..255 items. The sensors that the lamp is for"""
        illuminator_capabilities_rec: ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesRec = jd.field("IlluminatorCapabilitiesRec", lambda: ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesRec.layout())
        sensor_id_list: list[ReportVideoIlluminatorCapabilities.SensorIDRec] = jd.field("SensorIDList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportVideoIlluminatorCapabilities.SensorIDRec.layout()))

    illuminator_capabilities_list: list[ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesSeq] = jd.field("IlluminatorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportVideoIlluminatorCapabilities.IlluminatorCapabilitiesSeq.layout()))


@jd.message(_SERVICE, 0x281B, query=True)
class QueryVideoIlluminatorCapabilities(jd.Message):
    """QueryVideoIlluminatorCapabilities (0x281B): Asks what lamps can do.

    illuminator_id_list: 0..65535 items. The lamps
    """
    REPORT = ReportVideoIlluminatorCapabilities

    @jd.record()
    class IlluminatorIDRec(jd.Struct):
        """illuminator_id: Identifies the lamp"""
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))

    illuminator_id_list: list[QueryVideoIlluminatorCapabilities.IlluminatorIDRec] = jd.field("IlluminatorIDList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryVideoIlluminatorCapabilities.IlluminatorIDRec.layout()))

@jd.derived(_SERVICE)
class ConfirmSensorConfiguration(environment_sensing_v2_0_digital_audio_output.ConfirmSensorConfiguration): ...
