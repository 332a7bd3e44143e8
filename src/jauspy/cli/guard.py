"""`jauspy guard`: show the guards of a robot against self collision and obstacles, and switch them."""

from __future__ import annotations

import math
from enum import StrEnum
from typing import Annotated, Final

import typer
from rich.text import Text

from jauspy.cli import client, console
from jauspy.cli.options import Connect, Json, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.ocu import OCU
from jauspy.ocu.guards import Guard

TITLES: Final = {"self_collision": "self collision", "obstacle": "obstacles"}


class Switch(StrEnum):
    """A position of a switch."""

    ON = "on"
    OFF = "off"


def guard(
    *,
    robot: Annotated[int, typer.Argument(metavar="ROBOT", min=1, max=65534, help="The robot's subsystem id.")],
    self_collision: Annotated[
        Switch | None,
        typer.Option("--self-collision", help="Stop joints before links of the robot touch each other."),
    ] = None,
    obstacles: Annotated[
        Switch | None,
        typer.Option("--obstacles", help="Stop the chassis before obstacles that its lidars and depth cameras see."),
    ] = None,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Show the guards of a robot against self collision and obstacles, or switch them.

    A guard slows down commands that would end in a contact, and stops before it. Shows whether each one is on, the
    distance to the nearest contact, and why it stopped the robot. A switch stays until it is set again, or until the
    robot starts anew. It takes control of the component with the policies for a moment.

    Examples:
      jauspy guard 101
      jauspy guard 101 --self-collision on --obstacles on
    """
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    switches = [None if switch is None else switch is Switch.ON for switch in (self_collision, obstacles)]
    for found in run(_guards(ocu, robot, timeout, *switches)) or ():
        if as_json:
            distance = found.distance if math.isfinite(found.distance) else None
            console.print_json(
                {
                    "guard": found.name,
                    "enabled": found.enabled,
                    "active": found.active,
                    "distance": distance,
                    "problem": found.problem,
                }
            )
        else:
            console.stdout().print(_line(found))


async def _guards(
    ocu: OCU, robot: int, max_wait: float, self_collision: bool | None, obstacle: bool | None
) -> list[Guard]:
    async with ocu:
        guards = (await ocu.robot(robot, timeout=max_wait)).guards
        await guards.switch(self_collision=self_collision, obstacle=obstacle)
        return await guards.observe()


def _line(guard: Guard) -> Text:
    state = "stops" if guard.problem else "slows down" if guard.active else "on" if guard.enabled else "off"
    style = "bold yellow" if guard.active else "green" if guard.enabled else "dim"
    near = f"  {guard.distance:.2f} m" if math.isfinite(guard.distance) else ""
    return Text.assemble(
        f"{TITLES.get(guard.name, guard.name):15}", (state, style), near, f"  {guard.problem}" if guard.problem else ""
    )
