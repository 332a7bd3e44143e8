"""Services of sound: settings, who gets a stream, and who may play."""

from __future__ import annotations

import ipaddress
import itertools

import pytest

from jauspy.ids import JausID
from jauspy.messages.core import ReleaseControl, RequestControl, Resume
from jauspy.messages.environment_sensing import (
    ConfirmDigitalResourceEndpoint,
    RegisterDigitalResourceEndpoint as Register,
)
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
    SetAnnunciatorConfiguration,
    SetDigitalAudioSensorConfiguration,
    SetDigitalAudioSensorStreamEndpoint,
)
from jauspy.messages.iop import (
    QueryDigitalAudioCapabilities,
    QueryDigitalAudioConfiguration,
    QueryDigitalAudioStreamSource,
    SetDigitalAudioConfiguration,
    SetDigitalAudioConfigurationResponse,
    SetDigitalAudioStreamSource,
)
from jauspy.platform.sound import AudioSettings, Coding
from jauspy.platform.video_settings import RTP_SERVER_TYPE
from jauspy.protocol.addressing import UNKNOWN_LOCATION, Location
from jauspy.services.core import AccessControl, Management
from jauspy.services.environment_sensing import DigitalResourceDiscovery, MediaStreams
from jauspy.services.environment_sensing.digital_resource_discovery import MAX_END_POINTS_PER_CLIENT
from jauspy.services.iop import AnnunciatorStreams, DigitalAudio, DigitalAudioAnnunciator, DigitalAudioSensor
from jauspy.services.iop.sound_devices import CodedMicrophone, SoundDevices

OPERATOR, OTHER = "42.1.1", "43.1.1"
WHERE = {JausID.parse(OPERATOR): "192.0.2.42", JausID.parse(OTHER): "192.0.2.43"}
FOREIGN = "198.51.100.9"
Command, Status = ControlAnnunciatorStream.StreamCommand, ConfirmAnnunciatorStream.StreamStatus
Code = SetDigitalAudioConfigurationResponse.ResponseCode
Settings = SetDigitalAudioConfiguration.DigitalAudioConfigurationRec
PORTS = itertools.count(20000, 2)


class FakeMicrophone:
    def __init__(self) -> None:
        self.settings = AudioSettings()
        self.listeners: dict[tuple[str, int], tuple[bool, Coding]] = {}

    def watch(self, address, *, playing=True, coding=Coding.OPUS):
        self.listeners[address] = (playing, coding)

    def leave(self, address):
        self.listeners.pop(address, None)


class FakeLoudspeaker:
    def __init__(self) -> None:
        self.settings = AudioSettings()
        self.hosts: frozenset[str] = frozenset()
        self.port: int | None = None
        self.opens = True

    def listen(self, client, then):
        then(("203.0.113.1", 7000) if self.opens else None)

    def play(self, hosts, port=None):
        self.hosts, self.port = hosts, port

    def stop(self):
        self.hosts = frozenset()


