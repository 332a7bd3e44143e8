"""urn:jaus:jss:environmentSensing:DigitalAudioOutput 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.environment_sensing.v1_0 import types as environment_sensing_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:DigitalAudioOutput", "2.0")


@jd.message(_SERVICE, 0x0818, command=True)
class SetDigitalAudioOutputSource(jd.Message):
    """SetDigitalAudioOutputSource (0x0818): Sets the streams to play, and how loud.

    digital_audio_output_source_list: 0..65535 items. The outputs
    """

    @jd.record()
    class RequestIdRec(jd.Struct):
        """request_id: Repeated in the answer, to match it with its request"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    class Repeat(IntEnum):
        PLAY_ONCE = 0
        REPEAT = 1

    @jd.record()
    class DigitalAudioOutputSourceRec(jd.Struct):
        """What one output plays.

        sensor_id: 1..65535. Identifies the sensor
        stream_url: up to 255 characters. Where to fetch the stream
        repeat: Repeat. What to do at the end of the stream
        volume: 0..100 percent. Loudness, in percent
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        stream_url: str = jd.field("StreamURL", jd.Text(count=jd.Count("B", 0, 255)))
        repeat: SetDigitalAudioOutputSource.Repeat | int = jd.field("Repeat", lambda: jd.Number("B", jd.Values(SetDigitalAudioOutputSource.Repeat)))
        volume: float = jd.field("Volume", jd.real("H", 0.0, 100.0, "percent"))

    request_id_rec: SetDigitalAudioOutputSource.RequestIdRec = jd.field("RequestIdRec", lambda: SetDigitalAudioOutputSource.RequestIdRec.layout())
    digital_audio_output_source_list: list[SetDigitalAudioOutputSource.DigitalAudioOutputSourceRec] = jd.field("DigitalAudioOutputSourceList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetDigitalAudioOutputSource.DigitalAudioOutputSourceRec.layout()))


@jd.message(_SERVICE, 0x4818)
class ReportDigitalAudioOutputSource(jd.Message):
    """ReportDigitalAudioOutputSource (0x4818): Tells which streams are played, and how loud.

    digital_audio_output_source_list: 0..65535 items. The outputs
    """

    class Repeat(IntEnum):
        PLAY_ONCE = 0
        REPEAT = 1

    @jd.record()
    class DigitalAudioOutputSourceRec(jd.Struct):
        """What one output plays.

        sensor_id: 1..65535. Identifies the sensor
        stream_url: up to 255 characters. Where to fetch the stream
        repeat: Repeat. What to do at the end of the stream
        volume: 0..100 percent. Loudness, in percent
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        stream_url: str = jd.field("StreamURL", jd.Text(count=jd.Count("B", 0, 255)))
        repeat: ReportDigitalAudioOutputSource.Repeat | int = jd.field("Repeat", lambda: jd.Number("B", jd.Values(ReportDigitalAudioOutputSource.Repeat)))
        volume: float = jd.field("Volume", jd.real("H", 0.0, 100.0, "percent"))

    digital_audio_output_source_list: list[ReportDigitalAudioOutputSource.DigitalAudioOutputSourceRec] = jd.field("DigitalAudioOutputSourceList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalAudioOutputSource.DigitalAudioOutputSourceRec.layout()))


@jd.message(_SERVICE, 0x2818, query=True)
class QueryDigitalAudioOutputSource(jd.Message):
    """QueryDigitalAudioOutputSource (0x2818): Asks which streams are played.

    sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
    """
    REPORT = ReportDigitalAudioOutputSource

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    sensor_id: QueryDigitalAudioOutputSource.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryDigitalAudioOutputSource.SensorID, ((1, 65535),))))


