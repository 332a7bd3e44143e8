"""Sensors of pose and motion (AS6009).

LocalPoseSensor and GlobalPoseSensor report the pose in the local frame and on the globe; VelocityStateSensor and
AccelerationStateSensor the motion in the frame of the platform.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

from jauspy.geometry.poses import Pose, jaus_acceleration, jaus_twist, wrap_angle
from jauspy.messages.mobility import (
    ReportAccelerationState,
    ReportAccelerationStateExt,
    ReportGeomagneticProperty,
    ReportGlobalPose,
    ReportGlobalPoseExt,
    ReportLocalPose,
    ReportLocalPoseExt,
    ReportVelocityState,
    ReportVelocityStateExt,
    ReportVelocityStateExtRec,
    SetGeomagneticProperty,
    SetGlobalPose,
    SetGlobalPoseExt,
    SetLocalPose,
    SetLocalPoseExt,
    VelocityVehicleXYZRec,
    ZPosition,
)
from jauspy.platform.localization import Localization, LocalizationState, PoseEstimate
from jauspy.services.mobility.field_ranges import (
    MAX_XY_EXT,
    MAX_XYZ,
    MAX_Z_EXT,
    encodable,
    encodable_altitude,
    encodable_angle_rms,
    encodable_rms,
)
from jauspy.services.mobility.reference_frames import GlobalPose
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.service import Service
from jauspy.services.units import epoch_seconds, time_stamp


def _state(localization: Localization | None) -> LocalizationState | None:
    return None if localization is None else localization.state()


MAX_ROTATION_RMS: Final = 1000.0
"""rad/s^2, in the wide form."""


class VelocityStateSensor(Service, urn="urn:jaus:jss:mobility:VelocityStateSensor"):
    """Velocities (m/s) and rates (rad/s) in JAUS body axes: x forward, y right, z down."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._drive = vehicle.drive
        self._localization = vehicle.localization

    def report_velocity_state(self) -> ReportVelocityState:
        """All fields; the errors (RMS) if they are estimated."""
        twist, errors = jaus_twist(self._drive.twist()), _state(self._localization)
        return ReportVelocityState(
            velocity_x=twist.vx,
            velocity_y=twist.vy,
            velocity_z=twist.vz,
            velocity_rms=encodable_rms(errors and errors.velocity_rms),
            roll_rate=twist.wx,
            pitch_rate=twist.wy,
            yaw_rate=twist.wz,
            rate_rms=encodable_angle_rms(errors and errors.rate_rms),
            time_stamp=time_stamp(self.host.utc_time),
        )

    def report_velocity_state_ext(self) -> ReportVelocityStateExt:
        """Same as `report_velocity_state`, with speed over ground and epoch time; always in the vehicle's frame."""
        twist, errors = jaus_twist(self._drive.twist()), _state(self._localization)
        seconds, nanoseconds = epoch_seconds(self.host.utc_time)
        return ReportVelocityStateExt(
            velocity_var=VelocityVehicleXYZRec(velocity_x=twist.vx, velocity_y=twist.vy, velocity_z=twist.vz),
            report_velocity_state_ext_rec=ReportVelocityStateExtRec(
                velocity_rms=encodable_rms(errors and errors.velocity_rms),
                roll_rate=twist.wx,
                pitch_rate=twist.wy,
                yaw_rate=twist.wz,
                rate_rms=encodable_rms(errors and errors.rate_rms),
                speed_over_ground=math.hypot(twist.vx, twist.vy),
                time_seconds=seconds,
                time_nano_seconds=nanoseconds,
            ),
        )


