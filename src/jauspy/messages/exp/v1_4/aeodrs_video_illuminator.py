"""urn:jaus:jss:exp:aeodrs:AEODRSVideoIlluminator 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:AEODRSVideoIlluminator", "1.4")


@jd.message(_SERVICE, 0xF801)
class ReportDigitalVideoIlluminator(jd.Message):
    """ReportDigitalVideoIlluminator (0xF801): Tells the commanded brightness and beam width of the lamps.

    illumination_record_list: 0..65535 items. One element a lamp
    """

    @jd.record()
    class IlluminationRecordRec(jd.Struct):
        """illuminator_id: Number of the lamp; 0 is not allowed
        level: 0..100 percent. Brightness, in percent of full output
        beamwidth: 0..360 degree. Horizontal opening angle of the beam, in degrees
        """
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))
        level: float = jd.field("Level", jd.real("H", 0.0, 100.0, "percent"))
        beamwidth: float = jd.field("Beamwidth", jd.real("H", 0.0, 360.0, "degree"))

    illumination_record_list: list[ReportDigitalVideoIlluminator.IlluminationRecordRec] = jd.field("IlluminationRecordList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalVideoIlluminator.IlluminationRecordRec.layout()))


@jd.message(_SERVICE, 0xE801, query=True)
class QueryDigitalVideoIlluminator(jd.Message):
    """QueryDigitalVideoIlluminator (0xE801): Asks for the commanded brightness and beam width of the listed lamps.

    sensor_id_list: 0..65535 items. Lamps asked about
    """
    REPORT = ReportDigitalVideoIlluminator

    @jd.record()
    class SensorIdRec(jd.Struct):
        """illuminator_id: Number of the lamp; 0 is not allowed"""
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))

    sensor_id_list: list[QueryDigitalVideoIlluminator.SensorIdRec] = jd.field("SensorIdList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryDigitalVideoIlluminator.SensorIdRec.layout()))


@jd.message(_SERVICE, 0xF803)
class ReportDigitalVideoIlluminatorCapabilities(jd.Message):
    """ReportDigitalVideoIlluminatorCapabilities (0xF803): Tells what the lamps can do.

    digital_video_illuminator_capabilities_list: 0..65535 items. One element a lamp
    """

    @jd.bit_field("B")
    class IlluminationModes(jd.Struct):
        """A set bit marks a mode that the lamp has.

        color: bit 0. Color.
        greyscale: bit 1. Greyscale.
        infrared: bit 2. Infrared.
        lowlight: bit 3. Lowlight.
        """
        color: int = jd.bits(0, 0x1)
        greyscale: int = jd.bits(1, 0x1)
        infrared: int = jd.bits(2, 0x1)
        lowlight: int = jd.bits(3, 0x1)
        reserved_bits: int = 0

    @jd.record()
    class DigitalVideoIlluminatorCapabilityRec(jd.Struct):
        """illuminator_id: Number of the lamp; 0 is not allowed
        illuminator_name: up to 255 characters. Name of the lamp for people to read
        illumination_modes: A set bit marks a mode that the lamp has
        max_beamwidth: 0..360 degree. Widest horizontal opening angle of the beam, in degrees
        """
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))
        illuminator_name: str = jd.field("IlluminatorName", jd.Text(count=jd.Count("B", 0, 255)))
        illumination_modes: ReportDigitalVideoIlluminatorCapabilities.IlluminationModes = jd.field("IlluminationModes", lambda: ReportDigitalVideoIlluminatorCapabilities.IlluminationModes.layout())
        max_beamwidth: float = jd.field("MaxBeamwidth", jd.real("H", 0.0, 360.0, "degree"))

    digital_video_illuminator_capabilities_list: list[ReportDigitalVideoIlluminatorCapabilities.DigitalVideoIlluminatorCapabilityRec] = jd.field("DigitalVideoIlluminatorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalVideoIlluminatorCapabilities.DigitalVideoIlluminatorCapabilityRec.layout()))


@jd.message(_SERVICE, 0xE803, query=True)
class QueryDigitalVideoIlluminatorCapabilities(jd.Message):
    """QueryDigitalVideoIlluminatorCapabilities (0xE803): Asks what the listed lamps can do.

    query_digital_video_illuminator_capabilities_list: 0..65535 items. Lamps asked about
    """
    REPORT = ReportDigitalVideoIlluminatorCapabilities

    @jd.record()
    class QueryDigitalVideoIlluminatorCapabilityRec(jd.Struct):
        """illuminator_id: Number of the lamp; 0 stands for every lamp"""
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))

    query_digital_video_illuminator_capabilities_list: list[QueryDigitalVideoIlluminatorCapabilities.QueryDigitalVideoIlluminatorCapabilityRec] = jd.field("QueryDigitalVideoIlluminatorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryDigitalVideoIlluminatorCapabilities.QueryDigitalVideoIlluminatorCapabilityRec.layout()))


@jd.message(_SERVICE, 0xF804)
class ReportDigitalVideoIlluminatorConfiguration(jd.Message):
    """ReportDigitalVideoIlluminatorConfiguration (0xF804): Tells the mode and the assigned cameras of one lamp.

    illuminator_config_record: Illuminator config
    sensors_list: 0..255 items. Cameras assigned to the lamp; empty if there are none
    """

    class IlluminationMode(IntEnum):
        COLOR = 0
        GREYSCALE = 1
        INFRARED = 2
        LOWLIGHT = 3

    @jd.record()
    class IlluminatorConfigRecord(jd.Struct):
        """Illuminator config.

        illuminator_id: Number of the lamp; 0 is not allowed
        illumination_mode: IlluminationMode. Mode in force
        """
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))
        illumination_mode: ReportDigitalVideoIlluminatorConfiguration.IlluminationMode | int = jd.field("IlluminationMode", lambda: jd.Number("B", jd.Values(ReportDigitalVideoIlluminatorConfiguration.IlluminationMode)))

    @jd.record()
    class SensorRec(jd.Struct):
        """sensor_id: Number of an assigned camera"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    illuminator_config_record: ReportDigitalVideoIlluminatorConfiguration.IlluminatorConfigRecord = jd.field("IlluminatorConfigRecord", lambda: ReportDigitalVideoIlluminatorConfiguration.IlluminatorConfigRecord.layout())
    sensors_list: list[ReportDigitalVideoIlluminatorConfiguration.SensorRec] = jd.field("SensorsList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportDigitalVideoIlluminatorConfiguration.SensorRec.layout()))


@jd.message(_SERVICE, 0xE804, query=True)
class QueryDigitalVideoIlluminatorConfiguration(jd.Message):
    """QueryDigitalVideoIlluminatorConfiguration (0xE804): Asks for the mode and the assigned cameras of one lamp.

    illuminator_id: Number of the lamp; 0 is not allowed
    """
    REPORT = ReportDigitalVideoIlluminatorConfiguration
    illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))


