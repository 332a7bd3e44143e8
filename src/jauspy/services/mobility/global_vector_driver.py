"""GlobalVectorDriver: a true heading, at a speed (AS6009)."""

from __future__ import annotations

from collections.abc import Callable

from jauspy.messages.mobility import (
    GlobalZPosition,
    ReportGlobalVector,
    ReportGlobalVectorExt,
    SetGlobalVector,
    SetGlobalVectorExt,
)
from jauspy.services.mobility.field_ranges import speed_over_ground, unsigned_speed
from jauspy.services.mobility.vector_driver import CommandedVector, VectorDriver
from jauspy.services.mobility.vehicle import Vehicle


class GlobalVectorDriver(VectorDriver, urn="urn:jaus:jss:mobility:GlobalVectorDriver"):
    """As LocalVectorDriver, clockwise from true north. The vehicle needs an origin."""

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._altitude: float | None = None
        self._z: GlobalZPosition | None = None
        self._course: float | None = None

    def attached(self) -> None:
        """Check that there is one: `ConfigError` if not."""
        super().attached()
        self.vehicle.georeference()

    def present_heading(self) -> float:
        """Where the platform looks, from true north."""
        return self.vehicle.georeference().show(self.vehicle.pose).heading

    def in_world(self, heading: float) -> Callable[[], float]:
        """A true heading, in the world."""
        return lambda: self.vehicle.georeference().heading(heading)

    def set_global_vector(self, msg: SetGlobalVector) -> None:
        """Reached only in Ready, from the controlling client. A speed that is left out is zero."""
        self.drive_along(CommandedVector(msg.speed or 0.0, msg.heading, msg.roll, msg.pitch))
        self._altitude, self._z, self._course = msg.altitude, None, None

    def set_global_vector_ext(self, msg: SetGlobalVectorExt) -> None:
        """As `set_global_vector`, with several kinds of speed and vertical datums."""
        speed = self.usable_speed(msg)
        if speed is not None:
            heading = msg.course if msg.heading is None else msg.heading
            self.drive_along(CommandedVector(speed, heading, msg.roll, msg.pitch))
            self._altitude, self._z, self._course = None, msg.z_position, msg.course

    def report_global_vector(self) -> ReportGlobalVector:
        """What was commanded; the speed without its direction, which only the wider form has."""
        vector = self.vector
        return ReportGlobalVector(
            speed=unsigned_speed(vector.speed),
            altitude=self._altitude,
            heading=vector.heading,
            roll=vector.roll,
            pitch=vector.pitch,
        )

    def report_global_vector_ext(self) -> ReportGlobalVectorExt:
        """What was commanded."""
        vector = self.vector
        return ReportGlobalVectorExt(
            speed=speed_over_ground(vector.speed),
            z_position=self._z,
            roll=vector.roll,
            pitch=vector.pitch,
            heading=vector.heading,
            course=self._course,
        )
