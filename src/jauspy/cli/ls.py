"""`jauspy ls`: who is there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli.options import Connect, Json, OwnId

if TYPE_CHECKING:
    from jauspy.ocu import SubsystemInfo


def ls(
    *,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Annotated[
        float, typer.Option("--timeout", min=0.01, metavar="SECONDS", help="How long to listen for answers.")
    ] = 2.0,
    as_json: Json = False,
) -> None:
    """Find who answers: subsystems, nodes, components and services.

    Example:
      jauspy ls --connect udp://192.168.1.20:3794 --timeout 5
    """
    import json

    from jauspy.cli import addresses, console, tree
    from jauspy.cli.run import run
    from jauspy.errors import ResponseTimeout

    found = run(_discover(addresses.own_id(own_id, connect), connect, timeout)) or []
    for subsystem in found:
        if as_json:
            print(json.dumps(tree.as_json(subsystem), ensure_ascii=False))
        else:
            console.stdout().print(tree.tree_of(subsystem))
    if not found:
        raise ResponseTimeout(
            f"nobody answered within {timeout:g} s; start a robot (`jauspy up inc1`), or say with --connect where the "
            "node manager is"
        )


async def _discover(own_id: str, connect: str | None, patience: float) -> list[SubsystemInfo]:
    """Everybody but ourselves."""
    from jauspy.ocu import OCU

    async with OCU(own_id, connect) as ocu:
        found = await ocu.discover_all(timeout=patience)
        return [robot.info for robot in found if robot.id != ocu.id.subsystem]
