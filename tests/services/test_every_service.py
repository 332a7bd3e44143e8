"""Every shipped service runs from its definition: what the engine does is what a plain reading of the JSIDL says.

A component is made of the service and all it inherits from, with made-up actions that log their names and predicates
that say what they are told to. A second, slow interpreter reads the same JSIDL by the words of ADR 3. Both get the same
inputs, legal and illegal ones, and must agree on actions and states until every state has been active.
"""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cache
from itertools import product

import pytest
from tests.helpers.sampling import sampled

from jauspy.codec.names import snake
from jauspy.protocol.counters import Counters
from jauspy.schema import behavior, load_builtin, model
from jauspy.schema.state_tree import merge_machines, short_name
from jauspy.services.binding import Binder
from jauspy.services.definitions import definitions_of
from jauspy.services.service import Service
from jauspy.services.state_machine import ActionErrors, MachineInstance, Trigger

DEEPEST = 2
"""Pushed states that are followed; more of them are more of the same."""

SCHEMA = load_builtin()
SERVICES = [each for each in SCHEMA.services if each.behavior]
IDS = [f"{each.id.rpartition(':')[0].rpartition(':')[2]}-{each.name}-{each.version}" for each in SERVICES]


@dataclass
class Script:
    """What was called, and what predicates are to say."""

    called: list[str] = field(default_factory=list)
    truth: dict[str, bool] = field(default_factory=dict)


class Willing(Service):
    """Has a method for everything."""

    def __init__(self, script: Script) -> None:
        self.script = script

    def __getattr__(self, name: str) -> Callable[[], bool | None]:
        return lambda: self._call(name)

    def _call(self, name: str) -> bool | None:
        if name in self.script.truth:
            return self.script.truth[name]
        self.script.called.append(name)
        return None


def lineage(definition: model.ServiceDefinition) -> list[model.ServiceDefinition]:
    """The definition and its ancestors."""
    found = [definition]
    while (parent := found[-1].inherits_from) is not None:
        found.append(SCHEMA.service(parent.id, parent.version))
    return found


# --- the plain reading


@dataclass
class Plain:
    """A state machine as the definitions have it, state by state, without merging or compiling anything."""

    definitions: list[model.ServiceDefinition]
    name: str
    script: Script
    active: str = ""
    pushed: list[str] = field(default_factory=list)
    _states: dict[str, list[model.State]] = field(default_factory=dict)

    def states(self, path: str) -> list[model.State]:
        """What each definition says about one state, most derived first."""
        if path not in self._states:
            machines = [m for d in self.definitions for m in d.behavior.machines if short_name(m.name) == self.name]
            self._states[path] = [state for m in machines for state in _at(m.states, path.split("."))]
        return self._states[path]

    def leaf(self, path: str) -> str:
        while children := list(dict.fromkeys(child.name for state in self.states(path) for child in state.states)):
            initial = [state.initial for state in self.states(path) if state.initial in children]
            path = f"{path}.{(initial or children)[0]}"
        return path

    def upwards(self, path: str) -> list[str]:
        parts = path.split(".")
        return [".".join(parts[:n]) for n in range(len(parts), 0, -1)]

    def candidates(self) -> Iterator[model.Transition]:
        """Innermost first; in the active state its own before its defaults, around it the other way round."""
        for path in self.upwards(self.active):
            own = [each for state in self.states(path) for each in state.transitions]
            defaults = [each for state in self.states(path) for each in state.default_transitions]
            yield from own + defaults if path == self.active else defaults + own

    def handle(self, message: str | None, event: str) -> None:
        for transition in self.candidates():
            if _fits(transition, message, event) and self.holds(transition):
                self.take(transition)
                return

    def holds(self, transition: model.Transition) -> bool:
        if not transition.guard.strip():
            return True
        return _value(_parse(transition.guard), lambda call: self.script.truth[_predicate(call)])

    def take(self, transition: model.Transition) -> None:
        self.script.called += [_method(action) for action in transition.actions]
        if transition.kind == "pop" and self.pushed:
            self.move(self.pushed.pop())
        elif transition.kind == "push" and transition.end_state:
            if not f"{self.active}.".startswith(f"{transition.end_state}."):
                self.pushed.append(self.active)
                self.move(transition.end_state)
        elif transition.kind == "simple" and transition.end_state:
            self.move(transition.end_state)

    def move(self, target: str) -> None:
        leaf = self.leaf(target)
        around = [path for path in self.upwards(target)[1:] if path in self.upwards(self.active)]
        kept = set(self.upwards(around[0])) if around else set()
        for path in self.upwards(self.active):
            if path not in kept:
                self.script.called += [_method(a) for state in self.states(path) for a in state.exit]
        self.active = leaf
        for path in reversed(self.upwards(leaf)):
            if path not in kept:
                self.script.called += [_method(a) for state in reversed(self.states(path)) for a in state.entry]


def _at(states: tuple[model.State, ...], path: list[str]) -> Iterator[model.State]:
    for state in states:
        if state.name == path[0]:
            yield from [state] if len(path) == 1 else _at(state.states, path[1:])


def _fits(transition: model.Transition, message: str | None, event: str) -> bool:
    if transition.trigger.rpartition(".")[2] != event:
        return False
    return event != "Receive" or not transition.parameters or transition.parameters[0].type == message