class AccelerationStateSensor(Service, urn="urn:jaus:jss:mobility:AccelerationStateSensor"):
    """Accelerations (m/s^2, rad/s^2) without gravity in JAUS body axes: x forward, y right, z down."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._drive = vehicle.drive
        self._localization = vehicle.localization

    def report_acceleration_state(self) -> ReportAccelerationState:
        """All fields; the errors (RMS) if they are estimated."""
        acceleration = jaus_acceleration(self._drive.acceleration())
        errors = _state(self._localization)
        return ReportAccelerationState(
            acceleration_x=acceleration.ax,
            acceleration_y=acceleration.ay,
            acceleration_z=acceleration.az,
            acceleration_rms=encodable_rms(errors and errors.acceleration_rms),
            roll_acceleration=acceleration.wx,
            pitch_acceleration=acceleration.wy,
            yaw_acceleration=acceleration.wz,
            rotational_acceleration_rms=encodable_angle_rms(errors and errors.angular_acceleration_rms),
            time_stamp=time_stamp(self.host.utc_time),
        )

    def report_acceleration_state_ext(self) -> ReportAccelerationStateExt:
        """Same as `report_acceleration_state`, with epoch time."""
        acceleration = jaus_acceleration(self._drive.acceleration())
        errors = _state(self._localization)
        seconds, nanoseconds = epoch_seconds(self.host.utc_time)
        return ReportAccelerationStateExt(
            acceleration_x=acceleration.ax,
            acceleration_y=acceleration.ay,
            acceleration_z=acceleration.az,
            acceleration_rms=encodable_rms(errors and errors.acceleration_rms),
            roll_acceleration=acceleration.wx,
            pitch_acceleration=acceleration.wy,
            yaw_acceleration=acceleration.wz,
            rotational_acceleration_rms=encodable_rms(errors and errors.angular_acceleration_rms, MAX_ROTATION_RMS),
            time_seconds=seconds,
            time_nano_seconds=nanoseconds,
        )


MIN_COURSE_SPEED: Final = 0.05
"""m/s below which no course is reported."""


class GlobalPoseSensor(Service, urn="urn:jaus:jss:mobility:GlobalPoseSensor"):
    """Latitude and longitude (degrees, WGS 84), altitude (m above its ellipsoid), heading (rad from true north), time.

    The vehicle needs an origin. The controlling client may set latitude, longitude, altitude and yaw; roll and pitch
    are measured against gravity. The wide form has no altitude, since its datums are not supported.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle
        self._magnetic_variation = 0.0

    def attached(self) -> None:
        """Raises `ConfigError` without an origin."""
        self._vehicle.global_frame()

    def _pose(self) -> GlobalPose:
        return self._vehicle.global_frame().from_world(self._vehicle.pose_on_globe)

    def update_global_pose(self, msg: SetGlobalPose) -> None:
        """Move the global frame so that the platform has this pose; the local frame stays."""
        self._set(msg.latitude, msg.longitude, msg.altitude, msg.yaw)

    def update_global_pose_ext(self, msg: SetGlobalPoseExt) -> None:
        """Same as `update_global_pose`, without the height, whose datums are not supported."""
        self._set(msg.latitude, msg.longitude, None, msg.heading)

    def _set(
        self, latitude: float | None, longitude: float | None, altitude: float | None, heading: float | None
    ) -> None:
        given = {"latitude": latitude, "longitude": longitude, "altitude": altitude, "heading": heading}
        shown = replace(self._pose(), **{name: value for name, value in given.items() if value is not None})
        self._vehicle.global_frame().set(self._vehicle.pose_on_globe, shown)

    def update_geomagnetic_property(self, msg: SetGeomagneticProperty) -> None:
        """Keep the magnetic variation for reports; headings are true ones and do not change."""
        self._magnetic_variation = msg.magnetic_variation

    def report_geomagnetic_property(self) -> ReportGeomagneticProperty:
        """The variation that was set; at first zero."""
        return ReportGeomagneticProperty(magnetic_variation=self._magnetic_variation)

    def report_global_pose(self) -> ReportGlobalPose:
        """All fields; the errors (RMS) if they are estimated."""
        shown, attitude, errors = self._pose(), self._vehicle.pose_on_globe, self._errors()
        return ReportGlobalPose(
            latitude=shown.latitude,
            longitude=shown.longitude,
            altitude=encodable_altitude(shown.altitude),
            position_rms=encodable_rms(errors and errors.position_rms),
            roll=attitude.roll,
            pitch=attitude.pitch,
            yaw=shown.heading,
            attitude_rms=encodable_angle_rms(errors and errors.attitude_rms),
            time_stamp=time_stamp(self.host.utc_time),
        )

    def report_global_pose_ext(self) -> ReportGlobalPoseExt:
        """Same as `report_global_pose`, with the course while the platform moves, and epoch time."""
        shown, attitude, errors = self._pose(), self._vehicle.pose_on_globe, self._errors()
        seconds, nanoseconds = epoch_seconds(self.host.utc_time)
        return ReportGlobalPoseExt(
            latitude=shown.latitude,
            longitude=shown.longitude,
            xy_position_rms=encodable_rms(errors and errors.horizontal_rms),
            z_position_rms=encodable_rms(errors and errors.vertical_rms),
            roll=attitude.roll,
            pitch=attitude.pitch,
            heading=shown.heading,
            attitude_rms=encodable_angle_rms(errors and errors.attitude_rms),
            course=self._course(shown.heading),
            time_seconds=seconds,
            time_nano_seconds=nanoseconds,
        )

    def _errors(self) -> PoseEstimate | None:
        localization = self._vehicle.localization
        return None if localization is None else localization.state().globe

    def _course(self, heading: float) -> float | None:
        twist = jaus_twist(self._vehicle.drive.twist())
        if math.hypot(twist.vx, twist.vy) < MIN_COURSE_SPEED:
            return None
        return wrap_angle(heading + math.atan2(twist.vy, twist.vx))


