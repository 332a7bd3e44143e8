"""One interface for arms with the services of AS6057 and for the modular arm of a factory cell."""

from __future__ import annotations

import asyncio
import itertools
import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from jauspy.codec.message import Message
from jauspy.console.languages import sentence
from jauspy.errors import ConfigError, JausError, RequestError
from jauspy.messages.cell import (
    HoldModularArm,
    QueryModularArmSpecification,
    QueryModularArmState,
    ReportModularArmSpecification,
    ReportModularArmState,
)
from jauspy.ocu.arm import (
    PAN_TILT_DRIVER,
    POSE_DRIVER,
    POSE_SENSOR,
    POSITION_DRIVER,
    PROFILE,
    SPECIFICATION,
    VELOCITY_DRIVER,
)
from jauspy.ocu.motion_limits import MotionLimits
from jauspy.ocu.robot import MOVING, Robot
from jauspy.ocu.subsystems import ComponentInfo
from jauspy.platform.modular.arm import TrajectoryPoint
from jauspy.printable import printable
from jauspy.services.cell import motion_command, trajectory_command

MODULAR_ARM: Final = "cell:ModularArm"
CONNECTOR: Final = "cell:VacuumConnector"
CONVEYOR: Final = "cell:Conveyor"
GRACE_TIME: Final = 10.0
"""Seconds that a motion of a modular arm may take in addition to its duration."""
EASING: Final = 2.0
"""Greatest speed of a modular arm's motion as a multiple of the mean one, rounded up."""

Row: TypeAlias = tuple[float, Mapping[str, float]]
"""The duration of a motion in seconds, and the positions at its end by joint."""


def joint_label(name: str) -> str:
    """The name of a joint as panels show it: of `base_link_to_arm_link_1` the link that it moves."""
    return printable(name).rpartition("_to_")[2]


@dataclass(frozen=True, slots=True)
class JointInfo:
    """A joint: radians or metres; limits are infinite where there are none."""

    name: str
    is_revolute: bool
    lower: float
    upper: float
    motion: MotionLimits

    @property
    def unit(self) -> str:
        """The unit of its positions."""
        return "rad" if self.is_revolute else "m"

    def shown_range(self, position: float) -> tuple[float, float]:
        """The range of a slider: the limits, or the present turn of a joint without."""
        turn = round(position / math.tau) * math.tau if self.is_revolute else round(position)
        half = math.pi if self.is_revolute else 1.0
        low = self.lower if math.isfinite(self.lower) else min(turn - half, self.upper - 2.0 * half)
        return low, self.upper if math.isfinite(self.upper) else max(turn + half, low + 2.0 * half)


class Manipulator(ABC):
    """One arm, or another group of joints."""

    def __init__(self, robot: Robot, info: ComponentInfo) -> None:
        self.robot = robot
        self.info = info

    @property
    def title(self) -> str:
        """Name and id of the manipulator."""
        return f"{printable(self.info.name) or 'arm'}  {self.info.id}"

    @property
    def has_tool(self) -> bool:
        """True if its tool can be moved along and about axes."""
        return False

    @property
    def has_speed(self) -> bool:
        """True if its speed can be limited."""
        return True

    @abstractmethod
    async def joints(self) -> tuple[JointInfo, ...]:
        """The joints, base to tip; those of a modular arm change with its modules."""

    @abstractmethod
    async def positions(self) -> dict[str, float]:
        """The measured positions by joint."""

    @abstractmethod
    async def tool(self) -> str:
        """The pose of the tool as text; empty if the arm does not report it."""

    @abstractmethod
    async def move(self, positions: Mapping[str, float], share: float) -> None:
        """Move joints, with at most a share of their speeds, and wait until they are there."""

    @abstractmethod
    async def follow(self, rows: Sequence[Row], progress: Callable[[int], None]) -> None:
        """Move through rows; all are checked before anything moves."""

    async def poses(self) -> tuple[str, ...]:
        """The names of the poses that the robot itself knows for these joints, as it reports them."""
        return ()

    async def move_to(self, name: str) -> None:
        """Move to one of these poses, and wait until the joints are there."""
        raise ConfigError(sentence("{component} knows no pose {name!r}", component=self.info.id, name=name))

    @abstractmethod
    async def stop(self) -> None:
        """Hold."""