def _value(guard: behavior.Guard, truth: Callable[[behavior.Call], bool]) -> bool:
    match guard:
        case behavior.Call():
            return truth(guard)
        case behavior.Not(operand):
            return not _value(operand, truth)
        case behavior.And(operands):
            return all(_value(each, truth) for each in operands)
        case behavior.Or(operands):
            return any(_value(each, truth) for each in operands)


def _method(action: model.ActionCall) -> str:
    name = action.name.rpartition(".")[2]
    if name == "Send":
        name = next(argument.strip("'\"") for argument in action.arguments)
    return snake(name.rpartition(".")[2])


# --- both, side by side


class Pair:
    """The engine and the plain reading of the same service."""

    def __init__(self, definition: model.ServiceDefinition, name: str) -> None:
        self.engine_script, self.plain_script = Script(), Script()
        definitions = lineage(definition)
        services = {
            each.id: type("One", (Willing,), {}, urn=each.id, version=each.version)(self.engine_script)
            for each in definitions
        }
        found = definitions_of(services.values(), SCHEMA)
        assert [each.id for each in found.values()] == [each.id for each in definitions]
        binder = Binder(found, services, lambda *_: None)
        merged = merge_machines(found.values())
        bound = {each: binder.states(machine.root) for each, machine in merged.items()}
        binder.raise_problems()
        start = merged[name].start()
        self.plain = Plain(definitions, name, self.plain_script)
        self.machine = MachineInstance(bound[name], start, ActionErrors(Counters(logging.getLogger("test"))))
        self.plain.active = str(start)
        inputs = {m.name: m.code for each in reversed(definitions) for m in each.inputs}
        outputs = {m.name: m.code for each in reversed(definitions) for m in each.outputs}
        # an output with the code of an input, as MilitaryIllumination has one, is that input to a receiver
        self.codes = {name: code for name, code in outputs.items() if code not in inputs.values()} | inputs

    def all(self) -> Iterator[model.Transition]:
        waiting = [
            state
            for definition in self.plain.definitions
            for machine in definition.behavior.machines
            if short_name(machine.name) == self.plain.name
            for state in machine.states
        ]
        while waiting:
            state = waiting.pop()
            waiting += state.states
            yield from state.transitions + state.default_transitions

    def inputs(self) -> list[tuple[str | None, str]]:
        """Every message that the lineage takes, every event that it names, and one that it does not."""
        named = {_input(each) for each in self.all()}
        received = {(name, "Receive") for name in self.codes}
        return sorted((named | received | {(None, "Nonsense")}) - {(None, "Receive")}, key=str)

    def at(self) -> tuple[object, ...]:
        """Where both are, so that they can be put there again."""
        return self.machine._active, tuple(self.machine._pushed), self.plain.active, tuple(self.plain.pushed)

    def put(self, at: tuple) -> None:
        self.machine._active, pushed, self.plain.active, plain_pushed = at
        self.machine._pushed = deque(pushed)
        self.plain.pushed = list(plain_pushed)

    def truths(self, message: str | None, event: str) -> Iterator[dict[str, bool]]:
        """All that the predicates which this input may ask can say."""
        fitting = [each for each in self.plain.candidates() if each.guard.strip() and _fits(each, message, event)]
        names = sorted({_predicate(call) for each in fitting for call in behavior.calls(_parse(each.guard))})
        for values in product((False, True), repeat=len(names)):
            yield dict(zip(names, values, strict=True))

    def step(self, message: str | None, event: str, truth: dict[str, bool]) -> None:
        for script in (self.engine_script, self.plain_script):
            script.called.clear()
            script.truth = truth
        before = self.machine.state
        key = self.codes[message] if event == "Receive" and message else event
        self.machine.handle(Trigger(key))
        self.plain.handle(message, event)
        case = (before, message, event, truth)
        assert self.engine_script.called == self.plain_script.called, case
        assert self.machine.state == self.plain.active, case
        assert list(self.machine.pushed) == self.plain.pushed, case


def _input(transition: model.Transition) -> tuple[str | None, str]:
    return transition.parameters[0].type if transition.parameters else None, transition.trigger.rpartition(".")[2]


@cache
def _parse(guard: str) -> behavior.Guard:
    return behavior.parse(guard)


def _predicate(call: behavior.Call) -> str:
    return snake(call.name.rpartition(".")[2])


@pytest.mark.parametrize("definition", sampled(SERVICES, 50), ids=IDS)
def test_engine_matches_a_simple_interpreter(definition: model.ServiceDefinition) -> None:
    """In every state that can be reached: every input, with all that the predicates may say about it."""
    pair = Pair(definition, "ReceiveFSM")
    inputs = pair.inputs()
    waiting = [pair.at()]
    reached = {waiting[0][2:]}
    while waiting:
        at = waiting.pop()
        pair.put(at)
        for message, event in inputs:
            for truth in pair.truths(message, event):
                pair.put(at)
                pair.step(message, event, truth)
                here = pair.at()
                if here[2:] not in reached and len(pair.plain.pushed) <= DEEPEST:
                    reached.add(here[2:])
                    waiting.append(here)
            pair.put(at)
    wanted = {pair.plain.leaf(each.end_state) for each in pair.all() if each.end_state}
    assert wanted <= {active for active, _ in reached}
