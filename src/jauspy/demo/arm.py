"""The arm by ManipulatorJointPositionDriver, the gripper by PrimitiveEndEffector, and their measurements."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from statistics import fmean
from typing import Final

from jauspy.demo import plan
from jauspy.demo.report import DemoState, time_limit
from jauspy.errors import RequestError
from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.urdf import JointKind
from jauspy.geometry.vectors import GRAVITY, Vector
from jauspy.messages.environment_sensing.v2_0.force_torque_sensor import QueryForceTorque, ReportForceTorque
from jauspy.messages.manipulator import (
    QueryEndEffectorPose,
    QueryJointPositions,
    ReportEndEffectorPose,
    ReportJointPositions,
    SetEndEffectorEffort,
    SetJointPositions,
)
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.platform.description import RobotModel
from jauspy.services.manipulator.joints import position_records


class ArmKinematics:
    """Inverse kinematics of group `arm`: a vertical axis, three parallel hinges and a roll joint. Metres, radians."""

    def __init__(self, model: RobotModel) -> None:
        group = model.groups["arm"]
        chain = model.description.chain(group.base, group.tip)
        self.geometry = manipulator_geometry(chain)
        moving = [number for number, joint in enumerate(chain) if joint.kind is not JointKind.FIXED]
        turn, shoulder, elbow, wrist, _ = moving
        self.axis = chain[turn].origin.x
        """Of the vertical axis, forward of the base link's origin."""
        self._height = chain[turn].origin.z + chain[shoulder].origin.z
        self._upper, self._fore = chain[elbow].origin.x, chain[wrist].origin.x
        self._gripper_length = sum(joint.origin.x for joint in chain[wrist + 1 :])

    def around(self, target: Vector) -> tuple[float, float, float]:
        """A point of the base link's frame in cylinder coordinates: turn, distance from the vertical axis, height."""
        x, y, z = target
        return math.atan2(y, x - self.axis), math.hypot(x - self.axis, y), z

    def joints(self, turn: float, distance: float, height: float, pitch: float = 0.0) -> Sequence[float]:
        """Joint positions in the standard's convention (AS6057) for a gripper that points up by `pitch`.

        Raises `RequestError` if the arm is too short.
        """
        x = distance - self._gripper_length * math.cos(pitch)
        z = height - self._height - self._gripper_length * math.sin(pitch)
        upper, fore = self._upper, self._fore
        bend = (x * x + z * z - upper**2 - fore**2) / (2.0 * upper * fore)
        if abs(bend) > 1.0:
            raise RequestError(f"the arm cannot reach {distance:.2f} m from its axis at a height of {height:.2f} m")
        elbow = -math.acos(bend)
        shoulder = math.atan2(z, x) + math.atan2(fore * math.sin(-elbow), upper + fore * math.cos(elbow))
        return self.geometry.from_urdf((turn, shoulder, elbow, pitch - shoulder - elbow, 0.0))


JOINT_RATE: Final = 20.0
"""Hz of the joint position reports."""
JOINT_TOLERANCE: Final = 0.015
"""Radians; tolerance of each joint."""
SETTLED_REPORTS: Final = 4
"""Consecutive reports in which all joints are in position and at rest."""
MAX_JOINT_STEP: Final = 1e-3
"""Radians between two reports up to which a joint is at rest."""
GRIP_EFFORT: Final = 60.0
"""Percent."""
FINGER_REST_REPORTS: Final = 8
"""Consecutive reports in which the fingers are at rest."""
MAX_FINGER_STEP: Final = 2e-4
"""Metres between two reports up to which a finger is at rest."""
FLIPPER_TOLERANCE: Final = 0.05
"""Radians."""
FORCE_Z: Final = 0b100
WEIGHT_SAMPLES: Final = 25


