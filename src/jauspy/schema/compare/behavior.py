"""Differences of two state machines."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

from jauspy.schema.compare.change import Change
from jauspy.schema.model import Action, Behavior, State, Transition

_BLANKS = re.compile(r"(?<=[(!])\s+|\s+(?=[(),])")
"""Blanks in a guard that mean nothing."""

TransitionKey: TypeAlias = tuple[str, str]
"""What a transition waits for, and its guard."""


@dataclass(slots=True)
class _StateEffects:
    """What one state does, without the local names of where that is inherited from."""

    initial: str | None
    entry: tuple[str, ...]
    exit: tuple[str, ...]
    rules: dict[TransitionKey, list[str]] = field(default_factory=dict)


def compare_behavior(one: Behavior | None, other: Behavior | None) -> Iterator[Change]:
    """States and transitions that came, went or changed."""
    old, new = _states(one), _states(other)
    gone, come = old.keys() - new.keys(), new.keys() - old.keys()
    for path in sorted(gone):
        if path.rpartition(".")[0] not in gone:
            yield Change("behavior", path, f"{_what(path)} removed")
    for path in sorted(come):
        if path.rpartition(".")[0] not in come:
            yield Change("behavior", path, f"{_what(path)} added")
        for rule, effects in new[path].rules.items():
            yield from (Change("behavior", path, f"{_named(rule)}: {effect} added") for effect in effects)
    for path in (path for path in old if path in new):
        yield from _compare_states(old[path], new[path], path)
    starts = [{(short(start.machine), start.state) for start in (each.start if each else ())} for each in (one, other)]
    for machine, state in sorted(starts[0] ^ starts[1]):
        done = "does not start" if (machine, state) in starts[0] else "starts"
        yield Change("behavior", machine, f"{done} in {state}" + (" any more" if "not" in done else ""))


def _what(path: str) -> str:
    return "state" if "." in path else "state machine"


def _compare_states(one: _StateEffects, other: _StateEffects, path: str) -> Iterator[Change]:
    for what, before, after in (
        ("initial state", (one.initial or "none",), (other.initial or "none",)),
        ("on entry", one.entry, other.entry),
        ("on exit", one.exit, other.exit),
    ):
        if before != after:
            yield Change(
                "behavior", path, f"{what} {', '.join(before) or 'nothing'} -> {', '.join(after) or 'nothing'}"
            )
    for rule in dict.fromkeys((*one.rules, *other.rules)):
        old, new = one.rules.get(rule, []), other.rules.get(rule, [])
        gone = [effect for effect in old if effect not in new]
        come = [effect for effect in new if effect not in old]
        if len(gone) == len(come):
            pairs = zip(gone, come, strict=True)
            yield from (Change("behavior", path, f"{_named(rule)}: {a} -> {b}") for a, b in pairs)
        else:
            yield from (Change("behavior", path, f"{_named(rule)}: {effect} removed") for effect in gone)
            yield from (Change("behavior", path, f"{_named(rule)}: {effect} added") for effect in come)


def _named(rule: TransitionKey) -> str:
    return f"{rule[0]} [{rule[1]}]" if rule[1] else rule[0]


def _states(behavior: Behavior | None) -> dict[str, _StateEffects]:
    found: dict[str, _StateEffects] = {}
    for machine in behavior.machines if behavior else ():
        whole = _StateEffects(None, (), ())
        _add_rules(whole, machine.default_transitions, "by default ")
        found[short(machine.name)] = whole
        for state in machine.states:
            _add(found, state, f"{short(machine.name)}.{state.name}")
    return found


def _add(found: dict[str, _StateEffects], state: State, path: str) -> None:
    made = _StateEffects(state.initial, _texts(state.entry), _texts(state.exit))
    _add_rules(made, state.transitions, "")
    _add_rules(made, state.default_transitions, "by default ")
    found[path] = made
    for child in state.states:
        _add(found, child, f"{path}.{child.name}")


def _add_rules(state: _StateEffects, transitions: Sequence[Transition], prefix: str) -> None:
    for transition in transitions:
        rule = (prefix + trigger(transition), _BLANKS.sub("", transition.guard))
        state.rules.setdefault(rule, []).append(_effect(transition))


def _effect(transition: Transition) -> str:
    goes = f"go to {transition.end_state}" if transition.end_state else ""
    if transition.kind in ("push", "pop"):
        goes = f"{transition.kind} {transition.end_state or ''}".strip()
    return ", ".join((*_texts(transition.actions), *([goes] if goes else []))) or "nothing"


def _texts(actions: Sequence[Action]) -> tuple[str, ...]:
    return tuple(f"{short(action.name)}({', '.join(action.arguments)})" for action in actions)


def trigger(transition: Transition) -> str:
    """The message, or the internal event, that a transition waits for."""
    event = short(transition.trigger)
    if event == "Receive" and transition.parameters:
        return short(transition.parameters[0].type)
    return event or "anything else"


def short(dotted: str) -> str:
    """The name at the end of a dotted path: the rest says from which ancestor it comes."""
    return dotted.rpartition(".")[2]