class LocalPoseSensor(Service, urn="urn:jaus:jss:mobility:LocalPoseSensor"):
    """Position (m), attitude (rad) and time.

    The controlling client may set x, y, z and yaw; roll and pitch are measured against gravity. Local waypoints and
    vectors are in the same frame.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle

    @property
    def pose(self) -> Pose:
        """The pose in the local frame."""
        return self._vehicle.local_frame.from_world(self._vehicle.pose)

    def update_local_pose(self, msg: SetLocalPose) -> None:
        """Move the local frame so that the platform has this pose. Its errors are counted anew, from those given."""
        self._set(msg.x, msg.y, msg.z, msg.yaw)
        self._declare(msg, msg.position_rms, msg.yaw)

    def update_local_pose_ext(self, msg: SetLocalPoseExt) -> None:
        """Same as `update_local_pose`; a height above a datum is ignored."""
        z = msg.z_position
        local = z is not None and z.choice == ZPosition.Choice.Z_LOCAL
        self._set(msg.x, msg.y, z.value if z is not None and local else None, msg.heading)
        self._declare(msg, msg.xy_position_rms, msg.heading)

    def _declare(self, msg: SetLocalPose | SetLocalPoseExt, position_rms: float | None, yaw: float | None) -> None:
        if (localization := self._vehicle.localization) is not None:
            whole = msg.x is not None and msg.y is not None
            localization.declare(
                (position_rms or 0.0) if whole else None, None if yaw is None else msg.attitude_rms or 0.0
            )

    def _set(self, x: float | None, y: float | None, z: float | None, yaw: float | None) -> None:
        given = {"x": x, "y": y, "z": z, "yaw": yaw}
        shown = replace(self.pose, **{name: value for name, value in given.items() if value is not None})
        self._vehicle.local_frame.set(self._vehicle.pose, shown)

    def _errors(self) -> PoseEstimate | None:
        localization = self._vehicle.localization
        return None if localization is None else localization.state().local

    def report_local_pose(self) -> ReportLocalPose:
        """All fields that fit; the errors (RMS) if they are estimated."""
        pose, errors = self.pose, self._errors()
        return ReportLocalPose(
            x=encodable(pose.x, MAX_XYZ),
            y=encodable(pose.y, MAX_XYZ),
            z=encodable(pose.z, MAX_XYZ),
            position_rms=encodable_rms(errors and errors.position_rms),
            roll=pose.roll,
            pitch=pose.pitch,
            yaw=pose.yaw,
            attitude_rms=encodable_angle_rms(errors and errors.attitude_rms),
            time_stamp=time_stamp(self.host.utc_time),
        )

    def report_local_pose_ext(self) -> ReportLocalPoseExt:
        """Same as `report_local_pose`, with epoch time."""
        pose, errors = self.pose, self._errors()
        seconds, nanoseconds = epoch_seconds(self.host.utc_time)
        return ReportLocalPoseExt(
            x=encodable(pose.x, MAX_XY_EXT),
            y=encodable(pose.y, MAX_XY_EXT),
            z_local=encodable(pose.z, MAX_Z_EXT),
            xy_position_rms=encodable_rms(errors and errors.horizontal_rms),
            z_position_rms=encodable_rms(errors and errors.vertical_rms),
            roll=pose.roll,
            pitch=pose.pitch,
            heading=pose.yaw,
            attitude_rms=encodable_angle_rms(errors and errors.attitude_rms),
            time_seconds=seconds,
            time_nano_seconds=nanoseconds,
        )
