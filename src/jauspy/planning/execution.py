"""Plans motions of a robot's arm, and has the arm carry them out over JAUS while it watches the way."""

from __future__ import annotations

import asyncio
import itertools
import math
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from contextlib import AsyncExitStack, aclosing, asynccontextmanager, suppress
from dataclasses import dataclass, replace
from functools import partial
from threading import Event
from typing import Final, Protocol, TypeAlias, TypeVar

import numpy as np

from jauspy.errors import ConfigError, ControlRejected, JausError, RequestError, ResponseTimeout
from jauspy.geometry.frames import FrameTree
from jauspy.messages.planning import ReportMotionPlannerState
from jauspy.ocu.arm import PROFILE, Arm
from jauspy.ocu.control import DEFAULT_AUTHORITY
from jauspy.ocu.motion_limits import straight_duration
from jauspy.ocu.robot import Robot
from jauspy.planning.motion import Goal, JointGoal, MotionPlanner, NoPlan, Plan, PlanRequest, Reason
from jauspy.planning.obstacles import Array, Obstacles, Primitive
from jauspy.platform.description import GroupSetup, RobotModel

Phase: TypeAlias = ReportMotionPlannerState.Phase
T = TypeVar("T")

LEG_TOLERANCE: Final = 0.005
"""Radians or metres by which the list of positions may differ from the plan: a point in between is left out."""
LEAST_LEG: Final = 0.021
"""Radians or metres that the joint with the longest way moves on a leg, at least: less counts as no motion."""
DEVIATION: Final = 0.08
"""Radians or metres that a joint may be off the planned way."""
STANDSTILL: Final = 3.0
"""Seconds without progress after which an arm is taken to be blocked."""
AT_END: Final = 0.05
"""Radians or metres before the end of the way within which an arm may stand: it settles."""
NOISE: Final = 2e-3
"""Radians or metres by which encoders may show progress that is none."""
WATCH_RATE: Final = 20.0
"""Hz of the reports by which the way is watched."""
SIGHT_INTERVAL: Final = 0.2
"""Seconds between two comparisons of what is left of the way with the obstacles."""
LIMIT_NOISE: Final = 0.02
"""Radians or metres beyond a limit up to which a joint counts as at it."""
REST_INTERVAL, REST_STEP, REST_QUERIES = 0.05, 1e-3, 60
"""Seconds between queries until the arm stands, radians or metres between two of them, and their greatest number."""
SLOWER: Final = 1.02
"""Factor on the least time of a leg: the profile is rounded on the wire."""
GRACE: Final = 20.0
"""Seconds that a motion may take longer than planned."""


class MotionFailed(RequestError):
    """A motion ended before its end; the message says why in words."""

    def __init__(self, reason: Reason, text: str) -> None:
        super().__init__(text)
        self.reason = reason


@dataclass(frozen=True, slots=True)
class MotionState:
    """The state of planning and motion, as MotionPlanner reports it."""

    phase: Phase = ReportMotionPlannerState.Phase.IDLE
    reason: Reason | None = None
    text: str = ""
    """Reason in words."""
    progress: float = 0.0
    """Part of the way that is done, 0 to 1."""
    replans: int = 0
    plan: Plan | None = None
    """The plan that can be carried out, or is."""


@dataclass(frozen=True, slots=True)
class Aim:
    """A goal as a client gives it: joints by name, or a goal whose pose is in the frame of a link."""

    joints: Mapping[str, float] | None = None
    """Positions in radians or metres; joints that are left out stay where they are."""
    goal: Goal | None = None
    frame: str = ""
    """The link in whose frame the pose of `goal` is; empty for the base."""


class ObstructionCheck(Protocol):
    """Tells what is in the way of an arm."""

    def __call__(self, positions: Array, obstacles: Obstacles, payload: Primitive | None = None) -> str:
        """What is too near on straight motions between positions, shape (n, joints), in words; empty if nothing.

        `payload` is what the arm holds, in the frame of the tool.
        """
        ...


