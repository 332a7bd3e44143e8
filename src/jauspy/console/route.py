"""The waypoints of one robot: the list that the robot holds, read over JAUS, and the commands that change it."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final

from jauspy.codec.message import Message
from jauspy.console.languages import sentence
from jauspy.errors import ConfigError, JausError
from jauspy.messages.core import QueryElementList, ReportElementList
from jauspy.messages.mobility import SetLocalWaypoint
from jauspy.ocu import OCU
from jauspy.ocu.driving import TOLERANCE
from jauspy.ocu.lists import Element, Elements
from jauspy.ocu.robot import Robot
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.state import RobotPose

LIST_DRIVER: Final = "mobility:LocalWaypointListDriver"
LOOK_INTERVAL: Final = 0.5
"""Seconds between two queries of the active element and the elements' numbers."""
READ_INTERVAL: Final = 5.0
"""Seconds after which all elements are read again: another client may have changed one in place."""
NEAR: Final = TOLERANCE + 0.1
"""Metres from a waypoint up to which a robot that has stopped is there: it rolls on, and its pose is a moment old."""
MAX_WAYPOINTS: Final = 100
"""Waypoints of a list that can be shown and edited."""


@dataclass(frozen=True, slots=True)
class Waypoint:
    """A point of the robot's local frame: metres, x forward and y left of where it started."""

    x: float
    y: float
    element: Element | None = None
    """The robot's element; None for a waypoint that was not sent."""
    is_point: bool = True
    """False for an element of another kind, which is kept as it is."""

    def moved(self, x: float, y: float) -> Waypoint:
        """A copy at another point, with the same tolerance and heading."""
        return replace(self, x=x, y=y) if self.is_point else self

    def message(self) -> Element:
        """The element of the list."""
        if self.element is None:
            return SetLocalWaypoint(x=self.x, y=-self.y, waypoint_tolerance=TOLERANCE)
        if isinstance(self.element, Message) and self.is_point:
            return type(self.element).from_dict(self.element.to_dict() | {"x": self.x, "y": -self.y})
        return self.element


def waypoint_of(element: Element) -> Waypoint:
    """The waypoint that an element is."""
    x, y = getattr(element, "x", None), getattr(element, "y", None)
    if getattr(element, "NAME", "").startswith("SetLocalWaypoint") and x is not None and y is not None:
        return Waypoint(x, -y + 0.0, element)
    return Waypoint(0.0, 0.0, element, is_point=False)


