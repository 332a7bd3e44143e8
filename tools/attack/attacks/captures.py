"""Captures for `jauspy decode`: damaged, with sizes that do not fit, and with escape sequences of a terminal."""

from __future__ import annotations

import random
import struct

from jauspy.ids import JausID
from jauspy.messages.core import ReportIdentification
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

from ..attack import Attack, Attacker, Bounds, Layout, Victims
from ..files import FileKind, Make, attacked_by, damaged, noise, several

_GLOBAL = struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, 101)
ESCAPE = b"\x1b]0;owned\x07\x1b[2J"


def record(data: bytes) -> bytes:
    """A JUDP datagram as a record of a pcap file, in IPv4."""
    udp = struct.pack("!HHHH", 3794, 3794, 8 + len(data), 0) + data
    ip = struct.pack("!BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), 0, 0, 64, 17, 0, b"\x0a\0\0\1", b"\x0a\0\0\2") + udp
    return struct.pack("<IIII", 1, 0, len(ip), len(ip)) + ip


def capture(*payloads: bytes) -> bytes:
    """A pcap file with these messages."""
    ids = JausID.parse("101.1.1"), JausID.parse("42.1.1")
    return _GLOBAL + b"".join(record(judp.pack(Packet(*ids, payload, n))) for n, payload in enumerate(payloads))


def _named(name: bytes) -> bytes:
    payload = ReportIdentification(1, 10001, "X" * len(name)).encode()
    return payload.replace(b"X" * len(name), name)


HONEST = capture(_named(b"robot"), b"\x02\x20")


def huge_record(_: random.Random) -> bytes:
    """A record of 4 GB in a small file."""
    return HONEST + struct.pack("<IIII", 1, 0, 0xFFFFFFFF, 0xFFFFFFFF) + bytes(100)


def pcapng(chance: random.Random) -> bytes:
    """A pcapng file whose blocks have wrong sizes."""
    section = struct.pack("<IIIHHqI", 0x0A0D0D0A, 28, 0x1A2B3C4D, 1, 0, -1, 28)
    interface = struct.pack("<IIHHII", 1, 20, 101, 0, 65535, 20)
    size = chance.choice((0, 1, 12, 13, 0x7FFFFFFC, 0xFFFFFFFF))
    return section + interface + struct.pack("<II", 6, size) + bytes(60)


def many_fragments(chance: random.Random) -> bytes:
    """IP fragments that never make a packet."""
    data = [_GLOBAL]
    for number in range(20_000):
        place = chance.randrange(8000) | 0x2000
        head = struct.pack("!BBHHHBB", 0x45, 0, 28, number % 70, place, 64, 17)
        ip = head + b"\0\0\x0a\0\0\1\x0a\0\0\2" + bytes(8)
        data.append(struct.pack("<IIII", 1, 0, len(ip), len(ip)) + ip)
    return b"".join(data)


def deep(_: random.Random) -> bytes:
    """Messages in messages: events of events."""
    payload = b"\x02\x20"
    for _number in range(400):
        payload = b"\xf0\x01\x00\x00\x00\x00" + struct.pack("<I", len(payload)) + payload
    return capture(payload)


def escapes(_: random.Random) -> bytes:
    """A name with escape sequences."""
    return capture(_named(ESCAPE))


def big_list(_: random.Random) -> bytes:
    """Messages that say that they have 65535 elements."""
    return capture(b"\x00\x4b\xff", b"\x03\x48\xff\xff" + bytes(3000), b"\x00\x4b" + b"\xff" * 3000)


HOSTILE: dict[str, Make] = {
    **several("a damaged file", damaged(HONEST), 10),
    "a record of 4 GB": huge_record,
    **several("a pcapng file with wrong sizes", pcapng, 4),
    "20,000 IP fragments": many_fragments,
    "400 messages in messages": deep,
    "a name with escape sequences": escapes,
    "lists that are too long": big_list,
    "noise": noise,
}
ATTACK = Attack(
    "captures",
    Attacker.AUTHOR,
    "files",
    attacked_by(FileKind("decode", ".pcap", HONEST, HOSTILE)),
    Bounds(memory=400.0),
    layout=Layout(Victims.COMMANDS),
)
