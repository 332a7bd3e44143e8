"""CM-EEF, the end-effector module: closes and opens the gripper, and tells how far it is open."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import datetime

from jauspy.ids import JausID
from jauspy.modules.capability import capability
from jauspy.modules.config import ModuleConfig
from jauspy.platform.joints import JointGroup
from jauspy.services.core import Identity
from jauspy.services.host import Host
from jauspy.services.manipulator import Arm, JointPositionSensor, PrimitiveEndEffector
from jauspy.services.service import Service


def cm_eef(
    id: JausID,
    gripper: JointGroup,
    manipulator: JausID,
    config: ModuleConfig,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
) -> Host:
    """The component's host, with a watchdog on the gripper; `manipulator` is the module that carries it."""
    driver = PrimitiveEndEffector(gripper, manipulator)
    services: list[Service] = [driver]
    if config.offers("ManipulatorJointPositionSensor"):
        services.append(JointPositionSensor(Arm(gripper)))
    return capability(id, config, services, driver, identities=identities, utc_now=utc_now, now=now)
