"""`jauspy query`: ask a component, print its answer."""

from __future__ import annotations

from typing import Annotated

import typer

from jauspy.cli.options import OCU_ID, Connect, OwnId, Timeout

Destination = Annotated[str, typer.Argument(metavar="ID", help="The component, as in 101.1.1.")]
MessageName = Annotated[str, typer.Argument(metavar="MESSAGE", help="The message's JAUS name; case does not matter.")]
Fields = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="[FIELD=VALUE]...",
        help="Numbers (12, 0x1ff, 1.5e3) in the field's units, names of enumerations, text, JSON or YAML for lists and "
        "mappings; a dot reaches into mappings. A wrong field name lists the right ones with units.",
    ),
]


def query(
    *,
    destination: Destination,
    message: MessageName,
    fields: Fields = None,
    connect: Connect = None,
    own_id: OwnId = OCU_ID,
    timeout: Timeout = 2.0,
) -> None:
    """Ask a component and print its answer.

    The answer is YAML on a terminal, one JSON object per line in a pipe. A presence vector that is not given asks
    for every field. Lengths are in metres, angles in radians, times in seconds.

    Examples:
      jauspy query 101.1.1 QueryStatus
      jauspy query 101.1.1 QueryLocalPose presence_vector=0x43
    """
