"""What the controller of a modular arm needs of the servo modules, in the robot's thread. Backends implement it."""

from __future__ import annotations

from typing import NamedTuple, Protocol

from jauspy.platform.description import Gains


class ServoReading(NamedTuple):
    """What a servo module measures at one moment; if `powered` is False, its last report."""

    powered: bool
    position: float
    """Radians at the output, any number of turns."""
    velocity: float
    """rad/s at the output."""
    torque: float
    """Newton metres through the spring, positive if it accelerates the output."""


class ServoDrive(Protocol):
    """A servo module as a modular arm commands it; the backend's `ServoModule` may be one itself."""

    @property
    def name(self) -> str:
        """As in `servo_1`."""
        ...

    def read(self) -> ServoReading:
        """What it measures now; cheap, it is called in each control cycle."""
        ...

    def set_torque(self, torque: float) -> None:
        """Have the motor apply a torque (N m at the output), clamped to its limit, until the next command."""
        ...

    def hold(self) -> None:
        """Brake, and hold the position where it comes to rest, by its own controller."""
        ...

    def claim(self, arm: str) -> None:
        """Obey only the modular arm of this name from now on; empty ends the claim. `ServoState` reports it."""
        ...

    def gains(self) -> tuple[Gains, Gains]:
        """The gains of its own controllers: of position and of velocity."""
        ...