class Site:
    """A component with a microphone (1) and a loudspeaker (2), and an operator in control of it."""

    def __init__(self, make, targets=()) -> None:
        self.microphone, self.loudspeaker = FakeMicrophone(), FakeLoudspeaker()
        devices = SoundDevices({1: self.microphone}, {2: self.loudspeaker}, tuple(map(ipaddress.ip_network, targets)))
        opus, telephony = (
            MediaStreams({1: CodedMicrophone(self.microphone, coding)}, devices.targets)
            for coding in (Coding.OPUS, Coding.PCMU)
        )
        self.rig = make(
            AccessControl(timeout=0),
            Management(),
            DigitalAudio(devices, opus),
            DigitalResourceDiscovery(opus),
            DigitalAudioSensor(devices, telephony),
            DigitalAudioAnnunciator(devices),
            AnnunciatorStreams(devices),
        )
        self.known = True
        self.rig.host.locate = self._locate
        self.rig.tell(OPERATOR, RequestControl(100))
        self.rig.tell(OPERATOR, Resume())

    def _locate(self, client, found):
        hosts = frozenset({WHERE[client]})
        found(Location(hosts=hosts, ports=frozenset({3794})) if self.known else UNKNOWN_LOCATION)

    def count(self, reason):
        return self.rig.host.counters.get(reason, 0)

    def tell(self, message, client=OPERATOR):
        """What is sent in turn, deferred replies too."""
        now = self.rig.tell(client, message.encode(strict=False))
        return now + [(to, answer) for _, to, answer in self.rig.run(0.0)]

    def ask(self, message, client=OPERATOR):
        ((to, answer),) = self.tell(message, client)
        assert to == client
        return answer

    def release(self):
        self.tell(ReleaseControl())

    # --- AEODRS

    def stream_to(self, host, port, number=1):
        kind = SetDigitalAudioSensorStreamEndpoint
        record = kind.EndpointRecord(int(ipaddress.IPv4Address(host)), port)
        self.tell(kind(kind.SensorIdRec(number), record))

    def control(self, command, number=1):
        kind = ControlDigitalAudioSensorStream
        self.tell(kind(kind.AnnunciatorIdRec(number), kind.StreamControlRec(command)))

    def announce(self, command, number=2, client=OPERATOR):
        kind = ControlAnnunciatorStream
        return self.tell(kind(kind.AnnunciatorIdRec(number), kind.StreamControlRec(command)), client)

    # --- IOP

    def register(self, url, client=OPERATOR, sensor=1):
        record = Register.DigitalResourceEndpointRec(RTP_SERVER_TYPE, url, None, sensor)
        answer = self.ask(Register(Register.RequestIDRec(1), record), client)
        assert isinstance(answer, ConfirmDigitalResourceEndpoint)
        return answer.id

    def configure(self, *records):
        kind = SetDigitalAudioConfiguration
        return self.tell(kind(kind.RequestIDRec(9), list(records)))

    def play(self, url, number=2, client=OPERATOR):
        kind = SetDigitalAudioStreamSource
        record = kind.DigitalAudioStreamSourceRec(number, url, kind.Repeat.PLAY_ONCE)
        return self.tell(kind([record]), client)


@pytest.fixture
def site(make):
    return Site(make)


# --- DigitalAudio: settings


@pytest.mark.parametrize(("asked", "found"), [(0, [1, 2]), (1, [1]), (2, [2]), (3, []), (65535, [])])
def test_reports_are_of_the_devices_that_were_asked_for(site, asked, found):
    capabilities = site.ask(QueryDigitalAudioCapabilities(asked)).digital_audio_capabilities_list
    settings = site.ask(QueryDigitalAudioConfiguration(asked)).digital_audio_configuration_list
    assert [item.sensor_id for item in capabilities] == [item.sensor_id for item in settings] == found
    for item in settings:
        assert (item.maximum_bit_rate, item.sample_rate, item.digital_format) == (48, 48000, None)
        assert item.sensitivity == pytest.approx(50.0, abs=0.01)


def test_settings_are_used(site):
    answers = site.configure(Settings(1, 25.0, 24, 32), Settings(2, 100.0))
    assert answers == [(OPERATOR, SetDigitalAudioConfigurationResponse(9, Code.SUCCESS))]
    assert site.microphone.settings.bit_rate == 32
    assert site.microphone.settings.gain == pytest.approx(0.25, abs=1e-3)
    assert site.loudspeaker.settings == AudioSettings(48, 1.0)


@pytest.mark.parametrize(
    ("record", "code"),
    [
        (Settings(1, maximum_bit_rate=5), Code.UNSUPPORTED_CONFIGURATION),
        (Settings(1, maximum_bit_rate=257), Code.UNSUPPORTED_CONFIGURATION),
        (Settings(1, minimum_bit_rate=65535), Code.UNSUPPORTED_CONFIGURATION),
        (Settings(1, minimum_bit_rate=64, maximum_bit_rate=32), Code.UNSUPPORTED_CONFIGURATION),
        (Settings(1, sample_rate=44100), Code.UNSUPPORTED_CONFIGURATION),
        (Settings(1, digital_format=14), Code.UNSUPPORTED_CONFIGURATION),
        (Settings(1, digital_format=255), Code.UNSUPPORTED_CONFIGURATION),
        (Settings(1, bit_depth=7), Code.UNSUPPORTED_CONFIGURATION),
        (Settings(1, encoding_quality=0), Code.UNSUPPORTED_CONFIGURATION),
        (Settings(0, 10.0), Code.ONE_OR_MORE_SENSOR_IDS_NOT_FOUND),
        (Settings(3, 10.0), Code.ONE_OR_MORE_SENSOR_IDS_NOT_FOUND),
    ],
)
def test_request_that_cannot_be_carried_out_changes_nothing(site, record, code):
    assert site.configure(Settings(2, 10.0), record) == [(OPERATOR, SetDigitalAudioConfigurationResponse(9, code))]
    assert site.microphone.settings == site.loudspeaker.settings == AudioSettings()


