"""urn:jaus:jss:iop:DigitalAudio 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:DigitalAudio", "1.1")


@jd.message(_SERVICE, 0xDAEE)
class ReportDigitalAudioCapabilities(jd.Message):
    """ReportDigitalAudioCapabilities (0xDAEE): What each listed sensor can do.

    digital_audio_capabilities_list: 0..65535 items. One element per sensor
    """

    @jd.bit_field("I")
    class SupportedDigitalFormats(jd.Struct):
        """Audio codings that can be chosen.

        lpcm_pcm: bit 0. Lpcm pcm.
        aiff: bit 1. AIFF.
        wav: bit 2. WAV.
        alac: bit 3. ALAC.
        flac: bit 4. FLAC.
        real_audio: bit 5. Real audio.
        wma9_lossless: bit 6. WMA 9 lossless.
        true_audio: bit 7. True audio.
        dolby_digital: bit 8. Dolby digital.
        dts: bit 9. DTS.
        mp2: bit 10. MP 2.
        mp3: bit 11. MP 3.
        aac_mpeg2: bit 12. Aac mpeg2.
        aac_mpeg4: bit 13. Aac mpeg4.
        vorbis: bit 14. VORBIS.
        wma: bit 15. WMA.
        speex: bit 16. Speex.
        """
        lpcm_pcm: int = jd.bits(0, 0x1)
        aiff: int = jd.bits(1, 0x1)
        wav: int = jd.bits(2, 0x1)
        alac: int = jd.bits(3, 0x1)
        flac: int = jd.bits(4, 0x1)
        real_audio: int = jd.bits(5, 0x1)
        wma9_lossless: int = jd.bits(6, 0x1)
        true_audio: int = jd.bits(7, 0x1)
        dolby_digital: int = jd.bits(8, 0x1)
        dts: int = jd.bits(9, 0x1)
        mp2: int = jd.bits(10, 0x1)
        mp3: int = jd.bits(11, 0x1)
        aac_mpeg2: int = jd.bits(12, 0x1)
        aac_mpeg4: int = jd.bits(13, 0x1)
        vorbis: int = jd.bits(14, 0x1)
        wma: int = jd.bits(15, 0x1)
        speex: int = jd.bits(16, 0x1)
        reserved_bits: int = 0

    @jd.bit_field("H")
    class SupportedBitDepths(jd.Struct):
        """Sample sizes that can be chosen.

        eight_bits: bit 0. Eight bits.
        ten_bits: bit 1. Ten bits.
        twelve_bits: bit 2. Twelve bits.
        fourteen_bits: bit 3. Fourteen bits.
        sixteen_bits: bit 4. Sixteen bits.
        twenty_bits: bit 5. Twenty bits.
        twenty_four_bits: bit 6. Twenty four bits.
        thirty_two_bits: bit 7. Thirty two bits.
        """
        eight_bits: int = jd.bits(0, 0x1)
        ten_bits: int = jd.bits(1, 0x1)
        twelve_bits: int = jd.bits(2, 0x1)
        fourteen_bits: int = jd.bits(3, 0x1)
        sixteen_bits: int = jd.bits(4, 0x1)
        twenty_bits: int = jd.bits(5, 0x1)
        twenty_four_bits: int = jd.bits(6, 0x1)
        thirty_two_bits: int = jd.bits(7, 0x1)
        reserved_bits: int = 0

    @jd.bit_field("B")
    class SupportedQualityLevels(jd.Struct):
        """Quality steps of the encoder that can be chosen.

        best: bit 0. Best.
        better: bit 1. Better.
        good: bit 2. Good.
        average: bit 3. Average.
        less: bit 4. Less.
        poor: bit 5. Poor.
        worst: bit 6. Worst.
        """
        best: int = jd.bits(0, 0x1)
        better: int = jd.bits(1, 0x1)
        good: int = jd.bits(2, 0x1)
        average: int = jd.bits(3, 0x1)
        less: int = jd.bits(4, 0x1)
        poor: int = jd.bits(5, 0x1)
        worst: int = jd.bits(6, 0x1)
        reserved_bits: int = 0

    @jd.record("B")
    class DigitalAudioCapabilityRec(jd.Struct):
        """sensor_id: Sensor that the element is about; zero is not allowed
        minimum_allowed_bit_rate: optional. Lowest bit rate that can be set, in kbit/s (192 by default)
        maximum_allowed_bit_rate: optional. Highest bit rate that can be set, in kbit/s (192 by default)
        supported_digital_formats: optional. Audio codings that can be chosen
        min_sample_rate: optional. Fewest samples per second (44100 by default)
        max_sample_rate: optional. Most samples per second (44100 by default)
        supported_bit_depths: optional. Sample sizes that can be chosen
        supported_quality_levels: optional. Quality steps of the encoder that can be chosen
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        minimum_allowed_bit_rate: int | None = jd.field("MinimumAllowedBitRate", jd.Number("H"), default=None)
        maximum_allowed_bit_rate: int | None = jd.field("MaximumAllowedBitRate", jd.Number("H"), default=None)
        supported_digital_formats: ReportDigitalAudioCapabilities.SupportedDigitalFormats | None = jd.field("SupportedDigitalFormats", lambda: ReportDigitalAudioCapabilities.SupportedDigitalFormats.layout(), default=None)
        min_sample_rate: int | None = jd.field("MinSampleRate", jd.Number("I"), default=None)
        max_sample_rate: int | None = jd.field("MaxSampleRate", jd.Number("I"), default=None)
        supported_bit_depths: ReportDigitalAudioCapabilities.SupportedBitDepths | None = jd.field("SupportedBitDepths", lambda: ReportDigitalAudioCapabilities.SupportedBitDepths.layout(), default=None)
        supported_quality_levels: ReportDigitalAudioCapabilities.SupportedQualityLevels | None = jd.field("SupportedQualityLevels", lambda: ReportDigitalAudioCapabilities.SupportedQualityLevels.layout(), default=None)
        reserved_presence: int = 0

    digital_audio_capabilities_list: list[ReportDigitalAudioCapabilities.DigitalAudioCapabilityRec] = jd.field("DigitalAudioCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalAudioCapabilities.DigitalAudioCapabilityRec.layout()))


@jd.message(_SERVICE, 0xDABE, query=True)
class QueryDigitalAudioCapabilities(jd.Message):
    """QueryDigitalAudioCapabilities (0xDABE): Asks what one sensor or all sensors can do.

    sensor_id: Sensor asked about; zero stands for all of them
    """
    REPORT = ReportDigitalAudioCapabilities
    sensor_id: int = jd.field("SensorID", jd.Number("H"))


@jd.message(_SERVICE, 0xDAFE)
class ReportDigitalAudioConfiguration(jd.Message):
    """ReportDigitalAudioConfiguration (0xDAFE): Settings in use of each listed sensor.

    digital_audio_configuration_list: 0..65535 items. One element per sensor
    """

    class DigitalFormat(IntEnum):
        LPCM_PCM = 0
        AIFF = 1
        WAV = 2
        ALAC = 3
        FLAC = 4
        REAL_AUDIO = 5
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
        LESS = 4
        POOR = 5
        WORST = 6

    @jd.record("B")
    class DigitalAudioConfigurationRec(jd.Struct):
        """Digital audio configuration.

        sensor_id: Sensor that the element is about; zero is not allowed
        sensitivity: 0..100, optional. Input sensitivity in percent
        minimum_bit_rate: optional. Lowest bit rate in kbit/s (192 by default); a rate below the maximum allows variable bit rate where supported
        maximum_bit_rate: optional. Highest bit rate in kbit/s (192 by default)
        digital_format: DigitalFormat, optional. Audio coding in use
        sample_rate: optional. Samples taken each second (44100 by default)
        bit_depth: BitDepth, optional. Size of one sample
        encoding_quality: EncodingQuality, optional. Quality step of the encoder
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        sensitivity: float | None = jd.field("Sensitivity", jd.real("H", 0.0, 100.0), default=None)
        minimum_bit_rate: int | None = jd.field("MinimumBitRate", jd.Number("H"), default=None)
        maximum_bit_rate: int | None = jd.field("MaximumBitRate", jd.Number("H"), default=None)
        digital_format: ReportDigitalAudioConfiguration.DigitalFormat | int | None = jd.field("DigitalFormat", lambda: jd.Number("B", jd.Values(ReportDigitalAudioConfiguration.DigitalFormat)), default=None)
        sample_rate: int | None = jd.field("SampleRate", jd.Number("I"), default=None)
        bit_depth: ReportDigitalAudioConfiguration.BitDepth | int | None = jd.field("BitDepth", lambda: jd.Number("B", jd.Values(ReportDigitalAudioConfiguration.BitDepth)), default=None)
        encoding_quality: ReportDigitalAudioConfiguration.EncodingQuality | int | None = jd.field("EncodingQuality", lambda: jd.Number("B", jd.Values(ReportDigitalAudioConfiguration.EncodingQuality)), default=None)
        reserved_presence: int = 0

    digital_audio_configuration_list: list[ReportDigitalAudioConfiguration.DigitalAudioConfigurationRec] = jd.field("DigitalAudioConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalAudioConfiguration.DigitalAudioConfigurationRec.layout()))


@jd.message(_SERVICE, 0xDACE, query=True)
class QueryDigitalAudioConfiguration(jd.Message):
    """QueryDigitalAudioConfiguration (0xDACE): Asks for the settings in use of one sensor or all sensors.

    sensor_id: Sensor asked about; zero stands for all of them
    """
    REPORT = ReportDigitalAudioConfiguration
    sensor_id: int = jd.field("SensorID", jd.Number("H"))


@jd.message(_SERVICE, 0xDAAE, command=True)
class SetDigitalAudioConfiguration(jd.Message):
    """SetDigitalAudioConfiguration (0xDAAE): Changes the settings of one or more sensors.

    digital_audio_configuration_list: 0..65535 items. One element per sensor
    """

    @jd.record()
    class RequestIDRec(jd.Struct):
        """request_id: Number chosen by the client; the response repeats it"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class DigitalFormat(IntEnum):
        LPCM_PCM = 0
        AIFF = 1
        WAV = 2
        ALAC = 3
        FLAC = 4
        REAL_AUDIO = 5
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
        LESS = 4
        POOR = 5
        WORST = 6

    @jd.record("B")
    class DigitalAudioConfigurationRec(jd.Struct):
        """Digital audio configuration.

        sensor_id: Sensor that the element is about; zero is not allowed
        sensitivity: 0..100, optional. Input sensitivity in percent
        minimum_bit_rate: optional. Lowest bit rate in kbit/s (192 by default); a rate below the maximum allows variable bit rate where supported
        maximum_bit_rate: optional. Highest bit rate in kbit/s (192 by default)
        digital_format: DigitalFormat, optional. Audio coding in use
        sample_rate: optional. Samples taken each second (44100 by default)
        bit_depth: BitDepth, optional. Size of one sample
        encoding_quality: EncodingQuality, optional. Quality step of the encoder
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        sensitivity: float | None = jd.field("Sensitivity", jd.real("H", 0.0, 100.0), default=None)
        minimum_bit_rate: int | None = jd.field("MinimumBitRate", jd.Number("H"), default=None)
        maximum_bit_rate: int | None = jd.field("MaximumBitRate", jd.Number("H"), default=None)
        digital_format: SetDigitalAudioConfiguration.DigitalFormat | int | None = jd.field("DigitalFormat", lambda: jd.Number("B", jd.Values(SetDigitalAudioConfiguration.DigitalFormat)), default=None)
        sample_rate: int | None = jd.field("SampleRate", jd.Number("I"), default=None)
        bit_depth: SetDigitalAudioConfiguration.BitDepth | int | None = jd.field("BitDepth", lambda: jd.Number("B", jd.Values(SetDigitalAudioConfiguration.BitDepth)), default=None)
        encoding_quality: SetDigitalAudioConfiguration.EncodingQuality | int | None = jd.field("EncodingQuality", lambda: jd.Number("B", jd.Values(SetDigitalAudioConfiguration.EncodingQuality)), default=None)
        reserved_presence: int = 0

    request_id_rec: SetDigitalAudioConfiguration.RequestIDRec = jd.field("RequestIDRec", lambda: SetDigitalAudioConfiguration.RequestIDRec.layout())
    digital_audio_configuration_list: list[SetDigitalAudioConfiguration.DigitalAudioConfigurationRec] = jd.field("DigitalAudioConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetDigitalAudioConfiguration.DigitalAudioConfigurationRec.layout()))


@jd.message(_SERVICE, 0xDADE)
class SetDigitalAudioConfigurationResponse(jd.Message):
    """SetDigitalAudioConfigurationResponse (0xDADE): Tells whether a set request was carried out.

    request_id: Number that the client gave in its request
    response_code: ResponseCode. Outcome of the request
    """

    class ResponseCode(IntEnum):
        SUCCESS = 0
        ONE_OR_MORE_SENSOR_IDS_NOT_FOUND = 1
        UNSUPPORTED_CONFIGURATION = 2
        OTHER_ERROR = 3

    request_id: int = jd.field("RequestID", jd.Number("B"))
    response_code: SetDigitalAudioConfigurationResponse.ResponseCode | int = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(SetDigitalAudioConfigurationResponse.ResponseCode)))
