"""urn:jaus:jss:iop:DigitalAudioAnnunciator 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:DigitalAudioAnnunciator", "1.1")


@jd.message(_SERVICE, 0xDA9E)
class ReportDigitalAudioStreamSource(jd.Message):
    """ReportDigitalAudioStreamSource (0xDA9E): Tells which stream each sensor asked for is playing.

    digital_audio_stream_source_list: 0..65535 items. Digital audio stream source
    """

    class Repeat(IntEnum):
        PLAY_ONCE = 0
        REPEAT_UNTIL_NEW_STREAM_SPECIFIED = 1

    @jd.record()
    class DigitalAudioStreamSourceRec(jd.Struct):
        """Digital audio stream source.

        sensor_id: Number of the sensor; never 0
        stream_url: up to 255 characters. Address of the stream, with an IP address instead of a host name; empty = nothing is played
        repeat: Repeat. What happens at the end of an RTSP stream that has one
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        stream_url: str = jd.field("StreamURL", jd.Text(count=jd.Count("B", 0, 255)))
        repeat: ReportDigitalAudioStreamSource.Repeat | int = jd.field("Repeat", lambda: jd.Number("B", jd.Values(ReportDigitalAudioStreamSource.Repeat)))

    digital_audio_stream_source_list: list[ReportDigitalAudioStreamSource.DigitalAudioStreamSourceRec] = jd.field("DigitalAudioStreamSourceList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportDigitalAudioStreamSource.DigitalAudioStreamSourceRec.layout()))


@jd.message(_SERVICE, 0xDA8E, query=True)
class QueryDigitalAudioStreamSource(jd.Message):
    """QueryDigitalAudioStreamSource (0xDA8E): Asks which stream each sensor is playing.

    sensor_id: Number of the sensor asked for; 0 = every one
    """
    REPORT = ReportDigitalAudioStreamSource
    sensor_id: int = jd.field("SensorID", jd.Number("H"))


@jd.message(_SERVICE, 0xDA7E, command=True)
class SetDigitalAudioStreamSource(jd.Message):
    """SetDigitalAudioStreamSource (0xDA7E): Chooses the stream each sensor is to play.

    digital_audio_stream_source_list: 0..65535 items. Digital audio stream source
    """

    class Repeat(IntEnum):
        PLAY_ONCE = 0
        REPEAT_UNTIL_NEW_STREAM_SPECIFIED = 1

    @jd.record()
    class DigitalAudioStreamSourceRec(jd.Struct):
        """Digital audio stream source.

        sensor_id: Number of the sensor; never 0
        stream_url: up to 255 characters. Address of the stream, with an IP address instead of a host name; empty = nothing is played
        repeat: Repeat. What happens at the end of an RTSP stream that has one
        """
        sensor_id: int = jd.field("SensorID", jd.Number("H"))
        stream_url: str = jd.field("StreamURL", jd.Text(count=jd.Count("B", 0, 255)))
        repeat: SetDigitalAudioStreamSource.Repeat | int = jd.field("Repeat", lambda: jd.Number("B", jd.Values(SetDigitalAudioStreamSource.Repeat)))

    digital_audio_stream_source_list: list[SetDigitalAudioStreamSource.DigitalAudioStreamSourceRec] = jd.field("DigitalAudioStreamSourceList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetDigitalAudioStreamSource.DigitalAudioStreamSourceRec.layout()))
