"""Paths of local sockets that lead to other sockets, and directories of other users."""

import asyncio
import os
import socket
from collections.abc import Callable
from pathlib import Path

import pytest

from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

HERE, LINK = JausID.parse("101.1.1"), JausID.parse("66.1.1")
NOBODY = 65534


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 5000)


def manager(root: Path) -> NodeManager:
    return NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))


async def works(node: NodeManager, here: socket.socket) -> None:
    own = judp.pack(Packet(HERE, HERE, b"\0\0"))
    here.sendto(own, str(node.path))
    assert await receive(here) == own


async def test_a_link_to_the_node_manager_makes_no_loop(root: Path, introduce: Callable[..., socket.socket]) -> None:
    (root / str(int(LINK))).symlink_to(junior.SOCKET_NAME)
    async with manager(root) as node:
        here = introduce(HERE)
        assert await receive(here) == junior.accept(HERE)
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as unnamed:
            unnamed.sendto(judp.pack(Packet(LINK, LINK, b"\x02\x20", 1)), str(node.path))
            unnamed.sendto(junior.connect(LINK), str(node.path))
        for _ in range(5):
            await works(node, here)
        assert node.counters["received.local"] == 8
        assert node.counters["dropped.component_gone"] == 2
        assert node.components == (HERE,)


async def test_links_between_two_node_managers_make_no_loop(
    root: Path, introduce: Callable[..., socket.socket]
) -> None:
    for name, other in (("a", "b"), ("b", "a")):
        (root / name).mkdir()
        (root / name / str(int(LINK))).symlink_to(root / other / junior.SOCKET_NAME)
    async with manager(root / "a") as one, manager(root / "b") as other_one:
        here, there = introduce(HERE, root / "a"), introduce(HERE, root / "b")
        await receive(here)
        await receive(there)
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as unnamed:
            unnamed.sendto(judp.pack(Packet(LINK, LINK, b"\x02\x20", 1)), str(one.path))
        for _ in range(5):
            await works(one, here)
            await works(other_one, there)
        assert (one.counters["received.local"], other_one.counters["received.local"]) == (7, 6)


async def test_what_comes_from_the_socket_of_a_node_manager_is_no_component(
    root: Path, introduce: Callable[..., socket.socket]
) -> None:
    (root / "other").mkdir()
    async with manager(root) as node:
        here = introduce(HERE)
        await receive(here)
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as other:
            other.bind(str(root / "other" / junior.SOCKET_NAME))
            other.sendto(judp.pack(Packet(LINK, HERE, b"\x02\x20", 1)), str(node.path))
        await works(node, here)
        assert node.counters["dropped.node_manager"] == 1
        assert node.components == (HERE,)


async def test_a_link_to_another_service_gets_nothing(root: Path, introduce: Callable[..., socket.socket]) -> None:
    """As systemd's, which would obey what comes from the node manager."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as notify:
        notify.bind(str(root / "notify"))
        notify.setblocking(False)
        (root / str(int(LINK))).symlink_to("notify")
        async with manager(root) as node:
            here = introduce(HERE)
            await receive(here)
            with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as unnamed:
                unnamed.sendto(judp.pack(Packet(LINK, LINK, b"\nSTOPPING=1\n", 1)), str(node.path))
            await works(node, here)
        with pytest.raises(BlockingIOError):
            notify.recv(100)


async def test_a_local_root_of_another_user_is_refused(root: Path) -> None:
    if os.geteuid():
        pytest.skip("needs root to give a directory to another user")
    theirs, link = root / "theirs", root / "link"
    theirs.mkdir()
    os.chown(theirs, NOBODY, -1)
    link.symlink_to(root)
    os.lchown(link, NOBODY, -1)
    for path in (theirs, link):
        with pytest.raises(TransportError, match=rf"^{path} belongs to another user \(nobody\), who could replace"):
            await manager(path).open()
    assert not list(theirs.iterdir())


async def test_a_local_root_where_all_users_may_replace_sockets_is_refused(root: Path) -> None:
    root.chmod(0o777)
    with pytest.raises(TransportError, match=rf"do: chmod \+t {root}$"):
        await manager(root).open()
    root.chmod(0o1777)
    async with manager(root):
        pass
