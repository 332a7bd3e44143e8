"""On a network with a key, everything is recorded, and sent again right after a node manager has started."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from jauspy.errors import ProtocolError
from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.authentication import Authenticator
from jauspy.protocol.header import Packet
from jauspy.testing import until

ROBOT, OPERATOR = JausID.parse("101.1.1"), JausID.parse("42.1.1")
KEY = b"0123456789abcdef"
COUNT = 300


def command(number: int) -> bytes:
    return judp.pack(Packet(OPERATOR, ROBOT, b"\x05\x04", number))


@pytest.fixture
def key_file(root: Path) -> Path:
    path = root / "lan.key"
    path.write_bytes(KEY)
    path.chmod(0o600)
    return path


class Operator:
    """A node manager with the key, of which everything that it sends is recorded."""

    def __init__(self, sock: socket.socket, node: tuple[str, int]) -> None:
        self.recorded: list[bytes] = []
        self.received: list[bytes] = []
        self._socket = sock
        self._node = node
        self._authenticator = Authenticator(KEY, 42)
        asyncio.get_running_loop().add_reader(sock, self._read)

    def send(self, datagram: bytes) -> None:
        self._send(self._authenticator.sign(datagram, time.time(), self._node))

    def _send(self, data: bytes) -> None:
        self.recorded.append(data)
        self._socket.sendto(data, self._node)

    def _read(self) -> None:
        data, source = self._socket.recvfrom(70000)
        with contextlib.suppress(ProtocolError):
            if (datagram := self._authenticator.verify(data, time.time(), source)) is not None:
                self.received.append(datagram)
        for _, answer in self._authenticator.poll_output():
            self._send(answer)


async def test_neither_commands_nor_addresses_are_taken_from_replays(
    root: Path,
    key_file: Path,
    free_port: int,
    introduce: Callable[..., socket.socket],
    udp: Callable[..., socket.socket],
) -> None:
    config = NodeConfig(address="127.0.0.1", port=free_port, local_root=root, key_file=key_file)
    where = ("127.0.0.1", free_port)
    arrived: list[bytes] = []
    operator, attacker = Operator(udp("127.0.0.2"), where), udp("127.0.0.66")
    async with NodeManager(config):
        robot = introduce(ROBOT)
        asyncio.get_running_loop().add_reader(robot, lambda: arrived.append(robot.recv(70000)))
        for number in range(COUNT):
            operator.send(command(number))
            if number % 16 == 0:
                await until(lambda number=number: command(number) in arrived)
        await until(lambda: len(arrived) == COUNT + 1)
    async with NodeManager(config) as node:
        robot.sendto(junior.connect(ROBOT), str(node.path))
        await until(lambda: arrived[-1] == junior.accept(ROBOT))
        arrived.clear()
        recorded = list(operator.recorded)
        for number, data in enumerate(recorded):
            attacker.sendto(data, where)
            if number % 16 == 0:
                await asyncio.sleep(0)
        await until(lambda: node.counters["dropped.auth.unproven"] >= COUNT)
        assert arrived == []
        operator.send(command(7777))
        await until(lambda: arrived == [command(7777)])
        for number in range(COUNT):
            report = judp.pack(Packet(ROBOT, OPERATOR, b"\x02\x40", number))
            robot.sendto(report, str(node.path))
            await until(lambda report=report: operator.received[-1:] == [report])
        for data in recorded:
            attacker.sendto(data, where)
        operator.send(command(7778))
        await until(lambda: arrived == [command(7777), command(7778)])
    asyncio.get_running_loop().remove_reader(robot)


async def test_two_node_managers_lose_nothing_when_they_meet_and_when_one_starts_again(
    root: Path, key_file: Path, free_port: int, introduce: Callable[..., socket.socket]
) -> None:
    (root / "b").mkdir()
    here = NodeConfig(
        address="127.0.0.1",
        port=free_port,
        local_root=root,
        key_file=key_file,
        addresses={"42.1.255": f"udp://127.0.0.2:{free_port}"},
    )
    there = here.model_copy(
        update={
            "address": "127.0.0.2",
            "local_root": root / "b",
            "addresses": {"101.1.255": f"udp://127.0.0.1:{free_port}"},
        }
    )
    loop = asyncio.get_running_loop()
    async with NodeManager(there) as far:
        operator = introduce(OPERATOR, root / "b")
        await loop.sock_recv(operator, 5000)
        robot = None
        for _ in range(2):
            async with NodeManager(here) as near:
                if robot is None:
                    robot = introduce(ROBOT)
                else:
                    robot.sendto(junior.connect(ROBOT), str(near.path))
                assert await loop.sock_recv(robot, 5000) == junior.accept(ROBOT)
                for number in range(5):
                    operator.sendto(command(number), str(far.path))
                    async with asyncio.timeout(20):
                        assert await loop.sock_recv(robot, 5000) == command(number)
                    report = judp.pack(Packet(ROBOT, OPERATOR, b"\x02\x40", number))
                    robot.sendto(report, str(near.path))
                    async with asyncio.timeout(20):
                        assert await loop.sock_recv(operator, 5000) == report
