"""CM-MAN, the manipulator module: moves the arm and tells where it is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import datetime
from typing import Final

from jauspy.ids import JausID
from jauspy.modules.capability import capability
from jauspy.modules.config import ModuleConfig
from jauspy.platform.joints import JointGroup
from jauspy.services.core import Identity
from jauspy.services.host import Host
from jauspy.services.manipulator import (
    ActuatorForceTorqueDriver,
    Arm,
    EndEffectorPoseDriver,
    EndEffectorPoseListDriver,
    EndEffectorPoseSensor,
    EndEffectorVelocityStateDriver,
    EndEffectorVelocityStateSensor,
    JointForceTorqueSensor,
    JointMotionProfile,
    JointPositionDriver,
    JointPositionListDriver,
    JointPositionSensor,
    JointVelocityDriver,
    JointVelocitySensor,
    ManipulatorListDriver,
    ManipulatorSpecification,
    PrimitiveManipulator,
    ToolOffset,
)
from jauspy.services.service import Service

CHOICE: Final[Mapping[str, Callable[[Arm], Service]]] = {
    "ManipulatorSpecificationService": ManipulatorSpecification,
    "PrimitiveManipulator": PrimitiveManipulator,
    "ManipulatorJointPositionSensor": JointPositionSensor,
    "ManipulatorJointVelocitySensor": JointVelocitySensor,
    "ManipulatorJointForceTorqueSensor": JointForceTorqueSensor,
    "ManipulatorJointPositionDriver": JointPositionDriver,
    "ManipulatorJointVelocityDriver": JointVelocityDriver,
    "ManipulatorActuatorForceTorqueDriver": ActuatorForceTorqueDriver,
    "ManipulatorJointMotionProfile": JointMotionProfile,
    "ManipulatorJointPositionListDriver": JointPositionListDriver,
    "ManipulatorEndEffectorPoseSensor": EndEffectorPoseSensor,
    "ManipulatorEndEffectorPoseDriver": EndEffectorPoseDriver,
    "ManipulatorEndEffectorPoseListDriver": EndEffectorPoseListDriver,
    "ManipulatorEndEffectorVelocityStateSensor": EndEffectorVelocityStateSensor,
    "ManipulatorEndEffectorVelocityStateDriver": EndEffectorVelocityStateDriver,
    "ManipulatorToolOffsetService": ToolOffset,
}
"""What a configuration may choose from, beside the core services."""

LISTS: Final = ("ManipulatorJointPositionListDriver", "ManipulatorEndEffectorPoseListDriver")
"""Those that carry out the component's list."""


def cm_man(
    id: JausID,
    joints: JointGroup,
    config: ModuleConfig,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
) -> Host:
    """The component's host, with a watchdog on the arm."""
    arm = Arm(joints)
    services: list[Service] = [make(arm) for name, make in CHOICE.items() if config.offers(name)]
    if any(config.offers(name) for name in LISTS):
        services.append(ManipulatorListDriver(arm))
    return capability(id, config, services, arm, identities=identities, utc_now=utc_now, now=now)