Tell: TypeAlias = Callable[[MotionState], None]


async def in_thread(call: Callable[[], T], cancelled: Event | None = None) -> T:
    """Run a call in a thread.

    If this is cancelled, it sets `cancelled`, and returns when the thread has ended, so that only one runs.
    """
    running = asyncio.ensure_future(asyncio.to_thread(call))
    try:
        return await asyncio.shield(running)
    except asyncio.CancelledError:
        if cancelled is not None:
            cancelled.set()
        while not running.done():
            with suppress(asyncio.CancelledError):
                await asyncio.wait((running,))
        if not running.cancelled():
            running.exception()  # which nobody waits for, and asyncio would log
        raise


class _NewPlanNeeded(Exception):
    """The motion was stopped, and is to be planned again."""

    def __init__(self, reason: Reason, text: str) -> None:
        super().__init__(text)
        self.reason = reason


class PlannedArm:
    """An arm, a planner of its motions, and what is around it.

    `obstacles` returns them in the frame of the robot's base, or raises `RequestError`. `obstruction`
    compares what is left of the way with them during a motion; without it a motion is not stopped for new obstacles.
    With `in_thread` planning does not block the event loop. `on_hold` is called when what the arm holds has changed,
    so that sensors do not take it for an obstacle.
    """

    def __init__(
        self,
        robot: Robot,
        arm: Arm,
        model: RobotModel,
        planner: MotionPlanner,
        obstacles: Callable[[], Obstacles],
        *,
        obstruction: ObstructionCheck | None = None,
        authority: int = DEFAULT_AUTHORITY,
        in_thread: bool = True,
        on_hold: Callable[[Primitive | None], object] = lambda _: None,
    ) -> None:
        self.arm = arm
        self.held: Primitive | None = None
        """What the arm holds, in the frame of the tool: a part of the arm in plans and during motions."""
        self.tree = FrameTree(model.description)
        self.robot = robot
        self._model = model
        self._planner, self._obstacles, self._obstruction = planner, obstacles, obstruction
        self._authority = authority
        self._in_thread = in_thread
        self._on_hold = on_hold

    def hold(self, held: Primitive | None) -> None:
        """Count a thing in the frame of the tool as part of the arm from now on; None when the gripper is empty."""
        self._on_hold(held)
        self.held = held

    async def group(self) -> tuple[str, GroupSetup]:
        """Name and setup of the description's group with the joints of the arm; `ConfigError` if there is none."""
        return group_of(self._model, [joint.name for joint in (await self.arm.description()).joints])

    async def plan(self, aim: Aim, time_limit: float = 1.0) -> Plan:
        """Plan from where the joints are; `NoPlan` with the reason if there is no way."""
        start = await self._present()
        goal = await self._goal(aim, start)
        try:
            obstacles = self._obstacles()
        except RequestError as error:
            raise NoPlan(Reason.NO_SIGHT, str(error)) from error
        cancelled = Event()
        request = PlanRequest(start, goal, obstacles, self.held, time_limit=time_limit, is_cancelled=cancelled.is_set)
        return await self._run(lambda: self._planner.plan(request), cancelled)

    async def execute(self, plan: Plan, aim: Aim, *, max_replans: int = 3, tell: Tell, time_limit: float = 1.0) -> None:
        """Carry out a plan, with control of the arm during the motion.

        When the arm leaves the way, or something comes near what is left of it, it stops and plans again, at most
        `max_replans` times. Raises `MotionFailed` or `NoPlan` with the reason. If the call is cancelled, the arm stops.
        `tell` is called with each new state.
        """
        state = MotionState(ReportMotionPlannerState.Phase.EXECUTING, plan=plan)
        tell(state)
        async with self._controlled():
            while True:
                try:
                    await self._carry_out(plan, partial(_tell_part, tell, state))
                except _NewPlanNeeded as cause:
                    if state.replans >= max_replans:
                        times = f" after {state.replans} new plans" if state.replans else ""
                        raise MotionFailed(cause.reason, f"{cause}; the arm stands{times}") from cause
                    state = MotionState(
                        ReportMotionPlannerState.Phase.PLANNING, cause.reason, str(cause), 0.0, state.replans + 1
                    )
                    tell(state)
                    await self._until_rest()
                    plan = await self.plan(aim, time_limit)
                    state = replace(state, phase=ReportMotionPlannerState.Phase.EXECUTING, plan=plan)
                    tell(state)
                else:
                    return

    # --- inside -----------------------------------------------------------------------------------------------------

    async def _run(self, call: Callable[[], T], cancelled: Event | None = None) -> T:
        return await in_thread(call, cancelled) if self._in_thread else call()

    async def _present(self) -> tuple[float, ...]:
        try:
            present = (await self.arm.joints()).positions
            limits = await self.arm.limits()
        except (ConfigError, ResponseTimeout) as error:
            raise NoPlan(Reason.ARM_REFUSED, str(error)) from error
        return tuple(_within(value, *limits[name]) for name, value in present.items())

    async def _goal(self, aim: Aim, start: Sequence[float]) -> Goal:
        """The goal in the frame of the base, by the present positions of all joints."""
        if aim.joints is not None:
            table = await self.arm.description()
            names = [joint.name for joint in table.joints]
            if unknown := [name for name in aim.joints if name not in names]:
                text = f"the arm has no joint {unknown[0]!r}; it has {', '.join(names)}"
                raise NoPlan(Reason.WRONG_REQUEST, text)
            for joint in table.joints:
                value = aim.joints.get(joint.name)
                if value is not None and not joint.lower <= value <= joint.upper:
                    text = f"{joint.name} can be {joint.lower:.4g}..{joint.upper:.4g} {joint.unit}, and not {value:g}"
                    raise NoPlan(Reason.OUTSIDE_LIMITS, text)
            return JointGoal(tuple(aim.joints.get(name, position) for name, position in zip(names, start, strict=True)))
        assert aim.goal is not None
        if isinstance(aim.goal, JointGoal) or aim.frame in ("", self.tree.root):
            return aim.goal
        if aim.frame not in self.tree.description.links():
            known = ", ".join(sorted(self.tree.description.links()))
            raise NoPlan(Reason.WRONG_REQUEST, f"the robot has no frame {aim.frame!r}; it has: {known}")
        within = self.tree.pose(aim.frame, await self._all_joints(aim.frame))
        return replace(aim.goal, pose=within @ aim.goal.pose)

    async def _all_joints(self, frame: str) -> Mapping[str, float]:
        if self.tree.is_fixed(frame):
            return {}
        try:
            return (await self.robot.joints()).positions
        except JausError as error:
            raise NoPlan(Reason.ARM_REFUSED, f"where {frame} is cannot be told: {error}") from error

    @asynccontextmanager
    async def _controlled(self) -> AsyncIterator[None]:
        """Control of the arm, unless the program has it."""
        id = str(self.arm.info.id)
        async with AsyncExitStack() as stack:
            if not self.robot.component(id).is_controlled:
                try:
                    await stack.enter_async_context(self.robot.control(id, authority=self._authority))
                except (ControlRejected, ResponseTimeout) as error:
                    raise MotionFailed(Reason.ARM_REFUSED, str(error)) from error
            yield

    async def _carry_out(self, plan: Plan, tell: Callable[[float], None]) -> None:
        """Move through the plan; `_NewPlanNeeded` when the arm was stopped on the way."""
        legs = legs_of(plan.positions)
        path = Path(plan.positions[legs])
        start = await self._present()
        if path.distance(start) > DEVIATION:
            raise _NewPlanNeeded(Reason.DEVIATED, "the joints have moved since the plan was made")
        names = [joint.name for joint in (await self.arm.description()).joints]
        is_straight = self.arm.info.find(PROFILE) is not None
        limits = await self.arm.motion_limits()
        rows, before = list[tuple[float, dict[str, float]]](), start
        for number, last in itertools.pairwise(legs):
            end = tuple(map(float, plan.positions[last]))
            seconds = max(plan.times[last] - plan.times[number], straight_duration(limits, before, end) * SLOWER)
            rows.append((float(seconds) if is_straight else 0.0, dict(zip(names, end, strict=True))))
            before = end
        watching = asyncio.create_task(self._watch(path, tell))
        moving = asyncio.create_task(self.arm.follow(rows, straight=is_straight, timeout=GRACE))
        try:
            await asyncio.wait((watching, moving), return_when=asyncio.FIRST_COMPLETED)
            if watching.done() and not moving.done():
                moving.cancel()  # stops the arm
                with suppress(asyncio.CancelledError, JausError):
                    await moving
                watching.result()
            await moving
        except ControlRejected as error:
            raise MotionFailed(Reason.ARM_REFUSED, str(error)) from error
        except (ConfigError, ResponseTimeout) as error:
            raise MotionFailed(Reason.ARM_REFUSED, str(error)) from error
        except MotionFailed:
            raise
        except RequestError as error:
            raise MotionFailed(Reason.ARM_STOPPED, str(error)) from error
        finally:
            for task in (watching, moving):
                task.cancel()
            await asyncio.gather(watching, moving, return_exceptions=True)
        tell(1.0)

    async def _watch(self, path: Path, tell: Callable[[float], None]) -> None:
        """Follow the arm; ends with an exception when the motion must not go on."""
        clock = asyncio.get_running_loop().time
        look = moved = clock()
        part = 0.0
        try:
            async with aclosing(self.arm.watch(WATCH_RATE)) as reports:
                async for joints in reports:
                    off = path.follow(tuple(joints.positions.values()))
                    if off > DEVIATION:
                        raise _NewPlanNeeded(Reason.DEVIATED, f"a joint is {off:.2f} rad or m off the planned way")
                    if path.left > AT_END and path.part == part:
                        if clock() - moved > STANDSTILL:
                            text = f"the arm stands still after {100.0 * part:.0f} % of its way; it may be blocked"
                            raise MotionFailed(Reason.ARM_STOPPED, text)
                    else:
                        part, moved = path.part, clock()
                    tell(path.part)
                    if self._obstruction is not None and clock() >= look:
                        await self._look(path.rest())
                        look = clock() + SIGHT_INTERVAL
        except ResponseTimeout as error:
            raise MotionFailed(Reason.ARM_REFUSED, f"the arm does not report its joints any more: {error}") from error

    async def _look(self, rest: Array) -> None:
        """Compare what is left of the way with what is seen now."""
        check = self._obstruction
        assert check is not None
        try:
            obstacles = self._obstacles()
        except RequestError as error:
            raise MotionFailed(Reason.NO_SIGHT, str(error)) from error
        held = self.held
        found = await self._run(lambda: check(rest, obstacles, held))
        if found:
            raise _NewPlanNeeded(Reason.NEW_OBSTACLE, f"on what is left of the way {found}")

    async def _until_rest(self) -> None:
        before = await self._present()
        for _ in range(REST_QUERIES):
            await asyncio.sleep(REST_INTERVAL)
            now = await self._present()
            if max(abs(a - b) for a, b in zip(now, before, strict=True)) <= REST_STEP:
                return
            before = now


