"""Names of components by what they move or see, as robots report them: `flippers`, `arm camera`."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from typing import Final

from jauspy.console.camera_settings import VIDEO, sensor_name
from jauspy.console.languages import sentence
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.messages.description import QueryJointDescription, ReportJointDescription
from jauspy.ocu.joints import DESCRIPTION, table_of
from jauspy.ocu.robot import Robot
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.printable import printable

MAX_NAMES: Final = 1024
"""Names that are kept."""
MAX_NAME: Final = 40
"""Characters of a name."""
MAX_TRIES: Final = 3
"""Queries of a component that does not answer."""


class PartNames:
    """The names of all components that have been seen, which are asked for once."""

    def __init__(self) -> None:
        self._names: dict[tuple[JausID, ComponentInfo], str] = {}
        self._tries: dict[tuple[JausID, ComponentInfo], int] = {}
        self._reading: asyncio.Task[None] | None = None

    def of(self, component: ComponentInfo) -> str:
        """What the component moves or sees; empty while it is not known."""
        return self._names.get((component.id, component), "")

    def look(self, robots: Iterable[Robot]) -> None:
        """Ask components that are new."""
        if self._reading is None or self._reading.done():
            new = [
                (robot, component)
                for robot in robots
                for component in robot.components
                if self._tries.get((component.id, component), 0) < MAX_TRIES
                and (component.find(VIDEO) or component.find(DESCRIPTION))
            ]
            if new:
                self._reading = asyncio.create_task(self._read(new), name="console: names of parts")

    async def close(self) -> None:
        """Ask no more."""
        if self._reading is not None:
            self._reading.cancel()
            await asyncio.wait({self._reading})

    async def _read(self, new: list[tuple[Robot, ComponentInfo]]) -> None:
        for robot, component in new:
            key = (component.id, component)
            try:
                name = printable(await part_name(robot, component))
            except JausError:
                self._tries[key] = self._tries.get(key, 0) + 1
                continue
            self._tries[key], self._names[key] = MAX_TRIES, name if len(name) <= MAX_NAME else name[:MAX_NAME]
        for kept in (self._names, self._tries):
            while len(kept) > MAX_NAMES:
                kept.pop(next(iter(kept)))


async def part_name(robot: Robot, component: ComponentInfo) -> str:
    """The name of what a component moves or sees; raises `JausError` when it does not answer."""
    client = robot.component(str(component.id))
    if component.find(VIDEO):
        name = await sensor_name(client)
        return name if name == component.name or "camera" in name.lower() else sentence("{name} camera", name=name)
    report = await client.service(DESCRIPTION).query(QueryJointDescription(), expects=ReportJointDescription)
    assert isinstance(report, ReportJointDescription)
    return table_of(report).group.replace("_", " ")
