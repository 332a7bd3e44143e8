"""Clients on other UDP ports."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.profiles.raw_packets import B, Hand, by_hand, step
from jauspy.conformance.wire import PORTS, RAW


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
