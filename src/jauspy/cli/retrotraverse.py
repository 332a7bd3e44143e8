"""`jauspy retrotraverse`: drive a robot back along the path by which it came."""

from __future__ import annotations

from typing import Annotated

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Authority, Connect, Json, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.ocu import OCU, RobotPose
from jauspy.ocu.comms_lost import WayBack


def retrotraverse(
    *,
    robot: Annotated[int, typer.Argument(metavar="ROBOT", min=1, max=65534, help="The robot's subsystem id.")],
    distance: Annotated[float, typer.Argument(metavar="METRES", min=0.01, max=1e6, help="How far back.")],
    speed: Annotated[
        float, typer.Option("--speed", min=0.0, max=327.0, metavar="M/S", help="At most; 0: as fast as it came.")
    ] = 0.0,
    nose_first: Annotated[
        bool, typer.Option("--nose-first", help="Turn about first, instead of driving with the headings it had.")
    ] = False,
    within: Annotated[
        float, typer.Option("--within", min=1.0, max=86400.0, metavar="SECONDS", help="How long it may take.")
    ] = 300.0,
    authority: Authority = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Drive a robot back along the path by which it came.

    The robot keeps its path while it runs (IOP's service Retrotraverse), with the positions of its flippers. It does
    not avoid what has been put in the way since. It stops when this program ends, and when the link is lost.

    The exit status is 1 if it drove less than METRES, since the path that it keeps begins there, or if it gave up.

    Examples:
      jauspy retrotraverse 101 5
      jauspy retrotraverse 101 20 --speed 0.3 --connect udp://192.168.1.20
    """
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    found = run(_drive_back(ocu, robot, distance, speed, authority, nose_first=nose_first, within=within))
    if found is None:
        return
    way, pose = found
    is_short = way.ended_by == "path"
    if as_json:
        row = {"driven": way.distance, "asked": distance, "ended_by": way.ended_by}
        console.print_json(row | {"x": pose.x, "y": pose.y, "yaw": pose.yaw})
    else:
        why = f"not {distance:g} m: the path that it keeps begins there, at" if is_short else "to"
        console.print_lines(f"the robot drove {way.distance:.2f} m back, {why} x {pose.x:.2f} m, y {pose.y:.2f} m")
    if is_short:
        raise typer.Exit(1)


async def _drive_back(
    ocu: OCU, number: int, distance: float, speed: float, authority: int, *, nose_first: bool, within: float
) -> tuple[WayBack, RobotPose]:
    async with ocu:
        robot = await ocu.robot(number)
        async with robot.control(authority=authority):
            way = await robot.retrotraverse(distance, speed=speed or None, nose_first=nose_first, timeout=within)
        return way, await robot.pose()
