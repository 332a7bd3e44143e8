"""Heading, pitch, roll and speed of a robot for the overlay of its video."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable
from contextlib import aclosing
from dataclasses import asdict, dataclass, replace
from typing import Final

from jauspy.codec.message import Message
from jauspy.console.reports import reports_of
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.messages.mobility import QueryGlobalPose, QueryLocalPose, QueryVelocityState
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot

RATE: Final = 5.0
"""Hz."""
RETRY_INTERVAL: Final = 2.0
"""Seconds until a component is asked again that did not answer; what it reported is unknown meanwhile."""
SOURCES: Final = (
    ("LocalPoseSensor", QueryLocalPose(), ("heading", "pitch", "roll")),
    ("GlobalPoseSensor", QueryGlobalPose(), ("heading", "pitch", "roll")),
    ("VelocityStateSensor", QueryVelocityState(), ("speed",)),
)
"""Services with the query and what its report tells; of two that tell the same, the first is asked."""
FIELDS: Final = {"heading": "yaw", "pitch": "pitch", "roll": "roll", "speed": "velocity_x"}


@dataclass(frozen=True, slots=True)
class Attitude:
    """Degrees: heading clockwise, 0..360, pitch up, roll to the right; speed in m/s forward. None is not reported."""

    heading: float | None = None
    pitch: float | None = None
    roll: float | None = None
    speed: float | None = None

    def as_dict(self) -> dict[str, float | None]:
        """For the browser."""
        return asdict(self)


class AttitudeFeed:
    """Follows the attitude of one robot while somebody looks."""

    def __init__(self, ocu: OCU, robot: Robot) -> None:
        self.attitude = Attitude()
        self._ocu = ocu
        self._robot = robot
        self._watchers: list[Callable[[Attitude], None]] = []
        self._tasks: list[asyncio.Task[None]] = []

    def add(self, watcher: Callable[[Attitude], None]) -> None:
        """Call this function now, and whenever the attitude changes."""
        self._watchers.append(watcher)
        watcher(self.attitude)
        if not self._tasks:
            self._start()

    def remove(self, watcher: Callable[[Attitude], None]) -> None:
        """Call it no more; without effect for one that is not called."""
        if watcher in self._watchers:
            self._watchers.remove(watcher)
        if not self._watchers:
            for task in self._tasks:
                task.cancel()
            self._tasks = []

    def _start(self) -> None:
        told: set[str] = set()
        for service, query, names in SOURCES:
            component = next((each for each in self._robot.components if each.find(service)), None)
            if component is None or told & set(names):
                continue
            told |= set(names)
            following = self._follow(component.id, query, names, events=component.find("Events") is not None)
            self._tasks.append(asyncio.create_task(following, name=f"console: attitude of {component.id}"))

    async def _follow(self, id: JausID, query: Message, names: tuple[str, ...], *, events: bool) -> None:
        while True:
            try:
                async with aclosing(reports_of(self._ocu, id, query, RATE, events=events)) as reports:
                    async for report in reports:
                        self._take({name: getattr(report, FIELDS[name], None) for name in names})
            except JausError:
                self._take(dict.fromkeys(names))
            await asyncio.sleep(RETRY_INTERVAL)

    def _take(self, values: dict[str, float | None]) -> None:
        new = replace(self.attitude, **{name: _shown(name, value) for name, value in values.items()})
        if new != self.attitude:
            self.attitude = new
            for watcher in list(self._watchers):
                watcher(new)


def _shown(name: str, value: float | None) -> float | None:
    """In degrees with a decimal, or m/s with two; what does not change on the screen is not sent again."""
    if value is None:
        return None
    if name == "speed":
        return round(value, 2) + 0.0
    degrees = round(math.degrees(value), 1) + 0.0
    return degrees % 360.0 if name == "heading" else degrees
