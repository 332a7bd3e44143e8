"""Fragments of large messages that never end, begin in the middle, overlap, or repeat with the same bytes."""

from __future__ import annotations

from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, DataFlag, Packet

from ..arena import ROBOT, STRANGER, Arena
from ..attack import Attack, Attacker, Bounds

RATE = 3000
SIZE = 1200
_FLAGS = (DataFlag.FIRST, DataFlag.MIDDLE, DataFlag.MIDDLE, DataFlag.LAST)
_BACKWARDS = ((0, DataFlag.MIDDLE), (1, DataFlag.MIDDLE), (1, DataFlag.FIRST), (0, DataFlag.LAST))


def run(arena: Arena) -> None:
    """In turn: whole patterns of one stranger with the same bytes, and random fragments of 300 strangers."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    sequence = 0
    for number in arena.paced(RATE):
        if number % 2:
            source = JausID(4300 + chance.randrange(300), 1, 1)
            flag, at, payload = chance.choice(_FLAGS), chance.randrange(65536), chance.randbytes(SIZE)
        else:
            step, flag = _BACKWARDS[number // 2 % len(_BACKWARDS)]
            sequence += step == 0
            source, at, payload = STRANGER, sequence + step, bytes(SIZE)
        ack = chance.choice((Ack.NONE, Ack.REQUIRED))
        arena.send(sock, judp.pack(Packet(source, ROBOT, payload, at & 0xFFFF, ack=ack, data_flag=flag)))


ATTACK = Attack("fragments", Attacker.REMOTE, "datagrams", run, Bounds(memory=32.0))
