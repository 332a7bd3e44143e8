"""`jauspy map`: a map of where a robot drives."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jauspy.cli.options import Connect, OwnId, Timeout

if TYPE_CHECKING:
    from jauspy.mapping.grid import OccupancyGrid
    from jauspy.mapping.live import LiveMapping
    from jauspy.ocu import OCU


def map_robot(
    *,
    output: Annotated[Path, typer.Argument(metavar="OUT", help="Where to write OUT.pgm and OUT.yaml.")],
    subsystem: Annotated[
        int, typer.Option("--robot", metavar="SUBSYSTEM", min=1, max=65534, help="The robot's number.")
    ] = 101,
    sensor: Annotated[int, typer.Option("--sensor", min=1, max=65535, help="Which of its range sensors.")] = 1,
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
    """Map what a robot's lidar sees, while somebody drives it; write it as ROS's map_server does.

    It reads RangeSensor and LocalPoseSensor over JAUS, matches each scan with the map so that odometry may drift,
    and controls nothing. The map's origin is that of the local frame, x forward and y left of where it started. Scans
    on slopes are left out. Ctrl-C, or the end of --seconds, writes the map.

    Example:
      jauspy map yard --seconds 60
    """
    from jauspy.cli import addresses
    from jauspy.cli.run import run
    from jauspy.errors import ConfigError

    if find_spec("numpy") is None:
        raise ConfigError("maps need numpy: pip install 'jauspy[map]'")
    if not output.absolute().parent.is_dir():
        raise ConfigError(f"{output}: there is no folder {output.absolute().parent}; make it first")
    from jauspy.mapping.grid import OccupancyGrid

    grid = OccupancyGrid(size, resolution)
    ocu = addresses.client(own_id, connect, timeout)
    run(_map(ocu, (subsystem, sensor), grid, output, seconds))


async def _map(ocu: OCU, which: tuple[int, int], grid: OccupancyGrid, output: Path, seconds: float | None) -> None:
    """Map with a sensor of a subsystem until the time is up, or it is cancelled."""
    import asyncio
    from contextlib import suppress

    from jauspy.mapping.live import LiveMapping
    from jauspy.mapping.mapper import Mapper

    async with ocu:
        live = LiveMapping(await ocu.discover(which[0]), Mapper(grid), which[1])
        try:
            with suppress(TimeoutError):
                async with asyncio.timeout(seconds):
                    await live.run()
        finally:
            _finish(live, output)


def _finish(live: LiveMapping, output: Path) -> None:
    """Write what there is, however the mapping ended."""
    from jauspy.cli import console
    from jauspy.mapping.files import save_map

    used = live.counters.pop("scans", 0)
    lost = "".join(f"; {count} left out: {reason}" for reason, count in live.counters.items())
    picture, notes = save_map(live.mapper.grid, output)
    print(f"{picture} and {notes}: {used} scans{lost}", flush=True)
    if live.mapper.grid.outside:
        console.note(f"{live.mapper.grid.outside} ends of rays were outside of the map; --size makes it larger")
