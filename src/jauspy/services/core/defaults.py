"""The core services that a component gets by itself when something inherits from them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from jauspy.services.core.access_control import AccessControl
from jauspy.services.core.events import Events
from jauspy.services.core.list_manager import ListManager, ManipulatorListManager, MobilityListManager
from jauspy.services.core.management import Management, Transport
from jauspy.services.service import Service

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
