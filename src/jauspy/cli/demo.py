"""`jauspy demo`: everything at once, on this machine."""

from __future__ import annotations

from typing import Annotated

import typer

from jauspy.cli.options import DEFAULT_PORT, Port
from jauspy.cli.up import Backend, BackendName


def demo(
    *,
    port: Port = DEFAULT_PORT,
    backend: Backend = BackendName.SIM,
    plain: Annotated[
        bool, typer.Option("--plain", "--headless", help="Plain lines instead of a live table, as in a pipe.")
    ] = False,
) -> None:
    """See it all work: a simulated robot drives 2 m and turns 90 degrees.

    Starts a node manager and the robot as processes, discovers them over real UDP sockets, takes control, drives by
    the reported pose, gives control back, and prints what happened. Takes less than 90 s and leaves nothing behind.

    Example:
      jauspy demo --port 3795 --backend kinematic
    """
    from jauspy.cli import console
    from jauspy.cli.demo_run import play
    from jauspy.cli.demo_view import LiveView, PlainView, summary
    from jauspy.cli.run import run

    name = (backend or BackendName.SIM).value
    view = PlainView() if plain or not console.is_terminal() else LiveView()
    result = run(play(port, name, view))
    if result is None:  # told to stop
        raise typer.Exit(1)
    console.stdout().print(summary(result, name))
