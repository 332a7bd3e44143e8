"""The coordinate frames of a running robot: poses and joint positions over JAUS, the rest from its description."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from types import MappingProxyType
from typing import Final, Protocol

from jauspy.errors import ConfigError
from jauspy.geometry.denavit_hartenberg import manipulator_geometry, reversed_axes
from jauspy.geometry.frames import Frames, FrameTree
from jauspy.geometry.poses import Pose, Transform, jaus_pose
from jauspy.messages.manipulator import (
    QueryJointPositions,
    QueryManipulatorSpecifications,
    QueryPanTiltJointPositions,
    ReportJointPositions,
    ReportPanTiltJointPositions,
)
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.platform.description import GroupSetup, RobotModel

MANIPULATOR: Final = "ManipulatorJointPositionSensor"
PAN_TILT: Final = "PanTiltJointPositionSensor"
SPECIFICATION: Final = "ManipulatorSpecificationService"

_NAMES: Final = 0b10
"""Presence vector with the second field, the names of the joints."""


class JointReader(Protocol):
    """Reads joint positions from one component."""

    @property
    def joints(self) -> tuple[str, ...]:
        """The names of the joints in the description."""
        ...

    async def read(self) -> dict[str, float]:
        """Position of each joint in radians or metres; `ResponseTimeout` when the component does not answer."""
        ...


class ManipulatorReader:
    """Joints of a manipulator or gripper, which AS6057 measures in Denavit-Hartenberg frames."""

    def __init__(self, component: ComponentClient, model: RobotModel, group: GroupSetup) -> None:
        self._id = component.id
        self._sensor = component.service(MANIPULATOR)
        self._geometry = manipulator_geometry(model.description.chain(group.base, group.tip))
        self.joints = group.joints

    async def read(self) -> dict[str, float]:
        """Joint positions; raises `ConfigError` when the number of joints differs from the description."""
        report = await self._sensor.query(QueryJointPositions(), expects=ReportJointPositions)
        standard = [record.joint_position.value for record in report.joint_position_list]
        if len(standard) != len(self.joints):
            raise ConfigError(
                f"{self._id} reports {len(standard)} joints, and the description has {len(self.joints)} there: "
                f"{', '.join(self.joints)}; is it the description of this robot?"
            )
        return dict(zip(self.joints, self._geometry.to_urdf(standard), strict=True))


class PanTiltReader:
    """Joints of a pan-tilt unit; AS6057 counts angles to the right and upwards."""

    def __init__(self, component: ComponentClient, model: RobotModel, group: GroupSetup) -> None:
        self._sensor = component.service(PAN_TILT)
        self._reversed = reversed_axes(model.description.chain(group.base, group.tip))
        self.joints = group.joints

    async def read(self) -> dict[str, float]:
        """Joint positions as in `JointReader`."""
        report = await self._sensor.query(QueryPanTiltJointPositions(), expects=ReportPanTiltJointPositions)
        rows = zip(self.joints, (report.joint1_position, report.joint2_position), self._reversed, strict=True)
        return {joint: -angle if is_reversed else angle for joint, angle, is_reversed in rows}


async def joint_readers(robot: Robot, model: RobotModel, movers: Mapping[int, str]) -> list[JointReader]:
    """Readers of all components whose joints are known, from their specification or else from `movers`."""
    found: list[JointReader] = []
    for info in robot.info.offering(MANIPULATOR):
        component = robot.component(info.id)
        named = await _reported_group(component, model) if info.find(SPECIFICATION) else None
        group = named or model.groups.get(movers.get(info.id.component, ""))
        if group is not None:
            found.append(ManipulatorReader(component, model, group))
    for info in robot.info.offering(PAN_TILT):
        group = model.groups.get(movers.get(info.id.component, ""))
        if group is not None:
            found.append(PanTiltReader(robot.component(info.id), model, group))
    return found


async def _reported_group(component: ComponentClient, model: RobotModel) -> GroupSetup | None:
    """The group of the description with the joints that the component's specification names, if there is one."""
    report = await component.service(SPECIFICATION).query(QueryManipulatorSpecifications(_NAMES))
    names = tuple(record.description for record in report.joint_names_list or ())
    return next((group for group in model.groups.values() if group.joints == names), None)


LOCAL: Final = "local"
"""The frame of LocalPoseSensor with the axes of REP-103: x as in JAUS, y to the left of it, z up."""


class RobotFrames:
    """Reads the frames of a robot; `model` is its description.

    The specification of an arm names its joints, so that its component is matched with a joint group of the
    description. For others, such as grippers and pan-tilt units, `movers` maps component numbers to joint groups.
    Joints that no service reports are assumed to be at their start positions.
    """

    def __init__(self, robot: Robot, model: RobotModel, movers: Mapping[int, str] = MappingProxyType({})) -> None:
        self._robot = robot
        self._model = model
        self._movers = movers
        self._tree = FrameTree(model.description)
        self._readers: list[JointReader] | None = None

    async def read(self) -> Frames:
        """All frames now. Raises `ConfigError` without a pose sensor, `ResponseTimeout` if no answer arrives."""
        if self._readers is None:
            self._readers = await joint_readers(self._robot, self._model, self._movers)
        reported = asyncio.gather(*(reader.read() for reader in self._readers))
        base, groups = await asyncio.gather(self._base(), reported)
        positions = self._start_positions()
        for group in groups:
            positions |= group
        return self._tree.frames(base, positions, LOCAL)

    @property
    def assumed(self) -> list[str]:
        """The joints that no service reported to the last `read`, without track belts, whose frames do not move."""
        tracks = self._model.tracks
        belts = {*tracks.left, *tracks.right} if tracks else set()
        reported = {joint for reader in self._readers or () for joint in reader.joints}
        moving = (joint for joint in self._tree.joints if joint.is_independent)
        return [joint.name for joint in moving if joint.name not in reported | belts]

    def assumed_between(self, frame: str, within: str) -> list[str]:
        """The assumed joints between one frame and another one."""
        links = [self._tree.root if name == LOCAL else name for name in (frame, within)]
        joints = {joint.mimics or joint.name for joint in self._tree.between(*links)}
        return [joint for joint in self.assumed if joint in joints]

    def _start_positions(self) -> dict[str, float]:
        groups = self._model.groups.values()
        return {joint: position for group in groups for joint, position in zip(group.joints, group.start, strict=True)}

    async def _base(self) -> Transform:
        sensor = self._robot.service("mobility:LocalPoseSensor")
        report = await sensor.query(QueryLocalPose(), expects=ReportLocalPose)
        values = (report.x, report.y, report.z, report.roll, report.pitch, report.yaw)
        return Transform.from_pose(jaus_pose(Pose(*(value or 0.0 for value in values))))
