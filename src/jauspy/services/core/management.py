"""The small core services: Management, Liveness, Time and Transport (AS5710), and FailureRecovery."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from typing import Final

from jauspy.ids import JausID
from jauspy.messages.core import ReportHeartbeatPulse, ReportStatus, ReportTime, SetTime
from jauspy.services.messaging import Outgoing
from jauspy.services.service import Service
from jauspy.services.state_machine import STAY, ActionResult
from jauspy.services.units import date_stamp, time_stamp

MAX_EMERGENCY_CLIENTS: Final = 512
"""Clients whose emergency is remembered."""


class Management(Service, urn="urn:jaus:jss:core:Management"):
    """The status of the component. An emergency lasts until every client that set it has cleared it.

    An operator's client (see `CommandSeal`) also clears those that were set without a seal, which anybody can. With
    more clients than are remembered, it lasts until an operator's client clears it, or the component is started again:
    a client that invents many ids cannot end another client's emergency.
    """

    def __init__(self) -> None:
        self._emergency_clients: dict[JausID, bool] = {}
        """Clients that hold the emergency, and whether they set it with a seal."""
        self._is_any_forgotten = False
        """True after the emergency of a client that is not remembered."""

    @property
    def status(self) -> ReportStatus.Status:
        """The status of the active state."""
        return _status(self.host.path)

    def initialize(self) -> None:
        """Initialization ends immediately; a component with hardware overrides this."""
        self.host.fire("Initialized")

    def store_id(self, source: JausID) -> None:
        """`source` has set the emergency."""
        clients, sealed = self._emergency_clients, self.host.operator is not None
        if source not in clients and len(clients) >= MAX_EMERGENCY_CLIENTS:
            unsealed = self._unsealed()
            forgotten = unsealed[0] if sealed and unsealed else source
            clients.pop(forgotten, None)
            self._is_any_forgotten = True
            self.host.count("emergency_not_remembered", f"that of {forgotten}")
            if forgotten == source:
                return
        clients[source] = sealed or clients.get(source, False)

    def is_id_stored(self, source: JausID) -> bool:
        """`source` may clear the emergency, since it has set it."""
        if source in self._emergency_clients:
            return True
        return self.host.operator is not None and (self._is_any_forgotten or bool(self._unsealed()))

    def delete_id(self, source: JausID) -> ActionResult | None:
        """`source` clears its emergency; the component stays in Emergency while another client's is set."""
        cleared = {source}
        if self.host.operator is not None:
            cleared.update(self._unsealed())
            self._is_any_forgotten = False
        self._emergency_clients = {id: sealed for id, sealed in self._emergency_clients.items() if id not in cleared}
        return STAY if self._emergency_clients or self._is_any_forgotten else None

    def _unsealed(self) -> list[JausID]:
        return [id for id, sealed in self._emergency_clients.items() if not sealed]

    def report_status(self) -> ReportStatus:
        """The status of the component."""
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


class FailureRecovery(Service, urn="urn:jauspy:recovery:FailureRecovery", private=True):
    """Leaves Failure by Reset, which AS5710 does not provide for: the component is in Standby then (ADR 104).

    `recover_by` is called first: it retries what has failed, which may put the component in Failure again.
    """

    def __init__(self, recover_by: Callable[[], None] = lambda: None) -> None:
        self.recover_by = recover_by

    def recover(self) -> None:
        """Try again what has failed."""
        self.recover_by()


class Liveness(Service, urn="urn:jaus:jss:core:Liveness"):
    """Answers queries for a heartbeat."""

    def report_heartbeat_pulse(self) -> ReportHeartbeatPulse:
        """A message without fields."""
        return ReportHeartbeatPulse()


class Time(Service, urn="urn:jaus:jss:core:Time"):
    """Date and time of day in UTC. Setting it keeps an offset to the wall clock, which is not changed."""

    def set_time(self, msg: SetTime) -> None:
        """Set the fields that the message has; an impossible date is counted and ignored."""
        try:
            wanted = _combined(self.host.utc_time, msg)
        except ValueError as error:
            self.host.count("impossible_time", str(error))
            return
        self.host.clock_offset = wanted - self.host.utc_now()

    def report_time(self) -> ReportTime:
        """Time of day and date."""
        now = self.host.utc_time
        return ReportTime(time_stamp=time_stamp(now), date_stamp=date_stamp(now))


def _combined(now: datetime, msg: SetTime) -> datetime:
    parts: dict[str, int] = {}
    if (time := msg.time_stamp) is not None:
        parts |= {"day": time.day, "hour": time.hour, "minute": time.minutes, "second": time.seconds}
        parts |= {"microsecond": time.milliseconds * 1000}
    if (date := msg.date_stamp) is not None:
        parts |= {"year": 2000 + date.year, "month": date.month, "day": date.day}
    return now.replace(**parts)  # type: ignore[arg-type]  # all of these are numbers


class Transport(Service, urn="urn:jaus:jss:core:Transport", private=True):
    """Queues the messages that the other services send through its SendFSM."""

    def enqueue(self, msg: Outgoing) -> None:
        """Send to one component, or to all that a wildcard id matches."""
        self.host.output(msg)

    def broadcast_local_enqueue(self, msg: Outgoing) -> None:
        """Send to matching components at the same node manager: it sends no local broadcast to a network."""
        self.host.output(msg)

    def broadcast_global_enqueue(self, msg: Outgoing) -> None:
        """Send to matching components at the same node manager and on its networks."""
        self.host.output(msg)
