"""The arm by ManipulatorJointPositionDriver, the gripper by PrimitiveEndEffector, and what they feel."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager
from statistics import fmean
from typing import Final

from jauspy.cli.demo import plan
from jauspy.cli.demo.patience import within
from jauspy.cli.demo.reach import Hand
from jauspy.cli.demo.watch import Scene
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
from jauspy.services.manipulator.joints import position_records

RATE: Final = 20.0
"""Hz of the joints' positions."""
EXACT: Final = 0.015
"""Radians by which each joint may be off."""
SETTLED: Final = 4
"""Reports in a row in which all are there, and rest."""
RESTS_AT: Final = 1e-3
"""Radians that a joint at rest moves at most from one report to the next."""
GRIP: Final = 60.0
"""Percent of the gripper's effort."""
RESTS: Final = 8
"""Reports in a row in which the fingers rest."""
AT_REST: Final = 2e-4
"""Metres that a finger at rest moves at most from one report to the next."""
FORCE_Z: Final = 0b100
GRAVITY: Final = 9.81
WEIGHINGS: Final = 25


class Arm:
    """The arm of a robot whose CM-MAN and CM-EEF are in our control."""

    def __init__(self, robot: Robot, arm: ComponentClient, gripper: ComponentClient, hand: Hand, scene: Scene) -> None:
        self.hand = hand
        self._driver = arm.service("ManipulatorJointPositionDriver")
        self._sensor = arm.service("ManipulatorJointPositionSensor")
        self._pose = arm.service("ManipulatorEndEffectorPoseSensor")
        self._gripper = gripper.service("PrimitiveEndEffector")
        self._fingers = gripper.service("ManipulatorJointPositionSensor")
        self._robot = robot
        self._scene = scene
        self._following: asyncio.Task[None] | None = None

    @asynccontextmanager
    async def watched(self) -> AsyncIterator[None]:
        """Its joints are followed as long as this lasts; `go` needs it."""
        self._following = asyncio.create_task(self._follow())
        try:
            yield
        finally:
            self._following.cancel()
            await asyncio.wait({self._following})

    async def go(self, turn: float, distance: float, height: float, pitch: float = 0.0) -> float:
        """Bring the tool there; returns by how much the joint that is farthest off is off, radians."""
        wanted = self.hand.joints(turn, distance, height, pitch)
        self._scene.commanded(wanted)
        await self._driver.send(SetJointPositions(position_records(wanted, self.hand.geometry.links)), ack=True)
        late = f"rad off after {plan.MOVE_TIME:g} s, or does not rest; it may touch something"
        async with within(plan.MOVE_TIME, lambda: f"the arm is {self._off(wanted):.3f} {late}"):
            await self._arrive(wanted)
        return self._off(wanted)

    async def tool(self) -> tuple[float, float, float]:
        """The tool point in the manipulator's coordinate system, whose z is up; metres."""
        report = await self._pose.query(QueryEndEffectorPose(), expects=ReportEndEffectorPose)
        return report.tool_point_coordinate_x, report.tool_point_coordinate_y, report.tool_point_coordinate_z

    async def open_gripper(self) -> float:
        """As far as it goes; returns the distance between the fingers."""
        return await self._squeeze(-GRIP)

    async def close_gripper(self) -> float:
        """Until something is between the fingers, or they meet; returns their distance. It goes on squeezing."""
        return await self._squeeze(GRIP)

    async def width(self) -> float:
        """Metres between the fingers."""
        report = await self._fingers.query(QueryJointPositions(), expects=ReportJointPositions)
        finger = float(report.joint_position_list[0].joint_position.value)
        self._scene.finger = finger
        return 2.0 * finger

    async def weight(self) -> float:
        """Kilograms that hang on the wrist, the gripper included; the mean of some measurements."""
        return fmean([await self._weigh() for _ in range(WEIGHINGS)])

    async def _weigh(self) -> float:
        record = QueryForceTorque.QueryForceTorqueRec(1, QueryForceTorque.CoordinateSystem.VEHICLE, FORCE_Z)
        sensor = self._robot.service("ForceTorqueSensor")
        report = await sensor.query(QueryForceTorque([record]), expects=ReportForceTorque)
        await asyncio.sleep(1.0 / RATE)
        return float(report.report_force_torque_list[0].force_z or 0.0) / GRAVITY

    async def _squeeze(self, effort: float) -> float:
        await self._gripper.send(SetEndEffectorEffort(effort), ack=True)
        await asyncio.sleep(0.5)  # until the fingers move
        width, still = await self.width(), 0
        async with within(plan.GRIP_TIME, lambda: f"the fingers do not rest after {plan.GRIP_TIME:g} s"):
            while still < RESTS:
                await asyncio.sleep(1.0 / RATE)
                before, width = width, await self.width()
                still = still + 1 if abs(width - before) < AT_REST else 0
        return width

    async def _follow(self) -> None:
        query = QueryJointPositions()
        async with self._sensor.subscribe(
            query, rate=RATE, expects=ReportJointPositions, silence=plan.SILENCE
        ) as reports:
            async for report in reports:
                self._scene.moved([float(each.joint_position.value) for each in report.joint_position_list])

    async def _arrive(self, wanted: Sequence[float]) -> None:
        settled, before = 0, self._scene.joints
        while settled < SETTLED:
            await asyncio.sleep(1.0 / RATE)
            if self._following is not None and self._following.done():
                self._following.result()  # raises why nothing is heard of the joints any more
            if self._scene.joints is not before:
                rests = farthest(self._scene.joints, before) <= RESTS_AT
                settled = settled + 1 if rests and self._off(wanted) <= EXACT else 0
                before = self._scene.joints

    def _off(self, wanted: Sequence[float]) -> float:
        return farthest(self._scene.joints, wanted) if self._scene.joints else math.inf


def farthest(these: Sequence[float], those: Sequence[float]) -> float:
    """The largest difference of two joints of the same number."""
    return max((abs(a - b) for a, b in zip(these, those, strict=False)), default=math.inf)
