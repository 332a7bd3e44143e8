"""CM-MAN: an arm."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import matmul
from typing import Any, ClassVar, Final

from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Joint
from jauspy.platform.contract import RobotParts
from jauspy.services import manipulator
from jauspy.services.service import Service

from .joints import joint_description
from .kind import Kind, ModuleBuild, ServiceEntry, Stoppable

_INDEPENDENT: Final = "joints from base to tip that do not mimic others"


@dataclass(frozen=True, slots=True)
class ManipulatorContext:
    """Parts from which the services of a CM-MAN are made."""

    module: ClassVar[str] = "CM-MAN"
    robot: RobotParts
    arm: manipulator.Arm

    @property
    def moving(self) -> Stoppable:
        """The arm."""
        return self.arm


def _arm(make: Callable[[manipulator.Arm], Service]) -> ServiceEntry[ManipulatorContext]:
    return ServiceEntry(ManipulatorContext, lambda context: make(context.arm))


def _geometry(make: Callable[[manipulator.Arm], Service]) -> ServiceEntry[ManipulatorContext]:
    """A service that needs the geometry of the arm, which the standard describes by independent joints only."""
    return ServiceEntry(
        ManipulatorContext, lambda context: None if context.arm.is_coupled else make(context.arm), needs=_INDEPENDENT
    )


SERVICES: Final[Mapping[str, ServiceEntry[Any]]] = {
    "ManipulatorSpecificationService": _geometry(manipulator.ManipulatorSpecification),
    "PrimitiveManipulator": _arm(manipulator.PrimitiveManipulator),
    "ManipulatorJointPositionSensor": _arm(manipulator.JointPositionSensor),
    "ManipulatorJointVelocitySensor": _arm(manipulator.JointVelocitySensor),
    "ManipulatorJointForceTorqueSensor": _arm(manipulator.JointForceTorqueSensor),
    "ManipulatorJointPositionDriver": _arm(manipulator.JointPositionDriver),
    "ManipulatorJointVelocityDriver": _arm(manipulator.JointVelocityDriver),
    "ManipulatorActuatorForceTorqueDriver": _arm(manipulator.ActuatorForceTorqueDriver),
    "ManipulatorJointMotionProfile": _arm(manipulator.JointMotionProfile),
    "ManipulatorJointPositionListDriver": _arm(manipulator.JointPositionListDriver),
    "ManipulatorEndEffectorPoseSensor": _geometry(manipulator.EndEffectorPoseSensor),
    "ManipulatorEndEffectorPoseDriver": _geometry(manipulator.EndEffectorPoseDriver),
    "ManipulatorEndEffectorPoseListDriver": _geometry(manipulator.EndEffectorPoseListDriver),
    "ManipulatorEndEffectorVelocityStateSensor": _geometry(manipulator.EndEffectorVelocityStateSensor),
    "ManipulatorEndEffectorVelocityStateDriver": _geometry(manipulator.EndEffectorVelocityStateDriver),
    "ManipulatorToolOffsetService": _geometry(manipulator.ToolOffset),
    "JointDescription": ServiceEntry(ManipulatorContext, lambda context: joint_description(context.robot, context.arm)),
}

_LIST_DRIVERS: Final = (manipulator.JointPositionListDriver, manipulator.EndEffectorPoseListDriver)
"""Services that carry out the component's list, with a ManipulatorListDriver."""


class ManipulatorKind(Kind[ManipulatorContext]):
    """The kind CM-MAN."""

    type: ClassVar[str] = "CM-MAN"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = SERVICES
    own_keys: ClassVar[frozenset[str]] = frozenset({"group"})
    group: ClassVar[str | None] = "arm"

    def context(self, build: ModuleBuild) -> ManipulatorContext:
        """The arm."""
        return ManipulatorContext(build.robot, manipulator.Arm(build.joints))

    def joint_frame(self, chain: Sequence[Joint], number: int) -> Transform:
        """The frame by the Denavit-Hartenberg parameters of the arm."""
        geometry = manipulator_geometry(chain)
        return reduce(matmul, (link.frame(link.zero_position) for link in geometry.links[:number]), geometry.base)

    def companions(self, context: ManipulatorContext, services: Sequence[Service]) -> Iterator[Service]:
        """The driver of the component's list."""
        if any(isinstance(service, _LIST_DRIVERS) for service in services):
            yield manipulator.ManipulatorListDriver(context.arm)
