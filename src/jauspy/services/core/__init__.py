"""The core services (AS5710), and those that a component has by default."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Final

from jauspy.services.core.access_control import AccessControl, may_move, present_authority, waits_for_control
from jauspy.services.core.command_seal import CommandSeal
from jauspy.services.core.discovery import COMPONENT, DEFAULT_IDENTITIES, Discovery, Identity
from jauspy.services.core.events import Events
from jauspy.services.core.list_manager import ListDriver, ListManager, ManipulatorListManager, MobilityListManager
from jauspy.services.core.management import FailureRecovery, Liveness, Management, Time, Transport
from jauspy.services.service import Service

__all__ = [
    "INHERITED_DEFAULTS",
    "AccessControl",
    "CommandSeal",
    "Discovery",
    "Events",
    "FailureRecovery",
    "Identity",
    "ListDriver",
    "ListManager",
    "Liveness",
    "Management",
    "Time",
    "Transport",
    "may_move",
    "present_authority",
    "waits_for_control",
    "with_core_services",
]

INHERITED_DEFAULTS: Final[Mapping[str, Callable[[], Service]]] = {
    kind.urn: kind
    for kind in (
        Transport,
        Events,
        AccessControl,
        Management,
        ListManager,
        MobilityListManager,
        ManipulatorListManager,
    )
}


def with_core_services(services: Iterable[Service], name: str) -> list[Service]:
    """Add the core services that are not among these; `name` is reported by Discovery."""
    given = list(services)
    urns = {service.urn for service in given}
    component = Identity(name, DEFAULT_IDENTITIES[COMPONENT].type)
    for service in given:
        if isinstance(service, Discovery):
            service.identities.setdefault(COMPONENT, component)
    core = (Management(), Time(), Liveness(), Discovery({COMPONENT: component}))
    return [*given, *(service for service in core if service.urn not in urns)]
