"""`jauspy map`: map with a robot's lidar while the robot is driven."""

from __future__ import annotations

import asyncio
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Connect, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import ConfigError
from jauspy.ocu import OCU
from jauspy.robot import robot_files
from jauspy.robot.config import RobotConfig
from jauspy.robot.robot_files import robot_model
from jauspy.user_files import check_folder_of

if TYPE_CHECKING:
    from jauspy.mapping.elevation import ElevationGrid
    from jauspy.mapping.grid import OccupancyGrid
    from jauspy.mapping.live import LiveMapping


def map_robot(
    *,
    where: Annotated[
        Path | None, typer.Argument(metavar="[OUT]", help="Where to write OUT.pgm and OUT.yaml.", show_default=False)
    ] = None,
    output: Annotated[Path | None, typer.Option("-o", "--output", metavar="OUT", help="The same as an option.")] = None,
    subsystem: Annotated[
        int, typer.Option("--robot", metavar="SUBSYSTEM", min=1, max=65534, help="The robot's subsystem id.")
    ] = 101,
    sensor: Annotated[int, typer.Option("--sensor", min=1, max=65535, help="The id of the range sensor.")] = 1,
    seconds: Annotated[
        float | None, typer.Option("--seconds", min=0.1, help="How long to map. Default: until Ctrl-C.")
    ] = None,
    size: Annotated[
        float | None, typer.Option("--size", min=1.0, metavar="METRES", help="Side of the mapped square. Default: 40.")
    ] = None,
    resolution: Annotated[
        float | None, typer.Option("--resolution", min=0.01, metavar="METRES", help="Side of a cell. Default: 0.05.")
    ] = None,
    elevation: Annotated[
        bool, typer.Option("--elevation", help="Map the height of the ground around the robot, from --cloud.")
    ] = False,
    clouds: Annotated[
        list[str] | None,
        typer.Option("--cloud", metavar="ADDRESS", help="An address at which the robot publishes clouds; several."),
    ] = None,
    model: Annotated[
        str, typer.Option("--model", metavar="ROBOT", help="With --elevation, the robot's name or .toml file.")
    ] = "inc1",
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 5.0,
) -> None:
    """Map with a robot's lidar while the robot is driven, and write the map in the format of ROS's map_server.

    The verb subscribes to RangeSensor and LocalPoseSensor and takes no control. Each scan is matched with the map, to
    compensate for drifting odometry. The map's origin is that of the local frame: where the robot started, x forward, y
    left. Scans taken on slopes are not used. The map is written at Ctrl-C or after --seconds.

    With --elevation it is a grid of heights, from the clouds of depth cameras and lidars of several layers, that moves
    with the robot: OUT.png is a picture (steps are red), OUT.npz has heights, slopes, steps, roughness and ages. Its
    default sizes are 12 and 0.1 m.

    Examples:
      jauspy map yard --seconds 60
      jauspy map ground --elevation --cloud tcp://127.0.0.1:5566 --seconds 20
    """
    if (where is None) == (output is None):
        raise typer.BadParameter("give OUT once: where to write OUT.pgm and OUT.yaml", param_hint="OUT")
    path = output or where
    assert path is not None
    if find_spec("numpy") is None:
        raise ConfigError("maps need numpy: pip install 'jauspy[map]'")
    check_folder_of(path)
    if elevation != bool(clouds):
        raise ConfigError(
            "--elevation and --cloud ADDRESS belong together: heights are those of the clouds published there"
        )
    if elevation:
        _map_elevation(
            path,
            robot_files.load(model),
            (subsystem, clouds or []),
            (size, resolution),
            (own_id, connect, timeout, seconds),
        )
        return
    from jauspy.mapping.grid import OccupancyGrid

    grid = OccupancyGrid(size or 40.0, resolution or 0.05)
    ocu = client.make_ocu(own_id, connect, timeout)
    run(_map(ocu, (subsystem, sensor), grid, path, seconds))


def _map_elevation(
    path: Path,
    config: RobotConfig,
    source: tuple[int, list[str]],
    cells: tuple[float | None, float | None],
    connection: tuple[str | None, str | None, float, float | None],
) -> None:
    """Map heights of the subsystem and its clouds, `source`; `connection`: id, address, timeout and seconds."""
    from jauspy.mapping.elevation import ElevationGrid

    own_id, connect, timeout, seconds = connection
    grid = ElevationGrid(cells[0] or 12.0, cells[1] or 0.1)
    run(_add_clouds(client.make_ocu(own_id, connect, timeout), config, source, grid, (path, seconds, timeout)))


async def _add_clouds(
    ocu: OCU,
    config: RobotConfig,
    source: tuple[int, list[str]],
    grid: ElevationGrid,
    output: tuple[Path, float | None, float],
) -> None:
    """Add clouds until cancelled, and write the files; `output`: path, seconds to map and to wait for the robot."""
    from jauspy.mapping.elevation_files import save_elevation
    from jauspy.mapping.live_elevation import LiveElevation

    path, seconds, max_wait = output
    async with ocu:
        live = LiveElevation(
            await ocu.discover(source[0], timeout=max_wait), config, robot_model(config), grid, source[1]
        )
        try:
            with suppress(TimeoutError):
                async with asyncio.timeout(seconds):
                    await live.run()
        finally:
            used, own = (live.counters.pop(name, 0) for name in ("clouds", "own points"))
            lost = "".join(f"; {count} not used: {reason}" for reason, count in live.counters.items() if count)
            picture, arrays = save_elevation(grid, path)
            console.print_lines(f"{picture} and {arrays}: {used} clouds, {own} points of the robot left out{lost}")


async def _map(ocu: OCU, which: tuple[int, int], grid: OccupancyGrid, output: Path, seconds: float | None) -> None:
    """Map for that many seconds, or until cancelled."""
    from jauspy.mapping.live import LiveMapping
    from jauspy.mapping.mapper import Mapper

    async with ocu:
        live = LiveMapping(await ocu.discover(which[0]), Mapper(grid), which[1])
        try:
            with suppress(TimeoutError):
                async with asyncio.timeout(seconds):
                    await live.run()
        finally:
            _write(live, output)


def _write(live: LiveMapping, output: Path) -> None:
    """Write the map."""
    from jauspy.mapping.map_files import save_map

    used = live.counters.pop("scans", 0)
    lost = "".join(f"; {count} not used: {reason}" for reason, count in live.counters.items())
    picture, notes = save_map(live.mapper.grid, output)
    console.print_lines(f"{picture} and {notes}: {used} scans{lost}")
    if live.mapper.grid.outside:
        console.note(f"{live.mapper.grid.outside} echoes were outside of the map; --size enlarges it")
