"""Packets of made-up sources to made-up destinations: each could fill tables of addresses, probes and messages."""

from __future__ import annotations

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, Broadcast, Packet

from ..arena import OPERATOR, ROBOT, Arena
from ..attack import Attack, Attacker

RATE = 1000
QUERY_IDENTIFICATION = b"\x00\x2b\x04"


def run(arena: Arena) -> None:
    """Sources of any kind; destinations are the robot, everyone, and nobody."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    for number in arena.paced(RATE):
        source = JausID.from_int(chance.randrange(1 << 32))
        if source in (OPERATOR, ROBOT):
            continue
        destination = (
            EVERYONE if number % 10 == 0 else ROBOT if number % 2 else JausID.from_int(chance.randrange(1 << 32))
        )
        broadcast = Broadcast.GLOBAL if destination.is_wildcard else Broadcast.NONE
        ack = Ack.REQUIRED if number % 5 == 0 else Ack.NONE
        packet = Packet(source, destination, QUERY_IDENTIFICATION, number & 0xFFFF, broadcast=broadcast, ack=ack)
        arena.send(sock, judp.pack(packet))


ATTACK = Attack("made-up-ids", Attacker.REMOTE, "datagrams", run)