def test_client_without_control_changes_nothing(site):
    kind = SetDigitalAudioConfiguration
    assert not site.tell(kind(kind.RequestIDRec(1), [Settings(1, 10.0)]), OTHER)
    assert site.microphone.settings == AudioSettings()


# --- who gets a stream


def test_client_gets_opus_at_its_own_machine(site):
    assert site.register("rtp://192.0.2.43:5004", OTHER)
    assert site.microphone.listeners == {("192.0.2.43", 5004): (True, Coding.OPUS)}


@pytest.mark.parametrize(
    "url",
    [
        f"rtp://{FOREIGN}:5004",
        "rtp://192.0.2.43:5004",
        "rtp://192.0.2.42:3794",
        "rtp://192.0.2.42:3793",
        "rtp://192.0.2.42:53",
        "rtp://224.0.0.1:5004",
        "rtp://255.255.255.255:5004",
        "rtp://0.0.0.0:5004",
        "rtp://127.0.0.1:5004",
        "rtp://robot.example:5004",
        "http://192.0.2.42:5004",
        "rtp://192.0.2.42:99999",
        "",
    ],
)
def test_foreign_network_gets_nothing(site, url):
    assert not site.register(url)
    assert not site.microphone.listeners
    assert site.count("endpoint_refused") == 1


def test_network_of_the_robots_file_gets_a_stream(make):
    site = Site(make, ["198.51.100.0/24"])
    assert site.register(f"rtp://{FOREIGN}:5004")


def test_end_points_of_a_client_are_few(site):
    for _ in range(40):
        assert site.register(f"rtp://192.0.2.42:{next(PORTS)}")
        assert len(site.microphone.listeners) <= MAX_END_POINTS_PER_CLIENT


def test_lost_client_gets_nothing_more(site):
    site.register("rtp://192.0.2.43:5004", OTHER)
    site.rig.host.unreachable(JausID.parse(OTHER), site.rig.now)
    assert not site.microphone.listeners


# --- AEODRS: the microphone


def test_stream_of_aeodrs_is_mu_law_to_the_receiver_that_was_set(site):
    site.stream_to("192.0.2.42", 6000)
    (item,) = site.ask(QueryDigitalAudioSensorStreamEndpoint(0)).audio_sensor_endpoint_list
    assert item.endpoint_record.port == 6000
    assert not site.microphone.listeners
    site.control(Command.STREAM_START)
    assert site.microphone.listeners == {("192.0.2.42", 6000): (True, Coding.PCMU)}
    site.control(Command.STREAM_STOP)
    assert site.microphone.listeners == {("192.0.2.42", 6000): (False, Coding.PCMU)}
    site.control(Command.STREAM_START)
    assert site.microphone.listeners == {("192.0.2.42", 6000): (True, Coding.PCMU)}
    site.control(Command.STREAM_TERMINATE)
    assert not site.microphone.listeners
    (item,) = site.ask(QueryDigitalAudioSensorStreamEndpoint(1)).audio_sensor_endpoint_list
    assert (item.endpoint_record.ip_addr, item.endpoint_record.port) == (0, 0)


@pytest.mark.parametrize(
    ("host", "port"), [(FOREIGN, 6000), ("192.0.2.42", 3794), ("192.0.2.42", 0), ("224.0.0.1", 9999)]
)
def test_receiver_of_another_machine_is_refused(site, host, port):
    site.stream_to(host, port)
    site.control(Command.STREAM_START)
    assert not site.microphone.listeners
    assert site.count("endpoint_refused") == 1


