"""Floods from the network: what is urgent overtakes, what is too much is dropped from below."""

import asyncio
import socket
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager, ingress
from jauspy.node.ingress import Ingress
from jauspy.protocol import judp, junior
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Packet, Priority
from jauspy.transport.age import DatagramReader

HERE, FAR = JausID.parse("101.1.1"), JausID.parse("42.1.1")


def packet(number: int, priority: Priority) -> bytes:
    return judp.pack(Packet(FAR, HERE, b"\x02\x20", number & 0xFFFF, priority))


class Socket:
    """Gives what is queued, as a UDP socket would."""

    def __init__(self, *datagrams: bytes) -> None:
        self.datagrams = list(datagrams)

    def recvfrom(self, _: int) -> tuple[bytes, tuple[str, int]]:
        if not self.datagrams:
            raise BlockingIOError
        return self.datagrams.pop(0), ("10.0.0.1", 3794)

    family = socket.AF_INET

    def setsockopt(self, *_: object) -> None:
        raise OSError("this kernel has no filters")


@pytest.fixture
def counters() -> Counters:
    import logging

    return Counters(logging.getLogger())


async def run(source: Socket, counters: Counters) -> list[bytes]:
    """Wake up until nothing is left; what was routed, in order."""
    routed: list[bytes] = []
    reader = Ingress(lambda data, _: routed.append(data), counters)
    ages = DatagramReader(source, counters)  # type: ignore[arg-type]
    while source.datagrams or len(reader):
        reader._wake(ages, "lan", {}, lambda error: None)
        await asyncio.sleep(0)
    return routed


async def test_urgent_packets_overtake_packets_read_with_them(counters: Counters) -> None:
    low = [packet(n, Priority.LOW) for n in range(150)]
    urgent = [packet(n, Priority.SAFETY_CRITICAL) for n in range(3)]
    routed = await run(Socket(*low, *urgent), counters)
    assert routed == urgent + low


async def test_flood_delays_urgent_packets_slightly_and_drops_only_its_own(counters: Counters) -> None:
    flood = [packet(n, Priority.LOW) for n in range(20000)]
    urgent = packet(1, Priority.SAFETY_CRITICAL)
    source = Socket(*flood[:10000], urgent, *flood[10000:])
    routed = await run(source, counters)
    wakes = 10000 // ingress.READ_BURST + 2
    assert routed.index(urgent) <= wakes * ingress.ROUTE_BURST
    lost = counters["dropped.overload"]
    assert lost > 0
    assert len(routed) == 20001 - lost
    numbers = [judp.unpack(data)[0].sequence for data in routed if data != urgent]
    assert numbers == sorted(numbers)


async def test_lowest_priority_is_dropped_first(counters: Counters) -> None:
    high = [packet(n, Priority.HIGH) for n in range(ingress.MAX_QUEUED)]
    low = [packet(n, Priority.LOW) for n in range(ingress.MAX_QUEUED)]
    routed = await run(Socket(*low, *high), counters)
    assert [data for data in routed if judp.peek_priority(data) == Priority.HIGH] == high


async def test_the_kernel_drops_a_flood_until_what_was_read_is_routed(udp, counters: Counters) -> None:
    receiver, sender = udp(), udp()
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
    routed: list[bytes] = []
    reader, ages = Ingress(lambda data, _: routed.append(data), counters), DatagramReader(receiver, counters)
    low, urgent = packet(1, Priority.LOW), packet(2, Priority.SAFETY_CRITICAL)
    where = receiver.getsockname()
    while not counters["kernel_filter.attached"]:
        for _ in range(ingress.READ_BURST):
            sender.sendto(low, where)
        reader._wake(ages, "lan", {}, lambda error: None)
    for _ in range(3):
        sender.sendto(low, where)
        sender.sendto(urgent, where)
    waiting = len(reader)
    reader._wake(ages, "lan", {}, lambda error: None)
    assert len(reader) == waiting + 3
    async with asyncio.timeout(20):
        while len(reader):
            await asyncio.sleep(0)
    assert routed.count(urgent) == 3
    sender.sendto(low, where)
    assert receiver.recv(100) == low
    assert not counters["dropped.overload"]


async def test_low_priority_is_delayed_but_not_starved(counters: Counters) -> None:
    low = [packet(n, Priority.LOW) for n in range(40)]
    urgent = [packet(n, Priority.HIGH) for n in range(2000)]
    routed = await run(Socket(*low, *urgent), counters)
    assert routed.index(low[0]) < ingress.ROUTE_BURST
    assert routed.index(low[-1]) < (40 / ingress.LOW_PRIORITY_SHARE) * ingress.ROUTE_BURST
    assert [data for data in routed if data in low] == low
    assert [data for data in routed if data not in low] == urgent