@jd.message(_SERVICE, 0xD801, command=True)
class SetDigitalVideoIlluminator(jd.Message):
    """SetDigitalVideoIlluminator (0xD801): Sets brightness and beam width of one lamp.

    illuminator_id: Number of the lamp; 0 is not allowed
    level: 0..100 percent. Brightness, in percent of full output
    beamwidth: 0..360 degree. Horizontal opening angle of the beam, in degrees
    """
    illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))
    level: float = jd.field("Level", jd.real("H", 0.0, 100.0, "percent"))
    beamwidth: float = jd.field("Beamwidth", jd.real("H", 0.0, 360.0, "degree"))


@jd.message(_SERVICE, 0xD804, command=True)
class SetDigitalVideoIlluminatorConfiguration(jd.Message):
    """SetDigitalVideoIlluminatorConfiguration (0xD804): Sets the mode of one lamp and the cameras assigned to it.

    illuminator_config_record: Illuminator config
    sensor_list: 0..255 items. Cameras to assign to the lamp; an empty list clears the assignment
    """

    class IlluminationMode(IntEnum):
        COLOR = 0
        GREYSCALE = 1
        INFRARED = 2
        LOWLIGHT = 3

    @jd.record()
    class IlluminatorConfigRecord(jd.Struct):
        """Illuminator config.

        illuminator_id: Number of the lamp; 0 is not allowed
        illumination_mode: IlluminationMode. Mode in force
        """
        illuminator_id: int = jd.field("IlluminatorID", jd.Number("H"))
        illumination_mode: SetDigitalVideoIlluminatorConfiguration.IlluminationMode | int = jd.field("IlluminationMode", lambda: jd.Number("B", jd.Values(SetDigitalVideoIlluminatorConfiguration.IlluminationMode)))

    @jd.record()
    class SensorRec(jd.Struct):
        """sensor_id: Number of a camera to assign"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    illuminator_config_record: SetDigitalVideoIlluminatorConfiguration.IlluminatorConfigRecord = jd.field("IlluminatorConfigRecord", lambda: SetDigitalVideoIlluminatorConfiguration.IlluminatorConfigRecord.layout())
    sensor_list: list[SetDigitalVideoIlluminatorConfiguration.SensorRec] = jd.field("SensorList", lambda: jd.Repeat(jd.Count("B", 0, 255), SetDigitalVideoIlluminatorConfiguration.SensorRec.layout()))
