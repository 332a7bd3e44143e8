"""Thousands of events: each CreateEvent asks the robot to repeat a query at 100 Hz, or on every change."""

from __future__ import annotations

from jauspy.ids import JausID
from jauspy.messages.core import CreateEvent
from jauspy.messages.mobility import QueryLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

from ..arena import ROBOT, Arena
from ..attack import Attack, Attacker

RATE = 1000
CLIENTS = 200


def run(arena: Arena) -> None:
    """By many clients on one host, which acknowledge nothing and cancel nothing."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    for number in arena.paced(RATE):
        query = QueryLocalPose(chance.randrange(1, 0x200)).encode()
        wish = CreateEvent(number & 0xFF, chance.choice((0, 1)), 100.0, query)
        client = JausID(4300 + number % CLIENTS, 1, 1)
        arena.send(sock, judp.pack(Packet(client, ROBOT, wish.encode(), number & 0xFFFF)))


ATTACK = Attack("events", Attacker.REMOTE, "CreateEvents", run, restarts=True)
