"""Communicator: the health of the link between the robot and those who ask for it (IOP v3).

Each client that asks is probed by small reliable messages, whose acknowledgements tell delay and loss; the node manager
tells what it has sent to the client's machine, what waits, and what the limits of the link left out. Queues and limits
have no field: HealthReporter tells them. The robot has no radio of its own whose settings could be changed, so each
change is refused.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from functools import partial
from statistics import median
from typing import Final

from jauspy.ids import JausID
from jauspy.messages.core import ReportHeartbeatPulse
from jauspy.messages.iop import (
    ReportCommunicatorCapability,
    ReportCommunicatorConfiguration,
    ReportCommunicatorHealth,
    SetCommunicatorConfigurationResponse,
)
from jauspy.protocol.addressing import Location
from jauspy.services.service import Service

PROBE_PERIOD: Final = 0.5
"""Seconds between two probes of a client."""
PROBES: Final = 20
"""Probes that count: those of the last ten seconds."""
ASKED_TIMEOUT: Final = 10.0
"""Seconds that a client is probed after it last asked."""
MAX_CLIENTS: Final = 8
"""Clients that are probed; one more is told nothing while these ask."""
LOAD_PERIOD: Final = 2.0
"""Seconds between two looks at what the node manager has sent to a client, and has in its queue."""
LOADS: Final = 6
"""Looks that count: those of ten seconds."""
MIN_LOADS: Final = 2
MAX_RATE: Final = 1000.0
"""Megabits per second that the message can tell."""
FAILED_PROBES: Final = 3
"""Probes without an answer, one after the other, after which the link has failed."""
MAX_LATENCY: Final = 1.0
_Health = ReportCommunicatorHealth


@dataclass(frozen=True, slots=True)
class _Probe:
    """A probe that has ended: packets that were sent and lost, and the round trip in seconds, if it was answered."""

    sent: int
    lost: int
    delay: float | None


@dataclass(slots=True)
class _Link:
    """Measurements of the link to one client."""

    asked: float
    probes: deque[_Probe] = field(default_factory=lambda: deque(maxlen=PROBES))
    loads: deque[tuple[float, int]] = field(default_factory=lambda: deque(maxlen=LOADS))
    """Times, and bytes sent by then."""
    waiting: int | None = None
    """Bytes in the queue."""
    left_out: deque[dict[str, int]] = field(default_factory=lambda: deque(maxlen=LOADS))
    """Messages that limits have left out by each look, by name."""

    @property
    def rate(self) -> float | None:
        """Megabits per second that the robot sends; None while it is not known."""
        if len(self.loads) < MIN_LOADS or self.loads[-1][0] <= self.loads[0][0]:
            return None
        (begin, first), (end, last) = self.loads[0], self.loads[-1]
        return 8e-6 * (last - first) / (end - begin) if last >= first else None


class Communicator(Service, urn="urn:jaus:jss:iop:Communicator"):
    """Measures links. `ack_timeout` (seconds) and `resends` are those of the component's reliable messages."""

    def __init__(self, ack_timeout: float = 0.1, resends: int = 3) -> None:
        self._ack_timeout, self._resends = ack_timeout, resends
        self._links: dict[JausID, _Link] = {}

    # --- measuring

    def _asked(self, client: JausID) -> _Link | None:
        """The link to a client that asks; None if there are too many."""
        now = self.host.now
        link = self._links.get(client)
        if link is not None:
            link.asked = now
            return link
        if len(self._links) >= MAX_CLIENTS:
            if client != self.host.controller:
                self.host.count("too_many_links", f"{client}")
                return None
            oldest = min(self._links, key=lambda known: self._links[known].asked)
            self._forget(oldest)
        link = self._links[client] = _Link(now)
        self._probe(client)
        self._look(client)
        return link

    def _forget(self, client: JausID) -> None:
        self._links.pop(client, None)
        self.host.cancel_timer(("probe", client))
        self.host.cancel_timer(("load", client))

    def _probe(self, client: JausID) -> None:
        now = self.host.now
        link = self._links.get(client)
        if link is None:
            return
        if now - link.asked > ASKED_TIMEOUT:
            self._forget(client)
            return
        self.host.set_timer(("probe", client), now + PROBE_PERIOD, partial(self._probe, client))
        self.host.send(client, ReportHeartbeatPulse(), on_acknowledged=partial(self._ended, client, now))

    def _look(self, client: JausID) -> None:
        """Have the node manager tell what it has sent to the client, and what waits."""
        if client in self._links:
            self.host.set_timer(("load", client), self.host.now + LOAD_PERIOD, partial(self._look, client))
            self.host.locate(client, partial(self._loaded, client))

    def _loaded(self, client: JausID, location: Location) -> None:
        link = self._links.get(client)
        if link is None:
            return
        link.waiting = location.waiting
        link.left_out.append(dict(location.left_out))
        if location.sent is not None:
            link.loads.append((self.host.now, location.sent))

    def queues(self) -> dict[JausID, int]:
        """Bytes that wait to be sent to each client whose link is measured, as far as they are known."""
        return {client: link.waiting for client, link in self._links.items() if link.waiting is not None}

    def left_out(self) -> dict[JausID, dict[str, int]]:
        """Messages that the limits of links to clients have left out in about ten seconds, by name."""
        found = {}
        for client, link in self._links.items():
            if len(link.left_out) >= MIN_LOADS:
                before, now = link.left_out[0], link.left_out[-1]
                counts = {name: count - before.get(name, 0) for name, count in now.items()}
                found[client] = {name: count for name, count in counts.items() if count > 0}
        return found

    def _ended(self, client: JausID, begun: float, delivered: bool) -> None:
        link = self._links.get(client)
        if link is None:
            return
        if not delivered:
            link.probes.append(_Probe(self._resends + 1, self._resends + 1, None))
            return
        delay = self.host.now - begun
        lost = min(self._resends, int(delay / self._ack_timeout))
        link.probes.append(_Probe(lost + 1, lost, delay - lost * self._ack_timeout))

    # --- reports

    def send_report_communicator_health(self, source: JausID) -> ReportCommunicatorHealth:
        """Link to the client that asks: half of the median round trip, and the share of packets that were not answered.

        The data rate is what the robot's node manager sends to the client's machine; video and sound do not pass it.

        Nothing but zero errors is known before the first probe has ended.
        """
        link = self._asked(source)
        probes = list(link.probes) if link is not None else []
        if not probes:
            return _Health(_Health.ReportCommunicatorHealthRec(), _Health.PacketErrorCountRec(0), [])
        delays = [probe.delay for probe in probes if probe.delay is not None]
        failed = len(probes) >= FAILED_PROBES and all(probe.delay is None for probe in probes[-FAILED_PROBES:])
        record = _Health.ReportCommunicatorHealthRec(
            bit_results=_Health.BIT_Results.FAILED if failed else _Health.BIT_Results.PASSED,
            latency=min(MAX_LATENCY, median(delays) / 2.0) if delays else None,
            data_rate=None if link is None or link.rate is None else min(MAX_RATE, link.rate),
        )
        rate = 100.0 * sum(probe.lost for probe in probes) / sum(probe.sent for probe in probes)
        return _Health(record, _Health.PacketErrorRateRec(rate), [])

    def send_report_communicator_capability(self) -> ReportCommunicatorCapability:
        """Nothing: the robot has no radio of its own."""
        return ReportCommunicatorCapability(ReportCommunicatorCapability.ReportCommunicatorCapabilityRec(), [], [])

    def send_report_communicator_configuration(self) -> ReportCommunicatorConfiguration:
        """No settings."""
        report = ReportCommunicatorConfiguration
        return report(
            report.ReportCommunicatorConfigurationRec(), report.NoChangeRec(report.TransmitPowerNoChange.NO_CHANGE)
        )

    # --- changes

    def is_valid_command(self) -> bool:
        """Guard: no change is possible."""
        return False

    def send_set_communicator_configuration_response(self) -> SetCommunicatorConfigurationResponse:
        """The change is refused."""
        result = SetCommunicatorConfigurationResponse.Result
        return SetCommunicatorConfigurationResponse(result(**dict.fromkeys(_REASONS, 0) | {"other_failure": 1}))

    omits = frozenset(
        {
            "store_current_configuration_values",
            "set_configuration_values",
            "revert_configuration_values",
            "confirm_configuration_values",
            "reset_timer",
        }
    )


_REASONS: Final = (
    "transmitted_status_invalid",
    "mode_invalid",
    "channel_invalid",
    "power_level_invalid",
    "modulation_invalid",
    "bandwidth_invalid",
    "encryption_mode_invalid",
    "other_failure",
)
