"""`jauspy live`: show what is routed in Foxglove, now."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Iterator, Sequence
from contextlib import closing
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.capture.dissector import Dissector
from jauspy.capture.filters import Filter
from jauspy.cli import console
from jauspy.cli.definitions import SchemasOption, definitions
from jauspy.cli.options import DEFAULT_ROOT, Connect, FilterOption, LocalRoot, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.cli.recorded import Camera, Cameras, Robots, cameras, described, take_pictures
from jauspy.inspection.live import LiveCapture
from jauspy.recording.recorder import Picture

if TYPE_CHECKING:
    from jauspy.ocu import OCU
    from jauspy.recording.live_view import LiveView
    from jauspy.recording.samples import Sample


def live(
    *,
    port: Annotated[int, typer.Option("--port", min=0, max=65535, help="TCP port; 0 is any free one.")] = 8765,
    host: Annotated[
        str,
        typer.Option("--host", metavar="IP", help="Address to listen at. Whoever reaches it sees all traffic."),
    ] = "127.0.0.1",
    robot: Robots = None,
    video: Cameras = None,
    only: FilterOption = None,
    seconds: Annotated[
        float | None, typer.Option("--for", min=0.1, metavar="SECONDS", help="How long. Default: until Ctrl-C.")
    ] = None,
    root: LocalRoot = DEFAULT_ROOT,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 5.0,
    schemas: SchemasOption = None,
) -> None:
    """Show what the node manager of this machine routes in Foxglove, live.

    In Foxglove: Open connection, Foxglove WebSocket, the printed address. It has the channels of `jauspy record`. A
    client that is too slow is sent less video and fewer scans, but each change of state. One that reads nothing for 3 s
    is disconnected, so that it does not find old data when it comes back; it then gets the present states.

    Examples:
      jauspy live
      jauspy live --robot inc1 --video 101.1.106
    """
    import foxglove

    from jauspy.recording.feed import Feed
    from jauspy.recording.live_view import LiveView

    foxglove.set_log_level(logging.CRITICAL)  # it would print a line for each bad frame of a client
    known, wanted = definitions(schemas), cameras(video)
    fits = None if only is None else Filter(only, known.registry)
    dissector = Dissector(known.registry)
    feed, view = Feed(known.registry, described(robot)), LiveView()
    capture = LiveCapture(root, seconds)
    ocu = None
    if wanted:
        from jauspy.cli import client  # takes seconds, and nothing else here needs it

        ocu = client.make_ocu(own_id, connect, timeout)

    def samples() -> Iterator[list[Sample]]:
        for datagram in capture:
            parts = dissector.dissect(datagram.payload, datagram.time).parts
            kept = parts if fits is None else tuple(filter(fits, parts))
            if kept or fits is None:
                yield list(feed.samples(datagram, kept))

    with closing(capture):
        run(_serve(view, (host, port), capture, samples(), ocu=ocu, wanted=wanted))
    counted = ", ".join(f"{count} {name.replace('_', ' ')}" for name, count in sorted(view.counters.items()))
    console.note(counted or "no client")
    if capture.lost:
        console.note(f"{capture.lost} packets were lost, because they were not read in time")


async def _serve(
    view: LiveView,
    address: tuple[str, int],
    capture: LiveCapture,
    samples: Iterator[list[Sample]],
    *,
    ocu: OCU | None,
    wanted: Sequence[Camera],
) -> None:
    """Publish samples until they end, or this is cancelled."""
    from jauspy.recording.foxglove_messages import picture

    loop = asyncio.get_running_loop()

    async def publish(made: list[Sample]) -> None:
        for sample in made:
            view.publish(sample)

    def read() -> None:
        for made in samples:
            asyncio.run_coroutine_threadsafe(publish(made), loop).result()  # which holds the reader back

    def add(taken: Picture) -> None:
        time = round(taken.time * 1e9)
        view.publish(picture(taken.camera, time, taken.access_unit, is_idr=taken.is_idr))

    host, port = address[0], await view.start(*address)
    shown = f"[{host}]" if ":" in host else host
    console.print_lines(f"ws://{shown}:{port} for Foxglove; Ctrl-C ends it")
    reading = asyncio.create_task(asyncio.to_thread(read))
    tasks = {reading}
    if ocu is not None:
        tasks.add(asyncio.create_task(take_pictures(ocu, wanted, add, lambda: None)))
    try:
        done, _ = await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        for task in done:
            task.result()
    finally:
        capture.interrupt()
        for task in tasks - {reading}:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        await view.close()
