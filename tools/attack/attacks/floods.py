"""Valid messages as fast as one process can send them: of standard priority, and of the highest.

The attacker has a processor of its own, as on a machine of its own, and the victims have the others.
"""

from __future__ import annotations

from jauspy.messages.mobility import QueryLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet, Priority

from ..arena import ROBOT, STRANGER, Arena
from ..attack import Attack, Attacker, Bounds, Layout

UNLIMITED = 1e9
BOUNDS = Bounds(lost=0.05, silence=2.0)


def run(arena: Arena, priority: Priority) -> None:
    """Queries of one stranger; the robot answers those that reach it."""
    sock = arena.open(arena.attacker.udp())
    datagrams = [
        judp.pack(Packet(STRANGER, ROBOT, QueryLocalPose(0x1FF).encode(), number, priority)) for number in range(4096)
    ]
    with arena.stage.apart():
        for number in arena.paced(UNLIMITED):
            arena.send(sock, datagrams[number % len(datagrams)])


def _standard(arena: Arena) -> None:
    run(arena, Priority.STANDARD)


def _urgent(arena: Arena) -> None:
    run(arena, Priority.SAFETY_CRITICAL)


STANDARD = Attack("flood", Attacker.REMOTE, "datagrams", _standard, BOUNDS)
URGENT = Attack("urgent-flood", Attacker.REMOTE, "datagrams", _urgent, BOUNDS)
LIMITED = Attack(
    "limited-urgent-flood",
    Attacker.REMOTE,
    "datagrams",
    _urgent,
    # all of it is read, so that the receive buffer overflows: a fifth is lost at 120,000 a second, 40 % at 220,000
    Bounds(lost=0.5, silence=2.0),
    layout=Layout(settings={"rate_limit": 500.0}),
)
