"""The part of the demo that any backend can run: drive to the table and move the arm, over JAUS."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, asynccontextmanager
from itertools import pairwise
from pathlib import Path
from typing import Final

from jauspy.demo import plan
from jauspy.demo.arm import Arm, ArmKinematics
from jauspy.demo.plan import Plan, Waypoint
from jauspy.demo.report import DemoState, Report, StageResult, View, time_limit
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu import OCU, Robot, RobotControl, RobotPose, Subscription
from jauspy.robot.config import RobotConfig
from jauspy.robot.robot_files import robot_model

POSE_RATE: Final = 10.0
"""Hz of the pose reports."""
X_Y_YAW: Final = 0b0100_0011
FLIPPER_TOLERANCE: Final = 0.05
"""Radians."""


def off_by(pose: RobotPose, goal: Waypoint) -> tuple[float, float]:
    """Distance, m, and heading error, rad, from a waypoint."""
    return math.dist((pose.x, pose.y), goal.reported), math.remainder(pose.yaw - goal.heading, math.tau)


async def push(robot: Robot, control: RobotControl, goal: Waypoint, effort: float) -> RobotPose:
    """Drive straight on with an effort, as far as the waypoint is away; raises `ControlRejected` if control is lost."""
    start = pose = await robot.pose()
    way = math.dist((start.x, start.y), (goal.x, goal.y))
    try:
        while math.dist((pose.x, pose.y), (start.x, start.y)) < way:
            control.check()
            await robot.drive_effort(effort)
            await asyncio.sleep(1.0 / POSE_RATE)
            pose = await robot.pose()
    finally:
        await robot.stop()
    return pose


async def record(poses: Subscription[ReportLocalPose], state: DemoState) -> None:
    """Take the poses for display."""
    async for report in poses:
        state.read(report, POSE_RATE)


CONTROLLED_MODULES: Final = (("CM-MOB", None), ("CM-MAN", "flippers"), ("CM-MAN", "arm"), ("CM-EEF", "gripper"))
"""Types and groups of the modules of which control is taken."""


class Tour:
    """One run with the robot of `config`; results are added to `report`, files written to `folder`."""

    def __init__(self, ocu: OCU, config: RobotConfig, view: View, report: Report, folder: Path, *, goals: Plan) -> None:
        self._ocu, self._config, self._view, self._report, self._folder = ocu, config, view, report, folder
        self._plan = goals
        self._model = robot_model(config)
        self._state = view.state
        self._modules = {(module.type, module.moves): config.id_of(module) for module in config.modules}

    async def run(self) -> None:
        """Run all stages; raises `JausError` if a stage fails so that the next cannot run."""
        robot = await self._discover()
        async with AsyncExitStack() as stack:
            control, arm = await self._begin(stack, robot)
            self._step("drive", f"Drive {self._plan.drive}")
            self._add(await self._drive_there(robot, control))
            self._step("reach", "Move the arm to a pose")
            off = await arm.go(0.0, *self._plan.view)
            self._add(StageResult("arm", f"at its pose, {off:.4f} rad off", True, {"joint_error": off}))
            self._step("", "Standby, release control")

    async def _discover(self) -> Robot:
        self._view.step(f"Discover subsystem {self._config.subsystem}")
        robot = await self._ocu.discover(self._config.subsystem)
        self._view.discovered(robot.info)
        return robot

    async def _begin(self, stack: AsyncExitStack, robot: Robot) -> tuple[RobotControl, Arm]:
        """Take control of the moving modules until `stack` closes."""
        ids = [self._modules[module] for module in CONTROLLED_MODULES]
        self._view.step(f"Take control of {', '.join(map(str, ids))} with authority {plan.AUTHORITY}; Resume")
        control = robot.control(*map(str, ids), authority=plan.AUTHORITY)
        await stack.enter_async_context(control)
        self._state.controlled = True
        arm = Arm(robot, self._modules["CM-MAN", "arm"], ArmKinematics(self._model), self._state)
        await stack.enter_async_context(arm.monitored())
        return control, arm

    async def _drive_there(self, robot: Robot, control: RobotControl) -> StageResult:
        """Drive along the waypoints of the plan, and measure the error of the final pose."""
        goals, began = self._plan, self._state.elapsed
        async with self._following(robot) as poses:
            for point in goals.waypoints:
                pose = await self._drive_to(robot, control, point)
        left, turn = off_by(pose, goals.goal)
        seconds = self._state.elapsed - began
        places = [(0.0, 0.0), *((point.x, point.y) for point in goals.waypoints)]
        way = sum(math.dist(one, other) for one, other in pairwise(places))
        return StageResult(
            "drive",
            f"{way:.2g} m and to a heading of {math.degrees(goals.goal.heading):g}° in {seconds:.1f} s, "
            f"{100 * left:.1f} cm and {math.degrees(turn):+.1f}° off; "
            f"{poses.received} poses at {poses.confirmed_rate:.3g} Hz, {poses.lost or 'none'} lost",
            left <= plan.DRIVE_TOLERANCE[0] and abs(turn) <= plan.DRIVE_TOLERANCE[1],
            {"distance_error": left, "heading_error": turn, "seconds": seconds, "poses_lost": poses.lost},
        )

    async def _drive_to(self, robot: Robot, control: RobotControl, point: Waypoint) -> RobotPose:
        if point.flippers is not None:
            flippers = robot.manipulator(self._modules["CM-MAN", "flippers"])
            positions = dict.fromkeys(self._model.groups["flippers"].joints, point.flippers)
            await flippers.move(positions, tolerance=FLIPPER_TOLERANCE, timeout=plan.MOVE_TIMEOUT)
        if point.effort is not None:
            late = f"the robot is not at {point.reported} after {plan.DRIVE_TIMEOUT:g} s; it may be blocked"
            async with time_limit(plan.DRIVE_TIMEOUT, lambda: late):
                return await push(robot, control, point, point.effort)
        return await robot.go_to(
            *point.reported,
            point.heading,
            speed=point.speed,
            tolerance=plan.WAYPOINT_TOLERANCE,
            accept=plan.DRIVE_TOLERANCE[0],
            timeout=plan.DRIVE_TIMEOUT,
        )

    @asynccontextmanager
    async def _following(self, robot: Robot) -> AsyncIterator[Subscription[ReportLocalPose]]:
        """Record the reported poses in the block; raises the error that ends the subscription."""
        sensor = robot.service("mobility:LocalPoseSensor")
        async with sensor.subscribe(
            QueryLocalPose(X_Y_YAW), rate=POSE_RATE, expects=ReportLocalPose, silence=plan.REPORT_TIMEOUT
        ) as poses:
            recording = asyncio.create_task(record(poses, self._state), name="poses of the demo")
            try:
                yield poses
                if recording.done():
                    recording.result()
            finally:
                recording.cancel()
                await asyncio.wait({recording})

    def _step(self, phase: str, text: str) -> None:
        if phase:
            self._state.phases.append((self._state.elapsed, phase))
        self._view.step(text)

    def _add(self, result: StageResult) -> None:
        self._report.results.append(result)
        self._view.add(result)
