"""The arm and the gripper, with what the demo shows and measures of them, and the inverse kinematics of the arm."""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from statistics import fmean
from typing import Final

from jauspy.demo import plan
from jauspy.demo.report import DemoState
from jauspy.errors import RequestError
from jauspy.geometry.urdf import JointKind
from jauspy.geometry.vectors import GRAVITY, Vector
from jauspy.ids import JausID
from jauspy.ocu import Robot
from jauspy.platform.description import RobotModel


class ArmKinematics:
    """Inverse kinematics of group `arm`: a vertical axis, three parallel hinges and a roll joint. Metres, radians."""

    def __init__(self, model: RobotModel) -> None:
        group = model.groups["arm"]
        chain = model.description.chain(group.base, group.tip)
        self._names = group.joints
        moving = [number for number, joint in enumerate(chain) if joint.kind is not JointKind.FIXED]
        turn, shoulder, elbow, wrist, _ = moving
        self.axis = chain[turn].origin.x
        """Position of the vertical axis, metres forward of the base link's origin."""
        self._height = chain[turn].origin.z + chain[shoulder].origin.z
        self._upper, self._fore = chain[elbow].origin.x, chain[wrist].origin.x
        self._gripper_length = sum(joint.origin.x for joint in chain[wrist + 1 :])

    def around(self, target: Vector) -> tuple[float, float, float]:
        """A point of the base link's frame in cylinder coordinates: turn, distance from the vertical axis, height."""
        x, y, z = target
        return math.atan2(y, x - self.axis), math.hypot(x - self.axis, y), z

    def joints(self, turn: float, distance: float, height: float, pitch: float = 0.0) -> dict[str, float]:
        """Joint positions by name, as in the description, for a gripper that points up by `pitch`.

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
        return dict(zip(self._names, (turn, shoulder, elbow, pitch - shoulder - elbow, 0.0), strict=True))


JOINT_RATE: Final = 20.0
"""Hz of the joint position reports."""
JOINT_TOLERANCE: Final = 0.015
"""Radians; tolerance of each joint."""
GRIP_EFFORT: Final = 60.0
"""Percent."""
WEIGHT_SAMPLES: Final = 25


class Arm:
    """The arm and gripper of a robot, of which this client has control; `arm` is the component of the arm."""

    def __init__(self, robot: Robot, arm: JausID, kinematics: ArmKinematics, state: DemoState) -> None:
        self.kinematics = kinematics
        self._arm = robot.manipulator(arm)
        self._gripper = robot.gripper
        self._robot = robot
        self._state = state
        self._following: asyncio.Task[None] | None = None

    @asynccontextmanager
    async def monitored(self) -> AsyncIterator[None]:
        """Record the joint positions in the block."""
        self._following = asyncio.create_task(self._follow())
        try:
            yield
        finally:
            self._following.cancel()
            await asyncio.wait({self._following})

    async def go(
        self, turn: float, distance: float, height: float, pitch: float = 0.0, *, duration: float | None = None
    ) -> float:
        """Move the tool, with `duration` in so many seconds for all joints; returns the largest joint error, rad."""
        wanted = self.kinematics.joints(turn, distance, height, pitch)
        self._state.commanded(list(wanted.values()))
        reached = await self._arm.move(wanted, duration=duration, tolerance=JOINT_TOLERANCE, timeout=plan.MOVE_TIMEOUT)
        if self._following is not None and self._following.done():
            self._following.result()  # raises the error that ended the subscription
        return max(abs(reached[name] - position) for name, position in wanted.items())

    async def tool_height(self) -> float:
        """Height of the tool point in the robot's frame, m."""
        return (await self._arm.tool()).z

    async def open_gripper(self) -> float:
        """Open the gripper; returns the distance between the fingers, m."""
        await self._gripper.open(effort=GRIP_EFFORT, timeout=plan.GRIP_TIMEOUT)
        return await self.width()

    async def close_gripper(self) -> float:
        """Close the gripper until the fingers stop, and keep the effort; returns their distance, m."""
        await self._gripper.close(effort=GRIP_EFFORT, timeout=plan.GRIP_TIMEOUT)
        return await self.width()

    async def width(self) -> float:
        """Metres between the fingers."""
        self._state.width = await self._gripper.width()
        return self._state.width

    async def weight(self) -> float:
        """Mean weight at the wrist, including the gripper, kg."""
        return fmean([await self._weigh() for _ in range(WEIGHT_SAMPLES)])

    async def _weigh(self) -> float:
        measured = await self._robot.force_torque()
        await asyncio.sleep(1.0 / JOINT_RATE)
        return -measured.force[2] / GRAVITY

    async def _follow(self) -> None:
        async for joints in self._arm.watch(JOINT_RATE, silence=plan.REPORT_TIMEOUT):
            self._state.moved(list(joints.positions.values()))
