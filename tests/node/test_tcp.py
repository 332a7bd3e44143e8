"""JTCP of the running node manager: bytes of other implementations, several ids on a connection, faults, reconnects."""

import asyncio
import logging
import socket
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import pytest

from jauspy.errors import TransportError
from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager, links
from jauspy.protocol import judp
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Broadcast, Packet
from jauspy.testing import until
from jauspy.transport import LocalTransport, TcpTransport, tcp as stream

HERE, FAR, OTHER = JausID.parse("100.1.2"), JausID.parse("200.1.1"), JausID.parse("200.1.2")


class Inbox(asyncio.Queue[bytes]):
    """A component of the node manager; what it receives is waited for by `next`."""

    def __init__(self, transport: LocalTransport | TcpTransport) -> None:
        super().__init__()
        self.transport = transport
        transport.received = self.put_nowait

    async def next(self) -> bytes:
        async with asyncio.timeout(20):
            return await self.get()


class Stream:
    """A peer as bytes."""

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self.reader, self.writer = reader, writer

    def send(self, text: str) -> None:
        self.writer.write(bytes.fromhex(text))

    async def receive(self, count: int) -> str:
        async with asyncio.timeout(20):
            return (await self.reader.readexactly(count)).hex()

    async def ended(self) -> bool:
        async with asyncio.timeout(20):
            try:
                return await self.reader.read() is not None
            except ConnectionError:
                return True


@pytest.fixture
async def node(root: Path) -> AsyncIterator[NodeManager]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=True, tcp_port=0)) as manager:
        yield manager


@pytest.fixture
async def here(node: NodeManager, root: Path) -> AsyncIterator[Inbox]:
    inbox = Inbox(LocalTransport(HERE, root))
    await inbox.transport.open()
    yield inbox
    await inbox.transport.close()


@asynccontextmanager
async def peer(node: NodeManager) -> AsyncIterator[Stream]:
    reader, writer = await asyncio.open_connection("127.0.0.1", node.tcp_port)
    yield Stream(reader, writer)
    writer.close()


async def test_streams_of_another_implementation_are_understood(node: NodeManager, here: Inbox) -> None:
    async with peer(node) as far:
        far.send("02001000010201640001 01c80011120100")
        assert (await here.next()).hex() == "0200100001020164000101c80011120100"
        far.send("0011000102016400 0101c800 212223 0200")
        assert (await here.next()).hex() == "0200110001020164000101c8002122230200"
        here.transport.send(bytes.fromhex("02000f00010101c80002016400310500"))
        here.transport.send(bytes.fromhex("02000f00010101c80002016400320600"))
        assert await far.receive(16) == "02000f00010101c80002016400310500"
        assert await far.receive(15) == "000f00010101c80002016400320600"


async def test_connection_may_serve_several_ids_and_broadcasts(node: NodeManager, here: Inbox) -> None:
    async with peer(node) as far:
        far.send("02")
        for number, id in enumerate((FAR, OTHER)):
            far.writer.write(judp.pack(Packet(id, HERE, b"\x02\x20", number))[1:])
            await here.next()
        greeting = "02"
        for message in (
            Packet(HERE, FAR, b"\x02\x20", 1),
            Packet(HERE, OTHER, b"\x02\x20", 2),
            Packet(HERE, EVERYONE, b"\x00\x2b", 3, broadcast=Broadcast.GLOBAL),
        ):
            data = judp.pack(message)
            here.transport.send(data)
            assert await far.receive(len(data) - (not greeting)) == greeting + data[1:].hex()
            greeting = ""


async def test_unknown_destination_is_probed_on_connections(node: NodeManager, here: Inbox) -> None:
    async with peer(node) as far:
        await until(lambda: node.counters["tcp.accepted"] == 1)
        here.transport.send(judp.pack(Packet(HERE, FAR, b"\x02\x20", 1)))
        assert await far.receive(17) == "02001000110101c800020164000220" + "0100"


@pytest.mark.parametrize("compression", ["", "0000"], ids=["as Junior", "as FKIE's"])
async def test_version_1_is_answered_in_the_same_form(node: NodeManager, here: Inbox, compression: str) -> None:
    async with peer(node) as far:
        far.send(f"01 {compression} 0012 06023412 02016400 0101c800 0200 0700 aabb")
        assert await here.next() == bytes.fromhex("010000 0012 06023412 02016400 0101c800 0200 0700 aabb")
        here.transport.send(judp.pack(Packet(HERE, FAR, b"\x02\x20", 1)))
        here.transport.send(bytes.fromhex("010000 0012 06023412 0101c800 02016400 0200 0800 ccdd"))
        expected = bytes.fromhex(f"01 {compression} 0012 06023412 0101c800 02016400 0200 0800 ccdd")
        assert await far.receive(len(expected)) == expected.hex()
        assert node.counters["dropped.tcp_version"] == 1


