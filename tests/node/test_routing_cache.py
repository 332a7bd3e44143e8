"""The short way gives what the whole way gives: same datagrams, same order, same counters."""

import asyncio
import random
from pathlib import Path

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager, manager
from jauspy.node.manager import RoutingCache
from jauspy.protocol import judp, junior
from jauspy.protocol.addressing import GroupPort, LocalPort, Port, UdpPort
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority
from jauspy.protocol.routing import BroadcastRoute, Router
from jauspy.protocol.sources import SourceChecks, SourceLimits

HERE, THERE, FAR, AWAY = (JausID.parse(text) for text in ("101.1.1", "101.1.2", "42.1.1", "43.1.1"))
IDS = (HERE, THERE, FAR, AWAY)
ANYBODY = (*IDS, EVERYONE, JausID(101, 1, 255), JausID(0, 0, 0), JausID(7, 7, 7))
PORTS: tuple[Port, ...] = (
    *(LocalPort(f"/tmp/{int(id)}") for id in IDS),
    LocalPort(""),
    UdpPort("10.0.0.2", 3794),
    UdpPort("10.0.0.2", 4000),
    UdpPort("10.0.0.3", 3794),
    UdpPort("127.0.0.1", 5000),
)
HOMES: tuple[Port, ...] = (PORTS[0], PORTS[1], UdpPort("10.0.0.2", 3794), UdpPort("10.0.0.3", 3794))
"""Where each of `IDS` is."""


class CountingRouter:
    """A router, with a routing cache or without."""

    def __init__(self, *, cached: bool, check_address: bool = True) -> None:
        self.out: list[tuple[Port, bytes]] = []
        self.cached = self.broadcast = 0
        self.router = Router("/tmp", sources=SourceChecks(SourceLimits(check_address)), changed=self._changed)
        self.cache = RoutingCache(
            self.router,
            self._open if cached else lambda _: None,
            self._open_broadcast if cached else lambda _: None,
        )

    def _open(self, port: LocalPort | UdpPort) -> manager.Send:
        def send(datagram: bytes) -> None:
            self.cached += 1
            self.out.append((port, datagram))

        return send

    def _open_broadcast(self, route: BroadcastRoute) -> manager.Send:
        def send(datagram: bytes) -> None:
            self.cached += 1
            self.broadcast += 1
            self.out += [(port, datagram) for port in route.components]
            for network in route.networks:
                self.router.note_multicast(datagram, network, asyncio.get_running_loop().time())
                self.out.append((GroupPort(network), datagram))

        return send

    def _changed(self, id: int | None) -> None:
        self.cache.invalidate(id)

    def take(self, datagram: bytes, port: Port, now: float) -> None:
        if not self.cache.forward(datagram, port):
            self.router.receive(datagram, port, now)
            self.out += self.router.poll_output()


def any_source(chance: random.Random) -> tuple[JausID, Port]:
    """An id and where it sends from: mostly from its own port, since elsewhere it is dropped as a duplicate."""
    number = chance.randrange(len(IDS))
    return IDS[number], HOMES[number] if chance.random() < 0.95 else chance.choice(PORTS)


def any_datagram(chance: random.Random, source: JausID, number: int) -> bytes:
    """Mostly plain packets between ids that are used again and again."""
    destination = chance.choice(IDS if chance.random() < 0.8 else ANYBODY)
    plain = judp.pack(
        Packet(
            source,
            destination,
            b"\x02\x20" + number.to_bytes(4, "little"),
            number & 0xFFFF,
            chance.choice(list(Priority)),
            chance.choice(list(Broadcast)),
            chance.choice(list(Ack)),
            chance.choice(list(DataFlag)),
        )
    )
    match chance.randrange(40):
        case 0:
            return junior.connect(source)
        case 1:
            return junior.cancel(source)
        case 2:
            return plain[: chance.randrange(len(plain))]
        case 3:
            return plain + plain[1:]
        case 4:
            return plain[:1] + bytes([chance.randrange(256)]) + plain[2:]
        case 5:
            return plain[:2] + bytes([chance.randrange(40)]) + plain[3:]
        case 6:
            return bytes([chance.randrange(4)]) + plain[1:]
        case _:
            return plain


