"""2 % of the packets are lost on the way: nobody ends, and from a whole IDR to the next loss all is right."""

from __future__ import annotations

import random
import shutil
import socket
import threading
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import numpy as np

from jauspy.platform.video_settings import VideoSettings
from jauspy.video import h264_payload
from jauspy.video.h264 import H264Decoder, H264Encoder
from jauspy.video.h264_payload import Picture
from jauspy.video.imaging import read_numbers
from jauspy.video.receiver import RtpReceiver
from jauspy.video.rtp import RtpPacket
from jauspy.video.sender import RtpSender

from .players import ffmpeg, gstreamer, playing

SETTINGS = VideoSettings(320, 240, rate=30, gop=15, bit_rate=1_000_000)
PICTURES = 180
LOSS = 0.02
LIKE = 0.99
"""Correlation of a picture with what a decoder shows that loses nothing, at least; players differ in what is black."""

LUMA = np.array((0.299, 0.587, 0.114))
"""Red, green and blue to grey (BT.601)."""
QUIET = 1.0
"""Seconds without a picture after which the last has been seen."""


class Relay:
    """Stands between sender and receiver, and drops packets by a seed. It tells which pictures arrived in full."""

    def __init__(self, port: int, seed: int) -> None:
        self._chance = random.Random(seed)
        self.port = port
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
        self._socket.bind(("127.0.0.1", 0))
        self._ending = threading.Event()
        self.lost: dict[int, int] = defaultdict(int)
        """Packets lost of each picture, by its RTP time stamp, in the order in which they were sent."""

    @property
    def address(self) -> tuple[str, int]:
        return "127.0.0.1", int(self._socket.getsockname()[1])

    def run(self) -> None:
        self._socket.settimeout(0.05)
        while not self._ending.is_set():
            try:
                datagram = self._socket.recv(65536)
            except TimeoutError:
                continue
            drop = self._chance.random() < LOSS
            self.lost[RtpPacket.decode(datagram).timestamp] += drop
            if not drop:
                self._socket.sendto(datagram, ("127.0.0.1", self.port))

    @contextmanager
    def running(self) -> Iterator[None]:
        thread = threading.Thread(target=self.run)
        thread.start()
        try:
            yield
        finally:
            self._ending.set()
            thread.join()
            self._socket.close()


class Film:
    """What is sent, encoded beforehand, and what a receiver sees that loses nothing."""

    def __init__(self, scene: Callable[..., np.ndarray]) -> None:
        encoder, decoder = H264Encoder(SETTINGS), H264Decoder()
        self.pictures = [encoder.encode(scene(n, SETTINGS.width, SETTINGS.height)) for n in range(PICTURES)]
        self.idrs = {
            n
            for n, nals in enumerate(self.pictures)
            if any(h264_payload.nal_type(unit) == h264_payload.IDR for unit in nals)
        }
        whole = (Picture(n, tuple(nals), whole=True) for n, nals in enumerate(self.pictures))
        self.true = [decoder.decode(picture) @ LUMA for picture in whole]

    def show(self, to: tuple[str, int]) -> None:
        start = time.monotonic()
        with RtpSender() as sender:
            sender.add(to)
            for number, nals in enumerate(self.pictures):
                time.sleep(max(0.0, start + number / SETTINGS.rate - time.monotonic()))
                sender.send(nals, number / SETTINGS.rate, 1e9 + number)

    def right(self, seen: list[np.ndarray]) -> set[int]:
        """The numbers of those that were seen as they are."""
        pairs = ((read_numbers(image)[0], image) for image in seen)
        return {n for n, image in pairs if n < PICTURES and _alike(image, self.true[n]) > LIKE}


def _alike(one: np.ndarray, other: np.ndarray) -> float:
    return float(np.corrcoef(one.ravel(), other.ravel())[0, 1])


@pytest.fixture
def film(scene: Callable[..., np.ndarray]) -> Film:
    return Film(scene)


def sound(lost: list[int], idrs: set[int]) -> set[int]:
    """Pictures that a receiver can show as they are: from an IDR on, as long as nothing is lost."""
    found, whole = set(), False
    for number, count in enumerate(lost):
        whole = not count and (whole or number in idrs)
        found |= {number} if whole else set()
    return found


def free_port() -> int:
    with RtpReceiver() as free:
        return free.port


@pytest.mark.slow
@pytest.mark.parametrize(
    "player",
    [
        pytest.param(None, id="jauspy"),
        pytest.param(ffmpeg, id="ffmpeg", marks=pytest.mark.slow),
        pytest.param(gstreamer, id="gstreamer", marks=pytest.mark.slow),
    ],
)
def test_decoding_recovers_with_the_next_idr(player, film, tmp_path):
    port = free_port()
    relay = Relay(port, seed=7)
    with relay.running():
        seen = (
            ours(port, relay, film)
            if player is None
            else theirs(player(tmp_path, port, SETTINGS), relay, film, tmp_path / "complaints")
        )
    lost = list(relay.lost.values())
    assert len(lost) == PICTURES
    first = 2 * SETTINGS.gop  # a player that looks at the stream before it plays begins late
    good = {number for number in sound(lost, film.idrs) if number >= first}
    assert any(lost[min(good) : max(good)]), "there was nothing to recover from"
    assert len(good & film.right(seen)) > 0.95 * len(good)


def ours(port: int, relay: Relay, film: Film) -> list[np.ndarray]:
    seen: list[np.ndarray] = []
    ending = threading.Event()

    def pull() -> None:
        decoder = H264Decoder()
        while not ending.wait(0.001):
            images = [decoder.decode(picture) for picture in receiver.take()]
            seen.extend(image @ LUMA for image in images if image is not None)

    with RtpReceiver(port=port) as receiver:
        thread = threading.Thread(target=pull)
        thread.start()
        film.show(relay.address)
        until_the_last(seen)
        ending.set()
        thread.join()
    return seen


def until_the_last(seen: list[np.ndarray]) -> None:
    deadline, count = time.monotonic() + 20.0, -1
    while len(seen) != count and time.monotonic() < deadline:
        count = len(seen)
        time.sleep(QUIET)


def theirs(command: list[str], relay: Relay, film: Film, complaints: Path) -> list[np.ndarray]:
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not installed")
    seen: list[np.ndarray] = []
    area = SETTINGS.width * SETTINGS.height

    def pull() -> None:
        while len(data := process.stdout.read(area)) == area:
            seen.append(np.frombuffer(data, np.uint8).reshape(SETTINGS.height, SETTINGS.width))

    with playing(command, relay.port, complaints) as process:
        thread = threading.Thread(target=pull)
        thread.start()
        film.show(relay.address)
        until_the_last(seen)
        assert process.poll() is None, "it ended"
        process.kill()
        thread.join()
    return seen
