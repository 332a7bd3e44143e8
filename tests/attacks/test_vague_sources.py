"""Packets whose source is a wildcard, or has zeros, so that answers go to all or to nobody."""

import asyncio
import logging
import socket
from collections.abc import AsyncIterator, Callable
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior, routing
from jauspy.protocol.counters import Counters
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack, Packet
from jauspy.protocol.pending import MAX_PENDING_DESTINATIONS, MAX_RELAYED_DESTINATIONS, PendingDestinations
from jauspy.testing import until

ROBOT, CLIENT, FAR = JausID.parse("101.1.1"), JausID.parse("101.1.2"), JausID.parse("42.1.1")
WILDCARDS = [JausID.parse(text) for text in ("65535.255.255", "42.255.1", "42.1.255", "65535.1.1")]
QUERY = b"\x02\x20"


@pytest.fixture
async def node(root: Path) -> AsyncIterator[NodeManager]:
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as manager:
        yield manager


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 5000)


@pytest.mark.parametrize("ack", [Ack.NONE, Ack.REQUIRED])
async def test_no_wildcard_passes_from_a_network(
    node: NodeManager, introduce: Callable[..., socket.socket], udp: Callable[..., socket.socket], ack: Ack
) -> None:
    robot, attacker = introduce(ROBOT), udp("127.0.0.2")
    assert await receive(robot) == junior.accept(ROBOT)
    where = ("127.0.0.1", node.port)
    for number, source in enumerate(WILDCARDS):
        attacker.sendto(judp.pack(Packet(source, ROBOT, QUERY, number, ack=ack)), where)
    good = judp.pack(Packet(FAR, ROBOT, QUERY, 1))
    attacker.sendto(good, where)
    assert await receive(robot) == good
    assert node.counters["dropped.wildcard_source"] == len(WILDCARDS)


async def test_a_local_program_gets_no_ack_to_all(node: NodeManager, introduce: Callable[..., socket.socket]) -> None:
    robot, client = introduce(ROBOT), introduce(CLIENT)
    for sock in (robot, client):
        await receive(sock)
    for number, source in enumerate(WILDCARDS):
        client.sendto(judp.pack(Packet(source, ROBOT, QUERY, number, ack=Ack.REQUIRED)), str(node.path))
    good = judp.pack(Packet(CLIENT, ROBOT, QUERY, 9))
    client.sendto(good, str(node.path))
    assert await receive(robot) == good
    assert node.counters["dropped.wildcard_source"] == len(WILDCARDS)


def test_a_component_without_a_node_manager_sends_no_ack_to_all() -> None:
    endpoint = Endpoint(ROBOT, first_sequence=1)
    for number, source in enumerate(WILDCARDS):
        endpoint.receive(judp.pack(Packet(source, ROBOT, QUERY, number, ack=Ack.REQUIRED)), 0.0)
    assert endpoint.poll_output() == []
    assert endpoint.counters["dropped.wildcard_source"] == len(WILDCARDS)


async def test_answers_to_ids_with_zeros_leave_room_for_the_search_of_others(
    root: Path,
    introduce: Callable[..., socket.socket],
    udp: Callable[..., socket.socket],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(routing, "VAGUE_RATE", 5.0)
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as node:
        await answer_vague_ones(node, introduce(ROBOT), udp("127.0.0.2"))


async def answer_vague_ones(node: NodeManager, robot: socket.socket, attacker: socket.socket) -> None:
    await receive(robot)
    for number in range(300):
        vague = JausID(1 + number, 0, 1)
        query = judp.pack(Packet(vague, ROBOT, QUERY, number))
        attacker.sendto(query, ("127.0.0.1", node.port))
        assert await receive(robot) == query
        robot.sendto(judp.pack(Packet(ROBOT, vague, b"\x02\x40", number)), str(node.path))
    await until(lambda: node.counters["dropped.unknown_destination"] > 0)
    before = node.counters["routed.multicast"]
    robot.sendto(judp.pack(Packet(ROBOT, JausID(77, 1, 1), QUERY, 1)), str(node.path))
    await until(lambda: node.counters["routed.multicast"] > before)
    assert node.counters["dropped.too_many_unknown_destinations"] == 0
    assert 5 <= before < 300


def test_a_host_outside_leaves_room_for_the_search_of_the_components() -> None:
    pending = PendingDestinations(Counters(logging.getLogger()))
    taken = [pending.add(1000 + number, b"", 0.0, relayed=True) for number in range(MAX_PENDING_DESTINATIONS)]
    assert taken.count(b"") == MAX_RELAYED_DESTINATIONS
    assert pending.add(7, b"own", 0.0) == b"own"
