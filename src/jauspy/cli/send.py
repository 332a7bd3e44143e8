"""`jauspy send`: send a command or another message that has no answer."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncGenerator
from contextlib import asynccontextmanager, suppress
from typing import Annotated, Final, TypeAlias

import typer

from jauspy.cli import client, console
from jauspy.cli.definitions import SchemasOption, ServiceName, ServiceVersion, definitions
from jauspy.cli.fields import message_from
from jauspy.cli.options import Connect, OperatorKey, OwnId, Peer, Timeout
from jauspy.cli.processes import run
from jauspy.cli.query import Destination, Fields, MessageName
from jauspy.codec.message import Message
from jauspy.errors import ConfigError, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import QueryStatus, ReportStatus, Reset
from jauspy.ocu import OCU
from jauspy.ocu.explain import TAKE_CONTROL, needs_control
from jauspy.ocu.service import ServiceClient
from jauspy.services.command_timeout import CONTINUOUS_COMMANDS

REPEAT_RATE: Final = 5.0
"""Hz, at which efforts, velocities and vectors are sent during --hold."""
ACCESS_CONTROL: Final = "urn:jaus:jss:core:AccessControl"
STATUS_INTERVAL: Final = 0.1
"""Seconds between two queries of the status after Reset."""
LEFT_FAILURE: Final = 5
"""Reports of Standby in a row, after which a component has left Failure."""
Status: TypeAlias = ReportStatus.Status


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
            help="Take access control and resume the component first; Standby and release control afterwards.",
        ),
    ] = None,
    hold: Annotated[
        float, typer.Option("--hold", min=0, metavar="SECONDS", help="Keep control for this long after sending.")
    ] = 0.0,
    within: Annotated[
        float | None,
        typer.Option(
            "--within", min=0, metavar="SECONDS", help="Wait until the command has been carried out, at most this long."
        ),
    ] = None,
    sources: SchemasOption = None,
    service: ServiceName = None,
    version: ServiceVersion = None,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    peer: Peer = None,
    timeout: Timeout = 2.0,
) -> None:
    """Send a command or any other message that has no answer.

    Most commands take effect only if their sender controls the component. --control takes control, resumes the
    component, sends, waits until the command has been carried out (--within) or for --hold seconds, then sends Standby
    and releases control. Efforts, velocities and vectors are sent five times a second meanwhile, and zero before
    Standby. Exit status 1 means that control was lost meanwhile, that the component ignores or refuses the command
    (not offered, wrong joints, out of range, not Ready), or that it did not acknowledge Standby and release. Without
    --control the message is sent, too, and status 1 means that the component ignores it, for the reason on stderr.
    Reset of a component in Failure needs no control, and is awaited.

    Examples:
      jauspy send 101.1.102 SetWrenchEffort propulsive_linear_effort_x=40 --control 200 --hold 2
      jauspy send 101.1.102 SetEmergency emergency_code=STOP
      jauspy send 101.1.103 SetJointEffort 'joint_effort_list=[{joint_effort: 10}]' --control 200 --hold 1
      jauspy send 101.1.102 SetTime 'time_stamp={milliseconds: 0, seconds: 0, minutes: 30, hour: 12, day: 1}'

    `jauspy schema show MESSAGE` prints an example of any message, lists and records included.
    """
    if control is None and hold:
        raise typer.BadParameter("it requires --control", param_hint="--hold")
    if control is None and within is not None:
        raise typer.BadParameter("it requires --control", param_hint="--within")
    recipient = client.destination(destination)
    known = definitions(sources)
    command = message_from(known.registry, message, fields or [], known.hints(service, version))
    if command.IS_QUERY:
        raise ConfigError(f"{command.NAME} is a query, whose answer would not be shown; use `jauspy query`")
    if control is not None and recipient.is_wildcard:
        raise ConfigError(f"--control takes control of one component, and {recipient} has wildcards")
    ocu = client.make_ocu(own_id, connect, timeout, known.registry, operator=operator_key, peer=peer)
    if control is None:
        run(send_without_control(ocu, recipient, command, max_wait=timeout))
    else:
        run(send_in_control(ocu, recipient, command, authority=control, hold=hold, within=within, max_wait=timeout))


async def send_without_control(ocu: OCU, to: JausID, command: Message, *, max_wait: float) -> None:
    """Send; raises `RequestError` with the reason if the component has ignored it.

    Reset of a component in Failure is awaited.
    """
    async with ocu:
        if isinstance(command, Reset) and not to.is_wildcard and await _status(ocu, to) == Status.FAILURE:
            await _recover(ocu, to, max_wait)
            return
        await ocu.send(to, command)
        reason = "" if to.is_wildcard else await _obstacle(ocu, to, command)
        if reason:
            raise RequestError(f"{command.NAME} was sent, but {reason}")


async def _obstacle(ocu: OCU, to: JausID, command: Message) -> str:
    """Why a component may not have carried out a command."""
    reason = await ocu.explain(to, command)
    if ocu.stats.refused:
        return ""  # the log says why
    if command.NAME == "ClearEmergency":
        reason = reason or await _still_in_emergency(ocu, to)
    return reason.replace(TAKE_CONTROL, "use --control AUTHORITY")


async def _status(ocu: OCU, id: JausID) -> int | None:
    """The status that a component reports, None if it reports none."""
    with suppress(ResponseTimeout):
        return (await ocu.query(id, QueryStatus(), expects=ReportStatus)).status
    return None


async def _recover(ocu: OCU, id: JausID, max_wait: float) -> None:
    """Send Reset to a component in Failure; raises `RequestError` if it fails again or stays there for `max_wait` s.

    A part that has not recovered fails again a moment after Reset, so one report of another state is not enough.
    """
    await ocu.send(id, Reset(), ack=True)
    left, status = 0, None
    for _ in range(max(LEFT_FAILURE, round(max_wait / STATUS_INTERVAL))):
        await asyncio.sleep(STATUS_INTERVAL)
        status = await _status(ocu, id)
        left = left + 1 if status == Status.STANDBY else 0
        if left == LEFT_FAILURE:
            console.note(f"{id} has left Failure: it is in Standby")
            return
    where = "still in Failure" if status == Status.FAILURE else f"in status {getattr(status, 'name', status)}"
    raise RequestError(
        f"Reset was sent, but {id} is {where}: what has failed does not work yet (its log names it), or it has no "
        "recovery by Reset, which AS5710 does not require; then start the component again"
    )


async def _still_in_emergency(ocu: OCU, to: JausID) -> str:
    if await _status(ocu, to) == Status.EMERGENCY:
        return f"{to} is still in EMERGENCY; only the id that set it can clear it; this is {ocu.id} (see --id)"
    return ""


async def send_in_control(
    ocu: OCU, to: JausID, command: Message, *, authority: int, hold: float, within: float | None, max_wait: float
) -> None:
    """Take control, resume the component unless the message is one of Management, send, and release control.

    The component is not discovered first: many inherit from AccessControl without listing it, or have no Discovery.
    """
    async with ocu:
        if isinstance(command, Reset) and await _status(ocu, to) == Status.FAILURE:
            await _recover(ocu, to, max_wait)  # in Failure nobody gets control, and Reset needs none
            return
        client = ocu.service(to, ACCESS_CONTROL)
        async with client.control(authority) as control:
            if not command.SERVICE.endswith(":Management") and await _has_management(client):
                await client.resume(max_wait)
            async with _commanded(client, command, within):
                explained = asyncio.create_task(_ignored(client, command))
                try:
                    with suppress(TimeoutError):
                        async with asyncio.timeout(hold):
                            await control.until_lost()
                    control.check()
                    reason = await explained
                finally:
                    explained.cancel()
                    await asyncio.wait({explained})
            control.check()
        if control.released is False:
            raise ResponseTimeout(
                f"{to} did not acknowledge Standby and ReleaseControl: it was ended, or the connection is lost; if it "
                f"still runs, it stops when it misses its controller (access control's time-out: {control.timeout:g} s)"
            )
        if reason:
            raise RequestError(f"{command.NAME} was sent, but {reason}")


async def _ignored(client: ServiceClient, command: Message) -> str:
    """Why the component ignores the command, according to its state; empty if it may have accepted it."""
    return await client.explain(command) if needs_control(command) else ""


@asynccontextmanager
async def _commanded(client: ServiceClient, command: Message, within: float | None) -> AsyncGenerator[None, None]:
    """The command is sent; an effort, velocity or vector is repeated in the block and zero at its end."""
    if within is not None:
        await client.perform(command, within=within)
        yield
    elif command.NAME not in CONTINUOUS_COMMANDS:
        await (client.configure if _is_confirmed(command) else client.send)(command)
        yield
    else:
        async with client.streaming(REPEAT_RATE) as stream:
            await stream.send(command)
            yield


def _is_confirmed(command: Message) -> bool:
    """True for the settings of sensors, which a component confirms or refuses."""
    return ":environmentSensing:" in command.SERVICE and hasattr(command, "request_id_rec")


async def _has_management(client: ServiceClient) -> bool:
    """True if the component reports its status; one without Management has nothing to resume."""
    try:
        await client.status()
    except ResponseTimeout:
        console.note(f"{client.id} does not report a status, so it is not resumed before")
        return False
    return True
