"""Motions of an arm through postures over JAUS: planned, or straight from one to the next."""

from __future__ import annotations

import asyncio
import math
from collections.abc import Callable
from typing import Final, TypeVar

import numpy as np

from jauspy.ocu.arm import Arm
from jauspy.ocu.robot import Robot
from jauspy.planning.arm_planner import ArmPlanner
from jauspy.planning.execution import Aim, MotionFailed, PlannedArm
from jauspy.planning.motion import JointGoal, Plan, PlanRequest, Reason
from jauspy.planning.obstacles import Array, Obstacles, Primitive
from jauspy.planning.timing import timed
from jauspy.platform.description import RobotModel

PLAN_TIME: Final = 2.0
"""Seconds of search for a way."""

T = TypeVar("T")


class PlannedMotions:
    """Motions of one arm; the caller has control of it. `obstacles` returns them, or raises `RequestError`."""

    def __init__(
        self,
        robot: Robot,
        arm: Arm,
        model: RobotModel,
        planner: ArmPlanner,
        obstacles: Callable[[], Obstacles],
        *,
        authority: int,
        in_thread: bool,
    ) -> None:
        """`in_thread`: planning does not block the event loop."""
        self.arm, self.planner = arm, planner
        self._obstacles, self._in_thread = obstacles, in_thread
        self._planned = PlannedArm(
            robot,
            arm,
            model,
            planner,
            obstacles,
            obstruction=planner.obstruction,
            authority=authority,
            in_thread=in_thread,
        )
        self.tree = self._planned.tree
        """Frames of the robot's links."""

    async def present(self) -> tuple[float, ...]:
        """Positions of the joints now, in radians or metres."""
        return tuple((await self.arm.joints()).positions.values())

    async def plan(self, posture: Array | tuple[float, ...], payload: Primitive | None = None) -> Plan:
        """Plan a motion from where the arm is; `NoPlan` without a way. `payload`: what is held, in the tool's frame."""
        start = np.clip(await self.present(), self.planner.arm.lower, self.planner.arm.upper)
        goal = JointGoal(tuple(map(float, posture)))
        request = PlanRequest(tuple(start.tolist()), goal, self._obstacles(), payload, PLAN_TIME)
        return await self.work(lambda: self.planner.plan(request))

    async def run(self, plan: Plan, max_replans: int) -> None:
        """Carry out a plan; `MotionFailed` or `NoPlan` if the arm does not arrive."""
        goal = dict(zip(self.planner.arm.joints, map(float, plan.positions[-1]), strict=True))
        await self._planned.execute(plan, Aim(joints=goal), max_replans=max_replans, tell=lambda _: None)

    async def straight(self, rows: Array, where: str, *, watched: bool = True) -> None:
        """Move through postures, from where the arm is; `MotionFailed` if that is not free, or the arm is stopped.

        `where` begins the sentence in that case. Without `watched` it is not compared with what is seen.
        """
        rows = np.concatenate((np.array(await self.present())[None], rows[1:]))
        if watched and (found := self.planner.obstruction(rows, self._obstacles())):
            raise MotionFailed(Reason.NEW_OBSTACLE, f"{where} {found}")
        if watched:
            times, positions = timed(self.planner.arm, list(rows))
            await self.run(Plan(times, positions, math.nan, 0.0), 0)
            return
        for row in (*rows[2:-1:3], rows[-1]):
            await self.arm.move(dict(zip(self.planner.arm.joints, map(float, row), strict=True)), duration=1.0)

    async def work(self, call: Callable[[], T]) -> T:
        """The result of a call that takes long."""
        return await asyncio.to_thread(call) if self._in_thread else call()
