"""Transport: what the other services send goes out through its SendFSM (AS5710)."""

from __future__ import annotations

from jauspy.services.messaging import Outgoing
from jauspy.services.service import Service


class Transport(Service, urn="urn:jaus:jss:core:Transport", private=True):
    """Queues what is to be sent; a shell takes it from the host."""

    def enqueue(self, msg: Outgoing) -> None:
        """Send to one component, or to all that a wildcard id matches."""
        self.host.output(msg)

    def broadcast_local_enqueue(self, msg: Outgoing) -> None:
        """Send to all components of the subsystem."""
        self.host.output(msg)

    def broadcast_global_enqueue(self, msg: Outgoing) -> None:
        """Send to all components of all subsystems."""
        self.host.output(msg)
