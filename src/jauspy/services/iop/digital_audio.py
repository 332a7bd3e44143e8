"""DigitalAudio and DigitalAudioAnnunciator: settings of microphones and loudspeakers, and what these play (IOP v3).

Sound is Opus over RTP, which the definition's list of codings lacks: reports leave the coding out, and a request that
names one is unsupported. Clients get the sound of microphones by DigitalResourceDiscovery.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.iop import (
    QueryDigitalAudioCapabilities,
    QueryDigitalAudioConfiguration,
    QueryDigitalAudioStreamSource,
    ReportDigitalAudioCapabilities,
    ReportDigitalAudioConfiguration,
    ReportDigitalAudioStreamSource,
    SetDigitalAudioConfiguration,
    SetDigitalAudioConfigurationResponse,
    SetDigitalAudioStreamSource,
)
from jauspy.platform.sound import MAX_BIT_RATE, MIN_BIT_RATE, SAMPLE_RATE, Address
from jauspy.protocol.addressing import Location
from jauspy.services.environment_sensing.digital_resource_discovery import MediaStreams, check_target, parse_rtp_url
from jauspy.services.iop.sound_devices import SoundDevices, chosen
from jauspy.services.service import Service

_Requested = SetDigitalAudioConfiguration.DigitalAudioConfigurationRec
_Code = SetDigitalAudioConfigurationResponse.ResponseCode
_Source = SetDigitalAudioStreamSource.DigitalAudioStreamSourceRec


class DigitalAudio(Service, urn="urn:jaus:jss:iop:DigitalAudio"):
    """Settings of all devices: bit rate, and the sensitivity of a microphone or volume of a loudspeaker (50 %: as is).

    A request is carried out for all devices that it names, or not at all. `streams`: end points of the microphones,
    which end with their clients.
    """

    def __init__(self, devices: SoundDevices, streams: MediaStreams) -> None:
        self._devices, self._streams = devices, streams

    def send_report_digital_audio_capabilities(
        self, query: QueryDigitalAudioCapabilities
    ) -> ReportDigitalAudioCapabilities:
        """What each device can do."""
        kind = ReportDigitalAudioCapabilities
        depths = kind.SupportedBitDepths(
            eight_bits=0,
            ten_bits=0,
            twelve_bits=0,
            fourteen_bits=0,
            sixteen_bits=1,
            twenty_bits=0,
            twenty_four_bits=0,
            thirty_two_bits=0,
        )
        return kind(
            [
                kind.DigitalAudioCapabilityRec(
                    number,
                    MIN_BIT_RATE,
                    MAX_BIT_RATE,
                    min_sample_rate=SAMPLE_RATE,
                    max_sample_rate=SAMPLE_RATE,
                    supported_bit_depths=depths,
                )
                for number in chosen(query.sensor_id, self._devices.all)
            ]
        )

    def send_report_digital_audio_configuration(
        self, query: QueryDigitalAudioConfiguration
    ) -> ReportDigitalAudioConfiguration:
        """The settings of each device."""
        devices, kind = self._devices.all, ReportDigitalAudioConfiguration
        return kind(
            [
                kind.DigitalAudioConfigurationRec(
                    number,
                    100.0 * devices[number].settings.gain,
                    devices[number].settings.bit_rate,
                    devices[number].settings.bit_rate,
                    sample_rate=SAMPLE_RATE,
                    bit_depth=kind.BitDepth.SIXTEEN_BITS,
                )
                for number in chosen(query.sensor_id, devices)
            ]
        )

    def is_valid_sensor(self, msg: SetDigitalAudioConfiguration) -> bool:
        """True if the request names devices that there are."""
        known = self._devices.all
        return all(record.sensor_id in known for record in msg.digital_audio_configuration_list)

    def is_valid_command(self, msg: SetDigitalAudioConfiguration) -> bool:
        """True if the devices can be set as the request says."""
        return all(map(_is_supported, msg.digital_audio_configuration_list))

    def set_configuration(self, msg: SetDigitalAudioConfiguration) -> None:
        """Use the new settings from the next frame on; what is left out stays as it is."""
        devices = self._devices.all
        for record in msg.digital_audio_configuration_list:
            device = devices[record.sensor_id]
            rates = [rate for rate in (record.maximum_bit_rate, record.minimum_bit_rate) if rate is not None]
            gain = device.settings.gain if record.sensitivity is None else record.sensitivity / 100.0
            device.settings = replace(
                device.settings, gain=gain, bit_rate=rates[0] if rates else device.settings.bit_rate
            )

    def send_set_digital_audio_configuration_response_success(
        self, msg: SetDigitalAudioConfiguration
    ) -> SetDigitalAudioConfigurationResponse:
        """The answer to a request that is carried out."""
        return SetDigitalAudioConfigurationResponse(msg.request_id_rec.request_id, _Code.SUCCESS)

    def send_set_digital_audio_configuration_response_sensor_not_found(
        self, msg: SetDigitalAudioConfiguration
    ) -> SetDigitalAudioConfigurationResponse:
        """The answer to a request that names a device which is not there."""
        return SetDigitalAudioConfigurationResponse(
            msg.request_id_rec.request_id, _Code.ONE_OR_MORE_SENSOR_IDS_NOT_FOUND
        )

    def send_set_digital_audio_configuration_response_unsupported(
        self, msg: SetDigitalAudioConfiguration
    ) -> SetDigitalAudioConfigurationResponse:
        """The answer to a request for what the devices cannot do."""
        return SetDigitalAudioConfigurationResponse(msg.request_id_rec.request_id, _Code.UNSUPPORTED_CONFIGURATION)

    def client_lost(self, client: JausID) -> None:
        """Remove the end points of the client."""
        self._streams.remove_client(client)


def _is_supported(record: _Requested) -> bool:
    rates = [rate for rate in (record.minimum_bit_rate, record.maximum_bit_rate) if rate is not None]
    return (
        all(MIN_BIT_RATE <= rate <= MAX_BIT_RATE for rate in rates)
        and rates == sorted(rates)
        and record.digital_format is None
        and record.sample_rate in (None, SAMPLE_RATE)
        and record.bit_depth in (None, SetDigitalAudioConfiguration.BitDepth.SIXTEEN_BITS)
        and record.encoding_quality is None
    )


class DigitalAudioAnnunciator(Service, urn="urn:jaus:jss:iop:DigitalAudioAnnunciator"):
    """Loudspeakers that play what comes from `rtp://ADDRESS:PORT`, on the client's machine, to the loudspeaker's port.

    An empty address ends it, as does the loss of control. A live stream has no end, so that Repeat has no effect.
    `rtsp://` is refused: what a server of a client's choice answers may lead the robot anywhere.
    """

    def __init__(self, devices: SoundDevices) -> None:
        self._devices = devices
        self._played: dict[int, _Source] = {}

    def send_report_digital_audio_stream_source(
        self, query: QueryDigitalAudioStreamSource
    ) -> ReportDigitalAudioStreamSource:
        """What each loudspeaker plays."""
        kind = ReportDigitalAudioStreamSource
        records = []
        for number in chosen(query.sensor_id, self._devices.loudspeakers):
            played = self._played.get(number)
            url, repeat = (played.stream_url, played.repeat) if played else ("", kind.Repeat.PLAY_ONCE)
            records.append(kind.DigitalAudioStreamSourceRec(number, url, repeat))
        return kind(records)

    def play_stream(self, msg: SetDigitalAudioStreamSource, source: JausID) -> None:
        """Play these streams; one that cannot be played is counted, and ends what the loudspeaker played."""
        for record in msg.digital_audio_stream_source_list:
            if record.sensor_id not in self._devices.loudspeakers:
                self.host.count("announcement_refused", f"{source}: there is no loudspeaker {record.sensor_id}")
                continue
            self._stop(record.sensor_id)
            if not record.stream_url:
                continue
            try:
                address = parse_rtp_url(record.stream_url)
            except ConfigError as error:
                self.host.count("announcement_refused", f"{source}: {error}")
                continue
            self.host.locate(source, partial(self._play, record, source, address))

    def _play(self, record: _Source, source: JausID, address: Address, location: Location) -> None:
        if source != self.host.controller:  # control ended meanwhile
            return
        loudspeaker = self._devices.loudspeakers[record.sensor_id]
        try:
            check_target(address, location, source, self._devices.targets)
            loudspeaker.listen(address[0], lambda _: None)
        except ConfigError as error:
            self.host.count("announcement_refused", f"{source}: {error}")
            return
        loudspeaker.play(frozenset({address[0]}), address[1])
        self._played[record.sensor_id] = record

    def control_lost(self) -> None:
        """Play nothing."""
        for number in list(self._played):
            self._stop(number)

    def _stop(self, number: int) -> None:
        if self._played.pop(number, None) is not None:
            self._devices.loudspeakers[number].stop()
