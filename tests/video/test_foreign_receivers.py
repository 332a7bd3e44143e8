"""ffmpeg and GStreamer, which know nothing of jauspy, decode what is sent; for longer: `tools/bench/video.py`."""

from __future__ import annotations

import shutil
import threading
import time

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import numpy as np

from jauspy.platform.video_settings import H264Profile, H264Settings, Preset, VideoSettings
from jauspy.video.h264 import H264Encoder
from jauspy.video.imaging import read_numbers
from jauspy.video.receiver import RtpReceiver
from jauspy.video.sender import RtpSender

from .players import PLAYERS, playing

RATE = 15
PICTURES = 3 * RATE
STREAMS = {
    "640x480": VideoSettings(640, 480, RATE),
    "1280x720": VideoSettings(1280, 720, RATE),
    "main": VideoSettings(coding=H264Settings(H264Profile.MAIN, preset=Preset.SLOW_COMMS), rate=RATE),
    "high": VideoSettings(coding=H264Settings(H264Profile.HIGH, level=9), rate=RATE),
    "gradual": VideoSettings(coding=H264Settings(gradual=True), rate=RATE),
}


def show(sender: RtpSender, settings: VideoSettings, scene, ending: threading.Event) -> None:
    encoder, number = H264Encoder(settings), 0
    images = [scene(n, settings.width, settings.height) for n in range(PICTURES)]
    start = time.monotonic()
    while not ending.wait(max(0.0, start + number / RATE - time.monotonic())):
        now = time.monotonic()
        nals = encoder.encode(images[number % PICTURES], idr=sender.needs_idr(now))
        sender.send(nals, now, time.time())
        number += 1


@pytest.mark.slow
@pytest.mark.parametrize("player", PLAYERS, ids=lambda player: player.__name__)
@pytest.mark.parametrize(
    "settings",
    [
        pytest.param(settings, id=name, marks=[] if name in ("640x480", "gradual") else pytest.mark.slow)
        for name, settings in STREAMS.items()
    ],
)
def test_all_pictures_arrive_without_errors(player, settings, scene, tmp_path):
    with RtpReceiver() as free:
        port = free.port
    command, complaints = player(tmp_path, port, settings), tmp_path / "complaints"
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not installed")
    ending = threading.Event()
    with RtpSender() as sender, playing(command, port, complaints) as process:
        sender.add(("127.0.0.1", port))
        showing = threading.Thread(target=show, args=(sender, settings, scene, ending))
        showing.start()
        try:
            area = settings.width * settings.height
            seen = [process.stdout.read(area) for _ in range(PICTURES)]
        finally:
            ending.set()
            showing.join()
        process.kill()  # asked to end, it would wait for a reader of its last pictures
    images = [np.frombuffer(data, np.uint8).reshape(settings.height, settings.width) for data in seen]
    first = read_numbers(images[0])[0]
    assert [read_numbers(image)[0] for image in images] == [(first + n) % PICTURES for n in range(PICTURES)]
    assert not sender.counters["dropped"]
    assert complaints.read_text() == ""
