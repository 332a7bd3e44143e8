from __future__ import annotations

import random
import select
import struct
import sys

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

from jauspy import video as extra
from jauspy.errors import ConfigError, TransportError
from jauspy.platform.video_settings import VideoSettings
from jauspy.video import rtp
from jauspy.video.h264 import H264Decoder, H264Encoder
from jauspy.video.imaging import read_numbers
from jauspy.video.receiver import SOURCE_TIMEOUT, RtpReceiver
from jauspy.video.recorder import Recorder
from jauspy.video.sender import MAX_RECEIVERS, MIN_IDR_INTERVAL, RtpSender

RATE = 15


class Show:
    """Encodes and sends a scene, one picture after the other."""

    def __init__(self, scene, sender):
        self.encoder, self.sender, self.scene = H264Encoder(VideoSettings(320, 240, RATE, gop=200)), sender, scene
        self.number = 0

    def go_on(self, pictures=1):
        for _ in range(pictures):
            now = self.number / RATE
            nals = self.encoder.encode(self.scene(self.number, 320, 240), idr=self.sender.needs_idr(now))
            self.sender.send(nals, now, 1e9 + now)
            self.number += 1


def take(receiver, count):
    """The next pictures, when they are there."""
    found = []
    while len(found) < count:
        assert select.select([receiver], [], [], 20.0)[0], f"only {len(found)} of {count} pictures came"
        found += receiver.take()
    assert len(found) == count
    return found


def numbers(decoder, pictures):
    return [read_numbers(decoder.decode(picture))[0] for picture in pictures]


@pytest.fixture
def sender():
    with RtpSender("front") as made:
        yield made


@pytest.fixture
def receivers():
    with RtpReceiver() as one, RtpReceiver() as two:
        yield one, two


def at(receiver):
    return ("127.0.0.1", receiver.port)


def test_receivers_share_an_encoder_and_start_with_an_idr(scene, sender, receivers):
    show, (one, two) = Show(scene, sender), receivers
    sender.add(at(one))
    show.go_on(3)
    sender.add(at(two))
    show.go_on(3)
    first, second = take(one, 6), take(two, 3)
    assert numbers(H264Decoder(), first) == [0, 1, 2, 3, 4, 5]
    assert numbers(H264Decoder(), second) == [3, 4, 5]
    assert [picture.is_idr for picture in first] == [True, False, False, True, False, False]


def test_paused_receiver_continues_with_an_idr_without_gap(scene, sender, receivers):
    show, (one, two) = Show(scene, sender), receivers
    sender.add(at(one))
    sender.add(at(two))
    show.go_on(2)
    sender.pause(at(two))
    show.go_on(2)
    sender.play(at(two))
    show.go_on(2)
    assert numbers(H264Decoder(), take(one, 6)) == [0, 1, 2, 3, 4, 5]
    assert numbers(H264Decoder(), take(two, 4)) == [0, 1, 4, 5]
    assert not two.counters.get("lost")


def test_removed_receiver_gets_nothing(scene, sender, receivers):
    show, (one, two) = Show(scene, sender), receivers
    sender.add(at(one))
    sender.add(at(two))
    show.go_on()
    sender.remove(at(two))
    show.go_on()
    assert len(take(one, 2)) == 2
    assert len(take(two, 1)) == 1
    assert sender.receivers == [at(one)]
    sender.remove(at(one))
    assert not sender.playing


def test_receiver_requests_an_idr_after_a_loss(scene, sender, receivers):
    show, (receiver, _) = Show(scene, sender), receivers
    sender.add(at(receiver))
    show.go_on(2)
    take(receiver, 2)
    sender._receivers[at(receiver)].stream._sequence += 1  # as if a packet had been lost
    show.go_on()
    assert [picture.whole for picture in take(receiver, 1)] == [False]
    show.go_on(RATE)
    assert receiver.counters["asked"] == 1
    assert sum(picture.is_idr for picture in take(receiver, RATE)) == 1


def test_idr_requests_are_rate_limited(sender, receivers):
    receiver, _ = receivers
    sender.add(at(receiver))
    sender.send([b"\x67\x01", b"\x65\x01"], 10.0, 1e9)
    sender._asked = True
    assert not sender.needs_idr(10.0 + MIN_IDR_INTERVAL / 2)
    assert sender.needs_idr(10.0 + MIN_IDR_INTERVAL)


def test_sender_report_maps_time_stamps(sender):
    sender.close()
    report = rtp.sender_report(7, "front", utc=1.5, timestamp=90, packets=3, octets=400)
    first = struct.unpack_from("!BBHIIIIII", report)
    assert first == (0x80, 200, 6, 7, 2_208_988_801, 1 << 31, 90, 3, 400)
    assert report[28:30] == b"\x81\xca"
    assert len(report) % 4 == 0
    assert not rtp.requests_picture(report)
    assert rtp.requests_picture(report + rtp.picture_loss_indication(1, 7))
    assert not rtp.requests_picture(report + rtp.picture_loss_indication(1, 7)[:8])