class StandardArm(Manipulator):
    """An arm with the services of AS6057."""

    def __init__(self, robot: Robot, info: ComponentInfo) -> None:
        super().__init__(robot, info)
        self.arm = robot.manipulator(str(info.id))

    @property
    def has_tool(self) -> bool:
        """True if it takes velocities or poses of its tool and reports the tool's pose."""
        find = self.info.find
        moves = find(VELOCITY_DRIVER) or find(POSE_DRIVER)
        return bool(moves and find(POSE_SENSOR) and find(SPECIFICATION))

    @property
    def has_speed(self) -> bool:
        """True if it takes motion profiles."""
        return self.info.find(PROFILE) is not None

    async def joints(self) -> tuple[JointInfo, ...]:
        """The joints of the robot's description."""
        table, limits = await self.arm.description(), await self.arm.motion_limits()
        return tuple(
            JointInfo(joint.name, joint.is_revolute, joint.lower, joint.upper, limits[joint.name])
            for joint in table.joints
        )

    async def positions(self) -> dict[str, float]:
        """The measured positions by joint."""
        return dict((await self.arm.joints()).positions)

    async def tool(self) -> str:
        """Position and attitude in the robot's frame."""
        if not self.has_tool:
            return ""
        pose = await self.arm.tool()
        degrees = (round(math.degrees(angle)) for angle in (pose.roll, pose.pitch, pose.yaw))
        return _place((pose.x, pose.y, pose.z)) + "  \u00b7  {}\u00b0 {}\u00b0 {}\u00b0".format(*degrees)

    async def move(self, positions: Mapping[str, float], share: float) -> None:
        """Move joints, with at most a share of their speeds."""
        speeds = {}
        if share < 1.0 and self.has_speed:
            limits = await self.arm.motion_limits()
            speeds = {name: share * limit.speed for name, limit in limits.items() if math.isfinite(limit.speed)}
        await self.arm.move(positions, speed=speeds or None)

    async def follow(self, rows: Sequence[Row], progress: Callable[[int], None]) -> None:
        """Move through rows, as a list if the component supports lists."""
        await self.arm.follow(rows, progress=progress)

    async def poses(self) -> tuple[str, ...]:
        """The poses of the robot's file."""
        return await self.arm.poses()

    async def move_to(self, name: str) -> None:
        """Move on a route of the robot's choice."""
        await self.arm.move_to(name)

    async def stop(self) -> None:
        """Hold."""
        await self.arm.stop()


