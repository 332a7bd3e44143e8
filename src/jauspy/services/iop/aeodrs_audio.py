"""DigitalAudioSensor and DigitalAudioAnnuciator of AEODRS 1.4: streams of microphones, and to loudspeakers.

Of its codings (mu-law, AAC, MP3) mu-law is offered: G.711 at 8 kHz over RTP. Loudspeakers also take Opus, as the
payload type says.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from ipaddress import IPv4Address
from typing import Final

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.exp import (
    ConfirmAnnunciatorStream,
    ControlAnnunciatorStream,
    ControlDigitalAudioSensorStream,
    QueryAnnunciatorCapabilities,
    QueryAnnunciatorConfiguration,
    QueryAnnunciatorEndpoint,
    QueryDigitalAudioSensorCapabilities,
    QueryDigitalAudioSensorConfiguration,
    QueryDigitalAudioSensorStreamEndpoint,
    ReportAnnunciatorCapabilities,
    ReportAnnunciatorConfiguration,
    ReportAnnunciatorEndpoint,
    ReportDigitalAudioSensorCapabilities,
    ReportDigitalAudioSensorConfiguration,
    ReportDigitalAudioSensorStreamEndpoint,
    SetAnnunciatorConfiguration,
    SetDigitalAudioSensorConfiguration,
    SetDigitalAudioSensorStreamEndpoint,
)
from jauspy.messages.exp.v1_0.types import EncodingQuality, Formats, SampleWidths
from jauspy.platform.sound import Address, AudioSettings
from jauspy.protocol.addressing import Location
from jauspy.services.deferred import Deferred
from jauspy.services.environment_sensing.digital_resource_discovery import MediaStreams, StreamState
from jauspy.services.iop.sound_devices import SoundDevices, address_of, chosen, hosts_of
from jauspy.services.service import Service

BIT_RATE, TELEPHONY_RATE = 64, 8000
"""Kilobits and samples per second of G.711."""

_SENSOR, _SPEAKER = ReportDigitalAudioSensorConfiguration, ReportAnnunciatorConfiguration
_SensorSettings = SetDigitalAudioSensorConfiguration.AudioSensorConfigurationRec
_SpeakerSettings = SetAnnunciatorConfiguration.AnnunciatorConfigurationRec
_Command = ControlAnnunciatorStream.StreamCommand
_Status = ConfirmAnnunciatorStream.StreamStatus

_WIDTHS: Final = SampleWidths(1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)
_FORMATS: Final = Formats(u_law=1, aac=0, mp3=0)
_QUALITY: Final = EncodingQuality(highest=0, high=0, good=1, median=0, fair=0, poor=0, lowest=0)


_CAPABILITY: Final = (BIT_RATE, BIT_RATE, TELEPHONY_RATE, TELEPHONY_RATE, _WIDTHS, _FORMATS, _QUALITY, 1)
"""Bit rates, sample rates and so on: the same of both services, as are the numbers of their enums."""
_CONFIGURATION: Final = (
    BIT_RATE,
    BIT_RATE,
    TELEPHONY_RATE,
    int(_SENSOR.SampleWidth.EIGHT_BITS),
    int(_SENSOR.Formats.U_LAW),
    int(_SENSOR.EncodingQuality.GOOD),
    1,
)
"""A configuration but for its gain."""


def _problem(record: _SensorSettings | _SpeakerSettings) -> str:
    """The part of a configuration that is not supported; empty if all is."""
    if record.formats != _SENSOR.Formats.U_LAW:
        return f"the format is {record.formats}, and only mu-law (0) is offered"
    if not record.minimum_bitrate <= BIT_RATE <= record.maximum_bitrate:
        return f"bit rates {record.minimum_bitrate} to {record.maximum_bitrate} kbit/s do not include {BIT_RATE}"
    if record.sample_rate != TELEPHONY_RATE or record.number_channels != 1:
        return f"{record.number_channels} channels at {record.sample_rate} Hz, and one at {TELEPHONY_RATE} is offered"
    return ""


class DigitalAudioSensor(Service, urn="urn:jaus:jss:exp:aeodrs:DigitalAudioSensor"):
    """Streams microphones to receivers that the client in control chooses, one for each microphone.

    A receiver is on the client's own machine, or in the networks that the robot's file permits. A stream ends with
    the client's control.
    """

    def __init__(self, devices: SoundDevices, streams: MediaStreams) -> None:
        self._microphones, self._streams = devices.microphones, streams
        self._receivers: dict[int, Address] = {}

    def send_report_digital_audio_sensor_capabilities(
        self, query: QueryDigitalAudioSensorCapabilities
    ) -> ReportDigitalAudioSensorCapabilities:
        """Capabilities of each microphone."""
        kind = ReportDigitalAudioSensorCapabilities
        record = kind.DigitalAudioSensorCapabilityRec(*_CAPABILITY)
        numbers = chosen(query.sensor_id, self._microphones)
        return kind([kind.AudioSensorCapabilitySeq(kind.SensorIdRec(number), record) for number in numbers])

    def send_report_digital_audio_sensor_configuration(
        self, query: QueryDigitalAudioSensorConfiguration
    ) -> ReportDigitalAudioSensorConfiguration:
        """The settings of each microphone."""
        return _SENSOR(
            [
                _SENSOR.AudioSensorConfigurationSeq(
                    _SENSOR.SensorIdRec(number),
                    _SENSOR.AudioSensorConfigurationRec(
                        *_CONFIGURATION, 100.0 * self._microphones[number].settings.gain
                    ),
                )
                for number in chosen(query.sensor_id, self._microphones)
            ]
        )

    def send_report_digital_audio_sensor_stream_endpoint(
        self, query: QueryDigitalAudioSensorStreamEndpoint
    ) -> ReportDigitalAudioSensorStreamEndpoint:
        """The receiver of each microphone; address and port 0 without one."""
        kind = ReportDigitalAudioSensorStreamEndpoint
        return kind(
            [
                kind.AudioSensorEndpointSeq(
                    kind.SensorIdRec(number), kind.EndpointRecord(*_numbers(self._receivers.get(number)))
                )
                for number in chosen(query.sensor_id, self._microphones)
            ]
        )

    def set_digital_audio_sensor_configuration_action(
        self, msg: SetDigitalAudioSensorConfiguration, source: JausID
    ) -> None:
        """Use the gain; other settings have one value each, and a request for others is refused and counted."""
        microphone = self._microphones.get(msg.sensor_id_rec.sensor_id)
        record = msg.audio_sensor_configuration_rec
        problem = f"there is no microphone {msg.sensor_id_rec.sensor_id}" if microphone is None else _problem(record)
        if microphone is None or problem:
            self.host.count("audio_settings_refused", f"{source}: {problem}")
            return
        microphone.settings = _with_gain(microphone.settings, record.audio_gain)

    def set_digital_audio_sensor_stream_endpoint_action(
        self, msg: SetDigitalAudioSensorStreamEndpoint, source: JausID
    ) -> None:
        """Choose the receiver; a stream to another one ends."""
        number = msg.sensor_id_rec.sensor_id
        if number not in self._microphones:
            self.host.count("endpoint_refused", f"{source}: there is no microphone {number}")
            return
        self._end(number)
        record = msg.endpoint_record
        self._receivers[number] = (str(IPv4Address(record.ip_addr)), record.port)

    def control_digital_audio_sensor_stream_action(self, msg: ControlDigitalAudioSensorStream, source: JausID) -> None:
        """Start, halt or end the stream; one that was ended needs its receiver again."""
        number, command = msg.annunciator_id_rec.sensor_id_rec, msg.stream_control_rec.stream_command
        if number not in self._receivers:
            self.host.count("stream_unknown", f"{source}: microphone {number} has no receiver")
        elif command == _Command.STREAM_START:
            self.host.locate(source, partial(self._start, number, self._receivers[number], source))
        elif command == _Command.STREAM_STOP:
            self._streams.control(source, number, StreamState.PAUSE)
        elif command == _Command.STREAM_TERMINATE:
            self._end(number)
            del self._receivers[number]
        else:
            self.host.count("stream_refused", f"{source}: there is no command {command}")

    def _start(self, number: int, receiver: Address, source: JausID, location: Location) -> None:
        if source != self.host.controller or self._receivers.get(number) != receiver:
            return
        try:
            self._streams.register(source, number, f"rtp://{receiver[0]}:{receiver[1]}", location, [source])
            self._streams.control(source, number, StreamState.PLAY)
        except ConfigError as error:
            self.host.count("endpoint_refused", f"{source}: {error}")

    def _end(self, number: int) -> None:
        for key, point in list(self._streams.end_points.items()):
            if point.sensor == number:
                self._streams.remove(key)

    def control_lost(self) -> None:
        """End all streams."""
        for number in list(self._receivers):
            self._end(number)
        self._receivers.clear()


@dataclass(slots=True)
class _SpeakerState:
    status: _Status = _Status.INITIAL
    address: Address | None = None
    """Where it takes a stream."""


class AnnunciatorStreams(Service, urn="urn:jaus:jss:exp:aeodrs:DigitalAudioAnnuciator"):
    """Loudspeakers that play what the client in control sends by RTP, from its own machine.

    The client in control learns where to send: a port is opened for it. Playing ends with its control.
    """

    def __init__(self, devices: SoundDevices) -> None:
        self._loudspeakers = devices.loudspeakers
        self._states = {number: _SpeakerState() for number in devices.loudspeakers}
        self._reply: Deferred | None = None

    def send_report_annunciator_capabilities(
        self, query: QueryAnnunciatorCapabilities
    ) -> ReportAnnunciatorCapabilities:
        """Capabilities of each loudspeaker."""
        kind = ReportAnnunciatorCapabilities
        record = kind.AnnunciatorCapabilityRec(*_CAPABILITY)
        numbers = chosen(query.annunciator_id, self._loudspeakers)
        return kind([kind.AnnunciatorCapabilitySeq(kind.AnnunciatorIdRec(number), record) for number in numbers])

    def send_report_annunciator_configuration(
        self, query: QueryAnnunciatorConfiguration
    ) -> ReportAnnunciatorConfiguration:
        """The settings of each loudspeaker."""
        return _SPEAKER(
            [
                _SPEAKER.AnnunciatorConfigurationSeq(
                    _SPEAKER.AnnunciatorIdRec(number),
                    _SPEAKER.AnnunciatorConfigurationRec(
                        *_CONFIGURATION, 100.0 * self._loudspeakers[number].settings.gain
                    ),
                )
                for number in chosen(query.annunciator_id, self._loudspeakers)
            ]
        )

    def send_report_annunciator_endpoint(
        self, query: QueryAnnunciatorEndpoint, source: JausID
    ) -> ReportAnnunciatorEndpoint | Deferred:
        """Where each loudspeaker takes a stream: for the client in control, which it then listens to; else as it is."""
        numbers = chosen(query.annunciator_id, self._loudspeakers)
        if source != self.host.controller or not numbers:
            return self._endpoints(numbers)
        reply = self.host.defer(lambda: self._endpoints(numbers))
        if reply.report is None:
            self.host.locate(source, partial(self._listen, numbers, source, reply))
        return reply

    def _listen(self, numbers: list[int], source: JausID, reply: Deferred, location: Location) -> None:
        waiting = set(numbers)

        def on_port(number: int, address: Address | None) -> None:
            state = self._states[number]
            state.address = address
            if state.status is _Status.INITIAL and address is not None:
                state.status = _Status.READY
            waiting.discard(number)
            if not waiting:
                reply.set_result(self._endpoints(numbers))

        for number in numbers:
            try:
                self._loudspeakers[number].listen(address_of(location), partial(on_port, number))
            except ConfigError as error:
                self.host.count("announcement_refused", f"{source}: {error}")
                on_port(number, None)

    def _endpoints(self, numbers: list[int]) -> ReportAnnunciatorEndpoint:
        kind = ReportAnnunciatorEndpoint
        return kind(
            [
                kind.AnnunciatorEndpointSeq(
                    kind.AnnunciatorIdRec(number), kind.EndpointRec(*_numbers(self._states[number].address))
                )
                for number in numbers
            ]
        )

    def set_annunciator_configuration_action(self, msg: SetAnnunciatorConfiguration, source: JausID) -> None:
        """Use the gain; other settings have one value each, and a request for others is refused and counted."""
        number, record = msg.annunciator_id_rec.annunciator_id, msg.annunciator_configuration_rec
        loudspeaker = self._loudspeakers.get(number)
        problem = f"there is no loudspeaker {number}" if loudspeaker is None else _problem(record)
        if loudspeaker is None or problem:
            self.host.count("audio_settings_refused", f"{source}: {problem}")
            return
        loudspeaker.settings = _with_gain(loudspeaker.settings, record.audio_gain)

    def control_annunciator_stream_action(self, msg: ControlAnnunciatorStream, source: JausID) -> None:
        """Play what the client sends, or nothing any more."""
        number, command = msg.annunciator_id_rec.annunciator_id, msg.stream_control_rec.stream_command
        self._reply = None
        if number not in self._loudspeakers:
            self.host.count("announcement_refused", f"{source}: there is no loudspeaker {number}")
        elif command == _Command.STREAM_START:
            self._reply = reply = self.host.defer(partial(self._confirmation, number))
            if reply.report is None:
                self.host.locate(source, partial(self._start, number, source, reply))
        elif command in (_Command.STREAM_STOP, _Command.STREAM_TERMINATE):
            self._stop(number, _Status.STOPPED if command == _Command.STREAM_STOP else _Status.INITIAL)
        else:
            self.host.count("stream_refused", f"{source}: there is no command {command}")

    def send_confirm_annunciator_stream_action(
        self, msg: ControlAnnunciatorStream
    ) -> ConfirmAnnunciatorStream | Deferred:
        """The state that the loudspeaker has reached; INITIAL for one that there is not."""
        reply, self._reply = self._reply, None
        return reply or self._confirmation(msg.annunciator_id_rec.annunciator_id)

    def _start(self, number: int, source: JausID, reply: Deferred, location: Location) -> None:
        state, loudspeaker = self._states[number], self._loudspeakers[number]

        def on_port(address: Address | None) -> None:
            state.address = address
            if address is not None and source == self.host.controller and reply.report is None:
                loudspeaker.play(hosts_of(location))
                state.status = _Status.STREAMING
            reply.set_result(self._confirmation(number))

        try:
            loudspeaker.listen(address_of(location), on_port)
        except ConfigError as error:
            self.host.count("announcement_refused", f"{source}: {error}")
            reply.set_result(self._confirmation(number))

    def _confirmation(self, number: int) -> ConfirmAnnunciatorStream:
        kind = ConfirmAnnunciatorStream
        status = self._states[number].status if number in self._states else _Status.INITIAL
        return kind(kind.AnnunciatorIdRec(number), kind.AnnunciatorStreamStatus(status))

    def _stop(self, number: int, status: _Status) -> None:
        if self._states[number].status is _Status.STREAMING:
            self._loudspeakers[number].stop()
        self._states[number].status = status

    def control_lost(self) -> None:
        """Play nothing."""
        for number in self._states:
            self._stop(number, _Status.INITIAL)


def _with_gain(settings: AudioSettings, percent: float) -> AudioSettings:
    return replace(settings, gain=percent / 100.0)


def _numbers(address: Address | None) -> tuple[int, int]:
    """An address as the definition has it; zeros without one, and for IPv6, which it has no room for."""
    if address is None or ":" in address[0]:
        return 0, 0
    return int(IPv4Address(address[0])), address[1]
