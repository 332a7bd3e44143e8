"""Commands that go on until the next one, such as efforts and velocities: without a next one the motion stops."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from jauspy.services.service import Service

DEFAULT_TIMEOUT: Final = 2.0
"""Seconds; clients repeat such commands several times a second."""

CONTINUOUS_COMMANDS: Final = frozenset(
    {
        *("SetWrenchEffort", "SetSkidSteerEffort", "SetVelocityCommand", "SetVelocityCommandExt"),
        *("SetLocalVector", "SetGlobalVector"),
        *("SetJointEffort", "SetJointVelocity", "SetActuatorForceTorques", "SetEndEffectorVelocityState"),
        *("SetPanTiltJointEffort", "SetPanTiltJointVelocity"),
    }
)
"""Names of the commands that a client repeats, lest the motion stop (AS6009, AS6057, AS6091)."""


class ContinuousCommands(Service):
    """The base of services whose commands go on until the next one.

    Control alone does not show that somebody is at the controls: it is renewed in the background.
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
