"""Depth cameras for the guard against obstacles: their processes run while it is on."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from contextlib import AsyncExitStack
from functools import partial
from typing import Final

from jauspy.beats import next_beat
from jauspy.cloud.sightings import SightingProcess, SightingStream
from jauspy.platform.guards import ObstacleGuard
from jauspy.robot.config import RobotConfig
from jauspy.robot.realtime import RealTime

CHECK_PERIOD: Final = 0.2
"""Seconds between two checks whether the guard is on."""


def sightings(config: RobotConfig, robot: RealTime) -> list[SightingProcess]:
    """A process for each depth camera of a robot that has the guard."""
    guard = ObstacleGuard.of(robot)
    return [
        SightingProcess(
            SightingStream(robot.cameras[camera.name], camera.depth.range),
            partial(guard.see, camera.name, camera.link),
        )
        for camera in config.cameras
        if guard is not None and camera.depth is not None and camera.name in robot.cameras
    ]


async def follow_guard(guard: ObstacleGuard, processes: Sequence[SightingProcess], subsystem: int) -> None:
    """Run the processes while the guard of a robot is on, until cancelled."""
    while True:
        await _until(guard, subsystem, enabled=True)
        async with AsyncExitStack() as stack:
            for process in processes:
                await stack.enter_async_context(process)
            await _until(guard, subsystem, enabled=False)


async def _until(guard: ObstacleGuard, subsystem: int, *, enabled: bool) -> None:
    clock = asyncio.get_running_loop().time
    while True:
        if guard.state().enabled is enabled:
            return
        now = clock()
        await asyncio.sleep(next_beat(now, CHECK_PERIOD, subsystem) - now)
