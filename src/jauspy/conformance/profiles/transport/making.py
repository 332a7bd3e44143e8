"""What the steps are made of: packets by hand from one client, or from two."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from jauspy.conformance.packets import Hand
from jauspy.conformance.profile import Action, Step

A: Final = "42.1.1"
B: Final = "42.2.1"
"""Two clients."""
UNKNOWN: Final = bytes.fromhex("ffee")
"""A message id that no standard has."""

Trial = Callable[[Hand], None]


def by_hand(trial: Trial, client: str = A) -> Action:
    """A step that works with packets."""
    return lambda tester: trial(Hand(tester, client))


def answered(**fields: Any) -> Action:
    """A query with these header fields is answered once."""

    def trial(hand: Hand) -> None:
        hand.send(hand.packet(**fields))
        hand.expect(1, "one answer")

    return by_hand(trial)


def step(id: str, title: str, action: Action, *wants: str) -> Step:
    """A step of this profile."""
    return Step(id, title, action, why="AS5669A", wants=frozenset(wants))
