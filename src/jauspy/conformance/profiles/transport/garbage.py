"""Bytes that must have no effect."""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Final

from jauspy.conformance.profile import Action
from jauspy.conformance.profiles.raw_packets import UNKNOWN, Hand, alive, by_hand, step
from jauspy.conformance.wire import RAW
from jauspy.messages.core import QueryIdentification
from jauspy.protocol import header

WHO: Final = QueryIdentification(4).encode()


def garbage(make: Callable[[Hand], bytes]) -> Action:
    """Bytes that must have no effect."""

    def trial(hand: Hand) -> None:
        hand.raw(make(hand))
        hand.expect_none("nothing comes back")

    return by_hand(trial)


def borderline(data: bytes) -> Action:
    """A message that some understand and some do not; both is fine, as long as nobody is harmed."""

    def trial(hand: Hand) -> None:
        hand.send(hand.packet(data))
        alive(hand.tester)

    return by_hand(trial)


def whole(hand: Hand) -> bytes:
    """A good datagram."""
    return b"\x02" + header.pack(hand.packet())


def with_byte(offset: int, value: int) -> Callable[[Hand], bytes]:
    """A good datagram with one byte changed."""
    return lambda hand: (data := whole(hand))[:offset] + bytes([value]) + data[offset + 1 :]


def with_size(change: int) -> Callable[[Hand], bytes]:
    """A good datagram whose data size is wrong."""

    def make(hand: Hand) -> bytes:
        data = whole(hand)
        (size,) = struct.unpack_from("<H", data, 2)
        return data[:2] + struct.pack("<H", max(0, size + change)) + data[4:]

    return make


def payload(data: bytes) -> Callable[[Hand], bytes]:
    """A good header around something that is no message."""
    return lambda hand: b"\x02" + header.pack(hand.packet(data))


GARBAGE: Final[tuple[tuple[str, Callable[[Hand], bytes]], ...]] = (
    ("an empty datagram", lambda _: b""),
    ("a version byte alone", lambda _: b"\x02"),
    ("a version that does not exist", with_byte(0, 9)),
    ("a header that is cut off", lambda hand: whole(hand)[:9]),
    ("a packet that is cut off", lambda hand: whole(hand)[:-1]),
    ("a data size of zero", with_size(-0xFFFF)),
    ("a data size above the datagram", with_size(+1)),
    ("a reserved message type", with_byte(1, 5)),
    ("a compressed header that nobody agreed on", with_byte(1, 0xC0)),
    ("no message at all", payload(b"")),
    ("half a message id", payload(b"\x02")),
    ("an unknown message id", payload(UNKNOWN)),
    ("noise", lambda _: bytes((n * 151 + 89) % 256 for n in range(400))),
)


MALFORMED_DATAGRAMS: Final = (
    *(step(f"garbage-{number:02}", name, garbage(make), RAW) for number, (name, make) in enumerate(GARBAGE, 1)),
    step("long", "a query with bytes too many", borderline(WHO + bytes(3))),
    step("short", "a query with a byte too few", borderline(WHO[:-1])),
)
