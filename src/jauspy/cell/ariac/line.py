"""The controller of the line that the belt belongs to: a JAUS client beside the one that fills the trays."""

from __future__ import annotations

import asyncio
from contextlib import AsyncExitStack
from typing import Final, Self

from jauspy.cell.session import Session
from jauspy.errors import ConfigError

LINE_ID: Final = "42.1.2"


class Line:
    """`async with Line(session) as line:` controls the belt from the first speed on."""

    def __init__(self, session: Session) -> None:
        if session.network is None:
            raise ConfigError("the belt of a trial is run in a simulation of this process only")
        self._network, self._subsystem = session.network, session.cell.subsystem
        self._stack = AsyncExitStack()
        self._wanted: asyncio.Queue[float] = asyncio.Queue()
        self._task: asyncio.Task[None] | None = None

    async def __aenter__(self) -> Self:
        return self

    async def __aexit__(self, *_: object) -> None:
        if self._task is not None:
            self._task.cancel()
            await asyncio.wait({self._task})
        await self._stack.aclose()

    def run(self, speed: float) -> None:
        """Run the belt at a speed, in m/s, until the next one."""
        self._wanted.put_nowait(speed)
        if self._task is None:
            self._task = asyncio.create_task(self._work(), name="line")

    async def _work(self) -> None:
        ocu = await self._stack.enter_async_context(self._network.ocu(LINE_ID))
        robot = await ocu.discover(self._subsystem)
        (belt,) = robot.info.offering("Conveyor")
        await self._stack.enter_async_context(robot.control(str(belt.id)))
        conveyor = robot.component(str(belt.id)).conveyor
        while True:
            await conveyor.run(await self._wanted.get())