@jd.message(_SERVICE, 0x4819)
class ReportDigitalAudioOutputCapabilities(jd.Message):
    """ReportDigitalAudioOutputCapabilities (0x4819): Tells what audio outputs can do.

    digital_audio_output_capabilities_list: 0..65535 items. The outputs
    """
    SupportedAudioFormats = environment_sensing_v1_0_types.SupportedAudioFormats
    SupportedBitDepths = environment_sensing_v1_0_types.SupportedBitDepths

    @jd.record("B")
    class DigitalAudioOutputCapabilitiesRec(jd.Struct):
        """sensor_id: 1..65535. Identifies the sensor
        minimum_allowed_bit_rate: optional. Smallest bit rate that can be set, in kilobits per second
        maximum_allowed_bit_rate: optional. Largest bit rate that can be set, in kilobits per second
        supported_digital_formats: optional. Codings of audio that can be played
        min_sample_rate: optional. Smallest number of samples per second
        max_sample_rate: optional. Largest number of samples per second
        supported_bit_depths: optional. Bits per sample that can be had
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H", jd.Values(None, ((1, 65535),))))
        minimum_allowed_bit_rate: int | None = jd.field("MinimumAllowedBitRate", jd.Number("H"), default=None)
        maximum_allowed_bit_rate: int | None = jd.field("MaximumAllowedBitRate", jd.Number("H"), default=None)
        supported_digital_formats: environment_sensing_v1_0_types.SupportedAudioFormats | None = jd.field("SupportedDigitalFormats", lambda: environment_sensing_v1_0_types.SupportedAudioFormats.layout(), default=None)
        min_sample_rate: int | None = jd.field("MinSampleRate", jd.Number("I"), default=None)
        max_sample_rate: int | None = jd.field("MaxSampleRate", jd.Number("I"), default=None)
        supported_bit_depths: environment_sensing_v1_0_types.SupportedBitDepths | None = jd.field("SupportedBitDepths", lambda: environment_sensing_v1_0_types.SupportedBitDepths.layout(), default=None)
        reserved_presence: int = 0

    digital_audio_output_capabilities_list: list[ReportDigitalAudioOutputCapabilities.DigitalAudioOutputCapabilitiesRec] = jd.field("DigitalAudioOutputCapabilitiesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalAudioOutputCapabilities.DigitalAudioOutputCapabilitiesRec.layout()))


@jd.message(_SERVICE, 0x2819, query=True)
class QueryDigitalAudioOutputCapabilities(jd.Message):
    """QueryDigitalAudioOutputCapabilities (0x2819): Asks what audio outputs can do.

    sensor_id: SensorID or 1..65535. Which sensor is meant; 0 is all
    """
    REPORT = ReportDigitalAudioOutputCapabilities

    class SensorID(IntEnum):
        ALL_SENSORS = 0

    sensor_id: QueryDigitalAudioOutputCapabilities.SensorID | int = jd.field("SensorID", lambda: jd.Number("H", jd.Values(QueryDigitalAudioOutputCapabilities.SensorID, ((1, 65535),))))


@jd.message(_SERVICE, 0x0801)
class ConfirmSensorConfiguration(jd.Message):
    """ConfirmSensorConfiguration (0x0801): Tells for each sensor whether its new configuration was taken over, and if not, why.

    confirm_sensor_list: 0..65535 items. The sensors
    """
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

    @jd.record()
    class RequestIdRec(jd.Struct):
        """request_id: Repeated in the answer, to match it with its request"""
        request_id: int = jd.field("RequestID", jd.Number("B"))

    request_id_rec: ConfirmSensorConfiguration.RequestIdRec = jd.field("RequestIdRec", lambda: ConfirmSensorConfiguration.RequestIdRec.layout())
    confirm_sensor_list: list[environment_sensing_v1_0_types.SensorIdRec | environment_sensing_v1_0_types.RangeSensorErrorRec | environment_sensing_v1_0_types.VisualSensorErrorRec | environment_sensing_v1_0_types.DigitalVideoSensorErrorRec | environment_sensing_v1_0_types.AnalogVideoSensorErrorRec | environment_sensing_v1_0_types.StillImageSensorErrorRec | environment_sensing_v1_0_types.H264VideoEncodingErrorRec | environment_sensing_v1_0_types.DigitalAudioSensorErrorRec | environment_sensing_v1_0_types.DigitalAudioOutputErrorRec | environment_sensing_v1_0_types.VideoIlluminatorErrorRec] = jd.field("ConfirmSensorList", lambda: jd.Repeat(jd.Count("H", 0, 65535), jd.Union.of("B", sensor_id_rec=environment_sensing_v1_0_types.SensorIdRec, range_sensor_error_rec=environment_sensing_v1_0_types.RangeSensorErrorRec, visual_sensor_error_rec=environment_sensing_v1_0_types.VisualSensorErrorRec, digital_video_sensor_error_rec=environment_sensing_v1_0_types.DigitalVideoSensorErrorRec, analog_video_sensor_error_rec=environment_sensing_v1_0_types.AnalogVideoSensorErrorRec, still_image_sensor_error_rec=environment_sensing_v1_0_types.StillImageSensorErrorRec, h264_video_encoding_error_rec=environment_sensing_v1_0_types.H264VideoEncodingErrorRec, digital_audio_sensor_error_rec=environment_sensing_v1_0_types.DigitalAudioSensorErrorRec, digital_audio_output_error_rec=environment_sensing_v1_0_types.DigitalAudioOutputErrorRec, video_illuminator_error_rec=environment_sensing_v1_0_types.VideoIlluminatorErrorRec)))
