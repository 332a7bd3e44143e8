"""Files of the console: users with costly hashes and forged names, poses and trajectories that do not end."""

from __future__ import annotations

import random

from ..attack import Attack, Attacker, Bounds, Layout, Victims
from ..files import FileKind, Make, attacked_by, damaged, noise, several

HASH = "$argon2id$v=19$m={memory},t={iterations},p={lanes}$AAAAAAAAAAAAAAAAAAAAAA$" + "A" * 43
USERS = f"[users.anna]\nrole = 'operator'\npassword = '{HASH.format(memory=1024, iterations=1, lanes=1)}'\n".encode()
POSES = b"[inc1.stowed]\nelbow = 2.0\n"
SAVED = b'{"joints": ["elbow"], "rows": [{"seconds": 1.0, "positions": [0.5]}]}'


def costly(memory: int, iterations: int, lanes: int) -> Make:
    """A hash whose verification takes so much KiB, and so many iterations."""
    text = HASH.format(memory=memory, iterations=iterations, lanes=lanes)
    return lambda _: f"[users.anna]\nrole = 'operator'\npassword = '{text}'\n".encode()


def named(name: str) -> Make:
    """A user of this name."""
    return lambda _: USERS.replace(b"anna", f'"{name}"'.encode())


def dotted(_: random.Random) -> bytes:
    """A key of a hundred thousand parts."""
    return b"a" + b".a" * 100_000 + b" = 1\n"


def nested(opening: bytes) -> Make:
    """Deep nesting."""
    return lambda _: opening * 20_000


def digits(_: random.Random) -> bytes:
    """A number of 5000 digits."""
    return b"[inc1.stowed]\nelbow = " + b"9" * 5000


HOSTILE_USERS: dict[str, Make] = {
    **several("a damaged file", damaged(USERS), 5),
    "64 GB": costly(64 << 20, 3, 4),
    "1 GB": costly((1 << 20) - 1, 3, 4),
    "99 iterations": costly(1 << 17, 99, 4),
    "escapes in a name": named("\\u001b]0;x"),
    "HTML in a name": named("<img src=x onerror=alert(1)>"),
    "a forged line": named("anna] has logged in"),
    "a dotted key": dotted,
    "a long number": digits,
    "noise": noise,
}
HOSTILE_POSES: dict[str, Make] = {
    **several("a damaged file", damaged(POSES), 5),
    "NaN": lambda _: POSES.replace(b"2.0", b"nan"),
    "path parts": lambda _: b'[inc1."../../x"]\na = 1\n',
    "nested lists": nested(b"a = [["),
    "a dotted key": dotted,
    "a long number": digits,
    "noise": noise,
}
HOSTILE_SAVED: dict[str, Make] = {
    **several("a damaged file", damaged(SAVED), 5),
    "nested lists": nested(b"["),
    "nested objects": nested(b'{"poses":'),
    "NaN": lambda _: SAVED.replace(b"0.5", b"NaN"),
    "infinity": lambda _: SAVED.replace(b"0.5", b"1e999"),
    "a long key": lambda _: b'{"' + b"x" * 500_000 + b'": 1}',
    "noise": noise,
}
ATTACK = Attack(
    "console-files",
    Attacker.AUTHOR,
    "files",
    attacked_by(
        FileKind("users", ".toml", USERS, HOSTILE_USERS),
        FileKind("poses", ".toml", POSES, HOSTILE_POSES),
        FileKind("saved", ".json", SAVED, HOSTILE_SAVED),
    ),
    Bounds(memory=400.0),
    layout=Layout(Victims.COMMANDS),
)
