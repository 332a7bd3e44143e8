"""Emergency stops and releases of all browsers: a stop waits for nothing, and no release undoes it.

A stop and a release are both repeated until all components obey, and both have the id of the console. A release that
went on beside a stop would therefore clear what the stop has just set.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable
from typing import Final

from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.ocu.emergency import Reports, set_emergency

STOP_TIME: Final = 1.0
"""Seconds in which a stop or a release is repeated until all obey."""


class Emergencies:
    """Sets and clears emergencies by this OCU. A target is the number of a robot, or `all`."""

    def __init__(self, ocu: OCU) -> None:
        self._ocu = ocu
        self._stops: dict[asyncio.Task[Reports], str] = {}
        self._releases: set[asyncio.Task[Reports]] = set()

    def is_stopping(self, target: str) -> bool:
        """True while a stop of this target is repeated. No release begins before its end."""
        return target in self._stops.values()

    def end_releases(self) -> None:
        """End all releases, also those that wait."""
        for release in self._releases:
            release.cancel()

    def stop(self, target: str) -> Awaitable[Reports]:
        """Set the emergency, from now on; await the last status of each component that answered."""
        self.end_releases()
        stop = set_emergency(self._ocu, destination(target), within=STOP_TIME)
        task = asyncio.create_task(stop, name=f"console: stop of {target}")
        self._stops[task] = target
        task.add_done_callback(self._stops.pop)
        return asyncio.shield(task)

    async def release(self, target: str) -> Reports | None:
        """Clear the emergency, after the stops that are under way; None if another stop has come meanwhile."""
        task = asyncio.create_task(self._release(target), name=f"console: release of {target}")
        self._releases.add(task)
        task.add_done_callback(self._releases.discard)
        await asyncio.wait({task})
        return None if task.cancelled() else task.result()

    async def _release(self, target: str) -> Reports:
        while self._stops:
            await asyncio.wait(list(self._stops))
        return await set_emergency(self._ocu, destination(target), release=True, within=STOP_TIME)


def destination(target: str) -> JausID:
    """All components of the robot with this number, or those of all robots for `all`."""
    return JausID(int(target), 255, 255) if target.isdecimal() else JausID(65535, 255, 255)
