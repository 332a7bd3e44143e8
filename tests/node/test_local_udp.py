"""Components that speak UDP with their node manager, as those of ROS/IOP do."""

import asyncio
import socket
from collections.abc import AsyncIterator, Iterator
from pathlib import Path

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Broadcast, Packet
from jauspy.transport import LocalTransport

A, B, HERE = JausID.parse("100.0.1"), JausID.parse("100.1.2"), JausID.parse("100.1.3")


class UdpComponent:
    """A UDP socket on an ephemeral port."""

    def __init__(self, node: NodeManager) -> None:
        self._node = ("127.0.0.1", node.port)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.setblocking(False)

    def send(self, data: bytes) -> None:
        self.socket.sendto(data, self._node)

    async def receive(self) -> bytes:
        async with asyncio.timeout(20):
            return await asyncio.get_running_loop().sock_recv(self.socket, 70000)

    async def connect(self, id: JausID) -> None:
        self.send(junior.connect(id))
        assert await self.receive() == junior.accept(id)


@pytest.fixture
async def node(root: Path) -> AsyncIterator[NodeManager]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as manager:
        yield manager


@pytest.fixture
def pair(node: NodeManager) -> Iterator[tuple[UdpComponent, UdpComponent]]:
    made = UdpComponent(node), UdpComponent(node)
    yield made
    for each in made:
        each.socket.close()


async def test_connect_and_accept_have_the_captured_bytes(pair: tuple[UdpComponent, UdpComponent]) -> None:
    for _ in range(2):
        pair[0].send(bytes.fromhex("010000001006020100000000000100640000000000"))
        assert (await pair[0].receive()).hex() == "010000001006020200010064000000000000000000"


async def test_unicast_arrives_once_and_broadcasts_are_copied(
    node: NodeManager, pair: tuple[UdpComponent, UdpComponent], root: Path
) -> None:
    a, b = pair
    await a.connect(A)
    await b.connect(B)
    unix = LocalTransport(HERE, root)
    arrived: asyncio.Queue[bytes] = asyncio.Queue()
    unix.received = arrived.put_nowait
    await unix.open()
    for data in (
        judp.pack(Packet(A, B, b"\x02\x20", 1)),
        judp.pack(Packet(A, EVERYONE, b"\x00\x2b", 2, broadcast=Broadcast.LOCAL)),
        judp.pack(Packet(A, B, b"\x05\x20", 3)),
    ):
        a.send(data)
        assert await b.receive() == data
    assert judp.unpack(await arrived.get())[0].sequence == 2
    back = judp.pack(Packet(HERE, A, b"\x02\x40", 1))
    unix.send(back)
    assert await a.receive() == back
    assert {A, B, HERE} == set(node.components)
    await unix.close()


async def test_after_cancel_it_gets_no_more_broadcasts(
    node: NodeManager, pair: tuple[UdpComponent, UdpComponent]
) -> None:
    a, b = pair
    await a.connect(A)
    await b.connect(B)
    b.send(junior.cancel(B))
    a.send(judp.pack(Packet(A, EVERYONE, b"\x00\x2b", 1, broadcast=Broadcast.LOCAL)))
    a.send(judp.pack(Packet(A, A, b"\x00\x00", 2)))
    await a.receive()
    assert node.components == (A,)
    with pytest.raises(BlockingIOError):
        b.socket.recv(100)


async def test_dead_component_is_removed_without_loss_for_others(
    node: NodeManager, pair: tuple[UdpComponent, UdpComponent]
) -> None:
    a, b = pair
    await a.connect(A)
    await b.connect(B)
    b.socket.close()
    for number in range(50):
        a.send(judp.pack(Packet(A, EVERYONE, b"\x00\x2b", number, broadcast=Broadcast.LOCAL)))
        own = judp.pack(Packet(A, A, b"\x00\x00", number))
        a.send(own)
        assert await a.receive() == own
    assert node.components == (A,)
    assert node.counters["components.lost"] == 1


async def test_restarted_component_on_another_port_regains_its_id(
    node: NodeManager, pair: tuple[UdpComponent, UdpComponent]
) -> None:
    a, b = pair
    await a.connect(A)
    await b.connect(A)
    own = judp.pack(Packet(A, A, b"\x00\x00", 1))
    b.send(own)
    assert await b.receive() == own
    a.send(own)
    b.send(own)
    assert await b.receive() == own
    assert node.counters["dropped.hijack"] == 1


async def test_local_udp_can_be_disabled(root: Path) -> None:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root, local_udp=False)) as node:
        component = UdpComponent(node)
        component.send(junior.connect(A))
        async with asyncio.timeout(20):
            while not node.counters["dropped.connect_from_network"]:
                await asyncio.sleep(0.002)
        component.socket.close()
    assert node.components == ()
