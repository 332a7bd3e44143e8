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
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import joint_positions
from jauspy.platform.link_clearances import clearances_of
from jauspy.platform.motors import Motors
from jauspy.services import iop, manipulator
from jauspy.services.service import Service

from .joints import MOTOR_DATA, end_effector_load, joint_description
from .kind import Kind, ModuleBuild, ServiceEntry, Stoppable
from .mounting import mount_of

_INDEPENDENT: Final = "joints from base to tip that do not mimic others"


@dataclass(frozen=True, slots=True)
class ManipulatorContext:
    """Parts from which the services of a CM-MAN are made."""

    module: ClassVar[str] = "CM-MAN"
    robot: RobotParts
    arm: manipulator.Arm
    model: RobotModel
    listed: frozenset[str] = frozenset()
    """The services that the module's table lists."""
    mount: iop.Mount | None = None
    """The joint of another manipulator that carries it."""

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


def _extended(context: ManipulatorContext) -> Service | None:
    if (motors := Motors.of(context.robot)) is None:
        return None
    names = [joint.name for joint in context.arm.joints.joints]
    return iop.ExtendedPrimitiveManipulator(names, motors.state, context.mount)


PRESET_POSE: Final = "PresetPose"


def _preset_pose(context: ManipulatorContext) -> Service | None:
    """The service of an arm with named poses; if it is listed, of any arm, and then perhaps without poses."""
    names = [joint.name for joint in context.arm.joints.joints]
    poses = [pose for pose in context.model.poses if names[0] in pose.positions]
    if not poses and PRESET_POSE not in context.listed:
        return None
    return iop.PresetPose(
        context.arm,
        poses,
        clearances_of(context.model, names),
        lambda: joint_positions(context.robot.groups.values()),
    )


SERVICES: Final[Mapping[str, ServiceEntry[Any]]] = {
    "EnhancedAccessControl": ServiceEntry(ManipulatorContext, lambda _: iop.EnhancedAccessControl(), by_default=False),
    "ManipulatorSpecificationService": _geometry(manipulator.ManipulatorSpecification),
    "PrimitiveManipulator": _arm(manipulator.PrimitiveManipulator),
    "ExtendedPrimitiveManipulator": ServiceEntry(ManipulatorContext, _extended, needs=MOTOR_DATA),
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
    "ManipulatorEndEffectorForceTorqueSensor": ServiceEntry(
        ManipulatorContext,
        lambda context: None if context.arm.is_coupled else end_effector_load(context.robot, context.arm),
        needs="a sensor of force and torque that the tool is fixed to",
    ),
    PRESET_POSE: ServiceEntry(ManipulatorContext, _preset_pose),
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
        stability = build.shared.stability
        guard = manipulator.ArmStability(stability) if stability is not None else None
        arm = manipulator.Arm(build.joints, guard)
        listed = frozenset(build.module.services or ())
        return ManipulatorContext(build.robot, arm, build.model, listed, mount_of(build))

    def joint_frame(self, chain: Sequence[Joint], number: int) -> Transform:
        """The frame by the Denavit-Hartenberg parameters of the arm."""
        geometry = manipulator_geometry(chain)
        return reduce(matmul, (link.frame(link.zero_position) for link in geometry.links[:number]), geometry.base)

    def companions(self, context: ManipulatorContext, services: Sequence[Service]) -> Iterator[Service]:
        """The driver of the component's list."""
        if any(isinstance(service, _LIST_DRIVERS) for service in services):
            yield manipulator.ManipulatorListDriver(context.arm)
