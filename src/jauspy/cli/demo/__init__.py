"""`jauspy demo`: everything at once, on this machine."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli.options import DEFAULT_PORT, Port

if TYPE_CHECKING:
    from jauspy.services.environment_sensing.frame_sizes import FrameSize


def demo(
    *,
    port: Port = DEFAULT_PORT,
    backend: Annotated[
        str,
        typer.Option(
            "--backend",
            metavar="NAME",
            help="sim: MuJoCo physics (extra 'all'); kinematic: pure Python, only drives and moves the arm; or that of "
            "an installed package.",
        ),
    ] = "sim",
    output: Annotated[
        Path, typer.Option("--output", metavar="DIR", help="Where videos, still, map, plot and summary go.")
    ] = Path("demo_out"),
    size: Annotated[str, typer.Option("--size", metavar="WxH", help="Size of the videos.")] = "640x480",
    plain: Annotated[
        bool, typer.Option("--plain", "--headless", help="Plain lines instead of a live table, as in a pipe.")
    ] = False,
) -> None:
    """See it all work: a simulated robot drives to a table, looks, reaches, grasps a can and lifts it.

    Starts a node manager and the robot as processes and is the operator's unit itself: discovers them over real UDP
    sockets, takes control, records both cameras, maps with the lidar, drives by waypoint, finds the can in the picture,
    moves the arm and the gripper, and gives control back. Writes what it saw and measured, and prints a summary; the
    exit status is 0 if every goal was reached. Takes less than 90 s and leaves no process behind.

    Example:
      jauspy demo --port 3795 --output /tmp/demo
    """
    from jauspy.cli import console
    from jauspy.cli.demo.processes import play
    from jauspy.cli.demo.view import LiveView, View
    from jauspy.cli.run import run

    pixels = _size(size)
    view = View() if plain or not console.is_terminal() else LiveView()
    try:
        report = run(play(port, backend, view, output, pixels))
    except KeyboardInterrupt:
        console.note(view.farewell())
        raise typer.Exit(130) from None
    if report is None:  # told to stop
        console.note(view.farewell())
        raise typer.Exit(1)
    console.stdout().print(report.panel(str(output)))
    if not report.reached:
        raise typer.Exit(1)


def _size(text: str) -> FrameSize:
    from jauspy.services.environment_sensing.frame_sizes import OFFERED

    named = {f"{width}x{height}": size for size, (width, height) in OFFERED.items()}
    if text not in named:
        raise typer.BadParameter(f"{text!r} is none of {', '.join(named)}", param_hint="--size")
    return named[text]
