"""Clients of events on other machines: those that show no sign of life are not sent to for long (ADR 128).

A request with a forged source would otherwise have a component send reports to somebody else for minutes.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Final

from jauspy.ids import JausID
from jauspy.protocol.addressing import Location
from jauspy.services.service import ServiceHost

MAX_UNHEARD: Final = 10
"""Datagrams of reports to a client that was not heard since its request, or since it was heard last."""
UNHEARD_TIME: Final = 2.0
"""Seconds after which events of a client end that was never heard after its request."""
MAX_SILENCE: Final = 10.0
"""Seconds after which events of a client end that has acknowledged before, and does not any more."""
PROBE_INTERVAL: Final = 1.0
"""Seconds between two reports to a client that request an acknowledgement; the others are sent as they are."""
PROBE_COST: Final = 4
"""Datagrams of a report that is not acknowledged: it is resent three times."""
PROBE_LIFETIME: Final = 2.0
"""Seconds after which the outcome of such a report does not come any more, as when it was dropped here."""
MAX_PROBES: Final = 32
"""Reports whose acknowledgement is pending; the remaining places are for command events."""


class EventClients:
    """Clients to whom a component sends events, and when each was heard."""

    def __init__(self, host: ServiceHost) -> None:
        self._host = host
        self._clients: dict[JausID, _Client] = {}

    def add(self, id: JausID) -> None:
        """A client has an event; one of this machine is not checked."""
        if id not in self._clients:
            client = self._clients[id] = _Client()
            self._host.locate(id, partial(_located, client))

    def remove(self, id: JausID) -> None:
        """The client has no event any more."""
        self._clients.pop(id, None)

    def heard(self, id: JausID) -> None:
        """A message of this client has arrived, which a host that forges ids may have sent: it counts for little."""
        client = self._clients.get(id)
        if client is not None:
            client.sent, client.since = 0, math.inf

    def is_gone(self, id: JausID) -> bool:
        """True when the client was not heard for so long that its events are to end."""
        client, now = self._clients.get(id), self._host.now
        if client is None or client.is_local:
            return False
        if client.acknowledged_at is not None and now - client.acknowledged_at < MAX_SILENCE:
            return False
        return now - client.since >= UNHEARD_TIME and now >= client.probed_until

    def may_report(self, id: JausID) -> bool:
        """False while no further report may be sent to a client that has not acknowledged one yet."""
        client = self._clients.get(id)
        return client is None or client.is_trusted or client.sent < MAX_UNHEARD

    def report(self, id: JausID) -> Callable[[bool], None] | None:
        """Note a report that is sent now; what is to be called with its acknowledgement, if it requests one."""
        client, now = self._clients.get(id), self._host.now
        if client is None or client.is_local:
            return None
        client.since = min(client.since, now)
        if not self._may_probe(client, now):
            client.sent += 1
            return None
        client.sent += PROBE_COST
        client.probed_at, client.probed_until = now, now + PROBE_LIFETIME
        return partial(self._on_acknowledged, client)

    def _may_probe(self, client: _Client, now: float) -> bool:
        if now < client.probed_until or now - client.probed_at < PROBE_INTERVAL:
            return False
        if not client.is_trusted and client.sent + PROBE_COST > MAX_UNHEARD:
            return False
        return sum(now < client.probed_until for client in self._clients.values()) < MAX_PROBES

    def _on_acknowledged(self, client: _Client, delivered: bool) -> None:
        client.probed_until = -math.inf
        if delivered:
            client.acknowledged_at, client.sent, client.since = self._host.now, 0, math.inf


class _Client:
    """One client."""

    __slots__ = ("acknowledged_at", "is_local", "probed_at", "probed_until", "sent", "since")

    def __init__(self) -> None:
        self.is_local = False
        self.acknowledged_at: float | None = None
        self.since = math.inf
        """Time of the first report that was sent after it was heard."""
        self.sent = 0
        """Datagrams of reports since then."""
        self.probed_at = -math.inf
        """Time at which an acknowledgement was requested last."""
        self.probed_until = -math.inf
        """Until when it is pending."""

    @property
    def is_trusted(self) -> bool:
        return self.is_local or self.acknowledged_at is not None


def _located(client: _Client, location: Location) -> None:
    client.is_local = location.is_here
