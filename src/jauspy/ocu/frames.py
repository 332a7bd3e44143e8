"""The frames of a running robot: what moves is asked for over JAUS, the rest is its description."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from typing import Any, Final

from jauspy.messages.manipulator import QueryJointPositions, QueryManipulatorSpecifications, ReportJointPositions
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.platform.contract import Pose
from jauspy.platform.description import GroupSetup, RobotModel
from jauspy.platform.transforms import Frames, FrameTree
from jauspy.platform.vectors import Transform
from jauspy.services.manipulator.denavit_hartenberg import geometry
from jauspy.services.mobility.frames import jaus_pose

LOCAL: Final = "local"
"""The frame that LocalPoseSensor reports in, with REP-103's axes: x as its x, y to the left of it, z up."""

_ALL: Final = 0x1FF
_NAMES: Final = 0b10
"""Presence vector: the second field, names of joints."""


class RobotFrames:
    """Reads the frames of a robot; `model` is its description.

    Of each arm the specification tells the joints' names, so that positions find their place in the description
    whatever the component's number. Joints that no service reports stay where they start.
    """

    def __init__(self, robot: Robot, model: RobotModel) -> None:
        self._robot = robot
        self._model = model
        self._tree = FrameTree(model.description)
        self._arms: list[tuple[ComponentClient, GroupSetup]] | None = None

    async def look(self) -> Frames:
        """All frames now. Raises `ConfigError` without a pose sensor, `ResponseTimeout` when an answer stays out."""
        if self._arms is None:
            self._arms = [found for each in self._manipulators() if (found := await self._identified(each))]
        arms = asyncio.gather(*(self._joints(*arm) for arm in self._arms))
        base, told = await asyncio.gather(self._base(), arms)
        positions = self._starts()
        for arm in told:
            positions |= arm
        return self._tree.frames(base, positions, LOCAL)

    @property
    def assumed(self) -> list[str]:
        """The joints whose positions no service reported to the last `look`."""
        told = {joint for _, group in self._arms or () for joint in group.joints}
        return [joint for joint in self._starts() if joint not in told]

    def _starts(self) -> dict[str, float]:
        groups = self._model.groups.values()
        return {joint: at for group in groups for joint, at in zip(group.joints, group.start, strict=True)}

    def _manipulators(self) -> list[ComponentClient]:
        offering = self._robot.info.offering("ManipulatorJointPositionSensor")
        found = [each for each in offering if each.find("ManipulatorSpecificationService")]
        return [self._robot.component(each.id) for each in found]

    async def _identified(self, component: ComponentClient) -> tuple[ComponentClient, GroupSetup] | None:
        """The group of joints that a component moves, when the description has it."""
        specification = component.service("ManipulatorSpecificationService")
        report = await specification.query(QueryManipulatorSpecifications(_NAMES))
        names = tuple(record.description for record in report.joint_names_list or ())
        return next(((component, group) for group in self._model.groups.values() if group.joints == names), None)

    async def _base(self) -> Transform:
        sensor = self._robot.service("mobility:LocalPoseSensor")
        report = await sensor.query(QueryLocalPose(_ALL), expects=ReportLocalPose)
        values = (report.x, report.y, report.z, report.roll, report.pitch, report.yaw)
        return Transform.of(jaus_pose(Pose(*(value or 0.0 for value in values))))

    async def _joints(self, component: ComponentClient, group: GroupSetup) -> dict[str, float]:
        sensor = component.service("ManipulatorJointPositionSensor")
        report = await sensor.query(QueryJointPositions(), expects=ReportJointPositions)
        return dict(zip(group.joints, self._native(group, report.joint_position_list), strict=True))

    def _native(self, group: GroupSetup, records: Sequence[Any]) -> Sequence[float]:
        """The description's positions out of the standard's, which are counted from other axes."""
        chain = self._model.description.chain(group.base, group.tip)
        return geometry(chain).native([record.joint_position.value for record in records])
