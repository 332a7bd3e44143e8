"""The way to one component: full queues, full send buffers, and components that are replaced."""

import asyncio
import errno
import socket
from collections.abc import Iterator
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.node.liveness import ComponentSockets
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

A, B, STALLED = (JausID.parse(text) for text in ("126.1.11", "126.1.20", "126.1.30"))


class Wire:
    """Unix datagram sockets of several components, as bytes."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self._open: list[socket.socket] = []

    def bound(self, id: JausID) -> socket.socket:
        sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self._open.append(sock)
        sock.setblocking(False)
        (self.root / str(int(id))).unlink(missing_ok=True)
        sock.bind(str(self.root / str(int(id))))
        return sock

    async def connected(self, id: JausID) -> socket.socket:
        sock = self.bound(id)
        await self.send(sock, junior.connect(id))
        assert await receive(sock) == junior.accept(id)
        return sock

    async def send(self, sock: socket.socket, data: bytes) -> None:
        while True:
            try:
                sock.sendto(data, str(self.root / junior.SOCKET_NAME))
            except BlockingIOError:
                await asyncio.sleep(0)
            else:
                return

    def close(self) -> None:
        for sock in self._open:
            sock.close()


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70000)


@pytest.fixture
def wire(root: Path) -> Iterator[Wire]:
    wire = Wire(root)
    yield wire
    wire.close()


def manager(root: Path) -> NodeManager:
    return NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))


async def test_large_messages_for_one_that_does_not_read_leave_room_for_the_others(root: Path, wire: Wire) -> None:
    """Unread datagrams fill their sender's buffer in the kernel, long before the receiver's queue is full."""
    async with manager(root) as node:
        a, b, stalled = [await wire.connected(id) for id in (A, B, STALLED)]
        large = [judp.pack(Packet(A, STALLED, bytes(60000), number)) for number in range(20)]
        for data in large:
            await wire.send(a, data)
        for number in range(200):
            there = judp.pack(Packet(A, B, b"\x02\x20", number))
            await wire.send(a, there)
            assert await receive(b) == there
        assert [await receive(stalled) for _ in large] == large
        assert node.counters["routed.local"] == 220


async def test_a_component_that_hangs_is_replaced_by_one_that_connects(root: Path, wire: Wire) -> None:
    """The old process still holds its socket open, but its name leads to the new one."""
    async with manager(root):
        a, old = await wire.connected(A), await wire.connected(B)
        data = judp.pack(Packet(A, B, b"\x02\x20", 1))
        await wire.send(a, data)
        assert await receive(old) == data
        new = await wire.connected(B)
        await wire.send(a, data)
        assert await receive(new) == data


async def test_what_waited_for_a_hanging_component_goes_to_its_successor(root: Path, wire: Wire) -> None:
    async with manager(root) as node:
        a = await wire.connected(A)
        await wire.connected(B)
        sent = [judp.pack(Packet(A, B, bytes(30000), number)) for number in range(60)]
        for data in sent:
            await wire.send(a, data)
        await wire.send(a, judp.pack(Packet(A, A, b"\0\0")))
        await receive(a)
        new = wire.bound(B)
        await wire.send(new, junior.connect(B))
        arrived = [await receive(new)]
        while arrived[-1] != sent[-1]:
            arrived.append(await receive(new))
        arrived.remove(junior.accept(B))
        assert arrived == sent[-len(arrived) :]
        assert node.counters["dropped.queue_full"] == 0


async def test_a_component_is_heard_again_without_connect_after_it_died(root: Path, wire: Wire) -> None:
    async with manager(root):
        a, b = await wire.connected(A), await wire.connected(B)
        b.close()
        again = wire.bound(B)
        data = judp.pack(Packet(A, B, b"\x02\x20", 1))
        await wire.send(a, data)
        assert await receive(again) == data


async def test_socket_that_may_not_be_written_to_is_a_warning_with_the_fix(
    root: Path, wire: Wire, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """As of a component with umask 022 beside a node manager of another user."""
    path = root / str(int(A))
    async with manager(root) as node:
        writer = await wire.connected(B)
        monkeypatch.setattr("jauspy.node.component_senders.local.connect", _refuse)
        reader = wire.bound(A)
        path.chmod(0o755)
        await wire.send(reader, junior.connect(A))
        for number in range(3):
            await wire.send(writer, judp.pack(Packet(B, A, b"\x02\x20", number)))
        async with asyncio.timeout(20):
            while node.counters["dropped.local_send"] < 4:
                await asyncio.sleep(0.01)
    (warning,) = [each.getMessage() for each in caplog.records if each.levelname == "WARNING"]
    assert "component 126.1.11 receives nothing: this node manager, which runs as" in warning
    assert f"may not write to its socket {path}" in warning
    assert "mode 755); start the component with `umask 002` in a group of" in warning
    assert f"`chmod o+w {path}`" in warning


def _refuse(sock: socket.socket, path: str) -> None:
    raise PermissionError(errno.EACCES, "Permission denied")


def test_sockets_are_taken_up_only_of_users_who_may_use_the_local_socket(wire: Wire) -> None:
    wire.bound(A)
    for name in ("007", "5000000000", "12x"):
        with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as other:
            other.bind(str(wire.root / name))
    (wire.root / "77").touch()
    sockets = ComponentSockets(wire.root)
    sockets.open()
    assert list(sockets.find_live(lambda _: True)) == [(int(A), str(wire.root / str(int(A))))]
    assert list(sockets.find_live(lambda _: False)) == []
    sockets.close()
