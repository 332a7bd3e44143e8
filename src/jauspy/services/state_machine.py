"""Runs one merged JSIDL state machine (semantics: docs/adr/0003-state-machine-semantics.md).

A `MachineInstance` takes one `Trigger` after the other; a `TriggerQueue` keeps those that arise while another one is
handled (run to completion). Actions and guards are bound beforehand, see `binding`; what they raise is recorded in
`ActionErrors`.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from enum import Enum
from typing import Any, Final, Literal, NamedTuple, TypeAlias

from jauspy.ids import JausID
from jauspy.logs import get_logger
from jauspy.protocol.counters import Counters
from jauspy.schema.state_tree import MergedState

_LOG: Final = get_logger("jauspy.services")

MAX_PUSHED: Final = 32
"""States that can wait to be popped; a definition that pushes deeper loses the oldest."""
MAX_QUEUED_TRIGGERS: Final = 256
"""Triggers that may be queued at once, and that may follow from one message; more is a bug of a service."""
TriggerKey: TypeAlias = int | str
"""The trigger of a transition: the code of a received message, or the name of an internal event."""

ANY_MESSAGE: Final = "Receive"
"""The key of transitions that take every received message (JSIDL: `Receive` without parameters)."""

ANY_TRIGGER: Final = ""
"""The key of transitions that take whatever no other transition of their state takes (JSIDL: `default_transition`)."""


class Trigger(NamedTuple):
    """One input of a state machine: a message from `source`, or an internal event."""

    key: TriggerKey
    msg: Any = None
    """The received message; for an internal event whatever the service that fired it passed on."""
    source: JausID | None = None
    """The sender of the message; for an internal event the client concerned, None for no client."""

    @property
    def is_message(self) -> bool:
        """True for a received message."""
        return isinstance(self.key, int)


class ActionResult(Enum):
    """Values that an action may return to control its transition."""

    STAY = "stay"


STAY: Final = ActionResult.STAY
"""Returned by an action: the remaining actions run, but the state does not change."""


class ActionErrors:
    """Records the exceptions that actions, guards and timers of one component raise; `on_error` is called after each.

    All callers of a service's code catch every `Exception` and record it here.
    """

    def __init__(self, counters: Counters, on_error: Callable[[], None] = lambda: None) -> None:
        self._counters = counters
        self._on_error = on_error
        self._times: Counter[str] = Counter()
        self.first: tuple[str, Exception] | None = None
        """The first exception, with its traceback, and what raised it."""

    def record(self, name: str, trigger: Trigger, error: Exception) -> None:
        """Count it; `name` says which action of which service and state raised it.

        It is logged the 1st, 2nd, 4th, 8th ... time, so that a client cannot fill the disk.
        """
        self._counters["action_failed"] += 1
        self.first = self.first or (name, error)
        self._times[name] += 1
        times = self._times[name]
        if times & (times - 1) == 0:
            what, source = trigger.msg or trigger.key, trigger.source or "inside"
            again = f" ({times} times)" if times > 1 else ""
            _LOG.error("%s failed%s on %r from %s: %s", name, again, what, source, error, exc_info=error)
        self._on_error()


@dataclass(frozen=True, slots=True)
class BoundAction:
    """One action bound to a method; `name` says where it comes from, for the log."""

    name: str
    call: Callable[[Trigger], object]
    sends: bool = False
    """True for `Send`: a message goes out."""
    report: Callable[[Trigger], object] | None = None
    """Function that makes the `Message` of a `Send` to the source of the trigger, a `Deferred` one, or None."""


@dataclass(frozen=True, slots=True)
class BoundTransition:
    """One transition with its guard and actions bound; `end` is the state that it leads to."""

    name: str
    key: TriggerKey
    kind: Literal["simple", "internal", "push", "pop"]
    guard: Callable[[Trigger], bool] | None = None
    actions: tuple[BoundAction, ...] = ()
    end: MergedState | None = None


@dataclass(frozen=True, slots=True)
class BoundState:
    """Entry and exit actions, transitions and default transitions of one state, bound."""

    entry: tuple[BoundAction, ...] = ()
    exit: tuple[BoundAction, ...] = ()
    transitions: tuple[BoundTransition, ...] = ()
    defaults: tuple[BoundTransition, ...] = ()


class TriggerOutcome(Enum):
    """The outcome of a trigger."""

    TAKEN = "taken"
    IGNORED = "ignored"
    """No transition of the active states takes it, or one that does nothing."""
    FAILED = "failed"
    """An action raised an exception; the state is unchanged."""


class MachineInstance:
    """A merged state machine at run time. Not re-entrant, except for `ask` from within an action."""

    def __init__(self, states: dict[MergedState, BoundState], start: MergedState, errors: ActionErrors) -> None:
        self._states = states
        self._errors = errors
        self._active = start
        self._pushed: deque[MergedState] = deque(maxlen=MAX_PUSHED)
        self._candidates: dict[MergedState, dict[TriggerKey, tuple[BoundTransition, ...]]] = {
            node: {} for node in states
        }
        self._sole_actions: dict[MergedState, dict[TriggerKey, BoundAction | None]] = {state: {} for state in states}

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
        """The states that a pop returns to, newest last."""
        return tuple(str(node) for node in self._pushed)

    def start(self) -> None:
        """Run the entry actions of the start state and of the states around it, outermost first."""
        self._enter(reversed(list(self._active.upwards())), Trigger("start"))

    def handle(self, trigger: Trigger) -> TriggerOutcome:
        """Take the first transition that matches, if any."""
        transition = self._select(trigger)
        return TriggerOutcome.IGNORED if transition is None else self._apply(transition, trigger)

    def ask(self, trigger: Trigger) -> TriggerOutcome:
        """Same as `handle`, but takes internal transitions only; may be called from within an action."""
        transition = self._select(trigger)
        if transition is None or transition.kind != "internal":
            return TriggerOutcome.IGNORED
        return self._apply(transition, trigger)

    def sole_action(self, key: TriggerKey) -> BoundAction | None:
        """The action that is all that triggers with this key do in the active state; None when they may do more.

        That is the only action of an internal transition without a guard. Cached for each state.
        """
        known = self._sole_actions[self._active]
        if key not in known:
            first = next(iter(self._find_transitions(key)), None)
            plain = first is not None and first.guard is None and first.kind == "internal" and len(first.actions) == 1
            known[key] = first.actions[0] if first is not None and plain else None
        return known[key]

    def _select(self, trigger: Trigger) -> BoundTransition | None:
        known = self._candidates[self._active].get(trigger.key)
        for transition in self._find_transitions(trigger.key) if known is None else known:
            try:
                if transition.guard is None or transition.guard(trigger):
                    return transition
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._errors.record(f"guard of {transition.name}", trigger, error)
        return None

    def _find_transitions(self, key: TriggerKey) -> tuple[BoundTransition, ...]:
        """The transitions of the active state for a key, cached for each state."""
        keys = (key, ANY_MESSAGE, ANY_TRIGGER) if isinstance(key, int) else (key, ANY_TRIGGER)
        found = self._candidates[self._active][key] = tuple(
            transition for transition in self._in_order() if transition.key in keys
        )
        return found

    def _in_order(self) -> Iterable[BoundTransition]:
        """Innermost state first; the defaults of an enclosing state, which apply to states inside, precede its own."""
        state: MergedState | None = self._active
        while state is not None:
            bound = self._states[state]
            is_active = state is self._active
            yield from _catch_all_last(bound.transitions if is_active else bound.defaults)
            yield from _catch_all_last(bound.defaults if is_active else bound.transitions)
            state = state.parent

    def _apply(self, transition: BoundTransition, trigger: Trigger) -> TriggerOutcome:
        # actions run in the state that is left; one that fails, or returns STAY, keeps it
        stay = False
        for action in transition.actions:
            try:
                stay = action.call(trigger) is STAY or stay
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._errors.record(action.name, trigger, error)
                return TriggerOutcome.FAILED
        if transition.kind != "internal" and not stay:
            self._change_state(transition, trigger)
        does_something = transition.actions or transition.kind != "internal"
        return TriggerOutcome.TAKEN if does_something else TriggerOutcome.IGNORED

    def _change_state(self, transition: BoundTransition, trigger: Trigger) -> None:
        """Change to the end of a simple or push transition, or back to the state that a pop returns to (AS5684)."""
        if transition.kind == "pop":
            if self._pushed:  # a pop without a push stays where it is
                target = self._pushed.pop()
                self._move(target, target, trigger)
        elif (end := transition.end) is not None:
            if transition.kind == "push":
                if end.contains(self._active):
                    return
                self._pushed.append(self._active)
            self._move(end, end.leaf(), trigger)

    def _move(self, target: MergedState, leaf: MergedState, trigger: Trigger) -> None:
        """Leave up to the state around both, then enter down to `leaf`; a target that is active is left and entered.

        That state is the least common compound ancestor of W3C SCXML (2015), appendix D.
        """
        left = list(self._active.upwards())
        # the innermost state that contains both; None if the whole machine does
        around = target.parent
        while around is not None and not around.contains(self._active):
            around = around.parent
        depth = len(around.path) if around is not None else 0
        # exit actions from the innermost state outward, entry actions from the outermost inward
        for state in left:
            if len(state.path) > depth:
                self._run_each(self._states[state].exit, trigger)
        self._active = leaf
        self._enter(reversed([state for state in leaf.upwards() if len(state.path) > depth]), trigger)

    def _enter(self, states: Iterable[MergedState], trigger: Trigger) -> None:
        for state in states:
            self._run_each(self._states[state].entry, trigger)

    def _run_each(self, actions: Iterable[BoundAction], trigger: Trigger) -> None:
        """Entry and exit actions: an exception in one stops neither the others nor the change of state."""
        for action in actions:
            try:
                action.call(trigger)
            except Exception as error:  # noqa: BLE001 - any bug of a service
                self._errors.record(action.name, trigger, error)


def _catch_all_last(transitions: tuple[BoundTransition, ...]) -> list[BoundTransition]:
    """Sort transitions: those for any trigger come last, the others keep their order."""
    return sorted(transitions, key=lambda transition: transition.key == ANY_TRIGGER)


class CommandCompletion:
    """Reports how a command ended, once. Without `on_ended` nothing waits for that."""

    __slots__ = ("_on_ended", "takes_time")

    def __init__(self, on_ended: Callable[[bool], None] | None = None) -> None:
        self._on_ended = on_ended
        self.takes_time = False
        """True once a service has taken it with `begin_command`, and so calls it itself."""

    def __call__(self, success: bool) -> None:
        """True: it was carried out, False: it was given up. Later calls do nothing."""
        on_ended, self._on_ended = self._on_ended, None
        if on_ended is not None:
            on_ended(success)


class TriggerQueue:
    """Handles triggers one after the other; triggers that arise while one is handled are queued (first in, first out).

    Nothing is handled before `start`, when all services are bound. A trigger that exceeds `MAX_QUEUED_TRIGGERS` is
    passed to `on_dropped`.
    """

    def __init__(self, dispatch: Callable[[Trigger], TriggerOutcome], on_dropped: Callable[[Trigger], None]) -> None:
        self._dispatch = dispatch
        self._on_dropped = on_dropped
        self._queue: deque[tuple[Trigger, CommandCompletion | None]] = deque()
        self._command: CommandCompletion | None = None
        self._busy = True

    def start(self) -> None:
        """Handle what was queued so far, and from now on everything."""
        self._handle_queued()

    def handle(self, trigger: Trigger) -> TriggerOutcome:
        """Handle this trigger now, and then all that follow from it."""
        self._busy = True
        outcome = self._handle(trigger, None)
        self._handle_queued()
        return outcome

    def put(self, trigger: Trigger, completion: CommandCompletion | None = None) -> None:
        """Handle this trigger now, or after the one that is being handled."""
        if not self._busy:
            self._busy = True
            self._handle(trigger, completion)
            self._handle_queued()
        elif len(self._queue) < MAX_QUEUED_TRIGGERS:
            self._queue.append((trigger, completion))
        else:
            self._drop(trigger, completion)

    def begin_command(self) -> CommandCompletion:
        """Begin a command that takes time; returns the function to call when it has ended."""
        command = self._command or CommandCompletion()
        command.takes_time = True
        return command

    def _handle_queued(self) -> None:
        for _ in range(MAX_QUEUED_TRIGGERS):
            if not self._queue:
                break
            self._handle(*self._queue.popleft())
        while self._queue:
            self._drop(*self._queue.popleft())
        self._busy = False

    def _handle(self, trigger: Trigger, completion: CommandCompletion | None) -> TriggerOutcome:
        self._command = completion
        outcome = self._dispatch(trigger)
        self._command = None
        if completion is not None and not (completion.takes_time and outcome is TriggerOutcome.TAKEN):
            completion(outcome is TriggerOutcome.TAKEN)
        return outcome

    def _drop(self, trigger: Trigger, completion: CommandCompletion | None) -> None:
        self._on_dropped(trigger)
        if completion is not None:
            completion(False)
