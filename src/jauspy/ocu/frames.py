"""The frames of a running robot: what moves is asked for over JAUS, the rest is its description."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from typing import Final, Protocol

from jauspy.errors import ConfigError
from jauspy.messages.manipulator import (
    QueryJointPositions,
    QueryManipulatorSpecifications,
    QueryPanTiltJointPositions,
    ReportJointPositions,
    ReportPanTiltJointPositions,
)
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu.robot import ComponentClient, Robot
from jauspy.platform.contract import Pose
from jauspy.platform.description import GroupSetup, JointKind, RobotModel
from jauspy.platform.transforms import Frames, FrameTree
from jauspy.platform.vectors import Transform
from jauspy.services.manipulator.denavit_hartenberg import geometry
from jauspy.services.manipulator.pan_tilt import turned
from jauspy.services.mobility.frames import jaus_pose

MANIPULATOR: Final = "ManipulatorJointPositionSensor"
PAN_TILT: Final = "PanTiltJointPositionSensor"
SPECIFICATION: Final = "ManipulatorSpecificationService"

_NAMES: Final = 0b10
"""Presence vector: the second field, names of joints."""


class JointReader(Protocol):
    """Asks one component."""

    @property
    def joints(self) -> tuple[str, ...]:
        """Of which joints."""
        ...

    async def read(self) -> dict[str, float]:
        """Their positions, radians or metres; `ResponseTimeout` when it does not answer."""
        ...


class ManipulatorReader:
    """Positions of a manipulator, or of a gripper, which the standard counts from axes of its own."""

    def __init__(self, component: ComponentClient, model: RobotModel, group: GroupSetup) -> None:
        self._id = component.id
        self._sensor = component.service(MANIPULATOR)
        self._geometry = geometry(model.description.chain(group.base, group.tip))
        self.joints = group.joints

    async def read(self) -> dict[str, float]:
        """Asks the sensor; `ConfigError` when it has another number of joints."""
        report = await self._sensor.query(QueryJointPositions(), expects=ReportJointPositions)
        standard = [record.joint_position.value for record in report.joint_position_list]
        if len(standard) != len(self.joints):
            raise ConfigError(
                f"{self._id} reports {len(standard)} joints, and the description has {len(self.joints)} there: "
                f"{', '.join(self.joints)}; is it the description of this robot?"
            )
        return dict(zip(self.joints, self._geometry.native(standard), strict=True))


class PanTiltReader:
    """Angles of a pan-tilt unit, which count to the right and upwards."""

    def __init__(self, component: ComponentClient, model: RobotModel, group: GroupSetup) -> None:
        self._sensor = component.service(PAN_TILT)
        self._turned = turned(model.description.chain(group.base, group.tip))
        self.joints = group.joints

    async def read(self) -> dict[str, float]:
        """Asks the sensor."""
        report = await self._sensor.query(QueryPanTiltJointPositions(), expects=ReportPanTiltJointPositions)
        rows = zip(self.joints, (report.joint1_position, report.joint2_position), self._turned, strict=True)
        return {joint: -angle if turned else angle for joint, angle, turned in rows}


async def joint_readers(robot: Robot, model: RobotModel, movers: Mapping[int, str]) -> list[JointReader]:
    """All that can be asked and whose joints are known: named by a specification, or else by `movers`."""
    found: list[JointReader] = []
    for info in robot.info.offering(MANIPULATOR):
        component = robot.component(info.id)
        named = await _named(component, model) if info.find(SPECIFICATION) else None
        group = named or model.groups.get(movers.get(info.id.component, ""))
        if group is not None:
            found.append(ManipulatorReader(component, model, group))
    for info in robot.info.offering(PAN_TILT):
        group = model.groups.get(movers.get(info.id.component, ""))
        if group is not None:
            found.append(PanTiltReader(robot.component(info.id), model, group))
    return found


async def _named(component: ComponentClient, model: RobotModel) -> GroupSetup | None:
    """The group of joints whose names the specification reports, when the description has it."""
    report = await component.service(SPECIFICATION).query(QueryManipulatorSpecifications(_NAMES))
    names = tuple(record.description for record in report.joint_names_list or ())
    return next((group for group in model.groups.values() if group.joints == names), None)


LOCAL: Final = "local"
"""The frame that LocalPoseSensor reports in, with REP-103's axes: x as its x, y to the left of it, z up."""

_ALL: Final = 0x1FF
_NOBODY: Final[Mapping[int, str]] = {}


class RobotFrames:
    """Reads the frames of a robot; `model` is its description, `movers` says which component moves which group of it.

    Of arms the specification tells the joints' names, so that positions find their place in the description whatever
    the component's number; of others, as grippers and pan-tilt units, only `movers` can. Joints that no service
    reports are taken to stand where they start.
    """

    def __init__(self, robot: Robot, model: RobotModel, movers: Mapping[int, str] = _NOBODY) -> None:
        self._robot = robot
        self._model = model
        self._movers = movers
        self._tree = FrameTree(model.description)
        self._readers: list[JointReader] | None = None

    async def look(self) -> Frames:
        """All frames now. Raises `ConfigError` without a pose sensor, `ResponseTimeout` when an answer stays out."""
        if self._readers is None:
            self._readers = await joint_readers(self._robot, self._model, self._movers)
        told = asyncio.gather(*(reader.read() for reader in self._readers))
        base, found = await asyncio.gather(self._base(), told)
        positions = self._starts()
        for each in found:
            positions |= each
        return self._tree.frames(base, positions, LOCAL)

    @property
    def assumed(self) -> list[str]:
        """The joints whose positions no service reported to the last `look`; belts of tracks stay where they are."""
        belts = {*self._model.tracks.left, *self._model.tracks.right}
        told = {joint for reader in self._readers or () for joint in reader.joints}
        moving = (each for each in self._tree.joints if each.kind is not JointKind.FIXED and each.mimics is None)
        return [joint.name for joint in moving if joint.name not in told | belts]

    def assumed_between(self, frame: str, within: str) -> list[str]:
        """Those of them on which it depends where one frame is in another one."""
        links = [self._tree.root if each == LOCAL else each for each in (frame, within)]
        way = {joint.mimics or joint.name for joint in self._tree.between(*links)}
        return [joint for joint in self.assumed if joint in way]

    def _starts(self) -> dict[str, float]:
        groups = self._model.groups.values()
        return {joint: at for group in groups for joint, at in zip(group.joints, group.start, strict=True)}

    async def _base(self) -> Transform:
        sensor = self._robot.service("mobility:LocalPoseSensor")
        report = await sensor.query(QueryLocalPose(_ALL), expects=ReportLocalPose)
        values = (report.x, report.y, report.z, report.roll, report.pitch, report.yaw)
        return Transform.of(jaus_pose(Pose(*(value or 0.0 for value in values))))
