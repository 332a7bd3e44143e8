"""A gateway fails and another one takes over, and an attacker pretends that: who is heard, and where answers go."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable
from pathlib import Path

import pytest

from jauspy.ids import JausID
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.addressing import LocalPort, UdpPort
from jauspy.protocol.header import Ack, Packet
from jauspy.protocol.routing import Router
from jauspy.protocol.sources import MOVE_TIMEOUT, SourceChecks, SourceLimits

ROBOT, OPERATOR = JausID.parse("101.1.1"), JausID.parse("42.1.1")
OLD, NEW, ATTACKER = (UdpPort(f"10.0.0.{last}", 3794) for last in (2, 3, 66))
LOCAL = LocalPort(f"/root/{int(ROBOT)}")


class Side:
    """A node manager with the robot, and what arrives there; time is its own."""

    def __init__(self, *, authenticated: bool = False) -> None:
        names = ("lan",) if authenticated else ()
        self.router = Router("/root", sources=SourceChecks(SourceLimits(), authenticated=names))
        self.now = 100.0
        self.router.receive(junior.connect(ROBOT), LOCAL, self.now)
        self.router.poll_output()

    def is_heard(self, port: UdpPort, number: int, ack: Ack = Ack.NONE) -> bool:
        packet = judp.pack(Packet(OPERATOR, ROBOT, b"\x02\x20", number & 0xFFFF, ack=ack))
        self.router.receive(packet, port, self.now)
        return (LOCAL, packet) in self.router.poll_output()

    def answers_to(self) -> UdpPort:
        self.router.receive(judp.pack(Packet(ROBOT, OPERATOR, b"\x02\x40")), LOCAL, self.now)
        ((port, _),) = self.router.poll_output()
        assert isinstance(port, UdpPort)
        return port

    def drive(self, port: UdpPort, first: int, count: int) -> list[bool]:
        """Commands at 20 Hz; whether each was heard."""
        heard = []
        for number in range(first, first + count):
            heard.append(self.is_heard(port, number))
            self.now += 0.05
        return heard


@pytest.mark.parametrize("authenticated", [False, True])
@pytest.mark.parametrize("first", [1, 0xFFF0])
def test_the_new_way_is_followed_within_a_second_and_the_old_one_when_it_comes_back(
    authenticated: bool, first: int
) -> None:
    side = Side(authenticated=authenticated)
    assert all(side.drive(OLD, first, 40))
    side.now += 0.5  # so long it takes until the other gateway works
    heard = side.drive(NEW, first + 50, 20)
    assert heard.index(True) * 0.05 < 0.5
    assert all(heard[heard.index(True) :])
    assert side.answers_to() == NEW
    side.now += 1.0
    assert any(side.drive(OLD, first + 90, 20))
    assert side.answers_to() == OLD


def test_a_stop_that_is_resent_gets_through() -> None:
    side = Side()
    side.drive(OLD, 1, 40)
    side.now += 3.0
    heard = []
    for _ in range(4):
        heard.append(side.is_heard(NEW, 41, Ack.REQUIRED))
        side.now += 0.1
    assert heard[-1]


def test_while_the_old_way_is_heard_nobody_else_is_whatever_the_number() -> None:
    side = Side()
    for number in range(1, 400):
        assert side.is_heard(OLD, number)
        assert not side.is_heard(ATTACKER, number + 1)
        side.now += 0.05
        assert not side.is_heard(ATTACKER, number + 1)
    assert side.answers_to() == OLD


@pytest.mark.parametrize("numbers", [range(0, 65536, 251), range(1000, 1400), [7] * 1000])
def test_numbers_cannot_be_tried(numbers: range | list[int]) -> None:
    side = Side()
    side.drive(OLD, 30000, 40)
    side.now += 1.0
    for number in numbers:
        assert not side.is_heard(ATTACKER, number)
        side.now += 0.01
    assert not side.is_heard(ATTACKER, 30041)  # in vain: another number was wrong
    assert side.answers_to() == OLD
    side.now += MOVE_TIMEOUT
    assert side.is_heard(ATTACKER, 1)


def test_one_who_listens_takes_a_silent_operator_at_most_until_that_is_heard_again() -> None:
    side = Side()
    side.drive(OLD, 1, 40)
    side.now += 1.0
    assert any(side.drive(ATTACKER, 41, 10))
    assert side.is_heard(OLD, 41)
    side.now += 1.0
    assert not any(side.drive(ATTACKER, 51, 100))
    assert side.is_heard(OLD, 42)


def test_acknowledgements_have_numbers_of_others() -> None:
    side = Side()
    side.drive(OLD, 1, 40)
    side.now += 1.0
    for _ in range(20):
        assert not side.is_heard(ATTACKER, 41, Ack.ACK)
        side.now += 0.05
    assert any(side.drive(NEW, 41, 10))


async def test_a_real_node_manager_follows(
    root: Path, introduce: Callable[..., socket.socket], udp: Callable[..., socket.socket]
) -> None:
    loop = asyncio.get_running_loop()
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)) as node:
        robot, old, new = introduce(ROBOT), udp("127.0.0.2"), udp("127.0.0.3")
        number = 0

        async def send(way: socket.socket, seconds: float) -> list[float]:
            """Commands at 100 Hz; when those of this way arrived."""
            nonlocal number
            begin, sent, arrived = loop.time(), set(), []
            while loop.time() - begin < seconds:
                number += 1
                packet = judp.pack(Packet(OPERATOR, ROBOT, b"\x02\x20", number))
                sent.add(packet)
                way.sendto(packet, ("127.0.0.1", node.port))
                await asyncio.sleep(0.01)
                while True:
                    try:
                        data = robot.recv(5000)
                    except BlockingIOError:
                        break
                    arrived += [loop.time() - begin] if data in sent else []
            return arrived

        assert await send(old, 0.8)
        assert min(await send(new, 1.0)) < 0.8
