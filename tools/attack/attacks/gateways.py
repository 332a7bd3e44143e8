"""Two gateways between the same two networks: broadcasts must not go round, not even when there are too many of them.

More broadcasts are sent than a gateway remembers, so that echoes come back to a full table.
"""

from __future__ import annotations

import socket
import struct
import time

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp
from jauspy.protocol.header import Broadcast, Packet

from ..arena import Arena
from ..attack import Attack, Attacker, Layout, NotPossible, Victims
from ..stage import MULTICAST, PORT

RATE = 3000
QUIET_TIME = 3.0
"""Seconds after which nothing of the attack may be on the networks any more."""
MAX_COPIES = 4
"""Of each broadcast on the other network: one by each gateway, and one that each of them has not recognised."""


def listener(arena: Arena, address: str) -> socket.socket:
    """Hears the group on the network of this address."""
    with arena.attacker.entered():
        sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        sock.setblocking(False)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 24)
        sock.bind((MULTICAST, PORT))
        member = socket.inet_aton(MULTICAST) + socket.inet_aton(address)
        sock.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, member)
        sock.setsockopt(socket.IPPROTO_IP, 49, struct.pack("i", 0))  # IP_MULTICAST_ALL: only this network
    return sock


def drain(sock: socket.socket) -> int:
    """How many datagrams have arrived."""
    count = 0
    try:
        while sock.recv(70000):
            count += 1
    except BlockingIOError:
        return count
    return count


def run(arena: Arena) -> None:
    """From both networks; what is heard on the other one is counted."""
    host = arena.attacker
    if not host.second:
        raise NotPossible("two networks with two gateways need network namespaces")
    heard = arena.open(listener(arena, host.second))
    first, second = arena.open(host.udp(host.address)), arena.open(host.udp(host.second))
    copies = 0
    for number in arena.paced(RATE):
        inside = number % 2
        source = JausID(101 if inside else 43, 1 + number % 200, 1 + number // 200 % 200)
        packet = Packet(source, EVERYONE, b"\x00\x2b\x04", number & 0xFFFF, broadcast=Broadcast.GLOBAL)
        arena.send(second if inside else first, judp.pack(packet), (MULTICAST, PORT))
        copies += drain(heard)
    time.sleep(QUIET_TIME)
    copies += drain(heard)
    time.sleep(1.0)
    left = drain(heard)
    arena.require(left == 0, f"{left} broadcasts a second still go round {QUIET_TIME:g} s after the attack")
    arena.require(
        copies <= MAX_COPIES * arena.sent, f"{copies} broadcasts on one network for {arena.sent} that were sent"
    )


ATTACK = Attack("two-gateways", Attacker.REMOTE, "broadcasts", run, layout=Layout(Victims.GATEWAYS))
