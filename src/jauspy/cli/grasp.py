"""`jauspy grasp`: find a thing, grasp and lift it, and put it down."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Authority, Connect, Json, OperatorKey, OwnId, Timeout, numbers_of
from jauspy.cli.planner import (
    ArmArgument,
    Choices,
    Clouds,
    Description,
    Primitives,
    Unknown,
    arm_id,
    need_packages,
    surroundings_of,
)
from jauspy.cli.processes import run
from jauspy.cli.scene import UnknownSpace
from jauspy.ocu import OCU

if TYPE_CHECKING:
    from jauspy.geometry.vectors import Vector
    from jauspy.planning.objects import Wanted


def grasp(
    *,
    target: ArmArgument,
    object: Annotated[
        str | None,
        typer.Option(
            "--object", metavar="NAME", help="A known thing: can, box, bottle, cup, bar or ball.", show_default=False
        ),
    ] = None,
    colour: Annotated[
        str | None,
        typer.Option(
            "--colour",
            metavar="COLOUR",
            help="Colour of the thing: red, orange, yellow, green, blue or purple.",
            show_default=False,
        ),
    ] = None,
    at: Annotated[
        str | None,
        typer.Option(
            "--at", metavar="X,Y,Z", help="Where the thing is, in metres from the robot's base.", show_default=False
        ),
    ] = None,
    place: Annotated[
        str | None,
        typer.Option(
            "--place",
            metavar="X,Y,Z",
            help="Point of a surface on which it is put down, in metres from the robot's base.",
            show_default=False,
        ),
    ] = None,
    look_only: Annotated[bool, typer.Option("--look-only", help="Find the thing, and do not grasp it.")] = False,
    description: Description = None,
    primitives: Primitives = None,
    unknown: Unknown = UnknownSpace.FREE,
    cloud: Clouds = None,
    authority: Authority = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Grasp a thing that the robot's depth cameras see: look, plan, approach, close, lift, and check that it holds.

    The thing is named, or given by colour or place. The arm looks for it with the depth camera that it carries. It is
    held when the fingers are as far apart as it is wide, and when the wrist feels its weight. With --place it is then
    put on a surface; otherwise the arm stays lifted with it. Ctrl-C stops the arm.

    Examples:
      jauspy grasp 101.1.104 --object can --cloud tcp://127.0.0.1:5566
      jauspy grasp 101.1.104 --colour green --place 0.8,0.3,0.3 --cloud tcp://127.0.0.1:5566
    """
    choices = Choices(arm_id(target), description, primitives, unknown, cloud or (), True, authority, timeout)
    need_packages()
    from jauspy.planning.objects import Wanted

    wanted = Wanted(object or "", colour or "", _point(at, "--at"))
    goal = _point(place, "--place")
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    row = run(_grasp(ocu, wanted, goal, choices, look_only=look_only))
    if row is None:
        return
    if as_json:
        console.print_json(row)
    elif look_only:
        console.print_lines(f"the thing is there: {row['thing']}")
    else:
        weight = "" if row["weight"] is None else f", {row['weight']:.2f} kg"
        console.print_lines(f"the thing {'was placed' if row['placed'] else 'is held'}: {row['thing']}{weight}")


async def _grasp(ocu: OCU, wanted: Wanted, goal: Vector | None, choices: Choices, *, look_only: bool) -> dict[str, Any]:
    from jauspy.planning.grasping import grasping

    async with ocu:
        robot = await ocu.discover(choices.arm.subsystem, timeout=choices.max_wait)
        robot.component(choices.arm)
        model, surroundings = surroundings_of(robot, choices)
        async with grasping(
            robot, choices.arm, model, surroundings, authority=choices.authority, tell=console.note
        ) as steps:
            thing = await steps.look(wanted)
            row: dict[str, Any] = {
                "thing": str(thing),
                "colour": thing.colour,
                "centre": [round(value, 4) for value in thing.centre],
                "size": [round(value, 4) for value in thing.size],
                "support": round(thing.support.at(*thing.centre[:2]), 4),
            }
            if look_only:
                return row
            held = await steps.grasp(thing)
            row |= {
                "width": round(held.width, 4),
                "weight": None if held.weight is None else round(held.weight, 3),
                "lifted": round(held.lifted, 4),
                "pitch": round(math.degrees(held.candidate.pitch), 1),
                "placed": False,
            }
            if goal is not None:
                await steps.place(held, goal)
                row["placed"] = True
            return row


def _point(text: str | None, option: str) -> Vector | None:
    if text is None:
        return None
    x, y, z = numbers_of(text, option, "x,y,z in metres", "0.8,0.1,0.3")
    return x, y, z
