"""`jauspy estop`: set or clear the emergency of one component, one robot or all robots, and list which obeyed."""

from __future__ import annotations

from typing import Annotated, Final

import typer
from rich.text import Text

from jauspy.cli import client, console
from jauspy.cli.options import Connect, Json, OperatorKey
from jauspy.cli.processes import run
from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.ocu.control import status_name
from jauspy.ocu.emergency import Reports, obeys, set_emergency

ESTOP_ID: Final = "42.1.254"
"""The client's id, always the same: only the id that set an emergency can clear it."""
MAX_SUBSYSTEM: Final = 65534


def estop(
    *,
    target: Annotated[
        str, typer.Argument(metavar="[ID|all]", help="A component (101.1.102), a robot (101), or all.")
    ] = "all",
    release: Annotated[
        bool, typer.Option("--release", help="Clear the emergency that `jauspy estop` has set before.")
    ] = False,
    connect: Connect = None,
    own_id: Annotated[
        str,
        typer.Option(
            "--id", metavar="ID", help="This client's JAUS id; --release needs the id that set the emergency."
        ),
    ] = ESTOP_ID,
    operator_key: OperatorKey = None,
    timeout: Annotated[
        float, typer.Option("--timeout", min=0.1, metavar="SECONDS", help="How long to wait until all have stopped.")
    ] = 2.0,
    as_json: Json = False,
) -> None:
    """Stop all robots, one robot or one component, and list which have stopped.

    Sets the emergency of every component that is reached, whoever controls it. The message is sent immediately, without
    discovery, and repeated until all that answer have obeyed. Lists the status of each component that answers. The exit
    status is 0 if at least one answered, and all that answered obeyed. A client keeps control across the emergency;
    commands from before it are not resumed. Robots that require operators need a key to release.

    Examples:
      jauspy estop
      jauspy estop 101
      jauspy estop 101 --release
    """
    recipient = destination(target)
    if not release and own_id in client.ids_elsewhere(connect):  # or the node manager would refuse to stop anything
        taken, own_id = own_id, client.own_id(None, connect)
        console.note(f"{taken} is in use on another host: stopping as {own_id}; release with --id {own_id}")
    found = run(_stop(OCU(own_id, connect, operator=operator_key), recipient, release=release, max_wait=timeout)) or {}
    for id, report in sorted(found.items(), key=lambda item: int(item[0])):
        obeyed = obeys(report, release=release)
        if as_json:
            console.print_json({"id": str(id), "status": status_name(report), "obeyed": obeyed})
        else:
            state = (status_name(report), "green" if obeyed else "bold red")
            console.stdout().print(Text.assemble(str(id), "  ", state, "" if obeyed else "  did not obey"))
    if not found:
        nobody = "no component answered" if recipient.is_wildcard else f"{recipient} did not answer"
        raise ResponseTimeout(f"{nobody} within {timeout:g} s; the message was sent")
    disobedient = [str(id) for id, report in found.items() if not obeys(report, release=release)]
    if disobedient:
        why = (
            "another client has set an emergency, too, this is not the id that set it (--id), "
            "or robots require an operator's key (--operator-key)"
            if release
            else "stop the robot by other means"
        )
        raise ResponseTimeout(f"{len(disobedient)} of {len(found)} did not obey: {', '.join(disobedient)}; {why}")


def destination(text: str) -> JausID:
    """The id that `all`, a subsystem's number or an id means; raises `ConfigError` for anything else."""
    if text == "all":
        return JausID.parse("65535.255.255")
    if text.isascii() and text.isdigit():
        if not 1 <= int(text) <= MAX_SUBSYSTEM:
            raise ConfigError(f"{text} is not the number of a subsystem; it is 1..{MAX_SUBSYSTEM}, as in 101")
        return JausID.parse(f"{text}.255.255")
    return client.destination(text)


async def _stop(ocu: OCU, to: JausID, *, release: bool, max_wait: float) -> Reports:
    async with ocu:
        return await set_emergency(ocu, to, release=release, within=max_wait)
