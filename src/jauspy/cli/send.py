"""`jauspy send`: send a message without waiting for an answer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli.options import OCU_ID, Connect, OwnId, Timeout
from jauspy.cli.query import Destination, Fields, MessageName

if TYPE_CHECKING:
    from jauspy.codec.base import Message
    from jauspy.ids import JausID
    from jauspy.ocu import OCU


def send(
    *,
    destination: Destination,
    message: MessageName,
    fields: Fields = None,
    control: Annotated[
        int | None,
        typer.Option(
            "--control",
            min=0,
            max=255,
            metavar="AUTHORITY",
            help="Take access control and resume first; Standby and release afterwards.",
        ),
    ] = None,
    hold: Annotated[
        float, typer.Option("--hold", min=0, metavar="SECONDS", help="Keep control that long after sending.")
    ] = 0.0,
    connect: Connect = None,
    own_id: OwnId = OCU_ID,
    timeout: Timeout = 2.0,
) -> None:
    """Send a command or any other message.

    A command moves a component only while somebody controls it: --control takes control, resumes the component, sends,
    waits for --hold seconds, and gives all back. Without it nothing is awaited.

    Examples:
      jauspy send 101.1.102 SetWrenchEffort propulsive_linear_effort_x=40 --control 200 --hold 2
      jauspy send 101.1.102 SetEmergency emergency_code=STOP
    """
    from jauspy.cli.fields import message_from
    from jauspy.cli.run import run
    from jauspy.ids import JausID
    from jauspy.messages import registry
    from jauspy.ocu import OCU

    if control is None and hold:
        raise typer.BadParameter("control can only be held with --control", param_hint="--hold")
    to = JausID.parse(destination)
    command = message_from(registry, message, fields or [])
    ocu = OCU(own_id, connect, timeout=timeout / 3, retries=2)
    if control is None:
        run(_send(ocu, to, command))
    else:
        run(_send_in_control(ocu, to, command, authority=control, hold=hold, patience=timeout))


async def _send(ocu: OCU, to: JausID, command: Message) -> None:
    async with ocu:
        await ocu.send(to, command)


async def _send_in_control(
    ocu: OCU, to: JausID, command: Message, *, authority: int, hold: float, patience: float
) -> None:
    """Control is taken, the component resumed unless the message itself manages its state, and all that undone."""
    import asyncio

    async with ocu:
        robot = await ocu.discover(to.subsystem, timeout=patience)
        client = robot.component(to).service("AccessControl")
        async with client.control(authority):
            if not command.SERVICE.endswith(":Management"):
                await client.resume(patience)
            await client.send(command)
            await asyncio.sleep(hold)
