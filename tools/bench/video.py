"""Video of the whole robot, the cameras of an operator at once, as an ffmpeg, a GStreamer and jauspy itself receive it.

python tools/bench/video.py [--seconds 30] [--sizes 640x480,1280x720] [--rate 15] [--backend sim] [--quality medium]
                            [--cameras arm,chassis]

Each picture carries its number and the time of the state that it shows. From state to decoded pixels is what an
operator waits for, but for the screen. Lost are numbers that were left out between the first and the last picture.
Fewer pictures per second than asked for: the cameras' processes had too little of the processor. `robot time` is what
the robot simulated of the time that passed, these cameras running: 1 is real time. `said` are lines of warnings and
errors of the player and its decoder; the first is printed. ffmpeg's programs decode a picture when the next one begins,
so their delay contains a picture's time (67 ms of 15 pictures per second).
"""

from __future__ import annotations

import argparse
import asyncio
import os
import shutil
import statistics
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from subprocess import PIPE, Popen
from tempfile import TemporaryDirectory

import numpy as np

from jauspy import backends
from jauspy.platform.camera import Quality
from jauspy.platform.video_settings import VideoSettings
from jauspy.robot.config import RobotConfig
from jauspy.robot.realtime import RealTime
from jauspy.robot.robot_files import load, robot_model
from jauspy.video.camera_process import CameraProcess
from jauspy.video.h264 import H264Decoder
from jauspy.video.imaging import read_numbers
from jauspy.video.receiver import RtpReceiver
from jauspy.video.rtp import ffmpeg_source, gstreamer_source, session_description

LOUD = {**os.environ, "GST_DEBUG": "2", "GST_DEBUG_NO_COLOR": "1"}
"""Has GStreamer tell warnings of its decoder."""

WARM_UP = 5.0
"""Seconds until the cameras are open and players have filled their buffers."""

UNCOUNTED = 2.0
"""Seconds of pictures at the beginning that are not counted."""


@dataclass
class Seen:
    """What one receiver saw of one camera."""

    numbers: list[int] = field(default_factory=list)
    delays: list[float] = field(default_factory=list)
    times: list[float] = field(default_factory=list)
    said: list[str] = field(default_factory=list)

    def take(self, image: np.ndarray) -> None:
        """A picture has been decoded now."""
        number, micros = read_numbers(image, rows=2)
        self.numbers.append(number)
        self.times.append(time.monotonic())
        self.delays.append((round(self.times[-1] * 1e6) - micros & 0xFFFFFFFF) / 1e6)

    def line(self, rate: int) -> str:
        """Pictures, how many a second, losses, complaints, and delays in milliseconds."""
        numbers, delays, times = (each[int(UNCOUNTED * rate) :] for each in (self.numbers, self.delays, self.times))
        if len(numbers) < 2:
            return f"{len(self.numbers):9} pictures: too few"
        lost = numbers[-1] - numbers[0] + 1 - len(numbers)
        p95 = sorted(delays)[int(0.95 * len(delays))]
        pace = (len(times) - 1) / (times[-1] - times[0])
        counts = f"{len(numbers):9}{pace:7.1f}{lost:6}{len(self.said):6}"
        return f"{counts}{1e3 * statistics.median(delays):11.0f}{1e3 * p95:8.0f}"


def ffmpeg(folder: Path, port: int, _: VideoSettings) -> list[str]:
    """Decodes to grey pictures on standard output."""
    sdp = folder / f"{port}.sdp"
    sdp.write_text(session_description("bench", "127.0.0.1", port), newline="")
    source = ["ffmpeg", "-nostdin", "-loglevel", "warning", *ffmpeg_source(sdp)]
    raw = ["-f", "rawvideo", "-pix_fmt", "gray", "-threads", "1", "-"]  # with more threads it is one picture late
    return [*source, "-fps_mode", "passthrough", "-enc_time_base", "1:90000", *raw]


def gstreamer(_: Path, port: int, settings: VideoSettings) -> list[str]:
    """Decodes to grey pictures on standard output."""
    raw = f"video/x-raw,format=GRAY8,width={settings.width},height={settings.height}"
    return ["gst-launch-1.0", "-q", *gstreamer_source(port), "!", "videoconvert", "!", raw, "!", "fdsink", "fd=1"]


PLAYERS: dict[str, Callable[[Path, int, VideoSettings], list[str]]] = {"ffmpeg": ffmpeg, "gst-launch-1.0": gstreamer}


