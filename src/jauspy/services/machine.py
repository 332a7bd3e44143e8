"""The engine: runs one merged JSIDL state machine (semantics: docs/adr/0003-state-machine-semantics.md)."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import Enum
from typing import Final, Literal

from jauspy.codec.base import Message
from jauspy.schema.state_tree import MergedState
from jauspy.services.isolation import Bugs
from jauspy.services.later import Later
from jauspy.services.trigger import ANY_MESSAGE, ANY_TRIGGER, STAY, Key, Trigger

MAX_PUSHED: Final = 32
"""States that can wait to be popped; a definition that pushes deeper loses the oldest."""


@dataclass(frozen=True, slots=True)
class Step:
    """One bound action; `name` says where it comes from, for the log."""

    name: str
    call: Callable[[Trigger], object]
    sends: bool = False
    """True for `Send`: a message goes out."""
    report: Callable[[Trigger], Message | Later | None] | None = None
    """For a `Send` to who asked: what makes the message."""


@dataclass(frozen=True, slots=True)
class Rule:
    """One bound transition."""

    name: str
    key: Key
    kind: Literal["simple", "internal", "push", "pop"]
    guard: Callable[[Trigger], bool] | None = None
    steps: tuple[Step, ...] = ()
    end: MergedState | None = None


@dataclass(frozen=True, slots=True)
class BoundState:
    """What one state does."""

    entry: tuple[Step, ...] = ()
    exit: tuple[Step, ...] = ()
    transitions: tuple[Rule, ...] = ()
    defaults: tuple[Rule, ...] = ()


class Outcome(Enum):
    """What became of a trigger."""

    TAKEN = "taken"
    IGNORED = "ignored"
    """No transition of the active states wants it now, or one says to swallow it."""
    FAILED = "failed"
    """An action had a bug; the state is unchanged."""


class Machine:
    """One running state machine. Not re-entrant, except for `ask` from within an action."""

    def __init__(self, states: dict[MergedState, BoundState], start: MergedState, bugs: Bugs) -> None:
        self._states = states
        self._bugs = bugs
        self._active = start
        self._pushed: deque[MergedState] = deque(maxlen=MAX_PUSHED)
        self._candidates: dict[MergedState, dict[Key, tuple[Rule, ...]]] = {node: {} for node in states}
        self._only: dict[MergedState, dict[Key, Step | None]] = {node: {} for node in states}

    @property
    def state(self) -> str:
        """The innermost active state, as a dotted path."""
        return str(self._active)

    @property
    def path(self) -> tuple[str, ...]:
        """The names of the active states, outermost first."""
        return self._active.path

    @property
    def pushed(self) -> tuple[str, ...]:
        """The states that wait to be popped, newest last."""
        return tuple(str(node) for node in self._pushed)

    def start(self) -> None:
        """Run the entry actions of the start state and of all around it."""
        self._enter(reversed(list(self._active.upwards())), Trigger("start"))

    def handle(self, trigger: Trigger) -> Outcome:
        """Take the first transition that matches, if any."""
        rule = self._select(trigger)
        return Outcome.IGNORED if rule is None else self._apply(rule, trigger)

    def ask(self, trigger: Trigger) -> Outcome:
        """As `handle`, but only for what does not change the state; may be called from within an action."""
        rule = self._select(trigger)
        if rule is None or rule.kind != "internal":
            return Outcome.IGNORED
        return self._apply(rule, trigger)

    def only_step(self, key: Key) -> Step | None:
        """The whole answer to every trigger with this key while the present state lasts; None: more has a say in it.

        That is one action of an internal transition without a guard. Found once for each state.
        """
        known = self._only[self._active]
        if key not in known:
            first = next(iter(self._rules(key)), None)
            plain = first is not None and first.guard is None and first.kind == "internal" and len(first.steps) == 1
            known[key] = first.steps[0] if first is not None and plain else None
        return known[key]

    def _select(self, trigger: Trigger) -> Rule | None:
        rules = self._candidates[self._active].get(trigger.key)
        for rule in self._rules(trigger.key) if rules is None else rules:
            try:
                if rule.guard is None or rule.guard(trigger):
                    return rule
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._bugs.met(f"guard of {rule.name}", trigger, error)
        return None

    def _rules(self, key: Key) -> tuple[Rule, ...]:
        """The rules of the active state for a key; they are sought once in each state."""
        keys = (key, ANY_MESSAGE, ANY_TRIGGER) if isinstance(key, int) else (key, ANY_TRIGGER)
        found = self._candidates[self._active][key] = tuple(rule for rule in self._in_order() if rule.key in keys)
        return found

    def _in_order(self) -> Iterable[Rule]:
        """Innermost state first; around it the defaults, which speak for the states inside, come before its own."""
        node: MergedState | None = self._active
        while node is not None:
            bound = self._states[node]
            own = node is self._active
            yield from _takers(bound.transitions if own else bound.defaults)
            yield from _takers(bound.defaults if own else bound.transitions)
            node = node.parent

    def _apply(self, rule: Rule, trigger: Trigger) -> Outcome:
        stay = False
        for step in rule.steps:
            try:
                stay = step.call(trigger) is STAY or stay
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._bugs.met(step.name, trigger, error)
                return Outcome.FAILED
        if rule.kind != "internal" and not stay:
            self._change(rule, trigger)
        return Outcome.TAKEN if rule.steps or rule.kind != "internal" else Outcome.IGNORED

    def _change(self, rule: Rule, trigger: Trigger) -> None:
        if rule.kind == "pop":
            if self._pushed:
                target = self._pushed.pop()
                self._move(target, target, trigger)
        elif rule.end is not None:
            if rule.kind == "push":
                if rule.end.contains(self._active):
                    return
                self._pushed.append(self._active)
            self._move(rule.end, rule.end.leaf(), trigger)

    def _move(self, target: MergedState, leaf: MergedState, trigger: Trigger) -> None:
        """Leave up to the state around both, then enter down to `leaf`; a target that is active is left and entered."""
        leaving = list(self._active.upwards())
        around = target.parent
        while around is not None and not around.contains(self._active):
            around = around.parent
        depth = len(around.path) if around is not None else 0
        self._leave((node for node in leaving if len(node.path) > depth), trigger)
        self._active = leaf
        self._enter(reversed([node for node in leaf.upwards() if len(node.path) > depth]), trigger)

    def _leave(self, nodes: Iterable[MergedState], trigger: Trigger) -> None:
        for node in nodes:
            self._run_each(self._states[node].exit, trigger)

    def _enter(self, nodes: Iterable[MergedState], trigger: Trigger) -> None:
        for node in nodes:
            self._run_each(self._states[node].entry, trigger)

    def _run_each(self, steps: Iterable[Step], trigger: Trigger) -> None:
        """Entry and exit actions: a bug in one stops neither the others nor the change of state."""
        for step in steps:
            try:
                step.call(trigger)
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._bugs.met(step.name, trigger, error)


def _takers(rules: tuple[Rule, ...]) -> list[Rule]:
    """In order, except that those which take what nobody else takes come last."""
    return sorted(rules, key=lambda rule: rule.key == ANY_TRIGGER)
