"""A robot that lives on the event loop's clock, so that it drives on virtual time."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final

from jauspy.component.component import loop_time
from jauspy.modules.realtime import RealTime
from jauspy.platform.contract import Robot

STEP: Final = 0.01
"""Seconds; longer than in real time, since whoever waits for the robot here waits on the same clock."""


class VirtualTime(RealTime):
    """As `RealTime`, with a task of the event loop in place of the thread."""

    def __init__(self, robot: Robot) -> None:
        super().__init__(robot, step=STEP, clock=loop_time)
        self._stop: Final[Callable[[], None]] = robot.drive.stop
        self._task: asyncio.Task[None] | None = None

    def open(self) -> None:
        """Start the task; twice is fine."""
        if self._task is None:
            self._task = asyncio.create_task(self._step_on(), name="virtual robot")

    def close(self) -> None:
        """Stop the robot and end the task; twice is fine."""
        task, self._task = self._task, None
        if task is not None:
            task.cancel()
            self._stop()

    async def _step_on(self) -> None:
        due = loop_time()
        while True:
            due += STEP
            await asyncio.sleep(due - loop_time())
            self._make_step()
