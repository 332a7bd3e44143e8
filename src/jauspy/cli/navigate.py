"""`jauspy navigate`: drive a robot to a point, around what its sensors see."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Authority, Connect, Json, OperatorKey, OwnId, Timeout, numbers_of
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.geometry.poses import PlanarPose
from jauspy.ocu import OCU, Robot
from jauspy.printable import printable
from jauspy.user_files import check_folder_of

if TYPE_CHECKING:
    from jauspy.planning.navigator import NavigationProgress, Navigator
    from jauspy.planning.path_search import Path as Way
    from jauspy.platform.description import RobotModel
    from jauspy.robot.config import RobotConfig

LINE_INTERVAL: Final = 1.0
"""Seconds between two lines."""
EXTRAS: Final = ("numpy", "scipy")


def navigate(
    *,
    robot: Annotated[int, typer.Argument(metavar="ROBOT", min=1, max=65534, help="The robot's subsystem id.")],
    to: Annotated[
        str,
        typer.Option(
            "--to", metavar="X,Y", help="The goal: metres forward and left of where it started, or those of --map."
        ),
    ],
    speed: Annotated[float, typer.Option("--speed", min=0.05, max=327.0, metavar="M/S", help="At most.")] = 0.5,
    within: Annotated[
        float, typer.Option("--within", min=1.0, max=86400.0, metavar="SECONDS", help="How long it may take.")
    ] = 600.0,
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Show the way, and do not drive.")] = False,
    known_only: Annotated[
        bool, typer.Option("--known-only", help="Do not drive where nothing has been seen yet.")
    ] = False,
    file: Annotated[
        Path | None,
        typer.Option(
            "--robot-file", metavar="TOML", help="The robot's file. Default: that of its name, if it comes with jauspy."
        ),
    ] = None,
    known: Annotated[
        Path | None,
        typer.Option("--map", metavar="YAML", help="Begin with a map that `jauspy map`, or --save-map, has written."),
    ] = None,
    start: Annotated[
        str | None,
        typer.Option(
            "--start",
            metavar="X,Y,DEGREES",
            help="Where the robot is in it, to half a metre and 20 degrees. Default: its local pose.",
        ),
    ] = None,
    save: Annotated[
        Path | None,
        typer.Option(
            "--save-map", metavar="OUT", help="Write the map to OUT.pgm and OUT.yaml when the drive has ended."
        ),
    ] = None,
    size: Annotated[
        float, typer.Option("--size", min=5.0, max=100.0, metavar="METRES", help="Side of the map.")
    ] = 40.0,
    sensor: Annotated[int, typer.Option("--sensor", min=1, max=65535, help="The id of the range sensor.")] = 1,
    cloud: Annotated[
        list[str] | None,
        typer.Option(
            "--cloud",
            metavar="ADDRESS",
            help="An address at which the robot publishes clouds; several. Default: those of its file.",
        ),
    ] = None,
    report_id: Annotated[
        str | None,
        typer.Option("--report-id", metavar="ID", help="Report way and cost map as this component, such as 101.1.131."),
    ] = None,
    authority: Authority = 127,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 5.0,
    as_json: Json = False,
) -> None:
    """Drive a robot to a point, around what its sensors see.

    The way is planned on a map of the robot's lidar, and of the heights of the ground that depth cameras and lidars of
    several layers see (--cloud), for the robot's width, and sent as a list of waypoints (LocalWaypointListDriver). What
    appears on the way leads to another one; without any, the robot stops. It is slow at steps, and does not drive where
    its tracks would slip or where it would tip over. Where nothing has been seen yet it may drive, unless --known-only.
    Turn on guarded teleop, too (`jauspy guard`).

    A map is forgotten when the verb ends, unless --save-map writes it; the next drive begins with it by --map. Its
    frame is that of the first drive.

    Examples:
      jauspy navigate 101 --to 6,-2 --cloud tcp://127.0.0.1:5566
      jauspy navigate 101 --to 6,-2 --map house.yaml --start 2,0,90 --save-map house
      jauspy navigate 101 --to 6,-2 --dry-run --json
    """
    if missing := [name for name in EXTRAS if find_spec(name) is None]:
        raise ConfigError(f"navigate needs {' and '.join(missing)}: pip install 'jauspy[planning]'")
    x, y = numbers_of(to, "--to", "x,y in metres", "6,-2")
    goal = x, y
    if start is not None and known is None:
        raise typer.BadParameter("is a place in a map: give --map, too", param_hint="--start")
    if save is not None:
        check_folder_of(save)
    ocu = client.make_ocu(own_id, connect, timeout, operator=operator_key)
    options = {"size": size, "sensor": sensor, "allow_unknown": not known_only} | _begin(known, start, size)
    shown = _Shown(as_json=as_json)
    where = (robot, file, report_id, connect, cloud)
    if dry_run:
        run(_show(ocu, where, goal, options, shown))
    else:
        run(_drive(ocu, where, goal, options, shown, speed=speed, within=within, authority=authority, save=save))


def _begin(known: Path | None, start: str | None, size: float) -> dict[str, Any]:
    """The options of a map that was made before, and of the place of the robot in it."""
    if known is None:
        return {}
    from jauspy.mapping.known_map import load_map

    if start is None:
        return {"known": load_map(known, size), "start": None}
    x, y, degrees = numbers_of(start, "--start", "x,y in metres and the heading in degrees", "2,0,90")
    return {"known": load_map(known, size), "start": PlanarPose(x, y, math.radians(degrees))}


_Where = tuple[int, Path | None, str | None, str | None, list[str] | None]
"""The robot's number and file, the id of the component that reports, the node manager's address, and clouds."""


class _Shown:
    """Prints the way and the progress along it."""

    def __init__(self, *, as_json: bool) -> None:
        self._as_json = as_json
        self._due = 0.0
        self._plans = 0

    def way(self, way: Way) -> None:
        """Print a way that is not driven."""
        points = [[round(point.x, 2), round(point.y, 2)] for point in way.points]
        if self._as_json:
            console.print_json(
                {"length": round(way.length, 2), "search_time": round(way.search_time, 3), "points": points}
            )
            return
        places = " ".join(f"({x:g}, {y:g})" for x, y in points)
        console.print_lines(f"{way.length:.1f} m, found in {1000.0 * way.search_time:.0f} ms: {places}")

    def progress(self, progress: NavigationProgress) -> None:
        """Print a line a second, and one for each new way."""
        is_new = progress.plans != self._plans
        if progress.elapsed < self._due and not is_new:
            return
        self._due, self._plans = progress.elapsed + LINE_INTERVAL, progress.plans
        if self._as_json:
            row: dict[str, Any] = {
                "left": round(progress.left, 2),
                "elapsed": round(progress.elapsed, 1),
                "x": round(progress.pose.x, 2),
                "y": round(progress.pose.y, 2),
                "ways": progress.plans,
            }
            console.print_json(row)
            return
        new = f"; way {progress.plans}" if is_new else ""
        console.print_lines(f"{progress.left:.1f} m left after {progress.elapsed:.0f} s{new}")

    def arrived(self, x: float, y: float, elapsed: float) -> None:
        """Print where the robot stands."""
        if self._as_json:
            console.print_json({"x": round(x, 3), "y": round(y, 3), "elapsed": round(elapsed, 1), "arrived": True})
        else:
            console.print_lines(f"the robot is at x {x:.2f} m, y {y:.2f} m after {elapsed:.0f} s")


async def _show(ocu: OCU, where: _Where, goal: tuple[float, float], options: dict[str, Any], shown: _Shown) -> None:
    async with ocu:
        robot = await ocu.robot(where[0])
        async with _navigator(robot, where, options) as navigator:
            shown.way(await navigator.plan(*goal))


async def _drive(
    ocu: OCU,
    where: _Where,
    goal: tuple[float, float],
    options: dict[str, Any],
    shown: _Shown,
    *,
    speed: float,
    within: float,
    authority: int,
    save: Path | None,
) -> None:
    from jauspy.mapping.map_files import save_map

    clock = asyncio.get_running_loop().time
    async with ocu:
        robot = await ocu.robot(where[0])
        async with robot.control(authority=authority), _navigator(robot, where, options, speed) as navigator:
            began = clock()
            try:
                pose = await navigator.go_to(*goal, timeout=within, progress=shown.progress)
            finally:
                if save is not None:
                    save_map(navigator.map.grid, save)
            here = navigator.map.to_map(PlanarPose(pose.x, pose.y, pose.yaw))
            shown.arrived(here.x, here.y, clock() - began)


@asynccontextmanager
async def _navigator(
    robot: Robot, where: _Where, options: dict[str, Any], speed: float = 0.5
) -> AsyncIterator[Navigator]:
    """The navigator of a robot, which maps, and reports if that was asked for."""
    from jauspy.component import Component
    from jauspy.planning.driving_map import DrivingMap, heights_of_clouds
    from jauspy.planning.navigator import Navigator
    from jauspy.planning.path_services import navigation_services

    _, file, report_id, connect, given = where
    config, model = _described(robot, file)
    clouds = given or [source.address for source in config.clouds]
    heights = heights_of_clouds(robot, config, model, clouds) if clouds else None
    async with DrivingMap(robot, heights=heights, **options) as surroundings:
        navigator = Navigator(robot, model, surroundings, speed=speed)
        if report_id is None:
            yield navigator
            return
        services = navigation_services(navigator)
        async with Component(report_id, services, name=f"navigator of {robot.id}", connect=connect):
            yield navigator


def _described(robot: Robot, file: Path | None) -> tuple[RobotConfig, RobotModel]:
    from jauspy.robot import robot_files

    if file is None and robot.name not in robot_files.known():
        raise ConfigError(
            f"the shape of {robot.id} ({printable(robot.name)}) is not known here; give --robot-file, as in robot.toml"
        )
    config = robot_files.load(file or robot.name)
    return config, robot_files.robot_model(config)
