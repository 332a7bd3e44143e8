"""The part of the demo that any backend can run: drive to the table and move the arm, over JAUS."""

from __future__ import annotations

import math
from contextlib import AsyncExitStack
from pathlib import Path
from typing import Final

from jauspy.cli.demo import plan
from jauspy.cli.demo.arm import Arm, ArmKinematics
from jauspy.cli.demo.report import DemoState, Report, StageResult, View, time_limit
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose, SetLocalWaypoint, SetTravelSpeed
from jauspy.modules.config import RobotConfig
from jauspy.modules.robot_files import robot_model
from jauspy.ocu import OCU, Control
from jauspy.ocu.robot import Robot
from jauspy.ocu.subscription import Subscription

POSE_RATE: Final = 10.0
"""Hz of the pose reports."""
X_Y_YAW: Final = 0b0100_0011
MAX_POSE_STEP: Final = 0.005
"""Metres or radians between two reports below which the robot stands."""
STATIONARY_REPORTS: Final = 8
"""Consecutive reports in which the robot must stand at its goal."""


async def to_the_table(robot: Robot, control: Control, state: DemoState) -> StageResult:
    """Drive to the table and measure the error of the final pose."""
    driver = robot.component(control.id.component).service("LocalWaypointDriver")
    sensor = robot.service("mobility:LocalPoseSensor")
    x, y = plan.TABLE_POSITION
    began = state.elapsed
    async with sensor.subscribe(
        QueryLocalPose(X_Y_YAW), rate=POSE_RATE, expects=ReportLocalPose, silence=plan.REPORT_TIMEOUT
    ) as poses:
        await driver.send(
            SetLocalWaypoint(x=x, y=-y, yaw=-plan.TABLE_HEADING, waypoint_tolerance=plan.DRIVE_TOLERANCE[0])
        )
        await driver.send(SetTravelSpeed(plan.DRIVE_SPEED))
        async with time_limit(plan.DRIVE_TIMEOUT, lambda: _timeout_message(state)):
            await _arrive(poses, control, state)
    left, turn = remaining(state)
    seconds = state.elapsed - began
    return StageResult(
        "drive",
        f"{math.hypot(x, y):g} m and a turn of {math.degrees(plan.TABLE_HEADING):g}° in {seconds:.1f} s, "
        f"{100 * left:.1f} cm and {math.degrees(turn):+.1f}° off; "
        f"{poses.received} poses at {poses.confirmed_rate:.3g} Hz, {poses.lost or 'none'} lost",
        left <= plan.DRIVE_TOLERANCE[0] and abs(turn) <= plan.DRIVE_TOLERANCE[1],
        {"distance_error": left, "heading_error": turn, "seconds": seconds, "poses_lost": poses.lost},
    )


def remaining(state: DemoState) -> tuple[float, float]:
    """Distance, m, and heading error, rad, from the goal."""
    if state.pose is None:
        return math.inf, math.inf
    x, y, yaw = state.pose
    return math.dist((x, y), plan.TABLE_POSITION), math.remainder(yaw - plan.TABLE_HEADING, math.tau)


def _timeout_message(state: DemoState) -> str:
    left, turn = remaining(state)
    to_go = f"{left:.2f} m and {math.degrees(turn):.0f}°"
    return f"the drive took longer than {plan.DRIVE_TIMEOUT:g} s, with {to_go} to go; the robot may be blocked"


async def _arrive(poses: Subscription[ReportLocalPose], control: Control, state: DemoState) -> None:
    """Wait until the robot stands at its goal; raises `ControlRejected` if control is lost."""
    still = 0
    while still < STATIONARY_REPORTS:
        control.check()
        pose, before = await poses.get(), state.pose
        state.pose = now = (pose.x or 0.0, -(pose.y or 0.0), -(pose.yaw or 0.0))
        step = math.inf if before is None else max(math.dist(now[:2], before[:2]), abs(now[2] - before[2]))
        state.speed = 0.0 if before is None else POSE_RATE * math.dist(now[:2], before[:2])
        left, turn = remaining(state)
        there = left <= plan.DRIVE_TOLERANCE[0] and abs(turn) <= plan.DRIVE_TOLERANCE[1]
        still = still + 1 if there and step < MAX_POSE_STEP else 0


CONTROLLED_MODULES: Final = ("CM-MOB", "CM-MAN", "CM-EEF")
"""Module types of which control is taken."""


class Tour:
    """One run with the robot of `config`; results are added to `report`, files written to `folder`."""

    def __init__(self, ocu: OCU, config: RobotConfig, view: View, report: Report, folder: Path) -> None:
        self._ocu, self._config, self._view, self._report, self._folder = ocu, config, view, report, folder
        self._model = robot_model(config)
        self._state = view.state
        self._modules = {module.type: config.id_of(module) for module in config.modules}

    async def run(self) -> None:
        """Run all stages; raises `JausError` if a stage fails so that the next cannot run."""
        robot = await self._discover()
        async with AsyncExitStack() as stack:
            driving, arm = await self._begin(stack, robot)
            self._step("drive", f"Drive {plan.TABLE_POSITION[0]:g} m forward and turn")
            self._add(await to_the_table(robot, driving, self._state))
            self._step("reach", "Move the arm to a pose")
            off = await arm.go(0.0, *plan.VIEW_POSE)
            self._add(StageResult("arm", f"at its pose, {off:.4f} rad off", True, {"joint_error": off}))
            self._step("", "Standby, release control")

    async def _discover(self) -> Robot:
        self._view.step(f"Discover subsystem {self._config.subsystem}")
        robot = await self._ocu.discover(self._config.subsystem)
        self._view.discovered(robot.info)
        return robot

    async def _begin(self, stack: AsyncExitStack, robot: Robot) -> tuple[Control, Arm]:
        """Take control of the moving modules until `stack` closes."""
        controls = []
        ids = [self._modules[type] for type in CONTROLLED_MODULES]
        self._view.step(f"Take control of {', '.join(map(str, ids))} with authority {plan.AUTHORITY}; Resume")
        for id in ids:
            management = robot.component(id.component).service("Management")
            controls.append(await stack.enter_async_context(management.control(plan.AUTHORITY)))
            self._state.controlled = True
            await management.resume()
        _, arm_id, gripper_id = ids
        kinematics = ArmKinematics(self._model)
        arm = Arm(
            robot, robot.component(arm_id.component), robot.component(gripper_id.component), kinematics, self._state
        )
        await stack.enter_async_context(arm.monitored())
        return controls[0], arm

    def _step(self, phase: str, text: str) -> None:
        if phase:
            self._state.phases.append((self._state.elapsed, phase))
        self._view.step(text)

    def _add(self, result: StageResult) -> None:
        self._report.results.append(result)
        self._view.add(result)
