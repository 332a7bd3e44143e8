"""Protocol behaviour: state machines."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Literal

from lxml.etree import _Element as Element

from jauspy.schema.document import flag, line_of, location, required, suggestion, wrong
from jauspy.schema.model import Action, Behavior, Parameter, Start, State, StateMachine, Transition

Kind = Literal["simple", "internal", "push", "pop"]

_KINDS: Mapping[str, Kind] = {"simple": "simple", "internal": "internal", "push": "push", "pop": "pop"}
_ANY_TRIGGER = ""


def read_behavior(element: Element | None) -> Behavior | None:
    """The protocol behaviour of a service."""
    if element is None:
        return None
    machines = tuple(_machine(part) for part in element.iterchildren("state_machine"))
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


def _machine(element: Element) -> StateMachine:
    return StateMachine(
        name=required(element, "name"),
        states=_states(element),
        default_transitions=_defaults(element),
    )


def _states(parent: Element) -> tuple[State, ...]:
    _unique(parent.iterchildren("state"))
    return tuple(_state(part) for part in parent.iterchildren("state"))


def _state(element: Element) -> State:
    return State(
        name=required(element, "name"),
        initial=element.get("initial_state"),
        entry=_actions(element.find("entry")),
        exit=_actions(element.find("exit")),
        transitions=_transitions(element),
        states=_states(element),
        default_transitions=_defaults(element),
        where=location(element),
    )


def _defaults(parent: Element) -> tuple[Transition, ...]:
    element = parent.find("default_state")
    return () if element is None else _transitions(element)


def _transitions(parent: Element) -> tuple[Transition, ...]:
    return tuple(_transition(part) for part in parent.iterchildren("transition", "default_transition"))


def _transition(element: Element) -> Transition:
    kind = next(child for child in element if child.tag in _KINDS)
    if kind.tag == "pop" and (len(kind) or "transition" in kind.attrib):
        raise wrong(kind, "a pop that triggers another transition is not supported; no published service has one")
    if kind.tag == "push" and kind.find("simple") is not None:
        raise wrong(kind, "a push with a second transition is not supported; no published service has one")
    end_state = kind.find("end_state")
    guard = element.find("guard")
    return Transition(
        trigger=element.get("name", _ANY_TRIGGER),
        kind=_KINDS[str(kind.tag)],
        parameters=tuple(
            Parameter(required(part, "type"), required(part, "value")) for part in element.iterchildren("parameter")
        ),
        guard="" if guard is None else " ".join(required(guard, "condition").split()),
        end_state=None if end_state is None else required(end_state, "state"),
        actions=_actions(element),
        where=location(element),
    )


def _actions(parent: Element | None) -> tuple[Action, ...]:
    if parent is None:
        return ()
    return tuple(
        Action(required(part, "name"), tuple(required(argument, "value") for argument in part))
        for part in parent.iterchildren("action", "send_action")
    )
