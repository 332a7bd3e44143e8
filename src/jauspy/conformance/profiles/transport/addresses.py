"""Who is meant: ids, wildcards and broadcast flags."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Final

from jauspy.conformance.profile import Action
from jauspy.conformance.profiles.raw_packets import Hand, answered, by_hand, find_ping, other_subsystem, step
from jauspy.conformance.wire import RAW
from jauspy.ids import JausID
from jauspy.protocol.header import Broadcast, Priority

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
