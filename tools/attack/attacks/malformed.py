"""Damaged datagrams by UDP, IPv4: cut off, with wrong sizes and types, joined, with flipped bits, and noise."""

from __future__ import annotations

import random

from jauspy.ids import JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Ack, Broadcast, DataFlag, Packet, Priority

from ..arena import ROBOT, STRANGER, Arena
from ..attack import Attack, Attacker

RATE = 4000


def random_packet(chance: random.Random, source: JausID = STRANGER, destination: JausID = ROBOT) -> Packet:
    """A packet with a random payload and random flags."""
    return Packet(
        source,
        destination,
        chance.randbytes(chance.randrange(80)),
        chance.randrange(65536),
        chance.choice(list(Priority)),
        broadcast=chance.choice(list(Broadcast)),
        ack=chance.choice(list(Ack)),
        data_flag=chance.choice(list(DataFlag)),
    )


def damaged(chance: random.Random, data: bytes) -> bytes:
    """The same bytes, damaged in one of several ways."""
    kind = chance.randrange(7)
    if kind == 0:
        return data[: chance.randrange(1, len(data))]
    if kind == 1:
        at = chance.randrange(len(data))
        return data[:at] + bytes([data[at] ^ 1 << chance.randrange(8)]) + data[at + 1 :]
    if kind == 2:
        return data[:2] + chance.randbytes(2) + data[4:]
    if kind == 3:
        return data[:1] + chance.randbytes(1) + data[2:]
    if kind == 4:
        return data + data[1 : chance.randrange(1, len(data))]
    if kind == 5:
        return chance.choice((b"\x01", b"\xa5", b"JAUS01.0", b"\x02\xc0")) + data[1:]
    return chance.randbytes(chance.randrange(1, 300))


def run(arena: Arena) -> None:
    """Every datagram is damaged in another way."""
    sock = arena.open(arena.attacker.udp())
    for _ in arena.paced(RATE):
        arena.send(sock, damaged(arena.chance, judp.pack(random_packet(arena.chance))))


ATTACK = Attack("malformed", Attacker.REMOTE, "datagrams", run)
