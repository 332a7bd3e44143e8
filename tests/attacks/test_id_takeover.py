"""A program of the robot's machine, or another host, takes an id that is in use elsewhere."""

import asyncio
import logging
import os
import socket
from collections.abc import AsyncIterator, Callable
from pathlib import Path

import pytest

from jauspy.errors import TransportError
from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet
from jauspy.testing import until
from jauspy.transport import LocalTransport, local

ROBOT, OPERATOR = JausID.parse("101.1.1"), JausID.parse("42.1.1")
NOBODY = 65534
Udp = Callable[..., socket.socket]


@pytest.fixture
async def node(root: Path) -> AsyncIterator[NodeManager]:
    config = NodeConfig(address="127.0.0.1", port=0, local_root=root, own_ids=("101.1.*",))
    async with NodeManager(config) as manager:
        yield manager


async def receive(sock: socket.socket) -> bytes:
    async with asyncio.timeout(20):
        return await asyncio.get_running_loop().sock_recv(sock, 5000)


def command(sequence: int, source: JausID = OPERATOR) -> bytes:
    return judp.pack(Packet(source, ROBOT, b"\x05\x04", sequence))


class Scene:
    """A robot on the local socket, and its operator on another host."""

    def __init__(self, node: NodeManager, robot: socket.socket, operator: socket.socket) -> None:
        self.node = node
        self.robot = robot
        self.operator = operator
        self.sequence = 0

    async def operator_drives(self) -> None:
        self.sequence += 1
        self.operator.sendto(command(self.sequence), ("127.0.0.1", self.node.port))
        assert await receive(self.robot) == command(self.sequence)
        report = judp.pack(Packet(ROBOT, OPERATOR, b"\x02\x40", self.sequence))
        self.robot.sendto(report, str(self.node.path))
        assert await receive(self.operator) == report


@pytest.fixture
async def scene(node: NodeManager, introduce: Callable[..., socket.socket], udp: Udp) -> Scene:
    robot = introduce(ROBOT)
    assert await receive(robot) == junior.accept(ROBOT)
    scene = Scene(node, robot, udp("127.0.0.2"))
    await scene.operator_drives()
    return scene


@pytest.mark.parametrize("first", [junior.connect(OPERATOR), command(7)], ids=["connect", "message"])
@pytest.mark.parametrize("way", ["udp", "local"])
async def test_a_local_program_does_not_get_the_id_of_a_remote_operator(
    scene: Scene, udp: Udp, way: str, first: bytes, caplog: pytest.LogCaptureFixture
) -> None:
    node = scene.node
    with caplog.at_level(logging.WARNING), socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as own:
        own.bind(str(node.config.local_root / str(int(OPERATOR))))
        own.setblocking(False)
        attacker = udp() if way == "udp" else own
        where = ("127.0.0.1", node.port) if way == "udp" else str(node.path)
        for _ in range(8):
            attacker.sendto(first, where)
        await scene.operator_drives()
        dropped = "address_mismatch" if (way, first[0]) == ("udp", 2) else "id_taken"
        await until(lambda: node.counters[f"dropped.{dropped}"] == 8)
        assert node.components == (ROBOT,)
        with pytest.raises(BlockingIOError):
            attacker.recv(100)
    assert len([line for line in caplog.messages if line.startswith("id 42.1.1 is in use at 127.0.0.2:")]) == (
        dropped == "id_taken"
    )


async def test_who_is_not_accepted_learns_why(scene: Scene) -> None:
    late = LocalTransport(OPERATOR, scene.node.config.local_root, timeout=0.2)
    with pytest.raises(TransportError, match=r"does not accept 42\.1\.1: another host uses this id"):
        await late.open()
    await scene.operator_drives()


async def test_who_waits_for_its_node_manager_is_reported_in_the_log(
    scene: Scene, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(local, "REFUSED_AFTER", 0.1)
    waiting = LocalTransport(OPERATOR, scene.node.config.local_root, timeout=None)
    await waiting.open()
    await until(lambda: any("does not accept 42.1.1" in line for line in caplog.messages))
    await asyncio.sleep(0.3)
    assert len([line for line in caplog.messages if "does not accept" in line]) == 1
    await waiting.close()


async def test_an_operator_that_ended_on_this_machine_leaves_its_id(scene: Scene, udp: Udp) -> None:
    """As when an OCU without a node manager ended, and starts again with a local socket."""
    scene.operator.close()
    again = udp()
    again.sendto(junior.connect(OPERATOR), ("127.0.0.1", scene.node.port))
    assert await receive(again) == junior.accept(OPERATOR)


async def test_another_user_may_not_connect_by_udp(scene: Scene) -> None:
    if os.geteuid():
        pytest.skip("needs root to make a socket of another user")
    where = ("127.0.0.1", scene.node.port)
    os.seteuid(NOBODY)
    try:
        attacker = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    finally:
        os.seteuid(0)
    with attacker:
        attacker.setblocking(False)
        for number in range(10):
            attacker.sendto(junior.connect(JausID(77, 1, 1 + number)), where)
        await until(lambda: scene.node.counters["dropped.not_permitted"] == 10)
        await scene.operator_drives()
        assert scene.node.components == (ROBOT,)


async def test_another_user_who_speaks_as_an_operator_does_not_keep_it_out(node: NodeManager, udp: Udp) -> None:
    if os.geteuid():
        pytest.skip("needs root to make a socket of another user")
    os.seteuid(NOBODY)
    try:
        attacker = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    finally:
        os.seteuid(0)
    with attacker:
        attacker.sendto(command(1), ("127.0.0.1", node.port))
        await until(lambda: node.counters["received.udp"] == 1)
        operator = udp()
        operator.sendto(junior.connect(OPERATOR), ("127.0.0.1", node.port))
        assert await receive(operator) == junior.accept(OPERATOR)


async def test_another_host_does_not_get_the_id_of_a_robot_that_starts(
    node: NodeManager, introduce: Callable[..., socket.socket], udp: Udp
) -> None:
    attacker = udp("127.0.0.2")
    attacker.sendto(judp.pack(Packet(ROBOT, OPERATOR, b"\x02\x40", 1)), ("127.0.0.1", node.port))
    await until(lambda: node.counters["dropped.hijack"] == 1)
    assert await receive(introduce(ROBOT)) == junior.accept(ROBOT)
