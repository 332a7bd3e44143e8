"""Operating one robot: who of the browsers operates it, control over JAUS, and driving with a dead-man's switch."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Final

from jauspy.errors import JausError
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.ocu.driving import WRENCH
from jauspy.ocu.robot import Robot
from jauspy.ocu.robot_control import RobotControl

DEAD_MAN_TIME: Final = 0.2
"""Seconds without a message of the operator's browser after which the robot is stopped."""
MAX_TURN_RATE: Final = 1.2
"""rad/s at full deflection of the stick."""


class Operation:
    """One robot, and the browser that operates it. Other browsers observe; each is known by its token."""

    def __init__(self, robot: Robot, on_event: Callable[[str], None]) -> None:
        self.robot = robot
        self.operator = ""
        """Token of the browser that operates; empty while the robot is not controlled."""
        self.speed_limit = 0.5
        """m/s at full deflection."""
        self.problem = ""
        """Why the last command had no effect, in words."""
        self.commanded = (0.0, 0.0)
        """m/s and rad/s of the present drive command."""
        self._on_event = on_event
        self._control: RobotControl | None = None
        self._watchdog: asyncio.TimerHandle | None = None
        self._busy = asyncio.Lock()
        self._wanted: tuple[float, float] | None = None
        self._sending: asyncio.Task[None] | None = None

    @property
    def is_controlled(self) -> bool:
        """True while this console has control of the robot."""
        return self._control is not None and self._control.held

    async def take(self, token: str, authority: int) -> str:
        """Take control for a browser, or hand it over from another one; returns why not, or an empty string."""
        async with self._busy:
            if self._control is None:
                control = self.robot.control(authority=authority)
                try:
                    await control.__aenter__()
                except JausError as error:
                    self.problem = str(error)
                    self._on_event(f"control of robot {self.robot.id} was not granted: {error}")
                    return self.problem
                self._control = control
                self._on_event(f"control of robot {self.robot.id} was taken with authority {authority}")
            self._stop_driving()
            self.operator, self.problem = token, ""
            return ""

    async def release(self) -> None:
        """Stop, put the robot in Standby and release control. May be called twice."""
        async with self._busy:
            control, self._control, self.operator = self._control, None, ""
            self._cancel_watchdog()
            self._wanted, self.commanded = None, (0.0, 0.0)
            if control is not None:
                await control.__aexit__(None, None, None)
                self._on_event(f"control of robot {self.robot.id} was released")

    def drive(self, token: str, forward: float, left: float) -> str:
        """Drive with deflections of -1..1, repeated within `DEAD_MAN_TIME`; returns why not, or an empty string."""
        if token != self.operator or self._control is None:
            return "another browser operates this robot" if self.operator else "take control first"
        if self._control.lost:
            self.problem = self._control.lost
            return self.problem
        linear = self.speed_limit * min(1.0, max(-1.0, forward))
        angular = MAX_TURN_RATE * min(1.0, self.speed_limit / 0.5) * min(1.0, max(-1.0, left))
        self._cancel_watchdog()
        moving = bool(linear or angular)
        if moving:
            self._watchdog = asyncio.get_running_loop().call_later(DEAD_MAN_TIME, self._dead_man)
        self._want(linear, angular)
        return ""

    def _dead_man(self) -> None:
        self._watchdog = None
        self._on_event(f"robot {self.robot.id} was stopped: its operator's browser is silent")
        self._want(0.0, 0.0)

    def _want(self, linear: float, angular: float) -> None:
        self._wanted = (linear, angular)
        if self._sending is None or self._sending.done():
            self._sending = asyncio.create_task(self._send(), name=f"console: drive {self.robot.id}")

    async def _send(self) -> None:
        """Send the newest command; those that came meanwhile are left out."""
        while (wanted := self._wanted) is not None:
            self._wanted = None
            try:
                if any(wanted):
                    await self.robot.drive(*wanted)
                else:
                    await self._brake()
                self.problem, self.commanded = "", wanted
            except JausError as error:
                self.problem, self.commanded = str(error), (0.0, 0.0)

    async def _brake(self) -> None:
        """Stop: a velocity of zero slows down within the robot's limits, an effort of zero brakes."""
        await self.robot.stop()
        if any(each.find(WRENCH) for each in self.robot.components):
            await self.robot.service(WRENCH).send(SetWrenchEffort(), ack=True)

    def _stop_driving(self) -> None:
        self._cancel_watchdog()
        if any(self.commanded):
            self._want(0.0, 0.0)

    def _cancel_watchdog(self) -> None:
        if self._watchdog is not None:
            self._watchdog.cancel()
            self._watchdog = None
