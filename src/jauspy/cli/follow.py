"""`jauspy follow`: have one robot follow another."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator
from typing import Annotated, Any, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Authority, Connect, Json, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import RequestError
from jauspy.geometry.geodesy import Geodetic, to_ned
from jauspy.ids import JausID
from jauspy.messages.mobility import QueryGlobalPose, ReportGlobalPose
from jauspy.ocu import OCU, Robot

PERIOD: Final = 1.0
"""Seconds between two lines."""
POSITION: Final = 0b11
"""Presence vector of latitude and longitude."""


def follow(
    *,
    robot: Annotated[int, typer.Argument(metavar="ROBOT", min=1, max=65534, help="The subsystem id of the follower.")],
    leader: Annotated[
        str, typer.Argument(metavar="LEADER", help="The subsystem to follow, or the component that reports its pose.")
    ],
    gap: Annotated[float, typer.Option("--gap", min=0.0, metavar="METRES", help="Distance along the path.")] = 3.0,
    lag: Annotated[float, typer.Option("--lag", min=0.0, metavar="SECONDS", help="Time behind the leader, too.")] = 0.0,
    max_gap: Annotated[
        float, typer.Option("--max-gap", min=0.1, metavar="METRES", help="Distance at which following ends.")
    ] = 30.0,
    offset: Annotated[
        float, typer.Option("--offset", metavar="METRES", help="Distance to the left of the leader's path.")
    ] = 0.0,
    may_slow: Annotated[
        bool, typer.Option("--may-slow", help="Ask the leader to slow down when the gap becomes long.")
    ] = False,
    may_stop: Annotated[
        bool, typer.Option("--may-stop", help="Ask the leader to stop when following ends because of a bound.")
    ] = False,
    authority: Authority = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Have one robot follow another along its path, until Ctrl-C or until following ends.

    The verb takes control of the follower, and of nothing else: whoever drives the leader goes on. Both need
    GlobalPoseSensor; the more they err, the longer the gap becomes. Each second a line shows the distance between them.
    The follower stops when the leader is lost, when a bound is passed, and when this program ends. The leader waits for
    followers that its convoy names (--may-slow, --may-stop): see docs/convoy.md.

    Examples:
      jauspy follow 102 101 --gap 2
      jauspy follow 102 101.1.102 --lag 3 --connect udp://192.168.1.20
    """
    ahead: int | JausID = int(leader) if leader.isdecimal() else client.destination(leader)
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    options = {"gap": gap, "lag": lag, "max_gap": max_gap, "offset": offset, "may_slow": may_slow, "may_stop": may_stop}
    run(_follow(ocu, robot, ahead, options, authority, as_json=as_json))


async def _follow(
    ocu: OCU, number: int, leader: int | JausID, options: dict[str, Any], authority: int, *, as_json: bool
) -> None:
    async with ocu:
        robot = await ocu.robot(number)
        async with robot.control("drive", authority=authority) as control:
            await robot.follow(leader, **options)
            try:
                async for row in _rows(ocu, robot):
                    control.check()
                    if as_json:
                        console.print_json(row)
                    else:
                        far = row["distance"]
                        shown = "distance unknown" if far is None else f"{far:.2f} m"
                        console.print_lines(f"{number} follows {row['leader']}: {shown}")
            finally:
                await robot.stop_following()
    raise RequestError(f"{number} follows no more: the leader is lost, a bound was passed, or the robot was stopped")


async def _rows(ocu: OCU, robot: Robot) -> AsyncIterator[dict[str, Any]]:
    """The state of the follower, once a second while it follows."""
    own = robot.service("GlobalPoseSensor").id
    while (state := await robot.following()).is_following:
        far = None if state.leader is None else await _distance(ocu, own, state.leader)
        yield {"robot": robot.id, "leader": str(state.leader), "gap": state.gap, "lag": state.lag, "distance": far}
        await asyncio.sleep(PERIOD)


async def _distance(ocu: OCU, one: JausID, other: JausID) -> float | None:
    """Metres between two components that report their poses; None if one does not."""
    try:
        query = QueryGlobalPose(POSITION)
        reports = await asyncio.gather(*(ocu.query(id, query, expects=ReportGlobalPose) for id in (one, other)))
    except RequestError:
        return None
    places = [
        Geodetic(math.radians(report.latitude), math.radians(report.longitude), 0.0)
        for report in reports
        if report.latitude is not None and report.longitude is not None
    ]
    if len(places) < len(reports):
        return None
    north, east, _ = to_ned(*places)
    return round(math.hypot(north, east), 3)