def _tell_part(tell: Tell, state: MotionState, part: float) -> None:
    tell(replace(state, progress=part))


def _within(value: float, lower: float, upper: float) -> float:
    """A position that encoders or controllers put a little beyond a limit, within it."""
    limited = min(upper, max(lower, value))
    return limited if abs(limited - value) <= LIMIT_NOISE else value


def group_of(model: RobotModel, joints: Sequence[str]) -> tuple[str, GroupSetup]:
    """The group of a description with exactly these joints; `ConfigError` if there is none."""
    for name, group in model.groups.items():
        if group.joints == tuple(joints):
            return name, group
    raise ConfigError(
        f"no group of the description {model.description.name} has the joints {', '.join(joints)}: is it the "
        "description of this robot?"
    )


def legs_of(positions: Array) -> list[int]:
    """Rows of a plan from which straight ways differ by at most `LEG_TOLERANCE`, the first and the last included."""
    kept = _kept(positions, 0, len(positions) - 1)
    legs = [0]
    for number in kept[1:]:
        if number == kept[-1] or np.abs(positions[number] - positions[legs[-1]]).max() >= LEAST_LEG:
            legs.append(number)
    if len(legs) > 2 and np.abs(positions[legs[-1]] - positions[legs[-2]]).max() < LEAST_LEG:
        del legs[-2]
    return legs


