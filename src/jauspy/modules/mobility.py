"""CM-MOB, the mobility module: drives the chassis and tells where it is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import datetime
from typing import Final

from jauspy.ids import JausID
from jauspy.modules.config import ModuleConfig
from jauspy.modules.watchdog import Watchdog
from jauspy.platform.contract import DriveBase
from jauspy.services.core import AccessControl, Discovery, Events, Identity, Liveness, Management, Time, Transport
from jauspy.services.host import Host
from jauspy.services.mobility import LocalPoseSensor, PrimitiveDriver, VelocityStateSensor
from jauspy.services.service import Service

CHOICE: Final[Mapping[str, Callable[[DriveBase], Service]]] = {
    "Time": lambda _: Time(),
    "Liveness": lambda _: Liveness(),
    "PrimitiveDriver": PrimitiveDriver,
    "VelocityStateSensor": VelocityStateSensor,
    "LocalPoseSensor": LocalPoseSensor,
}
"""What a configuration may choose from, beside Discovery."""


def cm_mob(
    id: JausID,
    drive: DriveBase,
    config: ModuleConfig,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
) -> Host:
    """The component's host, with a watchdog on the drive. `now`: seconds of the clock that runs the host."""
    chosen = config.services if config.services is not None else ("Discovery", *CHOICE)
    access = config.access_control
    services: list[Service] = [
        Transport(),
        Events(),
        AccessControl(default_authority=access.default_authority, timeout=access.timeout),
        Management(),
    ]
    services += [Discovery(identities) if name == "Discovery" else CHOICE[name](drive) for name in chosen]
    host = Host(id, services, utc_now=utc_now, now=now)
    Watchdog(host, drive)
    return host
