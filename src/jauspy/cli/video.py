"""`jauspy video`: watch or record the video of a camera."""

from __future__ import annotations

import asyncio
import os
import shlex
import shutil
import subprocess
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Connect, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import ConfigError, RequestError
from jauspy.ids import JausID
from jauspy.messages.environment_sensing import (
    ConfirmDigitalResourceEndpoint as Confirm,
    RegisterDigitalResourceEndpoint as Register,
    RemoveDigitalResourceEndpoint as Remove,
)
from jauspy.ocu import OCU
from jauspy.services.environment_sensing.digital_resource_discovery import RTP, parse_rtp_url
from jauspy.video import need_video
from jauspy.video.rtp import ffmpeg_source, gstreamer_source, session_description


def video(
    *,
    camera: Annotated[str, typer.Argument(metavar="ID", help="The component of the camera, as in 101.1.106.")],
    sensor: Annotated[int, typer.Option("--sensor", min=1, max=65535, help="The sensor id of the camera.")] = 1,
    to: Annotated[
        str,
        typer.Option(
            "--to",
            metavar="IP:PORT",
            help="Where the robot sends the video: an address of this machine that the robot can reach.",
        ),
    ] = "127.0.0.1:5004",
    sdp: Annotated[
        Path | None, typer.Option("--sdp", metavar="FILE", help="Description for players.  [default: ID.sdp]")
    ] = None,
    save: Annotated[
        Path | None, typer.Option("--save", metavar="FILE", help="Record to this file, .mp4 or .mkv, without a player.")
    ] = None,
    show: Annotated[bool, typer.Option("--show", help="Open a window with ffplay.")] = False,
    seconds: Annotated[
        float | None,
        typer.Option(
            "--seconds",
            min=0.1,
            help="End after this time, with --save after the first picture. Default: until Ctrl-C.",
        ),
    ] = None,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 2.0,
) -> None:
    """Request the video of a camera, and print commands that show it; or record it.

    The camera sends H.264 in RTP until this command ends. The commands of ffplay, GStreamer and VLC that show the video
    are printed. With --save the stream is recorded without re-encoding.

    Examples:
      jauspy video 101.1.106
      jauspy video 101.1.107 --save front.mp4 --seconds 30
      jauspy video 101.1.106 --to 192.168.1.20:5004 --show
    """
    component = client.destination(camera)
    if component.is_wildcard:
        raise ConfigError(f"{component} has wildcards; name one component")
    if save is not None and show:
        raise typer.BadParameter("it cannot be combined with --save: a port has one receiver", param_hint="--show")
    address = parse_rtp_url(f"rtp://{to}")
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    if save is not None:
        run(record(ocu, component, sensor, address, file=save, seconds=seconds))
        return
    file = sdp or Path(f"{component}.sdp")
    players(file, f"{component} sensor {sensor}", address, show=show)
    run(watch(ocu, component, sensor, address, seconds))


RENEWAL_INTERVAL: Final = 60.0
"""Seconds between two registrations; the robot removes an endpoint after five minutes."""

START_TIMEOUT: Final = 20.0
"""Seconds until the first picture; the camera may have to be started."""


def url_of(address: tuple[str, int]) -> str:
    """The URL of an RTP endpoint."""
    host = f"[{address[0]}]" if ":" in address[0] else address[0]
    return f"rtp://{host}:{address[1]}"


async def register(ocu: OCU, camera: JausID, sensor: int, url: str) -> int:
    """Register an endpoint for the video of a sensor; returns the endpoint's id."""
    record = Register.DigitalResourceEndpointRec(RTP, url, None, sensor)
    answer = await ocu.query(camera, Register(Register.RequestIDRec(1), record), expects=Confirm)
    if not answer.id:
        raise RequestError(
            f"{camera} does not send sensor {sensor} to {url}: is this an address from which the robot hears this "
            "machine, or in its video_targets; is there such a sensor, a free place among the receivers, and the extra "
            "'video' on the robot?"
        )
    return answer.id


