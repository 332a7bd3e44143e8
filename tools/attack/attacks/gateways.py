"""Two gateways between the same two networks: broadcasts must not go round, not even when there are too many of them.

More broadcasts are sent than a gateway remembers, so that echoes come back to a full table.
"""

from __future__ import annotations

import contextlib
import socket
import struct
import time

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Broadcast, Packet

from ..arena import OPERATOR, Arena
from ..attack import Attack, Attacker, Layout, NotPossible, Victims
from ..stage import MULTICAST, PORT

RATE = 2000
_BETWEEN = 40
"""Broadcasts between two messages of the honest operator."""
COMPONENT = JausID.parse("101.1.50")
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


class Pair:
    """An operator outside, and a component behind one of the gateways, which counts what it receives from there."""

    def __init__(self, arena: Arena) -> None:
        self._arena = arena
        self._operator = arena.open(arena.hosts["operator"].udp())
        self._component = arena.open(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
        self._component.setblocking(False)
        self._component.bind(str(arena.root / str(int(COMPONENT))))
        self._component.sendto(junior.connect(COMPONENT), str(arena.root / junior.SOCKET_NAME))
        self._expected: set[bytes] = set()

    def send(self) -> None:
        """Send the next message."""
        data = judp.pack(Packet(OPERATOR, COMPONENT, b"\x02\x20", self._arena.asked & 0xFFFF))
        self._arena.asked += 1
        self._expected.add(data)
        self._operator.sendto(data, self._arena.where)

    def receive(self) -> None:
        """Count what has arrived."""
        with contextlib.suppress(BlockingIOError):
            while True:
                self._expected.discard(self._component.recv(70000))
        self._arena.lost = len(self._expected)


def run(arena: Arena) -> None:
    """From both networks; what is heard on the other one is counted."""
    host = arena.attacker
    if not host.second:
        raise NotPossible("two networks with two gateways need network namespaces")
    heard, pair = arena.open(listener(arena, host.second)), Pair(arena)
    first, second = arena.open(host.udp(host.address)), arena.open(host.udp(host.second))
    copies = 0
    for number in arena.paced(RATE):
        inside = number % 2
        source = JausID(101 if inside else 43, 1 + number % 200, 1 + number // 200 % 200)
        packet = Packet(source, EVERYONE, b"\x00\x2b\x04", number & 0xFFFF, broadcast=Broadcast.GLOBAL)
        arena.send(second if inside else first, judp.pack(packet), (MULTICAST, PORT))
        copies += drain(heard)
        pair.receive()
        if number % _BETWEEN == 0:
            pair.send()
    time.sleep(QUIET_TIME)
    copies += drain(heard)
    pair.receive()
    time.sleep(1.0)
    left = drain(heard)
    arena.require(left == 0, f"{left} broadcasts a second still go round {QUIET_TIME:g} s after the attack")
    arena.require(
        copies <= MAX_COPIES * arena.sent, f"{copies} broadcasts on one network for {arena.sent} that were sent"
    )


ATTACK = Attack("two-gateways", Attacker.REMOTE, "broadcasts", run, layout=Layout(Victims.GATEWAYS))
