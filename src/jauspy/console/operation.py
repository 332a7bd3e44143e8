"""The operation of one robot: the browser that may operate it, control over JAUS, driving with a dead-man's switch.

When that browser falls silent, the robot stops; when its page closes, the robot goes to Standby and is released. No
emergency is set. `watchdog` does the latter when the console itself is killed.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass
from typing import Final

from jauspy.console.dead_man import DeadMan
from jauspy.console.killed_console import Watchdog
from jauspy.console.languages import sentence
from jauspy.console.manipulators import operated
from jauspy.console.users import LOCAL, Session, User, current
from jauspy.errors import JausError
from jauspy.ids import JausID
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.ocu.driving import VELOCITY, WRENCH
from jauspy.ocu.robot import Robot, RobotControl

MAX_SPEED: Final = 1.5
"""m/s; greatest speed limit that can be chosen. The robot also has its own limits."""
MAX_TURN_RATE: Final = 1.2
"""rad/s at full deflection of the stick."""
VELOCITY_MODE, EFFORT = "velocity", "effort"
"""Modes of driving: m/s and rad/s, or shares of the robot's full effort."""
RETURN_TIME: Final = 5.0
"""Seconds in which a component that was lent must be released by who had it."""
RETURN_INTERVAL: Final = 0.2
"""Seconds between two attempts to take it back."""
REQUEST_TIME: Final = 30.0
"""Seconds in which the operator may answer another one who asks for control."""


@dataclass(frozen=True, slots=True)
class ControlRequest:
    """Another browser asks the operator for control; `time` in seconds of the event loop's clock."""

    token: str
    user: User
    authority: int
    time: float


