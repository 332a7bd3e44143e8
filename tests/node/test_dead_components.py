"""Components that died without goodbye: their ids are free again, and their sockets do not stay behind."""

import asyncio
import socket
from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

LIVING, DEAD = JausID.parse("126.1.11"), JausID.parse("126.1.20")


@pytest.fixture
async def node(root: Path) -> AsyncIterator[NodeManager]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as manager:
        yield manager


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(5):
        return await asyncio.get_running_loop().sock_recv(sock, 5000)


async def connected(root: Path, id: JausID, path: Path) -> socket.socket:
    sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    sock.setblocking(False)
    sock.bind(str(path))
    sock.sendto(junior.connect(id), str(root / junior.SOCKET_NAME))
    assert await receive(sock) == junior.accept(id)
    return sock


async def test_a_dead_components_id_comes_back_over_udp(root: Path, node: NodeManager) -> None:
    """As when an OCU was killed, and is started again with --connect udp://... and the same id."""
    dead_path = root / str(int(DEAD))
    with await connected(root, LIVING, root / str(int(LIVING))) as living:
        (await connected(root, DEAD, dead_path)).close()
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as again:
            again.setblocking(False)
            again.bind(("127.0.0.1", 0))
            query = judp.pack(Packet(DEAD, LIVING, b"\x02\x20", 1))
            again.sendto(query, ("127.0.0.1", node.port))
            assert await receive(living) == query
            report = judp.pack(Packet(LIVING, DEAD, b"\x02\x40", 1))
            living.sendto(report, str(node.path))
            assert await receive(again) == report
    assert node.components == (LIVING,)
    assert not dead_path.exists()


@pytest.mark.parametrize(("name", "stays"), [(str(int(DEAD)), False), ("mine", True), ("sub/8257812", True)])
async def test_only_components_sockets_in_the_local_root_are_removed(
    root: Path, node: NodeManager, name: str, stays: bool
) -> None:
    path = root / name
    path.parent.mkdir(exist_ok=True)
    with await connected(root, LIVING, root / str(int(LIVING))) as living:
        (await connected(root, DEAD, path)).close()
        living.sendto(judp.pack(Packet(LIVING, DEAD, b"\x02\x20", 1)), str(node.path))
        living.sendto(judp.pack(Packet(LIVING, LIVING, b"\x02\x20", 2)), str(node.path))
        await receive(living)
    assert node.components == (LIVING,)
    assert path.exists() == stays
