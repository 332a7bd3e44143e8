"""urn:jaus:jss:exp:aeodrs:DigitalAudioSensor 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.exp.v1_0 import types as exp_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:DigitalAudioSensor", "1.4")


@jd.message(_SERVICE, 0xDE04, command=True)
class ControlDigitalAudioSensorStream(jd.Message):
    """ControlDigitalAudioSensorStream (0xDE04): Starts, halts or ends the audio stream of one device."""

    @jd.record()
    class AnnunciatorIdRec(jd.Struct):
        """sensor_id_rec: Number of the audio device; 0 is not allowed"""
        sensor_id_rec: int = jd.field("SensorIdRec", jd.Number("H"))

    class StreamCommand(IntEnum):
        NOT_USED = 0
        STREAM_START = 1
        STREAM_STOP = 2
        STREAM_TERMINATE = 3

    @jd.record()
    class StreamControlRec(jd.Struct):
        """stream_command: StreamCommand. What the stream is to do"""
        stream_command: ControlDigitalAudioSensorStream.StreamCommand | int = jd.field("StreamCommand", lambda: jd.Number("B", jd.Values(ControlDigitalAudioSensorStream.StreamCommand)))

    annunciator_id_rec: ControlDigitalAudioSensorStream.AnnunciatorIdRec = jd.field("AnnunciatorIdRec", lambda: ControlDigitalAudioSensorStream.AnnunciatorIdRec.layout())
    stream_control_rec: ControlDigitalAudioSensorStream.StreamControlRec = jd.field("StreamControlRec", lambda: ControlDigitalAudioSensorStream.StreamControlRec.layout())


@jd.message(_SERVICE, 0xFE01)
class ReportDigitalAudioSensorCapabilities(jd.Message):
    """ReportDigitalAudioSensorCapabilities (0xFE01): Tells the encodings and parameter ranges of the devices.

    audio_sensor_capability_list: 0..255 items. One element a device
    """
    SampleWidths = exp_v1_0_types.SampleWidths
    Formats = exp_v1_0_types.Formats
    EncodingQuality = exp_v1_0_types.EncodingQuality

    @jd.record()
    class SensorIdRec(jd.Struct):
        """sensor_id: Number of the audio device"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    @jd.record()
    class DigitalAudioSensorCapabilityRec(jd.Struct):
        """minimum_bitrate: Lowest bit rate available, in kbit/s; equal to MaximumBitrate if the rate is constant
        maximum_bitrate: Highest bit rate available, in kbit/s; equal to MinimumBitrate if the rate is constant
        minimum_sample_rate: Lowest sampling rate available, in samples per second
        maximum_sample_rate: Highest sampling rate available, in samples per second
        sample_widths: A set bit marks a sample width that can be delivered
        formats: A set bit marks an audio encoding that can be delivered
        encoding_quality: A set bit marks an available (subjective) grade of quality
        maximum_channels: Most channels at once: 1 for mono, 2 for stereo and so on
        """
        minimum_bitrate: int = jd.field("MinimumBitrate", jd.Number("H"))
        maximum_bitrate: int = jd.field("MaximumBitrate", jd.Number("H"))
        minimum_sample_rate: int = jd.field("MinimumSampleRate", jd.Number("Q"))
        maximum_sample_rate: int = jd.field("MaximumSampleRate", jd.Number("Q"))
        sample_widths: exp_v1_0_types.SampleWidths = jd.field("SampleWidths", lambda: exp_v1_0_types.SampleWidths.layout())
        formats: exp_v1_0_types.Formats = jd.field("Formats", lambda: exp_v1_0_types.Formats.layout())
        encoding_quality: exp_v1_0_types.EncodingQuality = jd.field("EncodingQuality", lambda: exp_v1_0_types.EncodingQuality.layout())
        maximum_channels: int = jd.field("MaximumChannels", jd.Number("B"))

    @jd.record()
    class AudioSensorCapabilitySeq(jd.Struct):
        """AudioSensorCapabilitySeq."""
        sensor_id_rec: ReportDigitalAudioSensorCapabilities.SensorIdRec = jd.field("SensorIdRec", lambda: ReportDigitalAudioSensorCapabilities.SensorIdRec.layout())
        digital_audio_sensor_capability_rec: ReportDigitalAudioSensorCapabilities.DigitalAudioSensorCapabilityRec = jd.field("DigitalAudioSensorCapabilityRec", lambda: ReportDigitalAudioSensorCapabilities.DigitalAudioSensorCapabilityRec.layout())

    audio_sensor_capability_list: list[ReportDigitalAudioSensorCapabilities.AudioSensorCapabilitySeq] = jd.field("AudioSensorCapabilityList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportDigitalAudioSensorCapabilities.AudioSensorCapabilitySeq.layout()))


@jd.message(_SERVICE, 0xEE01, query=True)
class QueryDigitalAudioSensorCapabilities(jd.Message):
    """QueryDigitalAudioSensorCapabilities (0xEE01): Asks which encodings and parameter ranges a device can deliver.

    sensor_id: Number of the audio device; 0 stands for every device
    """
    REPORT = ReportDigitalAudioSensorCapabilities
    sensor_id: int = jd.field("SensorID", jd.Number("H"))


@jd.message(_SERVICE, 0xFE02)
class ReportDigitalAudioSensorConfiguration(jd.Message):
    """ReportDigitalAudioSensorConfiguration (0xFE02): Tells the encoding parameters in force.

    audio_sensor_configuration_list: 0..255 items. One element a device
    """

    @jd.record()
    class SensorIdRec(jd.Struct):
        """sensor_id: Number of the audio device; 0 is not allowed"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    class SampleWidth(IntEnum):
        EIGHT_BITS = 0
        TEN_BITS = 1
        TWELVE_BITS = 2
        FOURTEEN_BITS = 3
        SIXTEEN_BITS = 4
        TWENTY_BITS = 5
        TWENTY_FOUR_BITS = 6
        THIRTY_TWO_BITS = 7
        FOURTY_BITS = 8
        FOURTY_EIGHT_BITS = 9
        FIFTY_SIX_BITS = 10
        SIXTY_FOUR_BITS = 11

    class Formats(IntEnum):
        U_LAW = 0
        AAC = 1
        MP3 = 2

    class EncodingQuality(IntEnum):
        HIGHEST = 0
        HIGH = 1
        GOOD = 2
        MEDIAN = 3
        FAIR = 4
        POOR = 5
        LOWEST = 6

    @jd.record()
    class AudioSensorConfigurationRec(jd.Struct):
        """Audio sensor configuration.

        minimum_bitrate: Lower bound of the bit rate, in kbit/s; equal to MaximumBitrate for a constant rate
        maximum_bitrate: Upper bound of the bit rate, in kbit/s; equal to MinimumBitrate for a constant rate
        sample_rate: Sampling rate, in samples per second
        sample_width: SampleWidth. Width of one sample
        formats: Formats. Audio encoding in use
        encoding_quality: EncodingQuality. Grade of quality in use
        number_channels: Channels in the stream: 1 for mono, 2 for stereo and so on
        audio_gain: 0..100. Gain of the input, in percent
        """
        minimum_bitrate: int = jd.field("MinimumBitrate", jd.Number("H"))
        maximum_bitrate: int = jd.field("MaximumBitrate", jd.Number("H"))
        sample_rate: int = jd.field("SampleRate", jd.Number("Q"))
        sample_width: ReportDigitalAudioSensorConfiguration.SampleWidth | int = jd.field("SampleWidth", lambda: jd.Number("B", jd.Values(ReportDigitalAudioSensorConfiguration.SampleWidth)))
        formats: ReportDigitalAudioSensorConfiguration.Formats | int = jd.field("Formats", lambda: jd.Number("B", jd.Values(ReportDigitalAudioSensorConfiguration.Formats)))
        encoding_quality: ReportDigitalAudioSensorConfiguration.EncodingQuality | int = jd.field("EncodingQuality", lambda: jd.Number("B", jd.Values(ReportDigitalAudioSensorConfiguration.EncodingQuality)))
        number_channels: int = jd.field("NumberChannels", jd.Number("B"))
        audio_gain: float = jd.field("AudioGain", jd.real("B", 0.0, 100.0))

    @jd.record()
    class AudioSensorConfigurationSeq(jd.Struct):
        """audio_sensor_configuration_rec: Audio sensor configuration"""
        sensor_id_rec: ReportDigitalAudioSensorConfiguration.SensorIdRec = jd.field("SensorIdRec", lambda: ReportDigitalAudioSensorConfiguration.SensorIdRec.layout())
        audio_sensor_configuration_rec: ReportDigitalAudioSensorConfiguration.AudioSensorConfigurationRec = jd.field("AudioSensorConfigurationRec", lambda: ReportDigitalAudioSensorConfiguration.AudioSensorConfigurationRec.layout())

    audio_sensor_configuration_list: list[ReportDigitalAudioSensorConfiguration.AudioSensorConfigurationSeq] = jd.field("AudioSensorConfigurationList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportDigitalAudioSensorConfiguration.AudioSensorConfigurationSeq.layout()))


@jd.message(_SERVICE, 0xEE02, query=True)
class QueryDigitalAudioSensorConfiguration(jd.Message):
    """QueryDigitalAudioSensorConfiguration (0xEE02): Asks for the encoding parameters in force.

    sensor_id: Number of the audio device; 0 stands for every device
    """
    REPORT = ReportDigitalAudioSensorConfiguration
    sensor_id: int = jd.field("SensorID", jd.Number("H"))


@jd.message(_SERVICE, 0xFE03)
class ReportDigitalAudioSensorStreamEndpoint(jd.Message):
    """ReportDigitalAudioSensorStreamEndpoint (0xFE03): Tells where the devices stream to.

    audio_sensor_endpoint_list: 0..255 items. One element a device
    """
    EndpointRecord = exp_v1_0_types.EndpointRecord

    @jd.record()
    class SensorIdRec(jd.Struct):
        """sensor_id: Number of the audio device"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    @jd.record()
    class AudioSensorEndpointSeq(jd.Struct):
        """endpoint_record: Endpoint"""
        sensor_id_rec: ReportDigitalAudioSensorStreamEndpoint.SensorIdRec = jd.field("SensorIdRec", lambda: ReportDigitalAudioSensorStreamEndpoint.SensorIdRec.layout())
        endpoint_record: exp_v1_0_types.EndpointRecord = jd.field("EndpointRecord", lambda: exp_v1_0_types.EndpointRecord.layout())

    audio_sensor_endpoint_list: list[ReportDigitalAudioSensorStreamEndpoint.AudioSensorEndpointSeq] = jd.field("AudioSensorEndpointList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportDigitalAudioSensorStreamEndpoint.AudioSensorEndpointSeq.layout()))


@jd.message(_SERVICE, 0xEE03, query=True)
class QueryDigitalAudioSensorStreamEndpoint(jd.Message):
    """QueryDigitalAudioSensorStreamEndpoint (0xEE03): Asks for the IP address and port that a device streams to (RTP).

    sensor_id: Number of the audio device; 0 stands for every device
    """
    REPORT = ReportDigitalAudioSensorStreamEndpoint
    sensor_id: int = jd.field("SensorID", jd.Number("H"))


@jd.message(_SERVICE, 0xDE02, command=True)
class SetDigitalAudioSensorConfiguration(jd.Message):
    """SetDigitalAudioSensorConfiguration (0xDE02): Sets the encoding parameters of one device.

    audio_sensor_configuration_rec: Audio sensor configuration
    """

    @jd.record()
    class SensorIdRec(jd.Struct):
        """sensor_id: Number of the audio device; 0 is not allowed"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    class SampleWidth(IntEnum):
        EIGHT_BITS = 0
        TEN_BITS = 1
        TWELVE_BITS = 2
        FOURTEEN_BITS = 3
        SIXTEEN_BITS = 4
        TWENTY_BITS = 5
        TWENTY_FOUR_BITS = 6
        THIRTY_TWO_BITS = 7
        FOURTY_BITS = 8
        FOURTY_EIGHT_BITS = 9
        FIFTY_SIX_BITS = 10
        SIXTY_FOUR_BITS = 11

    class Formats(IntEnum):
        U_LAW = 0
        AAC = 1
        MP3 = 2

    class EncodingQuality(IntEnum):
        HIGHEST = 0
        HIGH = 1
        GOOD = 2
        MEDIAN = 3
        FAIR = 4
        POOR = 5
        LOWEST = 6

    @jd.record()
    class AudioSensorConfigurationRec(jd.Struct):
        """Audio sensor configuration.

        minimum_bitrate: Lower bound of the bit rate, in kbit/s; equal to MaximumBitrate for a constant rate
        maximum_bitrate: Upper bound of the bit rate, in kbit/s; equal to MinimumBitrate for a constant rate
        sample_rate: Sampling rate, in samples per second
        sample_width: SampleWidth. Width of one sample
        formats: Formats. Audio encoding in use
        encoding_quality: EncodingQuality. Grade of quality in use
        number_channels: Channels in the stream: 1 for mono, 2 for stereo and so on
        audio_gain: 0..100. Gain of the input, in percent
        """
        minimum_bitrate: int = jd.field("MinimumBitrate", jd.Number("H"))
        maximum_bitrate: int = jd.field("MaximumBitrate", jd.Number("H"))
        sample_rate: int = jd.field("SampleRate", jd.Number("Q"))
        sample_width: SetDigitalAudioSensorConfiguration.SampleWidth | int = jd.field("SampleWidth", lambda: jd.Number("B", jd.Values(SetDigitalAudioSensorConfiguration.SampleWidth)))
        formats: SetDigitalAudioSensorConfiguration.Formats | int = jd.field("Formats", lambda: jd.Number("B", jd.Values(SetDigitalAudioSensorConfiguration.Formats)))
        encoding_quality: SetDigitalAudioSensorConfiguration.EncodingQuality | int = jd.field("EncodingQuality", lambda: jd.Number("B", jd.Values(SetDigitalAudioSensorConfiguration.EncodingQuality)))
        number_channels: int = jd.field("NumberChannels", jd.Number("B"))
        audio_gain: float = jd.field("AudioGain", jd.real("B", 0.0, 100.0))

    sensor_id_rec: SetDigitalAudioSensorConfiguration.SensorIdRec = jd.field("SensorIdRec", lambda: SetDigitalAudioSensorConfiguration.SensorIdRec.layout())
    audio_sensor_configuration_rec: SetDigitalAudioSensorConfiguration.AudioSensorConfigurationRec = jd.field("AudioSensorConfigurationRec", lambda: SetDigitalAudioSensorConfiguration.AudioSensorConfigurationRec.layout())


@jd.message(_SERVICE, 0xDE03, command=True)
class SetDigitalAudioSensorStreamEndpoint(jd.Message):
    """SetDigitalAudioSensorStreamEndpoint (0xDE03): Chooses the receiver of one device's stream.

    endpoint_record: Endpoint
    """
    EndpointRecord = exp_v1_0_types.EndpointRecord

    @jd.record()
    class SensorIdRec(jd.Struct):
        """sensor_id: Number of the audio device"""
        sensor_id: int = jd.field("SensorID", jd.Number("H"))

    sensor_id_rec: SetDigitalAudioSensorStreamEndpoint.SensorIdRec = jd.field("SensorIdRec", lambda: SetDigitalAudioSensorStreamEndpoint.SensorIdRec.layout())
    endpoint_record: exp_v1_0_types.EndpointRecord = jd.field("EndpointRecord", lambda: exp_v1_0_types.EndpointRecord.layout())
