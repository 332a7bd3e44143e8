"""`jauspy video`: watch or record the video of a camera."""

from __future__ import annotations

import asyncio
import ipaddress
import os
import shlex
import shutil
import subprocess
from collections.abc import AsyncIterator, Mapping
from contextlib import AsyncExitStack, asynccontextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Connect, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.cli.still import size_of
from jauspy.errors import ConfigError, RequestError, TransportError
from jauspy.ids import JausID
from jauspy.messages.environment_sensing import (
    ConfirmDigitalResourceEndpoint as Confirm,
    RegisterDigitalResourceEndpoint as Register,
    RemoveDigitalResourceEndpoint as Remove,
)
from jauspy.ocu import OCU
from jauspy.ocu.camera import set_stream
from jauspy.platform.video_settings import (
    MAX_BIT_RATE,
    MAX_RATE,
    MIN_BIT_RATE,
    RTP_SERVER_TYPE,
    SUPPORTED_FRAME_SIZES,
    FrameSize,
    frame_size,
)
from jauspy.services.environment_sensing.digital_resource_discovery import parse_rtp_url
from jauspy.video import need_video
from jauspy.video.h264_payload import PPS, SPS, nal_type
from jauspy.video.rtp import ffmpeg_source, gstreamer_source, session_description

if TYPE_CHECKING:
    from jauspy.video.receiver import RtpReceiver


def video(
    *,
    camera: Annotated[str, typer.Argument(metavar="ID", help="The component of the camera, as in 101.1.106.")],
    sensor: Annotated[int, typer.Option("--sensor", min=1, max=65535, help="The sensor id of the camera.")] = 1,
    to: Annotated[
        str | None,
        typer.Option(
            "--to",
            metavar="IP:PORT",
            help="Where the robot sends the video: an address of this machine that the robot can reach.  "
            "[default: port 5004 of the address that routes to the robot]",
        ),
    ] = None,
    sdp: Annotated[
        Path | None, typer.Option("--sdp", metavar="FILE", help="Description for players.  [default: ID.sdp]")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o", "--output", "--save", metavar="FILE", help="Record to this file, .mp4 or .mkv, without a player."
        ),
    ] = None,
    show: Annotated[bool, typer.Option("--show", help="Open a window with ffplay.")] = False,
    size: Annotated[
        str | None,
        typer.Option("--size", metavar="WxH", help="Size of the video.  [default: as the camera is set]"),
    ] = None,
    rate: Annotated[
        int | None,
        typer.Option("--rate", min=1, max=MAX_RATE, help="Pictures per second.  [default: as the camera is set]"),
    ] = None,
    bit_rate: Annotated[
        int | None,
        typer.Option(
            "--bitrate",
            min=MIN_BIT_RATE // 1000,
            max=MAX_BIT_RATE // 1000,
            help="Kilobits per second.  [default: as the camera is set]",
        ),
    ] = None,
    seconds: Annotated[
        float | None,
        typer.Option(
            "--seconds",
            min=0.1,
            help="End after this time, with --output after the first picture. Default: until Ctrl-C.",
        ),
    ] = None,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 2.0,
) -> None:
    """Request the video of a camera, and print commands that show it; or record it.

    The camera sends H.264 in RTP until this command ends. The commands of ffplay, GStreamer and VLC that show the video
    are printed. With --output the stream is recorded without re-encoding. --size, --rate and --bitrate take control of
    the camera for a moment; they apply to all who watch it, and stay.

    Examples:
      jauspy video 101.1.106
      jauspy video 101.1.106 --size 1280x720 --rate 10 --bitrate 3000
      jauspy video 101.1.107 -o front.mp4 --seconds 30
      jauspy video 101.1.106 --to 192.168.1.20:5004 --show
    """
    component = client.destination(camera)
    if component.is_wildcard:
        raise ConfigError(f"{component} has wildcards; name one component")
    if output is not None and show:
        raise typer.BadParameter("it cannot be combined with --output: a port has one receiver", param_hint="--show")
    given = None if to is None else parse_rtp_url(f"rtp://{to}")
    settings = StreamSettings(known_size(size_of(size)), rate, bit_rate)
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    if output is not None:
        run(record(ocu, component, sensor, given, settings, file=output, seconds=seconds))
        return
    file = sdp or Path(f"{component}.sdp")
    check_writable(file)
    run(watch(ocu, component, sensor, given, settings, file=file, show=show, seconds=seconds))