class Arm:
    """The arm and gripper of a robot whose CM-MAN and CM-EEF this client controls."""

    def __init__(
        self, robot: Robot, arm: ComponentClient, gripper: ComponentClient, kinematics: ArmKinematics, state: DemoState
    ) -> None:
        self.kinematics = kinematics
        self._driver = arm.service("ManipulatorJointPositionDriver")
        self._sensor = arm.service("ManipulatorJointPositionSensor")
        self._pose = arm.service("ManipulatorEndEffectorPoseSensor")
        self._gripper = gripper.service("PrimitiveEndEffector")
        self._fingers = gripper.service("ManipulatorJointPositionSensor")
        self._robot = robot
        self._state = state
        self._following: asyncio.Task[None] | None = None

    @asynccontextmanager
    async def monitored(self) -> AsyncIterator[None]:
        """Subscribe to the joint positions in the block; `go` needs them."""
        self._following = asyncio.create_task(self._follow())
        try:
            yield
        finally:
            self._following.cancel()
            await asyncio.wait({self._following})

    async def go(self, turn: float, distance: float, height: float, pitch: float = 0.0) -> float:
        """Move the tool; returns the largest joint error, rad."""
        wanted = self.kinematics.joints(turn, distance, height, pitch)
        self._state.commanded(wanted)
        await self._driver.send(SetJointPositions(position_records(wanted, self.kinematics.geometry.links)), ack=True)
        late = f"rad off after {plan.MOVE_TIMEOUT:g} s, or still moves; it may be blocked"
        async with time_limit(plan.MOVE_TIMEOUT, lambda: f"the arm is {self._off(wanted):.3f} {late}"):
            await self._arrive(wanted)
        return self._off(wanted)

    async def tool(self) -> tuple[float, float, float]:
        """The tool point in the manipulator's coordinate system, whose z is up; metres."""
        report = await self._pose.query(QueryEndEffectorPose(), expects=ReportEndEffectorPose)
        return report.tool_point_coordinate_x, report.tool_point_coordinate_y, report.tool_point_coordinate_z

    async def open_gripper(self) -> float:
        """Open the gripper; returns the distance between the fingers, m."""
        return await self._squeeze(-GRIP_EFFORT)

    async def close_gripper(self) -> float:
        """Close the gripper until the fingers stop, and keep the effort; returns their distance, m."""
        return await self._squeeze(GRIP_EFFORT)

    async def width(self) -> float:
        """Metres between the fingers."""
        report = await self._fingers.query(QueryJointPositions(), expects=ReportJointPositions)
        finger = float(report.joint_position_list[0].joint_position.value)
        self._state.finger = finger
        return 2.0 * finger

    async def weight(self) -> float:
        """Mean weight at the wrist, including the gripper, kg."""
        return fmean([await self._weigh() for _ in range(WEIGHT_SAMPLES)])

    async def _weigh(self) -> float:
        record = QueryForceTorque.QueryForceTorqueRec(1, QueryForceTorque.CoordinateSystem.VEHICLE, FORCE_Z)
        sensor = self._robot.service("ForceTorqueSensor")
        report = await sensor.query(QueryForceTorque([record]), expects=ReportForceTorque)
        await asyncio.sleep(1.0 / JOINT_RATE)
        return float(report.report_force_torque_list[0].force_z or 0.0) / GRAVITY

    async def _squeeze(self, effort: float) -> float:
        await self._gripper.send(SetEndEffectorEffort(effort), ack=True)
        await asyncio.sleep(0.5)  # until the fingers move
        width, still = await self.width(), 0
        async with time_limit(plan.GRIP_TIMEOUT, lambda: f"the fingers still move after {plan.GRIP_TIMEOUT:g} s"):
            while still < FINGER_REST_REPORTS:
                await asyncio.sleep(1.0 / JOINT_RATE)
                before, width = width, await self.width()
                still = still + 1 if abs(width - before) < MAX_FINGER_STEP else 0
        return width

    async def _follow(self) -> None:
        query = QueryJointPositions()
        async with self._sensor.subscribe(
            query, rate=JOINT_RATE, expects=ReportJointPositions, silence=plan.REPORT_TIMEOUT
        ) as reports:
            async for report in reports:
                self._state.moved([float(each.joint_position.value) for each in report.joint_position_list])

    async def _arrive(self, wanted: Sequence[float]) -> None:
        settled, before = 0, self._state.joints
        while settled < SETTLED_REPORTS:
            await asyncio.sleep(1.0 / JOINT_RATE)
            if self._following is not None and self._following.done():
                self._following.result()  # raises the error that ended the subscription
            if self._state.joints is not before:
                rests = max_difference(self._state.joints, before) <= MAX_JOINT_STEP
                settled = settled + 1 if rests and self._off(wanted) <= JOINT_TOLERANCE else 0
                before = self._state.joints

    def _off(self, wanted: Sequence[float]) -> float:
        return max_difference(self._state.joints, wanted) if self._state.joints else math.inf


class Flippers:
    """The flippers of a robot whose CM-MAN for them this client controls."""

    def __init__(self, module: ComponentClient, model: RobotModel) -> None:
        group = model.groups["flippers"]
        self._geometry = manipulator_geometry(model.description.chain(group.base, group.tip))
        self._driver = module.service("ManipulatorJointPositionDriver")
        self._sensor = module.service("ManipulatorJointPositionSensor")

    async def go(self, angle: float) -> None:
        """Turn the flippers; radians as in the URDF, upward from the front."""
        wanted = self._geometry.from_urdf((angle,))
        await self._driver.send(SetJointPositions(position_records(wanted, self._geometry.links)), ack=True)
        async with time_limit(
            plan.MOVE_TIMEOUT, lambda: f"the flippers do not reach {angle:g} rad; they may be blocked"
        ):
            while True:
                report = await self._sensor.query(QueryJointPositions(), expects=ReportJointPositions)
                at = [float(each.joint_position.value) for each in report.joint_position_list]
                if max_difference(at, wanted) <= FLIPPER_TOLERANCE:
                    return
                await asyncio.sleep(1.0 / JOINT_RATE)


def max_difference(these: Sequence[float], those: Sequence[float]) -> float:
    """The largest absolute difference of corresponding joints."""
    return max((abs(a - b) for a, b in zip(these, those, strict=False)), default=math.inf)
