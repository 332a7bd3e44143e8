"""Binds the actions, predicates and reports that JSIDL state machines name to methods of services.

This happens once, when a component is made. `required_methods` lists the methods that a definition needs; `jauspy new`
writes them.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Container, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache, lru_cache
from operator import attrgetter
from typing import Final, Literal, TypeAlias

from jauspy.codec.message import Message
from jauspy.codec.names import method as method_name
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.schema import behavior, model
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.model import Schema, ServiceDefinition as Definition
from jauspy.schema.state_tree import MergedState, Owned, merge_machines, short_name, walk_states
from jauspy.services.core import INHERITED_DEFAULTS
from jauspy.services.deferred import Deferred
from jauspy.services.definitions import definitions_of, schema_for
from jauspy.services.service import BoundServices, Service
from jauspy.services.state_machine import (
    ANY_MESSAGE,
    ANY_TRIGGER,
    ActionErrors,
    BoundAction,
    BoundState,
    BoundTransition,
    MachineInstance,
    Trigger,
    TriggerKey,
)

MethodKind: TypeAlias = Literal["action", "predicate", "report"]

SendReply: TypeAlias = Callable[[object, Trigger, bool], None]
"""Sends a report: (what the method returned, the trigger, whether to its source or else to the controlling client)."""

_RESULT: Final = {"action": "None", "predicate": "bool"}
_GETTERS: Final[Mapping[str, Callable[[Trigger], object]]] = {
    "msg": attrgetter("msg"),
    "query": attrgetter("msg"),
    "source": attrgetter("source"),
}
_ASYNC: Final = "{} is `async def`, and nothing awaits it; start a task there, which calls `wake()` of the component"


@dataclass(slots=True)
class RequiredMethod:
    """A method that a definition calls: its JSIDL name, and what calls it."""

    jsidl: str
    """The name without the path of the service it may belong to."""
    kind: MethodKind
    reports: str = ""
    """The message that it returns, if its name contains one."""
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
        return method_name(self.jsidl)

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
        """The signature that the method must have."""
        parameters = ["self"]
        if self.takes_message:
            name = "query" if all(message.startswith("Query") for message in self.messages) else "msg"
            parameters.append(f"{name}: {' | '.join(self.messages)}")
        if self.literals:
            parameters.append("code: str")
        return f"def {self.method}({', '.join(parameters)}) -> {self.result}"


@cache
def required_methods(definition: model.ServiceDefinition) -> tuple[RequiredMethod, ...]:
    """The methods that the definition itself calls, in its order, without those that its parents call."""
    found: dict[str, RequiredMethod] = {}
    outputs = {message.name for message in definition.outputs}
    for machine in definition.behavior.machines if definition.behavior else ():
        for _, state in walk_states(machine.states):
            for action in (*state.entry, *state.exit):
                _required_by_action(found, action, outputs).in_states.append(state.name)
            for transition in (*state.transitions, *state.default_transitions):
                _add_transition(found, transition, outputs)
    return tuple(found.values())


def required_method(definition: model.ServiceDefinition, name: str) -> RequiredMethod:
    """One required method, by the name (dotted or not) in the behaviour that calls it."""
    short = short_name(name)
    return _required_by_name(definition).get(short) or RequiredMethod(short, "action")


@cache
def _required_by_name(definition: model.ServiceDefinition) -> dict[str, RequiredMethod]:
    return {method.jsidl: method for method in required_methods(definition)}


def _add_transition(found: dict[str, RequiredMethod], transition: model.Transition, outputs: set[str]) -> None:
    called = [_required_by_action(found, action, outputs) for action in transition.actions]
    if transition.guard.strip():
        called += [_required_by_guard(found, call) for call in behavior.calls(behavior.parse(transition.guard))]
    event = short_name(transition.trigger)
    for method in called:
        if event == "Receive" and transition.parameters:
            _append_new(method.messages, transition.parameters[0].type)
        else:
            _append_new(method.events, event)


def _required_by_action(
    found: dict[str, RequiredMethod], action: model.ActionCall, outputs: set[str]
) -> RequiredMethod:
    short, kind = short_name(action.name), "action"
    literals = [text for text in _literals(action.arguments) if text != "transportData"]
    if short == "Send" and literals:
        short, kind, literals = literals[0], "report", literals[1:]
    return _required(found, short, "report" if kind == "report" else "action", _reported(short, outputs), literals)


def _required_by_guard(found: dict[str, RequiredMethod], call: behavior.Call) -> RequiredMethod:
    return _required(found, short_name(call.name), "predicate", "", _literals(call.arguments))


def _required(
    found: dict[str, RequiredMethod], name: str, kind: MethodKind, reports: str, literals: Iterable[str]
) -> RequiredMethod:
    entry = found.setdefault(name, RequiredMethod(name, kind, reports))
    for literal in literals:
        _append_new(entry.literals, literal)
    return entry


def _reported(name: str, outputs: set[str]) -> str:
    """The output that an action is named for: `Send('ReportX')`, `sendReportX`, `sendX`, `sendReportXInY`."""
    bare = name.removeprefix("send") if name.startswith("send") else name[:1].upper() + name[1:]
    exact = next((candidate for candidate in (name, bare, f"Report{bare}") if candidate in outputs), "")
    begun = [output for output in outputs if name.startswith("send") and bare.startswith(output)]
    return exact or max(begun, key=len, default="")


def _append_new(names: list[str], name: str) -> None:
    if name not in names:
        names.append(name)


class Binder:
    """Finds the method for each action, predicate and Send; collects in `problems` what is missing."""

    def __init__(
        self, definitions: Mapping[str, model.ServiceDefinition], services: Mapping[str, Service], reply: SendReply
    ) -> None:
        self._parent_of = parents_among(definitions.values())
        self._lineages: dict[model.ServiceDefinition, tuple[model.ServiceDefinition, ...]] = {}
        self._services = services
        self._reply = reply
        self.problems: list[str] = []

    def states(self, root: MergedState) -> dict[MergedState, BoundState]:
        """Bind `root`, which has the defaults of the whole machine, and all states below it."""
        return {state: self._state(state, root) for state in root.all()}

    def raise_problems(self) -> None:
        """Raise one `ConfigError` with all problems, if there are any."""
        if self.problems:
            raise ConfigError("the services cannot run:\n  " + "\n  ".join(dict.fromkeys(self.problems)))

    def _state(self, state: MergedState, root: MergedState) -> BoundState:
        return BoundState(
            # Entry actions of a parent run before, exit actions after those of a service that inherits from it.
            entry=tuple(self._action(action, state) for action in reversed(state.entry)),
            exit=tuple(self._action(action, state) for action in state.exit),
            transitions=tuple(self._transition(transition, state, root) for transition in state.transitions),
            defaults=tuple(self._transition(transition, state, root) for transition in state.defaults),
        )

    def _transition(self, owned: Owned[model.Transition], state: MergedState, root: MergedState) -> BoundTransition:
        owner, transition = owned.owner, owned.item
        where = f"{owner.name}, state {state}"
        return BoundTransition(
            name=f"{where}, {_described(transition)}",
            key=self._key(owner, transition, where),
            # JSIDL 1.0 writes what keeps the state as a simple transition without an end state.
            kind="internal" if transition.kind == "simple" and transition.end_state is None else transition.kind,
            guard=self._guard(owned, where),
            actions=tuple(self._action(Owned(owner, action), state) for action in transition.actions),
            end=self._end(transition, root, where),
        )

    def _line(self, owner: model.ServiceDefinition) -> tuple[model.ServiceDefinition, ...]:
        """The service and its ancestors, looked up once."""
        if owner not in self._lineages:
            self._lineages[owner] = lineage(owner, self._parent_of)
        return self._lineages[owner]

    def _key(self, owner: model.ServiceDefinition, transition: model.Transition, where: str) -> TriggerKey:
        event = short_name(transition.trigger)
        if event != "Receive":
            service = self._services[owner.id]
            return service.own_event(event) if event in service.own_events else event
        if not transition.parameters:
            return ANY_MESSAGE
        wanted = transition.parameters[0].type
        line = self._line(owner)
        # Outputs come last: a service may be the client of another one of its own kind.
        for message in (
            *(m for definition in line for m in definition.inputs),
            *(m for definition in line for m in definition.outputs),
        ):
            if message.name == wanted:
                return message.code
        self.problems.append(f"{where}: receives {wanted}, which is no message of {owner.name} or its parents")
        return wanted

    def _end(self, transition: model.Transition, root: MergedState, where: str) -> MergedState | None:
        if transition.end_state is None:
            if transition.kind == "push":
                self.problems.append(f"{where}: a push transition without an end state")
            return None
        end = root.find(transition.end_state)
        if end is None:
            self.problems.append(f"{where}: goes to {transition.end_state}, which is not a state")
        return end

    def _guard(self, owned: Owned[model.Transition], where: str) -> Callable[[Trigger], bool] | None:
        if not owned.item.guard.strip():
            return None

        def resolve(call: behavior.Call) -> Callable[[Trigger], bool]:
            method = self._method(owned.owner, call.name, f"{where}: predicate")
            bound = self._with_arguments(method, call.arguments, f"{where}: predicate {call.name}")
            return lambda trigger: bool(bound(trigger))

        return behavior.compile_guard(behavior.parse(owned.item.guard), resolve)

    def _action(self, owned: Owned[model.ActionCall], state: MergedState) -> BoundAction:
        owner, action = owned.owner, owned.item
        where = f"{owner.name}, state {state}"
        if short_name(action.name) == "Send":
            return self._send(owned, where)
        method = self._method(owner, action.name, f"{where}: action")
        call = self._with_arguments(method, action.arguments, f"{where}: action {action.name}")
        # Newer definitions write sendReportX(msg, transportData) for what is Send('ReportX', transportData) in others.
        sends = bool(required_method(owner, action.name).reports)
        return BoundAction(f"{where}, action {action.name}", self._replying(call, method), sends)

    def _replying(
        self, call: Callable[[Trigger], object], method: Callable[..., object]
    ) -> Callable[[Trigger], object]:
        """Wrap `call`: a message that it returns, immediately or deferred, is sent to the source of the trigger."""
        reply = self._reply

        def run(trigger: Trigger) -> object:
            result = call(trigger)
            if isinstance(result, Deferred):
                result.set_origin(method.__qualname__, trigger)
            if isinstance(result, Message | Deferred):
                reply(result, trigger, True)
            return result

        return run

    def _send(self, owned: Owned[model.ActionCall], where: str) -> BoundAction:
        """`Send('Message', ['CODE',] [msg,] [transportData])`; without transportData to the controlling client."""
        arguments = [argument.strip() for argument in owned.item.arguments]
        # One published definition quotes the name of the parameter; it means the same.
        to_source = any(argument.strip("'\"") == "transportData" for argument in arguments)
        message, *literals = [text for text in _literals(arguments) if text != "transportData"] or [""]
        method = self._method(owned.owner, message, f"{where}: Send of")
        make = self._with_arguments(method, literals, f"{where}: Send of {message}", quoted=False)
        reply = self._reply

        def report(trigger: Trigger) -> Message | Deferred | None:
            made = make(trigger)
            if isinstance(made, Deferred):
                made.set_origin(method.__qualname__, trigger, message)
                return made
            return None if made is None else _check_report(made, message, method)

        return BoundAction(
            f"{where}, Send {message}",
            lambda trigger: reply(report(trigger), trigger, to_source),
            sends=True,
            report=report if to_source else None,
        )

    def _method(self, owner: model.ServiceDefinition, dotted: str, what: str) -> Callable[..., object]:
        name = method_name(short_name(dotted))
        for definition in self._line(owner):
            service = self._services[definition.id]
            method = getattr(service, name, None)
            if (
                callable(method)
                and not _is_inherited_hook(service, name)
                and (definition is owner or not service.private)
            ):
                if inspect.iscoroutinefunction(method):
                    self.problems.append(f"{what} {dotted}: {_ASYNC.format(f'{type(service).__name__}.{name}')}")
                return method  # type: ignore[no-any-return]  # getattr by a computed name
            if definition is owner and name in service.omits:
                return _missing_method
        self.problems.append(
            f"{what} {dotted} needs a method of {type(self._services[owner.id]).__name__}: "
            f"{required_method(owner, dotted).signature}"
        )
        return _missing_method

    def _with_arguments(
        self, method: Callable[..., object], arguments: tuple[str, ...] | list[str], what: str, *, quoted: bool = True
    ) -> Callable[[Trigger], object]:
        """A call of `method` with the arguments that its parameters name."""
        literals = _literals(arguments) if quoted else list(arguments)
        code = literals[0] if literals else None
        getters: list[Callable[[Trigger], object]] = []
        for parameter in _parameters(method):
            if parameter.name in _GETTERS and parameter.kind is parameter.POSITIONAL_OR_KEYWORD:
                getters.append(_GETTERS[parameter.name])
            elif parameter.name == "code" and parameter.kind is parameter.POSITIONAL_OR_KEYWORD:
                getters.append(lambda _: code)
            elif parameter.default is parameter.empty:
                known = ", ".join((*_GETTERS, "code"))
                self.problems.append(f"{what}: parameter `{parameter.name}` is not one of {known}")
        match getters:
            case []:
                return lambda _: method()
            case [only]:
                return lambda trigger: method(only(trigger))
            case [first, second]:
                return lambda trigger: method(first(trigger), second(trigger))
        return lambda trigger: method(*[get(trigger) for get in getters])


def _parameters(method: Callable[..., object]) -> tuple[inspect.Parameter, ...]:
    """The parameters with which a bound method or another callable is called."""
    if inspect.ismethod(method):
        return _parameters_of_function(method.__func__)[1:]
    return tuple(inspect.signature(method).parameters.values())


@lru_cache(maxsize=4096)
def _parameters_of_function(function: Callable[..., object]) -> tuple[inspect.Parameter, ...]:
    return tuple(inspect.signature(function).parameters.values())


def _is_inherited_hook(service: Service, name: str) -> bool:
    """True for a method of `Service` that this service does not override."""
    return name in vars(Service) and getattr(type(service), name) is vars(Service)[name]


def _literals(arguments: tuple[str, ...] | list[str]) -> list[str]:
    return [argument[1:-1] for argument in arguments if argument[:1] in ("'", '"')]


def _check_report(report: object, name: str, method: Callable[..., object]) -> Message:
    """The report; raises `TypeError` when it is not the message that the definition sends."""
    if isinstance(report, Message) and name == report.NAME:
        return report
    what = report.NAME if isinstance(report, Message) else repr(report)
    raise TypeError(f"{method.__qualname__} must return a {name}, a Deferred or None; it returned {what}")


def _described(transition: model.Transition) -> str:
    what = transition.parameters[0].type if transition.parameters else short_name(transition.trigger)
    return f"on {what or 'anything else'}"


def _missing_method() -> None:
    """Placeholder for a missing method until all problems are collected, and for one that a service omits."""


def bind_services(
    services: Iterable[Service], schema: Schema | None, registry: Registry, reply: SendReply, errors: ActionErrors
) -> BoundServices:
    """Bind and check everything; raises `ConfigError` that names all missing methods with their signatures."""
    given = _by_urn(services)
    if schema is None:
        schema = schema_for(given.values())
    definitions = definitions_of(given.values(), schema)
    all_services = {urn: given.get(urn) or _default(urn) for urn in definitions}
    binder = Binder(definitions, all_services, reply)
    merged = merge_machines(definitions.values())
    for machine in merged.values():
        machine.check_initials()
    bound = {name: binder.states(item.root) for name, item in merged.items()}
    binder.raise_problems()
    machines = {name: MachineInstance(states, merged[name].start(), errors) for name, states in bound.items()}
    transitions = [(transition, name) for name, states in bound.items() for transition in _transitions(states.values())]
    events: dict[TriggerKey, MachineInstance] = {
        transition.key: machines[name] for transition, name in transitions if isinstance(transition.key, str)
    }
    received = {transition.key for transition, _ in transitions if isinstance(transition.key, int)}
    queries = frozenset(
        transition.key for transition, _ in transitions if isinstance(transition.key, int) and _is_answer(transition)
    )
    inputs = _inputs(definitions.values(), received, registry)
    names = {event.name for definition in definitions.values() for event in definition.internal_events}
    names |= {key for key in events if isinstance(key, str) and key not in (ANY_MESSAGE, ANY_TRIGGER)}
    return BoundServices(
        services=all_services,
        definitions=definitions,
        machines=machines,
        receiver=machines.get("ReceiveFSM"),
        inputs=inputs,
        events=events,
        event_names=frozenset(names),
        queries=queries,
    )


def _transitions(states: Iterable[BoundState]) -> Iterable[BoundTransition]:
    return (transition for state in states for transition in state.transitions + state.defaults)


def _is_answer(transition: BoundTransition) -> bool:
    return transition.kind == "internal" and any(action.sends for action in transition.actions)


def _by_urn(services: Iterable[Service]) -> dict[str, Service]:
    found: dict[str, Service] = {}
    for service in services:
        if not service.urn:
            raise ConfigError(f"{type(service).__name__} names no definition; write class ...(Service, urn='urn:...')")
        if service.urn in found:
            raise ConfigError(f"{service.urn} is given twice; a component has each service once")
        found[service.urn] = service
    return found


def _default(urn: str) -> Service:
    if urn not in INHERITED_DEFAULTS:
        raise ConfigError(f"{urn} is a parent of one of the component's services, but not among them; add it")
    return INHERITED_DEFAULTS[urn]()


def _inputs(
    definitions: Iterable[Definition], received: Container[int], registry: Registry
) -> dict[int, type[Message]]:
    """The class of each message that the component takes, of the version of its service that the component runs."""
    found: dict[int, type[Message]] = {}
    for definition in definitions:
        for message in definition.messages:
            if message in definition.inputs or message.code in received:
                for kind in registry.by_code(message.code):
                    if definition.id == kind.SERVICE and definition.version == kind.VERSION:
                        _check_distinct(found.setdefault(message.code, kind), kind)
    return found


def _check_distinct(first: type[Message], second: type[Message]) -> None:
    """Raise `ConfigError` for two inputs of different services with the same message id."""
    if first.NAME != second.NAME and first.SERVICE != second.SERVICE:
        raise ConfigError(
            f"message id {first.CODE:04X} is {first.NAME} of {first.SERVICE} and {second.NAME} of {second.SERVICE}; "
            "a component cannot tell them apart: change one id, or give the services to two components"
        )
