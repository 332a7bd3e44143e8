"""Headers of earlier versions (AS5669 version 1, OpenJAUS 3): valid, damaged, and with ids of others."""

from __future__ import annotations

import random
import struct

from jauspy.protocol import legacy

from ..arena import OPERATOR, ROBOT, STRANGER, Arena
from ..attack import Attack, Attacker
from .malformed import damaged

RATE = 3000


def message(chance: random.Random) -> bytes:
    """A datagram of one of both versions."""
    payload = chance.randbytes(chance.randrange(60))
    source = chance.choice((STRANGER, OPERATOR))
    size = len(payload) | chance.randrange(16) << 12
    code = chance.choice((0, 0x2B00, chance.randrange(65536)))
    ids = int(ROBOT), int(source)
    ra = struct.pack("<BBHIIHH", chance.randrange(256), 2, code, *ids, size, chance.randrange(65536)) + payload
    if chance.random() < 0.5:
        return legacy.OPC_GREETING + ra
    return b"\x01\0\0" + struct.pack(">H", len(ra)) + ra


def run(arena: Arena) -> None:
    """Half of them are damaged."""
    sock = arena.open(arena.attacker.udp())
    for number in arena.paced(RATE):
        data = message(arena.chance)
        arena.send(sock, damaged(arena.chance, data) if number % 2 else data)


ATTACK = Attack("legacy-headers", Attacker.REMOTE, "datagrams", run)
