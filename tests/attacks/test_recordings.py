"""Somebody sends packets to the port of a recording; the recording program is killed, or the disk is full."""

from __future__ import annotations

import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import av
import numpy as np

from jauspy.errors import ConfigError
from jauspy.platform.video_settings import VideoSettings
from jauspy.video.h264 import H264Encoder
from jauspy.video.h264_payload import Picture, packetise
from jauspy.video.imaging import draw_numbers, read_numbers
from jauspy.video.receiver import MAX_CANDIDATES, MAX_DATAGRAMS, RtpReceiver
from jauspy.video.recorder import Recorder
from jauspy.video.rtp import RtpPacket, sender_report
from jauspy.video.sender import RtpSender

RATE = 15
PICTURES = 60
SPS, PPS = b"\x67\x42\xc0\x1e\xd9\x00\xa0\x47\xfe\x88", b"\x68\xce\x38\x80"


def scene(number: int, width: int, height: int) -> np.ndarray:
    """Noise that moves, and carries its number."""
    noise = np.random.default_rng(7).integers(0, 255, (height, width, 3), dtype=np.uint8)
    image = np.roll(noise, 3 * number, axis=1)
    draw_numbers(image, number)
    return image


class Recording:
    """A camera and a recorder on virtual time, and what an attacker sends in between."""

    def __init__(self, film: Path) -> None:
        self.now = 0.0
        self.receiver = RtpReceiver(clock=lambda: self.now)
        self.sender, self.attacker = RtpSender("front"), socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.film, self.recorder = film, Recorder(film)
        self.encoder = H264Encoder(VideoSettings(320, 240, RATE, gop=200))

    def attack(self, *packets: RtpPacket) -> None:
        for packet in packets:
            self.attacker.sendto(packet.encode(), ("127.0.0.1", self.receiver.port))
        self.take()

    def take(self) -> None:
        for picture in self.receiver.take():
            self.recorder.add(picture)

    def record(self, meanwhile: Callable[[int], None] = lambda number: None) -> list:
        """Record all pictures; what the film shows then."""
        self.sender.add(("127.0.0.1", self.receiver.port))
        for number in range(PICTURES):
            self.now += 1.0 / RATE
            nals = self.encoder.encode(scene(number, 320, 240), idr=self.sender.needs_idr(self.now))
            self.sender.send(nals, self.now, 1e9 + self.now)
            meanwhile(number)
            self.take()
        self.recorder.close()
        with av.open(str(self.film)) as film:
            return [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]

    def close(self) -> None:
        self.receiver.close()
        self.sender.close()
        self.attacker.close()


@pytest.fixture
def recording(tmp_path: Path) -> Iterator[Recording]:
    made = Recording(tmp_path / "front.mp4")
    yield made
    made.close()


def numbers(images: list) -> list[int]:
    return [read_numbers(image)[0] for image in images]


@pytest.mark.slow
@pytest.mark.parametrize(
    "nals",
    [[b"\x41" + bytes(100)], [b"\x65" + bytes(100)], [SPS, PPS, b"\x65\x88\x84" + bytes(100)]],
    ids=["slice", "IDR", "IDR with parameter sets"],
)
def test_a_stray_packet_before_the_stream(recording: Recording, nals: list[bytes]) -> None:
    (payload,) = packetise(nals)
    recording.attack(RtpPacket(7, 0, 0xBAD, payload, marker=True))
    recording.now += 0.2
    assert numbers(recording.record()) == list(range(PICTURES))


@pytest.mark.slow
def test_another_ssrc_between_the_packets(recording: Recording) -> None:
    """From the first picture on, of one more source each time, with other parameter sets and reports."""
    attacker = H264Encoder(VideoSettings(640, 480, RATE))
    payloads = packetise(attacker.encode(scene(0, 640, 480), idr=True))

    def attack(number: int) -> None:
        last = len(payloads) - 1
        made = (RtpPacket(n, number, 0xBAD + number, payload, marker=n == last) for n, payload in enumerate(payloads))
        for packet in made:
            recording.attacker.sendto(packet.encode(), ("127.0.0.1", recording.receiver.port))
        report = sender_report(0xBAD, "evil", utc=0.0, timestamp=0, packets=1, octets=1)
        recording.attacker.sendto(report, ("127.0.0.1", recording.receiver.port + 1))

    assert numbers(recording.record(attack)) == list(range(PICTURES))
    counters = recording.receiver.counters
    assert counters["foreign"] >= PICTURES * len(payloads)
    assert not counters.get("lost")
    assert recording.receiver.taken(Picture(0, (), whole=True)) != 0.0


def test_many_sources_need_little_memory(recording: Recording) -> None:
    part = bytes([0x65]) + bytes(1000)
    for first in range(0, 4 * MAX_DATAGRAMS, 100):
        recording.attack(*(RtpPacket(0, 0, n, part) for n in range(first, first + 100)))
    assert len(recording.receiver._candidates) == MAX_CANDIDATES


RECORD = f"""
import os, resource, sys
from pathlib import Path
sys.path.insert(0, {str(Path(__file__).parents[2])!r})
from tests.attacks.test_recordings import pictures
from jauspy.errors import ConfigError
from jauspy.video.recorder import Recorder

if sys.argv[2] == "full":
    resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))
recorder = Recorder(Path(sys.argv[1]))
for picture in pictures():
    recorder.add(picture)
    if recorder.ended:
        print(recorder.pictures)
        try:
            recorder.close()
        except ConfigError as error:
            print(error)
        sys.exit()
os.kill(os.getpid(), 9)
"""


def pictures() -> Iterator[Picture]:
    """Four seconds."""
    encoder = H264Encoder(VideoSettings(320, 240, RATE))
    for number in range(PICTURES):
        nals = encoder.encode(scene(number, 320, 240))
        yield Picture(number * 90_000 // RATE, tuple(nals), whole=True, source=7)


def record(film: Path, how: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", RECORD, str(film), how]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)


def frames(film: Path) -> int:
    with av.open(str(film)) as opened:
        return sum(1 for _ in opened.decode(video=0))


@pytest.mark.slow
@pytest.mark.parametrize("suffix", [".mp4", ".mkv"])
def test_a_recording_can_be_read_when_its_program_was_killed(tmp_path: Path, suffix: str) -> None:
    film = tmp_path / f"front{suffix}"
    assert record(film, "kill").returncode == -signal.SIGKILL
    assert frames(film) >= PICTURES - RATE


@pytest.mark.slow
def test_a_full_disk_is_reported_at_once_and_what_was_recorded_can_be_read(tmp_path: Path) -> None:
    film = tmp_path / "front.mp4"
    done = record(film, "full")
    recorded, reported = done.stdout.splitlines()
    assert (
        reported
        == f"cannot write {film}: File too large; what was recorded before can be read, but for the last second"
    )
    assert film.stat().st_size <= 100_000
    assert int(recorded) - RATE <= frames(film) < PICTURES


def test_a_full_disk_from_the_beginning(tmp_path: Path) -> None:
    film = tmp_path / "front.mp4"
    film.symlink_to("/dev/full")
    recorder = Recorder(film)
    recorder.add(next(pictures()))
    assert recorder.ended
    with pytest.raises(ConfigError, match=f"cannot write {film}: No space left on device"):
        recorder.close()
    recorder.close()
