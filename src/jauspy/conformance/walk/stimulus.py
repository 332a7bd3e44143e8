"""An input for a component: who sends what, and what the tester knows about the predicates that will judge it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Final, TypeAlias

from jauspy.codec.base import Message
from jauspy.conformance.checks import Check
from jauspy.conformance.walk.behaviour import Judge, Prediction, Situation, Truth
from jauspy.conformance.walk.walker import Walker
from jauspy.schema import guards

Make: TypeAlias = Callable[[Walker], Message]
Prepare: TypeAlias = Callable[[Walker, str], None]
"""Takes the role of the sender, too."""

SENDER: Final = frozenset({"isControllingClient"})
SETTER: Final = frozenset({"isIDStored"})
"""Predicates about who sends."""


LONGEST: Final = 70.0
"""Seconds that a step may wait for a timer of the component: the default of events is a minute."""
EARLIEST: Final = 0.8
"""Of a timer: the part of its time that must have passed."""


def nothing(walker: Walker, role: str) -> None:
    """The usual preparation."""


@dataclass(frozen=True, slots=True)
class Aftermath:
    """What is known when an input has been answered: who sent it, where that was, and the outcome that fits."""

    walker: Walker
    role: str
    before: Situation
    outcome: Prediction
    took: Callable[[str], None]
    """To be called when the input has brought about an internal event as well, by its name."""


@dataclass(frozen=True, slots=True)
class Stimulus:
    """One kind of input. `message` is its name in the JSIDL, `make` None for an event that comes by itself."""

    message: str
    make: Make | None
    variant: str = ""
    truths: Mapping[str, Truth] = field(default_factory=dict)
    """What is known of predicates, by name."""
    before: Prepare = nothing
    after: Prepare = nothing
    checks: Mapping[str, tuple[Check, ...]] = field(default_factory=dict)
    """What to look at in outputs, by message name."""
    verify: Callable[[Aftermath], None] | None = None
    """Looks at the effect."""
    by_controller: bool = False
    """Can only be prepared by the client in control."""
    only_in: str = ""
    """The name of the state, below Receiving.Ready, in which alone it shows anything."""
    moves: bool = False
    """Something may move in Ready, whatever the message says."""
    of: str = ""
    """How the URN of the service begins that is meant, when messages of others have the same name."""
    also: tuple[str, ...] = ()
    """Internal events that it may bring about as well."""
    seconds: Callable[[Walker], float] | None = None
    """How long to wait: for an event that comes by itself, or an answer that takes its time."""
    earliest: float = 0.0
    """The part of that time before which it must not come."""
    once: bool = False
    """Tried in the first state alone: the others would show nothing more."""

    def fits(self, situation: Situation) -> bool:
        """True where it can be prepared and shows something."""
        controlled = situation.controller is not None or not self.by_controller
        return controlled and (not self.only_in or self.only_in in situation.state[2:])

    def judge(self, role: str) -> Judge:
        """Decides predicates for this input from this sender."""

        def decide(call: guards.Call, situation: Situation) -> Truth:
            name = call.name.rpartition(".")[2]
            if name in SENDER:
                return situation.controller == role
            if name in SETTER:
                return role in situation.emergencies
            return self.truths.get(name)

        return decide
