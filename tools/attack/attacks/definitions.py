"""JSIDL definitions: text that leaves a string, entities, deep nesting, huge numbers."""

from __future__ import annotations

import random
from pathlib import Path

from lxml import etree

from ..attack import Attack, Attacker, Bounds, Layout, Victims
from ..files import CANARY, EXPRESSION, FileKind, Make, attacked_by, damaged, noise, several

HONEST = (Path(__file__).parents[3] / "tests/vendor/Lamp.xml").read_bytes()
_QUOTES = ('"""', "'''", '"', "'", "\\", '\\"""', "", "}", ")", "]", "\u2028", "²")
_BETWEEN = ("\n", ";", ",", " or ", "\r", "\x85")


def hostile_text(chance: random.Random) -> bytes:
    """An expression between quotes in one attribute or text, of the service itself in a third of the files."""
    root = etree.fromstring(HONEST)
    elements = [root] if chance.random() < 1 / 3 else list(root.iter("*"))
    element = chance.choice(elements)
    quote, between = chance.choice(_QUOTES), chance.choice(_BETWEEN)
    text = f"{chance.choice(('', 'a'))}{quote}{between}{EXPRESSION}{between}{quote}"
    names = [*element.attrib, *([None] if (element.text or "").strip() else [])]
    name = chance.choice(names) if names else None
    if name is None:
        element.text = text.replace("\x85", " ")
    else:
        element.set(name, text)
    return etree.tostring(root)


def entities(_: random.Random) -> bytes:
    """Entities that grow to gigabytes."""
    names = [f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 12)]
    head = f'<?xml version="1.0"?><!DOCTYPE s [<!ENTITY e0 "ha">{"".join(names)}]>'
    return head.encode() + HONEST[HONEST.index(b"<service_def") :].replace(b"<description>", b"<description>&e11;", 1)


def external(_: random.Random) -> bytes:
    """An entity that is a file of this machine."""
    head = b'<?xml version="1.0"?><!DOCTYPE s [<!ENTITY f SYSTEM "file:///etc/passwd">]>'
    return head + HONEST[HONEST.index(b"<service_def") :].replace(b"<description>", b"<description>&f;", 1)


def nested(_: random.Random) -> bytes:
    """Sequences in sequences."""
    depth = 5000
    opening, closing = b'<sequence name="s" optional="false">' * depth, b"</sequence>" * depth
    at = HONEST.index(b"<record", HONEST.index(b"<body"))
    end = HONEST.index(b"</record>", at) + len(b"</record>")
    return HONEST[:at] + opening + HONEST[at:end] + closing + HONEST[end:]


def large_numbers(chance: random.Random) -> bytes:
    """Counts, sizes and ids far beyond any range."""
    number = chance.choice((b"9" * 5000, b"-1", b"1e400", b"0x", b"NaN", b"4294967295"))
    mark = chance.choice((b'message_id="', b'_count="', b'_limit="', b'index="', b'from_index="'))
    at = HONEST.find(mark)
    at = HONEST.index(b'message_id="') + 12 if at < 0 else at + len(mark)
    return HONEST[:at] + number + HONEST[HONEST.index(b'"', at) :]


def path_as_name(chance: random.Random) -> bytes:
    """Names that are paths out of the folder."""
    name = chance.choice((b"../../" + CANARY.encode(), b"/" + CANARY.encode(), b"..", b"a/../../b"))
    at = HONEST.index(b'name="') + 6
    data = HONEST[:at] + name + HONEST[HONEST.index(b'"', at) :]
    at = data.index(b' id="') + 5
    return data[:at] + b"urn:x:" + name + data[data.index(b'"', at) :]


HOSTILE: dict[str, Make] = {
    **several("a text with an expression", hostile_text, 40),
    **several("a damaged file", damaged(HONEST), 3),
    "entities that grow": entities,
    "an external entity": external,
    "5000 nested sequences": nested,
    **several("a number out of range", large_numbers, 3),
    **several("a path as a name", path_as_name, 2),
    "noise": noise,
}
ATTACK = Attack(
    "definitions",
    Attacker.AUTHOR,
    "files",
    attacked_by(FileKind("definition", ".xml", HONEST, HOSTILE)),
    Bounds(memory=400.0),
    layout=Layout(Victims.COMMANDS),
)
