"""Components of two node managers on a bad network: everything without I/O, on a virtual clock."""

import heapq
import itertools
import random
from collections import Counter

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import junior
from jauspy.protocol.addressing import GroupPort, LocalPort, UdpPort
from jauspy.protocol.delivery import Delivery
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack, Broadcast, Packet
from jauspy.protocol.routing import CompressionUse, Router

A, B, C = (JausID.parse(text) for text in ("101.1.1", "102.1.1", "103.1.1"))


class Host:
    """A node manager with one component, and its address."""

    def __init__(self, number: int, id: JausID, delivery: Delivery, use: CompressionUse) -> None:
        self.port = UdpPort(f"10.0.0.{number}", 3794)
        self.node = Router("/root", compression=use)
        self.local = LocalPort(f"/root/{int(id)}")
        self.endpoint = Endpoint(id, first_sequence=1000 * number, delivery=delivery)
        self.node.receive(junior.connect(id), self.local, 0.0)
        self.received: list[Packet] = []
        self.outcomes: dict[int, bool] = {}


class World:
    """Hosts on a network that loses, doubles, delays and so reorders what passes between node managers."""

    def __init__(
        self, seed: int, *ids: JausID, loss: float, twice: float, delay: float, use: CompressionUse, delivery: Delivery
    ) -> None:
        self.chance = random.Random(seed)
        self.loss, self.twice, self.delay = loss, twice, delay
        self.hosts = {id: Host(number, id, delivery, use) for number, id in enumerate(ids, 1)}
        self.now = 0.0
        self._air: list[tuple[float, int, Host, bytes, UdpPort]] = []
        self._order = itertools.count()

    def send(self, source: JausID, destination: JausID, payload: bytes, ack: Ack = Ack.REQUIRED) -> int | None:
        host = self.hosts[source]
        broadcast = Broadcast.GLOBAL if destination == EVERYONE else Broadcast.NONE
        ticket = host.endpoint.send(destination, payload, now=self.now, ack=ack, broadcast=broadcast)
        self._settle(host)
        return ticket

    def run(self, seconds: float) -> None:
        """Let time pass."""
        end = self.now + seconds
        while (due := min(self._times(), default=end)) <= end:
            self.now = max(self.now, due)
            while self._air and self._air[0][0] <= self.now:
                _, _, host, data, source = heapq.heappop(self._air)
                host.node.receive(data, source, self.now)
                self._settle(host)
            for host in self.hosts.values():
                host.endpoint.handle_timeout(self.now)
                host.node.handle_timeout(self.now)
                self._settle(host)
            if due == end:
                break
        self.now = end

    def _times(self) -> list[float]:
        mine = [
            each for host in self.hosts.values() for each in (host.endpoint.next_timeout(), host.node.next_timeout())
        ]
        return [each for each in mine if each is not None] + [each[0] for each in self._air[:1]]

    def _settle(self, host: Host) -> None:
        """Carry everything between the component, its node manager and the network until nothing is left to carry."""
        busy = True
        while busy:
            busy = False
            for data in host.endpoint.poll_output():
                host.node.receive(data, host.local, self.now)
            for port, data in host.node.poll_output():
                busy = True
                if isinstance(port, LocalPort):
                    host.endpoint.receive(data, self.now)
                else:
                    self._carry(host, port, data)
            while (packet := host.endpoint.next_event()) is not None:
                host.received.append(packet)
            while (outcome := host.endpoint.next_outcome()) is not None:
                host.outcomes[outcome.ticket] = outcome.delivered

    def _carry(self, sender: Host, port: object, data: bytes) -> None:
        for host in self.hosts.values():
            if host is sender or not (isinstance(port, GroupPort) or port == host.port):
                continue
            for _ in range(1 + (self.chance.random() < self.twice)):
                if self.chance.random() >= self.loss:
                    at = self.now + self.delay * self.chance.random()
                    heapq.heappush(self._air, (at, next(self._order), host, data, sender.port))


def world(seed: int, *ids: JausID, use: CompressionUse = "accept", **faults: float) -> World:
    delivery = Delivery(max_message=16 << 20, resends=12)
    return World(seed, *ids, **({"loss": 0.2, "twice": 0.1, "delay": 0.05} | faults), use=use, delivery=delivery)


@pytest.mark.parametrize("use", ["accept", "propose"])
@pytest.mark.parametrize("seed", range(3))
def test_each_sent_message_arrives_once(seed: int, use: CompressionUse) -> None:
    """Three hosts that have never heard of each other, messages of one and of several pieces, all at once."""
    network = world(seed, A, B, C, use=use)
    sent = []
    for number in range(60):
        source, destination = network.chance.sample((A, B, C), 2)
        payload = b"\x02\x20" + number.to_bytes(2, "big") + bytes(network.chance.choice((0, 50, 9000)))
        sent.append((source, destination, payload, network.send(source, destination, payload)))
        network.run(0.05)
    network.run(60.0)
    for source, destination, payload, ticket in sent:
        arrived = [each for each in network.hosts[destination].received if each.payload == payload]
        assert len(arrived) == 1 or (not arrived and not network.hosts[source].outcomes[ticket or 0])
    outcomes = Counter(delivered for host in network.hosts.values() for delivered in host.outcomes.values())
    assert outcomes[True] == sum(outcomes.values()) == 60
    if use == "propose":
        assert sum(host.node.counters["compression.received"] for host in network.hosts.values()) > 50


@pytest.mark.slow
def test_16_mb_message_passes_two_node_managers_and_a_bad_network() -> None:
    network = world(1, A, B, loss=0.02, twice=0.02, delay=0.002)
    payload = network.chance.randbytes(16 << 20)
    ticket = network.send(A, B, payload)
    network.run(200.0)
    assert network.hosts[A].outcomes == {ticket: True}
    assert [packet.payload for packet in network.hosts[B].received] == [payload]


def test_broadcasts_are_not_repeated_by_node_managers() -> None:
    network = world(2, A, B, C, loss=0.0, twice=0.3)
    for number in range(200):
        network.send(A, EVERYONE, b"\x02\x20" + bytes([number]), Ack.NONE)
        network.run(0.2)
    assert not network.hosts[A].received
    for id in (B, C):
        reported = [packet.payload[2] for packet in network.hosts[id].received]
        assert sorted(reported) == list(range(200))
    assert sum(host.node.counters["routed.multicast"] for host in network.hosts.values()) == 200


def test_restarted_host_is_found_again() -> None:
    """Its node manager and its component have forgotten everything, and its numbers begin where they began before."""
    network = world(3, A, B, loss=0.1)
    for life in range(3):
        for number in range(10):
            network.send(A, B, bytes([2, 0x20, life, number]))
            network.send(B, A, bytes([2, 0x20, life, number]))
            network.run(0.1)
        network.run(20.0)
        received = sorted(packet.payload[2:4] for packet in network.hosts[B].received)
        assert received == [bytes([life, number]) for number in range(10)]
        network.hosts[B] = Host(2, B, Delivery(resends=12), "accept")
    assert len(network.hosts[A].received) == 30
