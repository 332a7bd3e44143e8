"""The core services of every component, whatever else it offers (AS5710)."""

from __future__ import annotations

from collections.abc import Iterable

from jauspy.services.core.discovery import COMPONENT, DEFAULT_IDENTITIES, Discovery, Identity
from jauspy.services.core.management import Liveness, Management, Time
from jauspy.services.service import Service


def with_core_services(services: Iterable[Service], name: str) -> list[Service]:
    """These services, and the core ones that are not among them; `name` is what Discovery calls the component."""
    given = list(services)
    urns = {service.urn for service in given}
    component = Identity(name, DEFAULT_IDENTITIES[COMPONENT].type)
    for service in given:
        if isinstance(service, Discovery):
            service.identities.setdefault(COMPONENT, component)
    core = (Management(), Time(), Liveness(), Discovery({COMPONENT: component}))
    return [*given, *(service for service in core if service.urn not in urns)]
