"""`jauspy record`: record what is routed, what passes a network, or a capture."""

from __future__ import annotations

import math
import re
import threading
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.capture.filters import Filter
from jauspy.capture.reader import Datagram, up_to_damage
from jauspy.cli import console
from jauspy.cli.definitions import SchemasOption, definitions
from jauspy.cli.options import DEFAULT_ROOT, Connect, FilterOption, LocalRoot, OwnId, Timeout
from jauspy.cli.processes import stoppable
from jauspy.cli.recorded import Cameras, Robots, cameras, described, pictures_taken
from jauspy.cli.traffic import CaptureFile, Interface, Multicast, NetworkPort, chosen_network, open_capture
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.recording.recorder import FLUSH_INTERVAL, Limits, Picture, Recorder
from jauspy.video.h264_payload import join_nals

if TYPE_CHECKING:
    from jauspy.export.rtp_streams import RecordedPicture, RtpStreams

UNITS = {"": 1.0, "k": 1e3, "m": 1e6, "g": 1e9}


def record(
    *,
    output: Annotated[Path, typer.Argument(metavar="FILE", help="A .mcap or .pcapng file, which does not exist yet.")],
    only: FilterOption = None,
    seconds: Annotated[
        float | None,
        typer.Option("--for", min=0.1, metavar="SECONDS", help="How long to record. Default: until Ctrl-C."),
    ] = None,
    split_size: Annotated[
        str | None, typer.Option("--split-size", metavar="SIZE", help="A new file at this size: 500k, 100M, 2G bytes.")
    ] = None,
    split_time: Annotated[
        float | None, typer.Option("--split-time", min=1.0, metavar="SECONDS", help="A new file after so long.")
    ] = None,
    keep: Annotated[
        int | None, typer.Option("--keep", min=1, metavar="N", help="Keep so many files, and delete older ones.")
    ] = None,
    robot: Robots = None,
    video: Cameras = None,
    file: CaptureFile = None,
    interface: Interface = None,
    multicast: Multicast = None,
    port: NetworkPort = None,
    root: LocalRoot = DEFAULT_ROOT,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 5.0,
    schemas: SchemasOption = None,
) -> None:
    """Record what the node manager of this machine routes, until Ctrl-C.

    A .pcapng file has the datagrams, for Wireshark. A .mcap file has them, too, and each message as JSON on the topic
    /SENDER/MESSAGE, with a schema made from its definition. All definitions are attached. It opens in Foxglove, with
    frames, poses, scans, joints and a log in Foxglove's schemas; with --robot also meshes, with --video pictures.
    With --capture or --interface, and without --filter, a .mcap file also gets the H.264 in RTP that is seen there.

    Examples:
      jauspy record run.mcap
      jauspy record run.mcap --robot inc1 --video 101.1.106
      jauspy record run.mcap --split-time 600 --keep 6
      jauspy record run.pcapng --filter 'src == 101.*' --for 60
      jauspy record run.mcap --interface eth0
      jauspy record run.mcap --capture run.pcapng
    """
    known = definitions(schemas)
    if keep is not None and split_size is None and split_time is None:
        raise ConfigError("--keep needs --split-size or --split-time")
    wanted = cameras(video)
    if wanted and (output.suffix != ".mcap" or file is not None):
        raise ConfigError("--video needs a .mcap file, and cameras that send now, not --capture")
    limits = Limits(None if split_size is None else _bytes(split_size), split_time, keep)
    fits = None if only is None else Filter(only, known.registry)
    network = chosen_network(interface, multicast, port, file)
    with_video = output.suffix == ".mcap" and only is None
    streams = None
    if network is not None and with_video:
        from jauspy.export.rtp_streams import RtpStreams  # before the capture begins, because it takes a while

        network = replace(network, with_rtp=True)
        streams = RtpStreams(known.registry)
    ocu = None
    if wanted:
        from jauspy.cli import client  # takes seconds, and nothing else here needs it

        ocu = client.make_ocu(own_id, connect, timeout)
    with stoppable(), open_capture(file, root, seconds, network=network) as capture:
        recorder = Recorder(output, known.registry, limits, fits, described(robot))
        if file is None:
            console.note("recording" + ("; Ctrl-C ends it" if seconds is None else f" for {seconds:g} s"))
        try:
            flushed = _flushed(recorder) if file is None else nullcontext()
            with pictures_taken(ocu, wanted, recorder.add_picture), flushed:
                datagrams: Iterable[Datagram] = up_to_damage(capture, console.note)
                if with_video and file is not None:
                    datagrams = _with_pictures_of_file(datagrams, file, recorder, known.registry)
                elif streams is not None and network is not None:
                    datagrams = _with_pictures(datagrams, network.port, recorder, streams)
                recorder.run(datagrams)
        finally:
            found = recorder.recorded
            files = ", ".join(map(str, found.files)) or "no file"
            pictures = f"{found.pictures} pictures, " if wanted or found.pictures else ""
            counts = f"{found.datagrams} datagrams, {found.messages} messages, {pictures}{found.bytes} bytes"
            console.note(f"{counts}: {files}")


@contextmanager
def _flushed(recorder: Recorder) -> Iterator[None]:
    """Have what was recorded handed over also while nothing comes, in a thread while the context is open."""
    ended = threading.Event()

    def work() -> None:
        while not ended.wait(FLUSH_INTERVAL / 2.0):
            recorder.flush()

    thread = threading.Thread(target=work, name="flush", daemon=True)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()


def _with_pictures_of_file(
    datagrams: Iterable[Datagram], file: Path, recorder: Recorder, registry: Registry
) -> Iterator[Datagram]:
    """The datagrams; the pictures of H.264 in RTP that the file has, too, are recorded between them, by time."""
    from jauspy.export.films import pictures

    found = pictures(file, registry)

    def following() -> RecordedPicture | None:
        with suppress(ConfigError):  # which the datagrams tell, too
            return next(found, None)
        return None

    picture = following()

    def record_until(time: float) -> None:
        nonlocal picture
        while picture is not None and picture.time <= time:
            _record(picture, recorder)
            picture = following()

    for datagram in datagrams:
        record_until(datagram.time)
        yield datagram
    record_until(math.inf)


def _with_pictures(
    datagrams: Iterable[Datagram], port: int, recorder: Recorder, streams: RtpStreams
) -> Iterator[Datagram]:
    """The datagrams of JAUS, by their port; the pictures of H.264 in the others are recorded."""
    for datagram in datagrams:
        for picture in streams.feed(datagram):
            _record(picture, recorder)
        if port in (datagram.source[1], datagram.destination[1]):
            yield datagram


def _record(found: RecordedPicture, recorder: Recorder) -> None:
    unit = join_nals(found.picture.nals)
    recorder.add_picture(Picture(found.camera, found.time, unit, found.picture.is_idr))
    recorder.write_pictures()


def _bytes(text: str) -> float:
    found = re.fullmatch(r"(\d+(?:\.\d+)?)([kmg]?)b?", text.strip(), re.IGNORECASE)
    if not found or float(found[1]) <= 0.0:
        raise ConfigError(f"{text!r} is no size, as 500k, 100M or 2G")
    return float(found[1]) * UNITS[found[2].lower()]
