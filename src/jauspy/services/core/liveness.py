"""Liveness: answers that the component is alive (AS5710)."""

from __future__ import annotations

from jauspy.messages.core import ReportHeartbeatPulse
from jauspy.services.service import Service


class Liveness(Service, urn="urn:jaus:jss:core:Liveness"):
    """The heartbeat."""

    def report_heartbeat_pulse(self) -> ReportHeartbeatPulse:
        """There is nothing in it: that it comes is the news."""
        return ReportHeartbeatPulse()
