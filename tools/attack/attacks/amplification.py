"""Few requests for many reports: with a forged source these would be sent to somebody else."""

from __future__ import annotations

import contextlib
import time

from jauspy.ids import JausID
from jauspy.messages.core import CreateEvent
from jauspy.messages.mobility import QueryLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

from ..arena import ROBOT, Arena
from ..attack import Attack, Attacker

CLIENTS = 8
MAX_FACTOR = 30.0
"""Bytes that are sent to these clients for each byte of theirs."""


def run(arena: Arena) -> None:
    """The clients receive, and acknowledge nothing."""
    sock = arena.open(arena.attacker.udp())
    sent = received = 0
    for number in range(CLIENTS):
        wish = CreateEvent(number, number % 2, 100.0, QueryLocalPose(0x1FF).encode())
        data = judp.pack(Packet(JausID(4300 + number, 1, 1), ROBOT, wish.encode(), number))
        arena.send(sock, data)
        sent += len(data)
    while arena.left:
        arena.command_robot()
        with contextlib.suppress(BlockingIOError):
            while data := sock.recv(70000):
                received += len(data)
        time.sleep(0.01)
    arena.require(received <= MAX_FACTOR * sent, f"{sent} bytes were answered by {received}")


ATTACK = Attack("amplification", Attacker.REMOTE, "CreateEvents", run)
