"""The map of the drive, and how well a scan that is not in it agrees with it."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Final

import numpy as np

from jauspy.cli.demo.report import Finding
from jauspy.cli.demo.watch import Scene
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.files import save_map
from jauspy.mapping.grid import OccupancyGrid, Points, transformed
from jauspy.mapping.live import LiveMapping
from jauspy.mapping.mapper import MAX_RANGE, Mapper
from jauspy.ocu.robot import Robot

SIDE: Final = 20.0
"""Metres of the map."""
AGREES: Final = 0.9
"""Share of a scan's echoes that must be where the map has something."""
KEPT: Final = 500
"""Scans, at most, that judge the map."""


class ScanKeeper(Mapper):
    """A mapper that keeps where the rays of those scans ended that did not go into the map: they can judge it."""

    def __init__(self, grid: OccupancyGrid) -> None:
        super().__init__(grid)
        self.scans = 0
        self.others: deque[Points] = deque(maxlen=KEPT)

    def add(
        self, odometry: PlanarPose, lidar: PlanarPose, angles: Sequence[float], ranges: Sequence[float]
    ) -> PlanarPose:
        """As `Mapper`."""
        used, pose = len(self.path), super().add(odometry, lidar, angles, ranges)
        self.scans += 1
        if len(self.path) == used:
            at, far = np.asarray(angles), np.asarray(ranges)
            echoes = (far > 0.0) & (far < MAX_RANGE)
            at, far = at[echoes], far[echoes]
            self.others.append(transformed(pose @ lidar, np.column_stack([far * np.cos(at), far * np.sin(at)])))
        return pose

    def agreement(self) -> float:
        """Share of the other scans' echoes that are in, or beside, a cell where the map has something."""
        if not self.others:
            return 0.0
        taken = np.pad(self.grid.occupancy() == 100, 1)
        near = np.logical_or.reduce([np.roll(taken, (dy, dx), (0, 1)) for dy in (-1, 0, 1) for dx in (-1, 0, 1)])
        columns, rows = np.rint(self.grid.cell_coordinates(np.concatenate(list(self.others)))).astype(int).T + 1
        inside = (columns > 0) & (rows > 0) & (columns <= self.grid.cells) & (rows <= self.grid.cells)
        return float(near[rows[inside], columns[inside]].mean()) if inside.any() else 0.0


class DriveMap:
    """The map, while it is made."""

    def __init__(self, robot: Robot, scene: Scene) -> None:
        self._mapper = ScanKeeper(OccupancyGrid(SIDE))
        self._live = LiveMapping(robot, self._mapper, threaded=True)
        self._scene = scene
        self._task: asyncio.Task[None] | None = None

    @asynccontextmanager
    async def made(self) -> AsyncIterator[None]:
        """Scans go into it as long as this lasts."""
        self._task = asyncio.create_task(self._live.run())
        counting = asyncio.create_task(self._count())
        try:
            yield
        finally:
            for task in (self._task, counting):
                task.cancel()
            await asyncio.gather(self._task, counting, return_exceptions=True)  # `finish` has raised what went wrong

    async def finish(self, folder: Path) -> tuple[Finding, list[str]]:
        """Compare it with the scans that are not in it, and save it; what was found, and the files."""
        if self._task is not None and self._task.done():
            self._task.result()
        agreement = self._mapper.agreement()
        files = save_map(self._mapper.grid, folder / "map")
        known = int((self._mapper.grid.occupancy() != -1).sum()) * self._mapper.grid.resolution**2
        used = len(self._mapper.path)
        finding = Finding(
            "map",
            f"{known:.0f} m² from {used} scans; of the echoes of the {len(self._mapper.others)} others "
            f"{100 * agreement:.1f} % are where it has something",
            agreement >= AGREES,
            {"agreement": agreement, "area": known, "scans": self._mapper.scans},
        )
        return finding, [file.name for file in files]

    async def _count(self) -> None:
        while True:
            self._scene.scans = self._mapper.scans
            await asyncio.sleep(0.2)
