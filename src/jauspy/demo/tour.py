"""The part of the demo that any backend can run: drive to the table and move the arm, over JAUS."""

from __future__ import annotations

import math
from contextlib import AsyncExitStack
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Final

from jauspy.demo import plan
from jauspy.demo.arm import Arm, ArmKinematics, Flippers
from jauspy.demo.plan import Plan, Waypoint
from jauspy.demo.report import DemoState, Report, StageResult, View, time_limit
from jauspy.messages.mobility import (
    QueryLocalPose,
    ReportLocalPose,
    SetLocalWaypoint,
    SetTravelSpeed,
    SetWrenchEffort,
)
from jauspy.ocu import OCU, Control
from jauspy.ocu.robot import Robot
from jauspy.ocu.service import ServiceClient
from jauspy.ocu.subscription import Subscription
from jauspy.robot.config import RobotConfig
from jauspy.robot.robot_files import robot_model

POSE_RATE: Final = 10.0
"""Hz of the pose reports."""
X_Y_YAW: Final = 0b0100_0011
MAX_POSE_STEP: Final = 0.005
"""Metres or radians between two reports below which the robot stands."""
STATIONARY_REPORTS: Final = 8
"""Consecutive reports in which the robot must stand at its goal."""


def remaining(state: DemoState, goal: Waypoint) -> tuple[float, float]:
    """Distance, m, and heading error, rad, from a waypoint."""
    if state.pose is None:
        return math.inf, math.inf
    x, y, yaw = state.pose
    return math.dist((x, y), goal.reported), math.remainder(yaw - goal.heading, math.tau)


def _timeout_message(state: DemoState, goal: Waypoint) -> str:
    left, turn = remaining(state, goal)
    to_go = f"{left:.2f} m and {math.degrees(turn):.0f}°"
    return f"the drive took longer than {plan.DRIVE_TIMEOUT:g} s, with {to_go} to go; the robot may be blocked"


async def _arrive(poses: Subscription[ReportLocalPose], control: Control, state: DemoState, goal: Waypoint) -> None:
    """Wait until the robot stands at the waypoint; raises `ControlRejected` if control is lost."""
    still = 0
    while still < STATIONARY_REPORTS:
        control.check()
        before = state.pose
        now = state.read(await poses.get(), POSE_RATE)
        step = math.inf if before is None else max(math.dist(now[:2], before[:2]), abs(now[2] - before[2]))
        left, turn = remaining(state, goal)
        there = left <= plan.DRIVE_TOLERANCE[0] and abs(turn) <= plan.DRIVE_TOLERANCE[1]
        still = still + 1 if there and step < MAX_POSE_STEP else 0


async def _push(
    driver: ServiceClient, poses: Subscription[ReportLocalPose], control: Control, state: DemoState, goal: Waypoint
) -> None:
    """Drive straight on with an effort, as far as the waypoint is away; raises `ControlRejected` if control is lost."""
    start = state.pose or (0.0, 0.0, 0.0)
    way = math.dist(start[:2], (goal.x, goal.y))
    try:
        while math.dist((state.pose or start)[:2], start[:2]) < way:
            control.check()
            await driver.send(SetWrenchEffort(propulsive_linear_effort_x=goal.effort))
            state.read(await poses.get(), POSE_RATE)
    finally:
        await driver.send(SetWrenchEffort(propulsive_linear_effort_x=0.0), ack=True)


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
            driving, flippers, arm = await self._begin(stack, robot)
            self._step("drive", f"Drive {self._plan.drive}")
            self._add(await self._drive_there(robot, driving, flippers))
            self._step("reach", "Move the arm to a pose")
            off = await arm.go(0.0, *self._plan.view)
            self._add(StageResult("arm", f"at its pose, {off:.4f} rad off", True, {"joint_error": off}))
            self._step("", "Standby, release control")

    async def _discover(self) -> Robot:
        self._view.step(f"Discover subsystem {self._config.subsystem}")
        robot = await self._ocu.discover(self._config.subsystem)
        self._view.discovered(robot.info)
        return robot

    async def _begin(self, stack: AsyncExitStack, robot: Robot) -> tuple[Control, Flippers, Arm]:
        """Take control of the moving modules until `stack` closes."""
        controls = []
        ids = [self._modules[each] for each in CONTROLLED_MODULES]
        self._view.step(f"Take control of {', '.join(map(str, ids))} with authority {plan.AUTHORITY}; Resume")
        for id in ids:
            management = robot.component(id.component).service("Management")
            controls.append(await stack.enter_async_context(management.control(plan.AUTHORITY)))
            self._state.controlled = True
            await management.resume()
        _, flippers, arm, gripper = (robot.component(id.component) for id in ids)
        moved = Arm(robot, arm, gripper, ArmKinematics(self._model), self._state)
        await stack.enter_async_context(moved.monitored())
        return controls[0], Flippers(flippers, self._model), moved

    async def _drive_there(self, robot: Robot, control: Control, flippers: Flippers) -> StageResult:
        """Drive along the waypoints of the plan, and measure the error of the final pose."""
        goals, state = self._plan, self._state
        component, tolerance = robot.component(control.id.component), plan.WAYPOINT_TOLERANCE
        driver = component.service("LocalWaypointDriver")
        sensor = robot.service("mobility:LocalPoseSensor")
        began = state.elapsed
        async with sensor.subscribe(
            QueryLocalPose(X_Y_YAW), rate=POSE_RATE, expects=ReportLocalPose, silence=plan.REPORT_TIMEOUT
        ) as poses:
            for point in goals.waypoints:
                if point.flippers is not None:
                    await flippers.go(point.flippers)
                async with time_limit(plan.DRIVE_TIMEOUT, partial(_timeout_message, state, point)):
                    if point.effort is None:
                        x, y = point.reported
                        await driver.send(SetLocalWaypoint(x=x, y=-y, yaw=-point.heading, waypoint_tolerance=tolerance))
                        await driver.send(SetTravelSpeed(point.speed))
                        await _arrive(poses, control, state, point)
                    else:
                        await _push(component.service("PrimitiveDriver"), poses, control, state, point)
        left, turn = remaining(state, goals.goal)
        seconds = state.elapsed - began
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

    def _step(self, phase: str, text: str) -> None:
        if phase:
            self._state.phases.append((self._state.elapsed, phase))
        self._view.step(text)

    def _add(self, result: StageResult) -> None:
        self._report.results.append(result)
        self._view.add(result)
