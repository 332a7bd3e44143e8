"""AS5669A as seen from outside: packing, wildcards, broadcast, ACK, pieces, duplicates, garbage, ports.

Every step sends packets made by hand to one component, with a query that changes nothing. A target is its component and
its node manager together; what the two do with a packet cannot be told apart from outside.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import replace
from typing import Final

from jauspy.conformance.profile import Action, Profile
from jauspy.conformance.profiles.raw_packets import (
    UNKNOWN,
    B,
    Hand,
    Trial,
    alive,
    answered,
    by_hand,
    find_ping,
    other_subsystem,
    pieces,
    step,
)
from jauspy.conformance.results import Skipped
from jauspy.conformance.wire import PORTS, RAW
from jauspy.ids import JausID
from jauspy.messages.core import QueryIdentification
from jauspy.protocol import header
from jauspy.protocol.header import Ack, Broadcast, Packet, Priority


def acknowledged(hand: Hand) -> None:
    """ACK required: an empty packet with the same number, and the answer."""
    packet = hand.packet(ack=Ack.REQUIRED)
    hand.send(packet)
    hand.expect_acks([packet.sequence], "an ACK with the number of the packet")
    (ack,) = hand.received(Ack.ACK)
    hand.tester.check("the ACK is empty", f"it carries {ack.payload.hex()}" if ack.payload else "")
    hand.expect(1, "one answer beside the ACK")


def acknowledged_again(hand: Hand) -> None:
    """A resend: the first ACK was lost."""
    packet = hand.packet(ack=Ack.REQUIRED)
    hand.send(packet)
    hand.expect(1, "one answer")
    hand.send(packet)
    hand.expect_acks([packet.sequence] * 2, "an ACK for the packet and for its resend")
    hand.expect(1, "one answer to the packet and its resend")


def not_acknowledged(hand: Hand) -> None:
    """No ACK without being asked."""
    hand.send(hand.packet())
    hand.expect(1, "one answer")
    hand.expect_acks([], "no ACK that was not asked for")


def stray(ack: Ack) -> Trial:
    """An ACK or NAK of nothing."""

    def trial(hand: Hand) -> None:
        hand.send(hand.packet(b"", ack=ack))
        hand.expect_none(f"no answer to a stray {ack.name}")

    return trial


def doubled(hand: Hand) -> None:
    """The network delivers a packet twice."""
    packet = hand.packet()
    hand.send(packet)
    hand.send(packet)
    hand.expect(1, "one answer to a packet that came twice")


def repeated(hand: Hand) -> None:
    """The same question once more is no duplicate."""
    hand.send(hand.packet())
    hand.send(hand.packet())
    hand.expect(2, "two answers to the same query under two numbers")


def restarted(hand: Hand) -> None:
    """A client that starts again uses its first numbers again, for other messages."""
    packet = hand.packet()
    hand.send(replace(packet, payload=UNKNOWN))
    hand.send(packet)
    hand.expect(1, "an answer to a known number with another message, as of a client that restarted")


def same_number_elsewhere(hand: Hand) -> None:
    """Numbers are the source's own."""
    other = Hand(hand.tester, B)
    packet = hand.packet()
    hand.send(packet)
    other.send(replace(packet, source=other.client.id))
    hand.expect(1, "an answer to the first client")
    other.expect(1, "an answer to another client with the same number")


ACKNOWLEDGING: Final = (
    step("ack", "a packet that wants to be acknowledged", by_hand(acknowledged)),
    step("ack-resend", "a packet that is sent again", by_hand(acknowledged_again)),
    step("ack-unasked", "a packet that does not want to be acknowledged", by_hand(not_acknowledged)),
    step("ack-stray", "an ACK of nothing", by_hand(stray(Ack.ACK))),
    step("nak-stray", "a NAK of nothing", by_hand(stray(Ack.NAK))),
    step("duplicate", "a packet that comes twice", by_hand(doubled)),
    step("repeat", "a query that is repeated", by_hand(repeated)),
    step("restart", "a client that starts again", by_hand(restarted)),
    step("same-number", "two clients with the same sequence number", by_hand(same_number_elsewhere)),
)


Aim = Callable[[JausID], JausID]


def aimed(aim: Aim, *, reaches: bool) -> Action:
    """A broadcast to a wildcard, or a packet to somebody else."""

    def trial(hand: Hand) -> None:
        destination = aim(hand.component)
        broadcast = Broadcast.GLOBAL if destination.is_wildcard else Broadcast.NONE
        hand.send(hand.packet(destination=destination, broadcast=broadcast))
        if reaches:
            hand.expect(1, f"one answer to {destination}")
        else:
            hand.expect_none(f"no answer to {destination}, which is somebody else")

    return by_hand(trial)


