"""Puts a component's services together: definitions, merged machines, bound actions and the messages it takes."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping
from dataclasses import dataclass

from jauspy.codec.base import Message
from jauspy.codec.registry import Registry
from jauspy.errors import ConfigError
from jauspy.schema.model import Schema, Service as Definition
from jauspy.schema.state_tree import merge_machines
from jauspy.services.bind import Binder, Reply
from jauspy.services.core.defaults import DEFAULTS
from jauspy.services.definitions import schema_for
from jauspy.services.isolation import Bugs
from jauspy.services.lineage import definitions_of
from jauspy.services.machine import BoundState, Machine, Rule
from jauspy.services.service import Service
from jauspy.services.trigger import ANY_MESSAGE, ANY_TRIGGER, Key


@dataclass(frozen=True, slots=True)
class Built:
    """The parts of a component."""

    services: Mapping[str, Service]
    definitions: Mapping[str, Definition]
    machines: Mapping[str, Machine]
    receiver: Machine | None
    """The machine for messages, and for internal events that no machine names."""
    inputs: Mapping[int, type[Message]]
    events: Mapping[Key, Machine]
    """The machine that each internal event is for."""
    event_names: frozenset[str]
    """The internal events that the definitions have, whether a transition waits for them or not."""
    queries: frozenset[int]
    """Codes of messages that are answered without a change of state."""


def build(services: Iterable[Service], schema: Schema | None, registry: Registry, reply: Reply, bugs: Bugs) -> Built:
    """Everything bound and checked; raises `ConfigError` with all that is missing."""
    given = _by_urn(services)
    if schema is None:
        schema = schema_for(given.values())
    definitions = definitions_of(given.values(), schema)
    all_services = {urn: given.get(urn) or _default(urn) for urn in definitions}
    binder = Binder(definitions, all_services, reply)
    merged = merge_machines(definitions.values())
    for each in merged.values():
        each.check_initials()
    bound = {name: binder.states(each.root) for name, each in merged.items()}
    binder.raise_problems()
    machines = {name: Machine(states, merged[name].start(), bugs) for name, states in bound.items()}
    rules = [(rule, name) for name, states in bound.items() for rule in _rules(states.values())]
    events: dict[Key, Machine] = {rule.key: machines[name] for rule, name in rules if isinstance(rule.key, str)}
    received = {rule.key for rule, _ in rules if isinstance(rule.key, int)}
    queries = frozenset(rule.key for rule, _ in rules if isinstance(rule.key, int) and _answers(rule))
    inputs = _inputs(definitions.values(), received, registry)
    names = {event.name for each in definitions.values() for event in each.internal_events}
    names |= {key for key in events if isinstance(key, str) and key not in (ANY_MESSAGE, ANY_TRIGGER)}
    return Built(
        all_services, definitions, machines, machines.get("ReceiveFSM"), inputs, events, frozenset(names), queries
    )


def _rules(states: Iterable[BoundState]) -> Iterable[Rule]:
    return (rule for state in states for rule in state.transitions + state.defaults)


def _answers(rule: Rule) -> bool:
    return rule.kind == "internal" and any(step.sends for step in rule.steps)


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
    if urn not in DEFAULTS:
        raise ConfigError(f"{urn} is inherited from and is not among the component's services; add it")
    return DEFAULTS[urn]()


def _inputs(
    definitions: Iterable[Definition], received: Container[int], registry: Registry
) -> dict[int, type[Message]]:
    """The class for each message the component takes: that of the version of the service it runs."""
    found: dict[int, type[Message]] = {}
    for definition in definitions:
        for message in definition.messages:
            if message in definition.inputs or message.code in received:
                for kind in registry.by_code(message.code):
                    if definition.id == kind.SERVICE and definition.version == kind.VERSION:
                        _distinct(found.setdefault(message.code, kind), kind)
    return found


def _distinct(first: type[Message], second: type[Message]) -> None:
    """Refuse two inputs of different services with one id."""
    if first.NAME != second.NAME and first.SERVICE != second.SERVICE:
        raise ConfigError(
            f"message id {first.CODE:04X} is {first.NAME} of {first.SERVICE} and {second.NAME} of {second.SERVICE}; "
            "a component cannot tell them apart: change one id, or give the services to two components"
        )
