"""Packets with ids of others from the attacker's own address: the operator's, the robot's, and another component's."""

from __future__ import annotations

from jauspy.ids import JausID
from jauspy.messages.core import Resume, SetEmergency, Shutdown
from jauspy.messages.mobility import QueryLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, Packet, Priority

from ..arena import OPERATOR, ROBOT, Arena
from ..attack import Attack, Attacker
from ..stage import PORT

RATE = 3000
SIBLING = JausID.parse("101.1.103")
MESSAGES = tuple(each.encode() for each in (QueryLocalPose(1), Resume(), Shutdown(), SetEmergency(1)))


def run(arena: Arena) -> None:
    """To the robot as its operator and as its own components; to the operator as the robot."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    operator = (arena.hosts["operator"].address, PORT)
    for number in arena.paced(RATE):
        payload = chance.choice(MESSAGES)
        ack = chance.choice((Ack.NONE, Ack.REQUIRED, Ack.ACK))
        source, destination, where = chance.choice(
            ((OPERATOR, ROBOT, arena.where), (SIBLING, ROBOT, arena.where), (ROBOT, OPERATOR, operator))
        )
        packet = Packet(source, destination, payload, number & 0xFFFF, Priority.HIGH, ack=ack)
        arena.send(sock, judp.pack(packet), where)


ATTACK = Attack("forged-ids", Attacker.REMOTE, "datagrams", run)
