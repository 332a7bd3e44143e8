"""urn:jaus:jss:environmentSensing:StillImage 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types


@dataclass(slots=True, repr=False)
class SetStillImageSensorConfiguration(rt.Message):
    """SetStillImageSensorConfiguration (0x0807): Sets the configuration of still image cameras.

    still_image_sensor_list: 0..65535 items. The cameras
    """

    CODE = 0x0807
    NAME = "SetStillImageSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:StillImage"
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

    class StillImageFormat(IntEnum):
        """Values of StillImageFormat."""

        JPEG = 0
        GIF = 1
        PNG = 2
        BMP = 3
        TIFF = 4
        PPM = 5
        PGM = 6
        PNM = 7
        NEF = 8
        CR2 = 9
        DNG = 10

    @dataclass(slots=True, repr=False)
    class StillImageSensorConfigurationRec(rt.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        frame_size: FrameSize, optional. Width and height of the image, in pixels
        still_image_format: StillImageFormat, optional. Coding of the image
        """

        sensor_id: int
        frame_size: SetStillImageSensorConfiguration.FrameSize | int | None = None
        still_image_format: SetStillImageSensorConfiguration.StillImageFormat | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("FrameSize", rt.Number("B", rt.Values(SetStillImageSensorConfiguration.FrameSize)), True),
                ("StillImageFormat", rt.Number("B", rt.Values(SetStillImageSensorConfiguration.StillImageFormat)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetStillImageSensorConfiguration_StillImageSensorConfigurationRec_0[mask & 0x3]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            if mask & 1:
                frame_size_ = raw()
                self.frame_size = _E_SetStillImageSensorConfiguration_FrameSize[frame_size_]
            else: self.frame_size = None
            if mask & 2:
                still_image_format_ = raw()
                self.still_image_format = _E_SetStillImageSensorConfiguration_StillImageFormat[still_image_format_]
            else: self.still_image_format = None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            frame_size_ = self.frame_size
            if frame_size_ is not None:
                mask |= 1
                if frame_size_ not in _E_SetStillImageSensorConfiguration_FrameSize: raise rt.Reject
                raw.append(frame_size_)
            still_image_format_ = self.still_image_format
            if still_image_format_ is not None:
                mask |= 2
                if still_image_format_ not in _E_SetStillImageSensorConfiguration_StillImageFormat: raise rt.Reject
                raw.append(still_image_format_)
            out += _M_SetStillImageSensorConfiguration_StillImageSensorConfigurationRec_0[mask & 0x3].pack(*raw)
            _S_B.pack_into(out, start, mask)

    request_id_rec: SetStillImageSensorConfiguration.RequestIdRec
    still_image_sensor_list: list[SetStillImageSensorConfiguration.StillImageSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestIdRec", SetStillImageSensorConfiguration.RequestIdRec.layout()),
            ("StillImageSensorList", rt.Repeat(rt.Count("H", 0, 65535), SetStillImageSensorConfiguration.StillImageSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x07 or data[1] != 0x08: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_id_ = data[2]
        self.request_id_rec = SetStillImageSensorConfiguration.RequestIdRec(request_id_)
        (still_image_sensor_list_count_,) = _S_H.unpack_from(data, 3)
        if still_image_sensor_list_count_ * 3 > size - 5: raise rt.Reject
        at = 5
        still_image_sensor_list_ = []
        for _ in range(still_image_sensor_list_count_):
            item_, at = SetStillImageSensorConfiguration.StillImageSensorConfigurationRec._read(data, at, nesting)
            still_image_sensor_list_.append(item_)
        self.still_image_sensor_list = still_image_sensor_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x07\x08")
        request_id_rec_ = self.request_id_rec
        if type(request_id_rec_) is not SetStillImageSensorConfiguration.RequestIdRec: raise rt.Reject
        out.append(request_id_rec_.request_id)
        still_image_sensor_list_ = self.still_image_sensor_list
        if type(still_image_sensor_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(still_image_sensor_list_))
        for item_ in still_image_sensor_list_:
            if type(item_) is not SetStillImageSensorConfiguration.StillImageSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryStillImageDataExt(rt.Message):
    """QueryStillImageDataExt (0x281C): Asks for images, or for where to fetch them.

    query_still_image_data_list: 0..65535 items. The cameras
    """

    CODE = 0x281C
    NAME = "QueryStillImageDataExt"
    SERVICE = "urn:jaus:jss:environmentSensing:StillImage"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportStillImageDataExt]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    class ReportCoordinateSystem(IntEnum):
        """Values of ReportCoordinateSystem."""

        NATIVE = 0
        VEHICLE = 1

    @dataclass(slots=True, repr=False)
    class QueryStillImageDataRec(rt.Struct):
        """QueryStillImageDataRec.

        sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: QueryStillImageDataExt.SensorID | int
        report_coordinate_system: QueryStillImageDataExt.ReportCoordinateSystem | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(QueryStillImageDataExt.SensorID, ((1, 65535),)))),
                ("ReportCoordinateSystem", rt.Number("B", rt.Values(QueryStillImageDataExt.ReportCoordinateSystem))),
                ("QueryPresenceVector", rt.Number("B")),
            )

    query_still_image_data_list: list[QueryStillImageDataExt.QueryStillImageDataRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryStillImageDataList", rt.Repeat(rt.Count("H", 0, 65535), QueryStillImageDataExt.QueryStillImageDataRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1C or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_still_image_data_list_count_,) = _S_H.unpack_from(data, 2)
        query_still_image_data_list_end_ = 4 + query_still_image_data_list_count_ * 4
        self.query_still_image_data_list = [QueryStillImageDataExt.QueryStillImageDataRec(_E_QueryStillImageDataExt_SensorID.get(sensor_id_, sensor_id_), _E_QueryStillImageDataExt_ReportCoordinateSystem[report_coordinate_system_], query_presence_vector_) for sensor_id_, report_coordinate_system_, query_presence_vector_ in _S_H2B.iter_unpack(data[4:query_still_image_data_list_end_])]
        if query_still_image_data_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1c\x28")
        query_still_image_data_list_ = self.query_still_image_data_list
        if type(query_still_image_data_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_still_image_data_list_))
        for item_ in query_still_image_data_list_:
            if type(item_) is not QueryStillImageDataExt.QueryStillImageDataRec: raise rt.Reject
            report_coordinate_system_ = item_.report_coordinate_system
            if report_coordinate_system_ not in _E_QueryStillImageDataExt_ReportCoordinateSystem: raise rt.Reject
            out += _S_H2B.pack(item_.sensor_id, report_coordinate_system_, item_.query_presence_vector)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryStillImageSensorConfiguration(rt.Message):
    """QueryStillImageSensorConfiguration (0x2813): Asks for the configuration of still image cameras.

    query_still_image_sensor_configuration_list: 0..65535 items. The cameras
    """

    CODE = 0x2813
    NAME = "QueryStillImageSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:StillImage"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportStillImageSensorConfiguration]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    @dataclass(slots=True, repr=False)
    class QueryStillImageSensorConfigurationRec(rt.Struct):
        """QueryStillImageSensorConfigurationRec.

        sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: QueryStillImageSensorConfiguration.SensorID | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(QueryStillImageSensorConfiguration.SensorID, ((1, 65535),)))),
                ("QueryPresenceVector", rt.Number("B")),
            )

    query_still_image_sensor_configuration_list: list[QueryStillImageSensorConfiguration.QueryStillImageSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryStillImageSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), QueryStillImageSensorConfiguration.QueryStillImageSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x13 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_still_image_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        query_still_image_sensor_configuration_list_end_ = 4 + query_still_image_sensor_configuration_list_count_ * 3
        self.query_still_image_sensor_configuration_list = [QueryStillImageSensorConfiguration.QueryStillImageSensorConfigurationRec(_E_QueryStillImageSensorConfiguration_SensorID.get(sensor_id_, sensor_id_), query_presence_vector_) for sensor_id_, query_presence_vector_ in _S_HB.iter_unpack(data[4:query_still_image_sensor_configuration_list_end_])]
        if query_still_image_sensor_configuration_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x13\x28")
        query_still_image_sensor_configuration_list_ = self.query_still_image_sensor_configuration_list
        if type(query_still_image_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_still_image_sensor_configuration_list_))
        for item_ in query_still_image_sensor_configuration_list_:
            if type(item_) is not QueryStillImageSensorConfiguration.QueryStillImageSensorConfigurationRec: raise rt.Reject
            out += _S_HB.pack(item_.sensor_id, item_.query_presence_vector)
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryStillImageSensorCapabilities(rt.Message):
    """QueryStillImageSensorCapabilities (0x2812): Asks what still image cameras can do.

    query_still_image_sensor_capabilities_list: 0..65535 items. The cameras
    """

    CODE = 0x2812
    NAME = "QueryStillImageSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:StillImage"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportStillImageSensorCapabilities]]

    class SensorID(IntEnum):
        """Values of SensorID."""

        ALL_SENSORS = 0

    @dataclass(slots=True, repr=False)
    class QueryStillImageSensorCapabilitiesRec(rt.Struct):
        """QueryStillImageSensorCapabilitiesRec.

        sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """

        sensor_id: QueryStillImageSensorCapabilities.SensorID | int
        query_presence_vector: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("SensorID", rt.Number("H", rt.Values(QueryStillImageSensorCapabilities.SensorID, ((1, 65535),)))),
                ("QueryPresenceVector", rt.Number("B")),
            )

    query_still_image_sensor_capabilities_list: list[QueryStillImageSensorCapabilities.QueryStillImageSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("QueryStillImageSensorCapabilitiesList", rt.Repeat(rt.Count("H", 0, 65535), QueryStillImageSensorCapabilities.QueryStillImageSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x12 or data[1] != 0x28: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (query_still_image_sensor_capabilities_list_count_,) = _S_H.unpack_from(data, 2)
        query_still_image_sensor_capabilities_list_end_ = 4 + query_still_image_sensor_capabilities_list_count_ * 3
        self.query_still_image_sensor_capabilities_list = [QueryStillImageSensorCapabilities.QueryStillImageSensorCapabilitiesRec(_E_QueryStillImageSensorCapabilities_SensorID.get(sensor_id_, sensor_id_), query_presence_vector_) for sensor_id_, query_presence_vector_ in _S_HB.iter_unpack(data[4:query_still_image_sensor_capabilities_list_end_])]
        if query_still_image_sensor_capabilities_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x12\x28")
        query_still_image_sensor_capabilities_list_ = self.query_still_image_sensor_capabilities_list
        if type(query_still_image_sensor_capabilities_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(query_still_image_sensor_capabilities_list_))
        for item_ in query_still_image_sensor_capabilities_list_:
            if type(item_) is not QueryStillImageSensorCapabilities.QueryStillImageSensorCapabilitiesRec: raise rt.Reject
            out += _S_HB.pack(item_.sensor_id, item_.query_presence_vector)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportStillImageDataExt(rt.Message):
    """ReportStillImageDataExt (0x481C): Carries images, or tells where to fetch them.

    still_image_data_list: 0..65535 items. The images
    """

    CODE = 0x481C
    NAME = "ReportStillImageDataExt"
    SERVICE = "urn:jaus:jss:environmentSensing:StillImage"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    TimeStamp = core_v1_0_types.TimeStamp

    class ReportCoordinateSystem(IntEnum):
        """Values of ReportCoordinateSystem."""

        NATIVE = 0
        VEHICLE = 1

    class ImageFrameFormat(IntEnum):
        """Values of ImageFrameFormat."""

        JPEG = 0
        GIF = 1
        PNG = 2
        BMP = 3
        TIFF = 4
        PPM = 5
        PGM = 6
        PNM = 7
        NEF = 8
        CR2 = 9
        DNG = 10

    @dataclass(slots=True, repr=False)
    class ImageFrame(rt.Struct):
        """The image."""

        format: ReportStillImageDataExt.ImageFrameFormat | int
        data: bytes

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.Formatted(cls, rt.Values(ReportStillImageDataExt.ImageFrameFormat), rt.Count("I", 0, 2147483647))

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            format = data[at]
            self.format = _E_ReportStillImageDataExt_ImageFrameFormat[format]
            (data_end_,) = _S_I.unpack_from(data, at + 1)
            if data_end_ > 2147483647: raise rt.Reject
            data_end_ += at + 5
            self.data = data[at + 5:data_end_]
            return self, data_end_

        def _write(self, out: bytearray) -> None:
            format = self.format
            if format not in _E_ReportStillImageDataExt_ImageFrameFormat: raise rt.Reject
            out.append(format)
            data_raw_ = rt.plain_bytes(self.data)
            if len(data_raw_) > 2147483647: raise rt.Reject
            out += _S_I.pack(len(data_raw_))
            out += data_raw_

    @dataclass(slots=True, repr=False)
    class StillImageDataRec(rt.Struct):
        """StillImageDataRec.

        sensor_id: 1..65535. Identifies the sensor
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        time_stamp: optional. Time within the month, in UTC
        image_frame: optional. The image
        still_image_uri: up to 255 characters, optional. Where to fetch the image
        """

        sensor_id: int
        report_coordinate_system: ReportStillImageDataExt.ReportCoordinateSystem | int
        time_stamp: core_v1_0_types.TimeStamp | None = None
        image_frame: ReportStillImageDataExt.ImageFrame | None = None
        still_image_uri: str | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("ReportCoordinateSystem", rt.Number("B", rt.Values(ReportStillImageDataExt.ReportCoordinateSystem))),
                ("TimeStamp", core_v1_0_types.TimeStamp.layout(), True),
                ("ImageFrame", ReportStillImageDataExt.ImageFrame.layout(), True),
                ("StillImageURI", rt.Text(count=rt.Count("B", 0, 255)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportStillImageDataExt_StillImageDataRec_0[mask & 0x1]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            report_coordinate_system_ = raw()
            self.report_coordinate_system = _E_ReportStillImageDataExt_ReportCoordinateSystem[report_coordinate_system_]
            if mask & 1:
                time_stamp_ = raw()
                milliseconds_ = time_stamp_ & 0x3FF
                if milliseconds_ > 999: raise rt.Reject
                seconds_ = time_stamp_ >> 10 & 0x3F
                if seconds_ > 59: raise rt.Reject
                minutes_ = time_stamp_ >> 16 & 0x3F
                if minutes_ > 59: raise rt.Reject
                hour_ = time_stamp_ >> 22 & 0x1F
                if hour_ > 23: raise rt.Reject
                day_ = time_stamp_ >> 27 & 0x1F
                if day_ < 1: raise rt.Reject
                self.time_stamp = core_v1_0_types.TimeStamp(milliseconds_, seconds_, minutes_, hour_, day_)
            else: self.time_stamp = None
            if mask & 2:
                self.image_frame, at = ReportStillImageDataExt.ImageFrame._read(data, at, nesting)
            else: self.image_frame = None
            if mask & 4:
                still_image_uri_end_ = at + 1 + data[at]
                self.still_image_uri = data[at + 1:still_image_uri_end_].decode("latin-1")
                at = still_image_uri_end_
            else: self.still_image_uri = None
            self.reserved_presence = mask & 0xF8
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x7: raise rt.Reject
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            report_coordinate_system_ = self.report_coordinate_system
            if report_coordinate_system_ not in _E_ReportStillImageDataExt_ReportCoordinateSystem: raise rt.Reject
            raw.append(report_coordinate_system_)
            time_stamp_ = self.time_stamp
            if time_stamp_ is not None:
                mask |= 1
                if type(time_stamp_) is not core_v1_0_types.TimeStamp: raise rt.Reject
                milliseconds_ = time_stamp_.milliseconds
                if not 0 <= milliseconds_ <= 999: raise rt.Reject
                seconds_ = time_stamp_.seconds
                if not 0 <= seconds_ <= 59: raise rt.Reject
                minutes_ = time_stamp_.minutes
                if not 0 <= minutes_ <= 59: raise rt.Reject
                hour_ = time_stamp_.hour
                if not 0 <= hour_ <= 23: raise rt.Reject
                day_ = time_stamp_.day
                if not 1 <= day_ <= 31: raise rt.Reject
                raw.append(milliseconds_ | seconds_ << 10 | minutes_ << 16 | hour_ << 22 | day_ << 27)
            out += _M_ReportStillImageDataExt_StillImageDataRec_0[mask & 0x1].pack(*raw)
            image_frame_ = self.image_frame
            if image_frame_ is not None:
                mask |= 2
                if type(image_frame_) is not ReportStillImageDataExt.ImageFrame: raise rt.Reject
                image_frame_._write(out)
            still_image_uri_ = self.still_image_uri
            if still_image_uri_ is not None:
                mask |= 4
                still_image_uri_raw_ = still_image_uri_.encode("latin-1")
                out.append(len(still_image_uri_raw_))
                out += still_image_uri_raw_
            _S_B.pack_into(out, start, mask)

    still_image_data_list: list[ReportStillImageDataExt.StillImageDataRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("StillImageDataList", rt.Repeat(rt.Count("H", 0, 65535), ReportStillImageDataExt.StillImageDataRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x1C or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (still_image_data_list_count_,) = _S_H.unpack_from(data, 2)
        if still_image_data_list_count_ * 4 > size - 4: raise rt.Reject
        at = 4
        still_image_data_list_ = []
        for _ in range(still_image_data_list_count_):
            item_, at = ReportStillImageDataExt.StillImageDataRec._read(data, at, nesting)
            still_image_data_list_.append(item_)
        self.still_image_data_list = still_image_data_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x1c\x48")
        still_image_data_list_ = self.still_image_data_list
        if type(still_image_data_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(still_image_data_list_))
        for item_ in still_image_data_list_:
            if type(item_) is not ReportStillImageDataExt.StillImageDataRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportStillImageSensorConfiguration(rt.Message):
    """ReportStillImageSensorConfiguration (0x4813): Tells the configuration of still image cameras.

    still_image_sensor_configuration_list: 0..65535 items. The cameras
    """

    CODE = 0x4813
    NAME = "ReportStillImageSensorConfiguration"
    SERVICE = "urn:jaus:jss:environmentSensing:StillImage"
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

    class StillImageFormat(IntEnum):
        """Values of StillImageFormat."""

        JPEG = 0
        GIF = 1
        PNG = 2
        BMP = 3
        TIFF = 4
        PPM = 5
        PGM = 6
        PNM = 7
        NEF = 8
        CR2 = 9
        DNG = 10

    @dataclass(slots=True, repr=False)
    class StillImageSensorConfigurationRec(rt.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        frame_size: FrameSize, optional. Width and height of the image, in pixels
        still_image_format: StillImageFormat, optional. Coding of the image
        """

        sensor_id: int
        frame_size: ReportStillImageSensorConfiguration.FrameSize | int | None = None
        still_image_format: ReportStillImageSensorConfiguration.StillImageFormat | int | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("FrameSize", rt.Number("B", rt.Values(ReportStillImageSensorConfiguration.FrameSize)), True),
                ("StillImageFormat", rt.Number("B", rt.Values(ReportStillImageSensorConfiguration.StillImageFormat)), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_SetStillImageSensorConfiguration_StillImageSensorConfigurationRec_0[mask & 0x3]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            if mask & 1:
                frame_size_ = raw()
                self.frame_size = _E_ReportStillImageSensorConfiguration_FrameSize[frame_size_]
            else: self.frame_size = None
            if mask & 2:
                still_image_format_ = raw()
                self.still_image_format = _E_ReportStillImageSensorConfiguration_StillImageFormat[still_image_format_]
            else: self.still_image_format = None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            frame_size_ = self.frame_size
            if frame_size_ is not None:
                mask |= 1
                if frame_size_ not in _E_ReportStillImageSensorConfiguration_FrameSize: raise rt.Reject
                raw.append(frame_size_)
            still_image_format_ = self.still_image_format
            if still_image_format_ is not None:
                mask |= 2
                if still_image_format_ not in _E_ReportStillImageSensorConfiguration_StillImageFormat: raise rt.Reject
                raw.append(still_image_format_)
            out += _M_SetStillImageSensorConfiguration_StillImageSensorConfigurationRec_0[mask & 0x3].pack(*raw)
            _S_B.pack_into(out, start, mask)

    still_image_sensor_configuration_list: list[ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("StillImageSensorConfigurationList", rt.Repeat(rt.Count("H", 0, 65535), ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x13 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (still_image_sensor_configuration_list_count_,) = _S_H.unpack_from(data, 2)
        if still_image_sensor_configuration_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        still_image_sensor_configuration_list_ = []
        for _ in range(still_image_sensor_configuration_list_count_):
            item_, at = ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec._read(data, at, nesting)
            still_image_sensor_configuration_list_.append(item_)
        self.still_image_sensor_configuration_list = still_image_sensor_configuration_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x13\x48")
        still_image_sensor_configuration_list_ = self.still_image_sensor_configuration_list
        if type(still_image_sensor_configuration_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(still_image_sensor_configuration_list_))
        for item_ in still_image_sensor_configuration_list_:
            if type(item_) is not ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ReportStillImageSensorCapabilities(rt.Message):
    """ReportStillImageSensorCapabilities (0x4812): Tells what still image cameras can do.

    still_image_sensor_list: 0..65535 items. The cameras
    """

    CODE = 0x4812
    NAME = "ReportStillImageSensorCapabilities"
    SERVICE = "urn:jaus:jss:environmentSensing:StillImage"
    VERSION = "2.0"
    IS_COMMAND = False
    IS_QUERY = False

    SupportedFrameSizes = environment_sensing_v1_0_types.SupportedFrameSizes
    SupportedImageFormats = environment_sensing_v1_0_types.SupportedImageFormats

    @dataclass(slots=True, repr=False)
    class StillImageSensorCapabilitiesRec(rt.Struct):
        """StillImageSensorCapabilitiesRec.

        sensor_id: 1..65535. Identifies the sensor
        supported_frame_sizes: optional. Sizes of image that the camera offers
        supported_image_formats: optional. Codings of image that the camera offers
        """

        sensor_id: int
        supported_frame_sizes: environment_sensing_v1_0_types.SupportedFrameSizes | None = None
        supported_image_formats: environment_sensing_v1_0_types.SupportedImageFormats | None = None
        reserved_presence: int = 0

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, "B",
                ("SensorID", rt.Number("H", rt.Values(None, ((1, 65535),)))),
                ("SupportedFrameSizes", environment_sensing_v1_0_types.SupportedFrameSizes.layout(), True),
                ("SupportedImageFormats", environment_sensing_v1_0_types.SupportedImageFormats.layout(), True),
            )

        @classmethod
        def _read(cls, data: bytes, at: int, nesting: rt.Nesting | None) -> tuple[Self, int]:
            self = rt.new(cls)
            mask = data[at]
            packer = _M_ReportStillImageSensorCapabilities_StillImageSensorCapabilitiesRec_0[mask & 0x3]
            raw = iter(packer.unpack_from(data, at + 1)).__next__
            at = at + 1 + packer.size
            sensor_id_ = raw()
            if sensor_id_ < 1: raise rt.Reject
            self.sensor_id = sensor_id_
            if mask & 1:
                supported_frame_sizes_ = raw()
                self.supported_frame_sizes = environment_sensing_v1_0_types.SupportedFrameSizes(_E_SupportedFrameSizes_Sqcif_128x96.get(supported_frame_sizes_ & 0x1, supported_frame_sizes_ & 0x1), _E_SupportedFrameSizes_Qcif_176x144.get(supported_frame_sizes_ >> 1 & 0x1, supported_frame_sizes_ >> 1 & 0x1), _E_SupportedFrameSizes_Cif_352x288.get(supported_frame_sizes_ >> 2 & 0x1, supported_frame_sizes_ >> 2 & 0x1), _E_SupportedFrameSizes_Cif4_704x576.get(supported_frame_sizes_ >> 3 & 0x1, supported_frame_sizes_ >> 3 & 0x1), _E_SupportedFrameSizes_Cif16_1408x1152.get(supported_frame_sizes_ >> 4 & 0x1, supported_frame_sizes_ >> 4 & 0x1), _E_SupportedFrameSizes_Qqvga_160x120.get(supported_frame_sizes_ >> 5 & 0x1, supported_frame_sizes_ >> 5 & 0x1), _E_SupportedFrameSizes_Qvga_320x240.get(supported_frame_sizes_ >> 6 & 0x1, supported_frame_sizes_ >> 6 & 0x1), _E_SupportedFrameSizes_Vga_640x480.get(supported_frame_sizes_ >> 7 & 0x1, supported_frame_sizes_ >> 7 & 0x1), _E_SupportedFrameSizes_Svga_800x600.get(supported_frame_sizes_ >> 8 & 0x1, supported_frame_sizes_ >> 8 & 0x1), _E_SupportedFrameSizes_Xga_1024x768.get(supported_frame_sizes_ >> 9 & 0x1, supported_frame_sizes_ >> 9 & 0x1), _E_SupportedFrameSizes_Uxga_1600x1200.get(supported_frame_sizes_ >> 10 & 0x1, supported_frame_sizes_ >> 10 & 0x1), _E_SupportedFrameSizes_Qxga_2048x1536.get(supported_frame_sizes_ >> 11 & 0x1, supported_frame_sizes_ >> 11 & 0x1), _E_SupportedFrameSizes_Sxga_1280x1024.get(supported_frame_sizes_ >> 12 & 0x1, supported_frame_sizes_ >> 12 & 0x1), _E_SupportedFrameSizes_Qsxga_2560x2048.get(supported_frame_sizes_ >> 13 & 0x1, supported_frame_sizes_ >> 13 & 0x1), _E_SupportedFrameSizes_Hsxga_5120x4096.get(supported_frame_sizes_ >> 14 & 0x1, supported_frame_sizes_ >> 14 & 0x1), _E_SupportedFrameSizes_Wvga_852x480.get(supported_frame_sizes_ >> 15 & 0x1, supported_frame_sizes_ >> 15 & 0x1), _E_SupportedFrameSizes_Wxga_1366x768.get(supported_frame_sizes_ >> 16 & 0x1, supported_frame_sizes_ >> 16 & 0x1), _E_SupportedFrameSizes_Wsxga_1600x1024.get(supported_frame_sizes_ >> 17 & 0x1, supported_frame_sizes_ >> 17 & 0x1), _E_SupportedFrameSizes_Wuxga_1920x1200.get(supported_frame_sizes_ >> 18 & 0x1, supported_frame_sizes_ >> 18 & 0x1), _E_SupportedFrameSizes_Woxga_2560x1600.get(supported_frame_sizes_ >> 19 & 0x1, supported_frame_sizes_ >> 19 & 0x1), _E_SupportedFrameSizes_Wqsxga_3200x2048.get(supported_frame_sizes_ >> 20 & 0x1, supported_frame_sizes_ >> 20 & 0x1), _E_SupportedFrameSizes_Wquxga_3840x2400.get(supported_frame_sizes_ >> 21 & 0x1, supported_frame_sizes_ >> 21 & 0x1), _E_SupportedFrameSizes_Whsxga_6400x4096.get(supported_frame_sizes_ >> 22 & 0x1, supported_frame_sizes_ >> 22 & 0x1), _E_SupportedFrameSizes_Whuxga_7680x4800.get(supported_frame_sizes_ >> 23 & 0x1, supported_frame_sizes_ >> 23 & 0x1), _E_SupportedFrameSizes_Cga_320x200.get(supported_frame_sizes_ >> 24 & 0x1, supported_frame_sizes_ >> 24 & 0x1), _E_SupportedFrameSizes_Ega_640x350.get(supported_frame_sizes_ >> 25 & 0x1, supported_frame_sizes_ >> 25 & 0x1), _E_SupportedFrameSizes_Hd480_852x480.get(supported_frame_sizes_ >> 26 & 0x1, supported_frame_sizes_ >> 26 & 0x1), _E_SupportedFrameSizes_Hd720_1280x720.get(supported_frame_sizes_ >> 27 & 0x1, supported_frame_sizes_ >> 27 & 0x1), _E_SupportedFrameSizes_Hd1080_1920x1080.get(supported_frame_sizes_ >> 28 & 0x1, supported_frame_sizes_ >> 28 & 0x1), supported_frame_sizes_ & 0xE0000000)
            else: self.supported_frame_sizes = None
            if mask & 2:
                supported_image_formats_ = raw()
                self.supported_image_formats = environment_sensing_v1_0_types.SupportedImageFormats(_E_SupportedImageFormats_JPEG.get(supported_image_formats_ & 0x1, supported_image_formats_ & 0x1), _E_SupportedImageFormats_GIF.get(supported_image_formats_ >> 1 & 0x1, supported_image_formats_ >> 1 & 0x1), _E_SupportedImageFormats_PNG.get(supported_image_formats_ >> 2 & 0x1, supported_image_formats_ >> 2 & 0x1), _E_SupportedImageFormats_BMP.get(supported_image_formats_ >> 3 & 0x1, supported_image_formats_ >> 3 & 0x1), _E_SupportedImageFormats_TIFF.get(supported_image_formats_ >> 4 & 0x1, supported_image_formats_ >> 4 & 0x1), _E_SupportedImageFormats_PPM.get(supported_image_formats_ >> 5 & 0x1, supported_image_formats_ >> 5 & 0x1), _E_SupportedImageFormats_PGM.get(supported_image_formats_ >> 6 & 0x1, supported_image_formats_ >> 6 & 0x1), _E_SupportedImageFormats_PNM.get(supported_image_formats_ >> 7 & 0x1, supported_image_formats_ >> 7 & 0x1), _E_SupportedImageFormats_NEF_Nikon_RAW.get(supported_image_formats_ >> 8 & 0x1, supported_image_formats_ >> 8 & 0x1), _E_SupportedImageFormats_CR2_Canon_RAW.get(supported_image_formats_ >> 9 & 0x1, supported_image_formats_ >> 9 & 0x1), _E_SupportedImageFormats_DNG_Adobe_RAW.get(supported_image_formats_ >> 10 & 0x1, supported_image_formats_ >> 10 & 0x1), supported_image_formats_ & 0xF800)
            else: self.supported_image_formats = None
            self.reserved_presence = mask & 0xFC
            return self, at

        def _write(self, out: bytearray) -> None:
            start = len(out)
            out += b"\0"
            mask = self.reserved_presence
            if mask & 0x3: raise rt.Reject
            raw: list[int | float | bytes] = []
            sensor_id_ = self.sensor_id
            if not 1 <= sensor_id_ <= 65535: raise rt.Reject
            raw.append(sensor_id_)
            supported_frame_sizes_ = self.supported_frame_sizes
            if supported_frame_sizes_ is not None:
                mask |= 1
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
            supported_image_formats_ = self.supported_image_formats
            if supported_image_formats_ is not None:
                mask |= 2
                if type(supported_image_formats_) is not environment_sensing_v1_0_types.SupportedImageFormats: raise rt.Reject
                jpeg_ = supported_image_formats_.jpeg
                if not 0 <= jpeg_ <= 1: raise rt.Reject
                gif_ = supported_image_formats_.gif
                if not 0 <= gif_ <= 1: raise rt.Reject
                png_ = supported_image_formats_.png
                if not 0 <= png_ <= 1: raise rt.Reject
                bmp_ = supported_image_formats_.bmp
                if not 0 <= bmp_ <= 1: raise rt.Reject
                tiff_ = supported_image_formats_.tiff
                if not 0 <= tiff_ <= 1: raise rt.Reject
                ppm_ = supported_image_formats_.ppm
                if not 0 <= ppm_ <= 1: raise rt.Reject
                pgm_ = supported_image_formats_.pgm
                if not 0 <= pgm_ <= 1: raise rt.Reject
                pnm_ = supported_image_formats_.pnm
                if not 0 <= pnm_ <= 1: raise rt.Reject
                nef_nikon_raw_ = supported_image_formats_.nef_nikon_raw
                if not 0 <= nef_nikon_raw_ <= 1: raise rt.Reject
                cr2_canon_raw_ = supported_image_formats_.cr2_canon_raw
                if not 0 <= cr2_canon_raw_ <= 1: raise rt.Reject
                dng_adobe_raw_ = supported_image_formats_.dng_adobe_raw
                if not 0 <= dng_adobe_raw_ <= 1: raise rt.Reject
                reserved_bits_2_ = supported_image_formats_.reserved_bits
                if reserved_bits_2_ & 0x7FF: raise rt.Reject
                raw.append(jpeg_ | gif_ << 1 | png_ << 2 | bmp_ << 3 | tiff_ << 4 | ppm_ << 5 | pgm_ << 6 | pnm_ << 7 | nef_nikon_raw_ << 8 | cr2_canon_raw_ << 9 | dng_adobe_raw_ << 10 | reserved_bits_2_)
            out += _M_ReportStillImageSensorCapabilities_StillImageSensorCapabilitiesRec_0[mask & 0x3].pack(*raw)
            _S_B.pack_into(out, start, mask)

    still_image_sensor_list: list[ReportStillImageSensorCapabilities.StillImageSensorCapabilitiesRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("StillImageSensorList", rt.Repeat(rt.Count("H", 0, 65535), ReportStillImageSensorCapabilities.StillImageSensorCapabilitiesRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x12 or data[1] != 0x48: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        (still_image_sensor_list_count_,) = _S_H.unpack_from(data, 2)
        if still_image_sensor_list_count_ * 3 > size - 4: raise rt.Reject
        at = 4
        still_image_sensor_list_ = []
        for _ in range(still_image_sensor_list_count_):
            item_, at = ReportStillImageSensorCapabilities.StillImageSensorCapabilitiesRec._read(data, at, nesting)
            still_image_sensor_list_.append(item_)
        self.still_image_sensor_list = still_image_sensor_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x12\x48")
        still_image_sensor_list_ = self.still_image_sensor_list
        if type(still_image_sensor_list_) is not list: raise rt.Reject
        out += _S_H.pack(len(still_image_sensor_list_))
        for item_ in still_image_sensor_list_:
            if type(item_) is not ReportStillImageSensorCapabilities.StillImageSensorCapabilitiesRec: raise rt.Reject
            item_._write(out)
        return bytes(out)


_M_SetStillImageSensorConfiguration_StillImageSensorConfigurationRec_0 = rt.Masks("", ((0, "H"), (1, "B"), (2, "B")))
_E_SetStillImageSensorConfiguration_FrameSize = rt.members(SetStillImageSensorConfiguration.FrameSize)
_E_SetStillImageSensorConfiguration_StillImageFormat = rt.members(SetStillImageSensorConfiguration.StillImageFormat)
_S_B = rt.Packer("<B")
_S_H = rt.Packer("<H")
_E_QueryStillImageDataExt_SensorID = rt.members(QueryStillImageDataExt.SensorID)
_E_QueryStillImageDataExt_ReportCoordinateSystem = rt.members(QueryStillImageDataExt.ReportCoordinateSystem)
_S_H2B = rt.Packer("<H2B")
_E_QueryStillImageSensorConfiguration_SensorID = rt.members(QueryStillImageSensorConfiguration.SensorID)
_S_HB = rt.Packer("<HB")
_E_QueryStillImageSensorCapabilities_SensorID = rt.members(QueryStillImageSensorCapabilities.SensorID)
_E_ReportStillImageDataExt_ImageFrameFormat = rt.members(ReportStillImageDataExt.ImageFrameFormat)
_S_I = rt.Packer("<I")
_M_ReportStillImageDataExt_StillImageDataRec_0 = rt.Masks("", ((0, "H"), (0, "B"), (1, "I")))
_E_ReportStillImageDataExt_ReportCoordinateSystem = rt.members(ReportStillImageDataExt.ReportCoordinateSystem)
_E_ReportStillImageSensorConfiguration_FrameSize = rt.members(ReportStillImageSensorConfiguration.FrameSize)
_E_ReportStillImageSensorConfiguration_StillImageFormat = rt.members(ReportStillImageSensorConfiguration.StillImageFormat)
_M_ReportStillImageSensorCapabilities_StillImageSensorCapabilitiesRec_0 = rt.Masks("", ((0, "H"), (1, "I"), (2, "H")))
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
_E_SupportedImageFormats_JPEG = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.JPEG)
_E_SupportedImageFormats_GIF = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.GIF)
_E_SupportedImageFormats_PNG = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.PNG)
_E_SupportedImageFormats_BMP = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.BMP)
_E_SupportedImageFormats_TIFF = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.TIFF)
_E_SupportedImageFormats_PPM = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.PPM)
_E_SupportedImageFormats_PGM = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.PGM)
_E_SupportedImageFormats_PNM = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.PNM)
_E_SupportedImageFormats_NEF_Nikon_RAW = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.NEF_Nikon_RAW)
_E_SupportedImageFormats_CR2_Canon_RAW = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.CR2_Canon_RAW)
_E_SupportedImageFormats_DNG_Adobe_RAW = rt.members(environment_sensing_v1_0_types.SupportedImageFormats.DNG_Adobe_RAW)
QueryStillImageDataExt.REPORT = ReportStillImageDataExt
QueryStillImageSensorConfiguration.REPORT = ReportStillImageSensorConfiguration
QueryStillImageSensorCapabilities.REPORT = ReportStillImageSensorCapabilities
