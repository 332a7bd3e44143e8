"""Follows the robots on the network: subsystems, and the state and controller of each component."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, Final

from jauspy.console.languages import sentence
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages.core import QueryControl, QueryStatus, ReportControl, ReportStatus
from jauspy.ocu import OCU
from jauspy.ocu.control import controller, status_name
from jauspy.ocu.robot import Robot
from jauspy.printable import printable

_LOG: Final = get_logger("jauspy.console")

DISCOVERY_INTERVAL: Final = 2.0
"""Seconds between two discoveries."""
STATUS_INTERVAL: Final = 0.5
"""Seconds between two queries of each component's state."""
LOST_AFTER: Final = 3.0
"""Seconds without an answer after which a component counts as silent."""
MAX_COMPONENTS: Final = 256
"""Components whose state is queried."""


@dataclass(frozen=True, slots=True)
class ComponentState:
    """The last answer of a component; `heard` is its time in seconds of the event loop's clock."""

    status: str = ""
    controller: str = ""
    """The id of the client in control; empty if there is none."""
    authority: int = 0
    heard: float = 0.0


NOTHING: Final = ComponentState()


class Fleet:
    """Follows all robots of the network between `start` and `close`."""

    def __init__(self, ocu: OCU) -> None:
        self.ocu = ocu
        self.robots: Mapping[int, Robot] = {}
        """Robots by the number of the subsystem; a new mapping after each change."""
        self.states: dict[JausID, ComponentState] = {}
        self.on_event: Callable[[str], None] = lambda _: None
        """Called with a sentence when a robot or a state changes."""
        self.on_robots: Callable[[Mapping[int, Robot]], None] = lambda _: None
        """Called with `robots` after each discovery."""
        self._tasks: list[asyncio.Task[None]] = []

    def start(self) -> None:
        """Start discovery."""
        self._tasks = [
            asyncio.create_task(self._discover(), name="console: discovery"),
            asyncio.create_task(self._query_states(), name="console: states"),
        ]

    async def close(self) -> None:
        """Stop discovery. May be called twice."""
        for task in self._tasks:
            task.cancel()
        if self._tasks:
            await asyncio.wait(self._tasks)
        self._tasks = []

    def age(self, id: JausID) -> float:
        """Seconds since the component's last answer; infinite before the first."""
        state = self.states.get(id)
        return float("inf") if state is None else asyncio.get_running_loop().time() - state.heard

    def is_silent(self, id: JausID) -> bool:
        """True if the component has not answered for `LOST_AFTER`."""
        return self.age(id) > LOST_AFTER

    async def _discover(self) -> None:
        missed: dict[int, int] = {}
        while True:
            with suppress(JausError):
                found = {robot.id: robot for robot in await self.ocu.discover_all(timeout=DISCOVERY_INTERVAL)}
                robots = {id: robot for id, robot in found.items() if not self._is_console(robot)}
                missed = {id: missed.get(id, 0) + 1 for id in self.robots if id not in robots}
                kept = {id: self.robots[id] for id, times in missed.items() if times < 2}
                self._take({**kept, **robots})
            await asyncio.sleep(0.1)

    def _is_console(self, robot: Robot) -> bool:
        return robot.id == self.ocu.id.subsystem or not any(
            component.find("Management") for component in robot.components
        )

    def _take(self, robots: dict[int, Robot]) -> None:
        for id in robots.keys() - self.robots.keys():
            self.on_event(sentence("robot {id} {name} has appeared", id=id, name=printable(robots[id].name)))
        for id in self.robots.keys() - robots.keys():
            self.on_event(
                sentence("robot {id} {name} does not answer any more", id=id, name=printable(self.robots[id].name))
            )
        self.robots = dict(sorted(robots.items()))
        self.on_robots(self.robots)
        known = {component.id for robot in robots.values() for component in robot.components}
        self.states = {id: state for id, state in self.states.items() if id in known}

    async def _query_states(self) -> None:
        while True:
            ids = [
                component.id
                for robot in self.robots.values()
                for component in robot.components
                if component.find("Management")
            ]
            await asyncio.gather(*(self._query_state(id) for id in ids[:MAX_COMPONENTS]))
            await asyncio.sleep(STATUS_INTERVAL)

    async def _query_state(self, id: JausID) -> None:
        queries: tuple[Any, Any] = QueryStatus(), QueryControl()
        try:
            status, control = await asyncio.gather(
                *(self.ocu.query(id, query, timeout=STATUS_INTERVAL, retries=0) for query in queries)
            )
        except JausError:
            return
        if not isinstance(status, ReportStatus) or not isinstance(control, ReportControl):
            return
        holder = controller(control)
        new = ComponentState(
            status_name(status),
            str(holder) if int(holder) else "",
            control.authority_code,
            asyncio.get_running_loop().time(),
        )
        before = self.states.get(id, NOTHING)
        self.states[id] = new
        if before.heard and before.status != new.status:
            self.on_event(
                sentence("{id} is in {status}, was in {before}", id=id, status=new.status, before=before.status)
            )
        if before.heard and before.controller != new.controller:
            self.on_event(
                sentence(
                    "{id} is controlled by {new}, was by {before}",
                    id=id,
                    new=new.controller or sentence("nobody"),
                    before=before.controller or sentence("nobody"),
                )
            )
