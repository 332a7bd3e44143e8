"""Scans of a hostile robot, given to the mapper: with as many rays as a message may have, and of any length."""

from __future__ import annotations

import random
import struct

from ..attack import Attack, Attacker, Bounds, Layout, Victims
from ..files import FileKind, Make, attacked_by

_RAY = struct.Struct("<ff")
MAX_RAYS = 65535
_LENGTHS = (0.0, -1.0, 1e-30, 15.0, 1e30, float("inf"), float("-inf"))


def rays(count: int, length: float) -> bytes:
    """So many rays of this length, all around."""
    return b"".join(_RAY.pack(6.28 * number / count, length) for number in range(count))


def scan(count: int, length: float) -> Make:
    """A scan with so many rays of this length."""
    return lambda _: rays(count, length)


def mixed(chance: random.Random) -> bytes:
    """Rays of any length and direction."""
    angles = (0.0, 3.0, 1e30, -1e30)
    return b"".join(_RAY.pack(chance.choice(angles), chance.choice(_LENGTHS)) for _ in range(1000))


HONEST = rays(360, 3.0)
HOSTILE: dict[str, Make] = {
    **{f"a scan with {MAX_RAYS} rays of {length:g} m": scan(MAX_RAYS, length) for length in _LENGTHS},
    "a scan with rays of any length": mixed,
    "no rays": lambda _: b"",
}
ATTACK = Attack(
    "scans",
    Attacker.REMOTE,
    "scans",
    attacked_by(FileKind("scan", ".scan", HONEST, HOSTILE)),
    Bounds(memory=400.0),
    layout=Layout(Victims.COMMANDS),
)
