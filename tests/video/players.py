"""Players that know nothing of jauspy, and write grey pictures to their standard output."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

from jauspy.platform.video_settings import VideoSettings
from jauspy.video.rtp import ffmpeg_source, gstreamer_source, session_description


def ffmpeg(folder: Path, port: int, _: VideoSettings) -> list[str]:
    sdp = folder / "stream.sdp"
    sdp.write_text(session_description("test", "127.0.0.1", port), newline="")
    source = ["ffmpeg", "-nostdin", "-loglevel", "warning", *ffmpeg_source(sdp)]
    return [*source, "-fps_mode", "passthrough", "-enc_time_base", "1:90000", "-f", "rawvideo", "-pix_fmt", "gray", "-"]


def gstreamer(_: Path, port: int, settings: VideoSettings) -> list[str]:
    raw = f"! videoconvert ! video/x-raw,format=GRAY8,width={settings.width},height={settings.height} ! fdsink fd=1"
    return ["gst-launch-1.0", "-q", *gstreamer_source(port), *raw.split()]


PLAYERS = [ffmpeg, gstreamer]


@cache
def know_plugins(gstreamer: str) -> None:
    """The first time that a user starts GStreamer it looks at all plugins, and complains about some."""
    command = [gstreamer, "-q", "fakesrc", "num-buffers=1", "!", "fakesink"]
    subprocess.run(command, check=True, capture_output=True, timeout=120)


@contextmanager
def playing(command: list[str], port: int, complaints: Path) -> Iterator[subprocess.Popen[bytes]]:
    """The player, once it listens; what it has to say goes to the file, warnings of its decoder, too."""
    if command[0].startswith("gst"):
        know_plugins(command[0])
    loud = {**os.environ, "GST_DEBUG": "2", "GST_DEBUG_NO_COLOR": "1"}
    with (
        complaints.open("wb") as errors,
        subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, env=loud) as player,
    ):
        try:
            deadline = time.monotonic() + 20.0
            while f":{port:04X} " not in Path("/proc/net/udp").read_text():
                assert player.poll() is None, complaints.read_text()
                assert time.monotonic() < deadline, "the player does not listen"
                time.sleep(0.02)
            yield player
        finally:
            player.kill()
