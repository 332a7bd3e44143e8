"""LocalPoseSensor: where the platform is in its local frame (AS6009)."""

from __future__ import annotations

from dataclasses import replace

from jauspy.geometry.poses import Pose
from jauspy.messages.mobility import (
    ReportLocalPose,
    ReportLocalPoseExt,
    SetLocalPose,
    SetLocalPoseExt,
    ZPosition,
)
from jauspy.services.mobility.reach import HIGH, NARROW, WIDE, within
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.service import Service
from jauspy.services.stamps import epoch_seconds, time_stamp


class LocalPoseSensor(Service, urn="urn:jaus:jss:mobility:LocalPoseSensor"):
    """Position (m), attitude (rad) and time.

    The controlling client may set x, y, z and yaw; roll and pitch are measured against gravity and stay as they are.
    The frame that is set is that of the drivers to local waypoints and along local vectors, too.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle

    @property
    def pose(self) -> Pose:
        """The pose in JAUS axes, in the local frame as it was last set."""
        return self._vehicle.local.show(self._vehicle.pose)

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
        self._vehicle.local.set(self._vehicle.pose, shown)

    def report_local_pose(self) -> ReportLocalPose:
        """Everything that is measured and can be said; there is no estimate of the errors."""
        pose = self.pose
        return ReportLocalPose(
            x=within(pose.x, NARROW),
            y=within(pose.y, NARROW),
            z=within(pose.z, NARROW),
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
            x=within(pose.x, WIDE),
            y=within(pose.y, WIDE),
            z_local=within(pose.z, HIGH),
            roll=pose.roll,
            pitch=pose.pitch,
            heading=pose.yaw,
            time_seconds=seconds,
            time_nano_seconds=nanoseconds,
        )
