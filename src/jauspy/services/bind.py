"""Binds what a JSIDL state machine names to methods of the services, once, when a component is made."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from operator import attrgetter
from typing import Final, TypeAlias

from jauspy.codec.base import Message
from jauspy.codec.names import snake
from jauspy.errors import ConfigError
from jauspy.schema import guards, model
from jauspy.schema.inheritance import lineage, parents_among
from jauspy.schema.state_tree import MergedState, Owned
from jauspy.services.later import Later
from jauspy.services.machine import BoundState, Rule, Step
from jauspy.services.service import Service
from jauspy.services.signatures import need
from jauspy.services.trigger import ANY_MESSAGE, Key, Trigger

Reply: TypeAlias = Callable[[object, Trigger, bool], None]
"""Sends (what a report method returned, the trigger, whether to its source or else to the controlling client)."""

_GETTERS: Final[Mapping[str, Callable[[Trigger], object]]] = {
    "msg": attrgetter("msg"),
    "query": attrgetter("msg"),
    "source": attrgetter("source"),
}

_ASYNC: Final = "{} is `async def`, and nobody awaits it; start a task there, which calls `wake()` of the component"


class Binder:
    """Finds the method for each action, predicate and Send; what is not found is collected in `problems`."""

    def __init__(self, definitions: Mapping[str, model.Service], services: Mapping[str, Service], reply: Reply) -> None:
        self._parent_of = parents_among(definitions.values())
        self._services = services
        self._reply = reply
        self.problems: list[str] = []

    def states(self, root: MergedState) -> dict[MergedState, BoundState]:
        """`root`, which has the defaults of the whole machine, and everything below it, bound."""
        return {node: self._state(node, root) for node in root.all()}

    def raise_problems(self) -> None:
        """Raise one `ConfigError` with everything that is missing."""
        if self.problems:
            raise ConfigError("the services cannot run:\n  " + "\n  ".join(dict.fromkeys(self.problems)))

    def _state(self, node: MergedState, root: MergedState) -> BoundState:
        return BoundState(
            # Around the others: what a parent sets up comes before, and goes after, what builds on it.
            entry=tuple(self._step(action, node) for action in reversed(node.entry)),
            exit=tuple(self._step(action, node) for action in node.exit),
            transitions=tuple(self._rule(transition, node, root) for transition in node.transitions),
            defaults=tuple(self._rule(transition, node, root) for transition in node.defaults),
        )

    def _rule(self, owned: Owned[model.Transition], node: MergedState, root: MergedState) -> Rule:
        owner, transition = owned.owner, owned.item
        where = f"{owner.name}, state {node}"
        return Rule(
            name=f"{where}, {_described(transition)}",
            key=self._key(owner, transition, where),
            # JSIDL 1.0 writes what keeps the state as a simple transition without an end state.
            kind="internal" if transition.kind == "simple" and transition.end_state is None else transition.kind,
            guard=self._guard(owned, where),
            steps=tuple(self._step(Owned(owner, action), node) for action in transition.actions),
            end=self._end(transition, root, where),
        )

    def _key(self, owner: model.Service, transition: model.Transition, where: str) -> Key:
        event = transition.trigger.rpartition(".")[2]
        if event != "Receive":
            return event
        if not transition.parameters:
            return ANY_MESSAGE
        wanted = transition.parameters[0].type
        line = lineage(owner, self._parent_of)
        # Outputs come last: a service may be the client of another one of its own kind.
        for message in (*(m for each in line for m in each.inputs), *(m for each in line for m in each.outputs)):
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

        def resolve(call: guards.Call) -> Callable[[Trigger], bool]:
            method = self._method(owned.owner, call.name, f"{where}: predicate")
            bound = self._by_name(method, call.arguments, f"{where}: predicate {call.name}")
            return lambda trigger: bool(bound(trigger))

        return guards.compile_guard(guards.parse(owned.item.guard), resolve)

    def _step(self, owned: Owned[model.Action], node: MergedState) -> Step:
        owner, action = owned.owner, owned.item
        where = f"{owner.name}, state {node}"
        name = f"{where}, action {action.name}"
        if action.name.rpartition(".")[2] == "Send":
            return self._send(owned, where)
        method = self._method(owner, action.name, f"{where}: action")
        call = self._by_name(method, action.arguments, f"{where}: action {action.name}")
        # Newer definitions write sendReportX(msg, transportData) for what is Send('ReportX', transportData) in others.
        return Step(name, self._answering(call, method), sends=bool(need(owner, action.name).reports))

    def _answering(
        self, call: Callable[[Trigger], object], method: Callable[..., object]
    ) -> Callable[[Trigger], object]:
        """A message that an action returns is its answer, now or later."""
        reply = self._reply

        def answering(trigger: Trigger) -> object:
            result = call(trigger)
            if isinstance(result, Later):
                result.comes_from(method.__qualname__, trigger)
            if isinstance(result, Message | Later):
                reply(result, trigger, True)
            return result

        return answering

    def _send(self, owned: Owned[model.Action], where: str) -> Step:
        """`Send('Message', ['CODE',] [msg,] [transportData])`; without transportData to the controlling client."""
        arguments = [argument.strip() for argument in owned.item.arguments]
        # One published definition quotes the name of the parameter; it means the same.
        to_source = any(argument.strip("'\"") == "transportData" for argument in arguments)
        message, *literals = [text for text in _literals(arguments) if text != "transportData"] or [""]
        method = self._method(owned.owner, message, f"{where}: Send of")
        make = self._by_name(method, literals, f"{where}: Send of {message}", quoted=False)
        reply = self._reply

        def report(trigger: Trigger) -> Message | Later | None:
            made = make(trigger)
            if isinstance(made, Later):
                made.comes_from(method.__qualname__, trigger, message)
                return made
            return None if made is None else _checked(made, message, method)

        return Step(
            f"{where}, Send {message}",
            lambda trigger: reply(report(trigger), trigger, to_source),
            sends=True,
            report=report if to_source else None,
        )

    def _method(self, owner: model.Service, dotted: str, what: str) -> Callable[..., object]:
        name = snake(dotted.rpartition(".")[2])
        for definition in lineage(owner, self._parent_of):
            service = self._services[definition.id]
            method = getattr(service, name, None)
            if callable(method) and not _is_hook(service, name) and (definition is owner or not service.private):
                if inspect.iscoroutinefunction(method):
                    self.problems.append(f"{what} {dotted}: {_ASYNC.format(f'{type(service).__name__}.{name}')}")
                return method  # type: ignore[no-any-return]  # getattr by a computed name
            if definition is owner and name in service.omits:
                return _nothing
        self.problems.append(
            f"{what} {dotted} needs a method of {type(self._services[owner.id]).__name__}: "
            f"{need(owner, dotted).signature}"
        )
        return _nothing

    def _by_name(
        self, method: Callable[..., object], arguments: tuple[str, ...] | list[str], what: str, *, quoted: bool = True
    ) -> Callable[[Trigger], object]:
        """A call of `method` with what its parameters name."""
        literals = _literals(arguments) if quoted else list(arguments)
        code = literals[0] if literals else None
        getters: list[Callable[[Trigger], object]] = []
        for parameter in inspect.signature(method).parameters.values():
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


def _is_hook(service: Service, name: str) -> bool:
    """True for what every service has, and this one has not made its own."""
    return name in vars(Service) and getattr(type(service), name) is vars(Service)[name]


def _literals(arguments: tuple[str, ...] | list[str]) -> list[str]:
    return [argument[1:-1] for argument in arguments if argument[:1] in ("'", '"')]


def _checked(report: object, name: str, method: Callable[..., object]) -> Message:
    """The report, if it is the message that the definition sends."""
    if isinstance(report, Message) and name == report.NAME:
        return report
    what = report.NAME if isinstance(report, Message) else repr(report)
    raise TypeError(f"{method.__qualname__} is to return a {name}, a Later or None, and returned {what}")


def _described(transition: model.Transition) -> str:
    what = transition.parameters[0].type if transition.parameters else transition.trigger.rpartition(".")[2]
    return f"on {what or 'anything else'}"


def _nothing() -> None:
    """Stands for a missing method until all of them are known."""
