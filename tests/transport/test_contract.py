"""One suite over every transport."""

import asyncio
import os
import pty
import tty
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from jauspy.errors import TransportError
from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.node.config import SerialConfig
from jauspy.protocol import judp
from jauspy.protocol.header import MAX_PAYLOAD, Broadcast, Packet
from jauspy.transport import (
    LocalTransport,
    LoopbackHub,
    LoopbackTransport,
    SerialLine,
    SerialTransport,
    TcpTransport,
    Transport,
    UdpTransport,
)

A, B, C = (JausID.parse(text) for text in ("101.1.1", "101.1.2", "101.1.3"))

Make = Callable[[JausID], Transport]


class Wire:
    """Carries bytes from one file to another, at the pace of the slower one."""

    def __init__(self, source: int, sink: int) -> None:
        self._source, self._sink, self._bytes = source, sink, b""
        self._loop = asyncio.get_running_loop()
        self._loop.add_reader(source, self._read)

    def _read(self) -> None:
        self._bytes = os.read(self._source, 1000)
        self._loop.remove_reader(self._source)
        self._loop.add_writer(self._sink, self._write)

    def _write(self) -> None:
        self._bytes = self._bytes[os.write(self._sink, self._bytes) :]
        if not self._bytes:
            self._loop.remove_writer(self._sink)
            self._loop.add_reader(self._source, self._read)

    def close(self) -> None:
        self._loop.remove_reader(self._source)
        self._loop.remove_writer(self._sink)


@contextmanager
def null_modem() -> Iterator[tuple[str, str]]:
    """Two serial devices whose ends are wired to each other: two pseudo terminals, with bytes carried between them."""
    (a, device_a), (b, device_b) = pty.openpty(), pty.openpty()
    for end in (a, b, device_a, device_b):
        tty.setraw(end)
        os.set_blocking(end, False)
    wires = (Wire(a, b), Wire(b, a))
    yield os.ttyname(device_a), os.ttyname(device_b)
    for wire in wires:
        wire.close()
    for end in (a, b, device_a, device_b):
        os.close(end)


@pytest.fixture(params=["local", "udp", "tcp", "serial", "loopback"])
async def make(request: pytest.FixtureRequest, root: Path) -> AsyncIterator[Make]:
    """Makes transports that reach each other; by UDP, TCP and serial line, A reaches those behind a node manager."""
    if request.param == "loopback":
        hub = LoopbackHub()
        yield lambda own: LoopbackTransport(own, hub)
        return
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=request.param == "tcp", tcp_port=0)
    if request.param == "serial":
        with null_modem() as (ours, theirs):
            line = SerialConfig(device=theirs, baud_rate=115200)
            async with NodeManager(config.model_copy(update={"serial": (line,)})):
                yield lambda own: SerialTransport(own, SerialLine(ours)) if own == A else LocalTransport(own, root)
        return
    async with NodeManager(config) as manager:
        if request.param == "local":
            yield lambda own: LocalTransport(own, root)
        elif request.param == "tcp":
            assert manager.tcp_port is not None
            there = ("127.0.0.1", manager.tcp_port)
            yield lambda own: TcpTransport(own, there) if own == A else LocalTransport(own, root)
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
        async with asyncio.timeout(20):
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
    assert (a.transport.counters["sent"], a.transport.counters["received"], a.transport.waiting) == (1, 1, 0)
    await closed(a, b)


async def test_largest_packet_is_delivered(make: Make) -> None:
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


async def test_malformed_datagrams_are_dropped(make: Make) -> None:
    a, b = await opened(make, A, B)
    for datagram in (b"", b"\x02", b"garbage" * 10, bytes(70000)):
        a.transport.send(datagram)
    packet = Packet(A, B, b"\x02\x20", 1)
    a.transport.send(judp.pack(packet))
    assert await b.next() == packet
    await closed(a, b)


@pytest.mark.parametrize("make", ["local", "loopback"], indirect=True)
async def test_id_in_use_is_an_error(make: Make) -> None:
    (a,) = await opened(make, A)
    with pytest.raises(TransportError, match=r"101\.1\.1"):
        await make(A).open()
    packet = Packet(A, A, b"\x00\x00", 1)
    a.transport.send(judp.pack(packet))
    assert await a.next() == packet
    await closed(a)