def answer_is_mine(hand: Hand) -> None:
    """An answer is for the client alone, and is not a broadcast."""
    hand.send(hand.packet(destination=replace(hand.component, component=255), broadcast=Broadcast.GLOBAL))
    hand.expect(1, "one answer to a broadcast")
    (answer,) = hand.answers()
    problem = "" if answer.broadcast is Broadcast.NONE else f"it has broadcast flag {answer.broadcast.value}"
    hand.tester.check("the answer to a broadcast is none itself", problem)


def nobody(hand: Hand) -> None:
    """A source that is a wildcard cannot be answered."""
    hand.send(hand.packet(source=JausID(65535, 255, 255)))
    hand.expect_none("no answer to a source that is a wildcard")


def flagged(flag: Broadcast) -> Action:
    """A wildcard with this broadcast flag."""

    def trial(hand: Hand) -> None:
        hand.send(hand.packet(destination=replace(hand.component, component=255), broadcast=flag))
        hand.expect(1, f"one answer to a wildcard with broadcast flag {flag.value}")

    return by_hand(trial)


ADDRESSING: Final = (
    step("query", "a query is answered", find_ping),
    step("unicast", "a query to the component alone", answered()),
    *(step(f"priority-{each.value}", f"a query of priority {each.name}", answered(priority=each)) for each in Priority),
    step(
        "wildcard-component",
        "all components of the node",
        aimed(lambda me: replace(me, component=255), reaches=True),
    ),
    step("wildcard-node", "all nodes, this component", aimed(lambda me: replace(me, node=255), reaches=True)),
    step(
        "wildcard-node-component",
        "all nodes, all components",
        aimed(lambda me: JausID(me.subsystem, 255, 255), reaches=True),
    ),
    step(
        "wildcard-subsystem",
        "all subsystems, this component",
        aimed(lambda me: replace(me, subsystem=65535), reaches=True),
    ),
    step("wildcard-all", "everybody", aimed(lambda _: JausID(65535, 255, 255), reaches=True)),
    step(
        "other-node",
        "all components of another node",
        aimed(lambda me: JausID(me.subsystem, me.node % 254 + 1, 255), reaches=False),
    ),
    step(
        "other-subsystem",
        "a subsystem with the same lower byte",
        aimed(other_subsystem, reaches=False),
    ),
    step(
        "other-subsystem-wildcard",
        "all of a subsystem with the same lower byte",
        aimed(lambda me: JausID(other_subsystem(me).subsystem, 255, 255), reaches=False),
    ),
    step(
        "broadcast-local",
        "a wildcard with the flag of local broadcasts",
        flagged(Broadcast.LOCAL),
    ),
    step(
        "broadcast-none",
        "a wildcard without a flag, as some stacks send it",
        flagged(Broadcast.NONE),
    ),
    step("answer-unicast", "the answer to a broadcast", by_hand(answer_is_mine)),
    step("source-wildcard", "a source that is a wildcard", by_hand(nobody), RAW),
)


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


def packed(hand: Hand) -> None:
    """Two packets behind one version byte."""
    hand.send(hand.packet(), hand.packet())
    hand.expect(2, "an answer to each of two packets in a datagram")


def packed_for_two(hand: Hand) -> None:
    """Two packets of different clients."""
    other = Hand(hand.tester, B)
    hand.send(hand.packet(), other.packet())
    hand.expect(1, "an answer to the first client")
    other.expect(1, "an answer to the second client")


def followed_by_garbage(hand: Hand) -> None:
    """Bytes that are no packet, behind one."""
    hand.raw(b"\x02" + header.pack(hand.packet()) + b"\x00\x01\x00")
    hand.expect(1, "an answer to the packet before the garbage")


def sequence_numbers(hand: Hand) -> None:
    """Every packet of a source has the next number."""
    for _ in range(3):
        hand.send(hand.packet())
    hand.expect(3, "three answers")
    numbers = [each.sequence for each in hand.answers()]
    problem = "" if len(set(numbers)) == len(numbers) else f"they are {numbers}"
    hand.tester.check("the sequence numbers of answers differ", problem)


PACKING: Final = (
    step("packed", "two packets in a datagram", by_hand(packed), RAW),
    step("packed-clients", "packets of two clients in a datagram", by_hand(packed_for_two), RAW),
    step("packed-garbage", "a packet followed by garbage", by_hand(followed_by_garbage), RAW),
    step("sequence", "sequence numbers", by_hand(sequence_numbers)),
)


