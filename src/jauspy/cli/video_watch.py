"""What `jauspy video` does: enters where the video is to go, and keeps it there; helps players; records."""

from __future__ import annotations

import asyncio
import os
import shlex
import shutil
import subprocess
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Final

from jauspy.cli import console
from jauspy.errors import ConfigError, RequestError
from jauspy.ids import JausID
from jauspy.messages.environment_sensing import (
    ConfirmDigitalResourceEndpoint as Confirm,
    RegisterDigitalResourceEndpoint as Register,
    RemoveDigitalResourceEndpoint as Remove,
)
from jauspy.ocu import OCU
from jauspy.services.environment_sensing.digital_resource_discovery import RTP
from jauspy.video.rtp import ffmpeg_source, gstreamer_source, session_description

AGAIN: Final = 60.0
"""Seconds between two entries; the robot forgets after five minutes."""

START: Final = 20.0
"""Seconds in which the first picture comes; a camera that nobody watched has to be started."""


def url_of(address: tuple[str, int]) -> str:
    """The end point, as the robot wants it."""
    host = f"[{address[0]}]" if ":" in address[0] else address[0]
    return f"rtp://{host}:{address[1]}"


async def enter(ocu: OCU, camera: JausID, sensor: int, url: str) -> int:
    """Have the video sent there; the number of the end point."""
    record = Register.DigitalResourceEndpointRec(RTP, url, None, sensor)
    answer = await ocu.query(camera, Register(Register.RequestIDRec(1), record), expects=Confirm)
    if not answer.id:
        raise RequestError(
            f"{camera} does not send sensor {sensor} to {url}: there may be no such sensor, no room, or no extra "
            "'video' at the robot, whose log tells"
        )
    return answer.id


@asynccontextmanager
async def entered(ocu: OCU, camera: JausID, sensor: int, url: str) -> AsyncIterator[None]:
    """The video is sent there as long as this lasts."""
    robot = await ocu.discover(camera.subsystem)
    robot.component(str(camera)).service("DigitalResourceDiscovery")
    number = await enter(ocu, camera, sensor, url)
    keeping = asyncio.create_task(_keep(ocu, camera, sensor, url))
    try:
        yield
    finally:
        keeping.cancel()
        with suppress(RequestError):  # one that is gone sends nothing any more
            await ocu.query(camera, Remove(number, 2), expects=Confirm)


async def watch(ocu: OCU, camera: JausID, sensor: int, address: tuple[str, int], seconds: float | None) -> None:
    """Keep the video coming."""
    async with ocu, entered(ocu, camera, sensor, url_of(address)):
        print(f"{camera} sends to {url_of(address)}; Ctrl-C ends it", flush=True)
        await _sleep(seconds)


async def record(
    ocu: OCU, camera: JausID, sensor: int, address: tuple[str, int], *, file: Path, seconds: float | None
) -> None:
    """Write the video to a film; ends when the size of the pictures changes, too."""
    from jauspy.video import need_video

    need_video()
    from jauspy.video.receiver import RtpReceiver
    from jauspy.video.recorder import Recorder

    loop = asyncio.get_running_loop()
    begun, ended = asyncio.Event(), asyncio.Event()
    with RtpReceiver(*address) as receiver, Recorder(file) as recorder:

        def take() -> None:
            for picture in receiver.take():
                recorder.add(picture)
                begun.set()
            if recorder.ended:
                ended.set()

        loop.add_reader(receiver.fileno(), take)
        try:
            async with ocu, entered(ocu, camera, sensor, url_of(address)):
                print(f"recording {camera} to {file}; Ctrl-C ends it", flush=True)
                with suppress(TimeoutError):
                    await asyncio.wait_for(begun.wait(), START)
                    await asyncio.wait_for(ended.wait(), seconds)
        finally:
            loop.remove_reader(receiver.fileno())
            pictures, lost = recorder.pictures, receiver.counters.get("lost", 0)
            console.note(f"{pictures} pictures in {file}, {lost} packets were lost")
    if not pictures:
        raise RequestError(
            f"no picture came to {url_of(address)} in {START:g} s: is it an address of this machine that {camera} "
            "reaches?"
        )


def players(file: Path, name: str, address: tuple[str, int], *, show: bool) -> None:
    """Write the SDP, and say how to watch; with `show` open a window, if there is a screen."""
    try:
        file.write_text(session_description(name, *address), newline="")
    except OSError as error:
        raise ConfigError(f"cannot write {file}: {error}; name another file with --sdp") from error
    ffplay = ["ffplay", *ffmpeg_source(file)]
    print(f"wrote {file}; watch it with one of these, best started first (GStreamer shows a picture soonest):")
    print(f"  {shlex.join(ffplay)}")
    print(f"  gst-launch-1.0 {_quoted(gstreamer_source(address[1]))} ! autovideosink sync=false")
    print(f"  vlc --network-caching=100 {shlex.quote(str(file))}", flush=True)
    if show:
        _show(ffplay)


def _quoted(words: list[str]) -> str:
    """For a shell; exclamation marks between spaces need no quotes, and read better without."""
    return " ".join(word if word == "!" else shlex.quote(word) for word in words)


def _show(command: list[str]) -> None:
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        console.note("there is no screen here (neither DISPLAY nor WAYLAND_DISPLAY is set): no window is opened")
    elif shutil.which("ffplay") is None:
        console.note("ffplay is not installed (Debian: apt-get install ffmpeg): no window is opened")
    else:
        subprocess.Popen([*command, "-loglevel", "error"], stdin=subprocess.DEVNULL)  # noqa: S603


async def _keep(ocu: OCU, camera: JausID, sensor: int, url: str) -> None:
    while True:
        await asyncio.sleep(AGAIN)
        try:
            await enter(ocu, camera, sensor, url)
        except RequestError as error:
            console.note(f"{error}; trying again")


async def _sleep(seconds: float | None) -> None:
    if seconds is None:
        await asyncio.Event().wait()
    else:
        await asyncio.sleep(seconds)
