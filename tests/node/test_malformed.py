"""24,000 malformed datagrams, each counted, with valid traffic in between, of which nothing is lost."""

import asyncio
import contextlib
import random
import socket
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.node import malformed

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

COUNT = 24_000
STREAMS = 800
BETWEEN = 40
"""Malformed ones between two valid ones."""
HERE, BESIDE, FAR = (JausID.parse(text) for text in ("101.1.1", "101.1.2", "42.1.1"))


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70000)


def dropped(node: NodeManager) -> int:
    return sum(count for name, count in node.counters.items() if name.startswith("dropped."))


def valid(source: JausID, number: int) -> bytes:
    return judp.pack(Packet(source, HERE, b"\x02\x20" + number.to_bytes(4, "little"), number & 0xFFFF))


async def until_sent(sock: socket.socket, data: bytes, path: str) -> None:
    """The kernel's queue of a local socket is short."""
    while True:
        try:
            sock.sendto(data, path)
        except BlockingIOError:
            await asyncio.sleep(0)
        else:
            return


@pytest.mark.slow
async def test_malformed_udp_is_handled(
    root: Path, introduce: Callable[..., socket.socket], udp: Callable[[], socket.socket]
) -> None:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as node:
        here, attacker, peer = introduce(HERE), udp(), udp()
        assert await receive(here) == junior.accept(HERE)
        where = ("127.0.0.1", node.port)
        for number, data in enumerate(malformed.datagrams(1, COUNT), 1):
            attacker.sendto(data, where)
            if number % BETWEEN == 0:
                peer.sendto(valid(FAR, number), where)
                assert await receive(here) == valid(FAR, number)
        assert sum(count for name, count in node.counters.items() if name.startswith("dropped.malformed")) == COUNT
        assert dropped(node) == COUNT
        assert node.counters["routed.local"] == COUNT // BETWEEN
        assert node.counters["routed.multicast"] == 0
        answers = 0
        while True:
            try:
                assert attacker.recv(100)[1] == 0x80
            except BlockingIOError:
                break
            answers += 1
        assert answers <= node.counters["compression.refused"] == COUNT // len(malformed.KINDS)


@pytest.mark.slow
async def test_malformed_local_datagrams_are_handled(root: Path, introduce: Callable[..., socket.socket]) -> None:
    """From a component that is registered, and goes on sending valid messages itself."""
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as node:
        here, beside = introduce(HERE), introduce(BESIDE)
        assert [await receive(here), await receive(beside)] == [junior.accept(HERE), junior.accept(BESIDE)]
        for number, data in enumerate(malformed.datagrams(2, COUNT), 1):
            await until_sent(beside, data, str(node.path))
            if number % BETWEEN == 0:
                await until_sent(beside, valid(BESIDE, number), str(node.path))
                assert await receive(here) == valid(BESIDE, number)
        assert sum(count for name, count in node.counters.items() if name.startswith("dropped.malformed")) == COUNT
        assert dropped(node) == COUNT
        assert node.counters["routed.local"] == COUNT // BETWEEN
        assert node.counters["routed.multicast"] == 0
        assert node.components == (HERE, BESIDE)


@pytest.mark.slow
async def test_malformed_tcp_streams_are_handled(root: Path, introduce: Callable[..., socket.socket]) -> None:
    """Each malformed one on a stream of its own, behind a valid packet; another stream goes on all the while."""
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, tcp=True, tcp_port=0)
    async with NodeManager(config) as node:
        here = introduce(HERE)
        assert await receive(here) == junior.accept(HERE)
        _, good = await asyncio.open_connection("127.0.0.1", node.tcp_port)
        good.write(b"\x02")
        for number, data in enumerate(malformed.datagrams(3, STREAMS)):
            reader, bad = await asyncio.open_connection("127.0.0.1", node.tcp_port)
            bad.write(valid(BESIDE, number) + data[1:] + b"\xff" * 70000)
            assert await receive(here) == valid(BESIDE, number)
            async with asyncio.timeout(20):
                with contextlib.suppress(ConnectionError):
                    assert await reader.read() == b""
            bad.close()
            good.write(valid(FAR, number)[1:])
            while (arrived := await receive(here)) != valid(FAR, number):
                assert arrived[9:13] != valid(FAR, 0)[9:13]
        good.close()
        closed = sum(count for name, count in node.counters.items() if name.startswith("dropped.malformed.stream"))
        assert closed == STREAMS


@pytest.mark.parametrize("kind", malformed.KINDS, ids=lambda kind: kind.__name__)
def test_generator_makes_the_described_packets(kind: Callable[..., bytes]) -> None:
    """The same for the same seed, and hardly ever the same twice."""
    first, again = ([kind(random.Random(seed)) for seed in range(50)] for _ in range(2))
    assert first == again
    assert len(set(first)) > 10