class Route:
    """The list of one robot; `robot` returns its last discovery, `pose` its pose.

    `look` reads, the other methods command.
    """

    def __init__(
        self, ocu: OCU, robot: Callable[[], Robot | None], pose: Callable[[], RobotPose | None] = lambda: None
    ) -> None:
        self.waypoints: tuple[Waypoint, ...] = ()
        """The waypoints that the robot holds."""
        self.active: int | None = None
        """The index of the active waypoint."""
        self.began_at: tuple[float, float] | None = None
        """The robot's position when the active waypoint became active."""
        self.ended_at = -1
        """The index of the waypoint at which or before which execution ended; -1 before that, and after a change."""
        self.has_arrived = False
        """True if the robot was there when execution ended, or if its pose was not known."""
        self.speed: float | None = None
        """m/s at which it drives; 0 while it waits, None when it does not report the speed."""
        self.problem = ""
        """Why the list is unknown."""
        self._ocu = ocu
        self._robot = robot
        self._where = pose
        self._uids: list[int] | None = None
        self._read_at = -math.inf
        self._looked_at = -math.inf
        self._looking = asyncio.Lock()

    @property
    def is_offered(self) -> bool:
        """True for a robot that takes a list of local waypoints."""
        robot = self._robot()
        return robot is not None and any(component.find(LIST_DRIVER) for component in robot.components)

    @property
    def is_paused(self) -> bool:
        """True while the list is executed at speed zero."""
        return self.active is not None and self.speed == 0.0

    @property
    def pose(self) -> RobotPose | None:
        """The robot's last pose."""
        return self._where()

    async def look(self) -> None:
        """Read changes; several browsers share one query in `LOOK_INTERVAL`. Never raises a `JausError`."""
        clock = asyncio.get_running_loop().time
        async with self._looking:
            if clock() - self._looked_at < LOOK_INTERVAL or not self.is_offered:
                return
            try:
                await self._look(clock())
                self.problem = ""
            except JausError as error:
                self.problem = str(error)
            self._looked_at = clock()

    async def _look(self, now: float) -> None:
        service = self._service()
        active, listed, speed = await asyncio.gather(
            service.query(service.message("QueryActiveElement")()),
            self._ocu.query(service.id, QueryElementList(), expects=ReportElementList),
            _speed(service),
        )
        uids = [element.element_uid for element in listed.element_list]
        if uids != self._uids or now - self._read_at > READ_INTERVAL:
            if len(uids) > MAX_WAYPOINTS:
                raise ConfigError(
                    sentence(
                        "the robot holds {count} waypoints; {most} can be shown",
                        count=len(uids),
                        most=MAX_WAYPOINTS,
                    )
                )
            elements = await service.waypoints.read() if uids else []
            self.waypoints = tuple(map(waypoint_of, elements))
            if uids != self._uids:
                self.ended_at = -1
            self._uids, self._read_at = uids, now
        uid: int = active.element_uid
        before, self.active = self.active, uids.index(uid) if uid in uids[: len(self.waypoints)] else None
        if self.active is not None:
            self.ended_at = -1
            if self.active != before:
                pose = self._where()
                self.began_at = None if pose is None else (pose.x, pose.y)
        elif before is not None:
            self.ended_at, self.has_arrived = self._end_of(before)
        self.speed = speed

    def _end_of(self, active: int) -> tuple[int, bool]:
        """The waypoint at which execution ended, or on the way to which: a short last leg falls between two looks."""
        pose = self._where()
        if pose is None:
            return active, True
        near = [
            index
            for index, point in enumerate(self.waypoints)
            if index >= active and point.is_point and math.dist((pose.x, pose.y), (point.x, point.y)) <= NEAR
        ]
        return (near[-1], True) if near else (active, not self.waypoints[active].is_point)

    def _service(self) -> ServiceClient:
        robot = self._robot()
        if robot is None:
            raise ConfigError(sentence("the robot has gone"))
        return robot.service(LIST_DRIVER)

    # --- commands; all need control, and raise `JausError` ----------------------------------------------------------

    async def start(self, waypoints: Sequence[Waypoint] | None, speed: float) -> None:
        """Send these waypoints, if there are any that the robot does not hold, and drive through the list."""
        elements: Elements = self._service().waypoints
        if waypoints is not None:
            if len(waypoints) > MAX_WAYPOINTS:
                raise ConfigError(
                    sentence(
                        "{count} waypoints are too many; {most} are possible",
                        count=len(waypoints),
                        most=MAX_WAYPOINTS,
                    )
                )
            await elements.upload([waypoint.message() for waypoint in waypoints])
        else:
            await elements.read()
        if not len(elements):
            raise ConfigError(sentence("there is no waypoint; click on the map to set one"))
        await elements.execute(speed)
        await self._changed()

    async def set_speed(self, speed: float) -> None:
        """Change the speed, m/s; 0 waits."""
        await self._service().waypoints.set_speed(speed)
        await self._changed()

    async def clear(self) -> None:
        """Delete the list, which ends its execution."""
        await self._service().waypoints.clear()
        await self._changed()

    async def _changed(self) -> None:
        self._uids, self._looked_at = None, -math.inf
        await self.look()


async def _speed(service: ServiceClient) -> float | None:
    try:
        report: Any = await service.query(service.message("QueryTravelSpeed")())
        return float(report.speed)
    except (JausError, AttributeError):
        return None
