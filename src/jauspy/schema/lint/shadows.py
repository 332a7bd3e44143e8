"""The rule about transitions that another one, written before them, always takes the trigger from."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from jauspy.schema.lint.behavior import RECEIVE, place, states_of
from jauspy.schema.lint.finding import Problem
from jauspy.schema.lint.world import World
from jauspy.schema.model import Behavior, Transition
from jauspy.schema.state_tree import short_name as short

Key = tuple[str, str]
"""Trigger, and the message where it is the arrival of one; empty is any."""


def shadowed_transition(world: World) -> Iterator[Problem]:
    """Transitions behind one of the same state that fits whenever they do: the first that fits is taken."""
    for service in world.services():
        behavior = world.behavior(service)
        for transitions in _lists(behavior) if behavior else ():
            yield from _shadowed(transitions)


def _lists(behavior: Behavior) -> Iterator[Sequence[Transition]]:
    """The transitions that compete: those of one state, and apart from them its default ones."""
    for machine in behavior.machines:
        yield machine.default_transitions
    for state in states_of(behavior):
        yield state.transitions
        yield state.default_transitions


def _shadowed(transitions: Sequence[Transition]) -> Iterator[Problem]:
    for number, transition in enumerate(transitions):
        first = next((each for each in transitions[:number] if _covers(each, transition)), None)
        if first is not None:
            line = place(first.where).line
            why = "has the same guard" if first.guard else "has no guard"
            what = f"the transition on {_what(first)} in line {line} {why} and is always taken before this one"
            yield place(transition.where), f"{what}; give that one a guard, or put it behind"


def _covers(first: Transition, other: Transition) -> bool:
    """True when the first fits all that the other one does."""
    trigger, message = _key(first)
    its_trigger, its_message = _key(other)
    fits = trigger in ("", its_trigger) and message in ("", its_message)
    return fits and "".join(first.guard.split()) in ("", "".join(other.guard.split()))


def _key(transition: Transition) -> Key:
    trigger = short(transition.trigger)
    message = transition.parameters[0].type if trigger == RECEIVE and transition.parameters else ""
    return trigger, short(message)


def _what(transition: Transition) -> str:
    trigger, message = _key(transition)
    return message or trigger or "everything else"
