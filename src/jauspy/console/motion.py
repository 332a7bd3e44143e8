"""One motion at a time that a browser has begun: it ends when that browser does not operate the robot any more."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from typing import Any, Final

from jauspy.console.server import Console
from jauspy.errors import JausError

CHECK_INTERVAL: Final = 0.1
"""Seconds between two looks at who operates the robot."""


class Motion:
    """The motions of one page; they are cancelled, which stops the joints, as in `Arm.move`."""

    def __init__(self, console: Console, token: str) -> None:
        self.problem = ""
        """Why the last motion was refused or has failed, in words."""
        self._console = console
        self._token = token
        self._task: asyncio.Task[None] | None = None

    @property
    def is_running(self) -> bool:
        """True while one is carried out."""
        return self._task is not None and not self._task.done()

    def refusal(self, subsystem: int) -> str:
        """Why this page may not command a robot now; empty if it may."""
        operation = self._console.operation(subsystem)
        return "the robot has gone" if operation is None else operation.refusal(self._token)

    def begin(self, subsystem: int, motion: Coroutine[Any, Any, Any], what: str) -> None:
        """Begin a motion of a robot, unless one is running or another browser operates it; see `problem`."""
        self.problem = "another motion is running: stop it first" if self.is_running else self.refusal(subsystem)
        if self.problem:
            motion.close()
            return
        self._task = asyncio.create_task(self._run(subsystem, motion, what), name=f"console: {what}")

    def stop(self) -> None:
        """End the motion that is running, if any."""
        if self._task is not None:
            self._task.cancel()

    async def _run(self, subsystem: int, motion: Coroutine[Any, Any, Any], what: str) -> None:
        inner = asyncio.create_task(motion, name=f"console: {what}, inside")
        try:
            while not inner.done():
                await asyncio.wait([inner], timeout=CHECK_INTERVAL)
                if not inner.done() and (why := self.refusal(subsystem)):
                    self.problem = f"{what} was stopped: {why}"
                    break
        finally:
            inner.cancel()
            await asyncio.wait([inner])
        if not inner.cancelled() and (error := inner.exception()) is not None:
            if not isinstance(error, JausError):
                raise error
            self.problem = str(error)
        if self.problem:
            self._console.note(f"{what} of robot {subsystem}: {self.problem}")