DEFAULT_PORT: Final = 5004
"""Port of RTP by default (RFC 3551)."""


async def own_address(ocu: OCU, camera: JausID, given: tuple[str, int] | None) -> tuple[str, int]:
    """The given address, else the one of this machine that routes to the camera."""
    if given is not None:
        return given
    robot = await ocu.discover(camera.subsystem)
    robot.component(str(camera)).service(ENDPOINTS)
    try:
        return await ocu.address_towards(camera), DEFAULT_PORT
    except RequestError as error:
        raise RequestError(f"{error}; name one that the robot can reach: --to IP:PORT") from None


ENDPOINTS: Final = "DigitalResourceDiscovery"
RENEWAL_INTERVAL: Final = 60.0
"""Seconds between two registrations; the robot removes an endpoint after five minutes."""

FIRST_NOTE: Final = 3.0
"""Seconds without a picture after which a note with possible causes is printed."""
START_TIMEOUT: Final = 20.0
"""Seconds until the first picture; the camera may have to be started."""
NOTE_INTERVAL: Final = 5.0
"""Seconds between two looks at what the camera says, and until it has said something."""
LONGEST_START: Final = 120.0
"""The same while the camera says that it is starting."""


def url_of(address: tuple[str, int]) -> str:
    """The URL of an RTP endpoint."""
    host = f"[{address[0]}]" if ":" in address[0] else address[0]
    return f"rtp://{host}:{address[1]}"


async def register(ocu: OCU, camera: JausID, sensor: int, url: str) -> int:
    """Register an endpoint for the video of a sensor; returns the endpoint's id."""
    record = Register.DigitalResourceEndpointRec(RTP_SERVER_TYPE, url, None, sensor)
    answer = await ocu.query(camera, Register(Register.RequestIDRec(1), record), expects=Confirm)
    if not answer.id:
        raise RequestError(
            f"{camera} does not send sensor {sensor} to {url}: is this an address from which the robot hears this "
            "machine, or in its video_targets; is there such a sensor, a free place among the receivers, and the extra "
            "'video' on the robot?"
        )
    return answer.id


async def said_by(ocu: OCU, camera: JausID, sensor: int) -> str:
    """Note of the camera about its stream; empty if it has none, or cannot be asked.

    It is asked for its video for a moment, since notes come beside it.
    """
    from jauspy.video.receiver import RtpReceiver

    try:
        with RtpReceiver(host := await ocu.address_towards(camera)) as receiver:
            async with registered(ocu, camera, sensor, url_of((host, receiver.port))), asyncio.timeout(NOTE_INTERVAL):
                while not (note := receiver.note):
                    receiver.take()
                    await asyncio.sleep(0.1)
                return note
    except (TimeoutError, RequestError, TransportError):
        return ""


@asynccontextmanager
async def registered(ocu: OCU, camera: JausID, sensor: int, url: str) -> AsyncIterator[None]:
    """The video is sent to `url` while this context is open."""
    robot = await ocu.discover(camera.subsystem)
    robot.component(str(camera)).service(ENDPOINTS)
    number = await register(ocu, camera, sensor, url)
    renewing = asyncio.create_task(_renew(ocu, camera, sensor, url))
    try:
        yield
    finally:
        renewing.cancel()
        with suppress(RequestError):  # a component that is gone sends no video
            await ocu.query(camera, Remove(number, 2), expects=Confirm)


