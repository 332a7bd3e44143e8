"""ffmpeg and GStreamer, which know nothing of jauspy, decode what is sent."""

from __future__ import annotations

import shutil
import subprocess
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import pytest

pytest.importorskip("av", reason="the extra 'video' is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

import numpy as np

from jauspy.platform.h264 import H264Settings, Preset, Profile
from jauspy.platform.video_settings import VideoSettings
from jauspy.video.encoder import H264Encoder
from jauspy.video.receiver import RtpReceiver
from jauspy.video.sdp import session
from jauspy.video.sender import RtpSender
from jauspy.video.stamp import read

RATE = 15
PICTURES = 3 * RATE
STREAMS = {
    "640x480": VideoSettings(640, 480, RATE),
    "1280x720": VideoSettings(1280, 720, RATE),
    "main": VideoSettings(coding=H264Settings(Profile.MAIN, preset=Preset.SLOW_COMMS), rate=RATE),
    "high": VideoSettings(coding=H264Settings(Profile.HIGH, level=9), rate=RATE),
    "gradual": VideoSettings(coding=H264Settings(gradual=True), rate=RATE),
}


def ffmpeg(folder: Path, port: int, _: VideoSettings) -> list[str]:
    sdp = folder / "stream.sdp"
    sdp.write_text(session("test", "127.0.0.1", port), newline="")
    quick = ["-nostdin", "-loglevel", "error", "-fflags", "nobuffer", "-flags", "low_delay"]
    source = ["-protocol_whitelist", "file,udp,rtp", "-i", str(sdp)]
    return [
        "ffmpeg",
        *quick,
        *source,
        "-fps_mode",
        "passthrough",
        "-enc_time_base",
        "1:90000",
        "-f",
        "rawvideo",
        "-pix_fmt",
        "gray",
        "-",
    ]


def gstreamer(_: Path, port: int, settings: VideoSettings) -> list[str]:
    caps = "application/x-rtp,media=video,clock-rate=90000,encoding-name=H264,payload=96"
    raw = f"video/x-raw,format=GRAY8,width={settings.width},height={settings.height}"
    source = ["udpsrc", f"port={port}", f"caps={caps}"]
    stages = [["rtpjitterbuffer"], ["rtph264depay"], ["avdec_h264"], ["videoconvert"], [raw], ["fdsink", "fd=1"]]
    return ["gst-launch-1.0", "-q", *source, *(word for stage in stages for word in ("!", *stage))]


@contextmanager
def playing(command: list[str], port: int):
    """The player, once it listens."""
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as player:
        try:
            deadline = time.monotonic() + 20.0
            while f":{port:04X} " not in Path("/proc/net/udp").read_text():
                assert player.poll() is None, player.stderr.read().decode()
                assert time.monotonic() < deadline, "the player does not listen"
                time.sleep(0.02)
            yield player
        finally:
            player.kill()


def show(sender: RtpSender, settings: VideoSettings, scene, ending: threading.Event) -> None:
    encoder, number = H264Encoder(settings), 0
    images = [scene(n, settings.width, settings.height) for n in range(PICTURES)]
    start = time.monotonic()
    while not ending.wait(max(0.0, start + number / RATE - time.monotonic())):
        now = time.monotonic()
        nals = encoder.encode(images[number % PICTURES], idr=sender.needs_idr(now))
        sender.send(nals, now, time.time())
        number += 1


@pytest.mark.parametrize("player", [ffmpeg, gstreamer], ids=lambda player: player.__name__)
@pytest.mark.parametrize("settings", STREAMS.values(), ids=STREAMS)
def test_every_picture_arrives_without_an_error(player, settings, scene, tmp_path):
    if shutil.which(player(tmp_path, 1, VideoSettings())[0]) is None:
        pytest.skip(f"{player.__name__} is not installed")
    with RtpReceiver() as free:
        port = free.port
    ending = threading.Event()
    with RtpSender() as sender, playing(player(tmp_path, port, settings), port) as process:
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
        complaints = process.stderr.read().decode()
    images = [np.frombuffer(data, np.uint8).reshape(settings.height, settings.width) for data in seen]
    first = read(images[0])[0]
    assert [read(image)[0] for image in images] == [(first + n) % PICTURES for n in range(PICTURES)]
    assert not sender.counters["dropped"]
    assert complaints == ""
