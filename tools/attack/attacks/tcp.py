"""JTCP: connections that say nothing, little, or nonsense, as many as one host can open."""

from __future__ import annotations

import contextlib
import socket
import time

from jauspy.ids import JausID
from jauspy.messages.mobility import QueryLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

from ..arena import ROBOT, Arena
from ..attack import Attack, Attacker
from ..hosts import Host
from .malformed import damaged, random_packet

RATE = 300
KEPT = 200
"""Connections that stay open."""
HONEST_INTERVAL = 0.5
TIMEOUT = 2.0
HONEST = JausID.parse("44.1.1")


def connect(host: Host, where: tuple[str, int]) -> socket.socket:
    """A connection from a machine; raises `OSError`."""
    with host.entered():
        sock = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    sock.settimeout(TIMEOUT)
    try:
        sock.bind((host.address, 0))
        sock.connect(where)
    except OSError:
        sock.close()
        raise
    return sock


def is_answered(host: Host, where: tuple[str, int]) -> bool:
    """True when a query by a new connection is answered."""
    query = judp.pack(Packet(HONEST, ROBOT, QueryLocalPose(1).encode(), 1))
    try:
        with connect(host, where) as sock:
            sock.sendall(query)
            return len(sock.recv(100)) > 0
    except OSError:
        return False


def run(arena: Arena) -> None:
    """A third stays idle, a third sends bytes one by one, a third sends nonsense."""
    chance = arena.chance
    kept: list[socket.socket] = []
    due = time.monotonic()
    for number in arena.paced(RATE):
        with contextlib.suppress(OSError):
            kept.append(sock := arena.open(connect(arena.attacker, arena.where)))
            sock.setblocking(False)
            if number % 3 == 1:
                sock.send(b"\x02")
            elif number % 3 == 2:
                sock.send(damaged(chance, judp.pack(random_packet(chance))) + chance.randbytes(200))
        arena.sent += 1
        for sock in kept[1::3]:
            with contextlib.suppress(OSError):
                sock.send(b"\0")
        if len(kept) > KEPT:
            kept.pop(chance.randrange(len(kept))).close()
        if time.monotonic() >= due:
            due = time.monotonic() + HONEST_INTERVAL
            arena.asked += 1
            arena.lost += not is_answered(arena.hosts["operator"], arena.where)


ATTACK = Attack("tcp", Attacker.REMOTE, "connections", run)
