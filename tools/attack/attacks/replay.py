"""Replays on a network with a key: everything that was recorded, in any order, damaged, and to the other side."""

from __future__ import annotations

import socket
from collections.abc import Iterator

from ..arena import Arena
from ..attack import Attack, Attacker, Layout, NotPossible
from ..stage import PORT
from .malformed import damaged

RATE = 3000
MAX_RECORDED = 2000
_ALL_FRAMES = 3
_HEADERS = 14 + 20 + 8
"""Bytes of Ethernet, IP and UDP before a datagram."""
_SOURCE = slice(26, 30)
"""The source address of IP."""


def recorder(arena: Arena) -> socket.socket:
    """Hears all frames of the operator's machine; raises `NotPossible`."""
    try:
        with arena.hosts["operator"].entered():
            sock = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(_ALL_FRAMES))
    except PermissionError:
        raise NotPossible("needs root, to record packets") from None
    sock.setblocking(False)
    return sock


def heard(sock: socket.socket, source: bytes) -> Iterator[bytes]:
    """The datagrams of one IPv4 address that have passed."""
    try:
        while True:
            frame = sock.recv(70000)
            if frame[_SOURCE] == source:
                yield frame[_HEADERS:]
    except BlockingIOError:
        pass


def record(sock: socket.socket, known: list[bytes], source: bytes) -> None:
    """Add the authenticated datagrams of an address that have passed; the newest are kept."""
    known += (data for data in heard(sock, source) if data[:1] == b"\xa5")
    del known[:-MAX_RECORDED]


def run(arena: Arena) -> None:
    """From another address, so that learning it would divert the answers, and as if from the address of the sender."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    forger = arena.open(arena.attacker.forger())
    sniffer = arena.open(recorder(arena))
    recorded: list[bytes] = []
    operator = (arena.hosts["operator"].address, PORT)
    for number in arena.paced(RATE):
        if number % 10 == 0:
            record(sniffer, recorded, socket.inet_aton(operator[0]))
        if not recorded:
            continue
        data = chance.choice(recorded)
        if number % 3 == 0:
            arena.sent += 1
            forger.send(data, operator, arena.where)
            continue
        arena.send(sock, damaged(chance, data) if number % 4 == 0 else data, arena.where if number % 2 else operator)
    arena.require(arena.sent > 0, "nothing could be recorded")


ATTACK = Attack("replay", Attacker.REMOTE, "datagrams", run, layout=Layout(keyed=True))
