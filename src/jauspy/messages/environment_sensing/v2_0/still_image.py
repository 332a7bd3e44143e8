"""urn:jaus:jss:environmentSensing:StillImage 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.core.v1_0 import types as core_v1_0_types
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:StillImage", "2.0")


@jd.message(_SERVICE, 0x0807, command=True)
class SetStillImageSensorConfiguration(jd.Message):
    """SetStillImageSensorConfiguration (0x0807): Sets the configuration of still image cameras.

    still_image_sensor_list: 0..65535 items. The cameras
    """

    @jd.record()
    class RequestIdRec(jd.Struct):
        """request_id: Repeated in the answer, to match it with its request"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class FrameSize(IntEnum):
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

    @jd.record("B")
    class StillImageSensorConfigurationRec(jd.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        frame_size: FrameSize, optional. Width and height of the image, in pixels
        still_image_format: StillImageFormat, optional. Coding of the image
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        frame_size: SetStillImageSensorConfiguration.FrameSize | int | None = jd.field("FrameSize", lambda: jd.Number("B", jd.Values(SetStillImageSensorConfiguration.FrameSize)), default=None)
        still_image_format: SetStillImageSensorConfiguration.StillImageFormat | int | None = jd.field("StillImageFormat", lambda: jd.Number("B", jd.Values(SetStillImageSensorConfiguration.StillImageFormat)), default=None)
        reserved_presence: int = 0

    request_id_rec: SetStillImageSensorConfiguration.RequestIdRec = jd.field("RequestIdRec", lambda: SetStillImageSensorConfiguration.RequestIdRec.layout())
    still_image_sensor_list: list[SetStillImageSensorConfiguration.StillImageSensorConfigurationRec] = jd.field("StillImageSensorList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetStillImageSensorConfiguration.StillImageSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x481C)
class ReportStillImageDataExt(jd.Message):
    """ReportStillImageDataExt (0x481C): Carries images, or tells where to fetch them.

    still_image_data_list: 0..65535 items. The images
    """
    TimeStamp = core_v1_0_types.TimeStamp

    class ReportCoordinateSystem(IntEnum):
        NATIVE = 0
        VEHICLE = 1

    class ImageFrameFormat(IntEnum):
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

    @jd.variable(lambda cls: jd.Formatted(cls, jd.Values(ReportStillImageDataExt.ImageFrameFormat), jd.Count("I", 0, 2147483647)))
    class ImageFrame(jd.Struct):
        """The image."""
        format: ReportStillImageDataExt.ImageFrameFormat | int
        data: bytes

    @jd.record("B")
    class StillImageDataRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        time_stamp: optional. Time within the month, in UTC
        image_frame: optional. The image
        still_image_uri: up to 255 characters, optional. Where to fetch the image
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        report_coordinate_system: ReportStillImageDataExt.ReportCoordinateSystem | int = jd.field("ReportCoordinateSystem", lambda: jd.Number("B", jd.Values(ReportStillImageDataExt.ReportCoordinateSystem)))
        time_stamp: core_v1_0_types.TimeStamp | None = jd.field("TimeStamp", lambda: core_v1_0_types.TimeStamp.layout(), default=None)
        image_frame: ReportStillImageDataExt.ImageFrame | None = jd.field("ImageFrame", lambda: ReportStillImageDataExt.ImageFrame.layout(), default=None)
        still_image_uri: str | None = jd.field("StillImageURI", jd.Text(count=jd.Count("B", 0, 255)), default=None)
        reserved_presence: int = 0

    still_image_data_list: list[ReportStillImageDataExt.StillImageDataRec] = jd.field("StillImageDataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportStillImageDataExt.StillImageDataRec.layout()))


@jd.message(_SERVICE, 0x281C, query=True)
class QueryStillImageDataExt(jd.Message):
    """QueryStillImageDataExt (0x281C): Asks for images, or for where to fetch them.

    query_still_image_data_list: 0..65535 items. The cameras
    """
    REPORT = ReportStillImageDataExt

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    class ReportCoordinateSystem(IntEnum):
        NATIVE = 0
        VEHICLE = 1

    @jd.record()
    class QueryStillImageDataRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        report_coordinate_system: ReportCoordinateSystem. Frame of the report
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryStillImageDataExt.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryStillImageDataExt.SensorID, ((1, 65535),))))
        report_coordinate_system: QueryStillImageDataExt.ReportCoordinateSystem | int = jd.field("ReportCoordinateSystem", lambda: jd.Number("B", jd.Values(QueryStillImageDataExt.ReportCoordinateSystem)))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("B"))

    query_still_image_data_list: list[QueryStillImageDataExt.QueryStillImageDataRec] = jd.field("QueryStillImageDataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryStillImageDataExt.QueryStillImageDataRec.layout()))


@jd.message(_SERVICE, 0x4813)
class ReportStillImageSensorConfiguration(jd.Message):
    """ReportStillImageSensorConfiguration (0x4813): Tells the configuration of still image cameras.

    still_image_sensor_configuration_list: 0..65535 items. The cameras
    """

    class FrameSize(IntEnum):
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

    @jd.record("B")
    class StillImageSensorConfigurationRec(jd.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        frame_size: FrameSize, optional. Width and height of the image, in pixels
        still_image_format: StillImageFormat, optional. Coding of the image
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        frame_size: ReportStillImageSensorConfiguration.FrameSize | int | None = jd.field("FrameSize", lambda: jd.Number("B", jd.Values(ReportStillImageSensorConfiguration.FrameSize)), default=None)
        still_image_format: ReportStillImageSensorConfiguration.StillImageFormat | int | None = jd.field("StillImageFormat", lambda: jd.Number("B", jd.Values(ReportStillImageSensorConfiguration.StillImageFormat)), default=None)
        reserved_presence: int = 0

    still_image_sensor_configuration_list: list[ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec] = jd.field("StillImageSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportStillImageSensorConfiguration.StillImageSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x2813, query=True)
class QueryStillImageSensorConfiguration(jd.Message):
    """QueryStillImageSensorConfiguration (0x2813): Asks for the configuration of still image cameras.

    query_still_image_sensor_configuration_list: 0..65535 items. The cameras
    """
    REPORT = ReportStillImageSensorConfiguration

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    @jd.record()
    class QueryStillImageSensorConfigurationRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryStillImageSensorConfiguration.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryStillImageSensorConfiguration.SensorID, ((1, 65535),))))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("B"))

    query_still_image_sensor_configuration_list: list[QueryStillImageSensorConfiguration.QueryStillImageSensorConfigurationRec] = jd.field("QueryStillImageSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryStillImageSensorConfiguration.QueryStillImageSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x4812)
class ReportStillImageSensorCapabilities(jd.Message):
    """ReportStillImageSensorCapabilities (0x4812): Tells what still image cameras can do.

    still_image_sensor_list: 0..65535 items. The cameras
    """
    SupportedFrameSizes = environment_sensing_v1_0_types.SupportedFrameSizes
    SupportedImageFormats = environment_sensing_v1_0_types.SupportedImageFormats

    @jd.record("B")
    class StillImageSensorCapabilitiesRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        supported_frame_sizes: optional. Sizes of image that the camera offers
        supported_image_formats: optional. Codings of image that the camera offers
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        supported_frame_sizes: environment_sensing_v1_0_types.SupportedFrameSizes | None = jd.field("SupportedFrameSizes", lambda: environment_sensing_v1_0_types.SupportedFrameSizes.layout(), default=None)
        supported_image_formats: environment_sensing_v1_0_types.SupportedImageFormats | None = jd.field("SupportedImageFormats", lambda: environment_sensing_v1_0_types.SupportedImageFormats.layout(), default=None)
        reserved_presence: int = 0

    still_image_sensor_list: list[ReportStillImageSensorCapabilities.StillImageSensorCapabilitiesRec] = jd.field("StillImageSensorList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportStillImageSensorCapabilities.StillImageSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x2812, query=True)
class QueryStillImageSensorCapabilities(jd.Message):
    """QueryStillImageSensorCapabilities (0x2812): Asks what still image cameras can do.

    query_still_image_sensor_capabilities_list: 0..65535 items. The cameras
    """
    REPORT = ReportStillImageSensorCapabilities

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    @jd.record()
    class QueryStillImageSensorCapabilitiesRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryStillImageSensorCapabilities.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryStillImageSensorCapabilities.SensorID, ((1, 65535),))))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("B"))

    query_still_image_sensor_capabilities_list: list[QueryStillImageSensorCapabilities.QueryStillImageSensorCapabilitiesRec] = jd.field("QueryStillImageSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryStillImageSensorCapabilities.QueryStillImageSensorCapabilitiesRec.layout()))
