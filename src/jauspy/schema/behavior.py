"""Readers of protocol behaviour: state machines, and the guards of their transitions.

Guards are predicate calls joined by `&&`, `||`, `!` and parentheses. `parse` returns the tree of a guard,
`compile_guard` one callable with the arguments of the predicates.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Final, Literal, TypeAlias, TypeVar

from lxml.etree import _Element as Element

from jauspy.errors import SchemaError
from jauspy.schema.document import flag, line_of, location, required, suggestion, wrong
from jauspy.schema.model import ActionCall, Behavior, Parameter, Start, State, StateMachine, Transition

Kind = Literal["simple", "internal", "push", "pop"]

_KINDS: Mapping[str, Kind] = {"simple": "simple", "internal": "internal", "push": "push", "pop": "pop"}
_ANY_TRIGGER: Final = ""
_RECEIVE: Final = "Receive"


def read_behavior(element: Element | None, inputs: Collection[str]) -> Behavior | None:
    """Read the protocol behaviour of a service; `inputs` are the names of its input messages.

    A transition with the name of an input is on Receive of this message, as in the JAUS Toolset.
    """
    if element is None:
        return None
    machines = tuple(_machine(part, inputs) for part in element.iterchildren("state_machine"))
    _unique(element.iterchildren("state_machine"))
    return Behavior(
        machines=machines,
        start=tuple(_start(part, machines) for part in element.iterchildren("start")),
        stateless=flag(element, "is_stateless"),
    )


def _unique(elements: Iterable[Element]) -> None:
    seen: dict[str, Element] = {}
    for element in elements:
        name = required(element, "name")
        first = seen.setdefault(name, element)
        if first is not element:
            raise wrong(element, f"duplicate {element.tag} '{name}'; the first is in line {line_of(first)}")


def _start(element: Element, machines: tuple[StateMachine, ...]) -> Start:
    start = Start(required(element, "state_machine_name"), required(element, "state_name"), location(element))
    for machine in machines:
        if machine.name == start.machine:
            return start
    known = suggestion(start.machine, (machine.name for machine in machines))
    raise wrong(element, f"no state machine '{start.machine}'{known}")


def _machine(element: Element, inputs: Collection[str]) -> StateMachine:
    return StateMachine(
        name=required(element, "name"),
        states=_states(element, inputs),
        default_transitions=_defaults(element, inputs),
    )


def _states(parent: Element, inputs: Collection[str]) -> tuple[State, ...]:
    _unique(parent.iterchildren("state"))
    return tuple(_state(part, inputs) for part in parent.iterchildren("state"))


def _state(element: Element, inputs: Collection[str]) -> State:
    return State(
        name=required(element, "name"),
        initial=element.get("initial_state"),
        entry=_actions(element.find("entry")),
        exit=_actions(element.find("exit")),
        transitions=_transitions(element, inputs),
        states=_states(element, inputs),
        default_transitions=_defaults(element, inputs),
        where=location(element),
    )


def _defaults(parent: Element, inputs: Collection[str]) -> tuple[Transition, ...]:
    element = parent.find("default_state")
    return () if element is None else _transitions(element, inputs)


def _transitions(parent: Element, inputs: Collection[str]) -> tuple[Transition, ...]:
    return tuple(_transition(part, inputs) for part in parent.iterchildren("transition", "default_transition"))


def _transition(element: Element, inputs: Collection[str]) -> Transition:
    kind = next(child for child in element if child.tag in _KINDS)
    if kind.tag == "pop" and (len(kind) or "transition" in kind.attrib):
        raise wrong(kind, "a pop that triggers another transition is not supported; no published service has one")
    if kind.tag == "push" and kind.find("simple") is not None:
        raise wrong(kind, "a push with a second transition is not supported; no published service has one")
    end_state = kind.find("end_state")
    guard = element.find("guard")
    trigger = element.get("name", _ANY_TRIGGER)
    parameters = tuple(
        Parameter(required(part, "type"), required(part, "value")) for part in element.iterchildren("parameter")
    )
    if trigger in inputs:
        message = next((parameter for parameter in parameters if parameter.type == trigger), Parameter(trigger, "msg"))
        trigger, parameters = _RECEIVE, (message, *(parameter for parameter in parameters if parameter is not message))
    return Transition(
        trigger=trigger,
        kind=_KINDS[str(kind.tag)],
        parameters=parameters,
        guard="" if guard is None else " ".join(required(guard, "condition").split()),
        end_state=None if end_state is None else required(end_state, "state"),
        actions=_actions(element),
        where=location(element),
    )


def _actions(parent: Element | None) -> tuple[ActionCall, ...]:
    if parent is None:
        return ()
    return tuple(
        ActionCall(required(part, "name"), tuple(required(argument, "value") for argument in part))
        for part in parent.iterchildren("action", "send_action")
    )


_TOKEN: Final = re.compile(r"\s*(?:(&&|\|\||[!(),])|('[^']*'|\"[^\"]*\"|[\w.]+))")
_NO_ARGUMENT: Final = ("", "&&", "||", "!", "(", ",")
_MAX_DEPTH: Final = 64

T = TypeVar("T")
Predicate: TypeAlias = Callable[[T], bool]


@dataclass(frozen=True, slots=True)
class Call:
    """A predicate and its arguments as they are written; a literal keeps its quotes."""

    name: str
    arguments: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Not:
    """True when its operand is not."""

    operand: Guard


@dataclass(frozen=True, slots=True)
class And:
    """True when all operands are."""

    operands: tuple[Guard, ...]


@dataclass(frozen=True, slots=True)
class Or:
    """True when any operand is."""

    operands: tuple[Guard, ...]


Guard: TypeAlias = Call | Not | And | Or


def parse(text: str) -> Guard:
    """Read a guard; `!` binds tighter than `&&`, `&&` tighter than `||`. Raises `SchemaError`."""
    reader = _Reader(text)
    guard = reader.either(0)
    if reader.upcoming:
        raise reader.error("an operator or the end")
    return guard


def calls(guard: Guard) -> Iterator[Call]:
    """Every predicate call, from left to right."""
    match guard:
        case Call():
            yield guard
        case Not(operand):
            yield from calls(operand)
        case And(operands) | Or(operands):
            for operand in operands:
                yield from calls(operand)


def compile_guard(guard: Guard, resolve: Callable[[Call], Predicate[T]]) -> Predicate[T]:
    """One callable for the guard, with each predicate resolved once; operands are evaluated lazily, left to right."""
    match guard:
        case Call():
            return resolve(guard)
        case Not(operand):
            inner = compile_guard(operand, resolve)
            return lambda given: not inner(given)
        case And(operands):
            every = [compile_guard(operand, resolve) for operand in operands]
            return lambda given: all(part(given) for part in every)
        case Or(operands):
            some = [compile_guard(operand, resolve) for operand in operands]
            return lambda given: any(part(given) for part in some)


class _Reader:
    """Recursive descent over the tokens; `upcoming` is the next one, empty at the end."""

    def __init__(self, text: str) -> None:
        self.text = text
        self._at = 0
        self.upcoming = ""
        self.advance()

    def advance(self) -> str:
        """Step to the next token and return the one before it."""
        taken = self.upcoming
        match = _TOKEN.match(self.text, self._at)
        if match is None and self.text[self._at :].strip():
            raise self.error("a predicate, an operator or a parenthesis")
        self.upcoming = match[1] or match[2] if match else ""
        self._at = match.end() if match else len(self.text)
        return taken

    def error(self, expected: str) -> SchemaError:
        """The error for an unexpected token."""
        found = self.upcoming or self.text[self._at :].strip() or "the end"
        return SchemaError(f"guard {self.text!r}: expected {expected}, found {found!r}")

    def either(self, depth: int) -> Guard:
        """`a || b || ...`."""
        operands = [self.both(depth)]
        while self.upcoming == "||":
            self.advance()
            operands.append(self.both(depth))
        return operands[0] if len(operands) == 1 else Or(tuple(operands))

    def both(self, depth: int) -> Guard:
        """`a && b && ...`."""
        operands = [self.single(depth)]
        while self.upcoming == "&&":
            self.advance()
            operands.append(self.single(depth))
        return operands[0] if len(operands) == 1 else And(tuple(operands))

    def single(self, depth: int) -> Guard:
        """`!a`, `(a)` or a predicate."""
        if depth > _MAX_DEPTH:
            raise SchemaError(f"guard {self.text[:40]!r}... is nested deeper than {_MAX_DEPTH}")
        if self.upcoming == "!":
            self.advance()
            return Not(self.single(depth + 1))
        if self.upcoming == "(":
            self.advance()
            inner = self.either(depth + 1)
            self.expect(")")
            return inner
        return self.call()

    def call(self) -> Call:
        """`name(argument, ...)`; the parentheses may be missing."""
        if not self.upcoming.replace(".", "_").isidentifier():
            raise self.error("the name of a predicate")
        name = self.advance()
        arguments: list[str] = []
        if self.upcoming == "(":
            self.advance()
            while self.upcoming != ")":
                if self.upcoming in _NO_ARGUMENT:
                    raise self.error("an argument or ')'")
                arguments.append(self.advance())
                if self.upcoming != ")":
                    self.expect(",")
            self.advance()
        return Call(name, tuple(arguments))

    def expect(self, symbol: str) -> None:
        """Step over exactly this token."""
        if self.upcoming != symbol:
            raise self.error(repr(symbol))
        self.advance()
