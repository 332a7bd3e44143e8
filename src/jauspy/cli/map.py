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

if TYPE_CHECKING:
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
    size: Annotated[float, typer.Option("--size", min=1.0, metavar="METRES", help="Side of the mapped square.")] = 40.0,
    resolution: Annotated[
        float, typer.Option("--resolution", min=0.01, metavar="METRES", help="Side of a cell.")
    ] = 0.05,
    connect: Connect = None,
    own_id: OwnId = None,
    timeout: Timeout = 5.0,
) -> None:
    """Map with a robot's lidar while the robot is driven, and write the map in the format of ROS's map_server.

    The verb subscribes to RangeSensor and LocalPoseSensor and takes no control. Each scan is matched with the map, to
    compensate for drifting odometry. The map's origin is that of the local frame: where the robot started, x forward, y
    left. Scans taken on slopes are not used. The map is written at Ctrl-C or after --seconds.

    Example:
      jauspy map yard --seconds 60
    """
    if (where is None) == (output is None):
        raise typer.BadParameter("give OUT once: where to write OUT.pgm and OUT.yaml", param_hint="OUT")
    path = output or where
    assert path is not None
    if find_spec("numpy") is None:
        raise ConfigError("maps need numpy: pip install 'jauspy[map]'")
    if not path.absolute().parent.is_dir():
        raise ConfigError(f"{path}: the directory {path.absolute().parent} does not exist")
    from jauspy.mapping.grid import OccupancyGrid

    grid = OccupancyGrid(size, resolution)
    ocu = client.make_ocu(own_id, connect, timeout)
    run(_map(ocu, (subsystem, sensor), grid, path, seconds))


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
    from jauspy.mapping.grid import save_map

    used = live.counters.pop("scans", 0)
    lost = "".join(f"; {count} not used: {reason}" for reason, count in live.counters.items())
    picture, notes = save_map(live.mapper.grid, output)
    console.print_lines(f"{picture} and {notes}: {used} scans{lost}")
    if live.mapper.grid.outside:
        console.note(f"{live.mapper.grid.outside} echoes were outside of the map; --size enlarges it")
