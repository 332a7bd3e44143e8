"""Replays on a network with a key: everything that was recorded, in any order, damaged, and to the other side."""

from __future__ import annotations

import socket

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


def record(sock: socket.socket, known: list[bytes], own: bytes) -> None:
    """Add the authenticated datagrams of others that have passed; the newest are kept."""
    try:
        while True:
            frame = sock.recv(70000)
            data = frame[_HEADERS:]
            if data[:1] == b"\xa5" and frame[_SOURCE] != own:
                known.append(data)
    except BlockingIOError:
        del known[:-MAX_RECORDED]


def run(arena: Arena) -> None:
    """From another address, so that learning it would divert the answers."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    sniffer = arena.open(recorder(arena))
    recorded: list[bytes] = []
    operator = (arena.hosts["operator"].address, PORT)
    for number in arena.paced(RATE):
        if number % 10 == 0:
            record(sniffer, recorded, socket.inet_aton(arena.attacker.address))
        if not recorded:
            continue
        data = chance.choice(recorded)
        arena.send(sock, damaged(chance, data) if number % 4 == 0 else data, arena.where if number % 3 else operator)
    arena.require(arena.sent > 0, "nothing could be recorded")


ATTACK = Attack("replay", Attacker.REMOTE, "datagrams", run, layout=Layout(keyed=True))