class ModularArm(Manipulator):
    """The arm of a factory cell that is built of modules: joints appear with their power."""

    def __init__(self, robot: Robot, info: ComponentInfo) -> None:
        super().__init__(robot, info)
        self._service = robot.component(str(info.id)).service(MODULAR_ARM)
        self._speeds: dict[str, float] = {}

    async def joints(self) -> tuple[JointInfo, ...]:
        """The joints that are attached now; they are continuous."""
        names = [joint.name for joint in (await self._state()).joint_list]
        if not self._speeds.keys() >= set(names):
            report = await self._service.query(QueryModularArmSpecification())
            assert isinstance(report, ReportModularArmSpecification)
            self._speeds = {joint.name: joint.max_speed for joint in report.joint_list}
        return tuple(
            JointInfo(name, True, -math.inf, math.inf, MotionLimits(self._speeds.get(name) or math.inf))
            for name in names
        )

    async def positions(self) -> dict[str, float]:
        """The measured positions by joint."""
        return {joint.name: joint.position for joint in (await self._state()).joint_list}

    async def tool(self) -> str:
        """Position of the tip."""
        state = await self._state()
        rec = state.modular_arm_motion_rec
        return _place((rec.tip_x, rec.tip_y, rec.tip_z)) if state.joint_list else ""

    async def move(self, positions: Mapping[str, float], share: float) -> None:
        """Move joints in the time that the slowest needs for this share of its speed."""
        now = await self.positions()
        ways = [abs(value - now[name]) / self._speeds.get(name, math.inf) for name, value in positions.items()]
        await self._move(positions, EASING * max(ways) / share if share < 1.0 else 0.0)

    async def follow(self, rows: Sequence[Row], progress: Callable[[int], None]) -> None:
        """Move through rows: without stops if all move the same joints in given times, else one after another."""
        known = {joint.name for joint in await self.joints()}
        for number, (_, positions) in enumerate(rows, 1):
            if missing := positions.keys() - known:
                raise ConfigError(
                    sentence("row {number}: there is no joint {joint!r} now", number=number, joint=sorted(missing)[0])
                )
        try:
            if len(rows) > 1 and all(seconds > 0.0 and row.keys() == rows[0][1].keys() for seconds, row in rows):
                await self._flow(rows, progress)
                return
            for number, (seconds, positions) in enumerate(rows):
                progress(number)
                await self._move(positions, seconds)
        except BaseException:
            await self.stop()
            raise

    async def _flow(self, rows: Sequence[Row], progress: Callable[[int], None]) -> None:
        """Move through rows with a velocity at each, and rest at the last one."""
        joints, times = tuple(rows[0][1]), tuple(itertools.accumulate(seconds for seconds, _ in rows))
        points = [
            TrajectoryPoint(time, tuple(row[name] for name in joints))
            for time, (_, row) in zip(times, rows, strict=True)
        ]
        command = trajectory_command(joints, points)
        performing = asyncio.ensure_future(self._perform(command, times[-1]))
        try:
            for number, (seconds, _) in enumerate(rows):
                if not performing.done():
                    progress(number)
                    await asyncio.wait({performing}, timeout=seconds)
            await performing
        finally:
            performing.cancel()
            await asyncio.wait({performing})

    async def stop(self) -> None:
        """Hold."""
        await self._service.send(HoldModularArm(), ack=True)

    async def _state(self) -> ReportModularArmState:
        report = await self._service.query(QueryModularArmState())
        assert isinstance(report, ReportModularArmState)
        return report

    async def _move(self, positions: Mapping[str, float], duration: float) -> None:
        names = [joint.name for joint in (await self._state()).joint_list]
        if missing := positions.keys() - set(names):
            raise ConfigError(sentence("there is no joint {joint!r} now", joint=sorted(missing)[0]))
        command = motion_command([positions.get(name, math.nan) for name in names], duration)
        await self._perform(command, duration)

    async def _perform(self, command: Message, duration: float) -> None:
        try:
            await self._service.perform(command, within=duration + GRACE_TIME)
        except JausError as error:
            raise RequestError(printable(str(error))) from error


def manipulators(robot: Robot) -> dict[str, Manipulator]:
    """The arms of a robot by the id of their components; those that move a tool first."""
    found: list[Manipulator] = [
        StandardArm(robot, component)
        for component in robot.components
        if component.find(POSITION_DRIVER) and not component.find(MODULAR_ARM)
    ]
    found += [ModularArm(robot, component) for component in robot.components if component.find(MODULAR_ARM)]
    return {str(manipulator.info.id): manipulator for manipulator in sorted(found, key=lambda arm: not arm.has_tool)}


def operated(robot: Robot) -> list[str]:
    """The components that an operator of the console controls: what moves robot, cameras or parts, and its gripper."""
    arms = {component.id.node for component in robot.components if component.find(POSITION_DRIVER)}
    return [
        str(component.id)
        for component in robot.components
        if any(component.find(name) for name in (*MOVING, PAN_TILT_DRIVER, MODULAR_ARM, CONVEYOR))
        or (component.find(CONNECTOR) and component.id.node in arms)
    ]


def _place(point: tuple[float, float, float]) -> str:
    return "x {:.3f}  y {:.3f}  z {:.3f} m".format(*(round(value, 3) + 0.0 for value in point))
