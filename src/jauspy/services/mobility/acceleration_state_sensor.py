"""AccelerationStateSensor: how the platform's motion changes, in its own frame (AS6009)."""

from __future__ import annotations

from jauspy.geometry.poses import jaus_acceleration
from jauspy.messages.mobility import ReportAccelerationState, ReportAccelerationStateExt
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.service import Service
from jauspy.services.stamps import epoch_seconds, time_stamp


class AccelerationStateSensor(Service, urn="urn:jaus:jss:mobility:AccelerationStateSensor"):
    """Accelerations (m/s^2, rad/s^2) in JAUS body axes, x forward, y right, z down; gravity is left out."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._drive = vehicle.drive

    def report_acceleration_state(self) -> ReportAccelerationState:
        """Everything that is measured; there is no estimate of the errors."""
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
        """As `report_acceleration_state`, with the time since 1970."""
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
