"""A gateway over real sockets: an OCU on one loopback address, a module behind another."""

import asyncio
import socket
from pathlib import Path

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.node import NodeConfig, NodeManager, status
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Ack, Broadcast, Packet

OCU, MOB, LOCAL = (JausID.parse(text) for text in ("42.1.1", "101.1.102", "101.3.1"))


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 70000)


def gateway(root: Path, port: int, *rules: dict[str, object]) -> NodeConfig:
    return NodeConfig.make(
        address="127.0.0.1",
        port=port,
        local_root=root,
        networks=[{"name": "vehicle", "address": "127.0.0.2", "port": port, "multicast_group": "239.255.0.2"}],
        gateway={"subsystem": 101, "inside": ["vehicle"], "rules": rules},
    )


async def test_ocu_reaches_a_module_behind_the_gateway(root: Path, free_port: int, introduce, udp) -> None:
    async with NodeManager(gateway(root, free_port)) as node:
        local = introduce(LOCAL)
        assert await receive(local) == junior.accept(LOCAL)
        ocu, module = udp("127.0.0.1"), udp("127.0.0.2")
        hello = judp.pack(Packet(MOB, LOCAL, b"\x02\x40", 1))
        module.sendto(hello, ("127.0.0.2", free_port))
        assert await receive(local) == hello
        for number in range(20):
            query = judp.pack(Packet(OCU, MOB, b"\x02\x20", number))
            ocu.sendto(query, ("127.0.0.1", free_port))
            assert await receive(module) == query
            report = judp.pack(Packet(MOB, OCU, b"\x02\x40", number))
            module.sendto(report, ("127.0.0.2", free_port))
            assert await receive(ocu) == report
        for other in (JausID(102, 1, 1), JausID(102, 255, 255)):
            ocu.sendto(judp.pack(Packet(OCU, other, b"\x02\x20")), ("127.0.0.1", free_port))
        ocu.sendto(judp.pack(Packet(OCU, LOCAL, b"\x02\x20")), ("127.0.0.1", free_port))
        await receive(local)
        assert node.counters["dropped.gateway.not_addressed_here"] == 2
        reported = await status.read(root)
        assert reported["refused"] == [
            {"message": "QueryStatus 2002h", "network": "lan", "why": "not_addressed_here", "count": 2}
        ]
        assert node.counters["relayed"] == 40


async def test_broadcasts_and_probes_reach_both_sides(root: Path, free_port: int, introduce) -> None:
    """Outside an OCU's node manager, inside a module's, each on its own multicast group, unaware of it."""
    folders = [root / name for name in ("gate", "ocu", "mob")]
    outside = NodeConfig(address="127.0.0.3", port=free_port, local_root=folders[1])
    inside = NodeConfig(address="127.0.0.4", port=free_port, local_root=folders[2], multicast_group="239.255.0.2")
    gate = NodeManager(gateway(folders[0], free_port, {"source": "42.*.*"}))
    async with gate, NodeManager(outside) as near, NodeManager(inside) as far:
        if any(node.counters["multicast.not_joined"] for node in (gate, near, far)):
            pytest.skip("this kernel does not multicast on its loopback interface")
        ocu, stranger, module = (
            introduce(OCU, folders[1]),
            introduce(JausID(43, 1, 1), folders[1]),
            introduce(MOB, folders[2]),
        )
        for sock in (ocu, stranger, module):
            await receive(sock)
        everybody = judp.pack(Packet(OCU, EVERYONE, b"\x00\x2b\x04", 1, broadcast=Broadcast.GLOBAL))
        stranger.sendto(judp.pack(Packet(JausID(43, 1, 1), MOB, b"\x02\x20", 1)), str(near.path))
        ocu.sendto(everybody, str(near.path))
        assert await receive(stranger) == everybody
        assert await receive(module) == everybody
        answer = judp.pack(Packet(MOB, OCU, b"\x00\x4b", 1))
        module.sendto(answer, str(far.path))
        assert await receive(ocu) == answer
        query = judp.pack(Packet(OCU, MOB, b"\x02\x20", 2))
        ocu.sendto(query, str(near.path))
        while (arrived := judp.unpack(await receive(module))[0]).sequence != 2:
            assert arrived.source == OCU
        assert arrived.ack in (Ack.NONE, Ack.REQUIRED)
        assert gate.counters["dropped.gateway.rule"] == 1