@pytest.mark.parametrize(
    "rubbish", ["03000010", "01001006 01", "02 02 001000", "02000500", "02c0ffff", "02ff"], ids=str
)
async def test_desynchronised_stream_is_closed_without_affecting_others(
    node: NodeManager, here: Inbox, rubbish: str
) -> None:
    async with peer(node) as good, peer(node) as bad:
        bad.send(rubbish + "00" * 20)
        assert await bad.ended()
        good.send("0200100001020164000101c80011120100")
        await here.next()
    malformed = [name for name in node.counters if name.startswith("dropped.malformed.stream")]
    assert len(malformed) == 1


async def test_ids_of_a_closed_connection_are_probed_again(node: NodeManager, here: Inbox) -> None:
    async with peer(node) as far:
        far.send("0200100001020164000101c80011120100")
        await here.next()
    await until(lambda: node.counters["tcp.closed"] == 1)
    here.transport.send(judp.pack(Packet(HERE, FAR, b"\x02\x20", 1)))
    await until(lambda: node.counters["routed.multicast"] == 1)
    async with peer(node) as far:
        far.send("0200100001020164000101c80011120100")
        await here.next()
        here.transport.send(judp.pack(Packet(HERE, FAR, b"\x02\x20", 2)))
        await far.receive(17)


async def test_peer_that_does_not_read_delays_no_other_and_gets_whole_packets(node: NodeManager, here: Inbox) -> None:
    async with peer(node) as slow, peer(node) as good:
        for stream, id in ((slow, FAR), (good, OTHER)):
            stream.writer.write(judp.pack(Packet(id, HERE, b"\x02\x20")))
            await here.next()
        slow.writer.transport.pause_reading()
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as flood:
            flood.setblocking(False)
            flood.connect(str(node.path))
            for number in range(0x10000):
                while True:
                    try:
                        flood.send(judp.pack(Packet(HERE, FAR, bytes(4000), number)))
                        break
                    except BlockingIOError:
                        await asyncio.sleep(0)
                if node.counters["dropped.queue_full"]:
                    break
        here.transport.send(judp.pack(Packet(HERE, OTHER, b"\x02\x20", 7)))
        assert (await good.receive(17)).endswith("0700")
        slow.writer.transport.resume_reading()
        assert await slow.receive(1) == "02"
        numbers = []
        for _ in range(300):
            packet = bytes.fromhex("02" + await slow.receive(4014))
            numbers.append(judp.unpack(packet)[0].sequence)
        assert numbers == sorted(numbers)


async def test_ipv6_both_ways(root: Path, free_port: int) -> None:
    try:
        with socket.create_server(("::1", 0), family=socket.AF_INET6):
            pass
    except OSError:
        pytest.skip("this system has no IPv6")
    near = NodeConfig(address="127.0.0.1", port=free_port, local_root=root / "a", address6="::1", tcp=True)
    book = {str(HERE): f"tcp://[::1]:{free_port}"}
    far = NodeConfig(address="127.0.0.1", port=0, local_root=root / "b", addresses=book)
    async with NodeManager(near) as first, NodeManager(far) as second:
        a, b = Inbox(LocalTransport(HERE, root / "a")), Inbox(LocalTransport(FAR, root / "b"))
        await a.transport.open()
        await b.transport.open()
        await until(lambda: second.counters["tcp.connected"] == 1)
        there = judp.pack(Packet(FAR, HERE, b"\x02\x20", 1))
        b.transport.send(there)
        assert await a.next() == there
        back = judp.pack(Packet(HERE, FAR, b"\x02\x40", 1))
        a.transport.send(back)
        assert await b.next() == back
        (peer,) = (each["address"] for each in first.state.as_dict(0.0)["peers"])
        assert peer.startswith("[::1]:")
        await a.transport.close()
        await b.transport.close()


SPEAKS = "02 001000 01 02016400 0101c800 1112 0100"


