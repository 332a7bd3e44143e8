"""The base of the services that drive the platform."""

from __future__ import annotations

from typing import Any, ClassVar

from jauspy.services.mobility.field_ranges import ground_speed
from jauspy.services.mobility.vehicle import Vehicle
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
