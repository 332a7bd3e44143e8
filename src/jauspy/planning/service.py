"""MotionPlanner (`urn:jauspy:planning:MotionPlanner`): planning, previews and motions as a service."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Awaitable, Callable
from dataclasses import replace
from functools import partial
from typing import Final, TypeAlias

from jauspy.errors import JausError
from jauspy.geometry.poses import Pose, Transform
from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.messages.planning import (
    ExecuteMotion,
    PlanMotion,
    ReportHeldObject,
    ReportMotionPlan,
    ReportMotionPlannerSpecification,
    ReportMotionPlannerState,
    SetHeldObject,
)
from jauspy.planning.execution import Aim, MotionFailed, MotionState, PlannedArm
from jauspy.planning.held_object import WrongObjectError, read_held, report_of
from jauspy.planning.motion import NoPlan, PoseGoal, Reason, RegionGoal
from jauspy.services.service import Service
from jauspy.services.state_machine import CommandCompletion
from jauspy.services.units import sent_text

MAX_TIME_LIMIT: Final = 10.0
"""Seconds of search that a client may ask for."""
TIME_LIMIT: Final = 1.0
"""Seconds of search if the client sets no limit."""
MAX_POINTS: Final = 4096
"""Points of a plan that the report holds; of more, every other one is left out until they fit."""
Work: TypeAlias = Callable[[], Awaitable[None]]
_LOG: Final = get_logger("jauspy.planning")
_Phase: Final = ReportMotionPlannerState.Phase


class WrongGoalError(JausError):
    """A goal of a message that cannot be one; the message says why."""


class MotionPlannerService(Service, urn="urn:jauspy:planning:MotionPlanner"):
    """The planner of one arm: one plan or motion at a time, for the client in control.

    A new request ends the present one. `joints`, `base` and `tool` are names of the description.
    """

    def __init__(self, planned: PlannedArm, joints: tuple[str, ...], base: str, tool: str) -> None:
        self._planned = planned
        self._joints, self._base, self._tool = joints, base, tool
        self._number = 0
        self._state = MotionState()
        self._aim = Aim()
        self._time_limit = TIME_LIMIT
        self._task: asyncio.Task[None] | None = None
        self._next: Work | None = None
        """What begins when the present task has ended: planning in a thread cannot be interrupted."""
        self._command: CommandCompletion | None = None

    # --- commands ---------------------------------------------------------------------------------------------------

    def plan_motion(self, msg: PlanMotion) -> None:
        """Plan; the command is completed when there is a plan, and has failed if there is none."""
        self.end_motion()
        self._number, self._command = msg.plan_rec.plan_number, self.host.begin_command()
        try:
            self._aim, self._time_limit = read_aim(msg), _time_limit(msg.plan_rec.time_limit)
        except WrongGoalError as error:
            self.host.count("wrong_goal", f"{msg}")
            self._fail(Reason.WRONG_REQUEST, str(error))
            self._give_up()
            return
        self._state = MotionState(_Phase.PLANNING)
        self._begin(self._make_plan)

    def execute_motion(self, msg: ExecuteMotion) -> None:
        """Carry out the plan; the command is completed when the arm is at its end, and fails if it does not get there.

        Without effect while a motion goes on.
        """
        state, command = self._state, self.host.begin_command()
        if state.phase == _Phase.EXECUTING or (state.phase == _Phase.PLANNING and state.replans):
            self.host.count("motion_going_on", f"{msg}")
            command(False)
        elif state.phase != _Phase.PLANNED or msg.plan_number != self._number:
            self.end_motion()
            self._number = msg.plan_number
            self._fail(Reason.NO_SUCH_PLAN, f"there is no plan {msg.plan_number} that can be carried out; plan first")
            command(False)
        else:
            self._command = command
            self._state = replace(state, phase=_Phase.EXECUTING)
            self._begin(partial(self._execute, msg.max_replans))

    def cancel_motion(self) -> None:
        """End planning or motion, and forget the plan."""
        self.end_motion()
        if self._state.phase == _Phase.PLANNED:
            self._state = MotionState()

    def set_held_object(self, msg: SetHeldObject) -> None:
        """Note what the gripper holds; planning or motion end, and a plan that was made without it is forgotten."""
        self.cancel_motion()
        try:
            self._planned.hold(read_held(msg))
        except WrongObjectError as error:
            self.host.count("wrong_object", f"{msg}")
            self._fail(Reason.WRONG_REQUEST, str(error))

    def end_motion(self) -> None:
        """End planning or motion, because a client says so, or Ready is left."""
        self._next = None
        if self._state.phase in (_Phase.PLANNING, _Phase.EXECUTING):
            self._fail(Reason.CANCELLED, "it was cancelled, another request came, or the planner is not Ready any more")
        if self._task is not None:
            self._task.cancel()
        self._give_up()

    def control_lost(self) -> None:
        """End planning or motion, and forget the plan: the next client must not inherit one."""
        super().control_lost()
        self.cancel_motion()

    def leaving(self) -> None:
        """End all, since the component is closed."""
        self.cancel_motion()

    async def wait_idle(self) -> None:
        """Wait until planning or motion has ended and the arm was told to stop."""
        while self._task is not None:
            await asyncio.wait((self._task,))
            await asyncio.sleep(0)

    # --- reports ----------------------------------------------------------------------------------------------------

    def report_motion_planner_state(self) -> ReportMotionPlannerState:
        """What it does, and why it failed."""
        state = self._state
        reason = 0 if state.reason is None else state.reason.value
        return ReportMotionPlannerState(
            self._number,
            state.phase,
            ReportMotionPlannerState.Reason(reason),
            sent_text(state.text),
            math.floor(100.0 * min(1.0, max(0.0, state.progress))),
            min(state.replans, 255),
        )

    def report_motion_plan(self) -> ReportMotionPlan:
        """The plan that can be carried out, or is."""
        kind, plan = ReportMotionPlan, self._state.plan
        names = [kind.PlannedJointRec(sent_text(name)) for name in self._joints]
        if plan is None:
            return kind(kind.MotionPlanRec(plan_number=self._number, planning_time=0.0), names, [])
        step = max(1, math.ceil((len(plan.times) - 1) / (MAX_POINTS - 1)))
        rows = sorted({*range(0, len(plan.times), step), len(plan.times) - 1})
        points = [
            kind.PlannedPointSeq(
                kind.PlannedTimeRec(float(plan.times[row])),
                [kind.PlannedPositionRec(float(value)) for value in plan.positions[row]],
            )
            for row in rows
        ]
        clearance = plan.clearance if math.isfinite(plan.clearance) else None
        record = kind.MotionPlanRec(plan_number=self._number, planning_time=plan.planning_time, clearance=clearance)
        return kind(record, names, points)

    def report_motion_planner_specification(self) -> ReportMotionPlannerSpecification:
        """The arm for which it plans."""
        kind, id = ReportMotionPlannerSpecification, self._planned.arm.info.id
        return kind(
            kind.PlannedArmRec(id.subsystem, id.node, id.component, sent_text(self._base), sent_text(self._tool)),
            [kind.PlannedJointRec(sent_text(name)) for name in self._joints],
        )

    def report_held_object(self) -> ReportHeldObject:
        """What the arm holds, as it was told last, by whichever client: the thing stays when control is lost."""
        return report_of(self._planned.held)

    # --- inside -----------------------------------------------------------------------------------------------------

    async def _make_plan(self) -> None:
        plan = await self._planned.plan(self._aim, self._time_limit)
        self._state = MotionState(_Phase.PLANNED, plan=plan)

    async def _execute(self, max_replans: int) -> None:
        plan = self._state.plan
        assert plan is not None
        await self._planned.execute(
            plan, self._aim, max_replans=max_replans, tell=self._tell, time_limit=self._time_limit
        )
        self._state = MotionState(_Phase.REACHED, progress=1.0, replans=self._state.replans)

    def _begin(self, work: Work) -> None:
        if self._task is None:
            self._task = asyncio.get_running_loop().create_task(self._perform(work), name=f"planner {self.host.id}")
            self._task.add_done_callback(self._on_done)
        else:
            self._next = work

    async def _perform(self, work: Work) -> None:
        is_done = False
        try:
            await work()
            is_done = True
        except (NoPlan, MotionFailed) as error:
            self._fail(error.reason, str(error))
        except JausError as error:
            self._fail(Reason.ARM_REFUSED, str(error))
        except Exception as error:  # noqa: BLE001 - any bug of a planner from elsewhere
            _LOG.exception("%s: the planner failed", self.host.id)
            self._fail(Reason.PLANNER_FAILED, f"the planner failed: {error!r}")
        command, self._command = self._command, None
        if command is not None:  # outside of the host's calls
            self.host.set_timer(command, self.host.now, partial(command, is_done))
            self.host.on_timer_change()

    def _on_done(self, _task: asyncio.Task[None]) -> None:
        self._task, work, self._next = None, self._next, None
        if work is not None:
            self._begin(work)

    def _tell(self, state: MotionState) -> None:
        self._state = state

    def _fail(self, reason: Reason, text: str) -> None:
        self._state = MotionState(_Phase.FAILED, reason, text, self._state.progress, self._state.replans)

    def _give_up(self) -> None:
        command, self._command = self._command, None
        if command is not None:
            command(False)


def read_aim(msg: PlanMotion) -> Aim:
    """The goal of a message; `WrongGoalError` for numbers that are none, and for what is no goal."""
    goal = msg.motion_goal
    if isinstance(goal, PlanMotion.JointGoalList):
        rows = goal.joint_goal_list
        joints = {row.joint_name: row.position for row in rows}
        if not rows or len(joints) < len(rows):
            raise WrongGoalError("a goal names at least one joint, and none twice")
        _check_finite(*joints.values())
        return Aim(joints=joints)
    if isinstance(goal, PlanMotion.RegionGoalSeq):
        region = goal.goal_region_rec
        size = region.size_x, region.size_y, region.size_z
        _check_finite(*size, region.angle)
        if min(*size, region.angle) < 0.0:
            raise WrongGoalError("sides and angle of a region are 0 or more")
        return Aim(goal=RegionGoal(_pose(goal.goal_pose_rec), size, region.angle), frame=goal.goal_pose_rec.frame)
    exactly = isinstance(goal, PlanMotion.PoseGoalRec)
    return Aim(goal=PoseGoal(_pose(goal), attitude=exactly), frame=goal.frame)


def _pose(record: PlanMotion.PoseGoalRec | PlanMotion.PointGoalRec | PlanMotion.GoalPoseRec) -> Transform:
    values = record.x, record.y, record.z, record.roll, record.pitch, record.yaw
    _check_finite(*values)
    if max(map(abs, values)) > 1e6:
        raise WrongGoalError("a pose is in metres and radians, and none of its numbers above a million")
    return Transform.from_pose(Pose(*values))


def _check_finite(*values: float) -> None:
    if not all(map(math.isfinite, values)):
        raise WrongGoalError("a goal has a number that is infinite or none")


def _time_limit(value: float) -> float:
    if math.isnan(value) or value < 0.0:
        raise WrongGoalError("the time limit is 0 seconds or more")
    return min(value, MAX_TIME_LIMIT) if value else TIME_LIMIT


def is_for(report: ReportMotionPlannerSpecification, id: JausID) -> bool:
    """True if a planner plans for this component."""
    arm = report.planned_arm_rec
    return JausID(arm.subsystem_id, arm.node_id, arm.component_id) == id
