"""Configurations and address books of the node manager: TOML, XML and YAML with objects, aliases and wrong values."""

from __future__ import annotations

import random

from ..attack import Attack, Attacker, Bounds, Layout, Victims
from ..files import CANARY, FileKind, Make, attacked_by, damaged, noise, several

TOML = b'address = "127.0.0.1"\nport = 3794\n[addresses]\n"101.1.255" = "udp://10.0.0.5:3794"\n'
XML = b'<?xml version="1.0"?><Configuration><AddressBook J8257803="10.0.0.5:3794"/></Configuration>'
YAML = b'addrbook:\n  udp:\n    "10.0.0.5:3794": 101.1.255\n'


def aliases(_: random.Random) -> bytes:
    """Lists of lists that are 10**9 long."""
    lines = ["a0: &a0 [101.1.1]"]
    lines += [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]" for n in range(1, 10)]
    return ("\n".join(lines) + '\naddrbook:\n  udp:\n    "10.0.0.5:3794": *a9\n').encode()


def yaml_object(_: random.Random) -> bytes:
    """An object that is made by a call."""
    return b"addrbook: !!python/object/apply:os.mknod [" + CANARY.encode() + b"]\n"


def entities(_: random.Random) -> bytes:
    """Entities that grow to gigabytes."""
    names = [f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 12)]
    head = f'<?xml version="1.0"?><!DOCTYPE c [<!ENTITY e0 "ha">{"".join(names)}]>'
    return head.encode() + b'<c><AddressBook J1="&e11;"/></c>'


def many(_: random.Random) -> bytes:
    """50,000 entries."""
    return b"<c>" + b"".join(b'<AddressBook J%d="10.0.0.5:%d"/>' % (n + 1, n + 1) for n in range(50_000)) + b"</c>"


def with_line(line: bytes) -> Make:
    """A configuration with one more setting."""
    return lambda _: line + b"\n" + TOML


def deep(opening: bytes, closing: bytes) -> Make:
    """Deep nesting."""
    return lambda _: opening * 20_000 + closing * 20_000


HOSTILE_TOML: dict[str, Make] = {
    **several("a damaged file", damaged(TOML), 5),
    "nested lists": with_line(b"networks = " + b"[" * 5000 + b"]" * 5000),
    "a huge number": with_line(b"receive_buffer = " + b"9" * 4000),
    "a key in /dev/zero": with_line(b'key_file = "/dev/zero"'),
    "an address book in /dev/zero": with_line(b'address_books = ["/dev/zero"]'),
    "noise": noise,
}
HOSTILE_XML: dict[str, Make] = {
    **several("a damaged file", damaged(XML), 5),
    "entities that grow": entities,
    "50,000 entries": many,
    "nested elements": deep(b"<a>", b"</a>"),
    "noise": noise,
}
HOSTILE_YAML: dict[str, Make] = {
    **several("a damaged file", damaged(YAML), 5),
    "an object": yaml_object,
    "aliases that grow": aliases,
    "nested lists": deep(b"[", b"]"),
    "noise": noise,
}
ATTACK = Attack(
    "configurations",
    Attacker.AUTHOR,
    "files",
    attacked_by(
        FileKind("node_manager", ".toml", TOML, HOSTILE_TOML),
        FileKind("addresses", ".cfg", XML, HOSTILE_XML),
        FileKind("addresses", ".yaml", YAML, HOSTILE_YAML),
    ),
    Bounds(memory=400.0),
    layout=Layout(Victims.COMMANDS),
)
