"""`jauspy send`: send a message without waiting for an answer."""

from __future__ import annotations

from typing import Annotated

import typer

from jauspy.cli.options import OCU_ID, Connect, OwnId, Timeout
from jauspy.cli.query import Destination, Fields, MessageName


def send(
    *,
    destination: Destination,
    message: MessageName,
    fields: Fields = None,
    control: Annotated[
        int | None,
        typer.Option(
            "--control", min=0, max=255, metavar="AUTHORITY", help="Take access control first, release it afterwards."
        ),
    ] = None,
    connect: Connect = None,
    own_id: OwnId = OCU_ID,
    timeout: Timeout = 2.0,
) -> None:
    """Send a command or any other message.

    Nothing is awaited but control, where asked for. With --control the robot obeys, and stops when
    control is released at the end.

    Examples:
      jauspy send 101.1.1 Resume --control 200
      jauspy send 101.1.1 SetEmergency emergency_code=STOP
    """
