"""What LocalVectorDriver and GlobalVectorDriver have in common: a heading and a speed, kept until told otherwise."""

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
    """m/s (negative backward) and radians, in the driver's frame; None for what a client leaves out."""

    speed: float = 0.0
    heading: float | None = None
    roll: float | None = None
    pitch: float | None = None


class VectorDriver(Driver):
    """Turns on the spot when it looks elsewhere, and then drives. Without a heading it keeps the one it has.

    Height, roll and pitch are the ground's: they are reported as commanded, and otherwise ignored.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._vector = CommandedVector()

    def present_heading(self) -> float:
        """Where the platform looks, in the driver's frame."""
        raise NotImplementedError(f"{type(self).__name__}.present_heading")

    def heading_in_world(self, heading: float) -> Callable[[], float]:
        """A heading of the driver's frame as the world's, whenever asked: the frame may be set meanwhile."""
        raise NotImplementedError(f"{type(self).__name__}.heading_in_world")

    def drive_along(self, vector: CommandedVector) -> None:
        """From now on."""
        heading = self.present_heading() if vector.heading is None else vector.heading
        course = VectorCourse(self.heading_in_world(heading), vector.speed, self.vehicle.chassis.max_turn_rate)
        self.vehicle.pilot.follow(self, course)
        self._vector = vector

    def on_preempted(self) -> None:
        """The speed ends; the rest is remembered for reports."""
        self._vector = replace(self._vector, speed=0.0)

    @property
    def vector(self) -> CommandedVector:
        """What was last commanded; its speed is zero when it was stopped or another service drives."""
        return self._vector


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
        self.vehicle.global_frame()

    def present_heading(self) -> float:
        """Where the platform looks, from true north."""
        return self.vehicle.global_frame().from_world(self.vehicle.pose).heading

    def heading_in_world(self, heading: float) -> Callable[[], float]:
        """A true heading, in the world."""
        return lambda: self.vehicle.global_frame().heading_to_world(heading)

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


class LocalVectorDriver(VectorDriver, urn="urn:jaus:jss:mobility:LocalVectorDriver"):
    """When the local frame is set on the way, the platform turns with it. A course is the heading: it cannot crab."""

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._z: ZPosition | None = None
        self._course: float | None = None

    def present_heading(self) -> float:
        """Where the platform looks, in the local frame."""
        return self.vehicle.local_frame.from_world(self.vehicle.pose).yaw

    def heading_in_world(self, heading: float) -> Callable[[], float]:
        """A heading of the local frame, in the world."""
        return lambda: self.vehicle.local_frame.heading_to_world(heading)

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
