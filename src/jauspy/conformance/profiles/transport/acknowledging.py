"""ACK and NAK, and packets that come twice."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from jauspy.conformance.profiles.raw_packets import UNKNOWN, B, Hand, Trial, by_hand, step
from jauspy.protocol.header import Ack


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
