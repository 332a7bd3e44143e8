"""An attacker who has the key: made-up senders and counters, ids of others, and damaged packets, all authenticated."""

from __future__ import annotations

import contextlib
import socket
import time
from collections.abc import Mapping

from jauspy.errors import ProtocolError
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
    """Each datagram has another sender; those that are challenged answer."""
    chance, sock = arena.chance, arena.open(arena.attacker.udp())
    senders: dict[int, Authenticator] = {}
    for number in arena.paced(RATE):
        source = chance.choice((OPERATOR, ROBOT, JausID.from_int(chance.randrange(1 << 32))))
        packet = judp.pack(random_packet(chance, source))
        session = chance.randrange(1, _SENDERS)
        sender = senders.setdefault(session, Authenticator(KEY, session))
        clock = time.time() + chance.choice((0.0, 0.0, 29.0, -29.0, 40.0))
        arena.send(sock, sender.sign(damaged(chance, packet) if number % 2 else packet, clock, arena.where))
        answer_challenges(arena, sock, senders)


def answer_challenges(arena: Arena, sock: socket.socket, senders: Mapping[int, Authenticator]) -> None:
    """Pass what has arrived to the sender that it is for, and send what that says."""
    while True:
        try:
            data, (host, port, *_) = sock.recvfrom(70000)
        except BlockingIOError:
            return
        sender = senders.get(int.from_bytes(data[9:17], "big"))
        if sender is None:
            continue
        with contextlib.suppress(ProtocolError):
            sender.verify(data, time.time(), (host, port))
        for _, answer in sender.poll_output():
            arena.send(sock, answer)


ATTACK = Attack("insider", Attacker.INSIDER, "datagrams", run, layout=Layout(keyed=True))
