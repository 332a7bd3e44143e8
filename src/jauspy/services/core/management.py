"""Management: Standby, Ready, Emergency and the rest of a component's life (AS5710)."""

from __future__ import annotations

from typing import Final

from jauspy.ids import JausID
from jauspy.messages.core import ReportStatus
from jauspy.services.service import Service
from jauspy.services.state_machine import STAY, ActionResult

MAX_EMERGENCY_CLIENTS: Final = 64
"""Clients whose emergency is remembered one by one; more keep the emergency, but need not clear it."""


class Management(Service, urn="urn:jaus:jss:core:Management"):
    """The status of the component. An emergency lasts until every client that set it has cleared it."""

    def __init__(self) -> None:
        self._emergency_clients: set[JausID] = set()

    @property
    def status(self) -> ReportStatus.Status:
        """What the active state means."""
        return _status(self.host.path)

    def initialize(self) -> None:
        """Nothing takes time here, so initialization is over at once; a component with hardware overrides this."""
        self.host.fire("Initialized")

    def store_id(self, source: JausID) -> None:
        """`source` has set the emergency."""
        if len(self._emergency_clients) < MAX_EMERGENCY_CLIENTS:
            self._emergency_clients.add(source)

    def is_id_stored(self, source: JausID) -> bool:
        """`source` may clear the emergency, since it has set it."""
        return source in self._emergency_clients

    def delete_id(self, source: JausID) -> ActionResult | None:
        """`source` clears its emergency; the component stays in Emergency while another client's is set."""
        self._emergency_clients.discard(source)
        return STAY if self._emergency_clients else None

    def report_status(self) -> ReportStatus:
        """The status, and four reserved bytes."""
        return ReportStatus(status=self.status, reserved=0)


_NAMES: Final = {
    "Init": ReportStatus.Status.INITIALIZE,
    "Ready": ReportStatus.Status.READY,
    "Standby": ReportStatus.Status.STANDBY,
    "Shutdown": ReportStatus.Status.SHUTDOWN,
    "Failure": ReportStatus.Status.FAILURE,
    "Emergency": ReportStatus.Status.EMERGENCY,
}


def _status(path: tuple[str, ...]) -> ReportStatus.Status:
    """The innermost state that Management names; services may put states of their own inside these."""
    return next((_NAMES[name] for name in reversed(path) if name in _NAMES), ReportStatus.Status.INITIALIZE)
