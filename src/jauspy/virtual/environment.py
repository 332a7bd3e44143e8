"""Base of environments in memory and on a real node manager, and the stepping of robots on virtual time."""

from __future__ import annotations

import asyncio
from abc import ABC, abstractmethod
from collections.abc import Iterable
from concurrent.futures import Future
from contextlib import AbstractAsyncContextManager
from dataclasses import replace
from datetime import datetime
from typing import TYPE_CHECKING, Any, Final

from jauspy.component import Component, ComponentOptions
from jauspy.component.component import loop_time
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.platform.contract import Robot
from jauspy.robot.realtime import RealTime
from jauspy.services.service import Service
from jauspy.transport import Transport

if TYPE_CHECKING:
    from jauspy.robot.runner import RobotRunner


class Environment(ABC):
    """Makes components and OCUs that reach each other; each is to be used with `async with`."""

    __test__ = False
    """Mark for pytest not to collect it, whatever name it is imported by."""

    @abstractmethod
    def transport(self, id: str | JausID) -> Transport:
        """A transport for the component of this id."""

    @abstractmethod
    def robot(self, name: str = "inc1") -> AbstractAsyncContextManager[RobotRunner]:
        """A whole robot of this name on the `kinematic` backend."""

    @abstractmethod
    def now(self) -> float:
        """Seconds of the monotonic clock that components use here."""

    @abstractmethod
    def utc_now(self) -> datetime:
        """The wall clock here."""

    def component(self, id: str | JausID, services: Iterable[Service], **options: Any) -> Component:
        """A component of these services; `options` are those of `Component`."""
        settings = replace(options.pop("options", ComponentOptions()), clock=self.now, utc_now=self.utc_now)
        return Component(id, services, transport=self.transport(id), options=settings, **options)

    def ocu(self, id: str | JausID = "42.1.1", **options: Any) -> OCU:
        """An OCU; `options` are those of `OCU`."""
        return OCU(id, transport=self.transport(id), **options)


STEP: Final = 0.01
"""Seconds of one step; longer than in real time, since tests wait on the same clock."""


class VirtualTime(RealTime):
    """Steps a robot as `RealTime` does, in a task of the event loop in place of a thread."""

    def __init__(self, robot: Robot) -> None:
        super().__init__(robot, step=STEP, clock=loop_time)
        self._task: asyncio.Task[None] | None = None

    def open(self) -> None:
        """Start the task; without effect when started."""
        if self._task is None:
            self._ended = Future()
            self._ended.set_running_or_notify_cancel()
            self._task = asyncio.create_task(self._step_on(), name="virtual robot")
            self._task.add_done_callback(self._on_end)

    def close(self) -> None:
        """Stop the robot and end the task; without effect when closed."""
        task, self._task = self._task, None
        if task is not None:
            task.remove_done_callback(self._on_end)
            task.cancel()
            self._stop_all()
            if not self._ended.done():
                self._ended.set_result(None)

    @property
    def _is_open(self) -> bool:
        """True between `open` and `close`."""
        return self._task is not None

    def _on_end(self, task: asyncio.Task[None]) -> None:
        """Report a task that was cancelled, or ended by an exception such as that of a test's time limit."""
        error = None if task.cancelled() else task.exception()
        self.end_early("the task that steps it", error)
        self._stop_all()
        self._ended.set_exception(error or RuntimeError("the task that steps the robot was cancelled"))
        context = {"message": "the task that steps a virtual robot has ended", "exception": error, "task": task}
        task.get_loop().call_exception_handler(context)

    async def _step_on(self) -> None:
        due = loop_time()
        while True:
            due += STEP
            await asyncio.sleep(due - loop_time())
            self._make_step()
