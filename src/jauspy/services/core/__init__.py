"""The core services (AS5710)."""

from jauspy.services.core.access_control import AccessControl
from jauspy.services.core.command_seal import CommandSeal
from jauspy.services.core.discovery import Discovery, Identity
from jauspy.services.core.events import Events
from jauspy.services.core.list_manager import ListDriver, ListManager
from jauspy.services.core.management import FailureRecovery, Liveness, Management, Time, Transport

__all__ = [
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
]
