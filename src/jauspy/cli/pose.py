"""`jauspy pose`: list the named poses of a robot, or move its joints to one."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Authority, Connect, Json, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.ocu.arm import Arm
from jauspy.ocu.preset_poses import listed
from jauspy.ocu.robot import Robot


def pose(
    *,
    target: Annotated[str, typer.Argument(metavar="ID", help="A robot (101), or one component of it (101.1.104).")],
    name: Annotated[str | None, typer.Argument(metavar="[POSE]", help="The pose to move to.")] = None,
    within: Annotated[
        float, typer.Option("--within", min=0.1, metavar="SECONDS", help="How long each component may move.")
    ] = 60.0,
    authority: Authority = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 3.0,
    as_json: Json = False,
) -> None:
    """Move a robot's arm and flippers to a named pose, or list its poses.

    Without POSE the poses are listed, with the components that move, and those that are in the pose now. With POSE,
    control of these components is taken; they move one after the other, on routes without contact that the robot
    chooses, and are released. Ctrl-C stops them. Robots name their poses in their files (docs/robots.md).

    Examples:
      jauspy pose 101
      jauspy pose 101 stow
      jauspy pose 101.1.104 reach_low
    """
    robot, component = _target(target)
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    if name is None:
        rows = run(_list(ocu, robot, component, timeout)) or []
        _print(rows, as_json=as_json)
        return
    moving = _move(ocu, robot, component, name, max_wait=timeout, within=within, authority=authority)
    if (positions := run(moving)) is not None:
        if as_json:
            console.print_json({"pose": name, "joints": positions})
        else:
            console.print_lines(f"{target} is in the pose {name}")


def _target(text: str) -> tuple[int, JausID | None]:
    """The subsystem, and the component if one is named; raises `ConfigError`."""
    if text.isascii() and text.isdigit():
        return client.destination(f"{text}.1.1").subsystem, None
    component = client.destination(text)
    if component.is_wildcard:
        raise ConfigError(f"{component} has wildcards; name a robot, as in 101, or one component, as in 101.1.104")
    return component.subsystem, component


def _arms(robot: Robot, component: JausID | None, ids: tuple[JausID, ...]) -> list[Arm]:
    return [robot.manipulator(id) for id in ids if component in (None, id)]


async def _known(
    ocu: OCU, subsystem: int, component: JausID | None, max_wait: float
) -> tuple[Robot, dict[str, tuple[JausID, ...]]]:
    """The robot, and the poses of the component or of all; `ConfigError` if the robot has no such component."""
    robot = await ocu.discover(subsystem, timeout=max_wait)
    known = await robot.poses()
    if component is not None:
        robot.component(component)
        known = {name: ids for name, ids in known.items() if component in ids}
    return robot, known


async def _list(ocu: OCU, subsystem: int, component: JausID | None, max_wait: float) -> list[dict[str, Any]]:
    async with ocu:
        robot, known = await _known(ocu, subsystem, component, max_wait)
        ids = tuple(dict.fromkeys(id for components in known.values() for id in components))
        held = {arm.info.id: await arm.pose() for arm in _arms(robot, component, ids)}
    return [
        {
            "pose": name,
            "components": [str(id) for id in components if id in held],
            "held_by": [str(id) for id in components if held.get(id) == name],
        }
        for name, components in known.items()
    ]


def _print(rows: list[dict[str, Any]], *, as_json: bool) -> None:
    if as_json:
        for row in rows:
            console.print_json(row)
    elif rows:
        table = [[row["pose"], ", ".join(row["components"]), ", ".join(row["held_by"])] for row in rows]
        console.print_table(["pose", "moves", "in it now"], table)
    else:
        console.note("it knows no poses: its file names none, or it does not offer the service PresetPose")


async def _move(
    ocu: OCU,
    subsystem: int,
    component: JausID | None,
    name: str,
    *,
    max_wait: float,
    within: float,
    authority: int,
) -> dict[str, float]:
    async with ocu:
        robot, known = await _known(ocu, subsystem, component, max_wait)
        arms = _arms(robot, component, known.get(name, ()))
        if not arms:
            who = component or f"subsystem {subsystem}"
            raise ConfigError(f"{who} has no pose {name!r}; its poses are: {listed(known)}")
        async with robot.control(*(str(arm.info.id) for arm in arms), authority=authority):
            moved = arms[0].move_to(name, timeout=within) if component else robot.move_to(name, timeout=within)
            return dict((await moved).positions)
