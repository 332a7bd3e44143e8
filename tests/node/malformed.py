"""Datagrams that nobody can read, the same ones for the same seed. Each breaks one rule of the header."""

import random
import struct
from collections.abc import Callable, Iterator

HERE, STRANGER = bytes.fromhex("01016500"), bytes.fromhex("01012b00")
RA_CODE = 0x1234


def packet(chance: random.Random, *, flags: int = 0, size: int | None = None, extra: bytes = b"") -> bytes:
    body = bytes([chance.randrange(256)]) + HERE + STRANGER + chance.randbytes(chance.randrange(60)) + b"\x01\x00"
    return struct.pack("<BBH", 2, flags, len(extra + body) + 3 if size is None else size) + extra + body


def ra(chance: random.Random, *, version: int = 2, size: int | None = None, control: int = 0) -> bytes:
    payload = chance.randbytes(chance.randrange(40))
    data = (len(payload) if size is None else size) | control << 12
    return struct.pack("<BBH", 6, version, RA_CODE) + HERE + STRANGER + struct.pack("<HH", data, 1) + payload


def old(body: bytes, length: int | None = None, compression: bytes = b"\0\0") -> bytes:
    return b"\x01" + compression + struct.pack(">H", len(body) if length is None else length) + body


def unknown_version(chance: random.Random) -> bytes:
    first = chance.choice([each for each in range(256) if each not in (1, 2, 0x4A, 0xA5)])
    return bytes([first]) + chance.randbytes(chance.randrange(1, 200))


def cut_off(chance: random.Random) -> bytes:
    whole = packet(chance)
    return whole[: chance.randrange(1, len(whole))]


def too_small(chance: random.Random) -> bytes:
    return packet(chance, size=chance.randrange(14))


def too_large(chance: random.Random) -> bytes:
    return packet(chance, size=chance.randrange(200, 65536))


def reserved_type(chance: random.Random) -> bytes:
    return packet(chance, flags=chance.randrange(1, 64))


def compressed_by_an_unknown_template(chance: random.Random) -> bytes:
    return packet(chance, flags=0xC0, extra=chance.randbytes(2))


def compression_cut_off(chance: random.Random) -> bytes:
    return packet(chance, flags=chance.choice((0x40, 0x80)), size=chance.randrange(16))


def followed_by_rubbish_only(chance: random.Random) -> bytes:
    return packet(chance, flags=chance.randrange(1, 64)) + packet(chance)[1:]


def old_cut_off(chance: random.Random) -> bytes:
    whole = old(ra(chance))
    return whole[: chance.randrange(1, len(whole))]


def old_with_a_wrong_size(chance: random.Random) -> bytes:
    return old(ra(chance, size=chance.randrange(100, 4096)))


def old_with_a_wrong_length(chance: random.Random) -> bytes:
    return old(ra(chance), length=chance.randrange(200, 65536))


def old_of_an_unknown_version(chance: random.Random) -> bytes:
    return old(ra(chance, version=chance.choice([0, 1, *range(3, 256)])))


def old_with_an_unknown_control(chance: random.Random) -> bytes:
    return old(ra(chance, control=chance.choice([3, 5, 6, 7, *range(9, 16)])))


def old_and_compressed(chance: random.Random) -> bytes:
    return old(
        ra(chance), compression=bytes([chance.randrange(256), chance.randrange(64) << 2 | chance.choice((2, 3))])
    )


def opc_cut_off(chance: random.Random) -> bytes:
    return b"JAUS01.0" + ra(chance)[: chance.randrange(16)]


def noise(chance: random.Random) -> bytes:
    return b"\x02\x00\xff\xff" + chance.randbytes(chance.randrange(8000))


KINDS: tuple[Callable[[random.Random], bytes], ...] = (
    unknown_version,
    cut_off,
    too_small,
    too_large,
    reserved_type,
    compressed_by_an_unknown_template,
    compression_cut_off,
    followed_by_rubbish_only,
    old_cut_off,
    old_with_a_wrong_size,
    old_with_a_wrong_length,
    old_of_an_unknown_version,
    old_with_an_unknown_control,
    old_and_compressed,
    opc_cut_off,
    noise,
)


def datagrams(seed: int, count: int) -> Iterator[bytes]:
    """All kinds in turn."""
    chance = random.Random(seed)
    for number in range(count):
        yield KINDS[number % len(KINDS)](chance)
