"""The base of the services that move the arm."""

from __future__ import annotations

from jauspy.services.manipulator.arm import Arm
from jauspy.services.service import Service


class ArmDriver(Service):
    """Moves the joints, which it shares with the other driver services of its component; the newest command counts."""

    def __init__(self, arm: Arm) -> None:
        self.arm = arm

    @property
    def moves(self) -> bool:
        """True while the joints follow the command of this very service."""
        return self.arm.driver is self

    def taken_over(self) -> None:
        """Called when another driver's command, or a stop, ends what this one was doing."""

    def stop_motion(self) -> None:
        """Runs when Ready is left, for whatever reason (the JSIDL of most drivers names it)."""
        self.arm.stop()

    def control_lost(self) -> None:
        """Another client's motion must not go on under a new one, which may not know of it."""
        super().control_lost()
        self.arm.stop()
