"""LocalVectorDriver and GlobalVectorDriver: a heading and a speed, kept until the next command (AS6009)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from jauspy.messages.mobility import (
    GlobalZPosition,
    ReportGlobalVector,
    ReportGlobalVectorExt,
    ReportLocalVector,
    ReportLocalVectorExt,
    SetGlobalVector,
    SetGlobalVectorExt,
    SetLocalVector,
    SetLocalVectorExt,
    ZPosition,
)
from jauspy.services.mobility.courses import VectorCourse
from jauspy.services.mobility.driver import Driver
from jauspy.services.mobility.field_ranges import MAX_ALTITUDE, MIN_ALTITUDE, local_z, speed_over_ground, unsigned_speed
from jauspy.services.mobility.vehicle import Vehicle


@dataclass(frozen=True, slots=True)
class CommandedVector:
    """Speed in m/s (negative backward), angles in radians in the driver's frame; None for what was not commanded."""

    speed: float = 0.0
    heading: float | None = None
    roll: float | None = None
    pitch: float | None = None


class VectorDriver(Driver):
    """Turns on the spot if the heading error is large, then drives. Without a heading, the present one is kept.

    A chassis that cannot turn on the spot drives a curve; with a speed of zero it stands, and that is counted.

    Height, roll and pitch are those of the ground: commanded values are reported, and ignored otherwise.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._vector = CommandedVector()

    def present_heading(self) -> float:
        """The heading of the platform in the driver's frame, rad."""
        raise NotImplementedError(f"{type(self).__name__}.present_heading")

    def heading_in_world(self, heading: float) -> Callable[[], float]:
        """Converts a heading to the world, at each call, since the driver's frame may be set meanwhile."""
        raise NotImplementedError(f"{type(self).__name__}.heading_in_world")

    def drive_along(self, vector: CommandedVector) -> None:
        """Follow a vector until the next command."""
        heading = self.present_heading() if vector.heading is None else vector.heading
        chassis = self.vehicle.chassis
        if chassis.min_turn_radius and not vector.speed and vector.heading is not None:
            self.host.count("cannot_turn_on_the_spot", f"{vector}")
        course = VectorCourse(
            self.heading_in_world(heading), vector.speed, chassis.max_turn_rate, chassis.min_turn_radius
        )
        self._vector = vector
        self.vehicle.pilot.follow(self, course)

    def drive_along_course(self, msg: SetGlobalVectorExt | SetLocalVectorExt) -> bool:
        """Follow the vector of a wide form; False, and counted, for a speed that is not one over ground."""
        speed = self.usable_speed(msg)
        if speed is None:
            return False
        heading = msg.course if msg.heading is None else msg.heading
        self.drive_along(CommandedVector(speed, heading, msg.roll, msg.pitch))
        return True

    def on_preempted(self) -> None:
        """The reported speed becomes zero."""
        self._vector = replace(self._vector, speed=0.0)

    @property
    def vector(self) -> CommandedVector:
        """The last command; its speed is zero after a stop, and while another service drives."""
        return self._vector


class GlobalVectorDriver(VectorDriver, urn="urn:jaus:jss:mobility:GlobalVectorDriver"):
    """Headings are clockwise from true north. The vehicle needs an origin."""

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._altitude: float | None = None
        self._z: GlobalZPosition | None = None
        self._course: float | None = None

    def attached(self) -> None:
        """Raises `ConfigError` without an origin."""
        super().attached()
        self.vehicle.global_frame()

    def present_heading(self) -> float:
        """The true heading, rad."""
        return self.vehicle.global_frame().from_world(self.vehicle.pose_on_globe).heading

    def heading_in_world(self, heading: float) -> Callable[[], float]:
        """Heading in the world of one in the global frame."""
        return lambda: self.vehicle.heading_on_globe(heading)

    def set_global_vector(self, msg: SetGlobalVector) -> None:
        """A speed that is left out is zero."""
        self.drive_along(CommandedVector(msg.speed or 0.0, msg.heading, msg.roll, msg.pitch))
        self._altitude, self._z, self._course = msg.altitude, None, None

    def set_global_vector_ext(self, msg: SetGlobalVectorExt) -> None:
        """Same as `set_global_vector`; ignored, and counted, for a speed that is not one over ground."""
        if self.drive_along_course(msg):
            self._altitude, self._z, self._course = None, msg.z_position, msg.course

    def report_global_vector(self) -> ReportGlobalVector:
        """The command; its speed without direction, which only the wide form has."""
        vector = self.vector
        return ReportGlobalVector(
            speed=unsigned_speed(vector.speed),
            altitude=self._altitude,
            heading=vector.heading,
            roll=vector.roll,
            pitch=vector.pitch,
        )

    def report_global_vector_ext(self) -> ReportGlobalVectorExt:
        """The command."""
        vector = self.vector
        return ReportGlobalVectorExt(
            speed=speed_over_ground(vector.speed),
            z_position=self._z,
            roll=vector.roll,
            pitch=vector.pitch,
            heading=vector.heading,
            course=self._course,
        )


class LocalVectorDriver(VectorDriver, urn="urn:jaus:jss:mobility:LocalVectorDriver"):
    """Headings are in the local frame; if it is set, the platform turns with it. A course is taken as a heading."""

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._z: ZPosition | None = None
        self._course: float | None = None

    def present_heading(self) -> float:
        """The heading in the local frame, rad."""
        return self.vehicle.local_frame.from_world(self.vehicle.pose).yaw

    def heading_in_world(self, heading: float) -> Callable[[], float]:
        """Heading in the world of one in the local frame."""
        return lambda: self.vehicle.local_frame.heading_to_world(heading)

    def set_local_vector(self, msg: SetLocalVector) -> None:
        """Follow this vector until the next command."""
        self.drive_along(CommandedVector(msg.speed, msg.heading, msg.roll, msg.pitch))
        self._z = None if msg.z is None else ZPosition(ZPosition.Choice.Z_LOCAL, msg.z)
        self._course = None

    def set_local_vector_ext(self, msg: SetLocalVectorExt) -> None:
        """Same as `set_local_vector`; ignored, and counted, for a speed that is not one over ground."""
        if self.drive_along_course(msg):
            self._z, self._course = msg.z_position, msg.course

    def report_local_vector(self) -> ReportLocalVector:
        """The command; its speed without direction, which only the wide form has."""
        vector = self.vector
        return ReportLocalVector(
            speed=unsigned_speed(vector.speed),
            z=local_z(self._z, MIN_ALTITUDE, MAX_ALTITUDE),
            heading=vector.heading,
            roll=vector.roll,
            pitch=vector.pitch,
        )

    def report_local_vector_ext(self) -> ReportLocalVectorExt:
        """The command."""
        vector = self.vector
        return ReportLocalVectorExt(
            speed=speed_over_ground(vector.speed),
            z_position=self._z,
            roll=vector.roll,
            pitch=vector.pitch,
            heading=vector.heading,
            course=self._course,
        )
