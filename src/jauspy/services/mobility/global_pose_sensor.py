"""GlobalPoseSensor: where the platform is on the globe (AS6009)."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

from jauspy.geometry.poses import jaus_twist, wrap_angle
from jauspy.messages.mobility import (
    ReportGeomagneticProperty,
    ReportGlobalPose,
    ReportGlobalPoseExt,
    SetGeomagneticProperty,
    SetGlobalPose,
    SetGlobalPoseExt,
)
from jauspy.services.mobility.global_frame import GlobalPose
from jauspy.services.mobility.reach import sayable_altitude
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.service import Service
from jauspy.services.stamps import epoch_seconds, time_stamp

MOVING: Final = 0.05
"""m/s below which the direction of travel says nothing."""


class GlobalPoseSensor(Service, urn="urn:jaus:jss:mobility:GlobalPoseSensor"):
    """Latitude and longitude (degrees, WGS 84), altitude (m above its ellipsoid), heading (rad from true north), time.

    The vehicle needs an origin. The controlling client may set latitude, longitude, altitude and yaw; roll and pitch
    are measured against gravity. The wider form has no altitude: none of its datums is known here.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle
        self._magnetic_variation = 0.0

    def attached(self) -> None:
        """Check that there is an origin: `ConfigError` if not."""
        self._vehicle.georeference()

    def _pose(self) -> GlobalPose:
        return self._vehicle.georeference().show(self._vehicle.pose)

    def update_global_pose(self, msg: SetGlobalPose) -> None:
        """The platform is, from now on, where the client says that it is; the local frame stays."""
        self._set(msg.latitude, msg.longitude, msg.altitude, msg.yaw)

    def update_global_pose_ext(self, msg: SetGlobalPoseExt) -> None:
        """As `update_global_pose`; the datums of its height are not known here."""
        self._set(msg.latitude, msg.longitude, None, msg.heading)

    def _set(
        self, latitude: float | None, longitude: float | None, altitude: float | None, heading: float | None
    ) -> None:
        given = {"latitude": latitude, "longitude": longitude, "altitude": altitude, "heading": heading}
        shown = replace(self._pose(), **{name: value for name, value in given.items() if value is not None})
        self._vehicle.georeference().set(self._vehicle.pose, shown)

    def update_geomagnetic_property(self, msg: SetGeomagneticProperty) -> None:
        """Kept and reported; headings are true ones here, whatever a compass would say."""
        self._magnetic_variation = msg.magnetic_variation

    def report_geomagnetic_property(self) -> ReportGeomagneticProperty:
        """As it was set, else zero."""
        return ReportGeomagneticProperty(magnetic_variation=self._magnetic_variation)

    def report_global_pose(self) -> ReportGlobalPose:
        """Everything that is measured; there is no estimate of the errors."""
        shown, attitude = self._pose(), self._vehicle.pose
        return ReportGlobalPose(
            latitude=shown.latitude,
            longitude=shown.longitude,
            altitude=sayable_altitude(shown.altitude),
            roll=attitude.roll,
            pitch=attitude.pitch,
            yaw=shown.heading,
            time_stamp=time_stamp(self.host.utc_time),
        )

    def report_global_pose_ext(self) -> ReportGlobalPoseExt:
        """As `report_global_pose`, with the direction of travel while there is one, and the time since 1970."""
        shown, attitude = self._pose(), self._vehicle.pose
        seconds, nanoseconds = epoch_seconds(self.host.utc_time)
        return ReportGlobalPoseExt(
            latitude=shown.latitude,
            longitude=shown.longitude,
            roll=attitude.roll,
            pitch=attitude.pitch,
            heading=shown.heading,
            course=self._course(shown.heading),
            time_seconds=seconds,
            time_nano_seconds=nanoseconds,
        )

    def _course(self, heading: float) -> float | None:
        twist = jaus_twist(self._vehicle.drive.twist())
        if math.hypot(twist.vx, twist.vy) < MOVING:
            return None
        return wrap_angle(heading + math.atan2(twist.vy, twist.vx))
