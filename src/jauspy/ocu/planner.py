"""Motions of an arm around obstacles by a component that plans them (service MotionPlanner)."""

# ruff: noqa: ASYNC109 - a timeout ends in an error that says what the planner does

from __future__ import annotations

import asyncio
import math
import secrets
from collections.abc import AsyncGenerator, Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.arguments import check_number, check_text
from jauspy.errors import ConfigError, RequestError
from jauspy.ids import JausID
from jauspy.messages.planning import (
    CancelMotion,
    ExecuteMotion,
    PlanMotion,
    QueryHeldObject,
    QueryMotionPlan,
    QueryMotionPlannerSpecification,
    QueryMotionPlannerState,
    ReportHeldObject,
    ReportMotionPlan,
    ReportMotionPlannerSpecification,
    ReportMotionPlannerState,
    SetHeldObject,
)
from jauspy.ocu.connection import Connection
from jauspy.ocu.explain import check_ready
from jauspy.ocu.subscription import subscribe
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.printable import printable

PLANNER: Final = "planning:MotionPlanner"
POLL_INTERVAL: Final = 0.05
"""Seconds between two queries for the state of planning, and of a motion."""
PATIENCE: Final = 15.0
"""Seconds that planning may take longer than its limit."""
ANY_ATTITUDE: Final = math.pi
"""Radians by which any two attitudes differ at most."""
LARGEST_NUMBER: Final = 0xFFFFFFFF


@dataclass(frozen=True, slots=True)
class MotionPlan:
    """A planned motion, linear between its points."""

    number: int
    joints: tuple[str, ...]
    """Names of the joints, base to tip."""
    times: tuple[float, ...]
    """Seconds from the start of the motion."""
    positions: tuple[tuple[float, ...], ...]
    """Radians or metres, of all joints, one row for each time."""
    clearance: float
    """Least distance in metres to obstacles and of the robot to itself on the way; NaN if it is not known."""
    planning_time: float
    """Seconds that the planning took."""

    @property
    def duration(self) -> float:
        """Seconds; the arm may take longer, since it comes to rest at each bend."""
        return self.times[-1] if self.times else 0.0

    def at(self, time: float) -> dict[str, float]:
        """Positions by name of the joint at a time in seconds."""
        later = next((row for row, other in enumerate(self.times) if other >= time), len(self.times) - 1)
        if later == 0:
            return dict(zip(self.joints, self.positions[0], strict=True))
        first, last = self.times[later - 1], self.times[later]
        part = min(1.0, (time - first) / (last - first)) if last > first else 1.0
        rows = zip(self.joints, self.positions[later - 1], self.positions[later], strict=True)
        return {name: before + part * (after - before) for name, before, after in rows}


@dataclass(frozen=True, slots=True)
class PlannerState:
    """The state of a planner: `phase` is "idle", "planning", "planned", "executing", "reached" or "failed"."""

    number: int
    """Number of the plan."""
    phase: str
    reason: str
    """Why it failed or plans again, as in "no_way"; empty without a reason."""
    text: str
    """Reason in words."""
    progress: float
    """Part of the way that is done, 0 to 1."""
    replans: int
    """New plans during the motion."""


