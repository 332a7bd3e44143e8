"""`jauspy send`: send a message without waiting for an answer."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Final

import typer

from jauspy.cli.definitions import Beside, ServiceName, ServiceVersion
from jauspy.cli.options import Connect, OwnId, Timeout
from jauspy.cli.query import Destination, Fields, MessageName

if TYPE_CHECKING:
    from jauspy.codec.message import Message
    from jauspy.ids import JausID
    from jauspy.ocu import OCU


_FREE_SERVICES: Final = frozenset({"Transport", "Events", "EventsClient", "AccessControl", "Discovery", "Liveness"})


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
    within: Annotated[
        float | None,
        typer.Option(
            "--within", min=0, metavar="SECONDS", help="Wait until it has been carried out, and no longer than that."
        ),
    ] = None,
    sources: Beside = None,
    service: ServiceName = None,
    version: ServiceVersion = None,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 2.0,
) -> None:
    """Send a command or any other message.

    A command moves a component only while somebody controls it: --control takes control, resumes the component, sends,
    waits until it has been carried out (--within) or for --hold seconds, and gives all back; losing control meanwhile
    is an error. Without it the message is sent, and a note on stderr says what speaks against its effect.

    Examples:
      jauspy send 101.1.102 SetWrenchEffort propulsive_linear_effort_x=40 --control 200 --hold 2
      jauspy send 101.1.102 SetEmergency emergency_code=STOP
    """
    from jauspy.cli import addresses, console
    from jauspy.cli.definitions import definitions
    from jauspy.cli.fields import message_from
    from jauspy.cli.run import run
    from jauspy.errors import ConfigError

    if control is None and hold:
        raise typer.BadParameter("control can only be held with --control", param_hint="--hold")
    if control is None and within is not None:
        raise typer.BadParameter("a command is only waited for with --control", param_hint="--within")
    to = addresses.destination(destination)
    known = definitions(sources)
    command = message_from(known.registry, message, fields or [], known.hints(service, version))
    if command.IS_QUERY:
        raise ConfigError(f"{command.NAME} is a query, and its answer would not be shown; use `jauspy query`")
    if control is not None and to.is_wildcard:
        raise ConfigError(f"control is taken of one component at a time, and {to} may be several")
    ocu = addresses.client(own_id, connect, timeout, known.registry)
    if control is None:
        remark = run(_send(ocu, to, command))
        if remark:
            console.note(remark)
    else:
        run(_send_in_control(ocu, to, command, authority=control, hold=hold, within=within, patience=timeout))


async def _send(ocu: OCU, to: JausID, command: Message) -> str:
    """Send; returns what speaks against an effect."""
    async with ocu:
        await ocu.send(to, command)
        return "" if to.is_wildcard else await _doubt(ocu, to, command)


async def _doubt(ocu: OCU, to: JausID, command: Message) -> str:
    """Why a component may not have done what it was sent."""
    import asyncio
    from typing import Any

    from jauspy.ids import JausID
    from jauspy.messages.core import QueryControl, QueryEventTimeout, QueryStatus, ReportControl, ReportStatus

    # Every component answers the last one, whatever else it offers.
    questions = QueryControl(), QueryStatus(), QueryEventTimeout()
    answers: list[Any] = await asyncio.gather(*(ocu.query(to, each) for each in questions), return_exceptions=True)
    control, status, _ = answers
    if all(isinstance(each, BaseException) for each in answers):
        return f"sent, but {to} does not answer: perhaps nobody has got it (`jauspy ls` shows who is there)"
    if (
        command.NAME == "ClearEmergency"
        and isinstance(status, ReportStatus)
        and status.status == status.Status.EMERGENCY
    ):
        return f"sent, but {to} is still in EMERGENCY: whoever set it must clear it, and you are {ocu.id} (see --id)"
    if isinstance(control, ReportControl) and _needs_control(command):
        holder = JausID(control.subsystem_id, control.node_id, control.component_id)
        who = str(holder) if int(holder) else "nobody"
        if holder != ocu.id:
            return f"sent, but {to} obeys only who is in control, and that is {who}: use --control AUTHORITY"
    return ""


def _needs_control(command: Message) -> bool:
    """False for what anybody may send: all of the services that every component has, and emergencies."""
    if not command.IS_COMMAND or command.NAME in {"SetEmergency", "ClearEmergency"}:
        return False
    return command.SERVICE.rpartition(":")[2] not in _FREE_SERVICES


async def _send_in_control(
    ocu: OCU, to: JausID, command: Message, *, authority: int, hold: float, within: float | None, patience: float
) -> None:
    """Control is taken, the component resumed unless the message itself manages its state, and all that undone."""
    import asyncio
    from contextlib import suppress

    async with ocu:
        robot = await ocu.discover(to.subsystem, timeout=patience)
        client = robot.component(to).service("AccessControl")
        async with client.control(authority) as control:
            if not command.SERVICE.endswith(":Management"):
                await client.resume(patience)
            if within is None:
                await client.send(command)
            else:
                await client.perform(command, within=within)
            with suppress(TimeoutError):
                await asyncio.wait_for(control.until_lost(), hold)
            control.check()
