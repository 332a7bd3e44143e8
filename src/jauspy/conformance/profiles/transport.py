"""AS5669A as seen from outside: packing, wildcards, broadcast, ACK, fragments, duplicates, garbage, ports.

Every step sends packets made by hand to one component, with a query that changes nothing. A target is its component and
its node manager together; what the two do with a packet cannot be distinguished from outside.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import replace
from typing import Final

from jauspy.conformance.link import PORTS, RAW
from jauspy.conformance.profile import Action, Profile
from jauspy.conformance.profiles.raw_packets import (
    UNKNOWN_MESSAGE,
    B,
    PacketTest,
    RawSender,
    answered,
    check_others_are_answered,
    find_ping,
    fragments,
    other_subsystem,
    step,
    with_packets,
)
from jauspy.conformance.results import Skipped
from jauspy.ids import JausID
from jauspy.messages.core import QueryIdentification
from jauspy.protocol import header
from jauspy.protocol.header import Ack, Broadcast, Packet, Priority


def acknowledged(sender: RawSender) -> None:
    """A packet with ACK required: an empty ACK with the same number, and the answer."""
    packet = sender.packet(ack=Ack.REQUIRED)
    sender.send(packet)
    sender.expect_acks([packet.sequence], "an ACK with the number of the packet")
    (ack,) = sender.received(Ack.ACK)
    sender.tester.check("the ACK is empty", f"it carries {ack.payload.hex()}" if ack.payload else "")
    sender.expect(1, "one answer beside the ACK")


def acknowledged_again(sender: RawSender) -> None:
    """A packet that is sent again, as if the first ACK was lost."""
    packet = sender.packet(ack=Ack.REQUIRED)
    sender.send(packet)
    sender.expect(1, "one answer")
    sender.send(packet)
    sender.expect_acks([packet.sequence] * 2, "an ACK for the packet and for its resend")
    sender.expect(1, "one answer to the packet and its resend")


def not_acknowledged(sender: RawSender) -> None:
    """A packet without ACK required is not acknowledged."""
    sender.send(sender.packet())
    sender.expect(1, "one answer")
    sender.expect_acks([], "no ACK that was not requested")


def stray(ack: Ack) -> PacketTest:
    """An ACK or NAK that acknowledges no packet."""

    def test(sender: RawSender) -> None:
        sender.send(sender.packet(b"", ack=ack))
        sender.expect_none(f"no answer to a stray {ack.name}")

    return test


def duplicated(sender: RawSender) -> None:
    """The network delivers a packet twice."""
    packet = sender.packet()
    sender.send(packet)
    sender.send(packet)
    sender.expect(1, "one answer to a packet that came twice")


def repeated(sender: RawSender) -> None:
    """The same query under a new sequence number is not a duplicate."""
    sender.send(sender.packet())
    sender.send(sender.packet())
    sender.expect(2, "two answers to the same query under two numbers")


def restarted(sender: RawSender) -> None:
    """A restarted client reuses its first sequence numbers for other messages."""
    packet = sender.packet()
    sender.send(replace(packet, payload=UNKNOWN_MESSAGE))
    sender.send(packet)
    sender.expect(1, "an answer to a known number with another message, as of a client that restarted")


def same_number_of_two_clients(sender: RawSender) -> None:
    """Two sources may use the same sequence number."""
    other = RawSender(sender.tester, B)
    packet = sender.packet()
    sender.send(packet)
    other.send(replace(packet, source=other.client.id))
    sender.expect(1, "an answer to the first client")
    other.expect(1, "an answer to another client with the same number")


ACKNOWLEDGING: Final = (
    step("ack", "a packet that requires an ACK", with_packets(acknowledged)),
    step("ack-resend", "a packet that is sent again", with_packets(acknowledged_again)),
    step("ack-unasked", "a packet that requires no ACK", with_packets(not_acknowledged)),
    step("ack-stray", "an ACK that acknowledges no packet", with_packets(stray(Ack.ACK))),
    step("nak-stray", "a NAK that refers to no packet", with_packets(stray(Ack.NAK))),
    step("duplicate", "a packet that comes twice", with_packets(duplicated)),
    step("repeat", "a query that is repeated", with_packets(repeated)),
    step("restart", "a client that starts again", with_packets(restarted)),
    step("same-number", "two clients with the same sequence number", with_packets(same_number_of_two_clients)),
)


ChooseDestination = Callable[[JausID], JausID]


def sent_to(choose: ChooseDestination, *, reaches: bool) -> Action:
    """Send a query to the destination that `choose` returns; it is answered if `reaches` is true."""

    def test(sender: RawSender) -> None:
        destination = choose(sender.component)
        broadcast = Broadcast.GLOBAL if destination.is_wildcard else Broadcast.NONE
        sender.send(sender.packet(destination=destination, broadcast=broadcast))
        if reaches:
            sender.expect(1, f"one answer to {destination}")
        else:
            sender.expect_none(f"no answer to {destination}, which is another component")

    return with_packets(test)


def answer_is_unicast(sender: RawSender) -> None:
    """The answer to a broadcast is addressed to the client and is not a broadcast itself."""
    sender.send(sender.packet(destination=replace(sender.component, component=255), broadcast=Broadcast.GLOBAL))
    sender.expect(1, "one answer to a broadcast")
    (answer,) = sender.answers()
    problem = "" if answer.broadcast is Broadcast.NONE else f"it has broadcast flag {answer.broadcast.value}"
    sender.tester.check("the answer to a broadcast is none itself", problem)


def wildcard_source(sender: RawSender) -> None:
    """A query whose source is a wildcard is not answered."""
    sender.send(sender.packet(source=JausID(65535, 255, 255)))
    sender.expect_none("no answer to a source that is a wildcard")


def flagged(flag: Broadcast) -> Action:
    """Send a query to a wildcard with this broadcast flag."""

    def test(sender: RawSender) -> None:
        sender.send(sender.packet(destination=replace(sender.component, component=255), broadcast=flag))
        sender.expect(1, f"one answer to a wildcard with broadcast flag {flag.value}")

    return with_packets(test)


ADDRESSING: Final = (
    step("query", "a query is answered", find_ping),
    step("unicast", "a query to the component alone", answered()),
    *(
        step(f"priority-{priority.value}", f"a query of priority {priority.name}", answered(priority=priority))
        for priority in Priority
    ),
    step(
        "wildcard-component",
        "all components of the node",
        sent_to(lambda me: replace(me, component=255), reaches=True),
    ),
    step("wildcard-node", "all nodes, this component", sent_to(lambda me: replace(me, node=255), reaches=True)),
    step(
        "wildcard-node-component",
        "all nodes, all components",
        sent_to(lambda me: JausID(me.subsystem, 255, 255), reaches=True),
    ),
    step(
        "wildcard-subsystem",
        "all subsystems, this component",
        sent_to(lambda me: replace(me, subsystem=65535), reaches=True),
    ),
    step("wildcard-all", "everybody", sent_to(lambda _: JausID(65535, 255, 255), reaches=True)),
    step(
        "other-node",
        "all components of another node",
        sent_to(lambda me: JausID(me.subsystem, me.node % 254 + 1, 255), reaches=False),
    ),
    step(
        "other-subsystem",
        "a subsystem with the same lower byte",
        sent_to(other_subsystem, reaches=False),
    ),
    step(
        "other-subsystem-wildcard",
        "all of a subsystem with the same lower byte",
        sent_to(lambda me: JausID(other_subsystem(me).subsystem, 255, 255), reaches=False),
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
    step("answer-unicast", "the answer to a broadcast", with_packets(answer_is_unicast)),
    step("source-wildcard", "a source that is a wildcard", with_packets(wildcard_source), RAW),
)


IDENTIFICATION_QUERY: Final = QueryIdentification(4).encode()


def garbage(make: Callable[[RawSender], bytes]) -> Action:
    """Bytes that must have no effect."""

    def test(sender: RawSender) -> None:
        sender.raw(make(sender))
        sender.expect_none("nothing comes back")

    return with_packets(test)


def borderline(data: bytes) -> Action:
    """A message that implementations may accept or reject; the component must still answer others."""

    def test(sender: RawSender) -> None:
        sender.send(sender.packet(data))
        check_others_are_answered(sender.tester)

    return with_packets(test)


def valid_datagram(sender: RawSender) -> bytes:
    """A valid datagram."""
    return b"\x02" + header.pack(sender.packet())


def with_byte(offset: int, value: int) -> Callable[[RawSender], bytes]:
    """A valid datagram with one byte changed."""
    return lambda sender: (data := valid_datagram(sender))[:offset] + bytes([value]) + data[offset + 1 :]


def with_size(change: int) -> Callable[[RawSender], bytes]:
    """A valid datagram with a wrong data size."""

    def make(sender: RawSender) -> bytes:
        data = valid_datagram(sender)
        (size,) = struct.unpack_from("<H", data, 2)
        return data[:2] + struct.pack("<H", max(0, size + change)) + data[4:]

    return make


def payload(data: bytes) -> Callable[[RawSender], bytes]:
    """A valid header with a payload that is not a message."""
    return lambda sender: b"\x02" + header.pack(sender.packet(data))


GARBAGE: Final[tuple[tuple[str, Callable[[RawSender], bytes]], ...]] = (
    ("an empty datagram", lambda _: b""),
    ("a version byte alone", lambda _: b"\x02"),
    ("a version that does not exist", with_byte(0, 9)),
    ("a header that is cut off", lambda sender: valid_datagram(sender)[:9]),
    ("a packet that is cut off", lambda sender: valid_datagram(sender)[:-1]),
    ("a data size of zero", with_size(-0xFFFF)),
    ("a data size above the datagram", with_size(+1)),
    ("a reserved message type", with_byte(1, 5)),
    ("a compressed header that was not negotiated", with_byte(1, 0xC0)),
    ("no message at all", payload(b"")),
    ("half a message id", payload(b"\x02")),
    ("an unknown message id", payload(UNKNOWN_MESSAGE)),
    ("noise", lambda _: bytes((n * 151 + 89) % 256 for n in range(400))),
)


MALFORMED_DATAGRAMS: Final = (
    *(step(f"garbage-{number:02}", name, garbage(make), RAW) for number, (name, make) in enumerate(GARBAGE, 1)),
    step("long", "a query with extra bytes", borderline(IDENTIFICATION_QUERY + bytes(3))),
    step("short", "a query with a byte missing", borderline(IDENTIFICATION_QUERY[:-1])),
)


def packed(sender: RawSender) -> None:
    """Two packets in one datagram, after one version byte."""
    sender.send(sender.packet(), sender.packet())
    sender.expect(2, "an answer to each of two packets in a datagram")


def packed_for_two(sender: RawSender) -> None:
    """Two packets of different clients in one datagram."""
    other = RawSender(sender.tester, B)
    sender.send(sender.packet(), other.packet())
    sender.expect(1, "an answer to the first client")
    other.expect(1, "an answer to the second client")


def followed_by_garbage(sender: RawSender) -> None:
    """A packet followed by bytes that are not a packet."""
    sender.raw(b"\x02" + header.pack(sender.packet()) + b"\x00\x01\x00")
    sender.expect(1, "an answer to the packet before the garbage")


def sequence_numbers(sender: RawSender) -> None:
    """The answers have different sequence numbers."""
    for _ in range(3):
        sender.send(sender.packet())
    sender.expect(3, "three answers")
    numbers = [answer.sequence for answer in sender.answers()]
    problem = "" if len(set(numbers)) == len(numbers) else f"they are {numbers}"
    sender.tester.check("the sequence numbers of answers differ", problem)


PACKING: Final = (
    step("packed", "two packets in a datagram", with_packets(packed), RAW),
    step("packed-clients", "packets of two clients in a datagram", with_packets(packed_for_two), RAW),
    step("packed-garbage", "a packet followed by garbage", with_packets(followed_by_garbage), RAW),
    step("sequence", "sequence numbers", with_packets(sequence_numbers)),
)


def fragmented(count: int, order: Callable[[list[Packet]], list[Packet]] = list, ack: Ack = Ack.NONE) -> PacketTest:
    """Send a query in `count` fragments."""

    def test(sender: RawSender) -> None:
        if len(sender.ping) < 3:
            raise Skipped("the only query that was answered is too short to be cut")
        cuts = [1] if count == 2 else [1, 2]
        parts = fragments(sender, sender.ping, *cuts, ack=ack)
        for packet in order(parts):
            sender.send(packet)
        if ack is Ack.REQUIRED:
            sender.expect_acks([packet.sequence for packet in order(parts)], "an ACK for each fragment")
        sender.expect(1, f"one answer to a query in {count} fragments")

    return test


def swapped(parts: list[Packet]) -> list[Packet]:
    """The fragments in reverse order."""
    return parts[::-1]


def first_twice(parts: list[Packet]) -> list[Packet]:
    """The fragments, with the first one twice."""
    return [parts[0], *parts]


def late_fragment(sender: RawSender) -> None:
    """A fragment that arrives after the others."""
    if len(sender.ping) < 3:
        raise Skipped("the only query that was answered is too short to be cut")
    first, middle, last = fragments(sender, sender.ping, 1, 2)
    sender.send(first)
    sender.send(last)
    sender.expect_none("no answer while a fragment is missing")
    sender.send(middle)
    sender.expect(1, "the answer after the last fragment")


def two_clients(sender: RawSender) -> None:
    """Fragments of two clients with the same sequence numbers are not combined."""
    other = RawSender(sender.tester, B)
    first, last = fragments(sender, sender.ping, 1)
    sender.send(first)
    other.send(replace(last, source=other.client.id))
    sender.expect_none("no answer to fragments of two clients")
    other.expect_none("no answer to the other client either")


FRAGMENTATION: Final = (
    step("pieces-2", "a query in two fragments", with_packets(fragmented(2))),
    step("pieces-3", "a query in three fragments", with_packets(fragmented(3))),
    step("pieces-order", "fragments in the wrong order", with_packets(fragmented(3, swapped))),
    step("pieces-twice", "a fragment that arrives twice", with_packets(fragmented(2, first_twice))),
    step("pieces-ack", "fragments that require ACKs", with_packets(fragmented(3, ack=Ack.REQUIRED))),
    step("pieces-missing", "a fragment that arrives late", with_packets(late_fragment)),
    step("pieces-crossed", "fragments of two clients", with_packets(two_clients)),
)


def other_port(sender: RawSender) -> None:
    """A client that sends from another UDP port than 3794 is answered on that port."""
    answered_on_port(sender, second=True)


def port_change(sender: RawSender) -> None:
    """A client that changes its UDP port is answered on the new one."""
    answered_on_port(sender, second=True)
    answered_on_port(sender, second=False)


def answered_on_port(sender: RawSender, *, second: bool) -> None:
    """Send a query from a port and check the port on which the answer arrives."""
    where = "second" if second else "first"
    before = len(sender.arrivals())
    sender.client.other_port = second
    try:
        sender.send(sender.packet())
    finally:
        sender.client.other_port = False
    sender.tester.pump(sender.tester.now + sender.tester.timeout, lambda: len(sender.arrivals()) > before)
    ports = {port for _, port in sender.arrivals()[before:]}
    problem = "" if ports == {second} else "no answer came there" if not ports else "it came to the other one"
    sender.tester.expected.append(f"an answer at the client's {where} UDP port")
    sender.tester.check(f"a client on its {where} UDP port is answered there", problem)


def two_ports(sender: RawSender) -> None:
    """Two clients of one host may use different UDP ports."""
    other = RawSender(sender.tester, B)
    answered_on_port(other, second=True)
    answered_on_port(sender, second=False)


UDP_PORTS: Final = (
    step("port-other", "a client on another UDP port", with_packets(other_port), RAW, PORTS),
    step("port-back", "a client that changes its UDP port and comes back", with_packets(port_change), RAW, PORTS),
    step(
        "port-neighbour",
        "another client of the host on another UDP port",
        with_packets(two_ports),
        RAW,
        PORTS,
    ),
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
        step("alive", "after all this a query is answered", check_others_are_answered),
    ),
)
