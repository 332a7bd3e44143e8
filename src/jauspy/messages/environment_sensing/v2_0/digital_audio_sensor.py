"""urn:jaus:jss:environmentSensing:DigitalAudioSensor 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types
from jauspy.messages.environment_sensing.v2_0 import digital_audio_output as environment_sensing_v2_0_digital_audio_output


@dataclass(slots=True, repr=False)
class SetDigitalAudioSensorConfiguration(rt.Message):
    """SetDigitalAudioSensorConfiguration (0x080F): Sets the configuration of microphones.

    digital_audio_sensor_configuration_list: 0..65535 items. The microphones
    """

    CODE = 0x080F
    NAME = "SetDigitalAudioSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioSensor"
    VERSION = "2.0"
    IS_COMMAND = True
    IS_QUERY = False

    @dataclass(slots=True, repr=False)
    class RequestIdRec(rt.Struct):
        """RequestIdRec.

        request_id: Repeated in the answer, to match it with its request
        """

        request_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("RequestID", rt.Number("B")),
            )

    class DigitalFormat(IntEnum):
        """Values of DigitalFormat."""

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
        """Values of BitDepth."""

        EIGHT_BITS = 0
        TEN_BITS = 1
        TWELVE_BITS = 2
        FOURTEEN_BITS = 3
        SIXTEEN_BITS = 4
        TWENTY_BITS = 5
        TWENTY_FOUR_BITS = 6
        THIRTY_TWO_BITS = 7

    class EncodingQuality(IntEnum):
        """Values of EncodingQuality."""

        BEST = 0
        BETTER = 1
        GOOD = 2
        AVERAGE = 3
        ADEQUATE = 4
        POOR = 5
        WORST = 6

    @dataclass(slots=True, repr=False)
    class DigitalAudioSensorConfigurationRec(rt.Struct):
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

        sensor_id: int
        sensitivity: float | None = None
        minimum_bit_rate: int | None = None
        maximum_bit_rate: int | None = None
        digital_format: SetDigitalAudioSensorConfiguration.DigitalFormat | int | None = None
        sample_rate: int | None = None
        bit_depth: SetDigitalAudioSensorConfiguration.BitDepth | int | None = None
        encoding_quality: SetDigitalAudioSensorConfiguration.EncodingQuality | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("Sensitivity", rt.real("H", 0.0, 100.0), True),
                ("MinimumBitRate", rt.Number("H"), True),
                ("MaximumBitRate", rt.Number("H"), True),
                ("DigitalFormat", rt.Number("B", rt.Values(SetDigitalAudioSensorConfiguration.DigitalFormat)), True),
                ("SampleRate", rt.Number("I"), True),
                ("BitDepth", rt.Number("B", rt.Values(SetDigitalAudioSensorConfiguration.BitDepth)), True),
                ("EncodingQuality", rt.Number("B", rt.Values(SetDigitalAudioSensorConfiguration.EncodingQuality)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetDigitalAudioSensorConfiguration_DigitalAudioSensorConfigurationRec_0[mask & 0x7F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.sensitivity = raw() * 0.0015259021896696422 if mask & 1 else None
            self.minimum_bit_rate = raw() if mask & 2 else None
            self.maximum_bit_rate = raw() if mask & 4 else None
            if mask & 8:
                digital_format_ = raw()
                self.digital_format = _E_SetDigitalAudioSensorConfiguration_DigitalFormat[digital_format_]
            else: self.digital_format = None
            self.sample_rate = raw() if mask & 16 else None
            if mask & 32:
                bit_depth_ = raw()
                self.bit_depth = _E_SetDigitalAudioSensorConfiguration_BitDepth[bit_depth_]
            else: self.bit_depth = None
            if mask & 64:
                encoding_quality_ = raw()
                self.encoding_quality = _E_SetDigitalAudioSensorConfiguration_EncodingQuality[encoding_quality_]
            else: self.encoding_quality = None
            self.reserved_presence = mask & 0x80
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7F: raise rt.Reject
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            sensitivity_ = self.sensitivity
            if sensitivity_ is not None:
                mask |= 1
                if not 0.0 <= sensitivity_ <= 100.0: raise rt.Reject
                near = sensitivity_ * 655.35 + 0.5
                sensitivity_raw_ = int(near)
                if not 1.52587890625e-05 < near - sensitivity_raw_ < 0.9999847412109375: sensitivity_raw_ = rt.exact_raw(sensitivity_, _R_4)
                raw.append(sensitivity_raw_)
            minimum_bit_rate_ = self.minimum_bit_rate
            if minimum_bit_rate_ is not None:
                mask |= 2
                raw.append(minimum_bit_rate_)
            maximum_bit_rate_ = self.maximum_bit_rate
            if maximum_bit_rate_ is not None:
                mask |= 4
                raw.append(maximum_bit_rate_)
            digital_format_ = self.digital_format
            if digital_format_ is not None:
                mask |= 8
                if digital_format_ not in _E_SetDigitalAudioSensorConfiguration_DigitalFormat: raise rt.Reject
                raw.append(digital_format_)
            sample_rate_ = self.sample_rate
            if sample_rate_ is not None:
                mask |= 16
                raw.append(sample_rate_)
            bit_depth_ = self.bit_depth
            if bit_depth_ is not None:
                mask |= 32
                if bit_depth_ not in _E_SetDigitalAudioSensorConfiguration_BitDepth: raise rt.Reject
                raw.append(bit_depth_)
            encoding_quality_ = self.encoding_quality
            if encoding_quality_ is not None:
                mask |= 64
                if encoding_quality_ not in _E_SetDigitalAudioSensorConfiguration_EncodingQuality: raise rt.Reject
                raw.append(encoding_quality_)
            out += _M_SetDigitalAudioSensorConfiguration_DigitalAudioSensorConfigurationRec_0[mask & 0x7F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    request_id_rec: SetDigitalAudioSensorConfiguration.RequestIdRec
    digital_audio_sensor_configuration_list: list[SetDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", SetDigitalAudioSensorConfiguration.RequestIdRec.layout()),
            ("DigitalAudioSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), SetDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0F or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetDigitalAudioSensorConfiguration.RequestIdRec(request_id_)
        (digital_audio_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 3)
        if digital_audio_sensor_configuration_list_count_ * 3 > size - 5: raise rt.Reject
        at = 5
        digital_audio_sensor_configuration_list_ = []
        for _ in range(digital_audio_sensor_configuration_list_count_):
            item_, at = SetDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec._read(data, at, nesting)
            digital_audio_sensor_configuration_list_.append(item_)
        self.digital_audio_sensor_configuration_list = digital_audio_sensor_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0f\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetDigitalAudioSensorConfiguration.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        digital_audio_sensor_configuration_list_ = self.digital_audio_sensor_configuration_list
        if type(digital_audio_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_audio_sensor_configuration_list_))
        for item_ in digital_audio_sensor_configuration_list_:
            if type(item_) is not SetDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryDigitalAudioSensorCapabilities(rt.Message):
    """QueryDigitalAudioSensorCapabilities (0x2817): Asks what microphones can do.

    sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
    """

    CODE = 0x2817
    NAME = "QueryDigitalAudioSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDigitalAudioSensorCapabilities]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    sensor_id: QueryDigitalAudioSensorCapabilities.SensorID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(QueryDigitalAudioSensorCapabilities.SensorID, ((1, 65535),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, sensor_id_ = _S_2H.unpack(data)
        if code != 0x2817: raise rt.Reject
        self.sensor_id = _E_QueryDigitalAudioSensorCapabilities_SensorID.get(sensor_id_, sensor_id_)
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2817, self.sensor_id)


@dataclass(slots=True, repr=False)
class QueryDigitalAudioSensorConfiguration(rt.Message):
    """QueryDigitalAudioSensorConfiguration (0x280F): Asks for the configuration of microphones.

    sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
    """

    CODE = 0x280F
    NAME = "QueryDigitalAudioSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDigitalAudioSensorConfiguration]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    sensor_id: QueryDigitalAudioSensorConfiguration.SensorID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(QueryDigitalAudioSensorConfiguration.SensorID, ((1, 65535),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, sensor_id_ = _S_2H.unpack(data)
        if code != 0x280F: raise rt.Reject
        self.sensor_id = _E_QueryDigitalAudioSensorConfiguration_SensorID.get(sensor_id_, sensor_id_)
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x280F, self.sensor_id)


class ConfirmSensorConfiguration(environment_sensing_v2_0_digital_audio_output.ConfirmSensorConfiguration):
    """ConfirmSensorConfiguration (0x0801): Tells for each sensor whether its new configuration was taken over, and
    if not, why.
    """

    __slots__ = ()
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioSensor"
    VERSION = "2.0"


@dataclass(slots=True, repr=False)
class ReportDigitalAudioSensorCapabilities(rt.Message):
    """ReportDigitalAudioSensorCapabilities (0x4817): Tells what microphones can do.

    digital_audio_sensor_capabilities_list: 0..65535 items. The microphones
    """

    CODE = 0x4817
    NAME = "ReportDigitalAudioSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    SupportedAudioFormats = environment_sensing_v1_0_types.SupportedAudioFormats
    SupportedBitDepths = environment_sensing_v1_0_types.SupportedBitDepths

    class Best(IntEnum):
        """Values of Best."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Better(IntEnum):
        """Values of Better."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Good(IntEnum):
        """Values of Good."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Average(IntEnum):
        """Values of Average."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Adequate(IntEnum):
        """Values of Adequate."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Poor(IntEnum):
        """Values of Poor."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Worst(IntEnum):
        """Values of Worst."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class SupportedQualityLevels(rt.Struct):
        """Qualities of coding that can be had.

        best: bit 0. Highest quality.
        better: bit 1. Second best quality.
        good: bit 2. Third best quality.
        average: bit 3. Middle quality.
        adequate: bit 4. Third worst quality.
        poor: bit 5. Second worst quality.
        worst: bit 6. Lowest quality.
        """

        best: ReportDigitalAudioSensorCapabilities.Best | int
        better: ReportDigitalAudioSensorCapabilities.Better | int
        good: ReportDigitalAudioSensorCapabilities.Good | int
        average: ReportDigitalAudioSensorCapabilities.Average | int
        adequate: ReportDigitalAudioSensorCapabilities.Adequate | int
        poor: ReportDigitalAudioSensorCapabilities.Poor | int
        worst: ReportDigitalAudioSensorCapabilities.Worst | int
        reserved_bits: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "B",
                (
                    rt.Bit("best", 0, 0x1, rt.Values(ReportDigitalAudioSensorCapabilities.Best)),
                    rt.Bit("better", 1, 0x1, rt.Values(ReportDigitalAudioSensorCapabilities.Better)),
                    rt.Bit("good", 2, 0x1, rt.Values(ReportDigitalAudioSensorCapabilities.Good)),
                    rt.Bit("average", 3, 0x1, rt.Values(ReportDigitalAudioSensorCapabilities.Average)),
                    rt.Bit("adequate", 4, 0x1, rt.Values(ReportDigitalAudioSensorCapabilities.Adequate)),
                    rt.Bit("poor", 5, 0x1, rt.Values(ReportDigitalAudioSensorCapabilities.Poor)),
                    rt.Bit("worst", 6, 0x1, rt.Values(ReportDigitalAudioSensorCapabilities.Worst)),
                ),
            )

    @dataclass(slots=True, repr=False)
    class DigitalAudioSensorCapabilitiesRec(rt.Struct):
        """DigitalAudioSensorCapabilitiesRec.

        sensor_id: 1..65535. Identifies the sensor
        minimum_allowed_bit_rate: optional. Smallest bit rate that can be set, in kilobits per second
        maximum_allowed_bit_rate: optional. Largest bit rate that can be set, in kilobits per second
        supported_digital_formats: optional. Codings of audio that the microphone offers
        min_sample_rate: optional. Smallest number of samples per second
        max_sample_rate: optional. Largest number of samples per second
        supported_bit_depths: optional. Bits per sample that can be had
        supported_quality_levels: optional. Qualities of coding that can be had
        """

        sensor_id: int
        minimum_allowed_bit_rate: int | None = None
        maximum_allowed_bit_rate: int | None = None
        supported_digital_formats: environment_sensing_v1_0_types.SupportedAudioFormats | None = None
        min_sample_rate: int | None = None
        max_sample_rate: int | None = None
        supported_bit_depths: environment_sensing_v1_0_types.SupportedBitDepths | None = None
        supported_quality_levels: ReportDigitalAudioSensorCapabilities.SupportedQualityLevels | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("MinimumAllowedBitRate", rt.Number("H"), True),
                ("MaximumAllowedBitRate", rt.Number("H"), True),
                ("SupportedDigitalFormats", environment_sensing_v1_0_types.SupportedAudioFormats.layout(), True),
                ("MinSampleRate", rt.Number("I"), True),
                ("MaxSampleRate", rt.Number("I"), True),
                ("SupportedBitDepths", environment_sensing_v1_0_types.SupportedBitDepths.layout(), True),
                ("SupportedQualityLevels", ReportDigitalAudioSensorCapabilities.SupportedQualityLevels.layout(), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportDigitalAudioSensorCapabilities_DigitalAudioSensorCapabilitiesRec_0[mask & 0x7F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.minimum_allowed_bit_rate = raw() if mask & 1 else None
            self.maximum_allowed_bit_rate = raw() if mask & 2 else None
            if mask & 4:
                supported_digital_formats_ = raw()
                self.supported_digital_formats = environment_sensing_v1_0_types.SupportedAudioFormats(_E_SupportedAudioFormats_LPCM_PCM.get(supported_digital_formats_ & 0x1, supported_digital_formats_ & 0x1), _E_SupportedAudioFormats_AIFF.get(supported_digital_formats_ >> 1 & 0x1, supported_digital_formats_ >> 1 & 0x1), _E_SupportedAudioFormats_WAV.get(supported_digital_formats_ >> 2 & 0x1, supported_digital_formats_ >> 2 & 0x1), _E_SupportedAudioFormats_ALAC.get(supported_digital_formats_ >> 3 & 0x1, supported_digital_formats_ >> 3 & 0x1), _E_SupportedAudioFormats_FLAC.get(supported_digital_formats_ >> 4 & 0x1, supported_digital_formats_ >> 4 & 0x1), _E_SupportedAudioFormats_RealAudio.get(supported_digital_formats_ >> 5 & 0x1, supported_digital_formats_ >> 5 & 0x1), _E_SupportedAudioFormats_WMA9_Lossless.get(supported_digital_formats_ >> 6 & 0x1, supported_digital_formats_ >> 6 & 0x1), _E_SupportedAudioFormats_TrueAudio.get(supported_digital_formats_ >> 7 & 0x1, supported_digital_formats_ >> 7 & 0x1), _E_SupportedAudioFormats_DolbyDigital.get(supported_digital_formats_ >> 8 & 0x1, supported_digital_formats_ >> 8 & 0x1), _E_SupportedAudioFormats_DTS.get(supported_digital_formats_ >> 9 & 0x1, supported_digital_formats_ >> 9 & 0x1), _E_SupportedAudioFormats_MP2.get(supported_digital_formats_ >> 10 & 0x1, supported_digital_formats_ >> 10 & 0x1), _E_SupportedAudioFormats_MP3.get(supported_digital_formats_ >> 11 & 0x1, supported_digital_formats_ >> 11 & 0x1), _E_SupportedAudioFormats_AAC_MPEG2.get(supported_digital_formats_ >> 12 & 0x1, supported_digital_formats_ >> 12 & 0x1), _E_SupportedAudioFormats_AAC_MPEG4.get(supported_digital_formats_ >> 13 & 0x1, supported_digital_formats_ >> 13 & 0x1), _E_SupportedAudioFormats_VORBIS.get(supported_digital_formats_ >> 14 & 0x1, supported_digital_formats_ >> 14 & 0x1), _E_SupportedAudioFormats_WMA.get(supported_digital_formats_ >> 15 & 0x1, supported_digital_formats_ >> 15 & 0x1), _E_SupportedAudioFormats_Speex.get(supported_digital_formats_ >> 16 & 0x1, supported_digital_formats_ >> 16 & 0x1), supported_digital_formats_ & 0xFFFE0000)
            else: self.supported_digital_formats = None
            self.min_sample_rate = raw() if mask & 8 else None
            self.max_sample_rate = raw() if mask & 16 else None
            if mask & 32:
                supported_bit_depths_ = raw()
                self.supported_bit_depths = environment_sensing_v1_0_types.SupportedBitDepths(_E_SupportedBitDepths_EIGHT_BITS.get(supported_bit_depths_ & 0x1, supported_bit_depths_ & 0x1), _E_SupportedBitDepths_TEN_BITS.get(supported_bit_depths_ >> 1 & 0x1, supported_bit_depths_ >> 1 & 0x1), _E_SupportedBitDepths_TWELVE_BITS.get(supported_bit_depths_ >> 2 & 0x1, supported_bit_depths_ >> 2 & 0x1), _E_SupportedBitDepths_FOURTEEN_BITS.get(supported_bit_depths_ >> 3 & 0x1, supported_bit_depths_ >> 3 & 0x1), _E_SupportedBitDepths_SIXTEEN_BITS.get(supported_bit_depths_ >> 4 & 0x1, supported_bit_depths_ >> 4 & 0x1), _E_SupportedBitDepths_TWENTY_BITS.get(supported_bit_depths_ >> 5 & 0x1, supported_bit_depths_ >> 5 & 0x1), _E_SupportedBitDepths_TWENTY_FOUR_BITS.get(supported_bit_depths_ >> 6 & 0x1, supported_bit_depths_ >> 6 & 0x1), _E_SupportedBitDepths_THIRTY_TWO_BITS.get(supported_bit_depths_ >> 7 & 0x1, supported_bit_depths_ >> 7 & 0x1), supported_bit_depths_ & 0xFF00)
            else: self.supported_bit_depths = None
            if mask & 64:
                supported_quality_levels_ = raw()
                self.supported_quality_levels = ReportDigitalAudioSensorCapabilities.SupportedQualityLevels(_E_ReportDigitalAudioSensorCapabilities_Best.get(supported_quality_levels_ & 0x1, supported_quality_levels_ & 0x1), _E_ReportDigitalAudioSensorCapabilities_Better.get(supported_quality_levels_ >> 1 & 0x1, supported_quality_levels_ >> 1 & 0x1), _E_ReportDigitalAudioSensorCapabilities_Good.get(supported_quality_levels_ >> 2 & 0x1, supported_quality_levels_ >> 2 & 0x1), _E_ReportDigitalAudioSensorCapabilities_Average.get(supported_quality_levels_ >> 3 & 0x1, supported_quality_levels_ >> 3 & 0x1), _E_ReportDigitalAudioSensorCapabilities_Adequate.get(supported_quality_levels_ >> 4 & 0x1, supported_quality_levels_ >> 4 & 0x1), _E_ReportDigitalAudioSensorCapabilities_Poor.get(supported_quality_levels_ >> 5 & 0x1, supported_quality_levels_ >> 5 & 0x1), _E_ReportDigitalAudioSensorCapabilities_Worst.get(supported_quality_levels_ >> 6 & 0x1, supported_quality_levels_ >> 6 & 0x1), supported_quality_levels_ & 0x80)
            else: self.supported_quality_levels = None
            self.reserved_presence = mask & 0x80
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7F: raise rt.Reject
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            minimum_allowed_bit_rate_ = self.minimum_allowed_bit_rate
            if minimum_allowed_bit_rate_ is not None:
                mask |= 1
                raw.append(minimum_allowed_bit_rate_)
            maximum_allowed_bit_rate_ = self.maximum_allowed_bit_rate
            if maximum_allowed_bit_rate_ is not None:
                mask |= 2
                raw.append(maximum_allowed_bit_rate_)
            supported_digital_formats_ = self.supported_digital_formats
            if supported_digital_formats_ is not None:
                mask |= 4
                if type(supported_digital_formats_) is not environment_sensing_v1_0_types.SupportedAudioFormats: raise rt.Reject
                lpcm_pcm_ = supported_digital_formats_.lpcm_pcm
                if not 0 <= lpcm_pcm_ <= 1: raise rt.Reject
                aiff_ = supported_digital_formats_.aiff
                if not 0 <= aiff_ <= 1: raise rt.Reject
                wav_ = supported_digital_formats_.wav
                if not 0 <= wav_ <= 1: raise rt.Reject
                alac_ = supported_digital_formats_.alac
                if not 0 <= alac_ <= 1: raise rt.Reject
                flac_ = supported_digital_formats_.flac
                if not 0 <= flac_ <= 1: raise rt.Reject
                real_audio_ = supported_digital_formats_.real_audio
                if not 0 <= real_audio_ <= 1: raise rt.Reject
                wma9_lossless_ = supported_digital_formats_.wma9_lossless
                if not 0 <= wma9_lossless_ <= 1: raise rt.Reject
                true_audio_ = supported_digital_formats_.true_audio
                if not 0 <= true_audio_ <= 1: raise rt.Reject
                dolby_digital_ = supported_digital_formats_.dolby_digital
                if not 0 <= dolby_digital_ <= 1: raise rt.Reject
                dts_ = supported_digital_formats_.dts
                if not 0 <= dts_ <= 1: raise rt.Reject
                mp2_ = supported_digital_formats_.mp2
                if not 0 <= mp2_ <= 1: raise rt.Reject
                mp3_ = supported_digital_formats_.mp3
                if not 0 <= mp3_ <= 1: raise rt.Reject
                aac_mpeg2_ = supported_digital_formats_.aac_mpeg2
                if not 0 <= aac_mpeg2_ <= 1: raise rt.Reject
                aac_mpeg4_ = supported_digital_formats_.aac_mpeg4
                if not 0 <= aac_mpeg4_ <= 1: raise rt.Reject
                vorbis_ = supported_digital_formats_.vorbis
                if not 0 <= vorbis_ <= 1: raise rt.Reject
                wma_ = supported_digital_formats_.wma
                if not 0 <= wma_ <= 1: raise rt.Reject
                speex_ = supported_digital_formats_.speex
                if not 0 <= speex_ <= 1: raise rt.Reject
                reserved_bits_ = supported_digital_formats_.reserved_bits
                if reserved_bits_ & 0x1FFFF: raise rt.Reject
                raw.append(lpcm_pcm_ | aiff_ << 1 | wav_ << 2 | alac_ << 3 | flac_ << 4 | real_audio_ << 5 | wma9_lossless_ << 6 | true_audio_ << 7 | dolby_digital_ << 8 | dts_ << 9 | mp2_ << 10 | mp3_ << 11 | aac_mpeg2_ << 12 | aac_mpeg4_ << 13 | vorbis_ << 14 | wma_ << 15 | speex_ << 16 | reserved_bits_)
            min_sample_rate_ = self.min_sample_rate
            if min_sample_rate_ is not None:
                mask |= 8
                raw.append(min_sample_rate_)
            max_sample_rate_ = self.max_sample_rate
            if max_sample_rate_ is not None:
                mask |= 16
                raw.append(max_sample_rate_)
            supported_bit_depths_ = self.supported_bit_depths
            if supported_bit_depths_ is not None:
                mask |= 32
                if type(supported_bit_depths_) is not environment_sensing_v1_0_types.SupportedBitDepths: raise rt.Reject
                eight_bits_ = supported_bit_depths_.eight_bits
                if not 0 <= eight_bits_ <= 1: raise rt.Reject
                ten_bits_ = supported_bit_depths_.ten_bits
                if not 0 <= ten_bits_ <= 1: raise rt.Reject
                twelve_bits_ = supported_bit_depths_.twelve_bits
                if not 0 <= twelve_bits_ <= 1: raise rt.Reject
                fourteen_bits_ = supported_bit_depths_.fourteen_bits
                if not 0 <= fourteen_bits_ <= 1: raise rt.Reject
                sixteen_bits_ = supported_bit_depths_.sixteen_bits
                if not 0 <= sixteen_bits_ <= 1: raise rt.Reject
                twenty_bits_ = supported_bit_depths_.twenty_bits
                if not 0 <= twenty_bits_ <= 1: raise rt.Reject
                twenty_four_bits_ = supported_bit_depths_.twenty_four_bits
                if not 0 <= twenty_four_bits_ <= 1: raise rt.Reject
                thirty_two_bits_ = supported_bit_depths_.thirty_two_bits
                if not 0 <= thirty_two_bits_ <= 1: raise rt.Reject
                reserved_bits_2_ = supported_bit_depths_.reserved_bits
                if reserved_bits_2_ & 0xFF: raise rt.Reject
                raw.append(eight_bits_ | ten_bits_ << 1 | twelve_bits_ << 2 | fourteen_bits_ << 3 | sixteen_bits_ << 4 | twenty_bits_ << 5 | twenty_four_bits_ << 6 | thirty_two_bits_ << 7 | reserved_bits_2_)
            supported_quality_levels_ = self.supported_quality_levels
            if supported_quality_levels_ is not None:
                mask |= 64
                if type(supported_quality_levels_) is not ReportDigitalAudioSensorCapabilities.SupportedQualityLevels: raise rt.Reject
                best_ = supported_quality_levels_.best
                if not 0 <= best_ <= 1: raise rt.Reject
                better_ = supported_quality_levels_.better
                if not 0 <= better_ <= 1: raise rt.Reject
                good_ = supported_quality_levels_.good
                if not 0 <= good_ <= 1: raise rt.Reject
                average_ = supported_quality_levels_.average
                if not 0 <= average_ <= 1: raise rt.Reject
                adequate_ = supported_quality_levels_.adequate
                if not 0 <= adequate_ <= 1: raise rt.Reject
                poor_ = supported_quality_levels_.poor
                if not 0 <= poor_ <= 1: raise rt.Reject
                worst_ = supported_quality_levels_.worst
                if not 0 <= worst_ <= 1: raise rt.Reject
                reserved_bits_3_ = supported_quality_levels_.reserved_bits
                if reserved_bits_3_ & 0x7F: raise rt.Reject
                raw.append(best_ | better_ << 1 | good_ << 2 | average_ << 3 | adequate_ << 4 | poor_ << 5 | worst_ << 6 | reserved_bits_3_)
            out += _M_ReportDigitalAudioSensorCapabilities_DigitalAudioSensorCapabilitiesRec_0[mask & 0x7F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    digital_audio_sensor_capabilities_list: list[ReportDigitalAudioSensorCapabilities.DigitalAudioSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DigitalAudioSensorCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), ReportDigitalAudioSensorCapabilities.DigitalAudioSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x17 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (digital_audio_sensor_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        if digital_audio_sensor_capabilities_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        digital_audio_sensor_capabilities_list_ = []
        for _ in range(digital_audio_sensor_capabilities_list_count_):
            item_, at = ReportDigitalAudioSensorCapabilities.DigitalAudioSensorCapabilitiesRec._read(data, at, nesting)
            digital_audio_sensor_capabilities_list_.append(item_)
        self.digital_audio_sensor_capabilities_list = digital_audio_sensor_capabilities_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x17\x48")
        digital_audio_sensor_capabilities_list_ = self.digital_audio_sensor_capabilities_list
        if type(digital_audio_sensor_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_audio_sensor_capabilities_list_))
        for item_ in digital_audio_sensor_capabilities_list_:
            if type(item_) is not ReportDigitalAudioSensorCapabilities.DigitalAudioSensorCapabilitiesRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportDigitalAudioSensorConfiguration(rt.Message):
    """ReportDigitalAudioSensorConfiguration (0x480F): Tells the configuration of microphones.

    digital_audio_sensor_configuration_list: 0..65535 items. The microphones
    """

    CODE = 0x480F
    NAME = "ReportDigitalAudioSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioSensor"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class DigitalFormat(IntEnum):
        """Values of DigitalFormat."""

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
        """Values of BitDepth."""

        EIGHT_BITS = 0
        TEN_BITS = 1
        TWELVE_BITS = 2
        FOURTEEN_BITS = 3
        SIXTEEN_BITS = 4
        TWENTY_BITS = 5
        TWENTY_FOUR_BITS = 6
        THIRTY_TWO_BITS = 7

    class EncodingQuality(IntEnum):
        """Values of EncodingQuality."""

        BEST = 0
        BETTER = 1
        GOOD = 2
        AVERAGE = 3
        ADEQUATE = 4
        POOR = 5
        WORST = 6

    @dataclass(slots=True, repr=False)
    class DigitalAudioSensorConfigurationRec(rt.Struct):
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

        sensor_id: int
        sensitivity: float | None = None
        minimum_bit_rate: int | None = None
        maximum_bit_rate: int | None = None
        digital_format: ReportDigitalAudioSensorConfiguration.DigitalFormat | int | None = None
        sample_rate: int | None = None
        bit_depth: ReportDigitalAudioSensorConfiguration.BitDepth | int | None = None
        encoding_quality: ReportDigitalAudioSensorConfiguration.EncodingQuality | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("Sensitivity", rt.real("H", 0.0, 100.0), True),
                ("MinimumBitRate", rt.Number("H"), True),
                ("MaximumBitRate", rt.Number("H"), True),
                ("DigitalFormat", rt.Number("B", rt.Values(ReportDigitalAudioSensorConfiguration.DigitalFormat)), True),
                ("SampleRate", rt.Number("I"), True),
                ("BitDepth", rt.Number("B", rt.Values(ReportDigitalAudioSensorConfiguration.BitDepth)), True),
                ("EncodingQuality", rt.Number("B", rt.Values(ReportDigitalAudioSensorConfiguration.EncodingQuality)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetDigitalAudioSensorConfiguration_DigitalAudioSensorConfigurationRec_0[mask & 0x7F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.sensitivity = raw() * 0.0015259021896696422 if mask & 1 else None
            self.minimum_bit_rate = raw() if mask & 2 else None
            self.maximum_bit_rate = raw() if mask & 4 else None
            if mask & 8:
                digital_format_ = raw()
                self.digital_format = _E_ReportDigitalAudioSensorConfiguration_DigitalFormat[digital_format_]
            else: self.digital_format = None
            self.sample_rate = raw() if mask & 16 else None
            if mask & 32:
                bit_depth_ = raw()
                self.bit_depth = _E_ReportDigitalAudioSensorConfiguration_BitDepth[bit_depth_]
            else: self.bit_depth = None
            if mask & 64:
                encoding_quality_ = raw()
                self.encoding_quality = _E_ReportDigitalAudioSensorConfiguration_EncodingQuality[encoding_quality_]
            else: self.encoding_quality = None
            self.reserved_presence = mask & 0x80
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7F: raise rt.Reject
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            sensitivity_ = self.sensitivity
            if sensitivity_ is not None:
                mask |= 1
                if not 0.0 <= sensitivity_ <= 100.0: raise rt.Reject
                near = sensitivity_ * 655.35 + 0.5
                sensitivity_raw_ = int(near)
                if not 1.52587890625e-05 < near - sensitivity_raw_ < 0.9999847412109375: sensitivity_raw_ = rt.exact_raw(sensitivity_, _R_4)
                raw.append(sensitivity_raw_)
            minimum_bit_rate_ = self.minimum_bit_rate
            if minimum_bit_rate_ is not None:
                mask |= 2
                raw.append(minimum_bit_rate_)
            maximum_bit_rate_ = self.maximum_bit_rate
            if maximum_bit_rate_ is not None:
                mask |= 4
                raw.append(maximum_bit_rate_)
            digital_format_ = self.digital_format
            if digital_format_ is not None:
                mask |= 8
                if digital_format_ not in _E_ReportDigitalAudioSensorConfiguration_DigitalFormat: raise rt.Reject
                raw.append(digital_format_)
            sample_rate_ = self.sample_rate
            if sample_rate_ is not None:
                mask |= 16
                raw.append(sample_rate_)
            bit_depth_ = self.bit_depth
            if bit_depth_ is not None:
                mask |= 32
                if bit_depth_ not in _E_ReportDigitalAudioSensorConfiguration_BitDepth: raise rt.Reject
                raw.append(bit_depth_)
            encoding_quality_ = self.encoding_quality
            if encoding_quality_ is not None:
                mask |= 64
                if encoding_quality_ not in _E_ReportDigitalAudioSensorConfiguration_EncodingQuality: raise rt.Reject
                raw.append(encoding_quality_)
            out += _M_SetDigitalAudioSensorConfiguration_DigitalAudioSensorConfigurationRec_0[mask & 0x7F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    digital_audio_sensor_configuration_list: list[ReportDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DigitalAudioSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), ReportDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0F or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (digital_audio_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        if digital_audio_sensor_configuration_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        digital_audio_sensor_configuration_list_ = []
        for _ in range(digital_audio_sensor_configuration_list_count_):
            item_, at = ReportDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec._read(data, at, nesting)
            digital_audio_sensor_configuration_list_.append(item_)
        self.digital_audio_sensor_configuration_list = digital_audio_sensor_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0f\x48")
        digital_audio_sensor_configuration_list_ = self.digital_audio_sensor_configuration_list
        if type(digital_audio_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_audio_sensor_configuration_list_))
        for item_ in digital_audio_sensor_configuration_list_:
            if type(item_) is not ReportDigitalAudioSensorConfiguration.DigitalAudioSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


_M_SetDigitalAudioSensorConfiguration_DigitalAudioSensorConfigurationRec_0 = rt.Masks("", ((0, "H"), (1, "H"), (2, "H"), (4, "H"), (8, "B"), (16, "I"), (32, "B"), (64, "B")))
_E_SetDigitalAudioSensorConfiguration_DigitalFormat = rt.members(SetDigitalAudioSensorConfiguration.DigitalFormat)
_E_SetDigitalAudioSensorConfiguration_BitDepth = rt.members(SetDigitalAudioSensorConfiguration.BitDepth)
_E_SetDigitalAudioSensorConfiguration_EncodingQuality = rt.members(SetDigitalAudioSensorConfiguration.EncodingQuality)
_R_4 = rt.Scaling(0.0, 100.0, 65535)
_S_B = rt.Packer("<B")
_S_H = rt.Packer("<H")
_E_QueryDigitalAudioSensorCapabilities_SensorID = rt.members(QueryDigitalAudioSensorCapabilities.SensorID)
_S_2H = rt.Packer("<2H")
_E_QueryDigitalAudioSensorConfiguration_SensorID = rt.members(QueryDigitalAudioSensorConfiguration.SensorID)
_M_ReportDigitalAudioSensorCapabilities_DigitalAudioSensorCapabilitiesRec_0 = rt.Masks("", ((0, "H"), (1, "H"), (2, "H"), (4, "I"), (8, "I"), (16, "I"), (32, "H"), (64, "B")))
_E_SupportedAudioFormats_LPCM_PCM = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.LPCM_PCM)
_E_SupportedAudioFormats_AIFF = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.AIFF)
_E_SupportedAudioFormats_WAV = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.WAV)
_E_SupportedAudioFormats_ALAC = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.ALAC)
_E_SupportedAudioFormats_FLAC = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.FLAC)
_E_SupportedAudioFormats_RealAudio = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.RealAudio)
_E_SupportedAudioFormats_WMA9_Lossless = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.WMA9_Lossless)
_E_SupportedAudioFormats_TrueAudio = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.TrueAudio)
_E_SupportedAudioFormats_DolbyDigital = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.DolbyDigital)
_E_SupportedAudioFormats_DTS = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.DTS)
_E_SupportedAudioFormats_MP2 = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.MP2)
_E_SupportedAudioFormats_MP3 = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.MP3)
_E_SupportedAudioFormats_AAC_MPEG2 = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.AAC_MPEG2)
_E_SupportedAudioFormats_AAC_MPEG4 = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.AAC_MPEG4)
_E_SupportedAudioFormats_VORBIS = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.VORBIS)
_E_SupportedAudioFormats_WMA = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.WMA)
_E_SupportedAudioFormats_Speex = rt.members(environment_sensing_v1_0_types.SupportedAudioFormats.Speex)
_E_SupportedBitDepths_EIGHT_BITS = rt.members(environment_sensing_v1_0_types.SupportedBitDepths.EIGHT_BITS)
_E_SupportedBitDepths_TEN_BITS = rt.members(environment_sensing_v1_0_types.SupportedBitDepths.TEN_BITS)
_E_SupportedBitDepths_TWELVE_BITS = rt.members(environment_sensing_v1_0_types.SupportedBitDepths.TWELVE_BITS)
_E_SupportedBitDepths_FOURTEEN_BITS = rt.members(environment_sensing_v1_0_types.SupportedBitDepths.FOURTEEN_BITS)
_E_SupportedBitDepths_SIXTEEN_BITS = rt.members(environment_sensing_v1_0_types.SupportedBitDepths.SIXTEEN_BITS)
_E_SupportedBitDepths_TWENTY_BITS = rt.members(environment_sensing_v1_0_types.SupportedBitDepths.TWENTY_BITS)
_E_SupportedBitDepths_TWENTY_FOUR_BITS = rt.members(environment_sensing_v1_0_types.SupportedBitDepths.TWENTY_FOUR_BITS)
_E_SupportedBitDepths_THIRTY_TWO_BITS = rt.members(environment_sensing_v1_0_types.SupportedBitDepths.THIRTY_TWO_BITS)
_E_ReportDigitalAudioSensorCapabilities_Best = rt.members(ReportDigitalAudioSensorCapabilities.Best)
_E_ReportDigitalAudioSensorCapabilities_Better = rt.members(ReportDigitalAudioSensorCapabilities.Better)
_E_ReportDigitalAudioSensorCapabilities_Good = rt.members(ReportDigitalAudioSensorCapabilities.Good)
_E_ReportDigitalAudioSensorCapabilities_Average = rt.members(ReportDigitalAudioSensorCapabilities.Average)
_E_ReportDigitalAudioSensorCapabilities_Adequate = rt.members(ReportDigitalAudioSensorCapabilities.Adequate)
_E_ReportDigitalAudioSensorCapabilities_Poor = rt.members(ReportDigitalAudioSensorCapabilities.Poor)
_E_ReportDigitalAudioSensorCapabilities_Worst = rt.members(ReportDigitalAudioSensorCapabilities.Worst)
_E_ReportDigitalAudioSensorConfiguration_DigitalFormat = rt.members(ReportDigitalAudioSensorConfiguration.DigitalFormat)
_E_ReportDigitalAudioSensorConfiguration_BitDepth = rt.members(ReportDigitalAudioSensorConfiguration.BitDepth)
_E_ReportDigitalAudioSensorConfiguration_EncodingQuality = rt.members(ReportDigitalAudioSensorConfiguration.EncodingQuality)
QueryDigitalAudioSensorCapabilities.REPORT = ReportDigitalAudioSensorCapabilities
QueryDigitalAudioSensorConfiguration.REPORT = ReportDigitalAudioSensorConfiguration
