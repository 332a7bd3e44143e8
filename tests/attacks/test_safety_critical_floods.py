"""A flood in which all is said to be safety-critical, and the ordinary packets of others."""

from __future__ import annotations

import logging
import socket
import time
from collections.abc import Callable

import pytest

from jauspy.ids import JausID
from jauspy.node import ingress, kernel_filter
from jauspy.node.ingress import Ingress
from jauspy.protocol import judp
from jauspy.protocol.counters import Counters
from jauspy.protocol.header import Packet, Priority
from jauspy.protocol.sources import SourceChecks, SourceLimits
from jauspy.transport.age import DatagramReader

ROBOT, OPERATOR, FLOODER = (JausID.parse(text) for text in ("101.1.1", "42.1.1", "43.1.1"))


def packet(source: JausID, number: int, priority: Priority) -> bytes:
    return judp.pack(Packet(source, ROBOT, b"\x02\x20", number & 0xFFFF, priority))


class Socket:
    """Has a flood without end; every 64th datagram is an ordinary one."""

    def __init__(self) -> None:
        self.count = 0

    def recvfrom(self, _: int) -> tuple[bytes, tuple[str, int]]:
        self.count += 1
        if self.count % 64:
            return packet(FLOODER, self.count, Priority.SAFETY_CRITICAL), ("10.0.0.66", 3794)
        return packet(OPERATOR, self.count // 64, Priority.STANDARD), ("10.0.0.1", 3794)

    family = socket.AF_INET

    def setsockopt(self, *_: object) -> None:
        raise OSError("this kernel has neither stamps nor filters")


@pytest.mark.slow
@pytest.mark.parametrize("rate", [0.0, 1.0])
async def test_ordinary_packets_keep_their_share_of_what_is_queued(rate: float) -> None:
    source, counters = Socket(), Counters(logging.getLogger("jauspy.test"))
    routed: list[bytes] = []
    checks = SourceChecks(SourceLimits(rate=rate, burst=10.0))

    def route(data: bytes, _: object) -> None:
        """As the router does."""
        id = OPERATOR if data[4] & 3 == Priority.STANDARD else FLOODER
        if not rate or id == OPERATOR or checks.within_rate(int(id), data[4] & 3, time.monotonic()):
            routed.append(data)

    reader = Ingress(route, counters, sources=checks)
    ages = DatagramReader(source, counters)  # type: ignore[arg-type]
    for _ in range(400):
        reader._wake(ages, "lan", {}, lambda error: None)
        reader._route()
    ordinary = [data for data in routed if judp.peek_priority(data) == Priority.STANDARD]
    assert len(ordinary) >= 0.9 * source.count / 64 - ingress.PRIORITY_SHARE
    if rate:
        assert len(routed) - len(ordinary) <= 10 + rate * 30
        assert counters["dropped.rate"] > 0.5 * source.count
    else:
        assert counters["dropped.overload"] > 0.5 * source.count


def test_the_kernel_drops_most_of_the_flood_and_nothing_else(udp: Callable[..., socket.socket]) -> None:
    receiver, sender = udp(), udp()
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
    if not kernel_filter.attach_sampling(receiver, Priority.SAFETY_CRITICAL, 0.25, 0):
        pytest.skip("this system has no socket filters")
    for number in range(1000):
        sender.sendto(packet(FLOODER, number, Priority.SAFETY_CRITICAL), receiver.getsockname())
        if number % 10 == 0:
            sender.sendto(packet(OPERATOR, number, Priority.LOW), receiver.getsockname())
    arrived = []
    while True:
        try:
            arrived.append(judp.peek_priority(receiver.recv(5000)))
        except BlockingIOError:
            break
    assert arrived.count(Priority.LOW) == 100
    assert 150 < arrived.count(Priority.SAFETY_CRITICAL) < 350


@pytest.mark.slow
async def test_the_filter_becomes_tighter_until_the_rest_can_be_routed(udp: Callable[..., socket.socket]) -> None:
    receiver, sender = udp(), udp()
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
    counters = Counters(logging.getLogger("jauspy.test"))
    reader, ages = Ingress(lambda data, _: None, counters), DatagramReader(receiver, counters)
    flood = packet(FLOODER, 1, Priority.SAFETY_CRITICAL)
    for _ in range(60):
        for _ in range(2 * ingress.READ_BURST):
            sender.sendto(flood, receiver.getsockname())
        reader._wake(ages, "lan", {}, lambda error: None)
    if not counters["kernel_filter.attached"]:
        pytest.skip("this system has no socket filters")
    assert reader._filtered[receiver].share < 1.0
    while len(reader):
        reader._route()
    assert not reader._filtered
    reader.close()