def test_receivers_are_bounded_and_addresses_numeric(sender):
    for port in range(2000, 2000 + 2 * MAX_RECEIVERS, 2):
        sender.add(("127.0.0.1", port))
    sender.add(("127.0.0.1", 2000))
    with pytest.raises(ConfigError, match="8 receivers watch front already"):
        sender.add(("127.0.0.1", 4000))
    with pytest.raises(ConfigError, match="'localhost' is not an IP address"):
        RtpSender().add(("localhost", 4000))
    with pytest.raises(ConfigError, match="port 0"):
        RtpSender().add(("127.0.0.1", 0))


def test_missing_listener_is_no_error(scene, sender, receivers):
    receiver, other = receivers
    sender.add(at(other))
    other.close()
    sender.add(at(receiver))
    Show(scene, sender).go_on(5)
    assert len(take(receiver, 5)) == 5


def test_port_in_use_is_an_error(receivers):
    with pytest.raises(TransportError, match=f"cannot listen at 127.0.0.1 port {receivers[0].port}"):
        RtpReceiver(port=receivers[0].port)


@pytest.mark.slow
def test_picture_is_correct_after_the_next_idr(scene):
    """2 % of the packets are lost; pictures from a whole IDR up to the next loss are what was sent."""
    from jauspy.video.h264_payload import Depacketiser, packetise
    from jauspy.video.rtp import RtpPacket
    from jauspy.video.sender import RtpStream

    chance, encoder = random.Random(5), H264Encoder(VideoSettings(gop=10))
    stream, receiver, decoder = RtpStream("lossy"), Depacketiser(), H264Decoder()
    sound, checked, idrs = False, 0, 0
    for number in range(150):
        packed = packetise(encoder.encode(scene(number)))
        sent = stream.packets(packed, idr=number == 0, now=number / RATE)
        arrived = [data for data in sent if chance.random() >= 0.02]
        before = receiver.counters["lost"]
        pictures = [picture for data in arrived for picture in receiver.feed(RtpPacket.decode(data))]
        for picture in pictures:
            image = decoder.decode(picture)
            whole = picture.whole and receiver.counters["lost"] == before
            sound = whole and (sound or picture.is_idr)
            idrs += picture.is_idr and not whole
            if sound:
                assert read_numbers(image) == [number]
                assert abs(image.astype(int) - scene(number)).mean() < 12.0
                checked += 1
    assert receiver.counters["damaged"] > 5
    assert idrs > 0
    assert checked > 30


def test_recording_has_all_pictures_at_their_times(scene, sender, receivers, tmp_path):
    import av

    receiver, _ = receivers
    show = Show(scene, sender)
    sender.add(at(receiver))
    show.go_on(20)
    with Recorder(tmp_path / "front.mp4") as recorder:
        for picture in take(receiver, 20):
            recorder.add(picture)
    assert recorder.pictures == 20
    with av.open(str(tmp_path / "front.mp4")) as film:
        frames = list(film.decode(video=0))
    assert [read_numbers(frame.to_ndarray(format="rgb24"))[0] for frame in frames] == list(range(20))
    assert [round(frame.time * RATE) for frame in frames] == list(range(20))


def test_recording_ends_when_the_size_changes(scene, sender, receivers, tmp_path):
    receiver, _ = receivers
    show = Show(scene, sender)
    sender.add(at(receiver))
    show.go_on(2)
    show.encoder.settings = VideoSettings(640, 480)
    sender.send(show.encoder.encode(scene(2)), 2 / RATE, 1e9)
    with Recorder(tmp_path / "front.mkv") as recorder:
        for picture in take(receiver, 3):
            recorder.add(picture)
        assert recorder.ended
        assert recorder.pictures == 2


def test_recording_continues_after_a_camera_restart(scene, sender, tmp_path):
    """Another process, with another source and another clock, is no gap of hours."""
    import av

    now = 0.0
    with (
        RtpReceiver(clock=lambda: now) as receiver,
        RtpSender("anew") as anew,
        Recorder(tmp_path / "front.mp4") as recorder,
    ):
        sender.add(at(receiver))
        Show(scene, sender).go_on(3)
        pictures = take(receiver, 3)
        now = SOURCE_TIMEOUT
        anew.add(at(receiver))
        Show(scene, anew).go_on(3)
        for picture in pictures + take(receiver, 3):
            recorder.add(picture)
    with av.open(str(tmp_path / "front.mp4")) as film:
        times = [float(frame.time) for frame in film.decode(video=0)]
    expected = [0, 1 / RATE, 2 / RATE, 2 / RATE + 0.1, 3 / RATE + 0.1, 4 / RATE + 0.1]
    assert times == pytest.approx(expected, abs=0.001)


def test_unwritable_recording_is_an_error(tmp_path):
    with pytest.raises(ConfigError, match=r"cannot record to .*film\.xyz"):
        Recorder(tmp_path / "film.xyz")


def test_a_missing_package_names_the_extra(monkeypatch):
    monkeypatch.setattr(extra, "PACKAGES", {"no_such_package": "PyAV"})
    with pytest.raises(ConfigError, match=r"video needs PyAV: pip install 'jauspy\[video\]'"):
        extra.need_video()
    assert "no_such_package" not in sys.modules