def _kept(positions: Array, first: int, last: int) -> list[int]:
    """Douglas and Peucker, by the joint that is off most; a loop, so that long plans do not nest."""
    kept, waiting = {first, last}, [(first, last)]
    while waiting:
        one, other = waiting.pop()
        if other - one < 2:
            continue
        between = positions[one + 1 : other]
        way = positions[other] - positions[one]
        length = float(way @ way)
        parts = np.clip((between - positions[one]) @ way / length, 0.0, 1.0) if length else np.zeros(len(between))
        off = np.abs(between - positions[one] - parts[:, None] * way).max(axis=1)
        worst = int(off.argmax())
        if off[worst] > LEG_TOLERANCE:
            middle = one + 1 + worst
            kept.add(middle)
            waiting += [(one, middle), (middle, other)]
    return sorted(kept)


class Path:
    """The way of a plan in the space of the joints, and how far along it the arm is."""

    def __init__(self, positions: Array) -> None:
        self._points = np.asarray(positions, dtype=float)
        steps = np.abs(np.diff(self._points, axis=0)).max(axis=1) if len(self._points) > 1 else np.zeros(0)
        self._lengths = np.concatenate(([0.0], np.cumsum(steps)))
        self._done = 0.0

    @property
    def part(self) -> float:
        """Part of the way that is done, 0 to 1."""
        whole = float(self._lengths[-1])
        return 1.0 if not whole else self._done / whole

    @property
    def left(self) -> float:
        """Radians or metres of the joint with the longest way that are left."""
        return float(self._lengths[-1]) - self._done

    def distance(self, positions: Sequence[float]) -> float:
        """How far the joint that is off most is from the first point, radians or metres."""
        return float(np.abs(self._points[0] - np.asarray(positions)).max())

    def follow(self, positions: Sequence[float]) -> float:
        """Note where the arm is; returns how far the joint that is off most is from the way that is left."""
        if len(self._points) < 2:
            return self.distance(positions)
        now = np.asarray(positions, dtype=float)
        starts, ways = self._points[:-1], np.diff(self._points, axis=0)
        squares = np.einsum("ij,ij->i", ways, ways)
        parts = np.clip(np.einsum("ij,ij->i", now - starts, ways) / np.where(squares, squares, 1.0), 0.0, 1.0)
        off = np.abs(now - starts - parts[:, None] * ways).max(axis=1)
        places = self._lengths[:-1] + parts * np.diff(self._lengths)
        off = np.where(places < self._done - DEVIATION, math.inf, off)
        nearest = int(off.argmin())
        if np.isinf(off[nearest]):
            return math.inf
        if places[nearest] > self._done + NOISE:
            self._done = float(places[nearest])
        return float(off[nearest])

    def rest(self) -> Array:
        """The bends of what is left of the way, from where the arm is, shape (n, joints)."""
        columns = [np.interp(self._done, self._lengths, column) for column in self._points.T]
        return np.concatenate((np.array(columns)[None], self._points[self._lengths > self._done]))
