"""Inheritance of service definitions (AS5684 `inherits_from`): a service has at most one parent.

All code that needs ancestors uses this module. A `ParentOf` returns the parent of a service: `parents_among` makes one
for loaded definitions. The linter, which works on XML elements, has its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeAlias, TypeVar

from jauspy.errors import SchemaError
from jauspy.schema.model import ServiceDefinition

T = TypeVar("T")
ParentOf: TypeAlias = Callable[[T], T | None]
"""Returns the parent of a service, None when it inherits from nothing."""


def parents_among(services: Iterable[ServiceDefinition]) -> ParentOf[ServiceDefinition]:
    """Parents by id and version; the returned function raises `SchemaError` for a parent that is not in `services`."""
    by_key = {service.key: service for service in services}

    def parent_of(service: ServiceDefinition) -> ServiceDefinition | None:
        reference = service.inherits_from
        if reference is None:
            return None
        if reference.key not in by_key:
            raise SchemaError(f"{service.name} inherits from {reference.id} {reference.version}, which is not loaded")
        return by_key[reference.key]

    return parent_of


def lineage(service: T, parent_of: ParentOf[T]) -> tuple[T, ...]:
    """The service, then its ancestors, nearest first. A cycle ends where it would repeat a service."""
    line = [service]
    while (parent := parent_of(line[-1])) is not None and parent not in line:
        line.append(parent)
    return tuple(line)


def is_a(service: ServiceDefinition, urn: str, parent_of: ParentOf[ServiceDefinition]) -> bool:
    """True when the service has this URN, or inherits from one that has it, whatever its version."""
    return any(ancestor.id == urn for ancestor in lineage(service, parent_of))


def most_derived_first(
    services: Iterable[ServiceDefinition], parent_of: ParentOf[ServiceDefinition]
) -> tuple[ServiceDefinition, ...]:
    """Order services and all their ancestors as in a component: one per URN, the longest lineage first.

    Where lineages bring different versions of one service, the version that comes first is kept.
    """
    found: dict[str, tuple[ServiceDefinition, int]] = {}
    for service in services:
        line = lineage(service, parent_of)
        for position, ancestor in enumerate(line):
            found.setdefault(ancestor.id, (ancestor, len(line) - position))
    return tuple(service for service, _ in sorted(found.values(), key=lambda pair: -pair[1]))
