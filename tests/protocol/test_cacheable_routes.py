"""What the core says about packets that need no decision, and when it takes that back."""

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.addressing import GROUP, LocalPort, Port, UdpPort
from jauspy.protocol.gateway import Gateway, GatewayRules
from jauspy.protocol.header import Packet
from jauspy.protocol.routing import Router
from jauspy.protocol.sources import MOVE_TIMEOUT, VERIFIED_INTERVAL, SourceChecks, SourceLimits

A, B, FAR, NOBODY = (JausID.parse(text) for text in ("101.1.1", "101.1.2", "42.1.1", "77.1.1"))
PEER, OTHER = UdpPort("10.0.0.2", 3794), UdpPort("10.0.0.3", 3794)


def home(id: JausID) -> LocalPort:
    return LocalPort(f"/tmp/{int(id)}")


class Node:
    """Two components, and a peer that was heard at time 0."""

    def __init__(self, **options: object) -> None:
        self.changed: list[int | None] = []
        self.core = Router("/tmp", changed=self.changed.append, **options)  # type: ignore[arg-type]
        for id in (A, B):
            self.core.receive(junior.connect(id), home(id), 0.0)
        self.hear(FAR, PEER)
        self.changed.clear()

    def hear(self, source: JausID, port: Port, now: float = 0.0) -> None:
        self.core.receive(judp.pack(Packet(source, A, b"\x02\x20")), port, now)

    def cacheable_route(self, source: JausID, destination: JausID, port: Port, now: float = 0.0) -> Port | None:
        return self.core.cacheable_route(int(source), int(destination), port, now)


def test_plain_routes_are_cacheable() -> None:
    node = Node()
    assert node.cacheable_route(A, B, home(A)) == home(B)
    assert node.cacheable_route(A, FAR, home(A)) == PEER
    assert node.cacheable_route(FAR, B, PEER) == home(B)


@pytest.mark.parametrize(
    ("source", "destination", "port"),
    [
        (A, EVERYONE, home(A)),
        (A, JausID(101, 255, 2), home(A)),
        (A, NOBODY, home(A)),
        (A, B, home(B)),  # an id that another socket uses
        (A, B, LocalPort("")),
        (NOBODY, B, home(NOBODY)),  # not registered yet
        (FAR, NOBODY, PEER),
        (FAR, B, OTHER),  # not where it was heard
        (NOBODY, B, PEER),  # not heard yet
        (A, B, PEER),  # a hijack
        (FAR, B, GROUP),
    ],
)
def test_other_routes_are_not_cacheable(source: JausID, destination: JausID, port: Port) -> None:
    assert Node().cacheable_route(source, destination, port) is None


def test_what_was_heard_is_checked_again_after_a_moment() -> None:
    node = Node()
    assert node.cacheable_route(FAR, B, PEER, 0.9 * VERIFIED_INTERVAL) is not None
    assert node.cacheable_route(FAR, B, PEER, VERIFIED_INTERVAL) is None
    assert node.cacheable_route(A, FAR, home(A), 600.0) is None


def test_rules_and_rates_disable_caching() -> None:
    limited = Node(sources=SourceChecks(SourceLimits(rate=10.0)))
    assert limited.cacheable_route(A, B, home(A)) is None
    node = Node()
    node.core.gateway = Gateway([range(101, 102)], ["lan"], ["lan"], GatewayRules([]))
    assert node.cacheable_route(A, B, home(A)) is None


def test_udp_components_are_not_cacheable() -> None:
    node = Node()
    here = UdpPort("127.0.0.1", 4000)
    node.core.receive(junior.connect(NOBODY), here, 0.0)
    assert node.cacheable_route(NOBODY, B, here) is None
    assert node.cacheable_route(A, NOBODY, home(A)) is None


def test_compressing_peers_are_not_cacheable() -> None:
    node = Node()
    plain = judp.pack(Packet(FAR, A, b"\x02\x20"))
    proposal = plain[:1] + b"\x40" + (len(plain) + 1).to_bytes(2, "little") + b"\x01\x09" + plain[4:]
    node.core.receive(proposal, PEER, 0.0)
    assert node.changed == [None]
    assert node.cacheable_route(A, FAR, home(A)) is None
    assert node.cacheable_route(FAR, B, PEER) == home(B)
    node.core.receive(proposal, PEER, 0.0)
    assert node.changed == [None]


def test_all_changes_are_reported() -> None:
    node = Node()
    node.hear(FAR, PEER, 2.0)
    node.core.receive(junior.connect(B), home(B), 2.0)
    assert node.changed == []
    node.hear(FAR, UdpPort(PEER.host, 4000), 3.0)
    assert node.changed == [int(FAR)]
    node.core.receive(junior.cancel(B), home(B), 3.0)
    assert node.changed == [int(FAR), int(B)]
    node.core.remove_dead(home(A))
    assert node.changed == [int(FAR), int(B), int(A)]
    node.core.receive(junior.connect(FAR), home(FAR), 3.0 + MOVE_TIMEOUT)
    assert node.changed[-1] == int(FAR)
