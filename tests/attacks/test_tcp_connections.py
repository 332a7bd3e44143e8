"""One host, or a few, open all JTCP connections that a node manager accepts."""

import asyncio
import socket
from collections.abc import AsyncIterator, Callable
from contextlib import ExitStack
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager, links
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet
from jauspy.testing import until

ROBOT, OPERATOR = JausID.parse("101.1.1"), JausID.parse("42.1.1")


@pytest.fixture
async def node(root: Path) -> AsyncIterator[NodeManager]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=True, tcp_port=0)) as manager:
        yield manager


class Host:
    """Opens connections from one address."""

    def __init__(self, node: NodeManager, stack: ExitStack, address: str) -> None:
        self.node = node
        self._stack = stack
        self._address = address

    async def connect(self, source: JausID | None = None) -> socket.socket:
        """A connection; with a source, it sends a packet to the robot."""
        sock = self._stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_STREAM))
        sock.bind((self._address, 0))
        sock.setblocking(False)
        await asyncio.get_running_loop().sock_connect(sock, ("127.0.0.1", self.node.tcp_port))
        if source is not None:
            await asyncio.get_running_loop().sock_sendall(sock, judp.pack(Packet(source, ROBOT, b"\x02\x20", 1)))
        return sock


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 5000)


Hosts = Callable[[str], Host]


@pytest.fixture
def host(node: NodeManager, stack: ExitStack) -> Hosts:
    return lambda address: Host(node, stack, address)


async def settled(node: NodeManager, connections: int) -> None:
    """Wait until the node manager has seen so many connections."""
    await until(lambda: node.counters["tcp.accepted"] + node.counters["tcp.refused"] >= connections)


async def operator_talks(node: NodeManager, host: Host, robot: socket.socket) -> socket.socket:
    sock = await host.connect(OPERATOR)
    source = 0
    while source != int(OPERATOR):
        source = judp.first_header(await receive(robot)).source
    report = judp.pack(Packet(ROBOT, OPERATOR, b"\x02\x40", 1))
    robot.sendto(report, str(node.path))
    arrived = b""
    while len(arrived) < len(report):
        arrived += await receive(sock)
    assert arrived == report
    return sock


@pytest.mark.parametrize("speaks", [True, False])
async def test_one_host_leaves_room_for_the_others(
    node: NodeManager, host: Hosts, introduce: Callable[..., socket.socket], speaks: bool
) -> None:
    robot = introduce(ROBOT)
    assert await receive(robot) == junior.accept(ROBOT)
    attacker, count = host("127.0.0.3"), 2 * links.MAX_CONNECTIONS
    for number in range(count):
        await attacker.connect(JausID(66, 1, 1 + number) if speaks else None)
    await settled(node, count)
    await operator_talks(node, host("127.0.0.2"), robot)
    assert node.counters["tcp.refused"] >= count - links.MAX_CONNECTIONS_PER_HOST


async def test_several_hosts_leave_room_for_the_others(
    node: NodeManager, host: Hosts, introduce: Callable[..., socket.socket]
) -> None:
    robot = introduce(ROBOT)
    await receive(robot)
    share, number = links.MAX_CONNECTIONS_PER_HOST, 0
    for address in range(3, 3 + links.MAX_CONNECTIONS // share):
        for _ in range(share):
            number += 1
            await host(f"127.0.0.{address}").connect(JausID(66, 1, number))
    await settled(node, links.MAX_CONNECTIONS)
    operator = await operator_talks(node, host("127.0.0.2"), robot)
    for again in range(20):
        await host("127.0.0.3").connect(JausID(66, 2, 1 + again))
    await settled(node, links.MAX_CONNECTIONS + 21)
    operator.setblocking(False)
    with pytest.raises(BlockingIOError):
        operator.recv(1)


async def test_idle_connections_are_closed(
    node: NodeManager, host: Hosts, introduce: Callable[..., socket.socket], monkeypatch: pytest.MonkeyPatch
) -> None:
    robot = introduce(ROBOT)
    await receive(robot)
    connections = [await host("127.0.0.3").connect(source) for source in (None, JausID(66, 1, 1))]
    await settled(node, 2)
    monkeypatch.setattr(links, "IDLE_LIMIT", -1.0)
    node._links._tcp._close_idle()  # which a timer calls every ten seconds
    assert [await receive(sock) for sock in connections] == [b"", b""]
    assert node.counters["tcp.idle"] == 2
