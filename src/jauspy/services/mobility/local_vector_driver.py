"""LocalVectorDriver: a heading in the local frame, at a speed (AS6009)."""

from __future__ import annotations

from collections.abc import Callable

from jauspy.messages.mobility import (
    ReportLocalVector,
    ReportLocalVectorExt,
    SetLocalVector,
    SetLocalVectorExt,
    ZPosition,
)
from jauspy.services.mobility.field_ranges import MAX_ALTITUDE, MIN_ALTITUDE, local_z, speed_over_ground, unsigned_speed
from jauspy.services.mobility.vector_driver import CommandedVector, VectorDriver
from jauspy.services.mobility.vehicle import Vehicle


class LocalVectorDriver(VectorDriver, urn="urn:jaus:jss:mobility:LocalVectorDriver"):
    """When the local frame is set on the way, the platform turns with it. A course is the heading: it cannot crab."""

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._z: ZPosition | None = None
        self._course: float | None = None

    def present_heading(self) -> float:
        """Where the platform looks, in the local frame."""
        return self.vehicle.local.show(self.vehicle.pose).yaw

    def in_world(self, heading: float) -> Callable[[], float]:
        """A heading of the local frame, in the world."""
        return lambda: self.vehicle.local.heading(heading)

    def set_local_vector(self, msg: SetLocalVector) -> None:
        """Reached only in Ready, from the controlling client."""
        self.drive_along(CommandedVector(msg.speed, msg.heading, msg.roll, msg.pitch))
        self._z = None if msg.z is None else ZPosition(ZPosition.Choice.Z_LOCAL, msg.z)
        self._course = None

    def set_local_vector_ext(self, msg: SetLocalVectorExt) -> None:
        """As `set_local_vector`, with several kinds of speed and vertical datums."""
        speed = self.usable_speed(msg)
        if speed is not None:
            heading = msg.course if msg.heading is None else msg.heading
            self.drive_along(CommandedVector(speed, heading, msg.roll, msg.pitch))
            self._z, self._course = msg.z_position, msg.course

    def report_local_vector(self) -> ReportLocalVector:
        """What was commanded; the speed without its direction, which only the wider form has."""
        vector = self.vector
        return ReportLocalVector(
            speed=unsigned_speed(vector.speed),
            z=local_z(self._z, MIN_ALTITUDE, MAX_ALTITUDE),
            heading=vector.heading,
            roll=vector.roll,
            pitch=vector.pitch,
        )

    def report_local_vector_ext(self) -> ReportLocalVectorExt:
        """What was commanded."""
        vector = self.vector
        return ReportLocalVectorExt(
            speed=speed_over_ground(vector.speed),
            z_position=self._z,
            roll=vector.roll,
            pitch=vector.pitch,
            heading=vector.heading,
            course=self._course,
        )
