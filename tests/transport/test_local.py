"""The Junior local protocol from a component's side, against a node manager that comes and goes."""

import asyncio
import socket
from pathlib import Path

import pytest

from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet
from jauspy.testing import until
from jauspy.transport import LocalTransport, local

A, B = JausID.parse("101.1.1"), JausID.parse("101.1.2")


def manager(root: Path) -> NodeManager:
    return NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))


async def test_missing_node_manager_error_says_what_to_do(root: Path) -> None:
    transport = LocalTransport(A, root, timeout=0.1)
    with pytest.raises(TransportError, match=f"jauspy node-manager --local-root {root}', or name the directory"):
        await transport.open()
    assert list(root.iterdir()) == []


async def test_id_in_use_is_an_error(root: Path) -> None:
    async with manager(root):
        first = LocalTransport(A, root)
        await first.open()
        with pytest.raises(TransportError, match=rf"another component {A} is already running .* use another id"):
            await LocalTransport(A, root).open()
        await first.close()


async def test_socket_of_another_kind_is_an_error(root: Path) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as other:
        other.bind(str(root / junior.SOCKET_NAME))
        with pytest.raises(TransportError, match="JuniorRTE is a socket of another kind"):
            await LocalTransport(A, root, timeout=0.05).open()


async def test_open_waits_for_a_late_node_manager(root: Path) -> None:
    transport = LocalTransport(A, root, timeout=None)
    await transport.open()
    assert not transport.connected
    async with manager(root):
        await until(lambda: transport.connected)
        await transport.close()


async def test_a_cancellation_in_the_moment_in_which_the_node_manager_answers_is_not_lost(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ctrl-C in the moment in which a component becomes known ends its program."""
    transport = LocalTransport(A, root)
    accept = transport._accepted.set

    async def serve() -> None:
        await transport.open()
        try:
            await asyncio.Event().wait()
        finally:
            await transport.close()

    def accept_and_cancel() -> None:
        accept()
        asyncio.get_running_loop().call_soon(serving.cancel)  # after the waiter was told, and before it runs on

    monkeypatch.setattr(transport._accepted, "set", accept_and_cancel)
    async with manager(root):
        serving = asyncio.create_task(serve())
        await until(serving.done)
        assert serving.cancelled()


async def test_connects_again_when_the_node_manager_is_back(root: Path) -> None:
    a, b = LocalTransport(A, root), LocalTransport(B, root)
    arrived: list[bytes] = []
    b.received = arrived.append
    async with manager(root):
        await a.open()
        await b.open()
    await until(lambda: not a.connected and not b.connected)
    async with manager(root) as again:
        await until(lambda: a.connected and b.connected)
        assert again.components == (A, B)
        a.send(judp.pack(Packet(A, B, b"\x02\x20")))
        await until(lambda: bool(arrived))
        await a.close()
        await b.close()


async def test_cancels_and_leaves_no_socket(root: Path) -> None:
    async with manager(root) as node:
        transport = LocalTransport(A, root)
        await transport.open()
        assert transport.path.is_socket()
        await transport.close()
        assert not transport.path.exists()
        await until(lambda: node.components == ())


async def test_takes_over_the_socket_of_a_dead_component(root: Path) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as dead:
        dead.bind(str(root / str(int(A))))
    async with manager(root):
        transport = LocalTransport(A, root)
        await transport.open()
        await transport.close()


async def test_other_files_are_not_removed(root: Path) -> None:
    (root / str(int(A))).write_text("mine")
    with pytest.raises(TransportError, match="is not a socket"):
        await LocalTransport(A, root).open()
    assert (root / str(int(A))).read_text() == "mine"


async def test_too_long_path_is_one_sentence(root: Path) -> None:
    with pytest.raises(TransportError, match="longer than 107 bytes"):
        await LocalTransport(A, root / ("x" * 120)).open()


async def test_bytes_match_those_of_a_junior_component(root: Path) -> None:
    """A node manager that only this test knows: it sees a Connect, answers it, and sees the Cancel."""
    loop = asyncio.get_running_loop()
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as node:
        node.bind(str(root / junior.SOCKET_NAME))
        node.setblocking(False)
        transport = LocalTransport(A, root)
        opening = asyncio.create_task(transport.open())
        data, sender = await loop.sock_recvfrom(node, 100)
        assert (data, sender) == (junior.connect(A), str(root / str(int(A))))
        node.sendto(junior.accept(A), sender)
        await opening
        await transport.close()
        while data != junior.cancel(A):
            data, _ = await loop.sock_recvfrom(node, 100)


async def test_unsent_datagrams_are_counted(root: Path) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as node:
        node.bind(str(root / junior.SOCKET_NAME))
        node.setblocking(False)
        transport = LocalTransport(A, root, timeout=None)
        await transport.open()
        for _ in range(500):
            transport.send(judp.pack(Packet(A, B, bytes(4000))))
        waiting = transport.waiting
        assert waiting > 100
        loop = asyncio.get_running_loop()
        async with asyncio.timeout(20):
            while transport.waiting > waiting - 50:
                await loop.sock_recv(node, 5000)
        await transport.close()
        assert transport.waiting == 0


async def test_failed_send_triggers_a_reconnect(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It does not wait for its next keep-alive, which here never comes."""
    monkeypatch.setattr(local, "KEEP_ALIVE_INTERVAL", 3600.0)
    transport = LocalTransport(A, root)
    async with manager(root):
        await transport.open()
        await asyncio.sleep(2 * local.CONNECT_INTERVAL)
    transport.send(judp.pack(Packet(A, B, b"\x02\x20")))
    assert not transport.connected
    async with manager(root):
        await until(lambda: transport.connected)
        await transport.close()
