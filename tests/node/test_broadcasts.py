"""Broadcasts by a prepared group: each component once, those that do not read by their queues, changes at once."""

import asyncio
import contextlib
import socket
from pathlib import Path

import pytest

from jauspy.ids import EVERYONE, JausID
from jauspy.logs import get_logger
from jauspy.node import NodeConfig, NodeManager
from jauspy.node.config import NetworkConfig
from jauspy.node.manager import RoutingCache
from jauspy.node.network import Network
from jauspy.protocol import judp, junior
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Broadcast, Packet

SENDER, READER, SLEEPER = (JausID(101, 1, number) for number in (1, 2, 3))


def make_broadcast(number: int, broadcast: Broadcast = Broadcast.LOCAL) -> bytes:
    return judp.pack(
        Packet(SENDER, EVERYONE, b"\x02\x40" + number.to_bytes(4, "little"), number & 0xFFFF, broadcast=broadcast)
    )


async def receive_all(sock: socket.socket, count: int) -> list[bytes]:
    loop = asyncio.get_running_loop()
    async with asyncio.timeout(20):
        return [await loop.sock_recv(sock, 100) for _ in range(count)]


async def test_component_that_sleeps_gets_all_broadcasts_later_and_delays_nobody(root: Path, introduce) -> None:
    """Its own socket holds few datagrams; the others wait in its queue, in order."""
    numbers = range(300)
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as node:
        sender, reader, sleeper = map(introduce, (SENDER, READER, SLEEPER))
        for sock, id in ((sender, SENDER), (reader, READER), (sleeper, SLEEPER)):
            assert await receive_all(sock, 1) == [junior.accept(id)]
        for number in numbers:
            sender.sendto(make_broadcast(number, Broadcast.GLOBAL), str(node.path))
            assert await receive_all(reader, 1) == [make_broadcast(number, Broadcast.GLOBAL)]
        assert await receive_all(sleeper, len(numbers)) == [make_broadcast(n, Broadcast.GLOBAL) for n in numbers]
        assert node.counters["routed.multicast"] == len(numbers)
        assert node.counters["routed.local"] == 2 * len(numbers)
        assert not any(name.startswith("dropped.queue") for name in node.counters)


async def test_group_follows_its_members(root: Path, introduce, monkeypatch) -> None:
    """One that joins gets the next broadcast, one that leaves or dies none, and no socket is left open."""
    found: list[bool] = []
    forward = RoutingCache.forward
    monkeypatch.setattr(RoutingCache, "forward", lambda *args: found.append(forward(*args)) or found[-1])
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as node:
        sender, reader = introduce(SENDER), introduce(READER)
        for sock in (sender, reader):
            await receive_all(sock, 1)
        sender.sendto(make_broadcast(1), str(node.path))
        await receive_all(reader, 1)
        assert found[-1]
        joined = introduce(SLEEPER)
        assert await receive_all(joined, 1) == [junior.accept(SLEEPER)]
        sender.sendto(make_broadcast(2), str(node.path))
        assert await receive_all(joined, 1) == await receive_all(reader, 1) == [make_broadcast(2)]
        joined.close()  # without Cancel
        sender.sendto(make_broadcast(3), str(node.path))
        assert await receive_all(reader, 1) == [make_broadcast(3)]
        assert node.components == (SENDER, READER)
        sender.sendto(make_broadcast(4), str(node.path))
        assert await receive_all(reader, 1) == [make_broadcast(4)]
        assert found[-1]
        assert sorted(node.state.queued) == [str(root / str(int(id))) for id in (SENDER, READER)]


def test_interface_of_multicasts_is_set_when_it_changes(monkeypatch: pytest.MonkeyPatch) -> None:
    """And again after an error or a check of the interfaces: one that was removed and added is another one."""
    selected: list[str] = []
    select = Network._select_interface

    def select_and_note(network: Network, interface: str) -> bool:
        selected.append(interface)
        return select(network, interface)

    monkeypatch.setattr(Network, "_select_interface", select_and_note)
    for interfaces in (("127.0.0.1",), ("127.0.0.1", "127.0.0.2")):
        selected.clear()
        counters = Counters(get_logger("test"))
        config = NetworkConfig(address="127.0.0.1", port=0, multicast_interfaces=interfaces)
        with contextlib.closing(Network(config, counters, 65536, None, lambda _: None)) as network:
            for _ in range(3):
                network.multicast(make_broadcast(1))
            if counters["dropped.udp_unreachable"]:
                pytest.skip("this machine does not multicast by its loopback interface")
            assert selected == (["127.0.0.1"] if len(interfaces) == 1 else 3 * ["127.0.0.1", "127.0.0.2"])
            selected.clear()
            network.refresh_memberships()
            network.multicast(make_broadcast(2))
            network.send(make_broadcast(3), "127.0.0.1", 0)  # which is refused
            assert counters["dropped.udp_unreachable"] == 1
            network.multicast(make_broadcast(4))
            assert selected == 2 * list(interfaces)