def test_another_receiver_replaces_the_first(site):
    for port in (6000, 6002):
        site.stream_to("192.0.2.42", port)
        site.control(Command.STREAM_START)
    assert list(site.microphone.listeners) == [("192.0.2.42", 6002)]


@pytest.mark.parametrize("end", ["release", "lose"])
def test_stream_of_aeodrs_ends_with_control(site, end):
    site.stream_to("192.0.2.42", 6000)
    site.control(Command.STREAM_START)
    site.release() if end == "release" else site.rig.host.unreachable(JausID.parse(OPERATOR), site.rig.now)
    assert not site.microphone.listeners


def test_unknown_microphones_and_commands_are_counted(site):
    site.stream_to("192.0.2.42", 6000, number=2)
    assert site.count("endpoint_refused") == 1
    site.control(Command.STREAM_START, number=7)
    assert site.count("stream_unknown") == 1
    site.stream_to("192.0.2.42", 6000)
    site.control(200)
    assert site.count("stream_refused") == 1
    assert not site.microphone.listeners


def test_what_aeodrs_microphones_can_do(site):
    (item,) = site.ask(QueryDigitalAudioSensorCapabilities(0)).audio_sensor_capability_list
    record = item.digital_audio_sensor_capability_rec
    assert (record.formats.u_law, record.formats.aac, record.formats.mp3) == (1, 0, 0)
    assert (record.minimum_sample_rate, record.maximum_bitrate, record.maximum_channels) == (8000, 64, 1)


def sensor_settings(number, *, rate=8000, gain=20.0, format=0, channels=1, bit_rates=(64, 64)):
    kind = SetDigitalAudioSensorConfiguration
    record = kind.AudioSensorConfigurationRec(*bit_rates, rate, 0, format, 2, channels, gain)
    return kind(kind.SensorIdRec(number), record)


def speaker_settings(number, *, gain=20.0, format=0):
    kind = SetAnnunciatorConfiguration
    return kind(kind.AnnunciatorIdRec(number), kind.AnnunciatorConfigurationRec(64, 64, 8000, 0, format, 2, 1, gain))


def test_gain_of_aeodrs_is_used(site):
    site.tell(sensor_settings(1))
    site.tell(speaker_settings(2, gain=80.0))
    assert site.microphone.settings.gain == pytest.approx(0.2, abs=3e-3)
    assert site.loudspeaker.settings.gain == pytest.approx(0.8, abs=3e-3)
    (sensor,) = site.ask(QueryDigitalAudioSensorConfiguration(0)).audio_sensor_configuration_list
    (speaker,) = site.ask(QueryAnnunciatorConfiguration(0)).annunciator_configuration_list
    assert sensor.audio_sensor_configuration_rec.audio_gain == pytest.approx(20.0, abs=0.3)
    assert speaker.annunciator_configuration_rec.audio_gain == pytest.approx(80.0, abs=0.3)


@pytest.mark.parametrize(
    "message",
    [
        sensor_settings(2),
        sensor_settings(1, rate=2**63),
        sensor_settings(1, format=1),
        sensor_settings(1, channels=2),
        sensor_settings(1, bit_rates=(128, 256)),
        speaker_settings(1),
        speaker_settings(2, format=2),
    ],
)
def test_settings_of_aeodrs_that_are_not_offered_are_refused(site, message):
    site.tell(message)
    assert site.count("audio_settings_refused") == 1
    assert site.microphone.settings == site.loudspeaker.settings == AudioSettings()


# --- AEODRS: the loudspeaker


def endpoint(site, client=OPERATOR):
    (item,) = site.ask(QueryAnnunciatorEndpoint(0), client).annunciator_endpoint_list
    return str(ipaddress.IPv4Address(item.endpoint_rec.ip_addr)), item.endpoint_rec.port