async def watch(
    ocu: OCU,
    camera: JausID,
    sensor: int,
    given: tuple[str, int] | None,
    settings: StreamSettings,
    *,
    file: Path,
    show: bool,
    seconds: float | None,
) -> None:
    """Keep the endpoint registered until the time is up; print what shows the video."""
    async with AsyncExitStack() as stack:
        await stack.enter_async_context(ocu)
        address = await own_address(ocu, camera, given)
        await configure(ocu, camera, sensor, settings)
        sets = await parameter_sets(ocu, camera, sensor)
        players(file, f"{camera} sensor {sensor}", address, sets, show=show)
        await stack.enter_async_context(registered(ocu, camera, sensor, url_of(address)))
        console.print_lines(f"{camera} sends to {url_of(address)}; Ctrl-C ends it")
        await _sleep(seconds)


async def configure(ocu: OCU, camera: JausID, sensor: int, settings: StreamSettings) -> None:
    """Change the stream if one of the options requires it."""
    if not settings.is_empty:
        robot = await ocu.discover(camera.subsystem)
        video_service = robot.component(str(camera)).service("DigitalVideo")
        await set_stream(video_service, sensor, settings.size, settings.rate, settings.bit_rate)


async def parameter_sets(ocu: OCU, camera: JausID, sensor: int) -> tuple[bytes, ...]:
    """The stream's parameter sets, SPS and PPS, from its first pictures; none if no picture comes.

    With them in the session description, a player can begin with any key frame.
    """
    from jauspy.video.receiver import RtpReceiver

    found: dict[int, bytes] = {}
    note = ""
    try:
        with RtpReceiver(await ocu.address_towards(camera)) as receiver:
            own_url = url_of((await ocu.address_towards(camera), receiver.port))
            async with registered(ocu, camera, sensor, own_url), asyncio.timeout(START_TIMEOUT):
                while len(found) < 2:
                    for picture in receiver.take():
                        found |= {nal_type(nal): nal for nal in picture.nals if nal_type(nal) in (SPS, PPS)}
                    note = receiver.note
                    await asyncio.sleep(0.02)
    except (TimeoutError, RequestError, TransportError) as error:
        why = str(error) or f"no picture has come within {START_TIMEOUT:g} s" + (f"; it says: {note}" if note else "")
        console.note(f"the description lacks the stream's parameters, so that players wait for a key frame: {why}")
        return ()
    if note:
        console.note(f"{camera} says: {note}")
    return found[SPS], found[PPS]


async def record(
    ocu: OCU,
    camera: JausID,
    sensor: int,
    given: tuple[str, int] | None,
    settings: StreamSettings,
    *,
    file: Path,
    seconds: float | None,
) -> None:
    """Record the video; also ends when the size of the pictures changes."""
    need_video()
    from jauspy.video.receiver import RtpReceiver
    from jauspy.video.recorder import Recorder

    loop = asyncio.get_running_loop()
    started, ended = asyncio.Event(), asyncio.Event()
    telling: asyncio.Task[None] | None = None
    async with AsyncExitStack() as stack:
        await stack.enter_async_context(ocu)
        address = await own_address(ocu, camera, given)
        await configure(ocu, camera, sensor, settings)
        receiver, recorder = stack.enter_context(RtpReceiver(*address)), stack.enter_context(Recorder(file))

        def take() -> None:
            for picture in receiver.take():
                recorder.add(picture)
                started.set()
            if recorder.ended:
                ended.set()

        loop.add_reader(receiver.fileno(), take)
        try:
            async with registered(ocu, camera, sensor, url_of(address)):
                console.print_lines(f"recording {camera} to {file}; Ctrl-C ends it")
                telling = asyncio.create_task(_tell_notes(camera, receiver))
                with suppress(TimeoutError):
                    if not await _starts(started, FIRST_NOTE):
                        why = no_picture(camera, address, receiver.counters, receiver.note)
                        console.note(f"no picture yet: {why}")
                    await _first_picture(started, receiver)
                    async with asyncio.timeout(seconds):
                        await ended.wait()
        finally:
            if telling is not None:
                telling.cancel()
            loop.remove_reader(receiver.fileno())
            pictures, lost = recorder.pictures, receiver.counters.get("lost", 0)
            console.note(f"{pictures} pictures in {file}, {lost} packets lost")
    if not pictures:
        why = no_picture(camera, address, receiver.counters, receiver.note)
        raise RequestError(f"no picture was received in {_longest_start(receiver):g} s: {why}")