@pytest.mark.slow
async def test_flood_does_not_starve_safety_critical_packets(root: Path, introduce, udp) -> None:
    """While a peer sends low-priority packets as fast as it can, another one's emergency stop arrives every time."""
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as node:
        component = introduce(HERE)
        flooder, operator = udp(), udp()
        low = judp.pack(Packet(JausID(43, 1, 1), HERE, bytes(200), 1, Priority.LOW))
        where = ("127.0.0.1", node.port)
        for number in range(30):
            for _ in range(600):
                flooder.sendto(low, where)
            urgent = packet(number, Priority.SAFETY_CRITICAL)
            operator.sendto(urgent, where)
            async with asyncio.timeout(20):
                while await asyncio.get_running_loop().sock_recv(component, 70000) != urgent:
                    pass


async def test_authenticated_networks_communicate_only_with_each_other(
    root: Path, introduce, free_port: int, tmp_path: Path, udp
) -> None:
    key = tmp_path / "key"
    key.write_bytes(b"a key of more than sixteen bytes\n")
    key.chmod(0o600)
    folders = [root / name for name in ("a", "b")]
    near, far = (
        NodeConfig(address=f"127.0.0.{n}", port=free_port, local_root=folder, key_file=key)
        for n, folder in enumerate(folders, 1)
    )
    async with NodeManager(near) as first, NodeManager(far) as second:
        if first.counters["multicast.not_joined"] or second.counters["multicast.not_joined"]:
            pytest.skip("this kernel does not multicast on its loopback interface")
        here, there = introduce(HERE, folders[0]), introduce(FAR, folders[1])
        assert [await receive(sock) for sock in (here, there)] == [junior.accept(HERE), junior.accept(FAR)]
        asking = judp.pack(Packet(HERE, FAR, b"\x02\x20", 1))
        here.sendto(asking, str(first.path))
        assert judp.unpack(await receive(there))[0].payload == b"\x02\x20"
        answer = judp.pack(Packet(FAR, HERE, b"\x02\x40", 1))
        there.sendto(answer, str(second.path))
        assert await receive(here) == answer
        stranger = udp()
        stranger.sendto(judp.pack(Packet(JausID(43, 1, 1), HERE, b"\x02\x20")), ("127.0.0.1", free_port))
        there.sendto(answer, str(second.path))
        assert await receive(here) == answer
        assert first.counters["dropped.auth.unauthenticated"] == 1


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70000)


async def test_large_datagrams_are_bounded_by_their_bytes(counters: Counters, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ingress, "MAX_QUEUED_BYTES", 600_000)
    large = [judp.pack(Packet(FAR, HERE, bytes(60_000), number)) for number in range(20)]
    small = [packet(number, Priority.LOW) for number in range(20)]
    routed = await run(Socket(*small, *large), counters)
    assert routed == large[-9:]  # the small ones are of lower priority
    assert counters["dropped.overload"] == 31


async def test_a_host_that_floods_displaces_its_own_packets(counters: Counters) -> None:
    """Also those that were read already, as after a burst into a large receive buffer."""
    routed: list[bytes] = []
    reader = Ingress(lambda data, _: routed.append(data), counters)

    class Two(Socket):
        def recvfrom(self, _: int) -> tuple[bytes, tuple[str, int]]:
            datagram = super().recvfrom(_)[0]
            return datagram, ("10.0.0.1" if datagram in honest else "10.0.0.66", 3794)

    honest = {packet(40_000 + number, Priority.STANDARD) for number in range(100)}
    flood = [packet(n, Priority.STANDARD) for n in range(3 * ingress.MAX_QUEUED)]
    source = Two(*flood[:200], *honest, *flood)
    ages = DatagramReader(source, counters)  # type: ignore[arg-type]
    while source.datagrams:
        reader._wake(ages, "lan", {}, lambda error: None)
    while len(reader):
        reader._route()
    assert counters["dropped.overload"]
    assert honest <= {*routed}


async def test_the_kernel_drops_packets_of_the_host_that_floods(udp, counters: Counters) -> None:
    receiver, sender = udp(), udp()
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
    reader, ages = Ingress(lambda data, _: None, counters), DatagramReader(receiver, counters)
    where, port = receiver.getsockname()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        try:
            other.bind(("127.0.0.2", 0))
        except OSError:
            pytest.skip("the loopback interface has one address only")
        while not counters["kernel_filter.attached"]:
            for _ in range(ingress.READ_BURST):
                sender.sendto(packet(1, Priority.STANDARD), (where, port))
            reader._wake(ages, "lan", {}, lambda error: None)
        for number in range(3):
            sender.sendto(packet(1, Priority.STANDARD), (where, port))
            other.sendto(packet(2 + number, Priority.LOW), (where, port))
        assert [receiver.recv(100) for _ in range(3)] == [packet(2 + number, Priority.LOW) for number in range(3)]
        with pytest.raises(BlockingIOError):
            receiver.recv(100)
