"""urn:jaus:jss:environmentSensing:DigitalVideo 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:DigitalVideo", "2.0")


@jd.message(_SERVICE, 0x0805, command=True)
class ControlDigitalVideoSensorStream(jd.Message):
    """ControlDigitalVideoSensorStream (0x0805): Starts, pauses or stops a stream.

    sensor_id: 1..65535. Identifies the sensor
    stream_state: StreamState. What the stream is to do
    """

    class StreamState(IntEnum):
        PLAY = 0
        PAUSE = 1
        STOP = 2

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    stream_state: ControlDigitalVideoSensorStream.StreamState | int = jd.field("StreamState", lambda: jd.Number("B", jd.Values(ControlDigitalVideoSensorStream.StreamState)))


@jd.message(_SERVICE, 0x0810, command=True)
class ControlDigitalVideoSensorRecording(jd.Message):
    """ControlDigitalVideoSensorRecording (0x0810): Starts or stops recording.

    sensor_id: 1..65535. Identifies the sensor
    requested_recording_state: RequestedRecordingState. Whether the camera is to record
    """

    class RequestedRecordingState(IntEnum):
        NOT_RECORDING = 0
        RECORDING = 1

    sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
    requested_recording_state: ControlDigitalVideoSensorRecording.RequestedRecordingState | int = jd.field("RequestedRecordingState", lambda: jd.Number("B", jd.Values(ControlDigitalVideoSensorRecording.RequestedRecordingState)))


@jd.message(_SERVICE, 0x0804, command=True)
class SetDigitalVideoSensorConfiguration(jd.Message):
    """SetDigitalVideoSensorConfiguration (0x0804): Sets the configuration of digital cameras.

    digital_video_sensor_list: 0..65535 items. The cameras
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

    class DigitalFormat(IntEnum):
        AVI = 0
        MJPEG = 1
        MPEG_2 = 2
        H_263 = 3
        H_263_PLUS = 4
        MPEG_4_VISUAL = 5
        MPEG_4_AVC = 6

    @jd.record("B")
    class DigitalVideoSensorConfigurationRec(jd.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        minimum_bit_rate: optional. Smallest bit rate, in kilobits per second
        maximum_bit_rate: optional. Largest bit rate, in kilobits per second
        frame_rate: optional. Frames per second
        frame_size: FrameSize, optional. Width and height of the image, in pixels
        digital_format: DigitalFormat, optional. Coding of the video
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        minimum_bit_rate: int | None = jd.field("MinimumBitRate", jd.Number("H"), default=None)
        maximum_bit_rate: int | None = jd.field("MaximumBitRate", jd.Number("H"), default=None)
        frame_rate: int | None = jd.field("FrameRate", jd.Number("B"), default=None)
        frame_size: SetDigitalVideoSensorConfiguration.FrameSize | int | None = jd.field("FrameSize", lambda: jd.Number("B", jd.Values(SetDigitalVideoSensorConfiguration.FrameSize)), default=None)
        digital_format: SetDigitalVideoSensorConfiguration.DigitalFormat | int | None = jd.field("DigitalFormat", lambda: jd.Number("B", jd.Values(SetDigitalVideoSensorConfiguration.DigitalFormat)), default=None)
        reserved_presence: int = 0

    request_id_rec: SetDigitalVideoSensorConfiguration.RequestIdRec = jd.field("RequestIdRec", lambda: SetDigitalVideoSensorConfiguration.RequestIdRec.layout())
    digital_video_sensor_list: list[SetDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec] = jd.field("DigitalVideoSensorList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x4809)
class ReportDigitalVideoSensorConfiguration(jd.Message):
    """ReportDigitalVideoSensorConfiguration (0x4809): Tells the configuration of digital cameras.

    digital_video_sensor_configuration_list: 0..65535 items. The cameras
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

    class DigitalFormat(IntEnum):
        AVI = 0
        MJPEG = 1
        MPEG_2 = 2
        H_263 = 3
        H_263_PLUS = 4
        MPEG_4_VISUAL = 5
        MPEG_4_AVC = 6

    @jd.record("B")
    class DigitalVideoSensorConfigurationRec(jd.Struct):
        """Settings of one camera.

        sensor_id: 1..65535. Identifies the sensor
        minimum_bit_rate: optional. Smallest bit rate, in kilobits per second
        maximum_bit_rate: optional. Largest bit rate, in kilobits per second
        frame_rate: optional. Frames per second
        frame_size: FrameSize, optional. Width and height of the image, in pixels
        digital_format: DigitalFormat, optional. Coding of the video
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        minimum_bit_rate: int | None = jd.field("MinimumBitRate", jd.Number("H"), default=None)
        maximum_bit_rate: int | None = jd.field("MaximumBitRate", jd.Number("H"), default=None)
        frame_rate: int | None = jd.field("FrameRate", jd.Number("B"), default=None)
        frame_size: ReportDigitalVideoSensorConfiguration.FrameSize | int | None = jd.field("FrameSize", lambda: jd.Number("B", jd.Values(ReportDigitalVideoSensorConfiguration.FrameSize)), default=None)
        digital_format: ReportDigitalVideoSensorConfiguration.DigitalFormat | int | None = jd.field("DigitalFormat", lambda: jd.Number("B", jd.Values(ReportDigitalVideoSensorConfiguration.DigitalFormat)), default=None)
        reserved_presence: int = 0

    digital_video_sensor_configuration_list: list[ReportDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec] = jd.field("DigitalVideoSensorConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalVideoSensorConfiguration.DigitalVideoSensorConfigurationRec.layout()))


@jd.message(_SERVICE, 0x2809, query=True)
class QueryDigitalVideoSensorConfiguration(jd.Message):
    """QueryDigitalVideoSensorConfiguration (0x2809): Asks for the configuration of digital cameras.

    query_digital_video_configuration_list: 0..65535 items. The cameras
    """
    REPORT = ReportDigitalVideoSensorConfiguration

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    @jd.record()
    class QueryDigitalVideoConfigurationRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryDigitalVideoSensorConfiguration.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryDigitalVideoSensorConfiguration.SensorID, ((1, 65535),))))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("B"))

    query_digital_video_configuration_list: list[QueryDigitalVideoSensorConfiguration.QueryDigitalVideoConfigurationRec] = jd.field("QueryDigitalVideoConfigurationList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryDigitalVideoSensorConfiguration.QueryDigitalVideoConfigurationRec.layout()))


@jd.message(_SERVICE, 0x481D)
class ReportDigitalVideoSensorCapabilitiesExt(jd.Message):
    """ReportDigitalVideoSensorCapabilitiesExt (0x481D): Tells what cameras can do, recording included.

    digital_video_sensor_list: 0..65535 items. The cameras
    """
    SupportedFrameSizes = environment_sensing_v1_0_types.SupportedFrameSizes
    SupportedDigitalFormats = environment_sensing_v1_0_types.SupportedDigitalFormats

    class RecordingSupported(IntEnum):
        UNSUPPORTED = 0
        SUPPORTED = 1

    @jd.record("B")
    class DigitalVideoSensorCapabilitiesRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        minimum_bit_rate: optional. Smallest bit rate, in kilobits per second
        maximum_bit_rate: optional. Largest bit rate, in kilobits per second
        minimum_frame_rate: optional. Smallest rate, in frames per second
        maximum_frame_rate: optional. Largest rate, in frames per second
        supported_frame_sizes: optional. Sizes of image that the camera offers
        supported_digital_formats: optional. Codings of video that the camera offers
        recording_supported: RecordingSupported, optional. Whether the camera can record
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        minimum_bit_rate: int | None = jd.field("MinimumBitRate", jd.Number("H"), default=None)
        maximum_bit_rate: int | None = jd.field("MaximumBitRate", jd.Number("H"), default=None)
        minimum_frame_rate: int | None = jd.field("MinimumFrameRate", jd.Number("B"), default=None)
        maximum_frame_rate: int | None = jd.field("MaximumFrameRate", jd.Number("B"), default=None)
        supported_frame_sizes: environment_sensing_v1_0_types.SupportedFrameSizes | None = jd.field("SupportedFrameSizes", lambda: environment_sensing_v1_0_types.SupportedFrameSizes.layout(), default=None)
        supported_digital_formats: environment_sensing_v1_0_types.SupportedDigitalFormats | None = jd.field("SupportedDigitalFormats", lambda: environment_sensing_v1_0_types.SupportedDigitalFormats.layout(), default=None)
        recording_supported: ReportDigitalVideoSensorCapabilitiesExt.RecordingSupported | int | None = jd.field("RecordingSupported", lambda: jd.Number("B", jd.Values(ReportDigitalVideoSensorCapabilitiesExt.RecordingSupported)), default=None)
        reserved_presence: int = 0

    digital_video_sensor_list: list[ReportDigitalVideoSensorCapabilitiesExt.DigitalVideoSensorCapabilitiesRec] = jd.field("DigitalVideoSensorList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalVideoSensorCapabilitiesExt.DigitalVideoSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x281D, query=True)
class QueryDigitalVideoSensorCapabilitiesExt(jd.Message):
    """QueryDigitalVideoSensorCapabilitiesExt (0x281D): Asks what cameras can do, recording included.

    query_digital_video_sensor_capabilities_list: 0..65535 items. The cameras
    """
    REPORT = ReportDigitalVideoSensorCapabilitiesExt

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    @jd.record()
    class QueryDigitalVideoSensorCapabilitiesRec(jd.Struct):
        """sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
        query_presence_vector: Optional fields wanted of this sensor: bit i asks for the i-th of them, from 0
        """
        sensor_id: QueryDigitalVideoSensorCapabilitiesExt.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryDigitalVideoSensorCapabilitiesExt.SensorID, ((1, 65535),))))
        query_presence_vector: int = jd.field("QueryPresenceVector", jd.Number("B"))

    query_digital_video_sensor_capabilities_list: list[QueryDigitalVideoSensorCapabilitiesExt.QueryDigitalVideoSensorCapabilitiesRec] = jd.field("QueryDigitalVideoSensorCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), QueryDigitalVideoSensorCapabilitiesExt.QueryDigitalVideoSensorCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x481E)
class ReportDigitalVideoSensorStatus(jd.Message):
    """ReportDigitalVideoSensorStatus (0x481E): Tells whether cameras stream and record.

    digital_video_sensor_status_list: 0..65535 items. The cameras
    """

    class StreamingState(IntEnum):
        PLAY = 0
        PAUSE = 1
        STOP = 2

    class RecordingState(IntEnum):
        NOT_RECORDING = 0
        RECORDING = 1

    @jd.record()
    class DigitalVideoSensorStatusRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        streaming_state: StreamingState. What the stream does
        recording_state: RecordingState. Whether the camera records
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        streaming_state: ReportDigitalVideoSensorStatus.StreamingState | int = jd.field("StreamingState", lambda: jd.Number("B", jd.Values(ReportDigitalVideoSensorStatus.StreamingState)))
        recording_state: ReportDigitalVideoSensorStatus.RecordingState | int = jd.field("RecordingState", lambda: jd.Number("B", jd.Values(ReportDigitalVideoSensorStatus.RecordingState)))

    digital_video_sensor_status_list: list[ReportDigitalVideoSensorStatus.DigitalVideoSensorStatusRec] = jd.field("DigitalVideoSensorStatusList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalVideoSensorStatus.DigitalVideoSensorStatusRec.layout()))


@jd.message(_SERVICE, 0x281E, query=True)
class QueryDigitalVideoSensorStatus(jd.Message):
    """QueryDigitalVideoSensorStatus (0x281E): Asks whether cameras stream and record.

    sensor_id_list: 0..65535 items. The sensors
    """
    REPORT = ReportDigitalVideoSensorStatus
    SensorIDQueryRec = environment_sensing_v1_0_types.SensorIDQueryRec
    sensor_id_list: list[environment_sensing_v1_0_types.SensorIDQueryRec] = jd.field("SensorIdList", lambda: jd.Repeat(jd.Count("H", 0, 65535), environment_sensing_v1_0_types.SensorIDQueryRec.layout()))
