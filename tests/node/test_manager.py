"""The running node manager: examples from the wire, garbage, slow and dead components, restarts, two on one host."""

import asyncio
import os
import random
import socket
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from jauspy.errors import ConfigError, TransportError
from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Broadcast, Packet

MANAGEMENT, OCU = JausID.parse("126.1.11"), JausID.parse("126.1.20")


class RawComponent:
    """A component as bytes: a Unix datagram socket that sends and expects hex."""

    def __init__(self, root: Path, id: JausID) -> None:
        self.id = id
        self._node = str(root / junior.SOCKET_NAME)
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.socket.bind(str(root / str(int(id))))
        self.socket.setblocking(False)

    def send(self, data: bytes) -> None:
        self.socket.sendto(data, self._node)

    async def send_patiently(self, data: bytes) -> None:
        """Send as soon as the node manager's queue has room."""
        while True:
            try:
                return self.send(data)
            except BlockingIOError:
                await asyncio.sleep(0)

    async def receive(self) -> bytes:
        async with asyncio.timeout(20):
            return await asyncio.get_running_loop().sock_recv(self.socket, 70000)


@pytest.fixture
async def node(root: Path) -> AsyncIterator[NodeManager]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as manager:
        yield manager


@pytest.fixture
def component(root: Path) -> Iterator[Callable[[JausID], RawComponent]]:
    with ExitStack() as stack:

        def make(id: JausID) -> RawComponent:
            raw = RawComponent(root, id)
            stack.enter_context(raw.socket)
            return raw

        yield make


@pytest.fixture
def remote() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind(("127.0.0.1", 0))
        sock.setblocking(False)
        yield sock


Make = Callable[[JausID], RawComponent]


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70000)


async def test_answers_use_the_learned_udp_port(node: NodeManager, component: Make, remote: socket.socket) -> None:
    local = component(MANAGEMENT)
    local.send(junior.connect(MANAGEMENT))
    await local.receive()
    far = JausID.parse("42.1.1")
    query = judp.pack(Packet(far, MANAGEMENT, b"\x02\x20", 5))
    remote.sendto(query, ("127.0.0.1", node.port))
    assert await local.receive() == query
    report = judp.pack(Packet(MANAGEMENT, far, bytes.fromhex("02400200000000"), 1))
    local.send(report)
    assert await receive(remote) == report


def rubbish(seed: int) -> Iterator[bytes]:
    """Random bytes, real packets cut short or with a byte changed, and the largest datagrams there are."""
    chance = random.Random(seed)
    real = judp.pack(Packet(OCU, MANAGEMENT, bytes.fromhex("0d00c8"), 1))
    for _ in range(300):
        yield chance.randbytes(chance.randrange(200))
        yield real[: chance.randrange(len(real))]
        broken = bytearray(real)
        broken[chance.randrange(4)] ^= 1 << chance.randrange(8)
        yield bytes(broken)
    for first in (b"\0", b"\1", b"\2", b"\2\0\xff\xff"):
        yield first + chance.randbytes(65507 - len(first))


async def test_garbage_affects_no_component(node: NodeManager, component: Make, remote: socket.socket) -> None:
    a, b = component(MANAGEMENT), component(OCU)
    for who in (a, b):
        who.send(junior.connect(who.id))
        await who.receive()
    sent = 0
    for number, garbage in enumerate(rubbish(1)):
        if number % 2:
            remote.sendto(garbage, ("127.0.0.1", node.port))
        else:
            await a.send_patiently(garbage)
        if number % 10 == 0:
            valid = judp.pack(Packet(MANAGEMENT, OCU, b"\x02\x20" + number.to_bytes(2, "little"), number))
            await a.send_patiently(valid)
            sent += 1
            while (arrived := await b.receive()) != valid:
                assert judp.unpack(arrived)[0].payload[:2] == b"\x0d\x00"
    malformed = {name: count for name, count in node.counters.items() if name.startswith("dropped.malformed")}
    assert {"dropped.malformed.version", "dropped.malformed.truncated"} <= set(malformed)
    assert sum(malformed.values()) > 800
    assert sent > 90


async def test_component_that_does_not_read_delays_no_other(node: NodeManager, component: Make) -> None:
    a, b, stalled = component(MANAGEMENT), component(OCU), component(JausID.parse("126.1.30"))
    for who in (a, b, stalled):
        who.send(junior.connect(who.id))
        await who.receive()
    for number in range(1000):
        await a.send_patiently(judp.pack(Packet(a.id, stalled.id, b"\x02\x20", number)))
    for number in range(200):
        there = judp.pack(Packet(a.id, b.id, b"\x02\x20", number))
        await a.send_patiently(there)
        assert await b.receive() == there
    assert node.counters["dropped.queue_full"] > 0
    kept = 1000 - node.counters["dropped.queue_full"]
    numbers = [judp.unpack(await stalled.receive())[0].sequence for _ in range(kept)]
    assert numbers == sorted(numbers)
    assert numbers[-1] == 999