@asynccontextmanager
async def registered(ocu: OCU, camera: JausID, sensor: int, url: str) -> AsyncIterator[None]:
    """The video is sent to `url` while this context is open."""
    robot = await ocu.discover(camera.subsystem)
    robot.component(str(camera)).service("DigitalResourceDiscovery")
    number = await register(ocu, camera, sensor, url)
    renewing = asyncio.create_task(_renew(ocu, camera, sensor, url))
    try:
        yield
    finally:
        renewing.cancel()
        with suppress(RequestError):  # a component that is gone sends no video
            await ocu.query(camera, Remove(number, 2), expects=Confirm)


async def watch(ocu: OCU, camera: JausID, sensor: int, address: tuple[str, int], seconds: float | None) -> None:
    """Keep the endpoint registered until the time is up."""
    async with ocu, registered(ocu, camera, sensor, url_of(address)):
        console.print_lines(f"{camera} sends to {url_of(address)}; Ctrl-C ends it")
        await _sleep(seconds)


async def record(
    ocu: OCU, camera: JausID, sensor: int, address: tuple[str, int], *, file: Path, seconds: float | None
) -> None:
    """Record the video; also ends when the size of the pictures changes."""
    need_video()
    from jauspy.video.receiver import RtpReceiver
    from jauspy.video.recorder import Recorder

    loop = asyncio.get_running_loop()
    started, ended = asyncio.Event(), asyncio.Event()
    with RtpReceiver(*address) as receiver, Recorder(file) as recorder:

        def take() -> None:
            for picture in receiver.take():
                recorder.add(picture)
                started.set()
            if recorder.ended:
                ended.set()

        loop.add_reader(receiver.fileno(), take)
        try:
            async with ocu, registered(ocu, camera, sensor, url_of(address)):
                console.print_lines(f"recording {camera} to {file}; Ctrl-C ends it")
                with suppress(TimeoutError):
                    await asyncio.wait_for(started.wait(), START_TIMEOUT)
                    await asyncio.wait_for(ended.wait(), seconds)
        finally:
            loop.remove_reader(receiver.fileno())
            pictures, lost = recorder.pictures, receiver.counters.get("lost", 0)
            console.note(f"{pictures} pictures in {file}, {lost} packets lost")
    if not pictures:
        raise RequestError(
            f"no picture was received at {url_of(address)} in {START_TIMEOUT:g} s: {camera} must be able to reach this "
            "address"
        )


def players(file: Path, name: str, address: tuple[str, int], *, show: bool) -> None:
    """Write the SDP file and print commands for players; with `show` start ffplay if there is a display."""
    try:
        file.write_text(session_description(name, *address), newline="")
    except OSError as error:
        raise ConfigError(f"cannot write {file}: {error}; choose another file with --sdp") from error
    ffplay = ["ffplay", *ffmpeg_source(file)]
    console.print_lines(
        f"wrote {file}; watch the video with one of these commands (GStreamer has the lowest delay):",
        f"  {shlex.join(ffplay)}",
        f"  gst-launch-1.0 {_quoted(gstreamer_source(address[1]))} ! autovideosink sync=false",
        f"  vlc --network-caching=100 {shlex.quote(str(file))}",
    )
    if show:
        _show(ffplay)


def _quoted(words: list[str]) -> str:
    """Words quoted for a shell; a `!` between spaces needs no quotes."""
    return " ".join(word if word == "!" else shlex.quote(word) for word in words)


def _show(command: list[str]) -> None:
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        console.note("no window is opened: there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set)")
    elif shutil.which("ffplay") is None:
        console.note("no window is opened: ffplay is not installed (Debian: apt-get install ffmpeg)")
    else:
        subprocess.Popen([*command, "-loglevel", "error"], stdin=subprocess.DEVNULL)  # noqa: S603


async def _renew(ocu: OCU, camera: JausID, sensor: int, url: str) -> None:
    while True:
        await asyncio.sleep(RENEWAL_INTERVAL)
        try:
            await register(ocu, camera, sensor, url)
        except RequestError as error:
            console.note(f"{error}; trying again")


async def _sleep(seconds: float | None) -> None:
    if seconds is None:
        await asyncio.Event().wait()
    else:
        await asyncio.sleep(seconds)
