"""What LocalVectorDriver and GlobalVectorDriver have in common: a heading and a speed, kept until told otherwise."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from jauspy.services.mobility.courses import VectorCourse
from jauspy.services.mobility.driver import Driver
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

    def in_world(self, heading: float) -> Callable[[], float]:
        """A heading of the driver's frame as the world's, whenever asked: the frame may be set meanwhile."""
        raise NotImplementedError(f"{type(self).__name__}.in_world")

    def drive_along(self, vector: CommandedVector) -> None:
        """From now on."""
        heading = self.present_heading() if vector.heading is None else vector.heading
        course = VectorCourse(self.in_world(heading), vector.speed, self.vehicle.chassis.max_turn_rate)
        self.vehicle.pilot.follow(self, course)
        self._vector = vector

    def taken_over(self) -> None:
        """The speed ends; the rest is remembered for reports."""
        self._vector = replace(self._vector, speed=0.0)

    @property
    def vector(self) -> CommandedVector:
        """What was last commanded; its speed is zero when it was stopped or another service drives."""
        return self._vector