@dataclass(frozen=True, slots=True)
class HeldObject:
    """What a gripper holds, in the frame of the tool: metres and radians."""

    shape: str
    """"box", "sphere" or "cylinder"; a cylinder is around its z axis."""
    size: tuple[float, float, float]
    """Sides of the box around it, along its own axes."""
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Its middle."""
    rpy: tuple[float, float, float] = (0.0, 0.0, 0.0)
    name: str = ""
    """Name in sentences of the planner."""


class PlanningFailed(RequestError):
    """There is no plan, or its motion ended early; the message says why, and `reason` is as in `PlannerState`."""

    def __init__(self, state: PlannerState) -> None:
        super().__init__(state.text or f"the planner reports {state.phase}")
        self.reason = state.reason


class Planner:
    """A planner of the motions of one arm. Planning and motions need control of it, and not of the arm.

    Only one plan is kept; it begins where the joints are when it is made. Metres and radians; poses are those of the
    tool link in the frame of a link of the robot's description, by default in that of the robot.
    """

    def __init__(self, connection: Connection, info: ComponentInfo) -> None:
        self.info: ComponentInfo = info
        """Id and services of the component."""
        self._connection = connection

    def __repr__(self) -> str:
        return f"<planner {self.info.id}>"

    async def arm(self) -> JausID:
        """The component of the arm for which it plans."""
        record = (await self._specification()).planned_arm_rec
        return JausID(record.subsystem_id, record.node_id, record.component_id)

    async def joints(self) -> tuple[str, ...]:
        """Names of the joints that it moves, base to tip."""
        return tuple(joint.joint_name for joint in (await self._specification()).planned_joint_list)

    async def plan_joints(self, joints: Mapping[str, float], *, time_limit: float = 0.0) -> MotionPlan:
        """Plan a motion of joints to positions, as in `{"elbow": 0.6}`; the others stay.

        Nothing moves. `time_limit`: seconds of search, 0 for the planner's own. Raises `PlanningFailed` with the
        reason if there is no way.
        """
        if not joints:
            raise ConfigError('joints are given by name, as in {"elbow": 0.6}')
        for name, value in joints.items():
            check_text(name, "a joint's name")
            check_number(value, f"the position of {name}")
        rows = [PlanMotion.JointGoalRec(name, float(value)) for name, value in joints.items()]
        return await self._plan(PlanMotion.JointGoalList(rows), time_limit)

    async def plan_pose(
        self,
        position: Sequence[float],
        rpy: Sequence[float] | None = None,
        *,
        frame: str = "",
        time_limit: float = 0.0,
    ) -> MotionPlan:
        """Plan a motion of the tool to a pose; without `rpy` (roll, pitch, yaw) any attitude will do.

        `frame` is a link of the robot's description, where it is now. Otherwise as `plan_joints`.
        """
        point, angles = _three(position, "position"), None if rpy is None else _three(rpy, "rpy")
        check_text(frame, "a frame")
        if angles is None:
            return await self._plan(PlanMotion.PointGoalRec(frame, *point, 0.0, 0.0, 0.0), time_limit)
        return await self._plan(PlanMotion.PoseGoalRec(frame, *point, *angles), time_limit)

    async def plan_region(
        self,
        position: Sequence[float],
        rpy: Sequence[float] = (0.0, 0.0, 0.0),
        *,
        size: Sequence[float],
        angle: float = ANY_ATTITUDE,
        frame: str = "",
        time_limit: float = 0.0,
    ) -> MotionPlan:
        """Plan a motion of the tool into a box around a point, its sides along the axes of `rpy`.

        The attitude of the tool may differ from `rpy` by `angle`. Otherwise as `plan_pose`.
        """
        check_number(angle, "angle")
        check_text(frame, "a frame")
        pose = PlanMotion.GoalPoseRec(frame, *_three(position, "position"), *_three(rpy, "rpy"))
        region = PlanMotion.GoalRegionRec(*_three(size, "size"), float(angle))
        return await self._plan(PlanMotion.RegionGoalSeq(pose, region), time_limit)

    async def hold(self, held: HeldObject | None) -> None:
        """State what the gripper holds: from now on it is planned for as a part of the arm; None for nothing.

        Planning and motion end, and the plan is forgotten. Raises `RequestError` with the reason if it is not taken.
        """
        message = _nothing_held() if held is None else _held_message(held)
        await check_ready(self._connection, self.info.id)
        await self._connection.send_checked(self.info.id, message, ack=True)
        taken = await self.held()
        if (None if taken is None else taken.shape) != (None if held is None else held.shape):
            state = await self.state()
            raise RequestError(f"{self.info.id} does not take what is held: {state.text or 'it reports another'}")

    async def held(self) -> HeldObject | None:
        """What the planner takes the gripper to hold."""
        report = await self._connection.query(self.info.id, QueryHeldObject(), expects=ReportHeldObject)
        assert isinstance(report, ReportHeldObject)
        if report.shape == ReportHeldObject.Shape.NOTHING:
            return None
        shape = report.shape.name.lower() if isinstance(report.shape, ReportHeldObject.Shape) else str(report.shape)
        return HeldObject(
            shape,
            (report.size_x, report.size_y, report.size_z),
            (report.x, report.y, report.z),
            (report.roll, report.pitch, report.yaw),
            printable(report.object_name),
        )

    async def preview(self) -> MotionPlan | None:
        """The plan that can be carried out, or is; None if there is none."""
        report = await self._connection.query(self.info.id, QueryMotionPlan(), expects=ReportMotionPlan)
        assert isinstance(report, ReportMotionPlan)
        return plan_of(report)

    async def execute(
        self,
        plan: MotionPlan,
        *,
        max_replans: int = 3,
        progress: Callable[[PlannerState], None] | None = None,
        timeout: float = 120.0,
    ) -> PlannerState:
        """Have the arm carry out the plan, and wait until it is there.

        When the arm leaves the way, or an obstacle comes near what is left of it, it stops and plans again, at most
        `max_replans` times. `progress` is called with each state that differs from the one before. Raises
        `PlanningFailed` with the reason when the motion ends early, `RequestError` when it has not ended after
        `timeout` seconds. Then, and if the call is cancelled, the arm stops.
        """
        check_number(max_replans, "max_replans", whole=True)
        check_number(timeout, "timeout")
        if not 0 <= max_replans <= 255:
            raise ConfigError(f"max_replans={max_replans} is not 0..255")
        await check_ready(self._connection, self.info.id)
        try:
            await self._connection.send_checked(self.info.id, ExecuteMotion(plan.number, max_replans), ack=True)
            return await self._ended(plan.number, ("planned", "planning", "executing"), timeout, progress)
        except BaseException as error:
            if not isinstance(error, PlanningFailed):
                await self._stop()
            raise

    async def cancel(self) -> None:
        """End planning, or stop the arm; the plan is forgotten."""
        await self._connection.send_checked(self.info.id, CancelMotion(), ack=True)

    async def state(self) -> PlannerState:
        """The present state."""
        query = QueryMotionPlannerState()
        report = await self._connection.query(self.info.id, query, expects=ReportMotionPlannerState)
        assert isinstance(report, ReportMotionPlannerState)
        return state_of(report)

    async def watch(self) -> AsyncGenerator[PlannerState, None]:
        """Each change of the state, as in `async for state in planner.watch()`, by a subscription."""
        query = QueryMotionPlannerState()
        async with subscribe(
            self._connection, self.info.id, query, ReportMotionPlannerState, rate=None, buffer=64
        ) as reports:
            async for report in reports:
                yield state_of(report)

    # --- inside -----------------------------------------------------------------------------------------------------

    async def _specification(self) -> ReportMotionPlannerSpecification:
        query = QueryMotionPlannerSpecification()
        report = await self._connection.query(self.info.id, query, expects=ReportMotionPlannerSpecification)
        assert isinstance(report, ReportMotionPlannerSpecification)
        return report

    async def _plan(
        self,
        goal: PlanMotion.JointGoalList | PlanMotion.PoseGoalRec | PlanMotion.PointGoalRec | PlanMotion.RegionGoalSeq,
        time_limit: float,
    ) -> MotionPlan:
        check_number(time_limit, "time_limit")
        number = secrets.randbelow(LARGEST_NUMBER) + 1
        await check_ready(self._connection, self.info.id)
        message = PlanMotion(PlanMotion.PlanRec(number, time_limit), goal)
        await self._connection.send_checked(self.info.id, message, ack=True)
        await self._ended(number, ("planning",), time_limit + PATIENCE)
        plan = await self.preview()
        if plan is None or plan.number != number:
            raise RequestError(f"{self.info.id} has forgotten the plan: another program uses the planner, too")
        return plan

    async def _ended(
        self,
        number: int,
        active: Sequence[str],
        timeout: float,
        tell: Callable[[PlannerState], None] | None = None,
    ) -> PlannerState:
        """The state in which planning or motion ended; `active` are the phases in which it has not."""
        clock, before = asyncio.get_running_loop().time, None
        end = clock() + timeout
        while True:
            state = await self.state()
            if tell is not None and state != before and state.number == number:
                tell(state)
            before = state
            if state.number == number and state.phase not in active:
                if state.phase == "failed":
                    raise PlanningFailed(state)
                return state
            if clock() > end:
                what = "takes no request" if state.number != number else f"is still {state.phase}"
                raise RequestError(f"the planner {self.info.id} {what} after {timeout:g} s")
            await asyncio.sleep(POLL_INTERVAL)

    async def _stop(self) -> None:
        if self.info.id in self._connection.controls:
            await self._connection.send_checked(self.info.id, CancelMotion(), ack=True)


def plan_of(report: ReportMotionPlan) -> MotionPlan | None:
    """The plan in a report; None if it has none, or one whose rows do not match its joints."""
    names = tuple(joint.joint_name for joint in report.planned_joint_list)
    times = tuple(point.planned_time_rec.time for point in report.planned_point_list)
    rows = tuple(tuple(item.position for item in point.planned_position_list) for point in report.planned_point_list)
    numbers = (*times, *(value for row in rows for value in row))
    if not rows or any(len(row) != len(names) for row in rows) or not all(map(math.isfinite, numbers)):
        return None
    record = report.motion_plan_rec
    clearance = math.nan if record.clearance is None else record.clearance
    return MotionPlan(record.plan_number, names, times, rows, clearance, record.planning_time)


def state_of(report: ReportMotionPlannerState) -> PlannerState:
    """The state in a report; unknown phases and reasons are numbers."""
    phase, reason = report.phase, report.reason
    return PlannerState(
        report.plan_number,
        phase.name.lower() if isinstance(phase, ReportMotionPlannerState.Phase) else str(phase),
        ""
        if not reason
        else reason.name.lower()
        if isinstance(reason, ReportMotionPlannerState.Reason)
        else str(reason),
        printable(report.reason_text),
        report.progress / 100.0,
        report.replans,
    )


def _nothing_held() -> SetHeldObject:
    return SetHeldObject(SetHeldObject.Shape.NOTHING, "", *(0.0,) * 9)


def _held_message(held: HeldObject) -> SetHeldObject:
    shapes = [shape.name.lower() for shape in SetHeldObject.Shape if shape]
    if held.shape not in shapes:
        raise ConfigError(f"shape={held.shape!r} of a held object is none of {', '.join(shapes)}")
    check_text(held.name, "a held object's name")
    size = _three(held.size, "size")
    if min(size) <= 0.0:
        raise ConfigError(f"size is three numbers above 0, in metres, not {size}")
    shape = SetHeldObject.Shape[held.shape.upper()]
    return SetHeldObject(shape, held.name, *_three(held.position, "position"), *_three(held.rpy, "rpy"), *size)


def _three(values: Sequence[float], name: str) -> tuple[float, float, float]:
    if isinstance(values, str | int | float) or len(values) != 3:
        raise TypeError(f"{name} is three numbers, as in (0.7, 0.0, 0.4)")
    for number in values:
        check_number(number, name)
    x, y, z = map(float, values)
    if not all(map(math.isfinite, (x, y, z))):
        raise ConfigError(f"{name} is three finite numbers, as in (0.7, 0.0, 0.4), not {(x, y, z)}")
    return x, y, z
