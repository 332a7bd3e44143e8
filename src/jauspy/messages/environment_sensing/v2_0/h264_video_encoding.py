"""urn:jaus:jss:environmentSensing:H264VideoEncoding 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.environment_sensing.v2_0 import digital_audio_output as environment_sensing_v2_0_digital_audio_output


@dataclass(slots=True, repr=False)
class SetH264VideoEncodingConfiguration(rt.Message):
    """SetH264VideoEncodingConfiguration (0x080D): Sets the configuration of H.264 encoders.

    h264_configuration_list: 0..65535 items. The encoders
    """

    CODE = 0x080D
    NAME = "SetH264VideoEncodingConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:H264VideoEncoding"
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

    class Profile(IntEnum):
        """Values of Profile."""

        BASELINE = 0
        CONSTRAINED_BASELINE = 1
        MAIN = 2
        EXTENDED = 3
        HIGH = 4
        PROGRESSIVE_HIGH = 5
        CONSTRAINED_HIGH = 6
        HIGH_10 = 7
        HIGH_422 = 8
        HIGH_444_PREDICTIVE = 9
        HIGH_10_INTRA = 10
        HIGH_422_INTRA = 11
        HIGH_444_INTRA = 12
        CAVLC444 = 13
        SCALABLE_BASELINE = 14
        SCALABLE_CONSTRAINED_BASELINE = 15
        SCALABLE_HIGH = 16
        SCALABLE_CONSTRAINED_HIGH = 17
        SCALABLE_HIGH_INTRA = 18
        STEREO_HIGH = 19
        MULTIVIEW_HIGH = 20

    class Level(IntEnum):
        """Values of Level."""

        LEVEL_1 = 0
        LEVEL_1_B = 1
        LEVEL_11 = 2
        LEVEL_12 = 3
        LEVEL_13 = 4
        LEVEL_2 = 5
        LEVEL_21 = 6
        LEVEL_22 = 7
        LEVEL_3 = 8
        LEVEL_31 = 9
        LEVEL_32 = 10
        LEVEL_4 = 11
        LEVEL_41 = 12
        LEVEL_42 = 13
        LEVEL_5 = 14
        LEVEL_51 = 15
        LEVEL_52 = 16
        LEVEL_6 = 17
        LEVEL_61 = 18
        LEVEL_62 = 19

    class Preset(IntEnum):
        """Values of Preset."""

        LOW_LATENCY = 0
        SLOW_COMMS = 1
        PERSISTENT_STARE = 2
        DRIVE_VISION = 3
        MANIPULATION = 4
        BEST_QUALITY = 5
        PROGRAMSPECIFIC_1 = 12
        PROGRAMSPECIFIC_2 = 13
        PROGRAMSPECIFIC_3 = 14
        PROGRAMSPECIFIC_4 = 15

    class GradualDecoderRefreshOnOff(IntEnum):
        """Values of GradualDecoderRefreshOnOff."""

        OFF = 0
        ON = 1

    class RegionOfInterestOnOff(IntEnum):
        """Values of RegionOfInterestOnOff."""

        OFF = 0
        ON = 1

    @dataclass(slots=True, repr=False)
    class H264ConfigurationRec(rt.Struct):
        """Settings of one encoder.

        sensor_id: Identifies the sensor
        profile: Profile, optional. Set of coding tools
        level: Level, optional. Level of size and rate
        preset: Preset, optional. Purpose that the encoder is tuned for
        group_of_pictures: optional. Number of frames from one complete frame to the next
        gradual_decoder_refresh_on_off: GradualDecoderRefreshOnOff, optional. Whether frames are refreshed part by part instead of by complete frames
        region_of_interest_on_off: RegionOfInterestOnOff, optional. Whether part of the image is coded better than the rest
        intra_macro_refresh: 0..100, optional. Blocks that are refreshed in each frame, in percent
        """

        sensor_id: int
        profile: SetH264VideoEncodingConfiguration.Profile | int | None = None
        level: SetH264VideoEncodingConfiguration.Level | int | None = None
        preset: SetH264VideoEncodingConfiguration.Preset | int | None = None
        group_of_pictures: int | None = None
        gradual_decoder_refresh_on_off: SetH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff | int | None = None
        region_of_interest_on_off: SetH264VideoEncodingConfiguration.RegionOfInterestOnOff | int | None = None
        intra_macro_refresh: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H")),
                ("Profile", rt.Number("B", rt.Values(SetH264VideoEncodingConfiguration.Profile)), True),
                ("Level", rt.Number("I", rt.Values(SetH264VideoEncodingConfiguration.Level)), True),
                ("Preset", rt.Number("B", rt.Values(SetH264VideoEncodingConfiguration.Preset)), True),
                ("GroupOfPictures", rt.Number("B"), True),
                ("GradualDecoderRefreshOnOff", rt.Number("B", rt.Values(SetH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff)), True),
                ("RegionOfInterestOnOff", rt.Number("B", rt.Values(SetH264VideoEncodingConfiguration.RegionOfInterestOnOff)), True),
                ("IntraMacroRefresh", rt.real("H", 0.0, 100.0), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetH264VideoEncodingConfiguration_H264ConfigurationRec_0[mask & 0x7F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.sensor_id = raw()
            if mask & 1:
                profile_ = raw()
                self.profile = _E_SetH264VideoEncodingConfiguration_Profile[profile_]
            else: self.profile = None
            if mask & 2:
                level_ = raw()
                self.level = _E_SetH264VideoEncodingConfiguration_Level[level_]
            else: self.level = None
            if mask & 4:
                preset_ = raw()
                self.preset = _E_SetH264VideoEncodingConfiguration_Preset[preset_]
            else: self.preset = None
            self.group_of_pictures = raw() if mask & 8 else None
            if mask & 16:
                gradual_decoder_refresh_on_off_ = raw()
                self.gradual_decoder_refresh_on_off = _E_SetH264VideoEncodingConfiguration_GradualDecoderRefreshOnOff[gradual_decoder_refresh_on_off_]
            else: self.gradual_decoder_refresh_on_off = None
            if mask & 32:
                region_of_interest_on_off_ = raw()
                self.region_of_interest_on_off = _E_SetH264VideoEncodingConfiguration_RegionOfInterestOnOff[region_of_interest_on_off_]
            else: self.region_of_interest_on_off = None
            self.intra_macro_refresh = raw() * 0.0015259021896696422 if mask & 64 else None
            self.reserved_presence = mask & 0x80
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7F: raise rt.Reject
            raw: list[int | float | bytes] = []
            raw.append(self.sensor_id)
            profile_ = self.profile
            if profile_ is not None:
                mask |= 1
                if profile_ not in _E_SetH264VideoEncodingConfiguration_Profile: raise rt.Reject
                raw.append(profile_)
            level_ = self.level
            if level_ is not None:
                mask |= 2
                if level_ not in _E_SetH264VideoEncodingConfiguration_Level: raise rt.Reject
                raw.append(level_)
            preset_ = self.preset
            if preset_ is not None:
                mask |= 4
                if preset_ not in _E_SetH264VideoEncodingConfiguration_Preset: raise rt.Reject
                raw.append(preset_)
            group_of_pictures_ = self.group_of_pictures
            if group_of_pictures_ is not None:
                mask |= 8
                raw.append(group_of_pictures_)
            gradual_decoder_refresh_on_off_ = self.gradual_decoder_refresh_on_off
            if gradual_decoder_refresh_on_off_ is not None:
                mask |= 16
                if gradual_decoder_refresh_on_off_ not in _E_SetH264VideoEncodingConfiguration_GradualDecoderRefreshOnOff: raise rt.Reject
                raw.append(gradual_decoder_refresh_on_off_)
            region_of_interest_on_off_ = self.region_of_interest_on_off
            if region_of_interest_on_off_ is not None:
                mask |= 32
                if region_of_interest_on_off_ not in _E_SetH264VideoEncodingConfiguration_RegionOfInterestOnOff: raise rt.Reject
                raw.append(region_of_interest_on_off_)
            intra_macro_refresh_ = self.intra_macro_refresh
            if intra_macro_refresh_ is not None:
                mask |= 64
                if not 0.0 <= intra_macro_refresh_ <= 100.0: raise rt.Reject
                near = intra_macro_refresh_ * 655.35 + 0.5
                intra_macro_refresh_raw_ = int(near)
                if not 1.52587890625e-05 < near - intra_macro_refresh_raw_ < 0.9999847412109375: intra_macro_refresh_raw_ = rt.exact_raw(intra_macro_refresh_, _R_6)
                raw.append(intra_macro_refresh_raw_)
            out += _M_SetH264VideoEncodingConfiguration_H264ConfigurationRec_0[mask & 0x7F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class RegionOfInterestParams(rt.Struct):
        """Part of the image that is coded better.

        x_start: 0..100 percent. Left edge of the part, in percent of the image
        y_start: 0..100 percent. Upper edge of the part, in percent of the image
        width: 0..100 percent. Width of the part, in percent of the image
        height: 0..100 percent. Height of the part, in percent of the image
        high_bit_rate: Bit rate for the part, in kilobits per second
        low_bit_rate: Bit rate for the rest of the image, in kilobits per second
        """

        x_start: float
        y_start: float
        width: float
        height: float
        high_bit_rate: int
        low_bit_rate: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X_Start", rt.real("H", 0.0, 100.0, "percent")),
                ("Y_Start", rt.real("H", 0.0, 100.0, "percent")),
                ("Width", rt.real("H", 0.0, 100.0, "percent")),
                ("Height", rt.real("H", 0.0, 100.0, "percent")),
                ("HighBitRate", rt.Number("H")),
                ("LowBitRate", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class GradualDecoderRefreshParams(rt.Struct):
        """How frames are refreshed part by part.

        gdr_duration: Frames that one refresh takes
        gdr_interval: Frames from one refresh to the next
        """

        gdr_duration: int
        gdr_interval: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("GDR_Duration", rt.Number("H")),
                ("GDR_Interval", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class H264ConfigurationSequence(rt.Struct):
        """H264ConfigurationSequence.

        h264_configuration_rec: Settings of one encoder
        region_of_interest_params: optional. Part of the image that is coded better
        gradual_decoder_refresh_params: optional. How frames are refreshed part by part
        """

        h264_configuration_rec: SetH264VideoEncodingConfiguration.H264ConfigurationRec
        region_of_interest_params: SetH264VideoEncodingConfiguration.RegionOfInterestParams | None = None
        gradual_decoder_refresh_params: SetH264VideoEncodingConfiguration.GradualDecoderRefreshParams | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("H264ConfigurationRec", SetH264VideoEncodingConfiguration.H264ConfigurationRec.layout()),
                ("RegionOfInterestParams", SetH264VideoEncodingConfiguration.RegionOfInterestParams.layout(), True),
                ("GradualDecoderRefreshParams", SetH264VideoEncodingConfiguration.GradualDecoderRefreshParams.layout(), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            at += 1
            self.h264_configuration_rec, at = SetH264VideoEncodingConfiguration.H264ConfigurationRec._read(data, at, nesting)
            if mask & 1:
                x_start_, y_start_, width_, height_, high_bit_rate_, low_bit_rate_ = _S_6H.unpack_from(data, at)
                self.region_of_interest_params = SetH264VideoEncodingConfiguration.RegionOfInterestParams(x_start_ * 0.0015259021896696422, y_start_ * 0.0015259021896696422, width_ * 0.0015259021896696422, height_ * 0.0015259021896696422, high_bit_rate_, low_bit_rate_)
                at += 12
            else: self.region_of_interest_params = None
            if mask & 2:
                gdr_duration_, gdr_interval_ = _S_2H.unpack_from(data, at)
                self.gradual_decoder_refresh_params = SetH264VideoEncodingConfiguration.GradualDecoderRefreshParams(gdr_duration_, gdr_interval_)
                at += 4
            else: self.gradual_decoder_refresh_params = None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            h264_configuration_rec_ = self.h264_configuration_rec
            if type(h264_configuration_rec_) is not SetH264VideoEncodingConfiguration.H264ConfigurationRec: raise rt.Reject
            h264_configuration_rec_._write(out)
            region_of_interest_params_ = self.region_of_interest_params
            if region_of_interest_params_ is not None:
                mask |= 1
                if type(region_of_interest_params_) is not SetH264VideoEncodingConfiguration.RegionOfInterestParams: raise rt.Reject
                x_start_ = region_of_interest_params_.x_start
                if not 0.0 <= x_start_ <= 100.0: raise rt.Reject
                near = x_start_ * 655.35 + 0.5
                x_start_raw_ = int(near)
                if not 1.52587890625e-05 < near - x_start_raw_ < 0.9999847412109375: x_start_raw_ = rt.exact_raw(x_start_, _R_6)
                y_start_ = region_of_interest_params_.y_start
                if not 0.0 <= y_start_ <= 100.0: raise rt.Reject
                near = y_start_ * 655.35 + 0.5
                y_start_raw_ = int(near)
                if not 1.52587890625e-05 < near - y_start_raw_ < 0.9999847412109375: y_start_raw_ = rt.exact_raw(y_start_, _R_6)
                width_ = region_of_interest_params_.width
                if not 0.0 <= width_ <= 100.0: raise rt.Reject
                near = width_ * 655.35 + 0.5
                width_raw_ = int(near)
                if not 1.52587890625e-05 < near - width_raw_ < 0.9999847412109375: width_raw_ = rt.exact_raw(width_, _R_6)
                height_ = region_of_interest_params_.height
                if not 0.0 <= height_ <= 100.0: raise rt.Reject
                near = height_ * 655.35 + 0.5
                height_raw_ = int(near)
                if not 1.52587890625e-05 < near - height_raw_ < 0.9999847412109375: height_raw_ = rt.exact_raw(height_, _R_6)
                out += _S_6H.pack(x_start_raw_, y_start_raw_, width_raw_, height_raw_, region_of_interest_params_.high_bit_rate, region_of_interest_params_.low_bit_rate)
            gradual_decoder_refresh_params_ = self.gradual_decoder_refresh_params
            if gradual_decoder_refresh_params_ is not None:
                mask |= 2
                if type(gradual_decoder_refresh_params_) is not SetH264VideoEncodingConfiguration.GradualDecoderRefreshParams: raise rt.Reject
                out += _S_2H.pack(gradual_decoder_refresh_params_.gdr_duration, gradual_decoder_refresh_params_.gdr_interval)
            _S_B.pack_into(out, start, mask)

    request_id_rec: SetH264VideoEncodingConfiguration.RequestIdRec
    h264_configuration_list: list[SetH264VideoEncodingConfiguration.H264ConfigurationSequence]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", SetH264VideoEncodingConfiguration.RequestIdRec.layout()),
            ("H264ConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), SetH264VideoEncodingConfiguration.H264ConfigurationSequence.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0D or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetH264VideoEncodingConfiguration.RequestIdRec(request_id_)
        (h264_configuration_list_count_,) = _S_H.unpack_from(data, 3)
        if h264_configuration_list_count_ * 4 > size - 5: raise rt.Reject
        at = 5
        h264_configuration_list_ = []
        for _ in range(h264_configuration_list_count_):
            item_, at = SetH264VideoEncodingConfiguration.H264ConfigurationSequence._read(data, at, nesting)
            h264_configuration_list_.append(item_)
        self.h264_configuration_list = h264_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0d\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetH264VideoEncodingConfiguration.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        h264_configuration_list_ = self.h264_configuration_list
        if type(h264_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(h264_configuration_list_))
        for item_ in h264_configuration_list_:
            if type(item_) is not SetH264VideoEncodingConfiguration.H264ConfigurationSequence: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryH264VideoEncodingCapabilities(rt.Message):
    """QueryH264VideoEncodingCapabilities (0x280E): Asks what H.264 encoders can do.

    query_h264_video_encoding_capabilities_list: 0..65535 items. The encoders
    """

    CODE = 0x280E
    NAME = "QueryH264VideoEncodingCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:H264VideoEncoding"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportH264VideoEncodingCapabilities]]

    @dataclass(slots=True, repr=False)
    class QueryH264VideoEncodingRec(rt.Struct):
        """QueryH264VideoEncodingRec.

        sensor_id: Which sensor is meant; 0 is all
        """

        sensor_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H")),
            )

    query_h264_video_encoding_capabilities_list: list[QueryH264VideoEncodingCapabilities.QueryH264VideoEncodingRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryH264VideoEncodingCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), QueryH264VideoEncodingCapabilities.QueryH264VideoEncodingRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0E or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_h264_video_encoding_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        query_h264_video_encoding_capabilities_list_end_ = 4 + query_h264_video_encoding_capabilities_list_count_ * 2
        self.query_h264_video_encoding_capabilities_list = [QueryH264VideoEncodingCapabilities.QueryH264VideoEncodingRec(sensor_id_) for sensor_id_ in _L_H[query_h264_video_encoding_capabilities_list_count_].unpack_from(data, 4)]
        if query_h264_video_encoding_capabilities_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0e\x28")
        query_h264_video_encoding_capabilities_list_ = self.query_h264_video_encoding_capabilities_list
        if type(query_h264_video_encoding_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_h264_video_encoding_capabilities_list_))
        raw_: list[int | float] = []
        for item_ in query_h264_video_encoding_capabilities_list_:
            if type(item_) is not QueryH264VideoEncodingCapabilities.QueryH264VideoEncodingRec: raise rt.Reject
            raw_.append(item_.sensor_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryH264VideoEncodingConfiguration(rt.Message):
    """QueryH264VideoEncodingConfiguration (0x280D): Asks for the configuration of H.264 encoders.

    query_h264_video_encoding_configuration_list: 0..65535 items. The encoders
    """

    CODE = 0x280D
    NAME = "QueryH264VideoEncodingConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:H264VideoEncoding"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportH264VideoEncodingConfiguration]]

    @dataclass(slots=True, repr=False)
    class QueryH264VideoEncodingRec(rt.Struct):
        """QueryH264VideoEncodingRec.

        sensor_id: Which sensor is meant; 0 is all
        """

        sensor_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H")),
            )

    query_h264_video_encoding_configuration_list: list[QueryH264VideoEncodingConfiguration.QueryH264VideoEncodingRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryH264VideoEncodingConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), QueryH264VideoEncodingConfiguration.QueryH264VideoEncodingRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0D or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_h264_video_encoding_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        query_h264_video_encoding_configuration_list_end_ = 4 + query_h264_video_encoding_configuration_list_count_ * 2
        self.query_h264_video_encoding_configuration_list = [QueryH264VideoEncodingConfiguration.QueryH264VideoEncodingRec(sensor_id_) for sensor_id_ in _L_H[query_h264_video_encoding_configuration_list_count_].unpack_from(data, 4)]
        if query_h264_video_encoding_configuration_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0d\x28")
        query_h264_video_encoding_configuration_list_ = self.query_h264_video_encoding_configuration_list
        if type(query_h264_video_encoding_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_h264_video_encoding_configuration_list_))
        raw_: list[int | float] = []
        for item_ in query_h264_video_encoding_configuration_list_:
            if type(item_) is not QueryH264VideoEncodingConfiguration.QueryH264VideoEncodingRec: raise rt.Reject
            raw_.append(item_.sensor_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


class ConfirmSensorConfiguration(environment_sensing_v2_0_digital_audio_output.ConfirmSensorConfiguration):
    """ConfirmSensorConfiguration (0x0801): Tells for each sensor whether its new configuration was taken over, and
    if not, why.
    """

    __slots__ = ()
    SERVICE = "urn:jaus:jss:environmentSensing:H264VideoEncoding"
    VERSION = "2.0"


@dataclass(slots=True, repr=False)
class ReportH264VideoEncodingCapabilities(rt.Message):
    """ReportH264VideoEncodingCapabilities (0x480E): Tells what H.264 encoders can do.

    h264_capabilities_list: 0..65535 items. The encoders
    """

    CODE = 0x480E
    NAME = "ReportH264VideoEncodingCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:H264VideoEncoding"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Baseline(IntEnum):
        """Values of Baseline."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ConstrainedBaseline(IntEnum):
        """Values of ConstrainedBaseline."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Main(IntEnum):
        """Values of Main."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Extended(IntEnum):
        """Values of Extended."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High(IntEnum):
        """Values of High."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ProgressiveHigh(IntEnum):
        """Values of ProgressiveHigh."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ConstrainedHigh(IntEnum):
        """Values of ConstrainedHigh."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High10(IntEnum):
        """Values of High10."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High422(IntEnum):
        """Values of High422."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High444Predictive(IntEnum):
        """Values of High444Predictive."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High10Intra(IntEnum):
        """Values of High10Intra."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High422Intra(IntEnum):
        """Values of High422Intra."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class High444Intra(IntEnum):
        """Values of High444Intra."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class CAVLC444(IntEnum):
        """Values of CAVLC444."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableBaseline(IntEnum):
        """Values of ScalableBaseline."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableConstrainedBaseline(IntEnum):
        """Values of ScalableConstrainedBaseline."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableHigh(IntEnum):
        """Values of ScalableHigh."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableConstrainedHigh(IntEnum):
        """Values of ScalableConstrainedHigh."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ScalableHighIntra(IntEnum):
        """Values of ScalableHighIntra."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class StereoHigh(IntEnum):
        """Values of StereoHigh."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class MultiviewHigh(IntEnum):
        """Values of MultiviewHigh."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class SupportedProfiles(rt.Struct):
        """Sets of coding tools that the encoder offers.

        baseline: bit 0. Profile Baseline.
        constrained_baseline: bit 1. Profile Constrained Baseline.
        main: bit 2. Profile Main.
        extended: bit 3. Profile Extended.
        high: bit 4. Profile High.
        progressive_high: bit 5. Profile Progressive High.
        constrained_high: bit 6. Profile Constrained High.
        high10: bit 7. Profile High 10.
        high422: bit 8. Profile High 4:2:2.
        high444_predictive: bit 9. Profile High 4:4:4 Predictive.
        high10_intra: bit 10. Profile High 10 Intra.
        high422_intra: bit 11. Profile High 4:2:2 Intra.
        high444_intra: bit 12. Profile High 4:4:4 Intra.
        cavlc444: bit 13. Profile CAVLC 4:4:4 Intra.
        scalable_baseline: bit 14. Profile Scalable Baseline.
        scalable_constrained_baseline: bit 15. Profile Scalable Constrained Baseline.
        scalable_high: bit 16. Profile Scalable High.
        scalable_constrained_high: bit 17. Profile Scalable Constrained High.
        scalable_high_intra: bit 18. Profile Scalable High Intra.
        stereo_high: bit 19. Profile Stereo High.
        multiview_high: bit 20. Profile Multiview High.
        """

        baseline: ReportH264VideoEncodingCapabilities.Baseline | int
        constrained_baseline: ReportH264VideoEncodingCapabilities.ConstrainedBaseline | int
        main: ReportH264VideoEncodingCapabilities.Main | int
        extended: ReportH264VideoEncodingCapabilities.Extended | int
        high: ReportH264VideoEncodingCapabilities.High | int
        progressive_high: ReportH264VideoEncodingCapabilities.ProgressiveHigh | int
        constrained_high: ReportH264VideoEncodingCapabilities.ConstrainedHigh | int
        high10: ReportH264VideoEncodingCapabilities.High10 | int
        high422: ReportH264VideoEncodingCapabilities.High422 | int
        high444_predictive: ReportH264VideoEncodingCapabilities.High444Predictive | int
        high10_intra: ReportH264VideoEncodingCapabilities.High10Intra | int
        high422_intra: ReportH264VideoEncodingCapabilities.High422Intra | int
        high444_intra: ReportH264VideoEncodingCapabilities.High444Intra | int
        cavlc444: ReportH264VideoEncodingCapabilities.CAVLC444 | int
        scalable_baseline: ReportH264VideoEncodingCapabilities.ScalableBaseline | int
        scalable_constrained_baseline: ReportH264VideoEncodingCapabilities.ScalableConstrainedBaseline | int
        scalable_high: ReportH264VideoEncodingCapabilities.ScalableHigh | int
        scalable_constrained_high: ReportH264VideoEncodingCapabilities.ScalableConstrainedHigh | int
        scalable_high_intra: ReportH264VideoEncodingCapabilities.ScalableHighIntra | int
        stereo_high: ReportH264VideoEncodingCapabilities.StereoHigh | int
        multiview_high: ReportH264VideoEncodingCapabilities.MultiviewHigh | int
        reserved_bits: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "I",
                (
                    rt.Bit("baseline", 0, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Baseline)),
                    rt.Bit("constrained_baseline", 1, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.ConstrainedBaseline)),
                    rt.Bit("main", 2, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Main)),
                    rt.Bit("extended", 3, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Extended)),
                    rt.Bit("high", 4, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.High)),
                    rt.Bit("progressive_high", 5, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.ProgressiveHigh)),
                    rt.Bit("constrained_high", 6, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.ConstrainedHigh)),
                    rt.Bit("high10", 7, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.High10)),
                    rt.Bit("high422", 8, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.High422)),
                    rt.Bit("high444_predictive", 9, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.High444Predictive)),
                    rt.Bit("high10_intra", 10, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.High10Intra)),
                    rt.Bit("high422_intra", 11, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.High422Intra)),
                    rt.Bit("high444_intra", 12, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.High444Intra)),
                    rt.Bit("cavlc444", 13, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.CAVLC444)),
                    rt.Bit("scalable_baseline", 14, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.ScalableBaseline)),
                    rt.Bit("scalable_constrained_baseline", 15, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.ScalableConstrainedBaseline)),
                    rt.Bit("scalable_high", 16, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.ScalableHigh)),
                    rt.Bit("scalable_constrained_high", 17, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.ScalableConstrainedHigh)),
                    rt.Bit("scalable_high_intra", 18, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.ScalableHighIntra)),
                    rt.Bit("stereo_high", 19, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.StereoHigh)),
                    rt.Bit("multiview_high", 20, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.MultiviewHigh)),
                ),
            )

    class Level_1(IntEnum):
        """Values of Level_1."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_1B(IntEnum):
        """Values of Level_1B."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_11(IntEnum):
        """Values of Level_11."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_12(IntEnum):
        """Values of Level_12."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_13(IntEnum):
        """Values of Level_13."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_2(IntEnum):
        """Values of Level_2."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_21(IntEnum):
        """Values of Level_21."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_22(IntEnum):
        """Values of Level_22."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_3(IntEnum):
        """Values of Level_3."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_31(IntEnum):
        """Values of Level_31."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_32(IntEnum):
        """Values of Level_32."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_4(IntEnum):
        """Values of Level_4."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_41(IntEnum):
        """Values of Level_41."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_42(IntEnum):
        """Values of Level_42."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_5(IntEnum):
        """Values of Level_5."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_51(IntEnum):
        """Values of Level_51."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_52(IntEnum):
        """Values of Level_52."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_6(IntEnum):
        """Values of Level_6."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_61(IntEnum):
        """Values of Level_61."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Level_62(IntEnum):
        """Values of Level_62."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class SupportedLevels(rt.Struct):
        """Levels of size and rate that the encoder offers.

        level_1: bit 0. Level 1.
        level_1_b: bit 1. Level 1B.
        level_11: bit 2. Level 1.1.
        level_12: bit 3. Level 1.2.
        level_13: bit 4. Level 1.3.
        level_2: bit 5. Level 2.
        level_21: bit 6. Level 2.1.
        level_22: bit 7. Level 2.2.
        level_3: bit 8. Level 3.
        level_31: bit 9. Level 3.1.
        level_32: bit 10. Level 3.2.
        level_4: bit 11. Level 4.
        level_41: bit 12. Level 4.1.
        level_42: bit 13. Level 4.2.
        level_5: bit 14. Level 5.
        level_51: bit 15. Level 5.1.
        level_52: bit 16. Level 5.2.
        level_6: bit 17. Level 6.
        level_61: bit 18. Level 6.1.
        level_62: bit 19. Level 6.2.
        """

        level_1: ReportH264VideoEncodingCapabilities.Level_1 | int
        level_1_b: ReportH264VideoEncodingCapabilities.Level_1B | int
        level_11: ReportH264VideoEncodingCapabilities.Level_11 | int
        level_12: ReportH264VideoEncodingCapabilities.Level_12 | int
        level_13: ReportH264VideoEncodingCapabilities.Level_13 | int
        level_2: ReportH264VideoEncodingCapabilities.Level_2 | int
        level_21: ReportH264VideoEncodingCapabilities.Level_21 | int
        level_22: ReportH264VideoEncodingCapabilities.Level_22 | int
        level_3: ReportH264VideoEncodingCapabilities.Level_3 | int
        level_31: ReportH264VideoEncodingCapabilities.Level_31 | int
        level_32: ReportH264VideoEncodingCapabilities.Level_32 | int
        level_4: ReportH264VideoEncodingCapabilities.Level_4 | int
        level_41: ReportH264VideoEncodingCapabilities.Level_41 | int
        level_42: ReportH264VideoEncodingCapabilities.Level_42 | int
        level_5: ReportH264VideoEncodingCapabilities.Level_5 | int
        level_51: ReportH264VideoEncodingCapabilities.Level_51 | int
        level_52: ReportH264VideoEncodingCapabilities.Level_52 | int
        level_6: ReportH264VideoEncodingCapabilities.Level_6 | int
        level_61: ReportH264VideoEncodingCapabilities.Level_61 | int
        level_62: ReportH264VideoEncodingCapabilities.Level_62 | int
        reserved_bits: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "I",
                (
                    rt.Bit("level_1", 0, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_1)),
                    rt.Bit("level_1_b", 1, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_1B)),
                    rt.Bit("level_11", 2, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_11)),
                    rt.Bit("level_12", 3, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_12)),
                    rt.Bit("level_13", 4, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_13)),
                    rt.Bit("level_2", 5, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_2)),
                    rt.Bit("level_21", 6, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_21)),
                    rt.Bit("level_22", 7, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_22)),
                    rt.Bit("level_3", 8, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_3)),
                    rt.Bit("level_31", 9, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_31)),
                    rt.Bit("level_32", 10, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_32)),
                    rt.Bit("level_4", 11, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_4)),
                    rt.Bit("level_41", 12, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_41)),
                    rt.Bit("level_42", 13, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_42)),
                    rt.Bit("level_5", 14, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_5)),
                    rt.Bit("level_51", 15, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_51)),
                    rt.Bit("level_52", 16, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_52)),
                    rt.Bit("level_6", 17, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_6)),
                    rt.Bit("level_61", 18, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_61)),
                    rt.Bit("level_62", 19, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Level_62)),
                ),
            )

    class LowLatency(IntEnum):
        """Values of LowLatency."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class SlowComms(IntEnum):
        """Values of SlowComms."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class PersistentStare(IntEnum):
        """Values of PersistentStare."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class DriveVision(IntEnum):
        """Values of DriveVision."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Manipulation(IntEnum):
        """Values of Manipulation."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class BestQuality(IntEnum):
        """Values of BestQuality."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class SupportedPresets(rt.Struct):
        """Purposes that the encoder can be tuned for.

        low_latency: bit 0. Least delay.
        slow_comms: bit 1. Slow links.
        persistent_stare: bit 2. Watching a place for long.
        drive_vision: bit 3. Driving.
        manipulation: bit 4. Manipulating.
        best_quality: bit 5. Best image.
        reserved: bits 6..11. Sent as 0, ignored when received.
        program_specific: bits 12..15. Of meaning to the maker alone.
        """

        low_latency: ReportH264VideoEncodingCapabilities.LowLatency | int
        slow_comms: ReportH264VideoEncodingCapabilities.SlowComms | int
        persistent_stare: ReportH264VideoEncodingCapabilities.PersistentStare | int
        drive_vision: ReportH264VideoEncodingCapabilities.DriveVision | int
        manipulation: ReportH264VideoEncodingCapabilities.Manipulation | int
        best_quality: ReportH264VideoEncodingCapabilities.BestQuality | int
        reserved: int
        program_specific: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Bits(
                cls,
                "H",
                (
                    rt.Bit("low_latency", 0, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.LowLatency)),
                    rt.Bit("slow_comms", 1, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.SlowComms)),
                    rt.Bit("persistent_stare", 2, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.PersistentStare)),
                    rt.Bit("drive_vision", 3, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.DriveVision)),
                    rt.Bit("manipulation", 4, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.Manipulation)),
                    rt.Bit("best_quality", 5, 0x1, rt.Values(ReportH264VideoEncodingCapabilities.BestQuality)),
                    rt.Bit("reserved", 6, 0x3F, rt.Values(None, ((0, 63),))),
                    rt.Bit("program_specific", 12, 0xF, rt.Values(None, ((0, 15),))),
                ),
            )

    class GroupOfPicturesSupported(IntEnum):
        """Values of GroupOfPicturesSupported."""

        FALSE = 0
        TRUE = 1

    class GradualDecoderRefreshSupported(IntEnum):
        """Values of GradualDecoderRefreshSupported."""

        FALSE = 0
        TRUE = 1

    class RegionOfInterestSupported(IntEnum):
        """Values of RegionOfInterestSupported."""

        FALSE = 0
        TRUE = 1

    @dataclass(slots=True, repr=False)
    class H264CapabilitiesRec(rt.Struct):
        """H264CapabilitiesRec.

        sensor_id: Identifies the sensor
        supported_profiles: optional. Sets of coding tools that the encoder offers
        supported_levels: optional. Levels of size and rate that the encoder offers
        supported_presets: optional. Purposes that the encoder can be tuned for
        group_of_pictures_supported: GroupOfPicturesSupported, optional. Whether the distance of complete frames can be set
        gradual_decoder_refresh_supported: GradualDecoderRefreshSupported, optional. Whether frames can be refreshed part by part
        region_of_interest_supported: RegionOfInterestSupported, optional. Whether part of the image can be coded better than the rest
        """

        sensor_id: int
        supported_profiles: ReportH264VideoEncodingCapabilities.SupportedProfiles | None = None
        supported_levels: ReportH264VideoEncodingCapabilities.SupportedLevels | None = None
        supported_presets: ReportH264VideoEncodingCapabilities.SupportedPresets | None = None
        group_of_pictures_supported: ReportH264VideoEncodingCapabilities.GroupOfPicturesSupported | int | None = None
        gradual_decoder_refresh_supported: ReportH264VideoEncodingCapabilities.GradualDecoderRefreshSupported | int | None = None
        region_of_interest_supported: ReportH264VideoEncodingCapabilities.RegionOfInterestSupported | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H")),
                ("SupportedProfiles", ReportH264VideoEncodingCapabilities.SupportedProfiles.layout(), True),
                ("SupportedLevels", ReportH264VideoEncodingCapabilities.SupportedLevels.layout(), True),
                ("SupportedPresets", ReportH264VideoEncodingCapabilities.SupportedPresets.layout(), True),
                ("GroupOfPicturesSupported", rt.Number("B", rt.Values(ReportH264VideoEncodingCapabilities.GroupOfPicturesSupported)), True),
                ("GradualDecoderRefreshSupported", rt.Number("B", rt.Values(ReportH264VideoEncodingCapabilities.GradualDecoderRefreshSupported)), True),
                ("RegionOfInterestSupported", rt.Number("B", rt.Values(ReportH264VideoEncodingCapabilities.RegionOfInterestSupported)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportH264VideoEncodingCapabilities_H264CapabilitiesRec_0[mask & 0x3F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.sensor_id = raw()
            if mask & 1:
                supported_profiles_ = raw()
                self.supported_profiles = ReportH264VideoEncodingCapabilities.SupportedProfiles(_E_ReportH264VideoEncodingCapabilities_Baseline.get(supported_profiles_ & 0x1, supported_profiles_ & 0x1), _E_ReportH264VideoEncodingCapabilities_ConstrainedBaseline.get(supported_profiles_ >> 1 & 0x1, supported_profiles_ >> 1 & 0x1), _E_ReportH264VideoEncodingCapabilities_Main.get(supported_profiles_ >> 2 & 0x1, supported_profiles_ >> 2 & 0x1), _E_ReportH264VideoEncodingCapabilities_Extended.get(supported_profiles_ >> 3 & 0x1, supported_profiles_ >> 3 & 0x1), _E_ReportH264VideoEncodingCapabilities_High.get(supported_profiles_ >> 4 & 0x1, supported_profiles_ >> 4 & 0x1), _E_ReportH264VideoEncodingCapabilities_ProgressiveHigh.get(supported_profiles_ >> 5 & 0x1, supported_profiles_ >> 5 & 0x1), _E_ReportH264VideoEncodingCapabilities_ConstrainedHigh.get(supported_profiles_ >> 6 & 0x1, supported_profiles_ >> 6 & 0x1), _E_ReportH264VideoEncodingCapabilities_High10.get(supported_profiles_ >> 7 & 0x1, supported_profiles_ >> 7 & 0x1), _E_ReportH264VideoEncodingCapabilities_High422.get(supported_profiles_ >> 8 & 0x1, supported_profiles_ >> 8 & 0x1), _E_ReportH264VideoEncodingCapabilities_High444Predictive.get(supported_profiles_ >> 9 & 0x1, supported_profiles_ >> 9 & 0x1), _E_ReportH264VideoEncodingCapabilities_High10Intra.get(supported_profiles_ >> 10 & 0x1, supported_profiles_ >> 10 & 0x1), _E_ReportH264VideoEncodingCapabilities_High422Intra.get(supported_profiles_ >> 11 & 0x1, supported_profiles_ >> 11 & 0x1), _E_ReportH264VideoEncodingCapabilities_High444Intra.get(supported_profiles_ >> 12 & 0x1, supported_profiles_ >> 12 & 0x1), _E_ReportH264VideoEncodingCapabilities_CAVLC444.get(supported_profiles_ >> 13 & 0x1, supported_profiles_ >> 13 & 0x1), _E_ReportH264VideoEncodingCapabilities_ScalableBaseline.get(supported_profiles_ >> 14 & 0x1, supported_profiles_ >> 14 & 0x1), _E_ReportH264VideoEncodingCapabilities_ScalableConstrainedBaseline.get(supported_profiles_ >> 15 & 0x1, supported_profiles_ >> 15 & 0x1), _E_ReportH264VideoEncodingCapabilities_ScalableHigh.get(supported_profiles_ >> 16 & 0x1, supported_profiles_ >> 16 & 0x1), _E_ReportH264VideoEncodingCapabilities_ScalableConstrainedHigh.get(supported_profiles_ >> 17 & 0x1, supported_profiles_ >> 17 & 0x1), _E_ReportH264VideoEncodingCapabilities_ScalableHighIntra.get(supported_profiles_ >> 18 & 0x1, supported_profiles_ >> 18 & 0x1), _E_ReportH264VideoEncodingCapabilities_StereoHigh.get(supported_profiles_ >> 19 & 0x1, supported_profiles_ >> 19 & 0x1), _E_ReportH264VideoEncodingCapabilities_MultiviewHigh.get(supported_profiles_ >> 20 & 0x1, supported_profiles_ >> 20 & 0x1), supported_profiles_ & 0xFFE00000)
            else: self.supported_profiles = None
            if mask & 2:
                supported_levels_ = raw()
                self.supported_levels = ReportH264VideoEncodingCapabilities.SupportedLevels(_E_ReportH264VideoEncodingCapabilities_Level_1.get(supported_levels_ & 0x1, supported_levels_ & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_1B.get(supported_levels_ >> 1 & 0x1, supported_levels_ >> 1 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_11.get(supported_levels_ >> 2 & 0x1, supported_levels_ >> 2 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_12.get(supported_levels_ >> 3 & 0x1, supported_levels_ >> 3 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_13.get(supported_levels_ >> 4 & 0x1, supported_levels_ >> 4 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_2.get(supported_levels_ >> 5 & 0x1, supported_levels_ >> 5 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_21.get(supported_levels_ >> 6 & 0x1, supported_levels_ >> 6 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_22.get(supported_levels_ >> 7 & 0x1, supported_levels_ >> 7 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_3.get(supported_levels_ >> 8 & 0x1, supported_levels_ >> 8 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_31.get(supported_levels_ >> 9 & 0x1, supported_levels_ >> 9 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_32.get(supported_levels_ >> 10 & 0x1, supported_levels_ >> 10 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_4.get(supported_levels_ >> 11 & 0x1, supported_levels_ >> 11 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_41.get(supported_levels_ >> 12 & 0x1, supported_levels_ >> 12 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_42.get(supported_levels_ >> 13 & 0x1, supported_levels_ >> 13 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_5.get(supported_levels_ >> 14 & 0x1, supported_levels_ >> 14 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_51.get(supported_levels_ >> 15 & 0x1, supported_levels_ >> 15 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_52.get(supported_levels_ >> 16 & 0x1, supported_levels_ >> 16 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_6.get(supported_levels_ >> 17 & 0x1, supported_levels_ >> 17 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_61.get(supported_levels_ >> 18 & 0x1, supported_levels_ >> 18 & 0x1), _E_ReportH264VideoEncodingCapabilities_Level_62.get(supported_levels_ >> 19 & 0x1, supported_levels_ >> 19 & 0x1), supported_levels_ & 0xFFF00000)
            else: self.supported_levels = None
            if mask & 4:
                supported_presets_ = raw()
                self.supported_presets = ReportH264VideoEncodingCapabilities.SupportedPresets(_E_ReportH264VideoEncodingCapabilities_LowLatency.get(supported_presets_ & 0x1, supported_presets_ & 0x1), _E_ReportH264VideoEncodingCapabilities_SlowComms.get(supported_presets_ >> 1 & 0x1, supported_presets_ >> 1 & 0x1), _E_ReportH264VideoEncodingCapabilities_PersistentStare.get(supported_presets_ >> 2 & 0x1, supported_presets_ >> 2 & 0x1), _E_ReportH264VideoEncodingCapabilities_DriveVision.get(supported_presets_ >> 3 & 0x1, supported_presets_ >> 3 & 0x1), _E_ReportH264VideoEncodingCapabilities_Manipulation.get(supported_presets_ >> 4 & 0x1, supported_presets_ >> 4 & 0x1), _E_ReportH264VideoEncodingCapabilities_BestQuality.get(supported_presets_ >> 5 & 0x1, supported_presets_ >> 5 & 0x1), supported_presets_ >> 6 & 0x3F, supported_presets_ >> 12 & 0xF)
            else: self.supported_presets = None
            if mask & 8:
                group_of_pictures_supported_ = raw()
                self.group_of_pictures_supported = _E_ReportH264VideoEncodingCapabilities_GroupOfPicturesSupported[group_of_pictures_supported_]
            else: self.group_of_pictures_supported = None
            if mask & 16:
                gradual_decoder_refresh_supported_ = raw()
                self.gradual_decoder_refresh_supported = _E_ReportH264VideoEncodingCapabilities_GradualDecoderRefreshSupported[gradual_decoder_refresh_supported_]
            else: self.gradual_decoder_refresh_supported = None
            if mask & 32:
                region_of_interest_supported_ = raw()
                self.region_of_interest_supported = _E_ReportH264VideoEncodingCapabilities_RegionOfInterestSupported[region_of_interest_supported_]
            else: self.region_of_interest_supported = None
            self.reserved_presence = mask & 0xC0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3F: raise rt.Reject
            raw: list[int | float | bytes] = []
            raw.append(self.sensor_id)
            supported_profiles_ = self.supported_profiles
            if supported_profiles_ is not None:
                mask |= 1
                if type(supported_profiles_) is not ReportH264VideoEncodingCapabilities.SupportedProfiles: raise rt.Reject
                baseline_ = supported_profiles_.baseline
                if not 0 <= baseline_ <= 1: raise rt.Reject
                constrained_baseline_ = supported_profiles_.constrained_baseline
                if not 0 <= constrained_baseline_ <= 1: raise rt.Reject
                main_ = supported_profiles_.main
                if not 0 <= main_ <= 1: raise rt.Reject
                extended_ = supported_profiles_.extended
                if not 0 <= extended_ <= 1: raise rt.Reject
                high_ = supported_profiles_.high
                if not 0 <= high_ <= 1: raise rt.Reject
                progressive_high_ = supported_profiles_.progressive_high
                if not 0 <= progressive_high_ <= 1: raise rt.Reject
                constrained_high_ = supported_profiles_.constrained_high
                if not 0 <= constrained_high_ <= 1: raise rt.Reject
                high10_ = supported_profiles_.high10
                if not 0 <= high10_ <= 1: raise rt.Reject
                high422_ = supported_profiles_.high422
                if not 0 <= high422_ <= 1: raise rt.Reject
                high444_predictive_ = supported_profiles_.high444_predictive
                if not 0 <= high444_predictive_ <= 1: raise rt.Reject
                high10_intra_ = supported_profiles_.high10_intra
                if not 0 <= high10_intra_ <= 1: raise rt.Reject
                high422_intra_ = supported_profiles_.high422_intra
                if not 0 <= high422_intra_ <= 1: raise rt.Reject
                high444_intra_ = supported_profiles_.high444_intra
                if not 0 <= high444_intra_ <= 1: raise rt.Reject
                cavlc444_ = supported_profiles_.cavlc444
                if not 0 <= cavlc444_ <= 1: raise rt.Reject
                scalable_baseline_ = supported_profiles_.scalable_baseline
                if not 0 <= scalable_baseline_ <= 1: raise rt.Reject
                scalable_constrained_baseline_ = supported_profiles_.scalable_constrained_baseline
                if not 0 <= scalable_constrained_baseline_ <= 1: raise rt.Reject
                scalable_high_ = supported_profiles_.scalable_high
                if not 0 <= scalable_high_ <= 1: raise rt.Reject
                scalable_constrained_high_ = supported_profiles_.scalable_constrained_high
                if not 0 <= scalable_constrained_high_ <= 1: raise rt.Reject
                scalable_high_intra_ = supported_profiles_.scalable_high_intra
                if not 0 <= scalable_high_intra_ <= 1: raise rt.Reject
                stereo_high_ = supported_profiles_.stereo_high
                if not 0 <= stereo_high_ <= 1: raise rt.Reject
                multiview_high_ = supported_profiles_.multiview_high
                if not 0 <= multiview_high_ <= 1: raise rt.Reject
                reserved_bits_ = supported_profiles_.reserved_bits
                if reserved_bits_ & 0x1FFFFF: raise rt.Reject
                raw.append(baseline_ | constrained_baseline_ << 1 | main_ << 2 | extended_ << 3 | high_ << 4 | progressive_high_ << 5 | constrained_high_ << 6 | high10_ << 7 | high422_ << 8 | high444_predictive_ << 9 | high10_intra_ << 10 | high422_intra_ << 11 | high444_intra_ << 12 | cavlc444_ << 13 | scalable_baseline_ << 14 | scalable_constrained_baseline_ << 15 | scalable_high_ << 16 | scalable_constrained_high_ << 17 | scalable_high_intra_ << 18 | stereo_high_ << 19 | multiview_high_ << 20 | reserved_bits_)
            supported_levels_ = self.supported_levels
            if supported_levels_ is not None:
                mask |= 2
                if type(supported_levels_) is not ReportH264VideoEncodingCapabilities.SupportedLevels: raise rt.Reject
                level_1_ = supported_levels_.level_1
                if not 0 <= level_1_ <= 1: raise rt.Reject
                level_1_b_ = supported_levels_.level_1_b
                if not 0 <= level_1_b_ <= 1: raise rt.Reject
                level_11_ = supported_levels_.level_11
                if not 0 <= level_11_ <= 1: raise rt.Reject
                level_12_ = supported_levels_.level_12
                if not 0 <= level_12_ <= 1: raise rt.Reject
                level_13_ = supported_levels_.level_13
                if not 0 <= level_13_ <= 1: raise rt.Reject
                level_2_ = supported_levels_.level_2
                if not 0 <= level_2_ <= 1: raise rt.Reject
                level_21_ = supported_levels_.level_21
                if not 0 <= level_21_ <= 1: raise rt.Reject
                level_22_ = supported_levels_.level_22
                if not 0 <= level_22_ <= 1: raise rt.Reject
                level_3_ = supported_levels_.level_3
                if not 0 <= level_3_ <= 1: raise rt.Reject
                level_31_ = supported_levels_.level_31
                if not 0 <= level_31_ <= 1: raise rt.Reject
                level_32_ = supported_levels_.level_32
                if not 0 <= level_32_ <= 1: raise rt.Reject
                level_4_ = supported_levels_.level_4
                if not 0 <= level_4_ <= 1: raise rt.Reject
                level_41_ = supported_levels_.level_41
                if not 0 <= level_41_ <= 1: raise rt.Reject
                level_42_ = supported_levels_.level_42
                if not 0 <= level_42_ <= 1: raise rt.Reject
                level_5_ = supported_levels_.level_5
                if not 0 <= level_5_ <= 1: raise rt.Reject
                level_51_ = supported_levels_.level_51
                if not 0 <= level_51_ <= 1: raise rt.Reject
                level_52_ = supported_levels_.level_52
                if not 0 <= level_52_ <= 1: raise rt.Reject
                level_6_ = supported_levels_.level_6
                if not 0 <= level_6_ <= 1: raise rt.Reject
                level_61_ = supported_levels_.level_61
                if not 0 <= level_61_ <= 1: raise rt.Reject
                level_62_ = supported_levels_.level_62
                if not 0 <= level_62_ <= 1: raise rt.Reject
                reserved_bits_2_ = supported_levels_.reserved_bits
                if reserved_bits_2_ & 0xFFFFF: raise rt.Reject
                raw.append(level_1_ | level_1_b_ << 1 | level_11_ << 2 | level_12_ << 3 | level_13_ << 4 | level_2_ << 5 | level_21_ << 6 | level_22_ << 7 | level_3_ << 8 | level_31_ << 9 | level_32_ << 10 | level_4_ << 11 | level_41_ << 12 | level_42_ << 13 | level_5_ << 14 | level_51_ << 15 | level_52_ << 16 | level_6_ << 17 | level_61_ << 18 | level_62_ << 19 | reserved_bits_2_)
            supported_presets_ = self.supported_presets
            if supported_presets_ is not None:
                mask |= 4
                if type(supported_presets_) is not ReportH264VideoEncodingCapabilities.SupportedPresets: raise rt.Reject
                low_latency_ = supported_presets_.low_latency
                if not 0 <= low_latency_ <= 1: raise rt.Reject
                slow_comms_ = supported_presets_.slow_comms
                if not 0 <= slow_comms_ <= 1: raise rt.Reject
                persistent_stare_ = supported_presets_.persistent_stare
                if not 0 <= persistent_stare_ <= 1: raise rt.Reject
                drive_vision_ = supported_presets_.drive_vision
                if not 0 <= drive_vision_ <= 1: raise rt.Reject
                manipulation_ = supported_presets_.manipulation
                if not 0 <= manipulation_ <= 1: raise rt.Reject
                best_quality_ = supported_presets_.best_quality
                if not 0 <= best_quality_ <= 1: raise rt.Reject
                reserved_ = supported_presets_.reserved
                if not 0 <= reserved_ <= 63: raise rt.Reject
                program_specific_ = supported_presets_.program_specific
                if not 0 <= program_specific_ <= 15: raise rt.Reject
                raw.append(low_latency_ | slow_comms_ << 1 | persistent_stare_ << 2 | drive_vision_ << 3 | manipulation_ << 4 | best_quality_ << 5 | reserved_ << 6 | program_specific_ << 12)
            group_of_pictures_supported_ = self.group_of_pictures_supported
            if group_of_pictures_supported_ is not None:
                mask |= 8
                if group_of_pictures_supported_ not in _E_ReportH264VideoEncodingCapabilities_GroupOfPicturesSupported: raise rt.Reject
                raw.append(group_of_pictures_supported_)
            gradual_decoder_refresh_supported_ = self.gradual_decoder_refresh_supported
            if gradual_decoder_refresh_supported_ is not None:
                mask |= 16
                if gradual_decoder_refresh_supported_ not in _E_ReportH264VideoEncodingCapabilities_GradualDecoderRefreshSupported: raise rt.Reject
                raw.append(gradual_decoder_refresh_supported_)
            region_of_interest_supported_ = self.region_of_interest_supported
            if region_of_interest_supported_ is not None:
                mask |= 32
                if region_of_interest_supported_ not in _E_ReportH264VideoEncodingCapabilities_RegionOfInterestSupported: raise rt.Reject
                raw.append(region_of_interest_supported_)
            out += _M_ReportH264VideoEncodingCapabilities_H264CapabilitiesRec_0[mask & 0x3F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    h264_capabilities_list: list[ReportH264VideoEncodingCapabilities.H264CapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("H264CapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), ReportH264VideoEncodingCapabilities.H264CapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0E or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (h264_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        if h264_capabilities_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        h264_capabilities_list_ = []
        for _ in range(h264_capabilities_list_count_):
            item_, at = ReportH264VideoEncodingCapabilities.H264CapabilitiesRec._read(data, at, nesting)
            h264_capabilities_list_.append(item_)
        self.h264_capabilities_list = h264_capabilities_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0e\x48")
        h264_capabilities_list_ = self.h264_capabilities_list
        if type(h264_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(h264_capabilities_list_))
        for item_ in h264_capabilities_list_:
            if type(item_) is not ReportH264VideoEncodingCapabilities.H264CapabilitiesRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportH264VideoEncodingConfiguration(rt.Message):
    """ReportH264VideoEncodingConfiguration (0x480D): Tells the configuration of H.264 encoders.

    h264_configuration_list: 0..65535 items. The encoders
    """

    CODE = 0x480D
    NAME = "ReportH264VideoEncodingConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:H264VideoEncoding"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Profile(IntEnum):
        """Values of Profile."""

        BASELINE = 0
        CONSTRAINED_BASELINE = 1
        MAIN = 2
        EXTENDED = 3
        HIGH = 4
        PROGRESSIVE_HIGH = 5
        CONSTRAINED_HIGH = 6
        HIGH_10 = 7
        HIGH_422 = 8
        HIGH_444_PREDICTIVE = 9
        HIGH_10_INTRA = 10
        HIGH_422_INTRA = 11
        HIGH_444_INTRA = 12
        CAVLC444 = 13
        SCALABLE_BASELINE = 14
        SCALABLE_CONSTRAINED_BASELINE = 15
        SCALABLE_HIGH = 16
        SCALABLE_CONSTRAINED_HIGH = 17
        SCALABLE_HIGH_INTRA = 18
        STEREO_HIGH = 19
        MULTIVIEW_HIGH = 20

    class Level(IntEnum):
        """Values of Level."""

        LEVEL_1 = 0
        LEVEL_1_B = 1
        LEVEL_11 = 2
        LEVEL_12 = 3
        LEVEL_13 = 4
        LEVEL_2 = 5
        LEVEL_21 = 6
        LEVEL_22 = 7
        LEVEL_3 = 8
        LEVEL_31 = 9
        LEVEL_32 = 10
        LEVEL_4 = 11
        LEVEL_41 = 12
        LEVEL_42 = 13
        LEVEL_5 = 14
        LEVEL_51 = 15
        LEVEL_52 = 16
        LEVEL_6 = 17
        LEVEL_61 = 18
        LEVEL_62 = 19

    class Preset(IntEnum):
        """Values of Preset."""

        LOW_LATENCY = 0
        SLOW_COMMS = 1
        PERSISTENT_STARE = 2
        DRIVE_VISION = 3
        MANIPULATION = 4
        BEST_QUALITY = 5
        PROGRAMSPECIFIC_1 = 12
        PROGRAMSPECIFIC_2 = 13
        PROGRAMSPECIFIC_3 = 14
        PROGRAMSPECIFIC_4 = 15

    class GradualDecoderRefreshOnOff(IntEnum):
        """Values of GradualDecoderRefreshOnOff."""

        OFF = 0
        ON = 1

    class RegionOfInterestOnOff(IntEnum):
        """Values of RegionOfInterestOnOff."""

        OFF = 0
        ON = 1

    @dataclass(slots=True, repr=False)
    class H264ConfigurationRec(rt.Struct):
        """Settings of one encoder.

        sensor_id: Identifies the sensor
        profile: Profile, optional. Set of coding tools
        level: Level, optional. Level of size and rate
        preset: Preset, optional. Purpose that the encoder is tuned for
        group_of_pictures: optional. Number of frames from one complete frame to the next
        gradual_decoder_refresh_on_off: GradualDecoderRefreshOnOff, optional. Whether frames are refreshed part by part instead of by complete frames
        region_of_interest_on_off: RegionOfInterestOnOff, optional. Whether part of the image is coded better than the rest
        intra_macro_refresh: 0..100, optional. Blocks that are refreshed in each frame, in percent
        """

        sensor_id: int
        profile: ReportH264VideoEncodingConfiguration.Profile | int | None = None
        level: ReportH264VideoEncodingConfiguration.Level | int | None = None
        preset: ReportH264VideoEncodingConfiguration.Preset | int | None = None
        group_of_pictures: int | None = None
        gradual_decoder_refresh_on_off: ReportH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff | int | None = None
        region_of_interest_on_off: ReportH264VideoEncodingConfiguration.RegionOfInterestOnOff | int | None = None
        intra_macro_refresh: float | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H")),
                ("Profile", rt.Number("B", rt.Values(ReportH264VideoEncodingConfiguration.Profile)), True),
                ("Level", rt.Number("I", rt.Values(ReportH264VideoEncodingConfiguration.Level)), True),
                ("Preset", rt.Number("B", rt.Values(ReportH264VideoEncodingConfiguration.Preset)), True),
                ("GroupOfPictures", rt.Number("B"), True),
                ("GradualDecoderRefreshOnOff", rt.Number("B", rt.Values(ReportH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff)), True),
                ("RegionOfInterestOnOff", rt.Number("B", rt.Values(ReportH264VideoEncodingConfiguration.RegionOfInterestOnOff)), True),
                ("IntraMacroRefresh", rt.real("H", 0.0, 100.0), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetH264VideoEncodingConfiguration_H264ConfigurationRec_0[mask & 0x7F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            self.sensor_id = raw()
            if mask & 1:
                profile_ = raw()
                self.profile = _E_ReportH264VideoEncodingConfiguration_Profile[profile_]
            else: self.profile = None
            if mask & 2:
                level_ = raw()
                self.level = _E_ReportH264VideoEncodingConfiguration_Level[level_]
            else: self.level = None
            if mask & 4:
                preset_ = raw()
                self.preset = _E_ReportH264VideoEncodingConfiguration_Preset[preset_]
            else: self.preset = None
            self.group_of_pictures = raw() if mask & 8 else None
            if mask & 16:
                gradual_decoder_refresh_on_off_ = raw()
                self.gradual_decoder_refresh_on_off = _E_ReportH264VideoEncodingConfiguration_GradualDecoderRefreshOnOff[gradual_decoder_refresh_on_off_]
            else: self.gradual_decoder_refresh_on_off = None
            if mask & 32:
                region_of_interest_on_off_ = raw()
                self.region_of_interest_on_off = _E_ReportH264VideoEncodingConfiguration_RegionOfInterestOnOff[region_of_interest_on_off_]
            else: self.region_of_interest_on_off = None
            self.intra_macro_refresh = raw() * 0.0015259021896696422 if mask & 64 else None
            self.reserved_presence = mask & 0x80
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7F: raise rt.Reject
            raw: list[int | float | bytes] = []
            raw.append(self.sensor_id)
            profile_ = self.profile
            if profile_ is not None:
                mask |= 1
                if profile_ not in _E_ReportH264VideoEncodingConfiguration_Profile: raise rt.Reject
                raw.append(profile_)
            level_ = self.level
            if level_ is not None:
                mask |= 2
                if level_ not in _E_ReportH264VideoEncodingConfiguration_Level: raise rt.Reject
                raw.append(level_)
            preset_ = self.preset
            if preset_ is not None:
                mask |= 4
                if preset_ not in _E_ReportH264VideoEncodingConfiguration_Preset: raise rt.Reject
                raw.append(preset_)
            group_of_pictures_ = self.group_of_pictures
            if group_of_pictures_ is not None:
                mask |= 8
                raw.append(group_of_pictures_)
            gradual_decoder_refresh_on_off_ = self.gradual_decoder_refresh_on_off
            if gradual_decoder_refresh_on_off_ is not None:
                mask |= 16
                if gradual_decoder_refresh_on_off_ not in _E_ReportH264VideoEncodingConfiguration_GradualDecoderRefreshOnOff: raise rt.Reject
                raw.append(gradual_decoder_refresh_on_off_)
            region_of_interest_on_off_ = self.region_of_interest_on_off
            if region_of_interest_on_off_ is not None:
                mask |= 32
                if region_of_interest_on_off_ not in _E_ReportH264VideoEncodingConfiguration_RegionOfInterestOnOff: raise rt.Reject
                raw.append(region_of_interest_on_off_)
            intra_macro_refresh_ = self.intra_macro_refresh
            if intra_macro_refresh_ is not None:
                mask |= 64
                if not 0.0 <= intra_macro_refresh_ <= 100.0: raise rt.Reject
                near = intra_macro_refresh_ * 655.35 + 0.5
                intra_macro_refresh_raw_ = int(near)
                if not 1.52587890625e-05 < near - intra_macro_refresh_raw_ < 0.9999847412109375: intra_macro_refresh_raw_ = rt.exact_raw(intra_macro_refresh_, _R_6)
                raw.append(intra_macro_refresh_raw_)
            out += _M_SetH264VideoEncodingConfiguration_H264ConfigurationRec_0[mask & 0x7F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    @dataclass(slots=True, repr=False)
    class RegionOfInterestParams(rt.Struct):
        """Part of the image that is coded better.

        x_start: 0..100 percent. Left edge of the part, in percent of the image
        y_start: 0..100 percent. Upper edge of the part, in percent of the image
        width: 0..100 percent. Width of the part, in percent of the image
        height: 0..100 percent. Height of the part, in percent of the image
        high_bit_rate: Bit rate for the part, in kilobits per second
        low_bit_rate: Bit rate for the rest of the image, in kilobits per second
        """

        x_start: float
        y_start: float
        width: float
        height: float
        high_bit_rate: int
        low_bit_rate: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("X_Start", rt.real("H", 0.0, 100.0, "percent")),
                ("Y_Start", rt.real("H", 0.0, 100.0, "percent")),
                ("Width", rt.real("H", 0.0, 100.0, "percent")),
                ("Height", rt.real("H", 0.0, 100.0, "percent")),
                ("HighBitRate", rt.Number("H")),
                ("LowBitRate", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class GradualDecoderRefreshParams(rt.Struct):
        """How frames are refreshed part by part.

        gdr_duration: Frames that one refresh takes
        gdr_interval: Frames from one refresh to the next
        """

        gdr_duration: int
        gdr_interval: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("GDR_Duration", rt.Number("H")),
                ("GDR_Interval", rt.Number("H")),
            )

    @dataclass(slots=True, repr=False)
    class H264ConfigurationSequence(rt.Struct):
        """H264ConfigurationSequence.

        h264_configuration_rec: Settings of one encoder
        region_of_interest_params: optional. Part of the image that is coded better
        gradual_decoder_refresh_params: optional. How frames are refreshed part by part
        """

        h264_configuration_rec: ReportH264VideoEncodingConfiguration.H264ConfigurationRec
        region_of_interest_params: ReportH264VideoEncodingConfiguration.RegionOfInterestParams | None = None
        gradual_decoder_refresh_params: ReportH264VideoEncodingConfiguration.GradualDecoderRefreshParams | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("H264ConfigurationRec", ReportH264VideoEncodingConfiguration.H264ConfigurationRec.layout()),
                ("RegionOfInterestParams", ReportH264VideoEncodingConfiguration.RegionOfInterestParams.layout(), True),
                ("GradualDecoderRefreshParams", ReportH264VideoEncodingConfiguration.GradualDecoderRefreshParams.layout(), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            at += 1
            self.h264_configuration_rec, at = ReportH264VideoEncodingConfiguration.H264ConfigurationRec._read(data, at, nesting)
            if mask & 1:
                x_start_, y_start_, width_, height_, high_bit_rate_, low_bit_rate_ = _S_6H.unpack_from(data, at)
                self.region_of_interest_params = ReportH264VideoEncodingConfiguration.RegionOfInterestParams(x_start_ * 0.0015259021896696422, y_start_ * 0.0015259021896696422, width_ * 0.0015259021896696422, height_ * 0.0015259021896696422, high_bit_rate_, low_bit_rate_)
                at += 12
            else: self.region_of_interest_params = None
            if mask & 2:
                gdr_duration_, gdr_interval_ = _S_2H.unpack_from(data, at)
                self.gradual_decoder_refresh_params = ReportH264VideoEncodingConfiguration.GradualDecoderRefreshParams(gdr_duration_, gdr_interval_)
                at += 4
            else: self.gradual_decoder_refresh_params = None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            h264_configuration_rec_ = self.h264_configuration_rec
            if type(h264_configuration_rec_) is not ReportH264VideoEncodingConfiguration.H264ConfigurationRec: raise rt.Reject
            h264_configuration_rec_._write(out)
            region_of_interest_params_ = self.region_of_interest_params
            if region_of_interest_params_ is not None:
                mask |= 1
                if type(region_of_interest_params_) is not ReportH264VideoEncodingConfiguration.RegionOfInterestParams: raise rt.Reject
                x_start_ = region_of_interest_params_.x_start
                if not 0.0 <= x_start_ <= 100.0: raise rt.Reject
                near = x_start_ * 655.35 + 0.5
                x_start_raw_ = int(near)
                if not 1.52587890625e-05 < near - x_start_raw_ < 0.9999847412109375: x_start_raw_ = rt.exact_raw(x_start_, _R_6)
                y_start_ = region_of_interest_params_.y_start
                if not 0.0 <= y_start_ <= 100.0: raise rt.Reject
                near = y_start_ * 655.35 + 0.5
                y_start_raw_ = int(near)
                if not 1.52587890625e-05 < near - y_start_raw_ < 0.9999847412109375: y_start_raw_ = rt.exact_raw(y_start_, _R_6)
                width_ = region_of_interest_params_.width
                if not 0.0 <= width_ <= 100.0: raise rt.Reject
                near = width_ * 655.35 + 0.5
                width_raw_ = int(near)
                if not 1.52587890625e-05 < near - width_raw_ < 0.9999847412109375: width_raw_ = rt.exact_raw(width_, _R_6)
                height_ = region_of_interest_params_.height
                if not 0.0 <= height_ <= 100.0: raise rt.Reject
                near = height_ * 655.35 + 0.5
                height_raw_ = int(near)
                if not 1.52587890625e-05 < near - height_raw_ < 0.9999847412109375: height_raw_ = rt.exact_raw(height_, _R_6)
                out += _S_6H.pack(x_start_raw_, y_start_raw_, width_raw_, height_raw_, region_of_interest_params_.high_bit_rate, region_of_interest_params_.low_bit_rate)
            gradual_decoder_refresh_params_ = self.gradual_decoder_refresh_params
            if gradual_decoder_refresh_params_ is not None:
                mask |= 2
                if type(gradual_decoder_refresh_params_) is not ReportH264VideoEncodingConfiguration.GradualDecoderRefreshParams: raise rt.Reject
                out += _S_2H.pack(gradual_decoder_refresh_params_.gdr_duration, gradual_decoder_refresh_params_.gdr_interval)
            _S_B.pack_into(out, start, mask)

    h264_configuration_list: list[ReportH264VideoEncodingConfiguration.H264ConfigurationSequence]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("H264ConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), ReportH264VideoEncodingConfiguration.H264ConfigurationSequence.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x0D or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (h264_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        if h264_configuration_list_count_ * 4 > size - 4: raise rt.Reject
        at = 4
        h264_configuration_list_ = []
        for _ in range(h264_configuration_list_count_):
            item_, at = ReportH264VideoEncodingConfiguration.H264ConfigurationSequence._read(data, at, nesting)
            h264_configuration_list_.append(item_)
        self.h264_configuration_list = h264_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x0d\x48")
        h264_configuration_list_ = self.h264_configuration_list
        if type(h264_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(h264_configuration_list_))
        for item_ in h264_configuration_list_:
            if type(item_) is not ReportH264VideoEncodingConfiguration.H264ConfigurationSequence: raise rt.Reject
            item_._write(out)
        return bytes(out)


_M_SetH264VideoEncodingConfiguration_H264ConfigurationRec_0 = rt.Masks("", ((0, "H"), (1, "B"), (2, "I"), (4, "B"), (8, "B"), (16, "B"), (32, "B"), (64, "H")))
_E_SetH264VideoEncodingConfiguration_Profile = rt.members(SetH264VideoEncodingConfiguration.Profile)
_E_SetH264VideoEncodingConfiguration_Level = rt.members(SetH264VideoEncodingConfiguration.Level)
_E_SetH264VideoEncodingConfiguration_Preset = rt.members(SetH264VideoEncodingConfiguration.Preset)
_E_SetH264VideoEncodingConfiguration_GradualDecoderRefreshOnOff = rt.members(SetH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff)
_E_SetH264VideoEncodingConfiguration_RegionOfInterestOnOff = rt.members(SetH264VideoEncodingConfiguration.RegionOfInterestOnOff)
_R_6 = rt.Scaling(0.0, 100.0, 65535)
_S_B = rt.Packer("<B")
_S_6H = rt.Packer("<6H")
_S_2H = rt.Packer("<2H")
_S_H = rt.Packer("<H")
_L_H = rt.Rows("H")
_M_ReportH264VideoEncodingCapabilities_H264CapabilitiesRec_0 = rt.Masks("", ((0, "H"), (1, "I"), (2, "I"), (4, "H"), (8, "B"), (16, "B"), (32, "B")))
_E_ReportH264VideoEncodingCapabilities_Baseline = rt.members(ReportH264VideoEncodingCapabilities.Baseline)
_E_ReportH264VideoEncodingCapabilities_ConstrainedBaseline = rt.members(ReportH264VideoEncodingCapabilities.ConstrainedBaseline)
_E_ReportH264VideoEncodingCapabilities_Main = rt.members(ReportH264VideoEncodingCapabilities.Main)
_E_ReportH264VideoEncodingCapabilities_Extended = rt.members(ReportH264VideoEncodingCapabilities.Extended)
_E_ReportH264VideoEncodingCapabilities_High = rt.members(ReportH264VideoEncodingCapabilities.High)
_E_ReportH264VideoEncodingCapabilities_ProgressiveHigh = rt.members(ReportH264VideoEncodingCapabilities.ProgressiveHigh)
_E_ReportH264VideoEncodingCapabilities_ConstrainedHigh = rt.members(ReportH264VideoEncodingCapabilities.ConstrainedHigh)
_E_ReportH264VideoEncodingCapabilities_High10 = rt.members(ReportH264VideoEncodingCapabilities.High10)
_E_ReportH264VideoEncodingCapabilities_High422 = rt.members(ReportH264VideoEncodingCapabilities.High422)
_E_ReportH264VideoEncodingCapabilities_High444Predictive = rt.members(ReportH264VideoEncodingCapabilities.High444Predictive)
_E_ReportH264VideoEncodingCapabilities_High10Intra = rt.members(ReportH264VideoEncodingCapabilities.High10Intra)
_E_ReportH264VideoEncodingCapabilities_High422Intra = rt.members(ReportH264VideoEncodingCapabilities.High422Intra)
_E_ReportH264VideoEncodingCapabilities_High444Intra = rt.members(ReportH264VideoEncodingCapabilities.High444Intra)
_E_ReportH264VideoEncodingCapabilities_CAVLC444 = rt.members(ReportH264VideoEncodingCapabilities.CAVLC444)
_E_ReportH264VideoEncodingCapabilities_ScalableBaseline = rt.members(ReportH264VideoEncodingCapabilities.ScalableBaseline)
_E_ReportH264VideoEncodingCapabilities_ScalableConstrainedBaseline = rt.members(ReportH264VideoEncodingCapabilities.ScalableConstrainedBaseline)
_E_ReportH264VideoEncodingCapabilities_ScalableHigh = rt.members(ReportH264VideoEncodingCapabilities.ScalableHigh)
_E_ReportH264VideoEncodingCapabilities_ScalableConstrainedHigh = rt.members(ReportH264VideoEncodingCapabilities.ScalableConstrainedHigh)
_E_ReportH264VideoEncodingCapabilities_ScalableHighIntra = rt.members(ReportH264VideoEncodingCapabilities.ScalableHighIntra)
_E_ReportH264VideoEncodingCapabilities_StereoHigh = rt.members(ReportH264VideoEncodingCapabilities.StereoHigh)
_E_ReportH264VideoEncodingCapabilities_MultiviewHigh = rt.members(ReportH264VideoEncodingCapabilities.MultiviewHigh)
_E_ReportH264VideoEncodingCapabilities_Level_1 = rt.members(ReportH264VideoEncodingCapabilities.Level_1)
_E_ReportH264VideoEncodingCapabilities_Level_1B = rt.members(ReportH264VideoEncodingCapabilities.Level_1B)
_E_ReportH264VideoEncodingCapabilities_Level_11 = rt.members(ReportH264VideoEncodingCapabilities.Level_11)
_E_ReportH264VideoEncodingCapabilities_Level_12 = rt.members(ReportH264VideoEncodingCapabilities.Level_12)
_E_ReportH264VideoEncodingCapabilities_Level_13 = rt.members(ReportH264VideoEncodingCapabilities.Level_13)
_E_ReportH264VideoEncodingCapabilities_Level_2 = rt.members(ReportH264VideoEncodingCapabilities.Level_2)
_E_ReportH264VideoEncodingCapabilities_Level_21 = rt.members(ReportH264VideoEncodingCapabilities.Level_21)
_E_ReportH264VideoEncodingCapabilities_Level_22 = rt.members(ReportH264VideoEncodingCapabilities.Level_22)
_E_ReportH264VideoEncodingCapabilities_Level_3 = rt.members(ReportH264VideoEncodingCapabilities.Level_3)
_E_ReportH264VideoEncodingCapabilities_Level_31 = rt.members(ReportH264VideoEncodingCapabilities.Level_31)
_E_ReportH264VideoEncodingCapabilities_Level_32 = rt.members(ReportH264VideoEncodingCapabilities.Level_32)
_E_ReportH264VideoEncodingCapabilities_Level_4 = rt.members(ReportH264VideoEncodingCapabilities.Level_4)
_E_ReportH264VideoEncodingCapabilities_Level_41 = rt.members(ReportH264VideoEncodingCapabilities.Level_41)
_E_ReportH264VideoEncodingCapabilities_Level_42 = rt.members(ReportH264VideoEncodingCapabilities.Level_42)
_E_ReportH264VideoEncodingCapabilities_Level_5 = rt.members(ReportH264VideoEncodingCapabilities.Level_5)
_E_ReportH264VideoEncodingCapabilities_Level_51 = rt.members(ReportH264VideoEncodingCapabilities.Level_51)
_E_ReportH264VideoEncodingCapabilities_Level_52 = rt.members(ReportH264VideoEncodingCapabilities.Level_52)
_E_ReportH264VideoEncodingCapabilities_Level_6 = rt.members(ReportH264VideoEncodingCapabilities.Level_6)
_E_ReportH264VideoEncodingCapabilities_Level_61 = rt.members(ReportH264VideoEncodingCapabilities.Level_61)
_E_ReportH264VideoEncodingCapabilities_Level_62 = rt.members(ReportH264VideoEncodingCapabilities.Level_62)
_E_ReportH264VideoEncodingCapabilities_LowLatency = rt.members(ReportH264VideoEncodingCapabilities.LowLatency)
_E_ReportH264VideoEncodingCapabilities_SlowComms = rt.members(ReportH264VideoEncodingCapabilities.SlowComms)
_E_ReportH264VideoEncodingCapabilities_PersistentStare = rt.members(ReportH264VideoEncodingCapabilities.PersistentStare)
_E_ReportH264VideoEncodingCapabilities_DriveVision = rt.members(ReportH264VideoEncodingCapabilities.DriveVision)
_E_ReportH264VideoEncodingCapabilities_Manipulation = rt.members(ReportH264VideoEncodingCapabilities.Manipulation)
_E_ReportH264VideoEncodingCapabilities_BestQuality = rt.members(ReportH264VideoEncodingCapabilities.BestQuality)
_E_ReportH264VideoEncodingCapabilities_GroupOfPicturesSupported = rt.members(ReportH264VideoEncodingCapabilities.GroupOfPicturesSupported)
_E_ReportH264VideoEncodingCapabilities_GradualDecoderRefreshSupported = rt.members(ReportH264VideoEncodingCapabilities.GradualDecoderRefreshSupported)
_E_ReportH264VideoEncodingCapabilities_RegionOfInterestSupported = rt.members(ReportH264VideoEncodingCapabilities.RegionOfInterestSupported)
_E_ReportH264VideoEncodingConfiguration_Profile = rt.members(ReportH264VideoEncodingConfiguration.Profile)
_E_ReportH264VideoEncodingConfiguration_Level = rt.members(ReportH264VideoEncodingConfiguration.Level)
_E_ReportH264VideoEncodingConfiguration_Preset = rt.members(ReportH264VideoEncodingConfiguration.Preset)
_E_ReportH264VideoEncodingConfiguration_GradualDecoderRefreshOnOff = rt.members(ReportH264VideoEncodingConfiguration.GradualDecoderRefreshOnOff)
_E_ReportH264VideoEncodingConfiguration_RegionOfInterestOnOff = rt.members(ReportH264VideoEncodingConfiguration.RegionOfInterestOnOff)
QueryH264VideoEncodingCapabilities.REPORT = ReportH264VideoEncodingCapabilities
QueryH264VideoEncodingConfiguration.REPORT = ReportH264VideoEncodingConfiguration
