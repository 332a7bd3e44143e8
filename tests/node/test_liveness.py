"""Components that died without goodbye: their ids are free again, and their sockets do not stay behind."""

import asyncio
import contextlib
import socket
from collections.abc import AsyncIterator
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager, liveness
from jauspy.protocol import judp, junior
from jauspy.protocol.address_book import ComponentDirectory, ComponentPort
from jauspy.protocol.addressing import LocalPort
from jauspy.protocol.header import Packet
from jauspy.testing import until

LIVING, DEAD = JausID.parse("126.1.11"), JausID.parse("126.1.20")


@pytest.fixture
def swept(monkeypatch: pytest.MonkeyPatch) -> None:
    """The node manager looks after its components all the time."""
    monkeypatch.setattr(liveness, "CHECK_INTERVAL", 0.01)


@pytest.fixture
async def node(root: Path) -> AsyncIterator[NodeManager]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as manager:
        yield manager


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 5000)


async def connected(root: Path, id: JausID, path: Path) -> socket.socket:
    sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    sock.setblocking(False)
    sock.bind(str(path))
    sock.sendto(junior.connect(id), str(root / junior.SOCKET_NAME))
    assert await receive(sock) == junior.accept(id)
    return sock


async def test_id_of_a_dead_component_is_available_over_udp(root: Path, node: NodeManager) -> None:
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


@pytest.mark.usefixtures("swept")
async def test_dead_component_without_traffic_is_detected(root: Path, node: NodeManager) -> None:
    path = root / str(int(DEAD))
    with await connected(root, LIVING, root / str(int(LIVING))):
        (await connected(root, DEAD, path)).close()
        await until(lambda: node.components == (LIVING,))
        assert not path.exists()
        for _ in range(5):
            await asyncio.sleep(0.02)
            assert node.components == (LIVING,)
    assert node.counters["components.lost"] == 1


@pytest.mark.usefixtures("swept")
async def test_messages_queued_for_a_dead_component_are_counted(root: Path, node: NodeManager) -> None:
    with await connected(root, LIVING, root / str(int(LIVING))) as living:
        dead = await connected(root, DEAD, root / str(int(DEAD)))
        sent = 0
        while not (waiting := node.state.queued.get(str(root / str(int(DEAD))), 0)) > 20:
            with contextlib.suppress(BlockingIOError):
                living.sendto(judp.pack(Packet(LIVING, DEAD, b"\x02\x20", sent)), str(node.path))
                sent += 1
            await asyncio.sleep(0)
        dead.close()
        await until(lambda: node.components == (LIVING,))
    assert node.counters["dropped.component_gone"] == waiting


@pytest.mark.usefixtures("swept")
async def test_dead_udp_component_is_detected(node: NodeManager) -> None:
    there = ("127.0.0.1", node.port)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as living:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as dead:
            for sock, id in ((living, LIVING), (dead, DEAD)):
                sock.setblocking(False)
                sock.sendto(junior.connect(id), there)
                assert await receive(sock) == junior.accept(id)
        await until(lambda: node.components == (LIVING,))
        for _ in range(5):
            await asyncio.sleep(0.02)
            assert node.components == (LIVING,)


def test_many_components_are_probed_a_few_at_a_time() -> None:
    components, asked = ComponentDirectory(), []
    for number in range(3 * liveness.MAX_CHECKS):
        components.register(number + 1, LocalPort(f"/{number}"))

    def is_dead(port: ComponentPort) -> bool:
        asked.append(port)
        return port == LocalPort("/7")

    gone: list[ComponentPort] = []
    looking = liveness.LivenessCheck(components, is_dead, gone.append)
    for turn in range(1, 4):
        looking.check_next()
        assert len(asked) == turn * liveness.MAX_CHECKS
    assert len(set(asked)) == len(asked)
    assert gone == [LocalPort("/7")]


def test_full_directory_is_probed_at_once() -> None:
    components, asked = ComponentDirectory(max_sockets=100), []
    assert all(components.register(number, LocalPort(f"/{number}")) for number in range(1, 101))
    assert not components.register(101, LocalPort("/101"))
    assert components.register(101, LocalPort("/100"))  # another id on the same socket
    assert components.register(7, LocalPort("/8"))
    assert components.register(102, LocalPort("/102"))
    assert components.is_full
    liveness.LivenessCheck(components, lambda path: bool(asked.append(path)), lambda port: None).check_next()
    assert len(asked) == 100
