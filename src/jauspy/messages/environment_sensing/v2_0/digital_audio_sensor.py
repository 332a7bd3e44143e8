"""urn:jaus:jss:environmentSensing:DigitalAudioSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types
from jauspy.messages.environment_sensing.v2_0 import digital_audio_output as environment_sensing_v2_0_digital_audio_output

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:DigitalAudioSensor", "2.0")


@jd.message(_SERVICE, 0x080F, command=True)
class SetDigitalAudioSensorConfiguration(jd.Message):
    """SetDigitalAudioSensorConfiguration (0x080F): Sets the configuration of microphones.

    digital_audio_sensor_configuration_list: 0..65535 items. The microphones
    """

    @jd.record()
    class RequestIdRec(jd.Struct):
        """request_id: Repeated in the answer, to match it with its request"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class DigitalFormat(IntEnum):
        LPCM_PCM = 0
        AIFF = 1
        WAV = 2
        ALAC = 3
        FLAC = 4
        REALAUDIO = 5
        WMA9_LOSSLESS = 6
        TRUE_AUDIO = 7
        DOLBY_DIGITAL = 8
        DTS = 9
        MP2 = 10
        MP3 = 11
        AAC_MPEG2 = 12
        AAC_MPEG4 = 13
        VORBIS = 14
        WMA = 15
        SPEEX = 16

    class BitDepth(IntEnum):
        EIGHT_BITS = 0
        TEN_BITS = 1
        TWELVE_BITS = 2
        FOURTEEN_BITS = 3
        SIXTEEN_BITS = 4
        TWENTY_BITS = 5
        TWENTY_FOUR_BITS = 6
        THIRTY_TWO_BITS = 7

    class EncodingQuality(IntEnum):
        BEST = 0
        BETTER = 1
        GOOD = 2
        AVERAGE = 3
        ADEQUATE = 4
        POOR = 5
        WORST = 6

    @jd.record("B")
    class DigitalAudioSensorConfigurationRec(jd.Struct):
        """Settings of one microphone.

        sensor_id: 1..65535. Identifies the sensor
        sensitivity: 0..100, optional. Sensitivity of the microphone, in percent
        minimum_bit_rate: optional. Smallest bit rate, in kilobits per second
        maximum_bit_rate: optional. Largest bit rate, in kilobits per second
        digital_format: DigitalFormat, optional. Coding of the audio
        sample_rate: optional. Samples per second
        bit_depth: BitDepth, optional. Bits per sample
        encoding_quality: EncodingQuality, optional. Quality of the coding
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        sensitivity: float | None = jd.field("Sensitivity", jd.real("H", 0.0, 100.0), default=None)
        minimum_bit_rate: int | None = jd.field("MinimumBitRate", jd.Number("H"), default=None)
        maximum_bit_rate: int | None = jd.field("MaximumBitRate", jd.Number("H"), default=None)
        digital_format: SetDigitalAudioSensorConfiguration.DigitalFormat | int | None = jd.field("DigitalFormat", lambda: jd.Number("B", jd.Values(SetDigitalAudioSensorConfiguration.DigitalFormat)), default=None)
        sample_rate: int | None = jd.field("SampleRate", jd.Number("I"), default=None)
        bit_depth: SetDigitalAudioSensorConfiguration.BitDepth | int | None = jd.field("BitDepth", lambda: jd.Number("B", jd.Values(SetDigitalAudioSensorConfiguration.BitDepth)), default=None)
        encoding_quality: SetDigitalAudioSensorConfiguration.EncodingQuality | int | None = jd.field("EncodingQuality", lambda: jd.Number("B", jd.Values(SetDigitalAudioSensorConfiguration.EncodingQuality)), default=None)
        reserved_presence: int = 0

    request_id_rec: SetDigitalAudioSensorConfiguration.RequestIdRec = jd.field("RequestIdRec", lambda: SetDigitalAudioSensorConfiguration.RequestIdRec.layout())
    digital_audio_sensor_configuration_list: list[SetDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec] = jd.field("DigitalAudioSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x4817)
class ReportDigitalAudioSensorCapabilities(jd.Message):
    """ReportDigitalAudioSensorCapabilities (0x4817): Tells what microphones can do.

    digital_audio_sensor_capabilities_list: 0..65535 items. The microphones
    """
    SupportedAudioFormats = environment_sensing_v1_0_types.SupportedAudioFormats
    SupportedBitDepths = environment_sensing_v1_0_types.SupportedBitDepths

    class Best(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Better(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Good(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Average(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Adequate(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Poor(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Worst(IntEnum):
        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @jd.bit_field("B")
    class SupportedQualityLevels(jd.Struct):
        """Qualities of coding that can be had.

        best: bit 0. Highest quality.
        better: bit 1. Second best quality.
        good: bit 2. Third best quality.
        average: bit 3. Middle quality.
        adequate: bit 4. Third worst quality.
        poor: bit 5. Second worst quality.
        worst: bit 6. Lowest quality.
        """
        best: ReportDigitalAudioSensorCapabilities.Best | int = jd.bits(0, 0x1, lambda: jd.Values(ReportDigitalAudioSensorCapabilities.Best))
        better: ReportDigitalAudioSensorCapabilities.Better | int = jd.bits(1, 0x1, lambda: jd.Values(ReportDigitalAudioSensorCapabilities.Better))
        good: ReportDigitalAudioSensorCapabilities.Good | int = jd.bits(2, 0x1, lambda: jd.Values(ReportDigitalAudioSensorCapabilities.Good))
        average: ReportDigitalAudioSensorCapabilities.Average | int = jd.bits(3, 0x1, lambda: jd.Values(ReportDigitalAudioSensorCapabilities.Average))
        adequate: ReportDigitalAudioSensorCapabilities.Adequate | int = jd.bits(4, 0x1, lambda: jd.Values(ReportDigitalAudioSensorCapabilities.Adequate))
        poor: ReportDigitalAudioSensorCapabilities.Poor | int = jd.bits(5, 0x1, lambda: jd.Values(ReportDigitalAudioSensorCapabilities.Poor))
        worst: ReportDigitalAudioSensorCapabilities.Worst | int = jd.bits(6, 0x1, lambda: jd.Values(ReportDigitalAudioSensorCapabilities.Worst))
        reserved_bits: int = 0

    @jd.record("B")
    class DigitalAudioSensorCapabilitiesRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        minimum_allowed_bit_rate: optional. Smallest bit rate that can be set, in kilobits per second
        maximum_allowed_bit_rate: optional. Largest bit rate that can be set, in kilobits per second
        supported_digital_formats: optional. Codings of audio that the microphone offers
        min_sample_rate: optional. Smallest number of samples per second
        max_sample_rate: optional. Largest number of samples per second
        supported_bit_depths: optional. Bits per sample that can be had
        supported_quality_levels: optional. Qualities of coding that can be had
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        minimum_allowed_bit_rate: int | None = jd.field("MinimumAllowedBitRate", jd.Number("H"), default=None)
        maximum_allowed_bit_rate: int | None = jd.field("MaximumAllowedBitRate", jd.Number("H"), default=None)
        supported_digital_formats: environment_sensing_v1_0_types.SupportedAudioFormats | None = jd.field("SupportedDigitalFormats", lambda: environment_sensing_v1_0_types.SupportedAudioFormats.layout(), default=None)
        min_sample_rate: int | None = jd.field("MinSampleRate", jd.Number("I"), default=None)
        max_sample_rate: int | None = jd.field("MaxSampleRate", jd.Number("I"), default=None)
        supported_bit_depths: environment_sensing_v1_0_types.SupportedBitDepths | None = jd.field("SupportedBitDepths", lambda: environment_sensing_v1_0_types.SupportedBitDepths.layout(), default=None)
        supported_quality_levels: ReportDigitalAudioSensorCapabilities.SupportedQualityLevels | None = jd.field("SupportedQualityLevels", lambda: ReportDigitalAudioSensorCapabilities.SupportedQualityLevels.layout(), default=None)
        reserved_presence: int = 0

    digital_audio_sensor_capabilities_list: list[ReportDigitalAudioSensorCapabilities.DigitalAudioSensorCapabilitiesRec] = jd.field("DigitalAudioSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalAudioSensorCapabilities.DigitalAudioSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x2817, query=True)
class QueryDigitalAudioSensorCapabilities(jd.Message):
    """QueryDigitalAudioSensorCapabilities (0x2817): Asks what microphones can do.

    sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
    """
    REPORT = ReportDigitalAudioSensorCapabilities

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    sensor_id: QueryDigitalAudioSensorCapabilities.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryDigitalAudioSensorCapabilities.SensorID, ((1, 65535),))))


@jd.message(_SERVICE, 0x480F)
class ReportDigitalAudioSensorConfiguration(jd.Message):
    """ReportDigitalAudioSensorConfiguration (0x480F): Tells the configuration of microphones.

    digital_audio_sensor_configuration_list: 0..65535 items. The microphones
    """

    class DigitalFormat(IntEnum):
        LPCM_PCM = 0
        AIFF = 1
        WAV = 2
        ALAC = 3
        FLAC = 4
        REALAUDIO = 5
        WMA9_LOSSLESS = 6
        TRUE_AUDIO = 7
        DOLBY_DIGITAL = 8
        DTS = 9
        MP2 = 10
        MP3 = 11
        AAC_MPEG2 = 12
        AAC_MPEG4 = 13
        VORBIS = 14
        WMA = 15
        SPEEX = 16

    class BitDepth(IntEnum):
        EIGHT_BITS = 0
        TEN_BITS = 1
        TWELVE_BITS = 2
        FOURTEEN_BITS = 3
        SIXTEEN_BITS = 4
        TWENTY_BITS = 5
        TWENTY_FOUR_BITS = 6
        THIRTY_TWO_BITS = 7

    class EncodingQuality(IntEnum):
        BEST = 0
        BETTER = 1
        GOOD = 2
        AVERAGE = 3
        ADEQUATE = 4
        POOR = 5
        WORST = 6

    @jd.record("B")
    class DigitalAudioSensorConfigurationRec(jd.Struct):
        """Settings of one microphone.

        sensor_id: 1..65535. Identifies the sensor
        sensitivity: 0..100, optional. Sensitivity of the microphone, in percent
        minimum_bit_rate: optional. Smallest bit rate, in kilobits per second
        maximum_bit_rate: optional. Largest bit rate, in kilobits per second
        digital_format: DigitalFormat, optional. Coding of the audio
        sample_rate: optional. Samples per second
        bit_depth: BitDepth, optional. Bits per sample
        encoding_quality: EncodingQuality, optional. Quality of the coding
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        sensitivity: float | None = jd.field("Sensitivity", jd.real("H", 0.0, 100.0), default=None)
        minimum_bit_rate: int | None = jd.field("MinimumBitRate", jd.Number("H"), default=None)
        maximum_bit_rate: int | None = jd.field("MaximumBitRate", jd.Number("H"), default=None)
        digital_format: ReportDigitalAudioSensorConfiguration.DigitalFormat | int | None = jd.field("DigitalFormat", lambda: jd.Number("B", jd.Values(ReportDigitalAudioSensorConfiguration.DigitalFormat)), default=None)
        sample_rate: int | None = jd.field("SampleRate", jd.Number("I"), default=None)
        bit_depth: ReportDigitalAudioSensorConfiguration.BitDepth | int | None = jd.field("BitDepth", lambda: jd.Number("B", jd.Values(ReportDigitalAudioSensorConfiguration.BitDepth)), default=None)
        encoding_quality: ReportDigitalAudioSensorConfiguration.EncodingQuality | int | None = jd.field("EncodingQuality", lambda: jd.Number("B", jd.Values(ReportDigitalAudioSensorConfiguration.EncodingQuality)), default=None)
        reserved_presence: int = 0

    digital_audio_sensor_configuration_list: list[ReportDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec] = jd.field("DigitalAudioSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x280F, query=True)
class QueryDigitalAudioSensorConfiguration(jd.Message):
    """QueryDigitalAudioSensorConfiguration (0x280F): Asks for the configuration of microphones.

    sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
    """
    REPORT = ReportDigitalAudioSensorConfiguration

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    sensor_id: QueryDigitalAudioSensorConfiguration.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryDigitalAudioSensorConfiguration.SensorID, ((1, 65535),))))

@jd.derived(_SERVICE)
class ConfirmSensorConfiguration(environment_sensing_v2_0_digital_audio_output.ConfirmSensorConfiguration): ...
