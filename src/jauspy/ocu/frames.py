"""The frames of a running robot: what moves is asked for over JAUS, the rest is its description."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from typing import Final

from jauspy.geometry.frames import Frames, FrameTree
from jauspy.geometry.poses import Pose, Transform, jaus_pose
from jauspy.geometry.urdf import JointKind
from jauspy.messages.mobility import QueryLocalPose, ReportLocalPose
from jauspy.ocu.joint_positions import JointReader, readers
from jauspy.ocu.robot import Robot
from jauspy.platform.description import RobotModel

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
            self._readers = await readers(self._robot, self._model, self._movers)
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
        return Transform.from_pose(jaus_pose(Pose(*(value or 0.0 for value in values))))
