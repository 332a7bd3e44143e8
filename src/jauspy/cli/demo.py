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
    plain: Annotated[bool, typer.Option("--plain", help="Plain lines instead of a live table.")] = False,
) -> None:
    """See it all work: a simulated robot drives 2 m and turns 90 degrees.

    Starts a node manager and the robot as processes, discovers them over real UDP sockets, takes control, drives by
    the reported pose, gives control back, and prints what happened. Takes less than 90 s and leaves nothing behind.

    Example:
      jauspy demo --port 3795 --backend kinematic
    """
