"""LocalPoseSensor: where the platform is in its local frame (AS6009)."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from jauspy.messages.mobility import (
    ReportLocalPose,
    ReportLocalPoseExt,
    SetLocalPose,
    SetLocalPoseExt,
    ZPosition,
)
from jauspy.platform.contract import DriveBase, Pose
from jauspy.services.mobility.frames import jaus_pose, wrap
from jauspy.services.service import Service
from jauspy.services.stamps import epoch_seconds, time_stamp


@dataclass(frozen=True, slots=True)
class Reference:
    """Puts the local frame so that the platform at `raw` reads as `shown`: a shift and a turn about z."""

    raw: Pose
    shown: Pose

    def apply(self, pose: Pose) -> Pose:
        """A pose (JAUS axes) in the frame that was set."""
        turn = self.shown.yaw - self.raw.yaw
        dx, dy = pose.x - self.raw.x, pose.y - self.raw.y
        return replace(
            pose,
            x=self.shown.x + math.cos(turn) * dx - math.sin(turn) * dy,
            y=self.shown.y + math.sin(turn) * dx + math.cos(turn) * dy,
            z=self.shown.z + pose.z - self.raw.z,
            yaw=wrap(pose.yaw + turn),
        )


class LocalPoseSensor(Service, urn="urn:jaus:jss:mobility:LocalPoseSensor"):
    """Position (m), attitude (rad) and time.

    The controlling client may set x, y, z and yaw; roll and pitch are measured against gravity and stay as they are.
    """

    def __init__(self, drive: DriveBase) -> None:
        self._drive = drive
        self._reference: Reference | None = None

    @property
    def pose(self) -> Pose:
        """The pose in JAUS axes, in the local frame as it was last set."""
        raw = jaus_pose(self._drive.pose())
        return self._reference.apply(raw) if self._reference else raw

    def update_local_pose(self, msg: SetLocalPose) -> None:
        """The platform is, from now on, where the client says that it is."""
        self._set(msg.x, msg.y, msg.z, msg.yaw)

    def update_local_pose_ext(self, msg: SetLocalPoseExt) -> None:
        """As `update_local_pose`; a height above some datum says nothing about z of the local frame."""
        z = msg.z_position
        local = z is not None and z.choice == ZPosition.Choice.Z_LOCAL
        self._set(msg.x, msg.y, z.value if z is not None and local else None, msg.heading)

    def _set(self, x: float | None, y: float | None, z: float | None, yaw: float | None) -> None:
        given = {"x": x, "y": y, "z": z, "yaw": yaw}
        shown = replace(self.pose, **{name: value for name, value in given.items() if value is not None})
        self._reference = Reference(jaus_pose(self._drive.pose()), shown)

    def report_local_pose(self) -> ReportLocalPose:
        """Everything that is measured; there is no estimate of the errors."""
        pose = self.pose
        return ReportLocalPose(
            x=pose.x,
            y=pose.y,
            z=pose.z,
            roll=pose.roll,
            pitch=pose.pitch,
            yaw=pose.yaw,
            time_stamp=time_stamp(self.host.utc_time),
        )

    def report_local_pose_ext(self) -> ReportLocalPoseExt:
        """As `report_local_pose`, with the time since 1970."""
        pose = self.pose
        seconds, nanoseconds = epoch_seconds(self.host.utc_time)
        return ReportLocalPoseExt(
            x=pose.x,
            y=pose.y,
            z_local=pose.z,
            roll=pose.roll,
            pitch=pose.pitch,
            heading=pose.yaw,
            time_seconds=seconds,
            time_nano_seconds=nanoseconds,
        )
