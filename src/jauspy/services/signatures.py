"""What the behaviour of a service definition asks of its Python class: which methods, and how they look."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache
from typing import Final, Literal, TypeAlias

from jauspy.codec.names import snake
from jauspy.schema import guards, model

MethodKind: TypeAlias = Literal["action", "predicate", "report"]

_RESULT: Final = {"action": "None", "predicate": "bool"}


@dataclass(slots=True)
class RequiredMethod:
    """One method: its JSIDL name, and from where it is called."""

    jsidl: str
    """The name without the path of the service it may belong to."""
    kind: MethodKind
    reports: str = ""
    """The message it makes, if that can be told from its name."""
    messages: list[str] = field(default_factory=list)
    """The messages it is called for, in the order of the definition."""
    events: list[str] = field(default_factory=list)
    """The internal events it is called for."""
    in_states: list[str] = field(default_factory=list)
    """The states whose entry or exit calls it."""
    literals: list[str] = field(default_factory=list)
    """The codes that it is called with."""

    @property
    def method(self) -> str:
        """The name of the Python method."""
        return snake(self.jsidl)

    @property
    def result(self) -> str:
        """The type it returns."""
        return self.reports or _RESULT.get(self.kind, "Message")

    @property
    def takes_message(self) -> bool:
        """True when every call is for a message that the definition names."""
        return bool(self.messages) and not self.events and not self.in_states

    @property
    def signature(self) -> str:
        """The method as it is to be written."""
        parameters = ["self"]
        if self.takes_message:
            name = "query" if all(each.startswith("Query") for each in self.messages) else "msg"
            parameters.append(f"{name}: {' | '.join(self.messages)}")
        if self.literals:
            parameters.append("code: str")
        return f"def {self.method}({', '.join(parameters)}) -> {self.result}"


@cache
def required_methods(definition: model.Service) -> tuple[RequiredMethod, ...]:
    """Everything that the definition itself calls, in its order; what its parents call is not in it."""
    found: dict[str, RequiredMethod] = {}
    outputs = {message.name for message in definition.outputs}
    for machine in definition.behavior.machines if definition.behavior else ():
        for state in _all(machine.states):
            for action in (*state.entry, *state.exit):
                _called(found, action, outputs).in_states.append(state.name)
            for transition in (*state.transitions, *state.default_transitions):
                _add(found, transition, outputs)
    return tuple(found.values())


def required_method(definition: model.Service, name: str) -> RequiredMethod:
    """What is asked of one method, by the name (dotted or not) in the behaviour that calls it."""
    short = name.rpartition(".")[2]
    return next((each for each in required_methods(definition) if each.jsidl == short), RequiredMethod(short, "action"))


def _all(states: Iterable[model.State]) -> Iterator[model.State]:
    for state in states:
        yield state
        yield from _all(state.states)


def _add(found: dict[str, RequiredMethod], transition: model.Transition, outputs: set[str]) -> None:
    called = [_called(found, action, outputs) for action in transition.actions]
    if transition.guard.strip():
        called += [_predicate(found, call) for call in guards.calls(guards.parse(transition.guard))]
    event = transition.trigger.rpartition(".")[2]
    for each in called:
        if event == "Receive" and transition.parameters:
            _once(each.messages, transition.parameters[0].type)
        else:
            _once(each.events, event)


def _called(found: dict[str, RequiredMethod], action: model.Action, outputs: set[str]) -> RequiredMethod:
    short, kind = action.name.rpartition(".")[2], "action"
    literals = [text[1:-1] for text in action.arguments if text[:1] in ("'", '"')]
    literals = [text for text in literals if text != "transportData"]
    if short == "Send" and literals:
        short, kind, literals = literals[0], "report", literals[1:]
    return _entry(found, short, "report" if kind == "report" else "action", _reported(short, outputs), literals)


def _predicate(found: dict[str, RequiredMethod], call: guards.Call) -> RequiredMethod:
    literals = [text[1:-1] for text in call.arguments if text[:1] in ("'", '"')]
    return _entry(found, call.name.rpartition(".")[2], "predicate", "", literals)


def _entry(
    found: dict[str, RequiredMethod], name: str, kind: MethodKind, reports: str, literals: Iterable[str]
) -> RequiredMethod:
    entry = found.setdefault(name, RequiredMethod(name, kind, reports))
    for literal in literals:
        _once(entry.literals, literal)
    return entry


def _reported(name: str, outputs: set[str]) -> str:
    """The output that an action is named for: `Send('ReportX')`, `sendReportX`, `sendX`, `sendReportXInY`."""
    bare = name.removeprefix("send") if name.startswith("send") else name[:1].upper() + name[1:]
    exact = next((each for each in (name, bare, f"Report{bare}") if each in outputs), "")
    begun = [each for each in outputs if name.startswith("send") and bare.startswith(each)]
    return exact or max(begun, key=len, default="")


def _once(names: list[str], name: str) -> None:
    if name not in names:
        names.append(name)
