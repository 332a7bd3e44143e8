"""urn:jaus:jss:environmentSensing:DigitalVideo 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types


@dataclass(slots=True, repr=False)
class ControlDigitalVideoSensorStream(rt.Message):
    """ControlDigitalVideoSensorStream (0x0805): Starts, pauses or stops a stream.

    sensor_id: 1..65535. Identifies the sensor
    stream_state: StreamState. What the stream is to do
    """

    CODE = 0x0805
    NAME = "ControlDigitalVideoSensorStream"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalVideo"
    VERSION = "2.0"
    IS_COMMAND = True
    IS_QUERY = False

    class StreamState(IntEnum):
        """Values of StreamState."""

        PLAY = 0
        PAUSE = 1
        STOP = 2

    sensor_id: int
    stream_state: ControlDigitalVideoSensorStream.StreamState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("StreamState", rt.Number("B", rt.Values(ControlDigitalVideoSensorStream.StreamState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, sensor_id_, stream_state_ = _S_2HB.unpack(data)
        if code != 0x0805: raise rt.Reject
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.stream_state = _E_ControlDigitalVideoSensorStream_StreamState[stream_state_]
        return self

    def _pack(self) -> bytes:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        stream_state_ = self.stream_state
        if stream_state_ not in _E_ControlDigitalVideoSensorStream_StreamState: raise rt.Reject
        return _S_2HB.pack(0x0805, sensor_id_, stream_state_)


@dataclass(slots=True, repr=False)
class ControlDigitalVideoSensorRecording(rt.Message):
    """ControlDigitalVideoSensorRecording (0x0810): Starts or stops recording.

    sensor_id: 1..65535. Identifies the sensor
    requested_recording_state: RequestedRecordingState. Whether the camera is to record
    """

    CODE = 0x0810
    NAME = "ControlDigitalVideoSensorRecording"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalVideo"
    VERSION = "2.0"
    IS_COMMAND = True
    IS_QUERY = False

    class RequestedRecordingState(IntEnum):
        """Values of RequestedRecordingState."""

        NOT_RECORDING = 0
        RECORDING = 1

    sensor_id: int
    requested_recording_state: ControlDigitalVideoSensorRecording.RequestedRecordingState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
            ("RequestedRecordingState", rt.Number("B", rt.Values(ControlDigitalVideoSensorRecording.RequestedRecordingState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, sensor_id_, requested_recording_state_ = _S_2HB.unpack(data)
        if code != 0x0810: raise rt.Reject
        if sensor_id_ < 1: raise rt.Reject
        self.sensor_id = sensor_id_
        self.requested_recording_state = _E_ControlDigitalVideoSensorRecording_RequestedRecordingState[requested_recording_state_]
        return self

    def _pack(self) -> bytes:
        sensor_id_ = self.sensor_id
        if not 1 <= sensor_id_ <= 65535: raise rt.Reject
        requested_recording_state_ = self.requested_recording_state
        if requested_recording_state_ not in _E_ControlDigitalVideoSensorRecording_RequestedRecordingState: raise rt.Reject
        return _S_2HB.pack(0x0810, sensor_id_, requested_recording_state_)


@dataclass(slots=True, repr=False)
class SetDigitalVideoSensorConfiguration(rt.Message):
    """SetDigitalVideoSensorConfiguration (0x0804): Sets the configuration of digital cameras.

    digital_video_sensor_list: 0..65535 items. The cameras
    """

    CODE = 0x0804
    NAME = "SetDigitalVideoSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalVideo"
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

    class FrameSize(IntEnum):
        """Values of FrameSize."""

        SQCIF_128_X96 = 0
        QCIF_176_X144 = 1
        CIF_352_X288 = 2
        CIF4_704_X576 = 3
        CIF16_1408_X1152 = 4
        QQVGA_160_X120 = 5
        QVGA_320_X240 = 6
        VGA_640_X480 = 7
        SVGA_800_X600 = 8
        XGA_1024_X768 = 9
        UXGA_1600_X1200 = 10
        QXGA_2048_X1536 = 11
        SXGA_1280_X1024 = 12
        QSXGA_2560_X2048 = 13
        HSXGA_5120_X4096 = 14
        WVGA_852_X480 = 15
        WXGA_1366_X768 = 16
        WSXGA_1600_X1024 = 17
        WUXGA_1920_X1200 = 18
        WOXGA_2560_X1600 = 19
        WQSXGA_3200_X2048 = 20
        WQUXGA_3840_X2400 = 21
        WHSXGA_6400_X4096 = 22
        WHUXGA_7680_X4800 = 23
        CGA_320_X200 = 24
        EGA_640_X350 = 25
        HD480_852_X480 = 26
        HD720_1280_X720 = 27
        HD1080_1920_X1080 = 28

    class DigitalFormat(IntEnum):
        """Values of DigitalFormat."""

        AVI = 0
        MJPEG = 1
        MPEG_2 = 2
        H_263 = 3
        H_263_PLUS = 4
        MPEG_4_VISUAL = 5
        MPEG_4_AVC = 6

    @dataclass(slots=True, repr=False)
    class DigitalVideoSensorConfigurationRec(rt.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        minimum_bit_rate: optional. Smallest bit rate, in kilobits per second
        maximum_bit_rate: optional. Largest bit rate, in kilobits per second
        frame_rate: optional. Frames per second
        frame_size: FrameSize, optional. Width and height of the image, in pixels
        digital_format: DigitalFormat, optional. Coding of the video
        """

        sensor_id: int
        minimum_bit_rate: int | None = None
        maximum_bit_rate: int | None = None
        frame_rate: int | None = None
        frame_size: SetDigitalVideoSensorConfiguration.FrameSize | int | None = None
        digital_format: SetDigitalVideoSensorConfiguration.DigitalFormat | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("MinimumBitRate", rt.Number("H"), True),
                ("MaximumBitRate", rt.Number("H"), True),
                ("FrameRate", rt.Number("B"), True),
                ("FrameSize", rt.Number("B", rt.Values(SetDigitalVideoSensorConfiguration.FrameSize)), True),
                ("DigitalFormat", rt.Number("B", rt.Values(SetDigitalVideoSensorConfiguration.DigitalFormat)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetDigitalVideoSensorConfiguration_DigitalVideoSensorConfigurationRec_0[mask & 0x1F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.minimum_bit_rate = raw() if mask & 1 else None
            self.maximum_bit_rate = raw() if mask & 2 else None
            self.frame_rate = raw() if mask & 4 else None
            if mask & 8:
                frame_size_ = raw()
                self.frame_size = _E_SetDigitalVideoSensorConfiguration_FrameSize[frame_size_]
            else: self.frame_size = None
            if mask & 16:
                digital_format_ = raw()
                self.digital_format = _E_SetDigitalVideoSensorConfiguration_DigitalFormat[digital_format_]
            else: self.digital_format = None
            self.reserved_presence = mask & 0xE0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1F: raise rt.Reject
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            minimum_bit_rate_ = self.minimum_bit_rate
            if minimum_bit_rate_ is not None:
                mask |= 1
                raw.append(minimum_bit_rate_)
            maximum_bit_rate_ = self.maximum_bit_rate
            if maximum_bit_rate_ is not None:
                mask |= 2
                raw.append(maximum_bit_rate_)
            frame_rate_ = self.frame_rate
            if frame_rate_ is not None:
                mask |= 4
                raw.append(frame_rate_)
            frame_size_ = self.frame_size
            if frame_size_ is not None:
                mask |= 8
                if frame_size_ not in _E_SetDigitalVideoSensorConfiguration_FrameSize: raise rt.Reject
                raw.append(frame_size_)
            digital_format_ = self.digital_format
            if digital_format_ is not None:
                mask |= 16
                if digital_format_ not in _E_SetDigitalVideoSensorConfiguration_DigitalFormat: raise rt.Reject
                raw.append(digital_format_)
            out += _M_SetDigitalVideoSensorConfiguration_DigitalVideoSensorConfigurationRec_0[mask & 0x1F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    request_id_rec: SetDigitalVideoSensorConfiguration.RequestIdRec
    digital_video_sensor_list: list[SetDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", SetDigitalVideoSensorConfiguration.RequestIdRec.layout()),
            ("DigitalVideoSensorList", rt.Repeat(rt.Count("H", 0, 65535), SetDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x04 or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetDigitalVideoSensorConfiguration.RequestIdRec(request_id_)
        (digital_video_sensor_list_count_,) = _S_H.unpack_from(data, 3)
        if digital_video_sensor_list_count_ * 3 > size - 5: raise rt.Reject
        at = 5
        digital_video_sensor_list_ = []
        for _ in range(digital_video_sensor_list_count_):
            item_, at = SetDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec._read(data, at, nesting)
            digital_video_sensor_list_.append(item_)
        self.digital_video_sensor_list = digital_video_sensor_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x04\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetDigitalVideoSensorConfiguration.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        digital_video_sensor_list_ = self.digital_video_sensor_list
        if type(digital_video_sensor_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_video_sensor_list_))
        for item_ in digital_video_sensor_list_:
            if type(item_) is not SetDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryDigitalVideoSensorConfiguration(rt.Message):
    """QueryDigitalVideoSensorConfiguration (0x2809): Asks for the configuration of digital cameras.

    query_digital_video_configuration_list: 0..65535 items. The cameras
    """

    CODE = 0x2809
    NAME = "QueryDigitalVideoSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDigitalVideoSensorConfiguration]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    @dataclass(slots=True, repr=False)
    class QueryDigitalVideoConfigurationRec(rt.Struct):
        """QueryDigitalVideoConfigurationRec.

        sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: QueryDigitalVideoSensorConfiguration.SensorID | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(QueryDigitalVideoSensorConfiguration.SensorID, ((1, 65535),)))),
                ("QueryPresenceVector", rt.Number("B")),
            )

    query_digital_video_configuration_list: list[QueryDigitalVideoSensorConfiguration.QueryDigitalVideoConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryDigitalVideoConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), QueryDigitalVideoSensorConfiguration.QueryDigitalVideoConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x09 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_digital_video_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        query_digital_video_configuration_list_end_ = 4 + query_digital_video_configuration_list_count_ * 3
        self.query_digital_video_configuration_list = [QueryDigitalVideoSensorConfiguration.QueryDigitalVideoConfigurationRec(_E_QueryDigitalVideoSensorConfiguration_SensorID.get(sensor_id_, sensor_id_), query_presence_vector_) for sensor_id_, query_presence_vector_ in _S_HB.iter_unpack(data[4:query_digital_video_configuration_list_end_])]
        if query_digital_video_configuration_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x09\x28")
        query_digital_video_configuration_list_ = self.query_digital_video_configuration_list
        if type(query_digital_video_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_digital_video_configuration_list_))
        for item_ in query_digital_video_configuration_list_:
            if type(item_) is not QueryDigitalVideoSensorConfiguration.QueryDigitalVideoConfigurationRec: raise rt.Reject
            out += _S_HB.pack(item_.sensor_id, item_.query_presence_vector)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryDigitalVideoSensorCapabilitiesExt(rt.Message):
    """QueryDigitalVideoSensorCapabilitiesExt (0x281D): Asks what cameras can do, recording included.

    query_digital_video_sensor_capabilities_list: 0..65535 items. The cameras
    """

    CODE = 0x281D
    NAME = "QueryDigitalVideoSensorCapabilitiesExt"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDigitalVideoSensorCapabilitiesExt]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    @dataclass(slots=True, repr=False)
    class QueryDigitalVideoSensorCapabilitiesRec(rt.Struct):
        """QueryDigitalVideoSensorCapabilitiesRec.

        sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: QueryDigitalVideoSensorCapabilitiesExt.SensorID | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(QueryDigitalVideoSensorCapabilitiesExt.SensorID, ((1, 65535),)))),
                ("QueryPresenceVector", rt.Number("B")),
            )

    query_digital_video_sensor_capabilities_list: list[QueryDigitalVideoSensorCapabilitiesExt.QueryDigitalVideoSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryDigitalVideoSensorCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), QueryDigitalVideoSensorCapabilitiesExt.QueryDigitalVideoSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1D or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_digital_video_sensor_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        query_digital_video_sensor_capabilities_list_end_ = 4 + query_digital_video_sensor_capabilities_list_count_ * 3
        self.query_digital_video_sensor_capabilities_list = [QueryDigitalVideoSensorCapabilitiesExt.QueryDigitalVideoSensorCapabilitiesRec(_E_QueryDigitalVideoSensorCapabilitiesExt_SensorID.get(sensor_id_, sensor_id_), query_presence_vector_) for sensor_id_, query_presence_vector_ in _S_HB.iter_unpack(data[4:query_digital_video_sensor_capabilities_list_end_])]
        if query_digital_video_sensor_capabilities_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1d\x28")
        query_digital_video_sensor_capabilities_list_ = self.query_digital_video_sensor_capabilities_list
        if type(query_digital_video_sensor_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_digital_video_sensor_capabilities_list_))
        for item_ in query_digital_video_sensor_capabilities_list_:
            if type(item_) is not QueryDigitalVideoSensorCapabilitiesExt.QueryDigitalVideoSensorCapabilitiesRec: raise rt.Reject
            out += _S_HB.pack(item_.sensor_id, item_.query_presence_vector)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryDigitalVideoSensorStatus(rt.Message):
    """QueryDigitalVideoSensorStatus (0x281E): Asks whether cameras stream and record.

    sensor_id_list: 0..65535 items. The sensors
    """

    CODE = 0x281E
    NAME = "QueryDigitalVideoSensorStatus"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportDigitalVideoSensorStatus]]

    SensorIDQueryRec = environment_sensing_v1_0_types.SensorIDQueryRec

    sensor_id_list: list[environment_sensing_v1_0_types.SensorIDQueryRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SensorIdList", rt.Repeat(rt.Count("H", 0, 65535), environment_sensing_v1_0_types.SensorIDQueryRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1E or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (sensor_id_list_count_,) = _S_H.unpack_from(data, 2)
        sensor_id_list_end_ = 4 + sensor_id_list_count_ * 2
        self.sensor_id_list = [environment_sensing_v1_0_types.SensorIDQueryRec(_E_SensorIDQueryRec_SensorID.get(sensor_id_, sensor_id_)) for sensor_id_ in _L_H[sensor_id_list_count_].unpack_from(data, 4)]
        if sensor_id_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1e\x28")
        sensor_id_list_ = self.sensor_id_list
        if type(sensor_id_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(sensor_id_list_))
        raw_: list[int | float] = []
        for item_ in sensor_id_list_:
            if type(item_) is not environment_sensing_v1_0_types.SensorIDQueryRec: raise rt.Reject
            raw_.append(item_.sensor_id)
        out += _L_H[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportDigitalVideoSensorCapabilitiesExt(rt.Message):
    """ReportDigitalVideoSensorCapabilitiesExt (0x481D): Tells what cameras can do, recording included.

    digital_video_sensor_list: 0..65535 items. The cameras
    """

    CODE = 0x481D
    NAME = "ReportDigitalVideoSensorCapabilitiesExt"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    SupportedFrameSizes = environment_sensing_v1_0_types.SupportedFrameSizes
    SupportedDigitalFormats = environment_sensing_v1_0_types.SupportedDigitalFormats

    class RecordingSupported(IntEnum):
        """Values of RecordingSupported."""

        UNSUPPORTED = 0
        SUPPORTED = 1

    @dataclass(slots=True, repr=False)
    class DigitalVideoSensorCapabilitiesRec(rt.Struct):
        """DigitalVideoSensorCapabilitiesRec.

        sensor_id: 1..65535. Identifies the sensor
        minimum_bit_rate: optional. Smallest bit rate, in kilobits per second
        maximum_bit_rate: optional. Largest bit rate, in kilobits per second
        minimum_frame_rate: optional. Smallest rate, in frames per second
        maximum_frame_rate: optional. Largest rate, in frames per second
        supported_frame_sizes: optional. Sizes of image that the camera offers
        supported_digital_formats: optional. Codings of video that the camera offers
        recording_supported: RecordingSupported, optional. Whether the camera can record
        """

        sensor_id: int
        minimum_bit_rate: int | None = None
        maximum_bit_rate: int | None = None
        minimum_frame_rate: int | None = None
        maximum_frame_rate: int | None = None
        supported_frame_sizes: environment_sensing_v1_0_types.SupportedFrameSizes | None = None
        supported_digital_formats: environment_sensing_v1_0_types.SupportedDigitalFormats | None = None
        recording_supported: ReportDigitalVideoSensorCapabilitiesExt.RecordingSupported | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("MinimumBitRate", rt.Number("H"), True),
                ("MaximumBitRate", rt.Number("H"), True),
                ("MinimumFrameRate", rt.Number("B"), True),
                ("MaximumFrameRate", rt.Number("B"), True),
                ("SupportedFrameSizes", environment_sensing_v1_0_types.SupportedFrameSizes.layout(), True),
                ("SupportedDigitalFormats", environment_sensing_v1_0_types.SupportedDigitalFormats.layout(), True),
                ("RecordingSupported", rt.Number("B", rt.Values(ReportDigitalVideoSensorCapabilitiesExt.RecordingSupported)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportDigitalVideoSensorCapabilitiesExt_DigitalVideoSensorCapabilitiesRec_0[mask & 0x7F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.minimum_bit_rate = raw() if mask & 1 else None
            self.maximum_bit_rate = raw() if mask & 2 else None
            self.minimum_frame_rate = raw() if mask & 4 else None
            self.maximum_frame_rate = raw() if mask & 8 else None
            if mask & 16:
                supported_frame_sizes_ = raw()
                self.supported_frame_sizes = environment_sensing_v1_0_types.SupportedFrameSizes(_E_SupportedFrameSizes_Sqcif_128x96.get(supported_frame_sizes_ & 0x1, supported_frame_sizes_ & 0x1), _E_SupportedFrameSizes_Qcif_176x144.get(supported_frame_sizes_ >> 1 & 0x1, supported_frame_sizes_ >> 1 & 0x1), _E_SupportedFrameSizes_Cif_352x288.get(supported_frame_sizes_ >> 2 & 0x1, supported_frame_sizes_ >> 2 & 0x1), _E_SupportedFrameSizes_Cif4_704x576.get(supported_frame_sizes_ >> 3 & 0x1, supported_frame_sizes_ >> 3 & 0x1), _E_SupportedFrameSizes_Cif16_1408x1152.get(supported_frame_sizes_ >> 4 & 0x1, supported_frame_sizes_ >> 4 & 0x1), _E_SupportedFrameSizes_Qqvga_160x120.get(supported_frame_sizes_ >> 5 & 0x1, supported_frame_sizes_ >> 5 & 0x1), _E_SupportedFrameSizes_Qvga_320x240.get(supported_frame_sizes_ >> 6 & 0x1, supported_frame_sizes_ >> 6 & 0x1), _E_SupportedFrameSizes_Vga_640x480.get(supported_frame_sizes_ >> 7 & 0x1, supported_frame_sizes_ >> 7 & 0x1), _E_SupportedFrameSizes_Svga_800x600.get(supported_frame_sizes_ >> 8 & 0x1, supported_frame_sizes_ >> 8 & 0x1), _E_SupportedFrameSizes_Xga_1024x768.get(supported_frame_sizes_ >> 9 & 0x1, supported_frame_sizes_ >> 9 & 0x1), _E_SupportedFrameSizes_Uxga_1600x1200.get(supported_frame_sizes_ >> 10 & 0x1, supported_frame_sizes_ >> 10 & 0x1), _E_SupportedFrameSizes_Qxga_2048x1536.get(supported_frame_sizes_ >> 11 & 0x1, supported_frame_sizes_ >> 11 & 0x1), _E_SupportedFrameSizes_Sxga_1280x1024.get(supported_frame_sizes_ >> 12 & 0x1, supported_frame_sizes_ >> 12 & 0x1), _E_SupportedFrameSizes_Qsxga_2560x2048.get(supported_frame_sizes_ >> 13 & 0x1, supported_frame_sizes_ >> 13 & 0x1), _E_SupportedFrameSizes_Hsxga_5120x4096.get(supported_frame_sizes_ >> 14 & 0x1, supported_frame_sizes_ >> 14 & 0x1), _E_SupportedFrameSizes_Wvga_852x480.get(supported_frame_sizes_ >> 15 & 0x1, supported_frame_sizes_ >> 15 & 0x1), _E_SupportedFrameSizes_Wxga_1366x768.get(supported_frame_sizes_ >> 16 & 0x1, supported_frame_sizes_ >> 16 & 0x1), _E_SupportedFrameSizes_Wsxga_1600x1024.get(supported_frame_sizes_ >> 17 & 0x1, supported_frame_sizes_ >> 17 & 0x1), _E_SupportedFrameSizes_Wuxga_1920x1200.get(supported_frame_sizes_ >> 18 & 0x1, supported_frame_sizes_ >> 18 & 0x1), _E_SupportedFrameSizes_Woxga_2560x1600.get(supported_frame_sizes_ >> 19 & 0x1, supported_frame_sizes_ >> 19 & 0x1), _E_SupportedFrameSizes_Wqsxga_3200x2048.get(supported_frame_sizes_ >> 20 & 0x1, supported_frame_sizes_ >> 20 & 0x1), _E_SupportedFrameSizes_Wquxga_3840x2400.get(supported_frame_sizes_ >> 21 & 0x1, supported_frame_sizes_ >> 21 & 0x1), _E_SupportedFrameSizes_Whsxga_6400x4096.get(supported_frame_sizes_ >> 22 & 0x1, supported_frame_sizes_ >> 22 & 0x1), _E_SupportedFrameSizes_Whuxga_7680x4800.get(supported_frame_sizes_ >> 23 & 0x1, supported_frame_sizes_ >> 23 & 0x1), _E_SupportedFrameSizes_Cga_320x200.get(supported_frame_sizes_ >> 24 & 0x1, supported_frame_sizes_ >> 24 & 0x1), _E_SupportedFrameSizes_Ega_640x350.get(supported_frame_sizes_ >> 25 & 0x1, supported_frame_sizes_ >> 25 & 0x1), _E_SupportedFrameSizes_Hd480_852x480.get(supported_frame_sizes_ >> 26 & 0x1, supported_frame_sizes_ >> 26 & 0x1), _E_SupportedFrameSizes_Hd720_1280x720.get(supported_frame_sizes_ >> 27 & 0x1, supported_frame_sizes_ >> 27 & 0x1), _E_SupportedFrameSizes_Hd1080_1920x1080.get(supported_frame_sizes_ >> 28 & 0x1, supported_frame_sizes_ >> 28 & 0x1), supported_frame_sizes_ & 0xE0000000)
            else: self.supported_frame_sizes = None
            if mask & 32:
                supported_digital_formats_ = raw()
                self.supported_digital_formats = environment_sensing_v1_0_types.SupportedDigitalFormats(_E_SupportedDigitalFormats_AVI.get(supported_digital_formats_ & 0x1, supported_digital_formats_ & 0x1), _E_SupportedDigitalFormats_MJPEG.get(supported_digital_formats_ >> 1 & 0x1, supported_digital_formats_ >> 1 & 0x1), _E_SupportedDigitalFormats_MPEG2.get(supported_digital_formats_ >> 2 & 0x1, supported_digital_formats_ >> 2 & 0x1), _E_SupportedDigitalFormats_H263.get(supported_digital_formats_ >> 3 & 0x1, supported_digital_formats_ >> 3 & 0x1), _E_SupportedDigitalFormats_H263plus.get(supported_digital_formats_ >> 4 & 0x1, supported_digital_formats_ >> 4 & 0x1), _E_SupportedDigitalFormats_MPEG4_Visual.get(supported_digital_formats_ >> 5 & 0x1, supported_digital_formats_ >> 5 & 0x1), _E_SupportedDigitalFormats_MPEG4_AVC_h264.get(supported_digital_formats_ >> 6 & 0x1, supported_digital_formats_ >> 6 & 0x1), supported_digital_formats_ & 0x80)
            else: self.supported_digital_formats = None
            if mask & 64:
                recording_supported_ = raw()
                self.recording_supported = _E_ReportDigitalVideoSensorCapabilitiesExt_RecordingSupported[recording_supported_]
            else: self.recording_supported = None
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
            minimum_bit_rate_ = self.minimum_bit_rate
            if minimum_bit_rate_ is not None:
                mask |= 1
                raw.append(minimum_bit_rate_)
            maximum_bit_rate_ = self.maximum_bit_rate
            if maximum_bit_rate_ is not None:
                mask |= 2
                raw.append(maximum_bit_rate_)
            minimum_frame_rate_ = self.minimum_frame_rate
            if minimum_frame_rate_ is not None:
                mask |= 4
                raw.append(minimum_frame_rate_)
            maximum_frame_rate_ = self.maximum_frame_rate
            if maximum_frame_rate_ is not None:
                mask |= 8
                raw.append(maximum_frame_rate_)
            supported_frame_sizes_ = self.supported_frame_sizes
            if supported_frame_sizes_ is not None:
                mask |= 16
                if type(supported_frame_sizes_) is not environment_sensing_v1_0_types.SupportedFrameSizes: raise rt.Reject
                sqcif_128_x96_ = supported_frame_sizes_.sqcif_128_x96
                if not 0 <= sqcif_128_x96_ <= 1: raise rt.Reject
                qcif_176_x144_ = supported_frame_sizes_.qcif_176_x144
                if not 0 <= qcif_176_x144_ <= 1: raise rt.Reject
                cif_352_x288_ = supported_frame_sizes_.cif_352_x288
                if not 0 <= cif_352_x288_ <= 1: raise rt.Reject
                cif4_704_x576_ = supported_frame_sizes_.cif4_704_x576
                if not 0 <= cif4_704_x576_ <= 1: raise rt.Reject
                cif16_1408_x1152_ = supported_frame_sizes_.cif16_1408_x1152
                if not 0 <= cif16_1408_x1152_ <= 1: raise rt.Reject
                qqvga_160_x120_ = supported_frame_sizes_.qqvga_160_x120
                if not 0 <= qqvga_160_x120_ <= 1: raise rt.Reject
                qvga_320_x240_ = supported_frame_sizes_.qvga_320_x240
                if not 0 <= qvga_320_x240_ <= 1: raise rt.Reject
                vga_640_x480_ = supported_frame_sizes_.vga_640_x480
                if not 0 <= vga_640_x480_ <= 1: raise rt.Reject
                svga_800_x600_ = supported_frame_sizes_.svga_800_x600
                if not 0 <= svga_800_x600_ <= 1: raise rt.Reject
                xga_1024_x768_ = supported_frame_sizes_.xga_1024_x768
                if not 0 <= xga_1024_x768_ <= 1: raise rt.Reject
                uxga_1600_x1200_ = supported_frame_sizes_.uxga_1600_x1200
                if not 0 <= uxga_1600_x1200_ <= 1: raise rt.Reject
                qxga_2048_x1536_ = supported_frame_sizes_.qxga_2048_x1536
                if not 0 <= qxga_2048_x1536_ <= 1: raise rt.Reject
                sxga_1280_x1024_ = supported_frame_sizes_.sxga_1280_x1024
                if not 0 <= sxga_1280_x1024_ <= 1: raise rt.Reject
                qsxga_2560_x2048_ = supported_frame_sizes_.qsxga_2560_x2048
                if not 0 <= qsxga_2560_x2048_ <= 1: raise rt.Reject
                hsxga_5120_x4096_ = supported_frame_sizes_.hsxga_5120_x4096
                if not 0 <= hsxga_5120_x4096_ <= 1: raise rt.Reject
                wvga_852_x480_ = supported_frame_sizes_.wvga_852_x480
                if not 0 <= wvga_852_x480_ <= 1: raise rt.Reject
                wxga_1366_x768_ = supported_frame_sizes_.wxga_1366_x768
                if not 0 <= wxga_1366_x768_ <= 1: raise rt.Reject
                wsxga_1600_x1024_ = supported_frame_sizes_.wsxga_1600_x1024
                if not 0 <= wsxga_1600_x1024_ <= 1: raise rt.Reject
                wuxga_1920_x1200_ = supported_frame_sizes_.wuxga_1920_x1200
                if not 0 <= wuxga_1920_x1200_ <= 1: raise rt.Reject
                woxga_2560_x1600_ = supported_frame_sizes_.woxga_2560_x1600
                if not 0 <= woxga_2560_x1600_ <= 1: raise rt.Reject
                wqsxga_3200_x2048_ = supported_frame_sizes_.wqsxga_3200_x2048
                if not 0 <= wqsxga_3200_x2048_ <= 1: raise rt.Reject
                wquxga_3840_x2400_ = supported_frame_sizes_.wquxga_3840_x2400
                if not 0 <= wquxga_3840_x2400_ <= 1: raise rt.Reject
                whsxga_6400_x4096_ = supported_frame_sizes_.whsxga_6400_x4096
                if not 0 <= whsxga_6400_x4096_ <= 1: raise rt.Reject
                whuxga_7680_x4800_ = supported_frame_sizes_.whuxga_7680_x4800
                if not 0 <= whuxga_7680_x4800_ <= 1: raise rt.Reject
                cga_320_x200_ = supported_frame_sizes_.cga_320_x200
                if not 0 <= cga_320_x200_ <= 1: raise rt.Reject
                ega_640_x350_ = supported_frame_sizes_.ega_640_x350
                if not 0 <= ega_640_x350_ <= 1: raise rt.Reject
                hd480_852_x480_ = supported_frame_sizes_.hd480_852_x480
                if not 0 <= hd480_852_x480_ <= 1: raise rt.Reject
                hd720_1280_x720_ = supported_frame_sizes_.hd720_1280_x720
                if not 0 <= hd720_1280_x720_ <= 1: raise rt.Reject
                hd1080_1920_x1080_ = supported_frame_sizes_.hd1080_1920_x1080
                if not 0 <= hd1080_1920_x1080_ <= 1: raise rt.Reject
                reserved_bits_ = supported_frame_sizes_.reserved_bits
                if reserved_bits_ & 0x1FFFFFFF: raise rt.Reject
                raw.append(sqcif_128_x96_ | qcif_176_x144_ << 1 | cif_352_x288_ << 2 | cif4_704_x576_ << 3 | cif16_1408_x1152_ << 4 | qqvga_160_x120_ << 5 | qvga_320_x240_ << 6 | vga_640_x480_ << 7 | svga_800_x600_ << 8 | xga_1024_x768_ << 9 | uxga_1600_x1200_ << 10 | qxga_2048_x1536_ << 11 | sxga_1280_x1024_ << 12 | qsxga_2560_x2048_ << 13 | hsxga_5120_x4096_ << 14 | wvga_852_x480_ << 15 | wxga_1366_x768_ << 16 | wsxga_1600_x1024_ << 17 | wuxga_1920_x1200_ << 18 | woxga_2560_x1600_ << 19 | wqsxga_3200_x2048_ << 20 | wquxga_3840_x2400_ << 21 | whsxga_6400_x4096_ << 22 | whuxga_7680_x4800_ << 23 | cga_320_x200_ << 24 | ega_640_x350_ << 25 | hd480_852_x480_ << 26 | hd720_1280_x720_ << 27 | hd1080_1920_x1080_ << 28 | reserved_bits_)
            supported_digital_formats_ = self.supported_digital_formats
            if supported_digital_formats_ is not None:
                mask |= 32
                if type(supported_digital_formats_) is not environment_sensing_v1_0_types.SupportedDigitalFormats: raise rt.Reject
                avi_ = supported_digital_formats_.avi
                if not 0 <= avi_ <= 1: raise rt.Reject
                mjpeg_ = supported_digital_formats_.mjpeg
                if not 0 <= mjpeg_ <= 1: raise rt.Reject
                mpeg2_ = supported_digital_formats_.mpeg2
                if not 0 <= mpeg2_ <= 1: raise rt.Reject
                h263_ = supported_digital_formats_.h263
                if not 0 <= h263_ <= 1: raise rt.Reject
                h26_3_plus_ = supported_digital_formats_.h26_3_plus
                if not 0 <= h26_3_plus_ <= 1: raise rt.Reject
                mpeg4_visual_ = supported_digital_formats_.mpeg4_visual
                if not 0 <= mpeg4_visual_ <= 1: raise rt.Reject
                mpeg4_avc_h264_ = supported_digital_formats_.mpeg4_avc_h264
                if not 0 <= mpeg4_avc_h264_ <= 1: raise rt.Reject
                reserved_bits_2_ = supported_digital_formats_.reserved_bits
                if reserved_bits_2_ & 0x7F: raise rt.Reject
                raw.append(avi_ | mjpeg_ << 1 | mpeg2_ << 2 | h263_ << 3 | h26_3_plus_ << 4 | mpeg4_visual_ << 5 | mpeg4_avc_h264_ << 6 | reserved_bits_2_)
            recording_supported_ = self.recording_supported
            if recording_supported_ is not None:
                mask |= 64
                if recording_supported_ not in _E_ReportDigitalVideoSensorCapabilitiesExt_RecordingSupported: raise rt.Reject
                raw.append(recording_supported_)
            out += _M_ReportDigitalVideoSensorCapabilitiesExt_DigitalVideoSensorCapabilitiesRec_0[mask & 0x7F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    digital_video_sensor_list: list[ReportDigitalVideoSensorCapabilitiesExt.DigitalVideoSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DigitalVideoSensorList", rt.Repeat(rt.Count("H", 0, 65535), ReportDigitalVideoSensorCapabilitiesExt.DigitalVideoSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1D or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (digital_video_sensor_list_count_,) = _S_H.unpack_from(data, 2)
        if digital_video_sensor_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        digital_video_sensor_list_ = []
        for _ in range(digital_video_sensor_list_count_):
            item_, at = ReportDigitalVideoSensorCapabilitiesExt.DigitalVideoSensorCapabilitiesRec._read(data, at, nesting)
            digital_video_sensor_list_.append(item_)
        self.digital_video_sensor_list = digital_video_sensor_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1d\x48")
        digital_video_sensor_list_ = self.digital_video_sensor_list
        if type(digital_video_sensor_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_video_sensor_list_))
        for item_ in digital_video_sensor_list_:
            if type(item_) is not ReportDigitalVideoSensorCapabilitiesExt.DigitalVideoSensorCapabilitiesRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportDigitalVideoSensorConfiguration(rt.Message):
    """ReportDigitalVideoSensorConfiguration (0x4809): Tells the configuration of digital cameras.

    digital_video_sensor_configuration_list: 0..65535 items. The cameras
    """

    CODE = 0x4809
    NAME = "ReportDigitalVideoSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class FrameSize(IntEnum):
        """Values of FrameSize."""

        SQCIF_128_X96 = 0
        QCIF_176_X144 = 1
        CIF_352_X288 = 2
        CIF4_704_X576 = 3
        CIF16_1408_X1152 = 4
        QQVGA_160_X120 = 5
        QVGA_320_X240 = 6
        VGA_640_X480 = 7
        SVGA_800_X600 = 8
        XGA_1024_X768 = 9
        UXGA_1600_X1200 = 10
        QXGA_2048_X1536 = 11
        SXGA_1280_X1024 = 12
        QSXGA_2560_X2048 = 13
        HSXGA_5120_X4096 = 14
        WVGA_852_X480 = 15
        WXGA_1366_X768 = 16
        WSXGA_1600_X1024 = 17
        WUXGA_1920_X1200 = 18
        WOXGA_2560_X1600 = 19
        WQSXGA_3200_X2048 = 20
        WQUXGA_3840_X2400 = 21
        WHSXGA_6400_X4096 = 22
        WHUXGA_7680_X4800 = 23
        CGA_320_X200 = 24
        EGA_640_X350 = 25
        HD480_852_X480 = 26
        HD720_1280_X720 = 27
        HD1080_1920_X1080 = 28

    class DigitalFormat(IntEnum):
        """Values of DigitalFormat."""

        AVI = 0
        MJPEG = 1
        MPEG_2 = 2
        H_263 = 3
        H_263_PLUS = 4
        MPEG_4_VISUAL = 5
        MPEG_4_AVC = 6

    @dataclass(slots=True, repr=False)
    class DigitalVideoSensorConfigurationRec(rt.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        minimum_bit_rate: optional. Smallest bit rate, in kilobits per second
        maximum_bit_rate: optional. Largest bit rate, in kilobits per second
        frame_rate: optional. Frames per second
        frame_size: FrameSize, optional. Width and height of the image, in pixels
        digital_format: DigitalFormat, optional. Coding of the video
        """

        sensor_id: int
        minimum_bit_rate: int | None = None
        maximum_bit_rate: int | None = None
        frame_rate: int | None = None
        frame_size: ReportDigitalVideoSensorConfiguration.FrameSize | int | None = None
        digital_format: ReportDigitalVideoSensorConfiguration.DigitalFormat | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("MinimumBitRate", rt.Number("H"), True),
                ("MaximumBitRate", rt.Number("H"), True),
                ("FrameRate", rt.Number("B"), True),
                ("FrameSize", rt.Number("B", rt.Values(ReportDigitalVideoSensorConfiguration.FrameSize)), True),
                ("DigitalFormat", rt.Number("B", rt.Values(ReportDigitalVideoSensorConfiguration.DigitalFormat)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetDigitalVideoSensorConfiguration_DigitalVideoSensorConfigurationRec_0[mask & 0x1F]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            self.minimum_bit_rate = raw() if mask & 1 else None
            self.maximum_bit_rate = raw() if mask & 2 else None
            self.frame_rate = raw() if mask & 4 else None
            if mask & 8:
                frame_size_ = raw()
                self.frame_size = _E_ReportDigitalVideoSensorConfiguration_FrameSize[frame_size_]
            else: self.frame_size = None
            if mask & 16:
                digital_format_ = raw()
                self.digital_format = _E_ReportDigitalVideoSensorConfiguration_DigitalFormat[digital_format_]
            else: self.digital_format = None
            self.reserved_presence = mask & 0xE0
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x1F: raise rt.Reject
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            minimum_bit_rate_ = self.minimum_bit_rate
            if minimum_bit_rate_ is not None:
                mask |= 1
                raw.append(minimum_bit_rate_)
            maximum_bit_rate_ = self.maximum_bit_rate
            if maximum_bit_rate_ is not None:
                mask |= 2
                raw.append(maximum_bit_rate_)
            frame_rate_ = self.frame_rate
            if frame_rate_ is not None:
                mask |= 4
                raw.append(frame_rate_)
            frame_size_ = self.frame_size
            if frame_size_ is not None:
                mask |= 8
                if frame_size_ not in _E_ReportDigitalVideoSensorConfiguration_FrameSize: raise rt.Reject
                raw.append(frame_size_)
            digital_format_ = self.digital_format
            if digital_format_ is not None:
                mask |= 16
                if digital_format_ not in _E_ReportDigitalVideoSensorConfiguration_DigitalFormat: raise rt.Reject
                raw.append(digital_format_)
            out += _M_SetDigitalVideoSensorConfiguration_DigitalVideoSensorConfigurationRec_0[mask & 0x1F].pack(*raw)
            _S_B.pack_into(out, start, mask)

    digital_video_sensor_configuration_list: list[ReportDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DigitalVideoSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), ReportDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x09 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (digital_video_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        if digital_video_sensor_configuration_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        digital_video_sensor_configuration_list_ = []
        for _ in range(digital_video_sensor_configuration_list_count_):
            item_, at = ReportDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec._read(data, at, nesting)
            digital_video_sensor_configuration_list_.append(item_)
        self.digital_video_sensor_configuration_list = digital_video_sensor_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x09\x48")
        digital_video_sensor_configuration_list_ = self.digital_video_sensor_configuration_list
        if type(digital_video_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_video_sensor_configuration_list_))
        for item_ in digital_video_sensor_configuration_list_:
            if type(item_) is not ReportDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportDigitalVideoSensorStatus(rt.Message):
    """ReportDigitalVideoSensorStatus (0x481E): Tells whether cameras stream and record.

    digital_video_sensor_status_list: 0..65535 items. The cameras
    """

    CODE = 0x481E
    NAME = "ReportDigitalVideoSensorStatus"
    SERVICE = "urn:jaus:jss:environmentSensing:DigitalVideo"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    class StreamingState(IntEnum):
        """Values of StreamingState."""

        PLAY = 0
        PAUSE = 1
        STOP = 2

    class RecordingState(IntEnum):
        """Values of RecordingState."""

        NOT_RECORDING = 0
        RECORDING = 1

    @dataclass(slots=True, repr=False)
    class DigitalVideoSensorStatusRec(rt.Struct):
        """DigitalVideoSensorStatusRec.

        sensor_id: 1..65535. Identifies the sensor
        streaming_state: StreamingState. What the stream does
        recording_state: RecordingState. Whether the camera records
        """

        sensor_id: int
        streaming_state: ReportDigitalVideoSensorStatus.StreamingState | int
        recording_state: ReportDigitalVideoSensorStatus.RecordingState | int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("StreamingState", rt.Number("B", rt.Values(ReportDigitalVideoSensorStatus.StreamingState))),
                ("RecordingState", rt.Number("B", rt.Values(ReportDigitalVideoSensorStatus.RecordingState))),
            )

    digital_video_sensor_status_list: list[ReportDigitalVideoSensorStatus.DigitalVideoSensorStatusRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("DigitalVideoSensorStatusList", rt.Repeat(rt.Count("H", 0, 65535), ReportDigitalVideoSensorStatus.DigitalVideoSensorStatusRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1E or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (digital_video_sensor_status_list_count_,) = _S_H.unpack_from(data, 2)
        digital_video_sensor_status_list_end_ = 4 + digital_video_sensor_status_list_count_ * 4
        digital_video_sensor_status_list_ = []
        for sensor_id_, streaming_state_, recording_state_ in _S_H2B.iter_unpack(data[4:digital_video_sensor_status_list_end_]):
            if sensor_id_ < 1: raise rt.Reject
            digital_video_sensor_status_list_.append(ReportDigitalVideoSensorStatus.DigitalVideoSensorStatusRec(sensor_id_, _E_ReportDigitalVideoSensorStatus_StreamingState[streaming_state_], _E_ReportDigitalVideoSensorStatus_RecordingState[recording_state_]))
        self.digital_video_sensor_status_list = digital_video_sensor_status_list_
        if digital_video_sensor_status_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1e\x48")
        digital_video_sensor_status_list_ = self.digital_video_sensor_status_list
        if type(digital_video_sensor_status_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(digital_video_sensor_status_list_))
        for item_ in digital_video_sensor_status_list_:
            if type(item_) is not ReportDigitalVideoSensorStatus.DigitalVideoSensorStatusRec: raise rt.Reject
            sensor_id_ = item_.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            streaming_state_ = item_.streaming_state
            if streaming_state_ not in _E_ReportDigitalVideoSensorStatus_StreamingState: raise rt.Reject
            recording_state_ = item_.recording_state
            if recording_state_ not in _E_ReportDigitalVideoSensorStatus_RecordingState: raise rt.Reject
            out += _S_H2B.pack(sensor_id_, streaming_state_, recording_state_)
        return bytes(out)


_E_ControlDigitalVideoSensorStream_StreamState = rt.members(ControlDigitalVideoSensorStream.StreamState)
_S_2HB = rt.Packer("<2HB")
_E_ControlDigitalVideoSensorRecording_RequestedRecordingState = rt.members(ControlDigitalVideoSensorRecording.RequestedRecordingState)
_M_SetDigitalVideoSensorConfiguration_DigitalVideoSensorConfigurationRec_0 = rt.Masks("", ((0, "H"), (1, "H"), (2, "H"), (4, "B"), (8, "B"), (16, "B")))
_E_SetDigitalVideoSensorConfiguration_FrameSize = rt.members(SetDigitalVideoSensorConfiguration.FrameSize)
_E_SetDigitalVideoSensorConfiguration_DigitalFormat = rt.members(SetDigitalVideoSensorConfiguration.DigitalFormat)
_S_B = rt.Packer("<B")
_S_H = rt.Packer("<H")
_E_QueryDigitalVideoSensorConfiguration_SensorID = rt.members(QueryDigitalVideoSensorConfiguration.SensorID)
_S_HB = rt.Packer("<HB")
_E_QueryDigitalVideoSensorCapabilitiesExt_SensorID = rt.members(QueryDigitalVideoSensorCapabilitiesExt.SensorID)
_E_SensorIDQueryRec_SensorID = rt.members(environment_sensing_v1_0_types.SensorIDQueryRec.SensorID)
_L_H = rt.Rows("H")
_M_ReportDigitalVideoSensorCapabilitiesExt_DigitalVideoSensorCapabilitiesRec_0 = rt.Masks("", ((0, "H"), (1, "H"), (2, "H"), (4, "B"), (8, "B"), (16, "I"), (32, "B"), (64, "B")))
_E_SupportedFrameSizes_Sqcif_128x96 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Sqcif_128x96)
_E_SupportedFrameSizes_Qcif_176x144 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Qcif_176x144)
_E_SupportedFrameSizes_Cif_352x288 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Cif_352x288)
_E_SupportedFrameSizes_Cif4_704x576 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Cif4_704x576)
_E_SupportedFrameSizes_Cif16_1408x1152 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Cif16_1408x1152)
_E_SupportedFrameSizes_Qqvga_160x120 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Qqvga_160x120)
_E_SupportedFrameSizes_Qvga_320x240 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Qvga_320x240)
_E_SupportedFrameSizes_Vga_640x480 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Vga_640x480)
_E_SupportedFrameSizes_Svga_800x600 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Svga_800x600)
_E_SupportedFrameSizes_Xga_1024x768 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Xga_1024x768)
_E_SupportedFrameSizes_Uxga_1600x1200 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Uxga_1600x1200)
_E_SupportedFrameSizes_Qxga_2048x1536 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Qxga_2048x1536)
_E_SupportedFrameSizes_Sxga_1280x1024 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Sxga_1280x1024)
_E_SupportedFrameSizes_Qsxga_2560x2048 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Qsxga_2560x2048)
_E_SupportedFrameSizes_Hsxga_5120x4096 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Hsxga_5120x4096)
_E_SupportedFrameSizes_Wvga_852x480 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Wvga_852x480)
_E_SupportedFrameSizes_Wxga_1366x768 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Wxga_1366x768)
_E_SupportedFrameSizes_Wsxga_1600x1024 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Wsxga_1600x1024)
_E_SupportedFrameSizes_Wuxga_1920x1200 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Wuxga_1920x1200)
_E_SupportedFrameSizes_Woxga_2560x1600 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Woxga_2560x1600)
_E_SupportedFrameSizes_Wqsxga_3200x2048 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Wqsxga_3200x2048)
_E_SupportedFrameSizes_Wquxga_3840x2400 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Wquxga_3840x2400)
_E_SupportedFrameSizes_Whsxga_6400x4096 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Whsxga_6400x4096)
_E_SupportedFrameSizes_Whuxga_7680x4800 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Whuxga_7680x4800)
_E_SupportedFrameSizes_Cga_320x200 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Cga_320x200)
_E_SupportedFrameSizes_Ega_640x350 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Ega_640x350)
_E_SupportedFrameSizes_Hd480_852x480 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Hd480_852x480)
_E_SupportedFrameSizes_Hd720_1280x720 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Hd720_1280x720)
_E_SupportedFrameSizes_Hd1080_1920x1080 = rt.members(environment_sensing_v1_0_types.SupportedFrameSizes.Hd1080_1920x1080)
_E_SupportedDigitalFormats_AVI = rt.members(environment_sensing_v1_0_types.SupportedDigitalFormats.AVI)
_E_SupportedDigitalFormats_MJPEG = rt.members(environment_sensing_v1_0_types.SupportedDigitalFormats.MJPEG)
_E_SupportedDigitalFormats_MPEG2 = rt.members(environment_sensing_v1_0_types.SupportedDigitalFormats.MPEG2)
_E_SupportedDigitalFormats_H263 = rt.members(environment_sensing_v1_0_types.SupportedDigitalFormats.H263)
_E_SupportedDigitalFormats_H263plus = rt.members(environment_sensing_v1_0_types.SupportedDigitalFormats.H263plus)
_E_SupportedDigitalFormats_MPEG4_Visual = rt.members(environment_sensing_v1_0_types.SupportedDigitalFormats.MPEG4_Visual)
_E_SupportedDigitalFormats_MPEG4_AVC_h264 = rt.members(environment_sensing_v1_0_types.SupportedDigitalFormats.MPEG4_AVC_h264)
_E_ReportDigitalVideoSensorCapabilitiesExt_RecordingSupported = rt.members(ReportDigitalVideoSensorCapabilitiesExt.RecordingSupported)
_E_ReportDigitalVideoSensorConfiguration_FrameSize = rt.members(ReportDigitalVideoSensorConfiguration.FrameSize)
_E_ReportDigitalVideoSensorConfiguration_DigitalFormat = rt.members(ReportDigitalVideoSensorConfiguration.DigitalFormat)
_E_ReportDigitalVideoSensorStatus_StreamingState = rt.members(ReportDigitalVideoSensorStatus.StreamingState)
_E_ReportDigitalVideoSensorStatus_RecordingState = rt.members(ReportDigitalVideoSensorStatus.RecordingState)
_S_H2B = rt.Packer("<H2B")
QueryDigitalVideoSensorConfiguration.REPORT = ReportDigitalVideoSensorConfiguration
QueryDigitalVideoSensorCapabilitiesExt.REPORT = ReportDigitalVideoSensorCapabilitiesExt
QueryDigitalVideoSensorStatus.REPORT = ReportDigitalVideoSensorStatus
