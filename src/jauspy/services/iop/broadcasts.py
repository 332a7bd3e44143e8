"""UnsolicitedHeartbeat and UnsolicitedBroadcastControlAvailable: what a component broadcasts by itself (IOP v3)."""

from __future__ import annotations

from typing import ClassVar, Final

from jauspy.ids import EVERYONE
from jauspy.messages.core import ReportHeartbeatPulse
from jauspy.protocol.header import Broadcast
from jauspy.services.core import AccessControl
from jauspy.services.service import Service

HEARTBEAT_PERIOD: Final = 1.0
"""Seconds between two heartbeats."""
CONTROL_PERIOD: Final = 5.0
"""Seconds between two reports of control."""
_DUE: Final = "PeriodicTimerTrigger"


class _PeriodicBroadcast(Service):
    """Raises its own event `PeriodicTimerTrigger` every `period` seconds."""

    own_events: ClassVar[frozenset[str]] = frozenset({_DUE})

    def __init__(self, period: float) -> None:
        self._period = period

    def attached(self) -> None:
        """Begin."""
        self.every(self._period, self._due)

    def _due(self) -> None:
        self.host.fire(self.own_event(_DUE))


class UnsolicitedHeartbeat(_PeriodicBroadcast, urn="urn:jaus:jss:iop:UnsolicitedHeartbeat"):
    """Broadcasts a heartbeat every `period` seconds to all components of all subsystems."""

    def __init__(self, period: float = HEARTBEAT_PERIOD) -> None:
        super().__init__(period)

    def has_jaus_id(self) -> bool:
        """The component has an id that others can answer to."""
        return not self.host.id.is_wildcard

    def broadcast_report_heart_beat_pulse(self) -> None:
        """Broadcast a heartbeat."""
        self.host.send(EVERYONE, ReportHeartbeatPulse(), broadcast=Broadcast.GLOBAL)


class UnsolicitedBroadcastControlAvailable(
    _PeriodicBroadcast, urn="urn:jaus:jss:iop:UnsolicitedBroadcastControlAvailable"
):
    """Broadcasts who is in control every `period` seconds, so that clients see when control is available."""

    def __init__(self, period: float = CONTROL_PERIOD) -> None:
        super().__init__(period)

    def broadcast_report_control(self) -> None:
        """Broadcast the client in control; all zero while control is available."""
        access = self.host.service(AccessControl)
        assert access is not None  # this service inherits from it
        self.host.send(EVERYONE, access.report_control(), broadcast=Broadcast.GLOBAL)
