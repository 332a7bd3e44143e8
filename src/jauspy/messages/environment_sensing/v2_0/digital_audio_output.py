"""urn:jaus:jss:environmentSensing:DigitalAudioOutput 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types


@dataclass(slots=True, repr=False)
class SetDigitalAudioOutputSource(rt.Message):
    """SetDigitalAudioOutputSource (0x0818): Sets the streams to play, and how loud.

    digital_audio_output_source_list: 0..65535 items. The outputs
    """

    CODE = 0x0818
    NAME = "SetDigitalAudioOutputSource"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioOutput"
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

    class Repeat(IntEnum):
        """Values of Repeat."""

        PLAY_ONCE = 0
        REPEAT = 1

    @dataclass(slots=True, repr=False)
    class DigitalAudioOutputSourceRec(rt.Struct):
        """What one output plays.

        sensor_id: 1..65535. Identifies the sensor
        stream_url: up to 255 characters. Where to fetch the stream
        repeat: Repeat. What to do at the end of the stream
        volume: 0..100 percent. Loudness, in percent
        """

        sensor_id: int
        stream_url: str
        repeat: SetDigitalAudioOutputSource.Repeat | int
        volume: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("StreamURL", rt.Text(count=rt.Count("B", 0, 255))),
                ("Repeat", rt.Number("B", rt.Values(SetDigitalAudioOutputSource.Repeat))),
                ("Volume", rt.real("H", 0.0, 100.0, "percent")),
            )

    request_id_rec: SetDigitalAudioOutputSource.RequestIdRec
    digital_audio_output_source_list: list[SetDigitalAudioOutputSource.DigitalAudioOutputSourceRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", SetDigitalAudioOutputSource.RequestIdRec.layout()),
            ("DigitalAudioOutputSourceList", rt.Repeat(rt.Count("H", 0, 65535), SetDigitalAudioOutputSource.DigitalAudioOutputSourceRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x18 or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetDigitalAudioOutputSource.RequestIdRec(request_id_)
        (digital_audio_output_source_list_count_,) = _S_H.unpack_from(data, 3)
        if digital_audio_output_source_list_count_ * 6 > size - 5: raise rt.Reject
        at = 5
        digital_audio_output_source_list_ = []
        for _ in range(digital_audio_output_source_list_count_):
            item_ = rt.new(SetDigitalAudioOutputSource.DigitalAudioOutputSourceRec)
            (sensor_id_,) = _S_H.unpack_from(data, at)
            if sensor_id_ < 1: raise rt.Reject
            item_.sensor_id = sensor_id_
            stream_url_end_ = at + 3 + data[at + 2]
            item_.stream_url = data[at + 3:stream_url_end_].decode("latin-1")
            repeat_, volume_ = _S_BH.unpack_from(data, stream_url_end_)
            item_.repeat = _E_SetDigitalAudioOutputSource_Repeat[repeat_]
            item_.volume = volume_ * 0.0015259021896696422
            at = stream_url_end_ + 3
            digital_audio_output_source_list_.append(item_)
        self.digital_audio_output_source_list = digital_audio_output_source_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x18\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetDigitalAudioOutputSource.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        digital_audio_output_source_list_ = self.digital_audio_output_source_list
        if type(digital_audio_output_source_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_audio_output_source_list_))
        for item_ in digital_audio_output_source_list_:
            if type(item_) is not SetDigitalAudioOutputSource.DigitalAudioOutputSourceRec: raise rt.Reject
            sensor_id_ = item_.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            out += _S_H.pack(sensor_id_)
            stream_url_raw_ = item_.stream_url.encode("latin-1")
            out.append(len(stream_url_raw_))
            out += stream_url_raw_
            repeat_ = item_.repeat
            if repeat_ not in _E_SetDigitalAudioOutputSource_Repeat: raise rt.Reject
            volume_ = item_.volume
            if not 0.0 <= volume_ <= 100.0: raise rt.Reject
            near = volume_ * 655.35 + 0.5
            volume_raw_ = int(near)
            if not 1.52587890625e-05 < near - volume_raw_ < 0.9999847412109375: volume_raw_ = rt.exact_raw(volume_, _R_3)
            out += _S_BH.pack(repeat_, volume_raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryDigitalAudioOutputSource(rt.Message):
    """QueryDigitalAudioOutputSource (0x2818): Asks which streams are played.

    sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
    """

    CODE = 0x2818
    NAME = "QueryDigitalAudioOutputSource"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioOutput"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDigitalAudioOutputSource]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    sensor_id: QueryDigitalAudioOutputSource.SensorID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(QueryDigitalAudioOutputSource.SensorID, ((1, 65535),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, sensor_id_ = _S_2H.unpack(data)
        if code != 0x2818: raise rt.Reject
        self.sensor_id = _E_QueryDigitalAudioOutputSource_SensorID.get(sensor_id_, sensor_id_)
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2818, self.sensor_id)


@dataclass(slots=True, repr=False)
class QueryDigitalAudioOutputCapabilities(rt.Message):
    """QueryDigitalAudioOutputCapabilities (0x2819): Asks what audio outputs can do.

    sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
    """

    CODE = 0x2819
    NAME = "QueryDigitalAudioOutputCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioOutput"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDigitalAudioOutputCapabilities]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    sensor_id: QueryDigitalAudioOutputCapabilities.SensorID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(QueryDigitalAudioOutputCapabilities.SensorID, ((1, 65535),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, sensor_id_ = _S_2H.unpack(data)
        if code != 0x2819: raise rt.Reject
        self.sensor_id = _E_QueryDigitalAudioOutputCapabilities_SensorID.get(sensor_id_, sensor_id_)
        return self

    def _pack(self) -> bytes:
        return _S_2H.pack(0x2819, self.sensor_id)


@dataclass(slots=True, repr=False)
class ConfirmSensorConfiguration(rt.Message):
    """ConfirmSensorConfiguration (0x0801): Tells for each sensor whether its new configuration was taken over, and
    if not, why.

    confirm_sensor_list: 0..65535 items. The sensors
    """

    CODE = 0x0801
    NAME = "ConfirmSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioOutput"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    SensorIdRec = environment_sensing_v1_0_types.SensorIdRec
    RangeSensorErrorRec = environment_sensing_v1_0_types.RangeSensorErrorRec
    VisualSensorErrorRec = environment_sensing_v1_0_types.VisualSensorErrorRec
    DigitalVideoSensorErrorRec = environment_sensing_v1_0_types.DigitalVideoSensorErrorRec
    AnalogVideoSensorErrorRec = environment_sensing_v1_0_types.AnalogVideoSensorErrorRec
    StillImageSensorErrorRec = environment_sensing_v1_0_types.StillImageSensorErrorRec
    H264VideoEncodingErrorRec = environment_sensing_v1_0_types.H264VideoEncodingErrorRec
    DigitalAudioSensorErrorRec = environment_sensing_v1_0_types.DigitalAudioSensorErrorRec
    DigitalAudioOutputErrorRec = environment_sensing_v1_0_types.DigitalAudioOutputErrorRec
    VideoIlluminatorErrorRec = environment_sensing_v1_0_types.VideoIlluminatorErrorRec

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

    request_id_rec: ConfirmSensorConfiguration.RequestIdRec
    confirm_sensor_list: list[environment_sensing_v1_0_types.SensorIdRec | environment_sensing_v1_0_types.RangeSensorErrorRec | environment_sensing_v1_0_types.VisualSensorErrorRec | environment_sensing_v1_0_types.DigitalVideoSensorErrorRec | environment_sensing_v1_0_types.AnalogVideoSensorErrorRec | environment_sensing_v1_0_types.StillImageSensorErrorRec | environment_sensing_v1_0_types.H264VideoEncodingErrorRec | environment_sensing_v1_0_types.DigitalAudioSensorErrorRec | environment_sensing_v1_0_types.DigitalAudioOutputErrorRec | environment_sensing_v1_0_types.VideoIlluminatorErrorRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", ConfirmSensorConfiguration.RequestIdRec.layout()),
            ("ConfirmSensorList", rt.Repeat(rt.Count("H", 0, 65535), rt.Union.of("B", sensor_id_rec=environment_sensing_v1_0_types.SensorIdRec, range_sensor_error_rec=environment_sensing_v1_0_types.RangeSensorErrorRec, visual_sensor_error_rec=environment_sensing_v1_0_types.VisualSensorErrorRec, digital_video_sensor_error_rec=environment_sensing_v1_0_types.DigitalVideoSensorErrorRec, analog_video_sensor_error_rec=environment_sensing_v1_0_types.AnalogVideoSensorErrorRec, still_image_sensor_error_rec=environment_sensing_v1_0_types.StillImageSensorErrorRec, h264_video_encoding_error_rec=environment_sensing_v1_0_types.H264VideoEncodingErrorRec, digital_audio_sensor_error_rec=environment_sensing_v1_0_types.DigitalAudioSensorErrorRec, digital_audio_output_error_rec=environment_sensing_v1_0_types.DigitalAudioOutputErrorRec, video_illuminator_error_rec=environment_sensing_v1_0_types.VideoIlluminatorErrorRec))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x01 or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = ConfirmSensorConfiguration.RequestIdRec(request_id_)
        (confirm_sensor_list_count_,) = _S_H.unpack_from(data, 3)
        if confirm_sensor_list_count_ * 3 > size - 5: raise rt.Reject
        at = 5
        confirm_sensor_list_ = []
        for _ in range(confirm_sensor_list_count_):
            tag = data[at]
            at += 1
            item_, at = _U_7[tag]._read(data, at, nesting)
            confirm_sensor_list_.append(item_)
        self.confirm_sensor_list = confirm_sensor_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x01\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not ConfirmSensorConfiguration.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        confirm_sensor_list_ = self.confirm_sensor_list
        if type(confirm_sensor_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(confirm_sensor_list_))
        for item_ in confirm_sensor_list_:
            out.append(_T_8[type(item_)])
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportDigitalAudioOutputSource(rt.Message):
    """ReportDigitalAudioOutputSource (0x4818): Tells which streams are played, and how loud.

    digital_audio_output_source_list: 0..65535 items. The outputs
    """

    CODE = 0x4818
    NAME = "ReportDigitalAudioOutputSource"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioOutput"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Repeat(IntEnum):
        """Values of Repeat."""

        PLAY_ONCE = 0
        REPEAT = 1

    @dataclass(slots=True, repr=False)
    class DigitalAudioOutputSourceRec(rt.Struct):
        """What one output plays.

        sensor_id: 1..65535. Identifies the sensor
        stream_url: up to 255 characters. Where to fetch the stream
        repeat: Repeat. What to do at the end of the stream
        volume: 0..100 percent. Loudness, in percent
        """

        sensor_id: int
        stream_url: str
        repeat: ReportDigitalAudioOutputSource.Repeat | int
        volume: float

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("StreamURL", rt.Text(count=rt.Count("B", 0, 255))),
                ("Repeat", rt.Number("B", rt.Values(ReportDigitalAudioOutputSource.Repeat))),
                ("Volume", rt.real("H", 0.0, 100.0, "percent")),
            )

    digital_audio_output_source_list: list[ReportDigitalAudioOutputSource.DigitalAudioOutputSourceRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DigitalAudioOutputSourceList", rt.Repeat(rt.Count("H", 0, 65535), ReportDigitalAudioOutputSource.DigitalAudioOutputSourceRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x18 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (digital_audio_output_source_list_count_,) = _S_H.unpack_from(data, 2)
        if digital_audio_output_source_list_count_ * 6 > size - 4: raise rt.Reject
        at = 4
        digital_audio_output_source_list_ = []
        for _ in range(digital_audio_output_source_list_count_):
            item_ = rt.new(ReportDigitalAudioOutputSource.DigitalAudioOutputSourceRec)
            (sensor_id_,) = _S_H.unpack_from(data, at)
            if sensor_id_ < 1: raise rt.Reject
            item_.sensor_id = sensor_id_
            stream_url_end_ = at + 3 + data[at + 2]
            item_.stream_url = data[at + 3:stream_url_end_].decode("latin-1")
            repeat_, volume_ = _S_BH.unpack_from(data, stream_url_end_)
            item_.repeat = _E_ReportDigitalAudioOutputSource_Repeat[repeat_]
            item_.volume = volume_ * 0.0015259021896696422
            at = stream_url_end_ + 3
            digital_audio_output_source_list_.append(item_)
        self.digital_audio_output_source_list = digital_audio_output_source_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x18\x48")
        digital_audio_output_source_list_ = self.digital_audio_output_source_list
        if type(digital_audio_output_source_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_audio_output_source_list_))
        for item_ in digital_audio_output_source_list_:
            if type(item_) is not ReportDigitalAudioOutputSource.DigitalAudioOutputSourceRec: raise rt.Reject
            sensor_id_ = item_.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            out += _S_H.pack(sensor_id_)
            stream_url_raw_ = item_.stream_url.encode("latin-1")
            out.append(len(stream_url_raw_))
            out += stream_url_raw_
            repeat_ = item_.repeat
            if repeat_ not in _E_ReportDigitalAudioOutputSource_Repeat: raise rt.Reject
            volume_ = item_.volume
            if not 0.0 <= volume_ <= 100.0: raise rt.Reject
            near = volume_ * 655.35 + 0.5
            volume_raw_ = int(near)
            if not 1.52587890625e-05 < near - volume_raw_ < 0.9999847412109375: volume_raw_ = rt.exact_raw(volume_, _R_3)
            out += _S_BH.pack(repeat_, volume_raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportDigitalAudioOutputCapabilities(rt.Message):
    """ReportDigitalAudioOutputCapabilities (0x4819): Tells what audio outputs can do.

    digital_audio_output_capabilities_list: 0..65535 items. The outputs
    """

    CODE = 0x4819
    NAME = "ReportDigitalAudioOutputCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalAudioOutput"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    SupportedAudioFormats = environment_sensing_v1_0_types.SupportedAudioFormats
    SupportedBitDepths = environment_sensing_v1_0_types.SupportedBitDepths

    @dataclass(slots=True, repr=False)
    class DigitalAudioOutputCapabilitiesRec(rt.Struct):
        """DigitalAudioOutputCapabilitiesRec.

        sensor_id: 1..65535. Identifies the sensor
        minimum_allowed_bit_rate: optional. Smallest bit rate that can be set, in kilobits per second
        maximum_allowed_bit_rate: optional. Largest bit rate that can be set, in kilobits per second
        supported_digital_formats: optional. Codings of audio that can be played
        min_sample_rate: optional. Smallest number of samples per second
        max_sample_rate: optional. Largest number of samples per second
        supported_bit_depths: optional. Bits per sample that can be had
        """

        sensor_id: int
        minimum_allowed_bit_rate: int | None = None
        maximum_allowed_bit_rate: int | None = None
        supported_digital_formats: environment_sensing_v1_0_types.SupportedAudioFormats | None = None
        min_sample_rate: int | None = None
        max_sample_rate: int | None = None
        supported_bit_depths: environment_sensing_v1_0_types.SupportedBitDepths | None = None
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
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportDigitalAudioOutputCapabilities_DigitalAudioOutputCapabilitiesRec_0[mask & 0x3F]
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
            self.reserved_presence = mask & 0xC0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3F: raise rt.Reject
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
            out += _M_ReportDigitalAudioOutputCapabilities_DigitalAudioOutputCapabilitiesRec_0[mask & 0x3F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    digital_audio_output_capabilities_list: list[ReportDigitalAudioOutputCapabilities.DigitalAudioOutputCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DigitalAudioOutputCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), ReportDigitalAudioOutputCapabilities.DigitalAudioOutputCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x19 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (digital_audio_output_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        if digital_audio_output_capabilities_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        digital_audio_output_capabilities_list_ = []
        for _ in range(digital_audio_output_capabilities_list_count_):
            item_, at = ReportDigitalAudioOutputCapabilities.DigitalAudioOutputCapabilitiesRec._read(data, at, nesting)
            digital_audio_output_capabilities_list_.append(item_)
        self.digital_audio_output_capabilities_list = digital_audio_output_capabilities_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x19\x48")
        digital_audio_output_capabilities_list_ = self.digital_audio_output_capabilities_list
        if type(digital_audio_output_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_audio_output_capabilities_list_))
        for item_ in digital_audio_output_capabilities_list_:
            if type(item_) is not ReportDigitalAudioOutputCapabilities.DigitalAudioOutputCapabilitiesRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


_S_H = rt.Packer("<H")
_E_SetDigitalAudioOutputSource_Repeat = rt.members(SetDigitalAudioOutputSource.Repeat)
_S_BH = rt.Packer("<BH")
_R_3 = rt.Scaling(0.0, 100.0, 65535)
_E_QueryDigitalAudioOutputSource_SensorID = rt.members(QueryDigitalAudioOutputSource.SensorID)
_S_2H = rt.Packer("<2H")
_E_QueryDigitalAudioOutputCapabilities_SensorID = rt.members(QueryDigitalAudioOutputCapabilities.SensorID)
_U_7: tuple[type[environment_sensing_v1_0_types.SensorIdRec] | type[environment_sensing_v1_0_types.RangeSensorErrorRec] | type[environment_sensing_v1_0_types.VisualSensorErrorRec] | type[environment_sensing_v1_0_types.DigitalVideoSensorErrorRec] | type[environment_sensing_v1_0_types.AnalogVideoSensorErrorRec] | type[environment_sensing_v1_0_types.StillImageSensorErrorRec] | type[environment_sensing_v1_0_types.H264VideoEncodingErrorRec] | type[environment_sensing_v1_0_types.DigitalAudioSensorErrorRec] | type[environment_sensing_v1_0_types.DigitalAudioOutputErrorRec] | type[environment_sensing_v1_0_types.VideoIlluminatorErrorRec], ...] = (environment_sensing_v1_0_types.SensorIdRec, environment_sensing_v1_0_types.RangeSensorErrorRec, environment_sensing_v1_0_types.VisualSensorErrorRec, environment_sensing_v1_0_types.DigitalVideoSensorErrorRec, environment_sensing_v1_0_types.AnalogVideoSensorErrorRec, environment_sensing_v1_0_types.StillImageSensorErrorRec, environment_sensing_v1_0_types.H264VideoEncodingErrorRec, environment_sensing_v1_0_types.DigitalAudioSensorErrorRec, environment_sensing_v1_0_types.DigitalAudioOutputErrorRec, environment_sensing_v1_0_types.VideoIlluminatorErrorRec)
_T_8: dict[type[rt.Struct], int] = {environment_sensing_v1_0_types.SensorIdRec: 0, environment_sensing_v1_0_types.RangeSensorErrorRec: 1, environment_sensing_v1_0_types.VisualSensorErrorRec: 2, environment_sensing_v1_0_types.DigitalVideoSensorErrorRec: 3, environment_sensing_v1_0_types.AnalogVideoSensorErrorRec: 4, environment_sensing_v1_0_types.StillImageSensorErrorRec: 5, environment_sensing_v1_0_types.H264VideoEncodingErrorRec: 6, environment_sensing_v1_0_types.DigitalAudioSensorErrorRec: 7, environment_sensing_v1_0_types.DigitalAudioOutputErrorRec: 8, environment_sensing_v1_0_types.VideoIlluminatorErrorRec: 9}
_E_ReportDigitalAudioOutputSource_Repeat = rt.members(ReportDigitalAudioOutputSource.Repeat)
_M_ReportDigitalAudioOutputCapabilities_DigitalAudioOutputCapabilitiesRec_0 = rt.Masks("", ((0, "H"), (1, "H"), (2, "H"), (4, "I"), (8, "I"), (16, "I"), (32, "H")))
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
_S_B = rt.Packer("<B")
QueryDigitalAudioOutputSource.REPORT = ReportDigitalAudioOutputSource
QueryDigitalAudioOutputCapabilities.REPORT = ReportDigitalAudioOutputCapabilities
