"""Continuous commands, such as efforts and velocities: the motion stops unless the next command arrives in time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from enum import Enum
from typing import Final

from jauspy.services.service import Service

DEFAULT_TIMEOUT: Final = 2.0
"""Seconds; clients repeat such commands several times a second."""


class Zero(Enum):
    """Fields of a command that are zero in the one that stops its motion."""

    ALL = "all"
    SPEED = "speed"
    """The heading and the attitude of a vector stay."""
    NONE = "none"
    """There is no such command: an arm falls without the forces of its motors. The time-out or Standby stop it."""


CONTINUOUS_COMMANDS: Final[Mapping[str, Zero]] = {
    **dict.fromkeys(("SetWrenchEffort", "SetSkidSteerEffort", "SetVelocityCommand", "SetVelocityCommandExt"), Zero.ALL),
    **dict.fromkeys(("SetLocalVector", "SetGlobalVector", "SetLocalVectorExt", "SetGlobalVectorExt"), Zero.SPEED),
    **dict.fromkeys(("SetJointEffort", "SetJointVelocity", "SetEndEffectorVelocityState"), Zero.ALL),
    **dict.fromkeys(("SetPanTiltJointEffort", "SetPanTiltJointVelocity"), Zero.ALL),
    **dict.fromkeys(("SetActuatorForceTorques", "SetServoTarget"), Zero.NONE),
}
"""Names of the commands that a client must repeat to continue a motion (AS6009, AS6057, AS6091), and how each is
stopped."""


class ContinuousCommands(Service):
    """The base of services with continuous commands.

    Held control does not show that an operator is active, since it is renewed in the background.
    """

    command_timeout: float | None = None
    """Seconds after a command in which the next one must arrive; None is no limit."""

    def expect_next_command(self, stop: Callable[[], None]) -> None:
        """Call `stop` unless this is called again in time; it must do nothing if another service moves by then."""
        if self.command_timeout is not None:
            self.host.set_timer(self._command_timer, self.host.now + self.command_timeout, lambda: self._time_out(stop))

    def expect_no_command(self) -> None:
        """The motion has ended."""
        self.host.cancel_timer(self._command_timer)

    @property
    def _command_timer(self) -> tuple[str, str]:
        return ("command timeout", self.urn)

    def _time_out(self, stop: Callable[[], None]) -> None:
        self.host.count("command_timeout", f"no command for {self.command_timeout:g} s: the motion stops")
        stop()