async def test_dead_component_is_removed_and_can_return(root: Path, node: NodeManager, component: Make) -> None:
    a, b = component(MANAGEMENT), component(OCU)
    for who in (a, b):
        who.send(junior.connect(who.id))
        await who.receive()
    b.socket.close()
    a.send(judp.pack(Packet(a.id, EVERYONE, b"\x02\x20", broadcast=Broadcast.LOCAL)))
    a.send(judp.pack(Packet(a.id, a.id, b"\0\0")))
    await a.receive()
    assert node.components == (MANAGEMENT,)
    assert not (root / str(int(OCU))).exists()
    again = component(OCU)
    again.send(judp.pack(Packet(OCU, MANAGEMENT, b"\x02\x20")))
    await a.receive()
    assert node.components == (MANAGEMENT, OCU)


async def test_two_node_managers_on_two_loopback_addresses_find_each_other(
    root: Path, free_port: int, component: Make
) -> None:
    near = NodeConfig(address="127.0.0.1", port=free_port, local_root=root / "a")
    far = NodeConfig(address="127.0.0.2", port=free_port, local_root=root / "b")
    async with NodeManager(near) as first, NodeManager(far) as second:
        if first.counters["multicast.not_joined"] or second.counters["multicast.not_joined"]:
            pytest.skip("this kernel does not multicast on its loopback interface")
        with RawComponent(root / "a", MANAGEMENT).socket as a, RawComponent(root / "b", OCU).socket as b:
            for sock, id, folder in ((a, MANAGEMENT, "a"), (b, OCU, "b")):
                sock.sendto(junior.connect(id), str(root / folder / junior.SOCKET_NAME))
                await receive(sock)
            everybody = judp.pack(Packet(MANAGEMENT, EVERYONE, b"\x00\x2b\x04", 1, broadcast=Broadcast.GLOBAL))
            a.sendto(everybody, str(root / "a" / junior.SOCKET_NAME))
            assert await receive(b) == everybody
            answer = judp.pack(Packet(OCU, MANAGEMENT, b"\x00\x4b", 1))
            b.sendto(answer, str(root / "b" / junior.SOCKET_NAME))
            assert await receive(a) == answer
            again = judp.pack(Packet(MANAGEMENT, OCU, b"\x02\x20", 2))
            a.sendto(again, str(root / "a" / junior.SOCKET_NAME))
            assert await receive(b) == again
        assert second.counters["routed.udp"] == 1
        assert first.counters["routed.multicast"] == 1


async def test_port_in_use_error_names_its_owner(root: Path, free_port: int) -> None:
    first = NodeConfig(address="127.0.0.1", port=free_port, local_root=root / "a")
    async with NodeManager(first):
        second = NodeManager(first.model_copy(update={"local_root": root / "b"}))
        with pytest.raises(TransportError, match=rf"UDP port {free_port} is used by process {os.getpid()} .*--port"):
            await second.open()
        assert list((root / "b").iterdir()) == []


async def test_second_node_manager_in_a_folder_is_an_error(root: Path, node: NodeManager) -> None:
    second = NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))
    with pytest.raises(TransportError, match="a node manager is already running"):
        await second.open()
    assert node.path.is_socket()


async def test_sockets_of_a_dead_node_manager_are_removed(root: Path) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as dead:
        dead.bind(str(root / junior.SOCKET_NAME))
    manager = NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))
    await manager.open()
    await manager.close()
    await manager.close()
    assert list(root.iterdir()) == []


async def test_run_ends_when_it_is_closed(node: NodeManager) -> None:
    running = asyncio.create_task(node.run())
    await node.close()
    async with asyncio.timeout(20):
        await running


def test_foreign_address_is_an_error(root: Path) -> None:
    manager = NodeManager(NodeConfig(address="192.0.2.1", port=0, local_root=root))
    with pytest.raises(TransportError, match=r"192\.0\.2\.1 is not an address of this machine"):
        asyncio.run(manager.open())


@pytest.mark.parametrize(
    ("settings", "reported"),
    [
        ({"port": 70000}, "port = 70000"),
        ({"address": "localhost"}, "write an IPv4 address"),
        ({"multicast_group": "10.0.0.1"}, "multicast address, as in 239.255.0.1"),
        ({"ports": 1}, "ports = 1"),
    ],
)
def test_invalid_settings_cause_one_sentence(settings: dict[str, object], reported: str) -> None:
    with pytest.raises(ConfigError, match="node manager setting") as caught:
        NodeConfig.make(**settings)
    assert reported in str(caught.value)
