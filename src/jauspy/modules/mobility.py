"""CM-MOB, the mobility module: drives the chassis and tells where it is."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from datetime import datetime
from typing import Final

from jauspy.ids import JausID
from jauspy.modules.capability import capability
from jauspy.modules.config import GLOBAL_SERVICES, ModuleConfig, RobotConfig
from jauspy.platform.chassis import chassis_of
from jauspy.platform.contract import DriveBase
from jauspy.platform.description import RobotModel
from jauspy.services.core import Identity
from jauspy.services.host import Host
from jauspy.services.mobility import (
    AccelerationStateSensor,
    GlobalPose,
    GlobalPoseSensor,
    GlobalVectorDriver,
    GlobalWaypointDriver,
    GlobalWaypointListDriver,
    LocalPoseSensor,
    LocalVectorDriver,
    LocalWaypointDriver,
    LocalWaypointListDriver,
    PrimitiveDriver,
    Vehicle,
    VelocityStateDriver,
    VelocityStateSensor,
)
from jauspy.services.service import Service
from jauspy.services.ugv import PlatformSpecifications, SkidSteerDriver

CHOICE: Final[Mapping[str, Callable[[Vehicle], Service]]] = {
    "PrimitiveDriver": PrimitiveDriver,
    "VelocityStateSensor": VelocityStateSensor,
    "VelocityStateDriver": VelocityStateDriver,
    "AccelerationStateSensor": AccelerationStateSensor,
    "LocalPoseSensor": LocalPoseSensor,
    "LocalVectorDriver": LocalVectorDriver,
    "LocalWaypointDriver": LocalWaypointDriver,
    "LocalWaypointListDriver": LocalWaypointListDriver,
    "GlobalPoseSensor": GlobalPoseSensor,
    "GlobalVectorDriver": GlobalVectorDriver,
    "GlobalWaypointDriver": GlobalWaypointDriver,
    "GlobalWaypointListDriver": GlobalWaypointListDriver,
    "SkidSteerDriver": SkidSteerDriver,
    "PlatformSpecifications": PlatformSpecifications,
}
"""What a configuration may choose from, beside the core services."""


def vehicle_of(config: RobotConfig, model: RobotModel, drive: DriveBase) -> Vehicle:
    """The robot's chassis as it is described, and where its world lies on the globe, as its services share them."""
    place = None
    if (origin := config.origin) is not None:
        place = GlobalPose(origin.latitude, origin.longitude, origin.altitude, math.radians(origin.heading))
    return Vehicle(drive, name=config.name, chassis=chassis_of(model), origin=place)


def cm_mob(
    id: JausID,
    vehicle: Vehicle,
    config: ModuleConfig,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
) -> Host:
    """The component's host, with a watchdog on the drive. `now`: seconds of the clock that runs the host."""
    names = [name for name in CHOICE if config.offers(name)]
    if config.services is None and not vehicle.has_origin:
        names = [name for name in names if name not in GLOBAL_SERVICES]
    services = [CHOICE[name](vehicle) for name in names]
    return capability(id, config, services, vehicle.pilot, identities=identities, utc_now=utc_now, now=now)
