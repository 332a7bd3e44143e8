"""The base of the services that drive the platform, and PrimitiveDriver, which sets efforts (AS6009)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from jauspy.messages.mobility import ReportWrenchEffort, SetWrenchEffort
from jauspy.services.command_timeout import ContinuousCommands
from jauspy.services.mobility.field_ranges import ground_speed
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.units import effort_or_zero


class Driver(ContinuousCommands):
    """Drives by the pilot, which all driver services of a component share."""

    uses_travel_speed: ClassVar[bool] = False
    """See `DriveOwner`."""

    def __init__(self, vehicle: Vehicle) -> None:
        self.vehicle = vehicle

    def attached(self) -> None:
        """Give the pilot the clock of the component."""
        super().attached()
        self.vehicle.pilot.attach(self.host)

    @property
    def is_driving(self) -> bool:
        """True while the platform carries out a command of this service."""
        return self.vehicle.pilot.driver is self

    def usable_speed(self, msg: Any) -> float | None:
        """The speed of a message in m/s; None, and counted, for a kind of speed that is not one over ground."""
        speed = ground_speed(msg.speed)
        if speed is None:
            self.host.count("unsupported_speed", f"{msg}")
            self.host.begin_command()(False)
        return speed

    def on_arrival(self) -> None:
        """Stop."""
        self.vehicle.pilot.release(self)

    def on_preempted(self) -> None:
        """Called when another service's command, or a stop, ends this service's motion."""

    def on_endless_motion(self) -> None:
        """Stop unless the client sends a further command in time."""
        self.expect_next_command(self.on_arrival)

    def resumption(self) -> Callable[[], None] | None:
        """Return a function that goes on, after a stop, with the motion that this service causes now.

        None for a motion without an end, which needs an operator.
        """
        return None

    def reset_travel_speed(self) -> None:
        """Stop when Ready is left; an action of most drivers' JSIDL."""
        self.vehicle.pilot.stop()

    def control_lost(self) -> None:
        """Stop: the next client must not inherit a motion."""
        super().control_lost()
        self.vehicle.pilot.stop()


class PrimitiveDriver(Driver, urn="urn:jaus:jss:mobility:PrimitiveDriver"):
    """Open-loop efforts along x and about z, in percent; other axes and resistive efforts are ignored.

    The effort about z is the steering angle of a chassis that steers. One that moves sideways has efforts along y, too.
    An effort that a command leaves out is zero.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._linear_x = 0.0
        self._rotational_z = 0.0
        self._linear_y = 0.0

    def set_wrench_effort(self, msg: SetWrenchEffort) -> None:
        """Drive with these efforts until the next command; positive z turns right."""
        self._linear_x = effort_or_zero(msg.propulsive_linear_effort_x)
        self._rotational_z = effort_or_zero(msg.propulsive_rotational_effort_z)
        sideways = effort_or_zero(msg.propulsive_linear_effort_y) if self.vehicle.chassis.moves_sideways else 0.0
        self._linear_y = sideways
        self.vehicle.pilot.set_effort(
            self, forward=self._linear_x / 100.0, right=self._rotational_z / 100.0, sideways=sideways / 100.0
        )

    def on_preempted(self) -> None:
        """The reported efforts become zero."""
        self._linear_x = self._rotational_z = self._linear_y = 0.0

    def report_wrench_effort(self) -> ReportWrenchEffort:
        """The commanded efforts in percent; zero after a stop, and while another service drives."""
        return ReportWrenchEffort(
            propulsive_linear_effort_x=self._linear_x,
            propulsive_linear_effort_y=self._linear_y if self.vehicle.chassis.moves_sideways else None,
            propulsive_rotational_effort_z=self._rotational_z,
        )
