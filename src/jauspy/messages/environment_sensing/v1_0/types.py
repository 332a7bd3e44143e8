"""Declared types that several messages share. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class SupportedAnalogFormats(rt.Struct):
    """SupportedAnalogFormats.

    ntscm: bit 0. NTSC-M.
    ntscj: bit 1. NTSC-J.
    paln: bit 2. PAL-N.
    palm: bit 3. PAL-M.
    secaml: bit 4. SECAM-L.
    secambg: bit 5. SECAM-B/G.
    """

    class NTSCM(IntEnum):
        """Values of NTSCM."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class NTSCJ(IntEnum):
        """Values of NTSCJ."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class PALN(IntEnum):
        """Values of PALN."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class PALM(IntEnum):
        """Values of PALM."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class SECAML(IntEnum):
        """Values of SECAML."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class SECAMBG(IntEnum):
        """Values of SECAMBG."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    ntscm: SupportedAnalogFormats.NTSCM | int
    ntscj: SupportedAnalogFormats.NTSCJ | int
    paln: SupportedAnalogFormats.PALN | int
    palm: SupportedAnalogFormats.PALM | int
    secaml: SupportedAnalogFormats.SECAML | int
    secambg: SupportedAnalogFormats.SECAMBG | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("ntscm", 0, 0x1, rt.Values(SupportedAnalogFormats.NTSCM)),
                rt.Bit("ntscj", 1, 0x1, rt.Values(SupportedAnalogFormats.NTSCJ)),
                rt.Bit("paln", 2, 0x1, rt.Values(SupportedAnalogFormats.PALN)),
                rt.Bit("palm", 3, 0x1, rt.Values(SupportedAnalogFormats.PALM)),
                rt.Bit("secaml", 4, 0x1, rt.Values(SupportedAnalogFormats.SECAML)),
                rt.Bit("secambg", 5, 0x1, rt.Values(SupportedAnalogFormats.SECAMBG)),
            ),
        )


@dataclass(slots=True, repr=False)
class SensorIDQueryRec(rt.Struct):
    """SensorIDQueryRec.

    sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
    """

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    sensor_id: SensorIDQueryRec.SensorID | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(SensorIDQueryRec.SensorID, ((1, 65535),)))),
        )


@dataclass(slots=True, repr=False)
class SensorIdRec(rt.Struct):
    """SensorIdRec.

    sensor_id: 1..65535. Identifies the sensor
    """

    sensor_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        (sensor_id_,) = _S_H.unpack_from(data, at)
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        return self, at + 2

    def _write(self, out: bytearray) -> None:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        out += _S_H.pack(sensor_id_)


@dataclass(slots=True, repr=False)
class RangeSensorErrorRec(rt.Struct):
    """RangeSensorErrorRec.

    sensor_id: 1..65535. Identifies the sensor
    range_sensor_error_code: RangeSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class RangeSensorErrorCode(IntEnum):
        """Values of RangeSensorErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_HORIZONTAL_FOV = 1
        INVALID_VERTICAL_FOV = 2
        INVALID_UPDATE_RATE = 3
        INVALID_SENSOR_RANGE = 4
        INVALID_SENSOR_STATE = 5
        MULTIPLE_INVALID_PARAMETERS = 6
        UNKNOWN_ERROR = 255

    sensor_id: int
    range_sensor_error_code: RangeSensorErrorRec.RangeSensorErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("RangeSensorErrorCode", rt.Number("B", rt.Values(RangeSensorErrorRec.RangeSensorErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        sensor_id_, range_sensor_error_code_ = _S_HB.unpack_from(data, at)
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.range_sensor_error_code = _E_RangeSensorErrorRec_RangeSensorErrorCode[range_sensor_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        range_sensor_error_code_ = self.range_sensor_error_code
        if range_sensor_error_code_ not in _E_RangeSensorErrorRec_RangeSensorErrorCode: raise rt.Reject
        out += _S_HB.pack(sensor_id_, range_sensor_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class VisualSensorErrorRec(rt.Struct):
    """VisualSensorErrorRec.

    sensor_id: 1..65535. Identifies the sensor
    visual_sensor_error_code: VisualSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class VisualSensorErrorCode(IntEnum):
        """Values of VisualSensorErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_SENSOR_STATE = 1
        INVALID_ZOOM_MODE = 2
        INVALID_ZOOM_VALUE = 3
        INVALID_FOCUS_MODE = 4
        INVALID_FOCUS_VALUE = 5
        INVALID_WHITE_BALANCE = 6
        INVALID_IMAGING_MODE = 7
        INVALID_EXPOSURE_MODE = 8
        INVALID_METERING_MODE = 9
        INVALID_SHUTTER_SPEED = 10
        INVALID_APERTURE_VALUE = 11
        INVALID_LIGHT_SENSITIVITY = 12
        INVALID_IMAGE_STABILIZATION = 13
        INVALID_HORIZONTAL_FOV = 14
        INVALID_VERTICAL_FOV = 15
        MULTIPLE_INVALID_PARAMETERS = 16
        UNKNOWN_ERROR = 255

    sensor_id: int
    visual_sensor_error_code: VisualSensorErrorRec.VisualSensorErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("VisualSensorErrorCode", rt.Number("B", rt.Values(VisualSensorErrorRec.VisualSensorErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        sensor_id_, visual_sensor_error_code_ = _S_HB.unpack_from(data, at)
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.visual_sensor_error_code = _E_VisualSensorErrorRec_VisualSensorErrorCode[visual_sensor_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        visual_sensor_error_code_ = self.visual_sensor_error_code
        if visual_sensor_error_code_ not in _E_VisualSensorErrorRec_VisualSensorErrorCode: raise rt.Reject
        out += _S_HB.pack(sensor_id_, visual_sensor_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class DigitalVideoSensorErrorRec(rt.Struct):
    """DigitalVideoSensorErrorRec.

    sensor_id: 1..65535. Identifies the sensor
    digital_video_error_code: DigitalVideoErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class DigitalVideoErrorCode(IntEnum):
        """Values of DigitalVideoErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_MINIMUM_BIT_RATE = 1
        INVALID_MAXIMUM_BIT_RATE = 2
        FRAME_RATE_TOO_LOW = 3
        FRAME_RATE_TOO_HIGH = 4
        INVALID_FRAME_SIZE = 5
        INVALID_FORMAT = 6
        MULTIPLE_INVALID_PARAMETERS = 7
        UNKNOWN_ERROR = 255

    sensor_id: int
    digital_video_error_code: DigitalVideoSensorErrorRec.DigitalVideoErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("DigitalVideoErrorCode", rt.Number("B", rt.Values(DigitalVideoSensorErrorRec.DigitalVideoErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        sensor_id_, digital_video_error_code_ = _S_HB.unpack_from(data, at)
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.digital_video_error_code = _E_DigitalVideoSensorErrorRec_DigitalVideoErrorCode[digital_video_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        digital_video_error_code_ = self.digital_video_error_code
        if digital_video_error_code_ not in _E_DigitalVideoSensorErrorRec_DigitalVideoErrorCode: raise rt.Reject
        out += _S_HB.pack(sensor_id_, digital_video_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class AnalogVideoSensorErrorRec(rt.Struct):
    """AnalogVideoSensorErrorRec.

    sensor_id: 1..65535. Identifies the sensor
    analog_video_error_code: AnalogVideoErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class AnalogVideoErrorCode(IntEnum):
        """Values of AnalogVideoErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_FORMAT = 1
        UNKNOWN_ERROR = 255

    sensor_id: int
    analog_video_error_code: AnalogVideoSensorErrorRec.AnalogVideoErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("AnalogVideoErrorCode", rt.Number("B", rt.Values(AnalogVideoSensorErrorRec.AnalogVideoErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        sensor_id_, analog_video_error_code_ = _S_HB.unpack_from(data, at)
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.analog_video_error_code = _E_AnalogVideoSensorErrorRec_AnalogVideoErrorCode[analog_video_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        analog_video_error_code_ = self.analog_video_error_code
        if analog_video_error_code_ not in _E_AnalogVideoSensorErrorRec_AnalogVideoErrorCode: raise rt.Reject
        out += _S_HB.pack(sensor_id_, analog_video_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class StillImageSensorErrorRec(rt.Struct):
    """StillImageSensorErrorRec.

    sensor_id: 1..65535. Identifies the sensor
    still_image_error_code: StillImageErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class StillImageErrorCode(IntEnum):
        """Values of StillImageErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_FRAME_SIZE = 1
        INVALID_FORMAT = 2
        MULTIPLE_INVALID_PARAMETERS = 3
        UNKNOWN_ERROR = 255

    sensor_id: int
    still_image_error_code: StillImageSensorErrorRec.StillImageErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("StillImageErrorCode", rt.Number("B", rt.Values(StillImageSensorErrorRec.StillImageErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        sensor_id_, still_image_error_code_ = _S_HB.unpack_from(data, at)
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.still_image_error_code = _E_StillImageSensorErrorRec_StillImageErrorCode[still_image_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        still_image_error_code_ = self.still_image_error_code
        if still_image_error_code_ not in _E_StillImageSensorErrorRec_StillImageErrorCode: raise rt.Reject
        out += _S_HB.pack(sensor_id_, still_image_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class H264VideoEncodingErrorRec(rt.Struct):
    """H264VideoEncodingErrorRec.

    sensor_id: 1..65535. Identifies the sensor
    h264_video_encoding_error_code: H264VideoEncodingErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class H264VideoEncodingErrorCode(IntEnum):
        """Values of H264VideoEncodingErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_PROFILE = 1
        INVALID_PRESET = 2
        INVALID_GROUP_OF_PICTURES = 3
        INVALID_GDR = 4
        INVALID_REGION_OF_INTEREST = 5
        INVALID_INTRA_MACRO_REFRESH = 6
        UNKNOWN_ERROR = 255

    sensor_id: int
    h264_video_encoding_error_code: H264VideoEncodingErrorRec.H264VideoEncodingErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("H264VideoEncodingErrorCode", rt.Number("B", rt.Values(H264VideoEncodingErrorRec.H264VideoEncodingErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        sensor_id_, h264_video_encoding_error_code_ = _S_HB.unpack_from(data, at)
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.h264_video_encoding_error_code = _E_H264VideoEncodingErrorRec_H264VideoEncodingErrorCode[h264_video_encoding_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        h264_video_encoding_error_code_ = self.h264_video_encoding_error_code
        if h264_video_encoding_error_code_ not in _E_H264VideoEncodingErrorRec_H264VideoEncodingErrorCode: raise rt.Reject
        out += _S_HB.pack(sensor_id_, h264_video_encoding_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class DigitalAudioSensorErrorRec(rt.Struct):
    """DigitalAudioSensorErrorRec.

    sensor_id: 1..65535. Identifies the sensor
    digital_audio_sensor_error_code: DigitalAudioSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class DigitalAudioSensorErrorCode(IntEnum):
        """Values of DigitalAudioSensorErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_BIT_RATE = 1
        INVALID_FORMAT = 2
        INVALID_SAMPLE_RATE = 3
        INVALID_BIT_DEPTH = 4
        INVALID_ENCODING_QUALITY = 5
        UNKNOWN_ERROR = 255

    sensor_id: int
    digital_audio_sensor_error_code: DigitalAudioSensorErrorRec.DigitalAudioSensorErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("DigitalAudioSensorErrorCode", rt.Number("B", rt.Values(DigitalAudioSensorErrorRec.DigitalAudioSensorErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        sensor_id_, digital_audio_sensor_error_code_ = _S_HB.unpack_from(data, at)
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.digital_audio_sensor_error_code = _E_DigitalAudioSensorErrorRec_DigitalAudioSensorErrorCode[digital_audio_sensor_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        digital_audio_sensor_error_code_ = self.digital_audio_sensor_error_code
        if digital_audio_sensor_error_code_ not in _E_DigitalAudioSensorErrorRec_DigitalAudioSensorErrorCode: raise rt.Reject
        out += _S_HB.pack(sensor_id_, digital_audio_sensor_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class DigitalAudioOutputErrorRec(rt.Struct):
    """DigitalAudioOutputErrorRec.

    sensor_id: 1..65535. Identifies the sensor
    digital_audio_output_error_code: DigitalAudioOutputErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class DigitalAudioOutputErrorCode(IntEnum):
        """Values of DigitalAudioOutputErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        STREAM_NOT_FOUND = 1
        STREAM_NOT_SUPPORTED = 2
        UNKNOWN_ERROR = 255

    sensor_id: int
    digital_audio_output_error_code: DigitalAudioOutputErrorRec.DigitalAudioOutputErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("DigitalAudioOutputErrorCode", rt.Number("B", rt.Values(DigitalAudioOutputErrorRec.DigitalAudioOutputErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        sensor_id_, digital_audio_output_error_code_ = _S_HB.unpack_from(data, at)
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.digital_audio_output_error_code = _E_DigitalAudioOutputErrorRec_DigitalAudioOutputErrorCode[digital_audio_output_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        digital_audio_output_error_code_ = self.digital_audio_output_error_code
        if digital_audio_output_error_code_ not in _E_DigitalAudioOutputErrorRec_DigitalAudioOutputErrorCode: raise rt.Reject
        out += _S_HB.pack(sensor_id_, digital_audio_output_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class VideoIlluminatorErrorRec(rt.Struct):
    """VideoIlluminatorErrorRec.

    illuminator_id: Identifies the lamp
    video_illuminator_error_rec_code: VideoIlluminatorErrorRecCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class VideoIlluminatorErrorRecCode(IntEnum):
        """Values of VideoIlluminatorErrorRecCode."""

        UNKNOWN_SENSOR_ID = 0
        UNSUPPORTED_MODE = 1
        UNSUPPORTED_BEAM_WIDTH = 2
        UNSUPPORTED_BEAM_HEIGHT = 3
        UNKNOWN_ERROR = 255

    illuminator_id: int
    video_illuminator_error_rec_code: VideoIlluminatorErrorRec.VideoIlluminatorErrorRecCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("IlluminatorID", rt.Number("H")),
            ("VideoIlluminatorErrorRecCode", rt.Number("B", rt.Values(VideoIlluminatorErrorRec.VideoIlluminatorErrorRecCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        self.illuminator_id, video_illuminator_error_rec_code_ = _S_HB.unpack_from(data, at)
        self.video_illuminator_error_rec_code = _E_VideoIlluminatorErrorRec_VideoIlluminatorErrorRecCode[video_illuminator_error_rec_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        video_illuminator_error_rec_code_ = self.video_illuminator_error_rec_code
        if video_illuminator_error_rec_code_ not in _E_VideoIlluminatorErrorRec_VideoIlluminatorErrorRecCode: raise rt.Reject
        out += _S_HB.pack(self.illuminator_id, video_illuminator_error_rec_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class SupportedAudioFormats(rt.Struct):
    """SupportedAudioFormats.

    lpcm_pcm: bit 0. Linear PCM.
    aiff: bit 1. AIFF.
    wav: bit 2. WAV.
    alac: bit 3. Apple Lossless; 0 means that it is supported.
    flac: bit 4. FLAC.
    real_audio: bit 5. RealAudio.
    wma9_lossless: bit 6. Windows Media Audio 9 Lossless.
    true_audio: bit 7. True Audio.
    dolby_digital: bit 8. Dolby Digital.
    dts: bit 9. DTS.
    mp2: bit 10. MPEG audio layer II.
    mp3: bit 11. MPEG audio layer III.
    aac_mpeg2: bit 12. AAC as in MPEG-2.
    aac_mpeg4: bit 13. AAC as in MPEG-4.
    vorbis: bit 14. Vorbis.
    wma: bit 15. Windows Media Audio.
    speex: bit 16. Speex.
    """

    class LPCM_PCM(IntEnum):
        """Values of LPCM_PCM."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class AIFF(IntEnum):
        """Values of AIFF."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class WAV(IntEnum):
        """Values of WAV."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class ALAC(IntEnum):
        """Values of ALAC."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class FLAC(IntEnum):
        """Values of FLAC."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class RealAudio(IntEnum):
        """Values of RealAudio."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class WMA9_Lossless(IntEnum):
        """Values of WMA9_Lossless."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TrueAudio(IntEnum):
        """Values of TrueAudio."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class DolbyDigital(IntEnum):
        """Values of DolbyDigital."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class DTS(IntEnum):
        """Values of DTS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class MP2(IntEnum):
        """Values of MP2."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class MP3(IntEnum):
        """Values of MP3."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class AAC_MPEG2(IntEnum):
        """Values of AAC_MPEG2."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class AAC_MPEG4(IntEnum):
        """Values of AAC_MPEG4."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class VORBIS(IntEnum):
        """Values of VORBIS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class WMA(IntEnum):
        """Values of WMA."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class Speex(IntEnum):
        """Values of Speex."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    lpcm_pcm: SupportedAudioFormats.LPCM_PCM | int
    aiff: SupportedAudioFormats.AIFF | int
    wav: SupportedAudioFormats.WAV | int
    alac: SupportedAudioFormats.ALAC | int
    flac: SupportedAudioFormats.FLAC | int
    real_audio: SupportedAudioFormats.RealAudio | int
    wma9_lossless: SupportedAudioFormats.WMA9_Lossless | int
    true_audio: SupportedAudioFormats.TrueAudio | int
    dolby_digital: SupportedAudioFormats.DolbyDigital | int
    dts: SupportedAudioFormats.DTS | int
    mp2: SupportedAudioFormats.MP2 | int
    mp3: SupportedAudioFormats.MP3 | int
    aac_mpeg2: SupportedAudioFormats.AAC_MPEG2 | int
    aac_mpeg4: SupportedAudioFormats.AAC_MPEG4 | int
    vorbis: SupportedAudioFormats.VORBIS | int
    wma: SupportedAudioFormats.WMA | int
    speex: SupportedAudioFormats.Speex | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "I",
            (
                rt.Bit("lpcm_pcm", 0, 0x1, rt.Values(SupportedAudioFormats.LPCM_PCM)),
                rt.Bit("aiff", 1, 0x1, rt.Values(SupportedAudioFormats.AIFF)),
                rt.Bit("wav", 2, 0x1, rt.Values(SupportedAudioFormats.WAV)),
                rt.Bit("alac", 3, 0x1, rt.Values(SupportedAudioFormats.ALAC)),
                rt.Bit("flac", 4, 0x1, rt.Values(SupportedAudioFormats.FLAC)),
                rt.Bit("real_audio", 5, 0x1, rt.Values(SupportedAudioFormats.RealAudio)),
                rt.Bit("wma9_lossless", 6, 0x1, rt.Values(SupportedAudioFormats.WMA9_Lossless)),
                rt.Bit("true_audio", 7, 0x1, rt.Values(SupportedAudioFormats.TrueAudio)),
                rt.Bit("dolby_digital", 8, 0x1, rt.Values(SupportedAudioFormats.DolbyDigital)),
                rt.Bit("dts", 9, 0x1, rt.Values(SupportedAudioFormats.DTS)),
                rt.Bit("mp2", 10, 0x1, rt.Values(SupportedAudioFormats.MP2)),
                rt.Bit("mp3", 11, 0x1, rt.Values(SupportedAudioFormats.MP3)),
                rt.Bit("aac_mpeg2", 12, 0x1, rt.Values(SupportedAudioFormats.AAC_MPEG2)),
                rt.Bit("aac_mpeg4", 13, 0x1, rt.Values(SupportedAudioFormats.AAC_MPEG4)),
                rt.Bit("vorbis", 14, 0x1, rt.Values(SupportedAudioFormats.VORBIS)),
                rt.Bit("wma", 15, 0x1, rt.Values(SupportedAudioFormats.WMA)),
                rt.Bit("speex", 16, 0x1, rt.Values(SupportedAudioFormats.Speex)),
            ),
        )


@dataclass(slots=True, repr=False)
class SupportedBitDepths(rt.Struct):
    """SupportedBitDepths.

    eight_bits: bit 0. 8 bits.
    ten_bits: bit 1. 10 bits.
    twelve_bits: bit 2. 12 bits.
    fourteen_bits: bit 3. 14 bits.
    sixteen_bits: bit 4. 16 bits.
    twenty_bits: bit 5. 20 bits.
    twenty_four_bits: bit 6. 24 bits.
    thirty_two_bits: bit 7. 32 bits.
    """

    class EIGHT_BITS(IntEnum):
        """Values of EIGHT_BITS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TEN_BITS(IntEnum):
        """Values of TEN_BITS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TWELVE_BITS(IntEnum):
        """Values of TWELVE_BITS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class FOURTEEN_BITS(IntEnum):
        """Values of FOURTEEN_BITS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class SIXTEEN_BITS(IntEnum):
        """Values of SIXTEEN_BITS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TWENTY_BITS(IntEnum):
        """Values of TWENTY_BITS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class TWENTY_FOUR_BITS(IntEnum):
        """Values of TWENTY_FOUR_BITS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    class THIRTY_TWO_BITS(IntEnum):
        """Values of THIRTY_TWO_BITS."""

        NOT_SUPPORTED = 0
        SUPPORTED = 1

    eight_bits: SupportedBitDepths.EIGHT_BITS | int
    ten_bits: SupportedBitDepths.TEN_BITS | int
    twelve_bits: SupportedBitDepths.TWELVE_BITS | int
    fourteen_bits: SupportedBitDepths.FOURTEEN_BITS | int
    sixteen_bits: SupportedBitDepths.SIXTEEN_BITS | int
    twenty_bits: SupportedBitDepths.TWENTY_BITS | int
    twenty_four_bits: SupportedBitDepths.TWENTY_FOUR_BITS | int
    thirty_two_bits: SupportedBitDepths.THIRTY_TWO_BITS | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "H",
            (
                rt.Bit("eight_bits", 0, 0x1, rt.Values(SupportedBitDepths.EIGHT_BITS)),
                rt.Bit("ten_bits", 1, 0x1, rt.Values(SupportedBitDepths.TEN_BITS)),
                rt.Bit("twelve_bits", 2, 0x1, rt.Values(SupportedBitDepths.TWELVE_BITS)),
                rt.Bit("fourteen_bits", 3, 0x1, rt.Values(SupportedBitDepths.FOURTEEN_BITS)),
                rt.Bit("sixteen_bits", 4, 0x1, rt.Values(SupportedBitDepths.SIXTEEN_BITS)),
                rt.Bit("twenty_bits", 5, 0x1, rt.Values(SupportedBitDepths.TWENTY_BITS)),
                rt.Bit("twenty_four_bits", 6, 0x1, rt.Values(SupportedBitDepths.TWENTY_FOUR_BITS)),
                rt.Bit("thirty_two_bits", 7, 0x1, rt.Values(SupportedBitDepths.THIRTY_TWO_BITS)),
            ),
        )


@dataclass(slots=True, repr=False)
class JAUS_ID(rt.Struct):
    """JAUS_ID.

    component_id: bits 0..7. Component number.
    node_id: bits 8..15. Node number.
    subsystem_id: bits 16..31. Subsystem number.
    """

    component_id: int
    node_id: int
    subsystem_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "I",
            (
                rt.Bit("component_id", 0, 0xFF, rt.Values(None, ((0, 255),))),
                rt.Bit("node_id", 8, 0xFF, rt.Values(None, ((0, 255),))),
                rt.Bit("subsystem_id", 16, 0xFFFF, rt.Values(None, ((0, 65535),))),
            ),
        )


@dataclass(slots=True, repr=False)
class SupportedFrameSizes(rt.Struct):
    """SupportedFrameSizes.

    sqcif_128_x96: bit 0. 128 x 96 pixels.
    qcif_176_x144: bit 1. 176 x 144 pixels.
    cif_352_x288: bit 2. 352 x 288 pixels.
    cif4_704_x576: bit 3. 704 x 576 pixels.
    cif16_1408_x1152: bit 4. 1408 x 1152 pixels.
    qqvga_160_x120: bit 5. 160 x 120 pixels.
    qvga_320_x240: bit 6. 320 x 240 pixels.
    vga_640_x480: bit 7. 640 x 480 pixels.
    svga_800_x600: bit 8. 800 x 600 pixels.
    xga_1024_x768: bit 9. 1024 x 768 pixels.
    uxga_1600_x1200: bit 10. 1600 x 1200 pixels.
    qxga_2048_x1536: bit 11. 2048 x 1536 pixels.
    sxga_1280_x1024: bit 12. 1280 x 1024 pixels.
    qsxga_2560_x2048: bit 13. 2560 x 2048 pixels.
    hsxga_5120_x4096: bit 14. 5120 x 4096 pixels.
    wvga_852_x480: bit 15. 852 x 480 pixels.
    wxga_1366_x768: bit 16. 1366 x 768 pixels.
    wsxga_1600_x1024: bit 17. 1600 x 1024 pixels.
    wuxga_1920_x1200: bit 18. 1920 x 1200 pixels.
    woxga_2560_x1600: bit 19. 2560 x 1600 pixels.
    wqsxga_3200_x2048: bit 20. 3200 x 2048 pixels.
    wquxga_3840_x2400: bit 21. 3840 x 2400 pixels.
    whsxga_6400_x4096: bit 22. 6400 x 4096 pixels.
    whuxga_7680_x4800: bit 23. 7680 x 4800 pixels.
    cga_320_x200: bit 24. 320 x 200 pixels.
    ega_640_x350: bit 25. 640 x 350 pixels.
    hd480_852_x480: bit 26. 852 x 480 pixels.
    hd720_1280_x720: bit 27. 1280 x 720 pixels.
    hd1080_1920_x1080: bit 28. 1920 x 1080 pixels.
    """

    class Sqcif_128x96(IntEnum):
        """Values of Sqcif_128x96."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qcif_176x144(IntEnum):
        """Values of Qcif_176x144."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cif_352x288(IntEnum):
        """Values of Cif_352x288."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cif4_704x576(IntEnum):
        """Values of Cif4_704x576."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cif16_1408x1152(IntEnum):
        """Values of Cif16_1408x1152."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qqvga_160x120(IntEnum):
        """Values of Qqvga_160x120."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qvga_320x240(IntEnum):
        """Values of Qvga_320x240."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Vga_640x480(IntEnum):
        """Values of Vga_640x480."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Svga_800x600(IntEnum):
        """Values of Svga_800x600."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Xga_1024x768(IntEnum):
        """Values of Xga_1024x768."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Uxga_1600x1200(IntEnum):
        """Values of Uxga_1600x1200."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qxga_2048x1536(IntEnum):
        """Values of Qxga_2048x1536."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Sxga_1280x1024(IntEnum):
        """Values of Sxga_1280x1024."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Qsxga_2560x2048(IntEnum):
        """Values of Qsxga_2560x2048."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Hsxga_5120x4096(IntEnum):
        """Values of Hsxga_5120x4096."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wvga_852x480(IntEnum):
        """Values of Wvga_852x480."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wxga_1366x768(IntEnum):
        """Values of Wxga_1366x768."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wsxga_1600x1024(IntEnum):
        """Values of Wsxga_1600x1024."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wuxga_1920x1200(IntEnum):
        """Values of Wuxga_1920x1200."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Woxga_2560x1600(IntEnum):
        """Values of Woxga_2560x1600."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wqsxga_3200x2048(IntEnum):
        """Values of Wqsxga_3200x2048."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Wquxga_3840x2400(IntEnum):
        """Values of Wquxga_3840x2400."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Whsxga_6400x4096(IntEnum):
        """Values of Whsxga_6400x4096."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Whuxga_7680x4800(IntEnum):
        """Values of Whuxga_7680x4800."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cga_320x200(IntEnum):
        """Values of Cga_320x200."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Ega_640x350(IntEnum):
        """Values of Ega_640x350."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Hd480_852x480(IntEnum):
        """Values of Hd480_852x480."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Hd720_1280x720(IntEnum):
        """Values of Hd720_1280x720."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Hd1080_1920x1080(IntEnum):
        """Values of Hd1080_1920x1080."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    sqcif_128_x96: SupportedFrameSizes.Sqcif_128x96 | int
    qcif_176_x144: SupportedFrameSizes.Qcif_176x144 | int
    cif_352_x288: SupportedFrameSizes.Cif_352x288 | int
    cif4_704_x576: SupportedFrameSizes.Cif4_704x576 | int
    cif16_1408_x1152: SupportedFrameSizes.Cif16_1408x1152 | int
    qqvga_160_x120: SupportedFrameSizes.Qqvga_160x120 | int
    qvga_320_x240: SupportedFrameSizes.Qvga_320x240 | int
    vga_640_x480: SupportedFrameSizes.Vga_640x480 | int
    svga_800_x600: SupportedFrameSizes.Svga_800x600 | int
    xga_1024_x768: SupportedFrameSizes.Xga_1024x768 | int
    uxga_1600_x1200: SupportedFrameSizes.Uxga_1600x1200 | int
    qxga_2048_x1536: SupportedFrameSizes.Qxga_2048x1536 | int
    sxga_1280_x1024: SupportedFrameSizes.Sxga_1280x1024 | int
    qsxga_2560_x2048: SupportedFrameSizes.Qsxga_2560x2048 | int
    hsxga_5120_x4096: SupportedFrameSizes.Hsxga_5120x4096 | int
    wvga_852_x480: SupportedFrameSizes.Wvga_852x480 | int
    wxga_1366_x768: SupportedFrameSizes.Wxga_1366x768 | int
    wsxga_1600_x1024: SupportedFrameSizes.Wsxga_1600x1024 | int
    wuxga_1920_x1200: SupportedFrameSizes.Wuxga_1920x1200 | int
    woxga_2560_x1600: SupportedFrameSizes.Woxga_2560x1600 | int
    wqsxga_3200_x2048: SupportedFrameSizes.Wqsxga_3200x2048 | int
    wquxga_3840_x2400: SupportedFrameSizes.Wquxga_3840x2400 | int
    whsxga_6400_x4096: SupportedFrameSizes.Whsxga_6400x4096 | int
    whuxga_7680_x4800: SupportedFrameSizes.Whuxga_7680x4800 | int
    cga_320_x200: SupportedFrameSizes.Cga_320x200 | int
    ega_640_x350: SupportedFrameSizes.Ega_640x350 | int
    hd480_852_x480: SupportedFrameSizes.Hd480_852x480 | int
    hd720_1280_x720: SupportedFrameSizes.Hd720_1280x720 | int
    hd1080_1920_x1080: SupportedFrameSizes.Hd1080_1920x1080 | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "I",
            (
                rt.Bit("sqcif_128_x96", 0, 0x1, rt.Values(SupportedFrameSizes.Sqcif_128x96)),
                rt.Bit("qcif_176_x144", 1, 0x1, rt.Values(SupportedFrameSizes.Qcif_176x144)),
                rt.Bit("cif_352_x288", 2, 0x1, rt.Values(SupportedFrameSizes.Cif_352x288)),
                rt.Bit("cif4_704_x576", 3, 0x1, rt.Values(SupportedFrameSizes.Cif4_704x576)),
                rt.Bit("cif16_1408_x1152", 4, 0x1, rt.Values(SupportedFrameSizes.Cif16_1408x1152)),
                rt.Bit("qqvga_160_x120", 5, 0x1, rt.Values(SupportedFrameSizes.Qqvga_160x120)),
                rt.Bit("qvga_320_x240", 6, 0x1, rt.Values(SupportedFrameSizes.Qvga_320x240)),
                rt.Bit("vga_640_x480", 7, 0x1, rt.Values(SupportedFrameSizes.Vga_640x480)),
                rt.Bit("svga_800_x600", 8, 0x1, rt.Values(SupportedFrameSizes.Svga_800x600)),
                rt.Bit("xga_1024_x768", 9, 0x1, rt.Values(SupportedFrameSizes.Xga_1024x768)),
                rt.Bit("uxga_1600_x1200", 10, 0x1, rt.Values(SupportedFrameSizes.Uxga_1600x1200)),
                rt.Bit("qxga_2048_x1536", 11, 0x1, rt.Values(SupportedFrameSizes.Qxga_2048x1536)),
                rt.Bit("sxga_1280_x1024", 12, 0x1, rt.Values(SupportedFrameSizes.Sxga_1280x1024)),
                rt.Bit("qsxga_2560_x2048", 13, 0x1, rt.Values(SupportedFrameSizes.Qsxga_2560x2048)),
                rt.Bit("hsxga_5120_x4096", 14, 0x1, rt.Values(SupportedFrameSizes.Hsxga_5120x4096)),
                rt.Bit("wvga_852_x480", 15, 0x1, rt.Values(SupportedFrameSizes.Wvga_852x480)),
                rt.Bit("wxga_1366_x768", 16, 0x1, rt.Values(SupportedFrameSizes.Wxga_1366x768)),
                rt.Bit("wsxga_1600_x1024", 17, 0x1, rt.Values(SupportedFrameSizes.Wsxga_1600x1024)),
                rt.Bit("wuxga_1920_x1200", 18, 0x1, rt.Values(SupportedFrameSizes.Wuxga_1920x1200)),
                rt.Bit("woxga_2560_x1600", 19, 0x1, rt.Values(SupportedFrameSizes.Woxga_2560x1600)),
                rt.Bit("wqsxga_3200_x2048", 20, 0x1, rt.Values(SupportedFrameSizes.Wqsxga_3200x2048)),
                rt.Bit("wquxga_3840_x2400", 21, 0x1, rt.Values(SupportedFrameSizes.Wquxga_3840x2400)),
                rt.Bit("whsxga_6400_x4096", 22, 0x1, rt.Values(SupportedFrameSizes.Whsxga_6400x4096)),
                rt.Bit("whuxga_7680_x4800", 23, 0x1, rt.Values(SupportedFrameSizes.Whuxga_7680x4800)),
                rt.Bit("cga_320_x200", 24, 0x1, rt.Values(SupportedFrameSizes.Cga_320x200)),
                rt.Bit("ega_640_x350", 25, 0x1, rt.Values(SupportedFrameSizes.Ega_640x350)),
                rt.Bit("hd480_852_x480", 26, 0x1, rt.Values(SupportedFrameSizes.Hd480_852x480)),
                rt.Bit("hd720_1280_x720", 27, 0x1, rt.Values(SupportedFrameSizes.Hd720_1280x720)),
                rt.Bit("hd1080_1920_x1080", 28, 0x1, rt.Values(SupportedFrameSizes.Hd1080_1920x1080)),
            ),
        )


@dataclass(slots=True, repr=False)
class SupportedDigitalFormats(rt.Struct):
    """SupportedDigitalFormats.

    avi: bit 0. AVI.
    mjpeg: bit 1. Motion JPEG.
    mpeg2: bit 2. MPEG-2.
    h263: bit 3. H.263.
    h26_3_plus: bit 4. H.263+.
    mpeg4_visual: bit 5. MPEG-4 part 2.
    mpeg4_avc_h264: bit 6. MPEG-4 part 10, which is H.264.
    """

    class AVI(IntEnum):
        """Values of AVI."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class MJPEG(IntEnum):
        """Values of MJPEG."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class MPEG2(IntEnum):
        """Values of MPEG2."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class H263(IntEnum):
        """Values of H263."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class H263plus(IntEnum):
        """Values of H263plus."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class MPEG4_Visual(IntEnum):
        """Values of MPEG4_Visual."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class MPEG4_AVC_h264(IntEnum):
        """Values of MPEG4_AVC_h264."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    avi: SupportedDigitalFormats.AVI | int
    mjpeg: SupportedDigitalFormats.MJPEG | int
    mpeg2: SupportedDigitalFormats.MPEG2 | int
    h263: SupportedDigitalFormats.H263 | int
    h26_3_plus: SupportedDigitalFormats.H263plus | int
    mpeg4_visual: SupportedDigitalFormats.MPEG4_Visual | int
    mpeg4_avc_h264: SupportedDigitalFormats.MPEG4_AVC_h264 | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("avi", 0, 0x1, rt.Values(SupportedDigitalFormats.AVI)),
                rt.Bit("mjpeg", 1, 0x1, rt.Values(SupportedDigitalFormats.MJPEG)),
                rt.Bit("mpeg2", 2, 0x1, rt.Values(SupportedDigitalFormats.MPEG2)),
                rt.Bit("h263", 3, 0x1, rt.Values(SupportedDigitalFormats.H263)),
                rt.Bit("h26_3_plus", 4, 0x1, rt.Values(SupportedDigitalFormats.H263plus)),
                rt.Bit("mpeg4_visual", 5, 0x1, rt.Values(SupportedDigitalFormats.MPEG4_Visual)),
                rt.Bit("mpeg4_avc_h264", 6, 0x1, rt.Values(SupportedDigitalFormats.MPEG4_AVC_h264)),
            ),
        )


@dataclass(slots=True, repr=False)
class RangeSensorErrorRecV1(rt.Struct):
    """RangeSensorErrorRecV1.

    sensor_id: Identifies the sensor
    range_sensor_error_code: RangeSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class RangeSensorErrorCode(IntEnum):
        """Values of RangeSensorErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_HORIZONTAL_FOV = 1
        INVALID_VERTICAL_FOV = 2
        INVALID_UPDATE_RATE = 3
        INVALID_SENSOR_RANGE = 4
        INVALID_SENSOR_STATE = 5
        MULTIPLE_INVALID_PARAMETERS = 6
        UNKNOWN_ERROR = 255

    sensor_id: int
    range_sensor_error_code: RangeSensorErrorRecV1.RangeSensorErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H")),
            ("RangeSensorErrorCode", rt.Number("B", rt.Values(RangeSensorErrorRecV1.RangeSensorErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        self.sensor_id, range_sensor_error_code_ = _S_HB.unpack_from(data, at)
        self.range_sensor_error_code = _E_RangeSensorErrorRecV1_RangeSensorErrorCode[range_sensor_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        range_sensor_error_code_ = self.range_sensor_error_code
        if range_sensor_error_code_ not in _E_RangeSensorErrorRecV1_RangeSensorErrorCode: raise rt.Reject
        out += _S_HB.pack(self.sensor_id, range_sensor_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class VisualSensorErrorRecV1(rt.Struct):
    """VisualSensorErrorRecV1.

    sensor_id: Identifies the sensor
    visual_sensor_error_code: VisualSensorErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class VisualSensorErrorCode(IntEnum):
        """Values of VisualSensorErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_SENSOR_STATE = 1
        INVALID_ZOOM_MODE = 2
        INVALID_ZOOM_VALUE = 3
        INVALID_FOCUS_MODE = 4
        INVALID_FOCUS_VALUE = 5
        INVALID_WHITE_BALANCE = 6
        INVALID_IMAGING_MODE = 7
        INVALID_EXPOSURE_MODE = 8
        INVALID_METERING_MODE = 9
        INVALID_SHUTTER_SPEED = 10
        INVALID_APERTURE_VALUE = 11
        INVALID_LIGHT_SENSITIVITY = 12
        INVALID_IMAGE_STABILIZATION = 13
        INVALID_HORIZONTAL_FOV = 14
        INVALID_VERTICAL_FOV = 15
        MULTIPLE_INVALID_PARAMETERS = 16
        UNKNOWN_ERROR = 255

    sensor_id: int
    visual_sensor_error_code: VisualSensorErrorRecV1.VisualSensorErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H")),
            ("VisualSensorErrorCode", rt.Number("B", rt.Values(VisualSensorErrorRecV1.VisualSensorErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        self.sensor_id, visual_sensor_error_code_ = _S_HB.unpack_from(data, at)
        self.visual_sensor_error_code = _E_VisualSensorErrorRecV1_VisualSensorErrorCode[visual_sensor_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        visual_sensor_error_code_ = self.visual_sensor_error_code
        if visual_sensor_error_code_ not in _E_VisualSensorErrorRecV1_VisualSensorErrorCode: raise rt.Reject
        out += _S_HB.pack(self.sensor_id, visual_sensor_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class DigitalVideoSensorErrorRecV1(rt.Struct):
    """DigitalVideoSensorErrorRecV1.

    sensor_id: Identifies the sensor
    digital_video_error_code: DigitalVideoErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class DigitalVideoErrorCode(IntEnum):
        """Values of DigitalVideoErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_MINIMUM_BIT_RATE = 1
        INVALID_MAXIMUM_BIT_RATE = 2
        INVALID_MINIMUM_FRAME_RATE = 3
        INVALID_MAXIMUM_FRAME_RATE = 4
        INVALID_FRAME_SIZE = 5
        INVALID_FORMAT = 6
        MULTIPLE_INVALID_PARAMETERS = 7
        UNKNOWN_ERROR = 255

    sensor_id: int
    digital_video_error_code: DigitalVideoSensorErrorRecV1.DigitalVideoErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H")),
            ("DigitalVideoErrorCode", rt.Number("B", rt.Values(DigitalVideoSensorErrorRecV1.DigitalVideoErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        self.sensor_id, digital_video_error_code_ = _S_HB.unpack_from(data, at)
        self.digital_video_error_code = _E_DigitalVideoSensorErrorRecV1_DigitalVideoErrorCode[digital_video_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        digital_video_error_code_ = self.digital_video_error_code
        if digital_video_error_code_ not in _E_DigitalVideoSensorErrorRecV1_DigitalVideoErrorCode: raise rt.Reject
        out += _S_HB.pack(self.sensor_id, digital_video_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class AnalogVideoSensorErrorRecV1(rt.Struct):
    """AnalogVideoSensorErrorRecV1.

    sensor_id: Identifies the sensor
    analog_video_error_code: AnalogVideoErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class AnalogVideoErrorCode(IntEnum):
        """Values of AnalogVideoErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_FORMAT = 1
        UNKNOWN_ERROR = 255

    sensor_id: int
    analog_video_error_code: AnalogVideoSensorErrorRecV1.AnalogVideoErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H")),
            ("AnalogVideoErrorCode", rt.Number("B", rt.Values(AnalogVideoSensorErrorRecV1.AnalogVideoErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        self.sensor_id, analog_video_error_code_ = _S_HB.unpack_from(data, at)
        self.analog_video_error_code = _E_AnalogVideoSensorErrorRecV1_AnalogVideoErrorCode[analog_video_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        analog_video_error_code_ = self.analog_video_error_code
        if analog_video_error_code_ not in _E_AnalogVideoSensorErrorRecV1_AnalogVideoErrorCode: raise rt.Reject
        out += _S_HB.pack(self.sensor_id, analog_video_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class StillImageSensorErrorRecV1(rt.Struct):
    """StillImageSensorErrorRecV1.

    sensor_id: Identifies the sensor
    still_image_error_code: StillImageErrorCode. What was wrong
    error_message: up to 255 characters. An explanation for people
    """

    class StillImageErrorCode(IntEnum):
        """Values of StillImageErrorCode."""

        UNKNOWN_SENSOR_ID = 0
        INVALID_FRAME_SIZE = 1
        INVALID_FORMAT = 2
        MULTIPLE_INVALID_PARAMETERS = 3
        UNKNOWN_ERROR = 255

    sensor_id: int
    still_image_error_code: StillImageSensorErrorRecV1.StillImageErrorCode | int
    error_message: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H")),
            ("StillImageErrorCode", rt.Number("B", rt.Values(StillImageSensorErrorRecV1.StillImageErrorCode))),
            ("ErrorMessage", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        self.sensor_id, still_image_error_code_ = _S_HB.unpack_from(data, at)
        self.still_image_error_code = _E_StillImageSensorErrorRecV1_StillImageErrorCode[still_image_error_code_]
        error_message_end_ = at + 4 + data[at + 3]
        self.error_message = data[at + 4:error_message_end_].decode("latin-1")
        return self, error_message_end_

    def _write(self, out: bytearray) -> None:
        still_image_error_code_ = self.still_image_error_code
        if still_image_error_code_ not in _E_StillImageSensorErrorRecV1_StillImageErrorCode: raise rt.Reject
        out += _S_HB.pack(self.sensor_id, still_image_error_code_)
        error_message_raw_ = self.error_message.encode("latin-1")
        out.append(len(error_message_raw_))
        out += error_message_raw_


@dataclass(slots=True, repr=False)
class SupportedStates(rt.Struct):
    """SupportedStates.

    active: bit 0. Working.
    standby: bit 1. Ready to work.
    off: bit 2. Off.
    """

    class Active(IntEnum):
        """Values of Active."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Standby(IntEnum):
        """Values of Standby."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Off(IntEnum):
        """Values of Off."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    active: SupportedStates.Active | int
    standby: SupportedStates.Standby | int
    off: SupportedStates.Off | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("active", 0, 0x1, rt.Values(SupportedStates.Active)),
                rt.Bit("standby", 1, 0x1, rt.Values(SupportedStates.Standby)),
                rt.Bit("off", 2, 0x1, rt.Values(SupportedStates.Off)),
            ),
        )


@dataclass(slots=True, repr=False)
class SupportedCompression(rt.Struct):
    """SupportedCompression.

    no_compression: bit 0. None.
    deflate: bit 1. Deflate.
    bzip2: bit 2. bzip2.
    lzma: bit 3. LZMA.
    """

    class NoCompression(IntEnum):
        """Values of NoCompression."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class DEFLATE(IntEnum):
        """Values of DEFLATE."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Bzip2(IntEnum):
        """Values of Bzip2."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class LZMA(IntEnum):
        """Values of LZMA."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    no_compression: SupportedCompression.NoCompression | int
    deflate: SupportedCompression.DEFLATE | int
    bzip2: SupportedCompression.Bzip2 | int
    lzma: SupportedCompression.LZMA | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("no_compression", 0, 0x1, rt.Values(SupportedCompression.NoCompression)),
                rt.Bit("deflate", 1, 0x1, rt.Values(SupportedCompression.DEFLATE)),
                rt.Bit("bzip2", 2, 0x1, rt.Values(SupportedCompression.Bzip2)),
                rt.Bit("lzma", 3, 0x1, rt.Values(SupportedCompression.LZMA)),
            ),
        )


@dataclass(slots=True, repr=False)
class StaticGeometricPropertiesRec(rt.Struct):
    """StaticGeometricPropertiesRec.

    sensor_position: 3 of -30..30 meter. Position of the sensor in the frame that it is mounted in: X, Y, Z
    unit_quaternion: 4 of -1..1. Attitude of the sensor in the frame that it is mounted in, as a unit quaternion
    """

    sensor_position: list[float]
    unit_quaternion: list[float]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorPosition", rt.Grid(rt.real("I", -30.0, 30.0, "meter"), (3,))),
            ("UnitQuaternion", rt.Grid(rt.real("I", -1.0, 1.0), (4,))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        sensor_position_ = []
        for _ in range(3):
            (item_2_,) = _S_I.unpack_from(data, at)
            item_ = -30.0 + item_2_ * 1.3969838622484784e-08
            at += 4
            sensor_position_.append(item_)
        self.sensor_position = sensor_position_
        unit_quaternion_ = []
        for _ in range(4):
            (item_4_,) = _S_I.unpack_from(data, at)
            item_3_ = -1.0 + item_4_ * 4.656612874161595e-10
            at += 4
            unit_quaternion_.append(item_3_)
        self.unit_quaternion = unit_quaternion_
        return self, at

    def _write(self, out: bytearray) -> None:
        sensor_position_ = self.sensor_position
        if type(sensor_position_) is not list or len(sensor_position_) != 3: raise rt.Reject
        for item_ in sensor_position_:
            if not -30.0 <= item_ <= 30.0: raise rt.Reject
            near = item_ * 71582788.25 + 2147483648.0
            item_raw_ = int(near)
            if not 1.52587890625e-05 < near - item_raw_ < 0.9999847412109375: item_raw_ = rt.exact_raw(item_, _R_17)
            out += _S_I.pack(item_raw_)
        unit_quaternion_ = self.unit_quaternion
        if type(unit_quaternion_) is not list or len(unit_quaternion_) != 4: raise rt.Reject
        for item_2_ in unit_quaternion_:
            if not -1.0 <= item_2_ <= 1.0: raise rt.Reject
            near = item_2_ * 2147483647.5 + 2147483648.0
            item_raw_2_ = int(near)
            if not 1.52587890625e-05 < near - item_raw_2_ < 0.9999847412109375: item_raw_2_ = rt.exact_raw(item_2_, _R_18)
            out += _S_I.pack(item_raw_2_)


@dataclass(slots=True, repr=False)
class ManipulatorGeometricPropertiesRec(rt.Struct):
    """ManipulatorGeometricPropertiesRec.

    subsystem_id: Subsystem of the manipulator
    node_id: Node of the manipulator
    component_id: Component of the manipulator
    joint_number: Number of the joint that the sensor moves with
    sensor_position: 3 of -30..30 meter. Position of the sensor in the frame that it is mounted in: X, Y, Z
    unit_quaternion: 4 of -1..1. Attitude of the sensor in the frame that it is mounted in, as a unit quaternion
    """

    subsystem_id: int
    node_id: int
    component_id: int
    joint_number: int
    sensor_position: list[float]
    unit_quaternion: list[float]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SubsystemID", rt.Number("H")),
            ("NodeID", rt.Number("B")),
            ("ComponentID", rt.Number("B")),
            ("JointNumber", rt.Number("B")),
            ("SensorPosition", rt.Grid(rt.real("I", -30.0, 30.0, "meter"), (3,))),
            ("UnitQuaternion", rt.Grid(rt.real("I", -1.0, 1.0), (4,))),
        )

    @classmethod
    def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
        self = rt.new(cls)
        self.subsystem_id, self.node_id, self.component_id, self.joint_number = _S_H3B.unpack_from(data, at)
        at += 5
        sensor_position_ = []
        for _ in range(3):
            (item_2_,) = _S_I.unpack_from(data, at)
            item_ = -30.0 + item_2_ * 1.3969838622484784e-08
            at += 4
            sensor_position_.append(item_)
        self.sensor_position = sensor_position_
        unit_quaternion_ = []
        for _ in range(4):
            (item_4_,) = _S_I.unpack_from(data, at)
            item_3_ = -1.0 + item_4_ * 4.656612874161595e-10
            at += 4
            unit_quaternion_.append(item_3_)
        self.unit_quaternion = unit_quaternion_
        return self, at

    def _write(self, out: bytearray) -> None:
        out += _S_H3B.pack(self.subsystem_id, self.node_id, self.component_id, self.joint_number)
        sensor_position_ = self.sensor_position
        if type(sensor_position_) is not list or len(sensor_position_) != 3: raise rt.Reject
        for item_ in sensor_position_:
            if not -30.0 <= item_ <= 30.0: raise rt.Reject
            near = item_ * 71582788.25 + 2147483648.0
            item_raw_ = int(near)
            if not 1.52587890625e-05 < near - item_raw_ < 0.9999847412109375: item_raw_ = rt.exact_raw(item_, _R_17)
            out += _S_I.pack(item_raw_)
        unit_quaternion_ = self.unit_quaternion
        if type(unit_quaternion_) is not list or len(unit_quaternion_) != 4: raise rt.Reject
        for item_2_ in unit_quaternion_:
            if not -1.0 <= item_2_ <= 1.0: raise rt.Reject
            near = item_2_ * 2147483647.5 + 2147483648.0
            item_raw_2_ = int(near)
            if not 1.52587890625e-05 < near - item_raw_2_ < 0.9999847412109375: item_raw_2_ = rt.exact_raw(item_2_, _R_18)
            out += _S_I.pack(item_raw_2_)


@dataclass(slots=True, repr=False)
class SupportedImageFormats(rt.Struct):
    """SupportedImageFormats.

    jpeg: bit 0. JPEG.
    gif: bit 1. GIF.
    png: bit 2. PNG.
    bmp: bit 3. Windows bitmap.
    tiff: bit 4. TIFF.
    ppm: bit 5. Portable pixmap.
    pgm: bit 6. Portable graymap.
    pnm: bit 7. Portable anymap.
    nef_nikon_raw: bit 8. Nikon raw.
    cr2_canon_raw: bit 9. Canon raw.
    dng_adobe_raw: bit 10. Adobe digital negative.
    """

    class JPEG(IntEnum):
        """Values of JPEG."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class GIF(IntEnum):
        """Values of GIF."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class PNG(IntEnum):
        """Values of PNG."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class BMP(IntEnum):
        """Values of BMP."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class TIFF(IntEnum):
        """Values of TIFF."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class PPM(IntEnum):
        """Values of PPM."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class PGM(IntEnum):
        """Values of PGM."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class PNM(IntEnum):
        """Values of PNM."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class NEF_Nikon_RAW(IntEnum):
        """Values of NEF_Nikon_RAW."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class CR2_Canon_RAW(IntEnum):
        """Values of CR2_Canon_RAW."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class DNG_Adobe_RAW(IntEnum):
        """Values of DNG_Adobe_RAW."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    jpeg: SupportedImageFormats.JPEG | int
    gif: SupportedImageFormats.GIF | int
    png: SupportedImageFormats.PNG | int
    bmp: SupportedImageFormats.BMP | int
    tiff: SupportedImageFormats.TIFF | int
    ppm: SupportedImageFormats.PPM | int
    pgm: SupportedImageFormats.PGM | int
    pnm: SupportedImageFormats.PNM | int
    nef_nikon_raw: SupportedImageFormats.NEF_Nikon_RAW | int
    cr2_canon_raw: SupportedImageFormats.CR2_Canon_RAW | int
    dng_adobe_raw: SupportedImageFormats.DNG_Adobe_RAW | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "H",
            (
                rt.Bit("jpeg", 0, 0x1, rt.Values(SupportedImageFormats.JPEG)),
                rt.Bit("gif", 1, 0x1, rt.Values(SupportedImageFormats.GIF)),
                rt.Bit("png", 2, 0x1, rt.Values(SupportedImageFormats.PNG)),
                rt.Bit("bmp", 3, 0x1, rt.Values(SupportedImageFormats.BMP)),
                rt.Bit("tiff", 4, 0x1, rt.Values(SupportedImageFormats.TIFF)),
                rt.Bit("ppm", 5, 0x1, rt.Values(SupportedImageFormats.PPM)),
                rt.Bit("pgm", 6, 0x1, rt.Values(SupportedImageFormats.PGM)),
                rt.Bit("pnm", 7, 0x1, rt.Values(SupportedImageFormats.PNM)),
                rt.Bit("nef_nikon_raw", 8, 0x1, rt.Values(SupportedImageFormats.NEF_Nikon_RAW)),
                rt.Bit("cr2_canon_raw", 9, 0x1, rt.Values(SupportedImageFormats.CR2_Canon_RAW)),
                rt.Bit("dng_adobe_raw", 10, 0x1, rt.Values(SupportedImageFormats.DNG_Adobe_RAW)),
            ),
        )


@dataclass(slots=True, repr=False)
class ZoomModes(rt.Struct):
    """ZoomModes.

    mixed: bit 0. By the lens, then by computation.
    analog_only: bit 1. By the lens alone.
    digital_only: bit 2. By computation alone.
    none: bit 3. No zoom.
    """

    class Mixed(IntEnum):
        """Values of Mixed."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class AnalogOnly(IntEnum):
        """Values of AnalogOnly."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class DigitalOnly(IntEnum):
        """Values of DigitalOnly."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class None_(IntEnum):
        """Values of None_."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    mixed: ZoomModes.Mixed | int
    analog_only: ZoomModes.AnalogOnly | int
    digital_only: ZoomModes.DigitalOnly | int
    none: ZoomModes.None_ | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("mixed", 0, 0x1, rt.Values(ZoomModes.Mixed)),
                rt.Bit("analog_only", 1, 0x1, rt.Values(ZoomModes.AnalogOnly)),
                rt.Bit("digital_only", 2, 0x1, rt.Values(ZoomModes.DigitalOnly)),
                rt.Bit("none", 3, 0x1, rt.Values(ZoomModes.None_)),
            ),
        )


@dataclass(slots=True, repr=False)
class FocusModes(rt.Struct):
    """FocusModes.

    auto_focus: bit 0. Automatic.
    manual_focus: bit 1. By setting.
    """

    class AutoFocus(IntEnum):
        """Values of AutoFocus."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class ManualFocus(IntEnum):
        """Values of ManualFocus."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    auto_focus: FocusModes.AutoFocus | int
    manual_focus: FocusModes.ManualFocus | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("auto_focus", 0, 0x1, rt.Values(FocusModes.AutoFocus)),
                rt.Bit("manual_focus", 1, 0x1, rt.Values(FocusModes.ManualFocus)),
            ),
        )


@dataclass(slots=True, repr=False)
class SupportedWhiteBalance(rt.Struct):
    """SupportedWhiteBalance.

    auto: bit 0. Found automatically.
    daylight: bit 1. Daylight.
    cloudy: bit 2. Cloudy sky.
    shade: bit 3. Shade.
    tungsten: bit 4. Tungsten lamps.
    flurescent: bit 5. Fluorescent lamps.
    flash: bit 6. Flash.
    """

    class Auto(IntEnum):
        """Values of Auto."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Daylight(IntEnum):
        """Values of Daylight."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Cloudy(IntEnum):
        """Values of Cloudy."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Shade(IntEnum):
        """Values of Shade."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Tungsten(IntEnum):
        """Values of Tungsten."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Flurescent(IntEnum):
        """Values of Flurescent."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Flash(IntEnum):
        """Values of Flash."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    auto: SupportedWhiteBalance.Auto | int
    daylight: SupportedWhiteBalance.Daylight | int
    cloudy: SupportedWhiteBalance.Cloudy | int
    shade: SupportedWhiteBalance.Shade | int
    tungsten: SupportedWhiteBalance.Tungsten | int
    flurescent: SupportedWhiteBalance.Flurescent | int
    flash: SupportedWhiteBalance.Flash | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("auto", 0, 0x1, rt.Values(SupportedWhiteBalance.Auto)),
                rt.Bit("daylight", 1, 0x1, rt.Values(SupportedWhiteBalance.Daylight)),
                rt.Bit("cloudy", 2, 0x1, rt.Values(SupportedWhiteBalance.Cloudy)),
                rt.Bit("shade", 3, 0x1, rt.Values(SupportedWhiteBalance.Shade)),
                rt.Bit("tungsten", 4, 0x1, rt.Values(SupportedWhiteBalance.Tungsten)),
                rt.Bit("flurescent", 5, 0x1, rt.Values(SupportedWhiteBalance.Flurescent)),
                rt.Bit("flash", 6, 0x1, rt.Values(SupportedWhiteBalance.Flash)),
            ),
        )


@dataclass(slots=True, repr=False)
class ExposureModes(rt.Struct):
    """ExposureModes.

    auto: bit 0. All automatic.
    manual: bit 1. Nothing automatic.
    shutter_priority: bit 2. Time set, aperture automatic.
    aperture_priority: bit 3. Aperture set, time automatic.
    """

    class Auto(IntEnum):
        """Values of Auto."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Manual(IntEnum):
        """Values of Manual."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class ShutterPriority(IntEnum):
        """Values of ShutterPriority."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class AperturePriority(IntEnum):
        """Values of AperturePriority."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    auto: ExposureModes.Auto | int
    manual: ExposureModes.Manual | int
    shutter_priority: ExposureModes.ShutterPriority | int
    aperture_priority: ExposureModes.AperturePriority | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("auto", 0, 0x1, rt.Values(ExposureModes.Auto)),
                rt.Bit("manual", 1, 0x1, rt.Values(ExposureModes.Manual)),
                rt.Bit("shutter_priority", 2, 0x1, rt.Values(ExposureModes.ShutterPriority)),
                rt.Bit("aperture_priority", 3, 0x1, rt.Values(ExposureModes.AperturePriority)),
            ),
        )


@dataclass(slots=True, repr=False)
class MeteringModes(rt.Struct):
    """MeteringModes.

    matrix_or_auto: bit 0. Over all of the image.
    center_weighted: bit 1. Mostly in the middle.
    spot: bit 2. In one point.
    """

    class MatrixOrAuto(IntEnum):
        """Values of MatrixOrAuto."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class CenterWeighted(IntEnum):
        """Values of CenterWeighted."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class Spot(IntEnum):
        """Values of Spot."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    matrix_or_auto: MeteringModes.MatrixOrAuto | int
    center_weighted: MeteringModes.CenterWeighted | int
    spot: MeteringModes.Spot | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("matrix_or_auto", 0, 0x1, rt.Values(MeteringModes.MatrixOrAuto)),
                rt.Bit("center_weighted", 1, 0x1, rt.Values(MeteringModes.CenterWeighted)),
                rt.Bit("spot", 2, 0x1, rt.Values(MeteringModes.Spot)),
            ),
        )


@dataclass(slots=True, repr=False)
class LightSensitivityLevels(rt.Struct):
    """LightSensitivityLevels.

    auto: bit 0. Found automatically.
    iso100: bit 1. ISO 100.
    iso200: bit 2. ISO 200.
    iso400: bit 3. ISO 400.
    iso800: bit 4. ISO 800.
    iso1600: bit 5. ISO 1600.
    iso3200: bit 6. ISO 3200.
    """

    class Auto(IntEnum):
        """Values of Auto."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO100(IntEnum):
        """Values of ISO100."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO200(IntEnum):
        """Values of ISO200."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO400(IntEnum):
        """Values of ISO400."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO800(IntEnum):
        """Values of ISO800."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO1600(IntEnum):
        """Values of ISO1600."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    class ISO3200(IntEnum):
        """Values of ISO3200."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    auto: LightSensitivityLevels.Auto | int
    iso100: LightSensitivityLevels.ISO100 | int
    iso200: LightSensitivityLevels.ISO200 | int
    iso400: LightSensitivityLevels.ISO400 | int
    iso800: LightSensitivityLevels.ISO800 | int
    iso1600: LightSensitivityLevels.ISO1600 | int
    iso3200: LightSensitivityLevels.ISO3200 | int
    reserved_bits: int = 0

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Bits(
            cls,
            "B",
            (
                rt.Bit("auto", 0, 0x1, rt.Values(LightSensitivityLevels.Auto)),
                rt.Bit("iso100", 1, 0x1, rt.Values(LightSensitivityLevels.ISO100)),
                rt.Bit("iso200", 2, 0x1, rt.Values(LightSensitivityLevels.ISO200)),
                rt.Bit("iso400", 3, 0x1, rt.Values(LightSensitivityLevels.ISO400)),
                rt.Bit("iso800", 4, 0x1, rt.Values(LightSensitivityLevels.ISO800)),
                rt.Bit("iso1600", 5, 0x1, rt.Values(LightSensitivityLevels.ISO1600)),
                rt.Bit("iso3200", 6, 0x1, rt.Values(LightSensitivityLevels.ISO3200)),
            ),
        )


_S_H = rt.Packer("<H")
_E_RangeSensorErrorRec_RangeSensorErrorCode = rt.members(RangeSensorErrorRec.RangeSensorErrorCode)
_S_HB = rt.Packer("<HB")
_E_VisualSensorErrorRec_VisualSensorErrorCode = rt.members(VisualSensorErrorRec.VisualSensorErrorCode)
_E_DigitalVideoSensorErrorRec_DigitalVideoErrorCode = rt.members(DigitalVideoSensorErrorRec.DigitalVideoErrorCode)
_E_AnalogVideoSensorErrorRec_AnalogVideoErrorCode = rt.members(AnalogVideoSensorErrorRec.AnalogVideoErrorCode)
_E_StillImageSensorErrorRec_StillImageErrorCode = rt.members(StillImageSensorErrorRec.StillImageErrorCode)
_E_H264VideoEncodingErrorRec_H264VideoEncodingErrorCode = rt.members(H264VideoEncodingErrorRec.H264VideoEncodingErrorCode)
_E_DigitalAudioSensorErrorRec_DigitalAudioSensorErrorCode = rt.members(DigitalAudioSensorErrorRec.DigitalAudioSensorErrorCode)
_E_DigitalAudioOutputErrorRec_DigitalAudioOutputErrorCode = rt.members(DigitalAudioOutputErrorRec.DigitalAudioOutputErrorCode)
_E_VideoIlluminatorErrorRec_VideoIlluminatorErrorRecCode = rt.members(VideoIlluminatorErrorRec.VideoIlluminatorErrorRecCode)
_E_RangeSensorErrorRecV1_RangeSensorErrorCode = rt.members(RangeSensorErrorRecV1.RangeSensorErrorCode)
_E_VisualSensorErrorRecV1_VisualSensorErrorCode = rt.members(VisualSensorErrorRecV1.VisualSensorErrorCode)
_E_DigitalVideoSensorErrorRecV1_DigitalVideoErrorCode = rt.members(DigitalVideoSensorErrorRecV1.DigitalVideoErrorCode)
_E_AnalogVideoSensorErrorRecV1_AnalogVideoErrorCode = rt.members(AnalogVideoSensorErrorRecV1.AnalogVideoErrorCode)
_E_StillImageSensorErrorRecV1_StillImageErrorCode = rt.members(StillImageSensorErrorRecV1.StillImageErrorCode)
_S_I = rt.Packer("<I")
_R_17 = rt.Scaling(-30.0, 30.0, 4294967295)
_R_18 = rt.Scaling(-1.0, 1.0, 4294967295)
_S_H3B = rt.Packer("<H3B")
