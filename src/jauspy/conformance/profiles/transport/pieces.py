"""Messages in several packets."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Final

from jauspy.conformance.profiles.raw_packets import B, Hand, Trial, by_hand, pieces, step
from jauspy.conformance.results import Skipped
from jauspy.protocol.header import Ack, Packet


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
