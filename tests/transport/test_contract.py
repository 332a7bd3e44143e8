"""One suite over every transport."""

import asyncio
from collections.abc import AsyncIterator, Callable
from pathlib import Path

import pytest

from jauspy.errors import TransportError
from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp
from jauspy.protocol.header import MAX_PAYLOAD, Broadcast, Packet
from jauspy.transport import LocalTransport, LoopbackHub, LoopbackTransport, Transport, UdpTransport

A, B, C = (JausID.parse(text) for text in ("101.1.1", "101.1.2", "101.1.3"))

Make = Callable[[JausID], Transport]


@pytest.fixture(params=["local", "udp", "loopback"])
async def make(request: pytest.FixtureRequest, root: Path) -> AsyncIterator[Make]:
    """Makes transports that reach each other; the UDP one reaches components behind a node manager."""
    if request.param == "loopback":
        hub = LoopbackHub()
        yield lambda own: LoopbackTransport(own, hub)
        return
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as manager:
        if request.param == "local":
            yield lambda own: LocalTransport(own, root)
        else:
            peer = ("127.0.0.1", manager.port)
            yield lambda own: UdpTransport(own, peer=peer) if own == A else LocalTransport(own, root)


class Inbox:
    """Collects what a transport receives."""

    def __init__(self, transport: Transport) -> None:
        self._queue: asyncio.Queue[bytes] = asyncio.Queue()
        self.transport = transport
        transport.received = self._queue.put_nowait

    async def next(self) -> Packet:
        """The next packet; fails the test when none comes."""
        async with asyncio.timeout(5):
            (packet,) = judp.unpack(await self._queue.get())
            return packet


async def opened(make: Make, *ids: JausID) -> list[Inbox]:
    inboxes = [Inbox(make(id)) for id in ids]
    for inbox in inboxes:
        await inbox.transport.open()
    return inboxes


async def closed(*inboxes: Inbox) -> None:
    for inbox in inboxes:
        await inbox.transport.close()
        await inbox.transport.close()


async def test_datagrams_arrive_unchanged_both_ways(make: Make) -> None:
    a, b = await opened(make, A, B)
    there = Packet(A, B, bytes(range(256)), 7)
    a.transport.send(judp.pack(there))
    assert await b.next() == there
    back = Packet(B, A, b"\x02\x40", 8)
    b.transport.send(judp.pack(back))
    assert await a.next() == back
    assert (a.transport.counters["sent"], a.transport.counters["received"]) == (1, 1)
    await closed(a, b)


async def test_the_largest_packet_passes(make: Make) -> None:
    a, b = await opened(make, A, B)
    packet = Packet(A, B, bytes(MAX_PAYLOAD), 1)
    a.transport.send(judp.pack(packet))
    assert await b.next() == packet
    await closed(a, b)


async def test_a_broadcast_reaches_the_others_only(make: Make) -> None:
    a, b, c = await opened(make, A, B, C)
    everybody = Packet(A, EVERYONE, b"\x00\x2b\x04", 1, broadcast=Broadcast.GLOBAL)
    a.transport.send(judp.pack(everybody))
    assert await b.next() == everybody
    assert await c.next() == everybody
    only = Packet(B, A, b"\x00\x4b", 2)
    b.transport.send(judp.pack(only))
    assert await a.next() == only
    await closed(a, b, c)


async def test_order_is_kept(make: Make) -> None:
    a, b = await opened(make, A, B)
    for number in range(100):
        a.transport.send(judp.pack(Packet(A, B, b"\x02\x20", number)))
    received = [(await b.next()).sequence for _ in range(100)]
    assert received == sorted(received)
    await closed(a, b)


async def test_connected_between_open_and_close(make: Make) -> None:
    (a,) = await opened(make, A)
    assert a.transport.connected
    await closed(a)
    assert not a.transport.connected
    a.transport.send(judp.pack(Packet(A, B, b"\x02\x20")))
    assert a.transport.counters["received"] == 0


async def test_opens_again_after_close(make: Make) -> None:
    a, b = await opened(make, A, B)
    await closed(a)
    await a.transport.open()
    packet = Packet(B, A, b"\x02\x20", 3)
    a.transport.send(judp.pack(Packet(A, B, b"\x02\x20", 1)))
    await b.next()
    b.transport.send(judp.pack(packet))
    assert await a.next() == packet
    await closed(a, b)


async def test_nonsense_is_dropped(make: Make) -> None:
    a, b = await opened(make, A, B)
    for datagram in (b"", b"\x02", b"garbage" * 10, bytes(70000)):
        a.transport.send(datagram)
    packet = Packet(A, B, b"\x02\x20", 1)
    a.transport.send(judp.pack(packet))
    assert await b.next() == packet
    await closed(a, b)


@pytest.mark.parametrize("make", ["local", "loopback"], indirect=True)
async def test_an_id_is_taken_once(make: Make) -> None:
    (a,) = await opened(make, A)
    with pytest.raises(TransportError, match=r"101\.1\.1"):
        await make(A).open()
    packet = Packet(A, A, b"\x00\x00", 1)
    a.transport.send(judp.pack(packet))
    assert await a.next() == packet
    await closed(a)
