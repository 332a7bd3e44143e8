"""CM-EEF: a gripper."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Final

from jauspy.geometry.fingers import FingerWidth, finger_width
from jauspy.ids import JausID
from jauspy.platform.contract import RobotParts
from jauspy.services import iop, manipulator
from jauspy.services.service import Service

from .joints import joint_description
from .kind import Kind, ModuleBuild, ServiceEntry, Stoppable
from .manipulator import ManipulatorKind


@dataclass(frozen=True, slots=True)
class EndEffectorContext:
    """Parts from which the services of a CM-EEF are made."""

    module: ClassVar[str] = "CM-EEF"
    robot: RobotParts
    arm: manipulator.Arm
    """The joints of the gripper."""
    driver: manipulator.PrimitiveEndEffector
    width: FingerWidth | None = None
    """How wide its fingers are open; None if that is not known."""

    @property
    def moving(self) -> Stoppable:
        """The gripper."""
        return self.driver


SERVICES: Final[Mapping[str, ServiceEntry[Any]]] = {
    "EnhancedAccessControl": ServiceEntry(EndEffectorContext, lambda _: iop.EnhancedAccessControl(), by_default=False),
    "PrimitiveEndEffector": ServiceEntry(EndEffectorContext, lambda context: context.driver),
    "ManipulatorJointPositionSensor": ServiceEntry(
        EndEffectorContext, lambda context: manipulator.JointPositionSensor(context.arm)
    ),
    "ManipulatorJointForceTorqueSensor": ServiceEntry(
        EndEffectorContext, lambda context: manipulator.JointForceTorqueSensor(context.arm)
    ),
    "JointDescription": ServiceEntry(
        EndEffectorContext, lambda context: joint_description(context.robot, context.arm, context.width)
    ),
}


class EndEffector(Kind[EndEffectorContext]):
    """The kind CM-EEF."""

    type: ClassVar[str] = "CM-EEF"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = SERVICES
    own_keys: ClassVar[frozenset[str]] = frozenset({"group"})
    group: ClassVar[str | None] = "gripper"

    def context(self, build: ModuleBuild) -> EndEffectorContext:
        """The joints of the gripper, and the arm that carries it."""
        joints = build.joints
        driver = manipulator.PrimitiveEndEffector(joints, _carrier(build))
        width = finger_width(build.model.description, [joint.name for joint in joints.joints])
        return EndEffectorContext(build.robot, manipulator.Arm(joints), driver, width)

    def older_versions(self, context: EndEffectorContext, services: Sequence[Service]) -> Iterator[Service]:
        """The specification of the gripper's joints."""
        if any(isinstance(service, manipulator.PrimitiveEndEffector) for service in services):
            yield manipulator.ManipulatorSpecification(context.arm)


def _carrier(build: ModuleBuild) -> JausID:
    """The CM-MAN whose joints carry the end effector of a module; the module itself when none does."""
    description, groups = build.model.description, build.model.groups
    base = groups[build.module.moves or ""].base
    carrying = {joint.name for joint in description.chain(description.root(), base)}
    for id, module in build.modules.items():
        group = groups.get(module.moves or "")
        if isinstance(module.kind, ManipulatorKind) and group is not None and carrying.intersection(group.joints):
            return id
    return build.id
