"""Connects by UDP from this machine, which every user can send: with the ids of others, and as many as possible."""

from __future__ import annotations

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet

from ..arena import OPERATOR, ROBOT, Arena
from ..attack import Attack, Attacker, NotPossible
from ..stage import PORT

RATE = 1000


def run(arena: Arena) -> None:
    """As the remote operator, as the robot, and as 255 strangers."""
    if not arena.has_namespaces:
        raise NotPossible("on the loopback interface every machine is this machine")
    chance, sock = arena.chance, arena.open(arena.hosts["robot"].udp("127.0.0.1"))
    where = (arena.hosts["robot"].address, PORT)
    for number in arena.paced(RATE):
        id = (OPERATOR, ROBOT, JausID(101, 9, 1 + number % 254))[number % 3]
        control = chance.choice((junior.connect, junior.connect, junior.cancel))
        arena.send(sock, control(id), where)
        arena.send(sock, judp.pack(Packet(id, ROBOT, b"\x02\x20", number & 0xFFFF)), where)


ATTACK = Attack("local-udp", Attacker.LOCAL, "datagrams", run)