def in_pieces(count: int, order: Callable[[list[Packet]], list[Packet]] = list, ack: Ack = Ack.NONE) -> Trial:
    """A query, cut."""

    def trial(hand: Hand) -> None:
        if len(hand.ping) < 3:
            raise Skipped("the only query that was answered is too short to be cut")
        cuts = [1] if count == 2 else [1, 2]
        parts = pieces(hand, hand.ping, *cuts, ack=ack)
        for each in order(parts):
            hand.send(each)
        if ack is Ack.REQUIRED:
            hand.expect_acks([each.sequence for each in order(parts)], "an ACK for each piece")
        hand.expect(1, f"one answer to a query in {count} pieces")

    return trial


def swapped(parts: list[Packet]) -> list[Packet]:
    """Last piece first."""
    return parts[::-1]


def first_twice(parts: list[Packet]) -> list[Packet]:
    """A piece is delivered twice."""
    return [parts[0], *parts]


def missing(hand: Hand) -> None:
    """A piece is lost, and comes later."""
    if len(hand.ping) < 3:
        raise Skipped("the only query that was answered is too short to be cut")
    first, middle, last = pieces(hand, hand.ping, 1, 2)
    hand.send(first)
    hand.send(last)
    hand.expect_none("no answer while a piece is missing")
    hand.send(middle)
    hand.expect(1, "the answer once the piece is there")


def crossed(hand: Hand) -> None:
    """Pieces of two clients with the same numbers must not be mixed."""
    other = Hand(hand.tester, B)
    first, last = pieces(hand, hand.ping, 1)
    hand.send(first)
    other.send(replace(last, source=other.client.id))
    hand.expect_none("no answer to pieces of two clients")
    other.expect_none("no answer to the other client either")


FRAGMENTATION: Final = (
    step("pieces-2", "a query in two pieces", by_hand(in_pieces(2))),
    step("pieces-3", "a query in three pieces", by_hand(in_pieces(3))),
    step("pieces-order", "pieces in the wrong order", by_hand(in_pieces(3, swapped))),
    step("pieces-twice", "a piece that comes twice", by_hand(in_pieces(2, first_twice))),
    step("pieces-ack", "pieces that want to be acknowledged", by_hand(in_pieces(3, ack=Ack.REQUIRED))),
    step("pieces-missing", "a piece that comes late", by_hand(missing)),
    step("pieces-crossed", "pieces of two clients", by_hand(crossed)),
)


def other_port(hand: Hand) -> None:
    """A client that speaks from another UDP port than 3794 is answered there."""
    came_to(hand, strange=True)


def back_again(hand: Hand) -> None:
    """A client that moves is answered where it is, not where it was."""
    came_to(hand, strange=True)
    came_to(hand, strange=False)


def came_to(hand: Hand, *, strange: bool) -> None:
    """Ask from a port, and look at which port the answer comes."""
    where = "strange" if strange else "usual"
    before = len(hand.arrivals())
    hand.client.strange_port = strange
    try:
        hand.send(hand.packet())
    finally:
        hand.client.strange_port = False
    hand.tester.pump(hand.tester.now + hand.tester.timeout, lambda: len(hand.arrivals()) > before)
    ports = {port for _, port in hand.arrivals()[before:]}
    problem = "" if ports == {strange} else "no answer came there" if not ports else "it came to the other one"
    hand.tester.expected.append(f"an answer at the client's {where} UDP port")
    hand.tester.check(f"a client on its {where} UDP port is answered there", problem)


def not_moved_by_others(hand: Hand) -> None:
    """One client of a host may use another port than the next."""
    other = Hand(hand.tester, B)
    came_to(other, strange=True)
    came_to(hand, strange=False)


UDP_PORTS: Final = (
    step("port-other", "a client on another UDP port", by_hand(other_port), RAW, PORTS),
    step("port-back", "a client that changes its UDP port and comes back", by_hand(back_again), RAW, PORTS),
    step("port-neighbour", "another client of the host on another UDP port", by_hand(not_moved_by_others), RAW, PORTS),
)


PROFILE: Final = Profile(
    "transport",
    "AS5669A: packing, wildcards, broadcast, ACK, pieces, duplicates, garbage, source ports",
    (
        *ADDRESSING,
        *PACKING,
        *ACKNOWLEDGING,
        *FRAGMENTATION,
        *MALFORMED_DATAGRAMS,
        *UDP_PORTS,
        step("alive", "after all this a query is answered", alive),
    ),
)
