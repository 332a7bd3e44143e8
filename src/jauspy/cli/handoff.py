"""`jauspy handoff`: ask the client in control of a component to hand it over, or answer those who ask."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from enum import StrEnum
from typing import Annotated, Any, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Authority, Connect, Json, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import ConfigError, ControlRejected
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.ocu.control import Control
from jauspy.ocu.service import ServiceClient
from jauspy.printable import printable
from jauspy.services.iop.handoff import Decision, HandoffRequest

SERVICE: Final = "iop:EnhancedAccessControl"
CHECK_PERIOD: Final = 0.2
"""Seconds between two looks whether control is still held."""
HANDOVER_TIME: Final = 2.0
"""Seconds within which a component hands control over after the answer."""


class Answer(StrEnum):
    """The answer to those who ask for control."""

    GRANT = "grant"
    REFUSE = "refuse"


def handoff(
    *,
    component: Annotated[str, typer.Argument(metavar="COMPONENT", help="As in 101.1.110.")],
    reason: Annotated[str | None, typer.Argument(metavar="[REASON]", help="Why, for the one in control.")] = None,
    answer: Annotated[
        Answer | None,
        typer.Option("--answer", help="Take control instead, and give this answer to all who ask for it."),
    ] = None,
    keep: Annotated[
        float,
        typer.Option("--keep", min=0.0, max=86400.0, metavar="SECONDS", help="How long to keep what was handed over."),
    ] = 0.0,
    within: Annotated[
        float, typer.Option("--within", min=1.0, max=600.0, metavar="SECONDS", help="How long to wait for the answer.")
    ] = 90.0,
    authority: Authority = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 3.0,
    as_json: Json = False,
) -> None:
    """Ask the client in control of a component to hand it over, or answer those who ask.

    With REASON the verb asks, and waits for the decision; the component must offer EnhancedAccessControl (IOP). What is
    handed over is kept for --keep seconds, and then released. With --answer the verb takes control, prints each client
    that asks, and answers, until Ctrl-C or until it has handed over. All motion stops when control is handed over. The
    exit status is 1 if it is refused.

    Examples:
      jauspy handoff 101.1.110 "I see the door" --keep 60
      jauspy handoff 101.1.110 --answer grant
    """
    id = client.destination(component)
    if id.is_wildcard:
        raise ConfigError(f"{id} has wildcards; name one component, as in 101.1.110")
    if (reason is None) is (answer is None):
        raise ConfigError('give either a REASON, as in "I see the door", to ask, or --answer grant or refuse')
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    if answer is not None:
        run(_answer(ocu, id, answer, authority, as_json=as_json))
    elif reason is not None:
        run(_ask(ocu, id, reason, authority=authority, within=within, keep=keep, as_json=as_json))


async def _ask(ocu: OCU, id: JausID, reason: str, *, authority: int, within: float, keep: float, as_json: bool) -> None:
    async with ocu:
        service = await _service(ocu, id)
        try:
            await ocu.request_handoff(id, reason, authority=authority, within=within)
        except ControlRejected as error:
            if not as_json:
                raise
            _print({"component": str(id), "granted": False, "problem": str(error)}, as_json=True)
            raise typer.Exit(1) from None
        async with service.control(authority=authority) as control:
            _print({"component": str(id), "granted": True, "problem": ""}, as_json=as_json)
            await _hold(control, keep)


async def _service(ocu: OCU, id: JausID) -> ServiceClient:
    """The service of the component; raises `ConfigError` for one without it."""
    return (await ocu.robot(id.subsystem)).component(id).service(SERVICE)


async def _hold(control: Control, seconds: float) -> None:
    """Keep control for so long; raises `ControlRejected` when it is lost before."""
    clock = asyncio.get_running_loop().time
    end = clock() + seconds
    while clock() < end:
        control.check()
        await asyncio.sleep(min(CHECK_PERIOD, seconds))


async def _answer(ocu: OCU, id: JausID, answer: Answer, authority: int, *, as_json: bool) -> None:
    handed_over = asyncio.Event()

    def decide(component: JausID, request: HandoffRequest) -> Decision | None:
        if component != id:
            return None
        row = {"component": str(id), "client": str(request.client), "authority": request.authority}
        _print(row | {"reason": printable(request.explanation), "answer": answer.value}, as_json=as_json)
        if answer is Answer.REFUSE:
            return Decision.DENIED
        handed_over.set()
        return Decision.GRANTED

    ocu.decide_handoffs(decide)
    async with ocu, (await _service(ocu, id)).control(authority=authority) as control:
        if not as_json:
            console.note(f"in control of {id}; Ctrl-C releases it")
        while not handed_over.is_set():
            control.check()
            with suppress(TimeoutError):
                async with asyncio.timeout(CHECK_PERIOD):
                    await handed_over.wait()
        with suppress(TimeoutError):  # the answer is resent until it has arrived, before control is released
            async with asyncio.timeout(HANDOVER_TIME):
                await control.until_lost()


def _print(row: dict[str, Any], *, as_json: bool) -> None:
    if as_json:
        console.print_json(row)
    elif "client" in row:
        asked = f"{row['client']} asks with authority {row['authority']}: {row['reason'] or 'it gives no reason'}"
        console.print_lines(f"{asked}; answered: {row['answer']}")
    else:
        console.print_lines(f"{row['component']} was handed over")