@pytest.mark.slow
@pytest.mark.parametrize("check_address", [False, True])
@pytest.mark.parametrize("seed", range(3))
async def test_routing_is_the_same_with_and_without_cache(seed: int, check_address: bool) -> None:
    """With checks, the first who uses an id has it, and few packets are accepted at all."""
    chance = random.Random(seed)
    quick, whole = (CountingRouter(cached=cached, check_address=check_address) for cached in (True, False))
    now = asyncio.get_running_loop().time()
    for number in range(4000):
        source, port = any_source(chance)
        datagram = any_datagram(chance, source, number)
        gone = chance.choice(PORTS) if chance.random() < 0.01 else None
        for router in (quick, whole):
            if isinstance(gone, LocalPort | UdpPort):
                router.router.remove_dead(gone)
            router.take(datagram, port, now)
        assert quick.out == whole.out, f"datagram {number}: {datagram.hex()} from {port}"
        quick.out.clear()
        whole.out.clear()
    assert quick.router.counters == whole.router.counters
    assert quick.cached > (0 if check_address else 100)
    assert quick.broadcast > 5
    quick.cache.clear()


async def test_cached_routes_of_networks_expire(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(manager, "CACHE_LIFETIME", 0.0)
    router = CountingRouter(cached=True)
    now = asyncio.get_running_loop().time()
    port = LocalPort(f"/tmp/{int(HERE)}")
    for id in (HERE, THERE):
        router.take(junior.connect(id), LocalPort(f"/tmp/{int(id)}"), now)
    router.take(judp.pack(Packet(HERE, THERE, b"\x02\x20")), port, now)
    assert len(router.cache) == 1
    peer = UdpPort("10.0.0.2", 3794)
    for _ in range(2):  # the first is learned from
        router.take(judp.pack(Packet(FAR, HERE, b"\x02\x20")), peer, now)
    router.take(judp.pack(Packet(HERE, FAR, b"\x02\x40")), port, now)
    assert len(router.cache) == 3
    async with asyncio.timeout(20):
        while len(router.cache) > 1:
            await asyncio.sleep(0)
    cached = router.cached
    router.take(judp.pack(Packet(HERE, THERE, b"\x02\x20")), port, now)
    assert router.cached == cached + 1, "the route between components of this machine holds"
    router.take(junior.cancel(THERE), LocalPort(f"/tmp/{int(THERE)}"), now)
    assert len(router.cache) == 0


async def test_unknown_destinations_are_not_cached(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(manager, "MAX_ROUTES", 3)
    router = CountingRouter(cached=True)
    now = asyncio.get_running_loop().time()
    sender = JausID(101, 1, 1)
    for number in range(1, 20):
        id = JausID(101, 1, number)
        router.take(junior.connect(id), LocalPort(f"/tmp/{int(id)}"), now)
    for number in range(1, 20):
        datagram = judp.pack(Packet(sender, JausID(101, 1, number), b"\x02\x20"))
        router.take(datagram, LocalPort(f"/tmp/{int(sender)}"), now)
        assert len(router.cache) <= 3
    router.cache.clear()


async def test_reloaded_rules_apply_to_the_next_packet(root: Path, introduce, udp) -> None:
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root)
    query = judp.pack(Packet(FAR, HERE, b"\x02\x20"))
    async with NodeManager(config) as node:
        component, peer = introduce(HERE), udp()
        loop = asyncio.get_running_loop()
        assert await loop.sock_recv(component, 100) == junior.accept(HERE)
        async with asyncio.timeout(20):
            for _ in range(5):
                peer.sendto(query, ("127.0.0.1", node.port))
                assert await loop.sock_recv(component, 100) == query
        node.reload(config.model_copy(update={"rate_limit": 0.001, "rate_burst": 1.0}))
        for _ in range(5):
            peer.sendto(query, ("127.0.0.1", node.port))
        async with asyncio.timeout(20):
            while node.counters["dropped.rate"] < 4:
                await asyncio.sleep(0)


async def test_mirror_disables_the_cache(root: Path, tmp_path: Path, introduce) -> None:
    file = tmp_path / "all.pcapng"
    texts = [b"\x02\x20" + bytes([n]) * 8 for n in range(20)]
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root, mirror=str(file))) as node:
        loop = asyncio.get_running_loop()
        here, there = introduce(HERE), introduce(THERE)
        async with asyncio.timeout(20):
            for sock in (here, there):
                await loop.sock_recv(sock, 100)
            for text in texts:
                here.sendto(judp.pack(Packet(HERE, THERE, text)), str(node.path))
                await loop.sock_recv(there, 100)
    mirrored = file.read_bytes()
    assert all(text in mirrored for text in texts)
