"""The same by IPv6: damaged datagrams and made-up ids, to the address and to the group of the link."""

from __future__ import annotations

import socket

from jauspy.ids import JausID
from jauspy.protocol import judp

from ..arena import OPERATOR, ROBOT, Arena
from ..attack import Attack, Attacker, NotPossible
from ..stage import MULTICAST6, PORT
from .malformed import damaged, random_packet

RATE = 3000


def run(arena: Arena) -> None:
    """Unicasts and multicasts, from one address."""
    chance, host = arena.chance, arena.attacker
    try:
        sock = arena.open(host.udp(host.address6))
    except OSError as error:
        raise NotPossible(f"this machine has no IPv6: {error.strerror}") from None
    interface = "eth0" if arena.has_namespaces else "lo"
    with host.entered():
        sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_IF, socket.if_nametoindex(interface))
    targets = ((arena.hosts["robot"].address6, PORT), (MULTICAST6, PORT))
    for number in arena.paced(RATE):
        source = JausID.from_int(chance.randrange(1 << 32))
        if source in (OPERATOR, ROBOT):
            continue
        data = judp.pack(random_packet(chance, source))
        arena.send(sock, damaged(chance, data) if number % 3 else data, targets[number % 2])


ATTACK = Attack("ipv6", Attacker.REMOTE, "datagrams", run)
