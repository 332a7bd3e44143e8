"""The engine: runs one merged JSIDL state machine (semantics: docs/adr/0003-state-machine-semantics.md)."""

from __future__ import annotations

import logging
from collections import Counter, deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import Enum
from typing import Any, Final, Literal, NamedTuple, TypeAlias

from jauspy.codec.base import Message
from jauspy.ids import JausID
from jauspy.schema.state_tree import MergedState
from jauspy.services.deferred import Deferred

TriggerKey: TypeAlias = int | str
"""What a transition waits for: the code of a received message, or the name of an internal event."""

ANY_MESSAGE: Final = "Receive"
"""The key of transitions that take every received message (JSIDL: `Receive` without parameters)."""

ANY_TRIGGER: Final = ""
"""The key of transitions that take whatever no other transition of their state takes (JSIDL: `default_transition`)."""


class Trigger(NamedTuple):
    """One input of the state machine: a message from `source`, or an internal event."""

    key: TriggerKey
    msg: Any = None
    """The received message; for an internal event whatever the service that fired it passed on."""
    source: JausID | None = None
    """Who sent the message; for an internal event whom it is about, None for nobody."""

    @property
    def is_message(self) -> bool:
        """True for a received message."""
        return isinstance(self.key, int)


class ActionResult(Enum):
    """What an action may return to steer the transition it belongs to."""

    STAY = "stay"


STAY: Final = ActionResult.STAY
"""Returned by an action: the remaining actions run, but the state does not change."""


_LOG: Final = logging.getLogger("jauspy.services")


class ActionErrors:
    """Everything that failed in one component; `failed` is called after each.

    Who calls the code of a service catches every `Exception` and hands it in here, with a name that says which action
    of which service and state it was.
    """

    def __init__(self, counters: Counter[str], failed: Callable[[], None] = lambda: None) -> None:
        self._counters = counters
        self._failed = failed
        self._times: Counter[str] = Counter()

    def met(self, name: str, trigger: Trigger, error: Exception) -> None:
        """Count it. It is logged the 1st, 2nd, 4th, 8th ... time, so that a client cannot fill the disk with it."""
        self._counters["action_failed"] += 1
        self._times[name] += 1
        times = self._times[name]
        if times & (times - 1) == 0:
            what, source = trigger.msg or trigger.key, trigger.source or "inside"
            again = f" ({times} times)" if times > 1 else ""
            _LOG.error("%s failed%s on %r from %s: %s", name, again, what, source, error, exc_info=error)
        self._failed()


MAX_PUSHED: Final = 32
"""States that can wait to be popped; a definition that pushes deeper loses the oldest."""


@dataclass(frozen=True, slots=True)
class BoundAction:
    """One bound action; `name` says where it comes from, for the log."""

    name: str
    call: Callable[[Trigger], object]
    sends: bool = False
    """True for `Send`: a message goes out."""
    report: Callable[[Trigger], Message | Deferred | None] | None = None
    """For a `Send` to who asked: what makes the message."""


@dataclass(frozen=True, slots=True)
class BoundTransition:
    """One bound transition."""

    name: str
    key: TriggerKey
    kind: Literal["simple", "internal", "push", "pop"]
    guard: Callable[[Trigger], bool] | None = None
    steps: tuple[BoundAction, ...] = ()
    end: MergedState | None = None


@dataclass(frozen=True, slots=True)
class BoundState:
    """What one state does."""

    entry: tuple[BoundAction, ...] = ()
    exit: tuple[BoundAction, ...] = ()
    transitions: tuple[BoundTransition, ...] = ()
    defaults: tuple[BoundTransition, ...] = ()


class TriggerOutcome(Enum):
    """What became of a trigger."""

    TAKEN = "taken"
    IGNORED = "ignored"
    """No transition of the active states wants it now, or one says to swallow it."""
    FAILED = "failed"
    """An action had a bug; the state is unchanged."""


