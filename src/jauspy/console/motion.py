"""The motions that a page has started: motions to a target, and jogging of an arm's tool while a button or key is held.

Both stop when the page no longer operates the robot.
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable, Coroutine
from typing import TYPE_CHECKING, Any, Final, TypeAlias

from jauspy.console.browser_messages import ToolVelocity
from jauspy.console.dead_man import DeadMan
from jauspy.console.languages import sentence
from jauspy.console.operation import Operation
from jauspy.console.users import Session, current
from jauspy.errors import JausError
from jauspy.geometry.vectors import Vector
from jauspy.ids import JausID

if TYPE_CHECKING:
    from jauspy.console.console import Console

MAX_SPEED: Final = 0.25
"""m/s; greatest speed from a browser: the limit for robots near people (ISO 10218-1)."""
MAX_TURN: Final = 1.0
"""rad/s."""

Velocity: TypeAlias = tuple[Vector, Vector, str]
"""m/s along and rad/s about the axes of a frame."""

STILL: Final[Velocity] = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), "robot")


def velocity(wanted: ToolVelocity | None) -> Velocity:
    """Limit the velocity of a browser's message; zero for one that is not valid."""
    if wanted is None:
        return STILL
    x, y, z, roll, pitch, yaw, frame = wanted
    return _limited((x, y, z), MAX_SPEED), _limited((roll, pitch, yaw), MAX_TURN), frame


class Jogging:
    """Moves the tool of one arm at velocities from the operator's browser, while the browser repeats them."""

    def __init__(self, operation: Operation, id: JausID, on_event: Callable[[str], None]) -> None:
        self.operation = operation
        self.problem = ""
        """Why the last command had no effect."""
        self._id = id
        self._on_event = on_event
        self._mover = ""
        """The token of the page that moves the tool; empty while the tool stands."""
        self._dead_man = DeadMan(self._stop_silent)
        self._wanted: Velocity | None = None
        self._by: Session | None = None
        """User on whose behalf the newest velocity is sent."""
        self._sending: asyncio.Task[None] | None = None

    def move(self, token: str, asked: ToolVelocity | None) -> str:
        """Move the tool; repeated within `dead_man.DEAD_MAN_TIME`. Returns why not, or an empty string."""
        if why_not := self.operation.refusal(token):
            return why_not
        wanted = velocity(asked)
        self._dead_man.end()
        if any((*wanted[0], *wanted[1])):
            self._dead_man.repeat()
            self._mover = token
            self._want(wanted)
        elif self._mover:
            self._stop()
        return self.problem

    def leave(self, token: str) -> None:
        """Stop the motion of a browser whose socket has closed."""
        if token == self._mover:
            self._dead_man.end()
            self._stop()

    def _stop_silent(self) -> None:
        self._on_event(sentence("the arm {id} was stopped: its operator's browser is silent", id=self._id))
        self._stop()

    def _stop(self) -> None:
        self._mover = ""
        self._want(STILL)

    def _want(self, wanted: Velocity) -> None:
        self._wanted, self._by = wanted, current.get()
        if self._sending is None or self._sending.done():
            self._sending = asyncio.create_task(self._send(), name=f"console: jog {self._id}")

    async def _send(self) -> None:
        """Send the newest command; older ones that were not sent are dropped."""
        while (wanted := self._wanted) is not None:
            self._wanted = None
            current.set(self._by)
            linear, angular, frame = wanted
            try:
                arm = self.operation.robot.manipulator(str(self._id))
                await arm.move_tool_at(linear, angular, frame=frame)
                self.problem = ""
            except JausError as error:
                self.problem = str(error)


def _limited(vector: Vector, most: float) -> Vector:
    length = math.hypot(*vector)
    x, y, z = vector
    return (x * most / length, y * most / length, z * most / length) if length > most else vector


CHECK_INTERVAL: Final = 0.1
"""Seconds between two checks that the page still operates the robot."""


class Motion:
    """The motions of one page; they are cancelled, which stops the joints, as in `Arm.move`."""

    def __init__(self, console: Console, token: str) -> None:
        self.problem = ""
        """Why the last motion was refused or has failed."""
        self._console = console
        self._token = token
        self._task: asyncio.Task[None] | None = None

    @property
    def is_running(self) -> bool:
        """True while a motion is carried out."""
        return self._task is not None and not self._task.done()

    def refusal(self, subsystem: int) -> str:
        """Why this page may not command a robot now; empty if it may."""
        operation = self._console.operation(subsystem)
        return sentence("the robot has gone") if operation is None else operation.refusal(self._token)

    def begin(self, subsystem: int, motion: Coroutine[Any, Any, Any], what: str) -> None:
        """Begin a motion of a robot, unless one is running or another browser operates it; see `problem`."""
        self.problem = (
            sentence("another motion is running: stop it first") if self.is_running else self.refusal(subsystem)
        )
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
                    self.problem = sentence("{what} was stopped: {why}", what=what, why=why)
                    break
        finally:
            inner.cancel()
            await asyncio.wait([inner])
        if not inner.cancelled() and (error := inner.exception()) is not None:
            if not isinstance(error, JausError):
                raise error
            self.problem = str(error)
        if self.problem:
            self._console.note(
                sentence("{what} of robot {subsystem}: {problem}", what=what, subsystem=subsystem, problem=self.problem)
            )
