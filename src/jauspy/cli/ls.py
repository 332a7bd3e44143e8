"""`jauspy ls`: who is there."""

from __future__ import annotations

from typing import Annotated

import typer

from jauspy.cli.options import OCU_ID, Connect, Json, OwnId


def ls(
    *,
    connect: Connect = None,
    own_id: OwnId = OCU_ID,
    timeout: Annotated[
        float, typer.Option("--timeout", min=0.01, metavar="SECONDS", help="How long to listen for answers.")
    ] = 2.0,
    as_json: Json = False,
) -> None:
    """Find who answers: subsystems, nodes, components and services.

    Example:
      jauspy ls --connect udp://192.168.1.20:3794 --timeout 5
    """