class MachineInstance:
    """One running state machine. Not re-entrant, except for `ask` from within an action."""

    def __init__(self, states: dict[MergedState, BoundState], start: MergedState, bugs: ActionErrors) -> None:
        self._states = states
        self._bugs = bugs
        self._active = start
        self._pushed: deque[MergedState] = deque(maxlen=MAX_PUSHED)
        self._candidates: dict[MergedState, dict[TriggerKey, tuple[BoundTransition, ...]]] = {
            node: {} for node in states
        }
        self._only: dict[MergedState, dict[TriggerKey, BoundAction | None]] = {node: {} for node in states}

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

    def handle(self, trigger: Trigger) -> TriggerOutcome:
        """Take the first transition that matches, if any."""
        rule = self._select(trigger)
        return TriggerOutcome.IGNORED if rule is None else self._apply(rule, trigger)

    def ask(self, trigger: Trigger) -> TriggerOutcome:
        """As `handle`, but only for what does not change the state; may be called from within an action."""
        rule = self._select(trigger)
        if rule is None or rule.kind != "internal":
            return TriggerOutcome.IGNORED
        return self._apply(rule, trigger)

    def only_step(self, key: TriggerKey) -> BoundAction | None:
        """The whole answer to every trigger with this key while the present state lasts; None: more has a say in it.

        That is one action of an internal transition without a guard. Found once for each state.
        """
        known = self._only[self._active]
        if key not in known:
            first = next(iter(self._rules(key)), None)
            plain = first is not None and first.guard is None and first.kind == "internal" and len(first.steps) == 1
            known[key] = first.steps[0] if first is not None and plain else None
        return known[key]

    def _select(self, trigger: Trigger) -> BoundTransition | None:
        rules = self._candidates[self._active].get(trigger.key)
        for rule in self._rules(trigger.key) if rules is None else rules:
            try:
                if rule.guard is None or rule.guard(trigger):
                    return rule
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._bugs.met(f"guard of {rule.name}", trigger, error)
        return None

    def _rules(self, key: TriggerKey) -> tuple[BoundTransition, ...]:
        """The rules of the active state for a key; they are sought once in each state."""
        keys = (key, ANY_MESSAGE, ANY_TRIGGER) if isinstance(key, int) else (key, ANY_TRIGGER)
        found = self._candidates[self._active][key] = tuple(rule for rule in self._in_order() if rule.key in keys)
        return found

    def _in_order(self) -> Iterable[BoundTransition]:
        """Innermost state first; around it the defaults, which speak for the states inside, come before its own."""
        node: MergedState | None = self._active
        while node is not None:
            bound = self._states[node]
            own = node is self._active
            yield from _takers(bound.transitions if own else bound.defaults)
            yield from _takers(bound.defaults if own else bound.transitions)
            node = node.parent

    def _apply(self, rule: BoundTransition, trigger: Trigger) -> TriggerOutcome:
        stay = False
        for step in rule.steps:
            try:
                stay = step.call(trigger) is STAY or stay
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._bugs.met(step.name, trigger, error)
                return TriggerOutcome.FAILED
        if rule.kind != "internal" and not stay:
            self._change(rule, trigger)
        return TriggerOutcome.TAKEN if rule.steps or rule.kind != "internal" else TriggerOutcome.IGNORED

    def _change(self, rule: BoundTransition, trigger: Trigger) -> None:
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

    def _run_each(self, steps: Iterable[BoundAction], trigger: Trigger) -> None:
        """Entry and exit actions: a bug in one stops neither the others nor the change of state."""
        for step in steps:
            try:
                step.call(trigger)
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._bugs.met(step.name, trigger, error)


def _takers(rules: tuple[BoundTransition, ...]) -> list[BoundTransition]:
    """In order, except that those which take what nobody else takes come last."""
    return sorted(rules, key=lambda rule: rule.key == ANY_TRIGGER)


class CommandCompletion:
    """Call it when the command has ended."""

    __slots__ = ("_tell", "claimed")

    def __init__(self, tell: Callable[[bool], None] | None = None) -> None:
        self._tell = tell
        self.claimed = False
        """True once a service said that its command takes time."""

    def __call__(self, success: bool) -> None:
        """True: it was carried out, False: it was given up. Later calls do nothing."""
        tell, self._tell = self._tell, None
        if tell is not None:
            tell(success)


MAX_QUEUED_TRIGGERS: Final = 256
"""Internal events that may wait at once, and that may follow from one message; more is a bug of a service."""


class TriggerQueue:
    """First in, first out. What comes up while something is handled waits until that is done.

    Nothing is handled before `open`, which is when everything is bound.
    """

    def __init__(self, dispatch: Callable[[Trigger], TriggerOutcome], dropped: Callable[[Trigger], None]) -> None:
        self._dispatch = dispatch
        self._dropped = dropped
        self._waiting: deque[tuple[Trigger, CommandCompletion | None]] = deque()
        self._command: CommandCompletion | None = None
        self._busy = True

    def open(self) -> None:
        """Begin, with what came up so far."""
        self._settle()

    def run(self, trigger: Trigger) -> TriggerOutcome:
        """Handle this now, and then all that follows from it."""
        self._busy = True
        outcome = self._handle(trigger, None)
        self._settle()
        return outcome

    def put(self, trigger: Trigger, completion: CommandCompletion | None = None) -> None:
        """Handle this as soon as what happens now is done; when too much waits, it is dropped."""
        if not self._busy:
            self._busy = True
            self._handle(trigger, completion)
            self._settle()
        elif len(self._waiting) < MAX_QUEUED_TRIGGERS:
            self._waiting.append((trigger, completion))
        else:
            self._drop(trigger, completion)

    def begin_command(self) -> CommandCompletion:
        """What is being handled takes time, and ends when this is called; nobody may wait for that."""
        command = self._command or CommandCompletion()
        command.claimed = True
        return command

    def _settle(self) -> None:
        for _ in range(MAX_QUEUED_TRIGGERS):
            if not self._waiting:
                break
            self._handle(*self._waiting.popleft())
        while self._waiting:
            self._drop(*self._waiting.popleft())
        self._busy = False

    def _handle(self, trigger: Trigger, completion: CommandCompletion | None) -> TriggerOutcome:
        self._command = completion
        outcome = self._dispatch(trigger)
        self._command = None
        if completion is not None and not (completion.claimed and outcome is TriggerOutcome.TAKEN):
            completion(outcome is TriggerOutcome.TAKEN)
        return outcome

    def _drop(self, trigger: Trigger, completion: CommandCompletion | None) -> None:
        self._dropped(trigger)
        if completion is not None:
            completion(False)
