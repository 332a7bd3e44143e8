"""The base of the services that drive the platform."""

from __future__ import annotations

from typing import Any, ClassVar

from jauspy.messages.mobility import ReportWrenchEffort, SetWrenchEffort
from jauspy.services.mobility.field_ranges import ground_speed
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.percent import percent
from jauspy.services.service import Service


class Driver(Service):
    """Drives through the pilot, which it shares with the other driver services of its component."""

    travels: ClassVar[bool] = False
    """True for those to whom the pilot's travel speed belongs."""

    def __init__(self, vehicle: Vehicle) -> None:
        self.vehicle = vehicle

    def attached(self) -> None:
        """Give the pilot the component's clock."""
        super().attached()
        self.vehicle.pilot.attach(self.host)

    @property
    def drives(self) -> bool:
        """True while the platform follows the command of this very service."""
        return self.vehicle.pilot.driver is self

    def usable_speed(self, msg: Any) -> float | None:
        """The speed of a message, m/s; None, and counted, when it is of a kind that a platform on tracks has not."""
        speed = ground_speed(msg.speed)
        if speed is None:
            self.host.count("unsupported_speed", f"{msg}")
            self.host.begin_command()(False)
        return speed

    def arrived(self) -> None:
        """Called when there is nothing more to do on the course; the platform slows down already."""
        self.vehicle.pilot.release(self)

    def taken_over(self) -> None:
        """Called when another driver's command, or a stop, ends what this one was doing."""

    def reset_travel_speed(self) -> None:
        """Runs when Ready is left, for whatever reason (the JSIDL of most drivers names it)."""
        self.vehicle.pilot.stop()

    def control_lost(self) -> None:
        """Another client's motion must not go on under a new one, which may not know of it."""
        super().control_lost()
        self.vehicle.pilot.stop()


class PrimitiveDriver(Driver, urn="urn:jaus:jss:mobility:PrimitiveDriver"):
    """Drives along x and turns about z; a platform of this kind has no other axes, and no brakes to set.

    A command counts as a whole: an effort that it leaves out is zero.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        super().__init__(vehicle)
        self._linear_x = 0.0
        self._rotational_z = 0.0

    def set_wrench_effort(self, msg: SetWrenchEffort) -> None:
        """Reached only in Ready, from the controlling client. JAUS turns right for positive z."""
        self._linear_x = percent(msg.propulsive_linear_effort_x)
        self._rotational_z = percent(msg.propulsive_rotational_effort_z)
        self.vehicle.pilot.push(self, forward=self._linear_x / 100.0, right=self._rotational_z / 100.0)

    def taken_over(self) -> None:
        """The efforts end."""
        self._linear_x = self._rotational_z = 0.0

    def report_wrench_effort(self) -> ReportWrenchEffort:
        """The last commanded efforts, in percent; zero when they were stopped or another service drives."""
        return ReportWrenchEffort(
            propulsive_linear_effort_x=self._linear_x, propulsive_rotational_effort_z=self._rotational_z
        )
