"""VelocityStateSensor and AccelerationStateSensor: the platform's motion in its own frame (AS6009)."""

from __future__ import annotations

import math

from jauspy.geometry.poses import jaus_acceleration, jaus_twist
from jauspy.messages.mobility import (
    ReportAccelerationState,
    ReportAccelerationStateExt,
    ReportVelocityState,
    ReportVelocityStateExt,
    ReportVelocityStateExtRec,
    VelocityVehicleXYZRec,
)
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.service import Service
from jauspy.services.units import epoch_seconds, time_stamp


class VelocityStateSensor(Service, urn="urn:jaus:jss:mobility:VelocityStateSensor"):
    """Velocities (m/s) and rates (rad/s) in JAUS body axes: x forward, y right, z down."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._drive = vehicle.drive

    def report_velocity_state(self) -> ReportVelocityState:
        """All fields but the errors (RMS), which are not estimated."""
        twist = jaus_twist(self._drive.twist())
        return ReportVelocityState(
            velocity_x=twist.vx,
            velocity_y=twist.vy,
            velocity_z=twist.vz,
            roll_rate=twist.wx,
            pitch_rate=twist.wy,
            yaw_rate=twist.wz,
            time_stamp=time_stamp(self.host.utc_time),
        )

    def report_velocity_state_ext(self) -> ReportVelocityStateExt:
        """As `report_velocity_state`, with speed over ground and epoch time; always in the vehicle's frame."""
        twist = jaus_twist(self._drive.twist())
        seconds, nanoseconds = epoch_seconds(self.host.utc_time)
        return ReportVelocityStateExt(
            velocity_var=VelocityVehicleXYZRec(velocity_x=twist.vx, velocity_y=twist.vy, velocity_z=twist.vz),
            report_velocity_state_ext_rec=ReportVelocityStateExtRec(
                roll_rate=twist.wx,
                pitch_rate=twist.wy,
                yaw_rate=twist.wz,
                speed_over_ground=math.hypot(twist.vx, twist.vy),
                time_seconds=seconds,
                time_nano_seconds=nanoseconds,
            ),
        )


class AccelerationStateSensor(Service, urn="urn:jaus:jss:mobility:AccelerationStateSensor"):
    """Accelerations (m/s^2, rad/s^2) without gravity in JAUS body axes: x forward, y right, z down."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._drive = vehicle.drive

    def report_acceleration_state(self) -> ReportAccelerationState:
        """All fields but the errors (RMS), which are not estimated."""
        acceleration = jaus_acceleration(self._drive.acceleration())
        return ReportAccelerationState(
            acceleration_x=acceleration.ax,
            acceleration_y=acceleration.ay,
            acceleration_z=acceleration.az,
            roll_acceleration=acceleration.wx,
            pitch_acceleration=acceleration.wy,
            yaw_acceleration=acceleration.wz,
            time_stamp=time_stamp(self.host.utc_time),
        )

    def report_acceleration_state_ext(self) -> ReportAccelerationStateExt:
        """As `report_acceleration_state`, with epoch time."""
        acceleration = jaus_acceleration(self._drive.acceleration())
        seconds, nanoseconds = epoch_seconds(self.host.utc_time)
        return ReportAccelerationStateExt(
            acceleration_x=acceleration.ax,
            acceleration_y=acceleration.ay,
            acceleration_z=acceleration.az,
            roll_acceleration=acceleration.wx,
            pitch_acceleration=acceleration.wy,
            yaw_acceleration=acceleration.wz,
            time_seconds=seconds,
            time_nano_seconds=nanoseconds,
        )
