"""Two endpoints on a bad network, on virtual time."""

import heapq
import itertools
import random
from collections.abc import Callable

import pytest

from jauspy.ids import JausID
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack, Packet


class Network:
    """Carries datagrams with delay, loss, duplication and reordering; `loss` may be a function of the datagram."""

    def __init__(self, seed: int = 1, *, loss: float = 0.0, twice: float = 0.0, delay: float = 0.002) -> None:
        self.chance = random.Random(seed)
        self.loss, self.twice, self.delay = loss, twice, delay
        self.lose: Callable[[bytes], bool] = lambda _: False
        self.now = 0.0
        self.endpoints: dict[JausID, Endpoint] = {}
        self.received: dict[JausID, list[Packet]] = {}
        self.outcomes: list[tuple[int, bool]] = []
        self.sent: list[bytes] = []
        self._order = itertools.count()
        self._air: list[tuple[float, int, JausID, bytes]] = []

    def add(self, id: JausID, first_sequence: int = 1, delivery: Delivery | None = None) -> Endpoint:
        """A component on this network; one of the same id is replaced, as when it restarts."""
        self.endpoints[id] = Endpoint(id, first_sequence=first_sequence, delivery=delivery)
        self.received.setdefault(id, [])
        return self.endpoints[id]

    def send(self, source: JausID, destination: JausID, payload: bytes, ack: Ack = Ack.NONE) -> int | None:
        ticket = self.endpoints[source].send(destination, payload, now=self.now, ack=ack)
        self._collect()
        return ticket

    def run(self, until: float) -> None:
        """Let time pass, from one thing that happens to the next."""
        while True:
            times = [each.next_timeout() for each in self.endpoints.values()]
            due = min([time for time in times if time is not None] + [each[0] for each in self._air[:1]], default=until)
            self.now = max(self.now, min(due, until))
            if due > until or (due == until and not self._air and not any(times)):
                return
            while self._air and self._air[0][0] <= self.now:
                _, _, id, datagram = heapq.heappop(self._air)
                self.endpoints[id].receive(datagram, self.now)
            for endpoint in self.endpoints.values():
                endpoint.handle_timeout(self.now)
            self._collect()

    def _collect(self) -> None:
        for id, endpoint in self.endpoints.items():
            for datagram in endpoint.poll_output():
                self._carry(id, datagram)
            while (packet := endpoint.next_event()) is not None:
                self.received[id].append(packet)
            while (outcome := endpoint.next_outcome()) is not None:
                self.outcomes.append(outcome[:2])

    def _carry(self, source: JausID, datagram: bytes) -> None:
        self.sent.append(datagram)
        for _ in range(1 + (self.chance.random() < self.twice)):
            if self.chance.random() >= self.loss and not self.lose(datagram):
                at = self.now + self.delay * (0.5 + self.chance.random())
                for id in self.endpoints:
                    if id != source:
                        heapq.heappush(self._air, (at, next(self._order), id, datagram))


@pytest.fixture
def network() -> Network:
    """A network that loses nothing."""
    return Network()


@pytest.fixture(scope="session")
def bad_network() -> Callable[..., Network]:
    """Makes networks with faults."""
    return Network