class Operation:
    """One robot, and the browser that operates it. Other browsers observe; each is known by its token."""

    def __init__(self, robot: Robot, on_event: Callable[[str], None], watchdog: Watchdog | None = None) -> None:
        self.robot = robot
        self.operator = ""
        """Token of the browser that operates; empty while the robot is not controlled."""
        self.user = LOCAL
        """The user of the browser that operates, or operated last."""
        self.authority = 0
        """The authority with which the robot is controlled."""
        self.speed_limit = 0.5
        """m/s at full deflection; in the mode EFFORT the share of the full effort, at most 1."""
        self.mode = next(iter(modes_of(robot)), VELOCITY_MODE)
        self.problem = ""
        """Why the last command had no effect; `problem_for` also has what concerns one page only."""
        self.commanded = (0.0, 0.0)
        """m/s and rad/s of the present drive command, or shares of the full effort."""
        self._sent_mode = self.mode
        self._on_event = on_event
        self._watchdog = watchdog
        self._renewing = Session(LOCAL, "")
        """User on whose behalf control is renewed: always the present one."""
        self._by: Session | None = None
        """User on whose behalf the newest command is sent."""
        self._control: RobotControl | None = None
        self._dead_man = DeadMan(self._stop_silent)
        self._stop: tuple[str, str] | None = None
        """Token and name of the emergency stop that this console has sent since control was taken."""
        self._told: dict[str, str] = {}
        """What only one page is told, by its token: that what it asked for last was refused."""
        self.taken_from = ""
        """Token of the browser from which the present one has taken control over; empty if it was handed over."""
        self._busy = asyncio.Lock()
        self._wanted: tuple[float, float] | None = None
        self._sending: asyncio.Task[None] | None = None
        self._request: ControlRequest | None = None
        self._seen = robot
        """The robot as it was discovered last."""
        self._missing: set[JausID] = set()
        """Components in control that the last discovery has not found."""
        self._lent: set[JausID] = set()
        """Components that another client controls for a while, as a planner the arm."""
        self._returning: asyncio.Task[None] | None = None
        """Takes a lent component back."""
        self._refused: set[JausID] = set()
        """Components that have appeared, and whose control was not granted."""
        self._following: asyncio.Task[None] | None = None

    @property
    def is_controlled(self) -> bool:
        """True while this console has control of the robot."""
        return self._control is not None and self._control.held

    @property
    def request(self) -> ControlRequest | None:
        """The pending request for control, while the operator may still answer."""
        if self._request is not None and asyncio.get_running_loop().time() - self._request.time > REQUEST_TIME:
            self._request = None
        return self._request if self.operator else None

    def may_take_over(self, user: User, authority: int) -> bool:
        """True if control may be taken now: it is free, one's own in another browser, or held with less authority."""
        return not self.operator or user.name == self.user.name or authority > self.authority

    async def take(self, token: str, authority: int, user: User = LOCAL) -> str:
        """Take control for a browser, or take it over from another one; returns why not, or an empty string."""
        if not user.may_operate:
            return sentence("{user} may only observe ({role})", user=user.name, role=user.role)
        if authority > user.authority:
            return sentence(
                "{user} has an authority of at most {authority} ({role})",
                user=user.name,
                authority=user.authority,
                role=user.role,
            )
        async with self._busy:
            if token != self.operator and not self.may_take_over(user, authority):
                return sentence(
                    "{user} operates this robot with authority {authority}; ask for it, or take it over "
                    "with a higher authority",
                    user=self.user.name,
                    authority=self.authority,
                )
            before = self.operator if self.is_controlled else ""
            problem = await self._enter(token, authority, user)
            if before and token != before and not problem:
                self.taken_from = before
            elif before and token != before and not self.operator:
                self._told[before] = self._not_granted(user, problem)
            return problem

    def _not_granted(self, user: User, error: object) -> str:
        return sentence(
            "control of robot {robot} was not granted to {user}: {error}",
            robot=self.robot.id,
            user=user.name,
            error=error,
        )

    def ask(self, token: str, authority: int, user: User = LOCAL) -> None:
        """Ask the operator for control."""
        if self.operator and token != self.operator and user.may_operate:
            self._request = ControlRequest(
                token, user, min(authority, user.authority), asyncio.get_running_loop().time()
            )
            self._on_event(
                sentence(
                    "{user} asks {operator} for control of robot {robot}",
                    user=user.name,
                    operator=self.user.name,
                    robot=self.robot.id,
                )
            )

    async def answer(self, token: str, *, grant: bool) -> str:
        """Handle the operator's answer to a request for control.

        Returns why control could not be handed over, or an empty string.
        """
        async with self._busy:
            request, self._request = self.request, None
            if request is None or token != self.operator:
                return ""
            if grant:
                return await self._enter(request.token, request.authority, request.user)
            self._on_event(
                sentence(
                    "{user} does not hand over robot {robot} to {asker}",
                    user=self.user.name,
                    robot=self.robot.id,
                    asker=request.user.name,
                )
            )
            return ""

    async def _enter(self, token: str, authority: int, user: User) -> str:
        """Stop, and control the robot for this browser; with another authority control is requested anew."""
        self._stop_driving()
        if self._control is not None and (authority != self.authority or not self._control.held):
            await self._leave()
        if self._control is None:
            control = self.robot.control(*operated(self.robot), authority=authority)
            before, self._renewing.user = self._renewing.user, user
            reset = current.set(self._renewing)
            try:
                await control.__aenter__()
            except JausError as error:
                self._renewing.user = before
                self._told = {token: str(error)}
                self._on_event(self._not_granted(user, error))
                return str(error)
            finally:
                current.reset(reset)
            self._control, self._stop = control, None
            if self._watchdog is not None:
                self._watchdog.hold(self.robot.id, control.ids)
        self.operator, self.user, self.authority, self.problem, self._request = token, user, authority, "", None
        self._told, self.taken_from = {}, ""
        self._renewing.user = user
        self._on_event(
            sentence(
                "{user} operates robot {robot} with authority {authority}",
                user=user.name,
                robot=self.robot.id,
                authority=authority,
            )
        )
        return ""

    async def _leave(self) -> None:
        control, self._control, self.operator, self.problem = self._control, None, "", ""
        self._dead_man.end()
        self._wanted, self.commanded = None, (0.0, 0.0)
        self._missing, self._refused, self._lent = set(), set(), set()
        if control is not None:
            await control.__aexit__(None, None, None)
            if self._watchdog is not None:
                self._watchdog.hold(self.robot.id, ())

    def follow(self, robot: Robot) -> None:
        """Apply a new discovery of the robot: take control of new components, and drop those that have vanished.

        A component counts as vanished when two discoveries have not found it: one alone may have lost a packet.
        """
        if robot is self._seen:
            return
        self._seen = robot
        control = self._control
        if control is None:
            self.robot = robot
            return
        wanted = {JausID.parse(component) for component in operated(robot)}
        missing = set(control.ids) - wanted
        gone, self._missing = missing & self._missing, missing
        self._refused &= wanted
        new = wanted - set(control.ids) - self._refused - self._lent
        if self._following is None or self._following.done():
            kept = {component.id: component for component in self.robot.components if component.id in missing - gone}
            if not kept:
                self.robot.info = robot.info  # its driving and its motions go on
            if new or gone:
                change = self._change(control, new, gone)
                self._following = asyncio.create_task(change, name=f"console: components of {robot.id}")

    async def _change(self, control: RobotControl, new: set[JausID], gone: set[JausID]) -> None:
        async with self._busy:
            if self._control is not control:
                return
            for component in sorted(gone):
                self._on_event(sentence("{component} has gone, and is not operated any more", component=component))
            await control.exclude(gone)
            for component in sorted(new):
                try:
                    await control.include([component])
                except JausError as error:
                    self._refused.add(component)
                    self.problem = sentence(
                        "{component} has appeared, and is not operated: {error}", component=component, error=error
                    )
                    self._on_event(self.problem)
                else:
                    self._on_event(
                        sentence(
                            "{component} has appeared, and is operated by {user} too",
                            component=component,
                            user=self.user.name,
                        )
                    )
            if self._watchdog is not None:
                self._watchdog.hold(self.robot.id, control.ids)

    @asynccontextmanager
    async def lent(self, component: JausID) -> AsyncIterator[None]:
        """Within this another client may control a component; the operation has it again afterwards, if it still can.

        It is put in Standby and released; the other components stay controlled.
        """
        async with self._busy:
            control = self._control
            is_held = control is not None and component in control.ids
            if control is not None and is_held:
                self._lent.add(component)
                await control.exclude([component])
        try:
            yield
        finally:
            if control is not None and is_held:
                self._returning = asyncio.create_task(
                    self._take_back(control, component), name=f"console: {component} comes back"
                )
                await asyncio.shield(self._returning)

    async def _take_back(self, control: RobotControl, component: JausID) -> None:
        """Control a lent component again; who had it may need a moment to stop and release it."""
        clock = asyncio.get_running_loop().time
        end = clock() + RETURN_TIME
        while self._control is control:
            try:
                async with self._busy:
                    if self._control is control:
                        await control.include([component])
            except JausError as error:
                if clock() > end:
                    self._refused.add(component)
                    self.problem = sentence(
                        "{component} was lent, and is not operated any more: {error}", component=component, error=error
                    )
                    self._on_event(self.problem)
                    break
                await asyncio.sleep(RETURN_INTERVAL)
            else:
                break
        self._lent.discard(component)
        if self._watchdog is not None and self._control is control:
            self._watchdog.hold(self.robot.id, control.ids)

    async def release(self, token: str = "") -> None:
        """Stop, put the robot in Standby and release control; with a token only if that browser operates the robot.

        May be called twice.
        """
        async with self._busy:
            if token and token != self.operator:
                return  # another browser has taken over meanwhile
            had_control = self._control is not None
            await self._leave()
            if had_control:
                if token:
                    text = sentence(
                        "control of robot {robot} was released by {user}", robot=self.robot.id, user=self.user.name
                    )
                else:
                    text = sentence(
                        "control of robot {robot} was released, since the console ends", robot=self.robot.id
                    )
                self._on_event(text)

    def refusal(self, token: str) -> str:
        """Why a browser may not command the robot now; empty if it may."""
        if token != self.operator or self._control is None:
            return sentence("another browser operates this robot") if self.operator else sentence("take control first")
        return self._loss(token)

    def problem_for(self, token: str) -> str:
        """What a page is told: why control was lost, what it asked for and did not get, or why a command failed."""
        return self._loss(token) or self._told.get(token) or self.problem

    def tell(self, token: str, problem: str) -> None:
        """Tell one page why it did not get what it asked for."""
        self._told = {token: problem}

    def stopped(self, token: str, what: str) -> None:
        """Take note of an emergency stop from a page of this console, named by its token; `what` as STOP ALL."""
        if self.is_controlled:
            self._stop = token, what

    def _loss(self, token: str) -> str:
        """Why control was lost, in words for a page: by a stop of this console, or as the component has told."""
        reason = "" if self._control is None else self._control.lost
        if self._stop is None or not reason:
            return reason
        by, what = self._stop
        return sentence(
            "{what} by {page} has ended it; clear the emergency, then take control again",
            what=what,
            page=sentence("this page") if token == by else sentence("another page of this console"),
        )

    def drive(self, token: str, forward: float, left: float) -> str:
        """Drive with deflections of -1..1, repeated within `dead_man.DEAD_MAN_TIME`; other numbers stop the robot.

        Returns why not, or an empty string.
        """
        if why_not := self.refusal(token):
            return why_not
        self._told.pop(token, None)
        ahead, turn = self._full_deflection()
        is_valid = -1.0 <= forward <= 1.0 and -1.0 <= left <= 1.0
        linear, angular = (ahead * forward, turn * left) if is_valid else (0.0, 0.0)
        if linear or angular:
            self._dead_man.repeat()
        else:
            self._dead_man.end()
        self._want(linear, angular)
        return "" if is_valid else sentence("stopped: a deflection is a number from -1 to 1")

    def set_limit(self, token: str, limit: float) -> None:
        """Set the limit of the speed, at most `MAX_SPEED`; without effect for a browser that does not operate."""
        if token == self.operator and 0.0 <= limit <= MAX_SPEED:
            self.speed_limit = limit

    def set_mode(self, token: str, mode: str) -> str:
        """Switch between velocities and efforts; the robot stops first. Returns why not, or an empty string."""
        if token != self.operator or self._control is None:
            return sentence("take control first")
        if mode not in modes_of(self.robot):
            return sentence("this robot does not offer the mode {mode}", mode=mode)
        self._stop_driving()
        self.mode = mode
        self._on_event(
            sentence("{user} drives robot {robot} by {mode}", user=self.user.name, robot=self.robot.id, mode=mode)
        )
        return ""

    def _full_deflection(self) -> tuple[float, float]:
        if self.mode == EFFORT:
            share = min(1.0, self.speed_limit)
            return share, share
        return self.speed_limit, MAX_TURN_RATE * min(1.0, self.speed_limit / 0.5)

    def _stop_silent(self) -> None:
        self._on_event(sentence("robot {robot} was stopped: its operator's browser is silent", robot=self.robot.id))
        self._want(0.0, 0.0)

    def _want(self, linear: float, angular: float) -> None:
        self._wanted, self._by = (linear, angular), current.get()
        if self._sending is None or self._sending.done():
            self._sending = asyncio.create_task(self._send(), name=f"console: drive {self.robot.id}")

    async def _send(self) -> None:
        """Send the newest command; older ones that were not sent are dropped."""
        while (wanted := self._wanted) is not None:
            self._wanted = None
            current.set(self._by)  # not of the one whose command has started this task
            try:
                if any(wanted):
                    await self._drive(*wanted)
                else:
                    await self._brake()
                self.problem, self.commanded = "", wanted
            except JausError as error:
                self.problem, self.commanded = str(error), (0.0, 0.0)

    async def _drive(self, linear: float, angular: float) -> None:
        """Angles of JAUS count clockwise. The browser repeats commands, so an effort is not repeated here."""
        if self.mode != self._sent_mode:
            await self._brake()  # a velocity that is repeated would go on beside the effort
            self._sent_mode = self.mode
        if self.mode == EFFORT:
            effort = SetWrenchEffort(
                propulsive_linear_effort_x=100.0 * linear, propulsive_rotational_effort_z=-100.0 * angular
            )
            await self.robot.service(WRENCH).send(effort)
        else:
            await self.robot.drive(linear, angular)

    async def _brake(self) -> None:
        """Stop: a velocity of zero slows down within the robot's limits, an effort of zero brakes."""
        await self.robot.stop()
        if any(component.find(WRENCH) for component in self.robot.components):
            await self.robot.service(WRENCH).send(SetWrenchEffort(), ack=True)

    def _stop_driving(self) -> None:
        self._dead_man.end()
        if any(self.commanded):
            self._want(0.0, 0.0)


def modes_of(robot: Robot) -> list[str]:
    """The modes in which this robot can be driven manually; the usual one first."""

    def offers(*names: str) -> bool:
        return all(any(component.find(name) for component in robot.components) for name in names)

    by_velocity = offers(VELOCITY) or offers(WRENCH, "ugv:PlatformSpecifications")
    return [VELOCITY_MODE] * by_velocity + [EFFORT] * offers(WRENCH)
