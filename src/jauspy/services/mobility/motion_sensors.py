"""VelocityStateSensor and AccelerationStateSensor: the platform's motion in its own frame (AS6009)."""

from __future__ import annotations

import math
from typing import Final

from jauspy.geometry.poses import jaus_acceleration, jaus_twist
from jauspy.messages.mobility import (
    ReportAccelerationState,
    ReportAccelerationStateExt,
    ReportVelocityState,
    ReportVelocityStateExt,
    ReportVelocityStateExtRec,
    VelocityVehicleXYZRec,
)
from jauspy.platform.localization import Localization, LocalizationState
from jauspy.services.mobility.field_ranges import encodable_angle_rms, encodable_rms
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
        """As `report_velocity_state`, with speed over ground and epoch time; always in the vehicle's frame."""
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
        """As `report_acceleration_state`, with epoch time."""
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
