"""urn:jaus:jss:exp:aeodrs:DigitalAudioAnnuciator 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.exp.v1_0 import types as exp_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:DigitalAudioAnnuciator", "1.4")


@jd.message(_SERVICE, 0xDF05, command=True)
class ControlAnnunciatorStream(jd.Message):
    """ControlAnnunciatorStream (0xDF05): Starts, stops or ends the stream of one device."""

    @jd.record()
    class AnnunciatorIdRec(jd.Struct):
        """annunciator_id: Number of the sound device; 0 is not allowed"""
        annunciator_id: int = jd.field("AnnunciatorID", jd.Number("H"))

    class StreamCommand(IntEnum):
        NOT_USED = 0
        STREAM_START = 1
        STREAM_STOP = 2
        STREAM_TERMINATE = 3

    @jd.record()
    class StreamControlRec(jd.Struct):
        """stream_command: StreamCommand. What to do with the stream"""
        stream_command: ControlAnnunciatorStream.StreamCommand | int = jd.field("StreamCommand", lambda: jd.Number("B", jd.Values(ControlAnnunciatorStream.StreamCommand)))

    annunciator_id_rec: ControlAnnunciatorStream.AnnunciatorIdRec = jd.field("AnnunciatorIdRec", lambda: ControlAnnunciatorStream.AnnunciatorIdRec.layout())
    stream_control_rec: ControlAnnunciatorStream.StreamControlRec = jd.field("StreamControlRec", lambda: ControlAnnunciatorStream.StreamControlRec.layout())


@jd.message(_SERVICE, 0xFF01)
class ReportAnnunciatorCapabilities(jd.Message):
    """ReportAnnunciatorCapabilities (0xFF01): Formats and parameter limits of the devices.

    annunciator_capability_list: 0..255 items. One entry a device
    """
    SampleWidths = exp_v1_0_types.SampleWidths
    Formats = exp_v1_0_types.Formats
    EncodingQuality = exp_v1_0_types.EncodingQuality

    @jd.record()
    class AnnunciatorIdRec(jd.Struct):
        """annunciator_id: Number of the sound device; 0 is not allowed"""
        annunciator_id: int = jd.field("AnnunciatorID", jd.Number("H"))

    @jd.record()
    class AnnunciatorCapabilityRec(jd.Struct):
        """minimum_bitrate: Lowest bit rate, in kbit/s; equal to MaximumBitrate if the rate is constant
        maximum_bitrate: Highest bit rate, in kbit/s; equal to MinimumBitrate if the rate is constant
        minimum_sample_rate: Lowest sample rate, in samples per second
        maximum_sample_rate: Highest sample rate, in samples per second
        sample_widths: Sample sizes the device takes (bit set: taken)
        formats: Audio codings the device takes (bit set: taken)
        encoding_quality: Quality grades the device takes (bit set: taken); the grades are a matter of judgement
        maximum_channels: Largest count of channels (1 mono, 2 stereo)
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
    class AnnunciatorCapabilitySeq(jd.Struct):
        """AnnunciatorCapabilitySeq."""
        annunciator_id_rec: ReportAnnunciatorCapabilities.AnnunciatorIdRec = jd.field("AnnunciatorIdRec", lambda: ReportAnnunciatorCapabilities.AnnunciatorIdRec.layout())
        annunciator_capability_rec: ReportAnnunciatorCapabilities.AnnunciatorCapabilityRec = jd.field("AnnunciatorCapabilityRec", lambda: ReportAnnunciatorCapabilities.AnnunciatorCapabilityRec.layout())

    annunciator_capability_list: list[ReportAnnunciatorCapabilities.AnnunciatorCapabilitySeq] = jd.field("AnnunciatorCapabilityList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportAnnunciatorCapabilities.AnnunciatorCapabilitySeq.layout()))


@jd.message(_SERVICE, 0xEF01, query=True)
class QueryAnnunciatorCapabilities(jd.Message):
    """QueryAnnunciatorCapabilities (0xEF01): Asks for formats and parameter limits.

    annunciator_id: Number of the sound device; 0 asks for every device
    """
    REPORT = ReportAnnunciatorCapabilities
    annunciator_id: int = jd.field("AnnunciatorID", jd.Number("H"))


@jd.message(_SERVICE, 0xFF02)
class ReportAnnunciatorConfiguration(jd.Message):
    """ReportAnnunciatorConfiguration (0xFF02): Settings the devices use now.

    annunciator_configuration_list: 0..255 items. One entry a device
    """

    @jd.record()
    class AnnunciatorIdRec(jd.Struct):
        """annunciator_id: Number of the sound device; 0 is not allowed"""
        annunciator_id: int = jd.field("AnnunciatorID", jd.Number("H"))

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
    class AnnunciatorConfigurationRec(jd.Struct):
        """Annunciator configuration.

        minimum_bitrate: Lower bound of the stream's bit rate, in kbit/s; equal to MaximumBitrate if the rate is constant
        maximum_bitrate: Upper bound of the stream's bit rate, in kbit/s; equal to MinimumBitrate if the rate is constant
        sample_rate: Samples per second; lies within the limits of ReportAnnunciatorCapabilities
        sample_width: SampleWidth. Size of a sample
        formats: Formats. Coding of the audio
        encoding_quality: EncodingQuality. Quality grade of the coding
        number_channels: Channels in the stream (1 mono, 2 stereo)
        audio_gain: 0..100. Gain of the audio, 0 to 100
        """
        minimum_bitrate: int = jd.field("MinimumBitrate", jd.Number("H"))
        maximum_bitrate: int = jd.field("MaximumBitrate", jd.Number("H"))
        sample_rate: int = jd.field("SampleRate", jd.Number("Q"))
        sample_width: ReportAnnunciatorConfiguration.SampleWidth | int = jd.field("SampleWidth", lambda: jd.Number("B", jd.Values(ReportAnnunciatorConfiguration.SampleWidth)))
        formats: ReportAnnunciatorConfiguration.Formats | int = jd.field("Formats", lambda: jd.Number("B", jd.Values(ReportAnnunciatorConfiguration.Formats)))
        encoding_quality: ReportAnnunciatorConfiguration.EncodingQuality | int = jd.field("EncodingQuality", lambda: jd.Number("B", jd.Values(ReportAnnunciatorConfiguration.EncodingQuality)))
        number_channels: int = jd.field("NumberChannels", jd.Number("B"))
        audio_gain: float = jd.field("AudioGain", jd.real("B", 0.0, 100.0))

    @jd.record()
    class AnnunciatorConfigurationSeq(jd.Struct):
        """annunciator_configuration_rec: Annunciator configuration"""
        annunciator_id_rec: ReportAnnunciatorConfiguration.AnnunciatorIdRec = jd.field("AnnunciatorIdRec", lambda: ReportAnnunciatorConfiguration.AnnunciatorIdRec.layout())
        annunciator_configuration_rec: ReportAnnunciatorConfiguration.AnnunciatorConfigurationRec = jd.field("AnnunciatorConfigurationRec", lambda: ReportAnnunciatorConfiguration.AnnunciatorConfigurationRec.layout())

    annunciator_configuration_list: list[ReportAnnunciatorConfiguration.AnnunciatorConfigurationSeq] = jd.field("AnnunciatorConfigurationList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportAnnunciatorConfiguration.AnnunciatorConfigurationSeq.layout()))


@jd.message(_SERVICE, 0xEF02, query=True)
class QueryAnnunciatorConfiguration(jd.Message):
    """QueryAnnunciatorConfiguration (0xEF02): Asks for the settings in use.

    annunciator_id: Number of the sound device; 0 asks for every device
    """
    REPORT = ReportAnnunciatorConfiguration
    annunciator_id: int = jd.field("AnnunciatorID", jd.Number("H"))


@jd.message(_SERVICE, 0xFF03)
class ReportAnnunciatorEndpoint(jd.Message):
    """ReportAnnunciatorEndpoint (0xFF03): Network addresses that take the audio of each device.

    annunciator_endpoint_list: 0..255 items. One entry a device
    """

    @jd.record()
    class AnnunciatorIdRec(jd.Struct):
        """annunciator_id: Number of the sound device; 0 is not allowed"""
        annunciator_id: int = jd.field("AnnunciatorID", jd.Number("H"))

    @jd.record()
    class EndpointRec(jd.Struct):
        """ip_addr: IPv4 address that takes the stream
        port: Port that takes the stream
        """
        ip_addr: int = jd.field("IpAddr", jd.Number("I"))
        port: int = jd.field("Port", jd.Number("H"))

    @jd.record()
    class AnnunciatorEndpointSeq(jd.Struct):
        """AnnunciatorEndpointSeq."""
        annunciator_id_rec: ReportAnnunciatorEndpoint.AnnunciatorIdRec = jd.field("AnnunciatorIdRec", lambda: ReportAnnunciatorEndpoint.AnnunciatorIdRec.layout())
        endpoint_rec: ReportAnnunciatorEndpoint.EndpointRec = jd.field("EndpointRec", lambda: ReportAnnunciatorEndpoint.EndpointRec.layout())

    annunciator_endpoint_list: list[ReportAnnunciatorEndpoint.AnnunciatorEndpointSeq] = jd.field("AnnunciatorEndpointList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportAnnunciatorEndpoint.AnnunciatorEndpointSeq.layout()))


@jd.message(_SERVICE, 0xEF03, query=True)
class QueryAnnunciatorEndpoint(jd.Message):
    """QueryAnnunciatorEndpoint (0xEF03): Asks for the network address that takes the RTP audio.

    annunciator_id: Number of the sound device; 0 asks for every device
    """
    REPORT = ReportAnnunciatorEndpoint
    annunciator_id: int = jd.field("AnnunciatorID", jd.Number("H"))


@jd.message(_SERVICE, 0xDF02, command=True)
class SetAnnunciatorConfiguration(jd.Message):
    """SetAnnunciatorConfiguration (0xDF02): Sets the stream parameters of one device.

    annunciator_configuration_rec: Annunciator configuration
    """

    @jd.record()
    class AnnunciatorIdRec(jd.Struct):
        """annunciator_id: Number of the sound device; 0 is not allowed"""
        annunciator_id: int = jd.field("AnnunciatorID", jd.Number("H"))

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
    class AnnunciatorConfigurationRec(jd.Struct):
        """Annunciator configuration.

        minimum_bitrate: Lower bound of the stream's bit rate, in kbit/s; equal to MaximumBitrate if the rate is constant
        maximum_bitrate: Upper bound of the stream's bit rate, in kbit/s; equal to MinimumBitrate if the rate is constant
        sample_rate: Samples per second; lies within the limits of ReportAnnunciatorCapabilities
        sample_width: SampleWidth. Size of a sample
        formats: Formats. Coding of the audio
        encoding_quality: EncodingQuality. Quality grade of the coding
        number_channels: Channels in the stream (1 mono, 2 stereo)
        audio_gain: 0..100. Gain of the audio, 0 to 100
        """
        minimum_bitrate: int = jd.field("MinimumBitrate", jd.Number("H"))
        maximum_bitrate: int = jd.field("MaximumBitrate", jd.Number("H"))
        sample_rate: int = jd.field("SampleRate", jd.Number("Q"))
        sample_width: SetAnnunciatorConfiguration.SampleWidth | int = jd.field("SampleWidth", lambda: jd.Number("B", jd.Values(SetAnnunciatorConfiguration.SampleWidth)))
        formats: SetAnnunciatorConfiguration.Formats | int = jd.field("Formats", lambda: jd.Number("B", jd.Values(SetAnnunciatorConfiguration.Formats)))
        encoding_quality: SetAnnunciatorConfiguration.EncodingQuality | int = jd.field("EncodingQuality", lambda: jd.Number("B", jd.Values(SetAnnunciatorConfiguration.EncodingQuality)))
        number_channels: int = jd.field("NumberChannels", jd.Number("B"))
        audio_gain: float = jd.field("AudioGain", jd.real("B", 0.0, 100.0))

    annunciator_id_rec: SetAnnunciatorConfiguration.AnnunciatorIdRec = jd.field("AnnunciatorIdRec", lambda: SetAnnunciatorConfiguration.AnnunciatorIdRec.layout())
    annunciator_configuration_rec: SetAnnunciatorConfiguration.AnnunciatorConfigurationRec = jd.field("AnnunciatorConfigurationRec", lambda: SetAnnunciatorConfiguration.AnnunciatorConfigurationRec.layout())


@jd.message(_SERVICE, 0xFF05)
class ConfirmAnnunciatorStream(jd.Message):
    """ConfirmAnnunciatorStream (0xFF05): Answer to ControlAnnunciatorStream with the state reached by the device."""

    @jd.record()
    class AnnunciatorIdRec(jd.Struct):
        """annunciator_id: Number of the sound device; 0 is not allowed"""
        annunciator_id: int = jd.field("AnnunciatorID", jd.Number("H"))

    class StreamStatus(IntEnum):
        INITIAL = 0
        READY = 1
        STREAMING = 2
        STOPPED = 3

    @jd.record()
    class AnnunciatorStreamStatus(jd.Struct):
        """stream_status: StreamStatus. State of the device's stream"""
        stream_status: ConfirmAnnunciatorStream.StreamStatus | int = jd.field("StreamStatus", lambda: jd.Number("B", jd.Values(ConfirmAnnunciatorStream.StreamStatus)))

    annunciator_id_rec: ConfirmAnnunciatorStream.AnnunciatorIdRec = jd.field("AnnunciatorIdRec", lambda: ConfirmAnnunciatorStream.AnnunciatorIdRec.layout())
    annunciator_stream_status: ConfirmAnnunciatorStream.AnnunciatorStreamStatus = jd.field("AnnunciatorStreamStatus", lambda: ConfirmAnnunciatorStream.AnnunciatorStreamStatus.layout())
