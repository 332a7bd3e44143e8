"""What all capability modules are made of: the core services, those of their own, and a watchdog."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from datetime import datetime

from jauspy.ids import JausID
from jauspy.modules.config import ModuleConfig
from jauspy.modules.watchdog import Stoppable, Watchdog
from jauspy.services.core import AccessControl, Discovery, Events, Identity, Liveness, Management, Time, Transport
from jauspy.services.host import Host
from jauspy.services.service import Service


def capability(
    id: JausID,
    config: ModuleConfig,
    services: Sequence[Service],
    moving: Stoppable | None = None,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
) -> Host:
    """The host of a module, with a watchdog on what it moves. `now`: seconds of the clock that runs the host."""
    access = config.access_control
    made: list[Service] = [
        Transport(),
        Events(),
        AccessControl(default_authority=access.default_authority, timeout=access.timeout),
        Management(),
    ]
    optional: dict[str, Callable[[], Service]]
    optional = {"Discovery": lambda: Discovery(identities), "Time": Time, "Liveness": Liveness}
    made += [make() for name, make in optional.items() if config.offers(name)]
    host = Host(id, [*made, *services], utc_now=utc_now, now=now)
    if moving is not None:
        Watchdog(host, moving)
    return host
