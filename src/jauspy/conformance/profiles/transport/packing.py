"""Several packets in a datagram, and their numbers."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.profiles.raw_packets import B, Hand, by_hand, step
from jauspy.conformance.wire import RAW
from jauspy.protocol import header


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
