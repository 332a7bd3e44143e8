"""Many components and connections that do not read make the node manager keep what is sent to them."""

import asyncio
import contextlib
import socket
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet, Priority
from jauspy.testing import until

HERE, READER = JausID.parse("101.1.1"), JausID.parse("101.1.2")
QUEUE_MEMORY = 4 << 20
NON_READERS, CONNECTIONS = 30, 12
LARGE = bytes(60_000)


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70_000)


async def send(sock: socket.socket, node: NodeManager, data: bytes) -> None:
    while True:
        with contextlib.suppress(BlockingIOError):
            sock.sendto(data, str(node.path))
            return
        await asyncio.sleep(0)


async def test_those_who_do_not_read_share_a_bounded_memory(
    root: Path, stack: ExitStack, introduce: Callable[..., socket.socket]
) -> None:
    settings = NodeConfig(
        address="127.0.0.1", port=0, local_root=root, tcp=True, tcp_port=0, queue_memory=QUEUE_MEMORY, max_message_age=0
    )
    async with NodeManager(settings) as node:
        here, reader = introduce(HERE), introduce(READER)
        for sock, id in ((here, HERE), (reader, READER)):
            assert await receive(sock) == junior.accept(id)
        lazy = [JausID(66, 1, 1 + number) for number in range(NON_READERS)]
        for number, id in enumerate(lazy, 3):
            introduce(id)
            await until(lambda wanted=number: len(node.components) == wanted)
        peers = [JausID(67, 1, 1 + number) for number in range(CONNECTIONS)]
        for id in peers:
            sock = stack.enter_context(socket.socket())
            sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
            sock.setblocking(False)
            await asyncio.get_running_loop().sock_connect(sock, ("127.0.0.1", node.tcp_port))
            await asyncio.get_running_loop().sock_sendall(sock, judp.pack(Packet(id, HERE, b"\x02\x20", 1)))
            assert judp.first_header(await receive(here)).source == int(id)
        for number in range(10):
            for id in (*lazy, *peers):
                await send(here, node, judp.pack(Packet(HERE, id, LARGE, number)))
        urgent = judp.pack(Packet(HERE, READER, b"\x02\x20", 1, Priority.SAFETY_CRITICAL))
        for _ in range(20):
            await send(here, node, urgent)
            assert await receive(reader) == urgent
        assert node.counters["dropped.queue_memory"] > 0
        assert node.counters["dropped.queue_full"] == 0
        queued = sum(node.state.queued.values())
        assert 0 < queued * len(LARGE) <= QUEUE_MEMORY
