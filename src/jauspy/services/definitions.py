"""Where a component's definitions and messages come from: what is built in, and what its services bring along."""

from __future__ import annotations

from collections.abc import Iterable

from jauspy import messages
from jauspy.codec.registry import Registry
from jauspy.schema.model import Schema
from jauspy.schema.needed import Wanted, load_needed, versions_of
from jauspy.schema.state_tree import check_behavior
from jauspy.services.service import Service


def schema_for(services: Iterable[Service]) -> Schema:
    """The definitions of these services and of all they inherit from; those that services bring along come first.

    Raises `SchemaError` with file and line when one that is brought along cannot run: it was loaded for its messages.
    """
    services = list(services)
    schema = _schema(services, every_version=False)
    ids = [each.id for each in schema.services]
    if len(set(ids)) < len(ids):
        # Two versions of one parent: some service must be content with an older version of itself.
        schema = _schema(services, every_version=True)
    brought = {service.urn for service in services if service.definitions is not None}
    check_behavior([each for each in schema.services if each.id in brought], schema.services)
    return schema


def _schema(services: Iterable[Service], *, every_version: bool) -> Schema:
    brought = [registry.schema for registry in _registries(services) if registry.schema is not None]
    own = {each.key: each for schema in brought for each in schema.services}
    parents = [each.inherits_from for each in own.values() if each.inherits_from is not None]
    wanted: set[Wanted] = {parent.key for parent in parents if parent.key not in own}
    defined = {urn for urn, _ in own}
    for service in services:
        if service.urn not in defined:
            every = every_version and service.version is None
            wanted |= {(service.urn, version) for version in (versions_of(service.urn) if every else [service.version])}
    needed = load_needed(frozenset(wanted))
    return Schema(services=(*own.values(), *(each for each in needed.services if each.key not in own)))


def registry_for(services: Iterable[Service]) -> Registry:
    """The messages of these services, and all that are built in."""
    brought = _registries(services)
    if len(brought) == 1:
        return brought[0]
    if not brought:
        return messages.registry
    return Registry(dict.fromkeys(entry for each in brought for entry in each.entries))


def _registries(services: Iterable[Service]) -> list[Registry]:
    found = {id(service.definitions): service.definitions for service in services}
    return [each for each in found.values() if each is not None]
