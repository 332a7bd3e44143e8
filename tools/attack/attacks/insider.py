"""An attacker who has the key: made-up senders and counters, ids of others, and damaged packets, all authenticated."""

from __future__ import annotations

import time

from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.authentication import Authenticator

from ..arena import OPERATOR, ROBOT, Arena
from ..attack import Attack, Attacker, Layout
from ..stage import KEY
from .malformed import damaged, random_packet

RATE = 1500
_SENDERS = 3000
"""More than a node manager remembers."""


def run(arena: Arena) -> None:
    """Each datagram has another sender."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    for number in arena.paced(RATE):
        source = chance.choice((OPERATOR, ROBOT, JausID.from_int(chance.randrange(1 << 32))))
        packet = judp.pack(random_packet(chance, source))
        sender = Authenticator(KEY, chance.randrange(_SENDERS))
        clock = time.time() + chance.choice((0.0, 0.0, 29.0, -29.0, 40.0))
        arena.send(sock, sender.sign(damaged(chance, packet) if number % 2 else packet, clock))


ATTACK = Attack("insider", Attacker.INSIDER, "datagrams", run, layout=Layout(keyed=True))
