"""`jauspy video`: watch a camera of a robot."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from jauspy.cli.options import Connect, OwnId, Timeout


def video(
    *,
    camera: Annotated[str, typer.Argument(metavar="ID", help="The vision module, as in 101.1.106.")],
    sensor: Annotated[int, typer.Option("--sensor", min=1, max=65535, help="Which of its cameras.")] = 1,
    to: Annotated[
        str,
        typer.Option(
            "--to",
            metavar="IP:PORT",
            help="Where the robot sends the video: an address of the machine that watches, as the robot reaches it.",
        ),
    ] = "127.0.0.1:5004",
    sdp: Annotated[
        Path | None, typer.Option("--sdp", metavar="FILE", help="Description for players.  [default: ID.sdp]")
    ] = None,
    save: Annotated[
        Path | None, typer.Option("--save", metavar="FILE", help="Record to that file, .mp4 or .mkv; no player runs.")
    ] = None,
    show: Annotated[bool, typer.Option("--show", help="Open a window with ffplay.")] = False,
    seconds: Annotated[
        float | None,
        typer.Option(
            "--seconds", min=0.1, help="End after that time, with --save from the first picture on; else with Ctrl-C."
        ),
    ] = None,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 2.0,
) -> None:
    """Have a camera's video sent here, and say how to watch it; or record it.

    The video comes as H.264 in RTP, until this ends; how ffplay, GStreamer and VLC show it is printed. With --save it
    is recorded as it comes, without a player.

    Examples:
      jauspy video 101.1.106
      jauspy video 101.1.107 --save front.mp4 --seconds 30
      jauspy video 101.1.106 --to 192.168.1.20:5004 --show
    """
    from jauspy.cli import addresses
    from jauspy.cli.run import run
    from jauspy.cli.video_watch import players, record, watch
    from jauspy.errors import ConfigError
    from jauspy.services.environment_sensing.video_camera import address_of

    component = addresses.destination(camera)
    if component.is_wildcard:
        raise ConfigError(f"{component} may be several; one camera is watched at a time")
    if save is not None and show:
        raise typer.BadParameter("a port has one listener: watch, or record", param_hint="--show")
    address = address_of(f"rtp://{to}")
    ocu = addresses.client(own_id, connect, timeout)
    if save is not None:
        run(record(ocu, component, sensor, address, file=save, seconds=seconds))
        return
    file = sdp or Path(f"{component}.sdp")
    players(file, f"{component} sensor {sensor}", address, show=show)
    run(watch(ocu, component, sensor, address, seconds))
