"""VelocityStateSensor: how fast the platform moves and turns, in its own frame (AS6009)."""

from __future__ import annotations

import math

from jauspy.geometry.poses import jaus_twist
from jauspy.messages.mobility import (
    ReportVelocityState,
    ReportVelocityStateExt,
    ReportVelocityStateExtRec,
    VelocityVehicleXYZRec,
)
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.service import Service
from jauspy.services.stamps import epoch_seconds, time_stamp


class VelocityStateSensor(Service, urn="urn:jaus:jss:mobility:VelocityStateSensor"):
    """Velocities (m/s) and rates (rad/s) in JAUS body axes: x forward, y right, z down."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._drive = vehicle.drive

    def report_velocity_state(self) -> ReportVelocityState:
        """Everything that is measured; there is no estimate of the errors."""
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
        """As `report_velocity_state`, always in the vehicle's frame, with the speed and the time since 1970."""
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