def _longest_start(receiver: RtpReceiver) -> float:
    return LONGEST_START if receiver.note else START_TIMEOUT


async def _first_picture(started: asyncio.Event, receiver: RtpReceiver) -> None:
    """Wait for the first picture, longer while the camera says that it is starting; raises `TimeoutError`."""
    clock = asyncio.get_running_loop().time
    began = clock()
    while not started.is_set():
        left = began + _longest_start(receiver) - FIRST_NOTE - clock()
        if left <= 0.0:
            raise TimeoutError
        await _starts(started, min(left, 1.0))


async def _tell_notes(camera: JausID, receiver: RtpReceiver) -> None:
    """Print what the camera says of its stream when it says something else."""
    said = ""
    while True:
        if (note := receiver.note) and note != said:
            console.note(f"{camera} says: {note}")
        said = note
        await asyncio.sleep(NOTE_INTERVAL)


async def _starts(started: asyncio.Event, seconds: float) -> bool:
    with suppress(TimeoutError):
        async with asyncio.timeout(seconds):
            await started.wait()
    return started.is_set()


def no_picture(camera: JausID, address: tuple[str, int], counters: Mapping[str, int], note: str = "") -> str:
    """Why no picture may have come, from what was received; `note` is what the camera says."""
    if note:
        return f"{camera} says: {note}"
    if counters:
        received = ", ".join(f"{name} {count}" for name, count in sorted(counters.items()))
        return f"packets arrive at {url_of(address)}, but no whole picture to begin with ({received})"
    if ipaddress.ip_address(address[0]).is_loopback:
        reason = f"only a robot on this machine reaches it; if {camera} is on another one, name an address with --to"
    else:
        reason = f"UDP port {address[1]} may be closed by a firewall, or {camera} may have no route to {address[0]}"
    return f"no packet has arrived at {url_of(address)}: the camera may still be starting; else {reason}"


def check_writable(file: Path) -> None:
    """Raise `ConfigError` if the description cannot be written, before anybody is asked for video."""
    if not os.access(file if file.exists() else file.parent, os.W_OK):
        raise ConfigError(f"cannot write {file}; choose another file with --sdp")


def players(file: Path, name: str, address: tuple[str, int], sets: tuple[bytes, ...], *, show: bool) -> None:
    """Write the SDP file and print commands for players; with `show` start ffplay if there is a display."""
    try:
        file.write_text(session_description(name, *address, sets), newline="")
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


@dataclass(frozen=True, slots=True)
class StreamSettings:
    """Settings to be changed; None keeps the camera's."""

    size: FrameSize | None = None
    rate: int | None = None
    """Pictures per second."""
    bit_rate: int | None = None
    """Kilobits per second."""

    @property
    def is_empty(self) -> bool:
        """True if nothing is to be changed."""
        return self == StreamSettings()


def known_size(pixels: tuple[int, int] | None) -> FrameSize | None:
    """JAUS's number of a size; raises `ConfigError` with the sizes that there are."""
    if pixels is None:
        return None
    found = frame_size(*pixels)
    if found not in SUPPORTED_FRAME_SIZES:
        sizes = sorted(set(SUPPORTED_FRAME_SIZES.values()))
        known = ", ".join(f"{width}x{height}" for width, height in sizes)
        raise ConfigError(f"--size {pixels[0]}x{pixels[1]}: JAUS has no such size for video; it has: {known}")
    return found
