"""The pan-tilt unit that carries a camera, and its services."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from jauspy.errors import ConfigError
from jauspy.geometry.frames import FrameTree
from jauspy.modules.config import ModuleConfig
from jauspy.modules.sensors import frame_of
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import JointGroup
from jauspy.services.manipulator import (
    PanTilt,
    PanTiltJointPositionDriver,
    PanTiltJointPositionSensor,
    PanTiltJointVelocityDriver,
    PanTiltJointVelocitySensor,
    PanTiltMotionProfile,
    PanTiltSpecification,
    PrimitivePanTilt,
)
from jauspy.services.service import Service

CHOICE: Final[Mapping[str, Callable[[PanTilt], Service]]] = {
    "PrimitivePanTilt": PrimitivePanTilt,
    "PanTiltJointPositionSensor": PanTiltJointPositionSensor,
    "PanTiltJointPositionDriver": PanTiltJointPositionDriver,
    "PanTiltJointVelocitySensor": PanTiltJointVelocitySensor,
    "PanTiltJointVelocityDriver": PanTiltJointVelocityDriver,
    "PanTiltMotionProfileService": PanTiltMotionProfile,
    "PanTiltSpecificationService": PanTiltSpecification,
}
"""What a configuration may choose from, of a camera that has a unit."""


def unit_of(module: ModuleConfig, model: RobotModel, groups: Mapping[str, JointGroup]) -> PanTilt | None:
    """The unit that carries the module's camera; None when nothing moves it alone."""
    if module.group is None:
        return None
    if module.group not in groups:
        raise ConfigError(f"{module.component} moves the group {module.group!r}, and the backend has no such joints")
    base = model.groups[module.group].base
    return PanTilt(groups[module.group], frame_of(FrameTree(model.description), base, groups))


def services_of(unit: PanTilt, module: ModuleConfig) -> list[Service]:
    """Those that the module offers."""
    return [make(unit) for name, make in CHOICE.items() if module.offers(name)]
