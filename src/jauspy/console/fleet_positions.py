"""Where all robots are, for one map: their frames on the globe, and their poses in the frame of another one."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final

from jauspy.console.geographic_frame import GeographicFrame, find_frame
from jauspy.geometry.geodesy import Geodetic
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

INTERVAL: Final = 0.5
"""Seconds between two queries of each robot."""
MAX_ROBOTS: Final = 32
OLD: Final = 5.0
"""Seconds after which a pose is not shown any more."""
WEIGHT: Final = 0.05
"""Share of a new measurement in a frame: positions of satellites are uncertain by metres."""
JUMP: Final = 10.0
"""Metres of difference with which a frame counts as another one, as after a restart of the robot."""


@dataclass(slots=True)
class _Place:
    name: str
    pose: tuple[float, float, float]
    frame: GeographicFrame | None
    heard: float


class FleetPositions:
    """Asks while somebody watches; `start` and `close` may be called several times."""

    def __init__(self, ocu: OCU, robots: Callable[[], Mapping[int, Robot]]) -> None:
        self._ocu, self._robots = ocu, robots
        self._places: dict[int, _Place] = {}
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Ask from now on."""
        if self._task is None:
            self._task = asyncio.create_task(self._run(), name="console: positions of robots")

    async def close(self) -> None:
        """Stop asking."""
        task, self._task = self._task, None
        if task is not None:
            task.cancel()
            await asyncio.wait({task})
        self._places = {}

    def frame(self, subsystem: int) -> GeographicFrame | None:
        """The frame of a robot on the globe, if it reports both poses."""
        place = self._places.get(subsystem)
        return None if place is None else place.frame

    def others(self, subsystem: int) -> list[tuple[int, str, float, float, float]]:
        """Number, name, x, y (metres) and yaw (radians) of the other robots, in the frame of this one."""
        own, now = self.frame(subsystem), asyncio.get_running_loop().time()
        if own is None:
            return []
        found = []
        for number, place in self._places.items():
            if number == subsystem or place.frame is None or now - place.heard > OLD:
                continue
            x, y = own.to_local(*place.frame.to_globe(*place.pose[:2]))
            yaw = math.remainder(own.heading - place.frame.heading + place.pose[2], math.tau)
            found.append((number, place.name, round(x, 2), round(y, 2), round(yaw, 3)))
        return found

    def for_browser(self, subsystem: int) -> dict[str, Any]:
        """The frame on the globe (radians), and the other robots in it, as JSON."""
        frame = self.frame(subsystem)
        if frame is None:
            return {}
        place = (frame.origin.latitude, frame.origin.longitude, frame.heading)
        return {"geo": [round(value, 10) for value in place], "others": self.others(subsystem)}

    async def _run(self) -> None:
        while True:
            robots = list(self._robots().values())[:MAX_ROBOTS]
            await asyncio.gather(*(self._ask(robot) for robot in robots))
            self._places = {each.id: self._places[each.id] for each in robots if each.id in self._places}
            await asyncio.sleep(INTERVAL)

    async def _ask(self, robot: Robot) -> None:
        frame, pose = await find_frame(self._ocu, robot)
        if pose is None:
            return
        before = self._places.get(robot.id)
        known = None if before is None else before.frame
        if frame is not None and known is not None:
            frame = blended(known, frame)
        self._places[robot.id] = _Place(printable(robot.name), pose, frame or known, asyncio.get_running_loop().time())


def blended(known: GeographicFrame, measured: GeographicFrame) -> GeographicFrame:
    """The known frame, moved a little to the measured one; the measured one if they are far apart."""
    latitude, longitude = math.degrees(measured.origin.latitude), math.degrees(measured.origin.longitude)
    if math.hypot(*known.to_local(latitude, longitude)) > JUMP:
        return measured

    def mean(old: float, new: float) -> float:
        return old + WEIGHT * math.remainder(new - old, math.tau)

    origin = Geodetic(
        mean(known.origin.latitude, measured.origin.latitude), mean(known.origin.longitude, measured.origin.longitude)
    )
    return GeographicFrame(origin, mean(known.heading, measured.heading))
