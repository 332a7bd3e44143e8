"""Sources with wildcards that request acknowledgements, and acknowledgements of what was never sent."""

from __future__ import annotations

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, Packet

from ..arena import ROBOT, STRANGER, Arena
from ..attack import Attack, Attacker

RATE = 1500
QUERY_IDENTIFICATION = b"\x00\x2b\x04"


def run(arena: Arena) -> None:
    """To the robot, and to components that do not exist."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    vague = (EVERYONE, JausID(43, 255, 255), JausID(43, 1, 255), JausID(65535, 1, 1), STRANGER)
    for number in arena.paced(RATE):
        source = chance.choice(vague) if chance.random() < 0.5 else JausID(chance.randrange(1, 65535), 255, 255)
        destination = chance.choice((ROBOT, JausID(101, chance.randrange(1, 255), chance.randrange(1, 255))))
        ack = chance.choice((Ack.REQUIRED, Ack.ACK, Ack.NAK))
        payload = QUERY_IDENTIFICATION if ack is Ack.REQUIRED else b""
        arena.send(sock, judp.pack(Packet(source, destination, payload, number & 0xFFFF, ack=ack)))


ATTACK = Attack("vague-sources", Attacker.REMOTE, "datagrams", run)