@contextmanager
def foreign(player: str, folder: Path, settings: VideoSettings, seen: Seen) -> Iterator[int]:
    """A player that was not written by us; its port."""
    with RtpReceiver() as free:
        port = free.port
    area = settings.width * settings.height

    def pull(process: Popen[bytes]) -> None:
        assert process.stdout is not None
        while len(data := process.stdout.read(area)) == area:
            seen.take(np.frombuffer(data, np.uint8).reshape(settings.height, settings.width))

    complaints = folder / f"{port}.log"
    with (
        complaints.open("wb") as errors,
        Popen(PLAYERS[player](folder, port, settings), stdout=PIPE, stderr=errors, env=LOUD) as process,
    ):
        while f":{port:04X} " not in Path("/proc/net/udp").read_text():
            time.sleep(0.02)
        puller = threading.Thread(target=pull, args=(process,))
        puller.start()
        yield port
        process.kill()
        puller.join()
    seen.said += complaints.read_text().splitlines()


@contextmanager
def own(seen: Seen) -> Iterator[int]:
    """Our receiver; its port."""
    ending = threading.Event()

    def pull(receiver: RtpReceiver) -> None:
        decoder = H264Decoder()
        while not ending.wait(0.001):
            for picture in receiver.take():
                if (image := decoder.decode(picture)) is not None:
                    seen.take(image)

    with RtpReceiver() as receiver:
        puller = threading.Thread(target=pull, args=(receiver,))
        puller.start()
        yield receiver.port
        ending.set()
        puller.join()


async def film(
    config: RobotConfig, ports: Mapping[str, int], settings: VideoSettings, seconds: float
) -> tuple[float, str]:
    """Run the robot and these cameras, each to its port; robot seconds per second, and how pictures were made."""
    robot = backends.find(config.backend).open(robot_model(config), config.world)
    with RealTime(robot) as realtime:
        videos = [CameraProcess(realtime.cameras[name], settings, stamped=True) for name in ports]
        for video, port in zip(videos, ports.values(), strict=True):
            await video.open()
            video.watch(("127.0.0.1", port))
        await asyncio.sleep(WARM_UP)
        begin, start = realtime.snapshot.time, time.monotonic()
        realtime.drive.set_effort(0.0, 0.3)
        await asyncio.sleep(seconds)
        factor = (realtime.snapshot.time - begin) / (time.monotonic() - start)
        for video in videos:
            await video.close()
    robot.close()
    return factor, videos[0].description


def main() -> None:
    """A line for each receiver and camera."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--sizes", default="640x480,1280x720")
    parser.add_argument("--rate", type=int, default=15)
    parser.add_argument("--backend", default="sim")
    parser.add_argument("--quality", type=Quality, default=Quality.MEDIUM)
    parser.add_argument("--cameras", default="arm,chassis", help="which are watched; all of inc1: arm,chassis,outside")
    options = parser.parse_args()
    cameras = options.cameras.split(",")
    config = load("inc1").model_copy(update={"backend": options.backend, "quality": options.quality})
    if unknown := set(cameras) - {camera.name for camera in config.cameras}:
        parser.error(f"inc1 has no camera {', '.join(sorted(unknown))}")
    head = f"{'receiver and camera':36}{'pictures':>9}{'per s':>7}{'lost':>6}{'said':>6}"
    print(f"{head}{'median ms':>11}{'95 %':>8}{'robot time':>12}")
    for size in options.sizes.split(","):
        width, height = map(int, size.split("x"))
        for name in ("jauspy", *PLAYERS):
            if name != "jauspy" and shutil.which(name) is None:
                print(f"{name:36} is not installed")
                continue
            _measure(name, config, cameras, VideoSettings(width, height, options.rate), options.seconds)


def _receiving(name: str, folder: Path, settings: VideoSettings, seen: Seen) -> AbstractContextManager[int]:
    return foreign(name, folder, settings, seen) if name in PLAYERS else own(seen)


def _measure(name: str, config: RobotConfig, cameras: Sequence[str], settings: VideoSettings, seconds: float) -> None:
    seen = {camera: Seen() for camera in cameras}
    with TemporaryDirectory() as folder, ExitStack() as stack:
        ports = {
            camera: stack.enter_context(_receiving(name, Path(folder), settings, each)) for camera, each in seen.items()
        }
        factor, how = asyncio.run(film(config, ports, settings, seconds))
    for camera, each in seen.items():
        title = f"{name}, {camera}, {settings.width}x{settings.height}"
        print(f"{title:36}{each.line(settings.rate)}{factor:12.3f}  {how}", flush=True)
        for line in each.said[:1]:
            print(f"    {line}")


if __name__ == "__main__":
    main()
