"""Members of the group of the local sockets: components that never read, come and go, and take ids."""

from __future__ import annotations

import contextlib
import socket
from pathlib import Path

from jauspy.ids import EVERYONE, JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Broadcast, Packet

from ..arena import Arena
from ..attack import Attack, Attacker, Bounds

RATE = 1000
SILENT = 60
"""Components that stay, and never read."""
SIZE = 4000


def component(arena: Arena, folder: Path, id: JausID) -> socket.socket:
    """A component that sends Connect and reads nothing."""
    path = folder / str(int(id))
    path.unlink(missing_ok=True)
    sock = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    sock.setblocking(False)
    sock.bind(str(path))
    arena.send(sock, junior.connect(id), str(folder / junior.SOCKET_NAME))
    return sock


def run(arena: Arena) -> None:
    """Large broadcasts for those who do not read, and components that end without Cancel."""
    folder, chance = arena.root, arena.chance
    silent = [arena.open(component(arena, folder, JausID(101, 7, 1 + number))) for number in range(SILENT)]
    node = str(folder / junior.SOCKET_NAME)
    for number in arena.paced(RATE):
        sender = silent[number % SILENT]
        source = JausID(101, 7, 1 + number % SILENT)
        if number % 4 == 0:
            id = JausID(101, 8 + chance.randrange(200), 1 + chance.randrange(250))
            component(arena, folder, id).close()
            if number % 8 == 0:
                (folder / str(int(id))).unlink(missing_ok=True)
        elif number % 4 == 1:
            to_all = Packet(source, JausID(101, 7, 255), bytes(SIZE), number & 0xFFFF, broadcast=Broadcast.LOCAL)
            arena.send(sender, judp.pack(to_all), node)
        elif number % 4 == 2:
            arena.send(sender, chance.randbytes(chance.randrange(1, 300)), node)
        else:
            unknown = JausID(chance.randrange(200, 60000), 1, 1)
            arena.send(sender, judp.pack(Packet(source, unknown, bytes(SIZE), number & 0xFFFF)), node)
    with contextlib.suppress(OSError):
        arena.send(silent[0], judp.pack(Packet(JausID(101, 7, 1), EVERYONE, b"\x00\x2b\x04")), node)


ATTACK = Attack("local-components", Attacker.LOCAL, "datagrams", run, Bounds(memory=100.0), restarts=True)