def test_client_in_control_learns_where_to_send(site):
    assert endpoint(site, OTHER) == ("0.0.0.0", 0), "no port is opened for others"
    assert endpoint(site) == ("203.0.113.1", 7000)
    ((_, answer),) = site.announce(Command.STREAM_START)
    assert answer.annunciator_stream_status.stream_status == Status.STREAMING
    assert site.loudspeaker.hosts == {"192.0.2.42"}
    ((_, answer),) = site.announce(Command.STREAM_STOP)
    assert answer.annunciator_stream_status.stream_status == Status.STOPPED
    assert not site.loudspeaker.hosts


def test_client_without_control_does_not_play(site):
    assert not site.announce(Command.STREAM_START, client=OTHER)
    assert not site.loudspeaker.hosts


def test_client_whose_machine_is_not_known_does_not_play(site):
    site.known = False
    ((_, answer),) = site.announce(Command.STREAM_START)
    assert answer.annunciator_stream_status.stream_status == Status.INITIAL
    assert not site.loudspeaker.hosts
    assert site.count("announcement_refused") == 1
    assert endpoint(site)[1] == 0


def test_loudspeaker_without_a_port_does_not_play(site):
    site.loudspeaker.opens = False
    ((_, answer),) = site.announce(Command.STREAM_START)
    assert answer.annunciator_stream_status.stream_status == Status.INITIAL
    assert not site.loudspeaker.hosts


def test_playing_ends_with_control(site):
    site.announce(Command.STREAM_START)
    site.release()
    assert not site.loudspeaker.hosts
    site.tell(RequestControl(100), OTHER)
    assert not site.loudspeaker.hosts


def test_unknown_loudspeakers_and_commands_are_counted(site):
    ((_, answer),) = site.announce(Command.STREAM_START, number=1)
    assert answer.annunciator_stream_status.stream_status == Status.INITIAL
    assert site.count("announcement_refused") == 1
    site.announce(99)
    assert site.count("stream_refused") == 1
    assert not site.ask(QueryAnnunciatorEndpoint(9)).annunciator_endpoint_list
    assert len(site.ask(QueryAnnunciatorCapabilities(0)).annunciator_capability_list) == 1


def test_queries_for_the_port_that_wait_are_few(site):
    waiting = []
    site.loudspeaker.listen = lambda _, then: waiting.append(then)
    for _ in range(100):
        assert len(site.tell(QueryAnnunciatorEndpoint(0))) <= 1
    assert len(waiting) == 32
    for then in waiting:
        then(("203.0.113.1", 7000))
    ((_, _, answer),) = site.rig.run(0.0)
    assert answer.annunciator_endpoint_list[0].endpoint_rec.port == 7000


# --- IOP: the loudspeaker


def source(site):
    (item,) = site.ask(QueryDigitalAudioStreamSource(0)).digital_audio_stream_source_list
    return item.sensor_id, item.stream_url


def test_stream_of_the_own_machine_is_played_from_its_port_only(site):
    site.play("rtp://192.0.2.42:5004")
    assert (site.loudspeaker.hosts, site.loudspeaker.port) == ({"192.0.2.42"}, 5004)
    assert source(site) == (2, "rtp://192.0.2.42:5004")
    site.play("")
    assert source(site) == (2, "")
    assert not site.loudspeaker.hosts


@pytest.mark.parametrize(
    "url",
    [f"rtp://{FOREIGN}:5004", "rtsp://192.0.2.42:554/x", "file:///etc/passwd", "rtp://[::1]:5004", "rtp://x" * 30],
)
def test_other_streams_are_refused(site, url):
    site.play("rtp://192.0.2.42:5004")
    site.play(url)
    assert not site.loudspeaker.hosts
    assert source(site) == (2, "")
    assert site.count("announcement_refused") == 1


def test_stream_of_iop_ends_with_control(site):
    site.play("rtp://192.0.2.42:5004")
    site.release()
    assert not site.loudspeaker.hosts
    assert source(site) == (2, "")
    site.play("rtp://192.0.2.43:5004", client=OTHER)
    assert not site.loudspeaker.hosts
    site.tell(RequestControl(100))
    site.play("rtp://192.0.2.42:5004", number=1)
    assert site.count("announcement_refused") == 1