async def test_connections_are_bounded(node: NodeManager, here: Inbox, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(links, "MAX_CONNECTIONS", 1)
    async with peer(node) as first:
        first.send(SPEAKS)
        await here.next()
        async with peer(node) as second:
            assert await second.ended()
    assert node.counters["tcp.refused"] == 1


async def test_silent_connection_is_replaced_by_a_new_one(
    node: NodeManager, here: Inbox, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(links, "MAX_CONNECTIONS", 2)
    async with peer(node) as silent:
        silent.send(SPEAKS[:-2])
        await until(lambda: node.counters["tcp.accepted"] == 1)
        async with peer(node) as one, peer(node) as other:
            assert await silent.ended()
            for each in (one, other):
                each.send(SPEAKS)
                await here.next()
    assert (node.counters["tcp.refused"], node.counters["tcp.accepted"]) == (1, 3)


@pytest.mark.slow
async def test_flood_on_a_connection_delays_no_other(node: NodeManager, here: Inbox) -> None:
    """Between any two turns of the event loop only so much is read of each."""
    seen = []
    async with peer(node) as first, peer(node) as second:
        for each in (first, second):
            each.writer.write(bytes.fromhex(SPEAKS)[:1] + bytes.fromhex(SPEAKS)[1:] * 20_000)
        for _ in range(100):
            before = node.counters["received.tcp"]
            await asyncio.sleep(0)
            seen.append(node.counters["received.tcp"] - before)
    assert 0 < max(seen) <= 2 * (stream.READ_SIZE // 16 + 1)


async def test_address_book_peers_are_connected_and_reconnected(root: Path, free_port: int) -> None:
    book = {str(FAR): f"tcp://127.0.0.1:{free_port}"}
    near = NodeConfig(address="127.0.0.1", port=0, local_root=root / "near", addresses=book)
    far = NodeConfig(address="127.0.0.1", port=0, local_root=root / "far", tcp=True, tcp_port=free_port)
    async with NodeManager(near) as ours:
        a = Inbox(LocalTransport(HERE, root / "near"))
        await a.transport.open()
        a.transport.send(judp.pack(Packet(HERE, FAR, b"\x02\x20", 1)))
        await until(lambda: ours.counters["dropped.tcp_unconnected"] == 1)
        for life in range(2):
            async with NodeManager(far):
                b = Inbox(LocalTransport(FAR, root / "far"))
                await b.transport.open()
                await until(lambda wanted=life + 1: ours.counters["tcp.connected"] == wanted)
                there = judp.pack(Packet(HERE, FAR, b"\x02\x20", 2))
                a.transport.send(there)
                assert await b.next() == there
                back = judp.pack(Packet(FAR, HERE, b"\x02\x40", 3))
                b.transport.send(back)
                assert await a.next() == back
                await b.transport.close()
        await a.transport.close()


async def test_reconnect_pauses_grow_and_reset_after_a_connection(
    free_port: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    pauses: list[float] = []
    sleep = asyncio.sleep

    async def noted(seconds: float) -> None:
        pauses.append(seconds)
        await sleep(0.001)

    monkeypatch.setattr(asyncio, "sleep", noted)
    dialer = stream.Dialer(("127.0.0.1", free_port), Counters(logging.getLogger()), lambda link, datagram: None)
    async with asyncio.timeout(20):
        while len(pauses) < 10:
            await sleep(0.001)
        assert pauses[:10] == [0.1, 0.2, 0.4, 0.8, 1.6, 2.0, 2.0, 2.0, 2.0, 2.0]
        with socket.create_server(("127.0.0.1", free_port)):
            await dialer.connected.wait()
            pauses.clear()
        while not pauses:
            await sleep(0.001)
    assert pauses[0] == stream.MIN_RETRY_INTERVAL
    await dialer.close()


async def test_component_reconnects(root: Path, free_port: int) -> None:
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=True, tcp_port=free_port)
    ocu = Inbox(TcpTransport(FAR, ("127.0.0.1", free_port)))
    async with NodeManager(config):
        await ocu.transport.open()
    await until(lambda: not ocu.transport.connected)
    ocu.transport.send(judp.pack(Packet(FAR, FAR, b"\0\0")))
    assert ocu.transport.counters["dropped.tcp_unconnected"] == 1
    async with NodeManager(config) as node:
        await until(lambda: ocu.transport.connected)
        ocu.transport.send(judp.pack(Packet(FAR, HERE, b"\0\0")))
        await until(lambda: node.counters["received.tcp"] == 1)
    await ocu.transport.close()


async def test_missing_peer_and_port_in_use_errors_say_what_to_do(root: Path, free_port: int) -> None:
    with pytest.raises(TransportError, match="with `tcp = true`"):
        await TcpTransport(FAR, ("127.0.0.1", free_port), timeout=0.2).open()
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        manager = NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=True, tcp_port=port))
        with pytest.raises(TransportError, match="choose another tcp_port"):
            await manager.open()
    assert list(root.iterdir()) == []
