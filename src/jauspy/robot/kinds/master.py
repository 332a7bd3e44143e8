"""CM-MAS: what concerns the robot as a whole."""

from __future__ import annotations

import platform
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from typing import Any, ClassVar, Final

from jauspy.geometry.rigid_parts import RigidPart, RigidParts
from jauspy.platform.battery import Battery
from jauspy.platform.contract import RobotParts
from jauspy.platform.description import RobotModel
from jauspy.platform.guards import ObstacleGuard, SelfCollisionGuard, guards_of
from jauspy.platform.joints import joint_positions
from jauspy.services import iop, ugv
from jauspy.services.service import Service

from .health_checks import health_checks
from .kind import Kind, ModuleBuild, ServiceEntry
from .mounting import mount_sites


@dataclass(frozen=True, slots=True)
class MasterContext:
    """Parts from which the services of a CM-MAS are made."""

    module: ClassVar[str] = "CM-MAS"
    moving: ClassVar[None] = None
    build: ModuleBuild
    """The robot that the module belongs to, with all of its modules."""

    @property
    def robot(self) -> RobotParts:
        """The robot's parts."""
        return self.build.robot

    @property
    def model(self) -> RobotModel:
        """The robot's description."""
        return self.build.model


def _software(_context: MasterContext) -> Service:
    return iop.SoftwareVersionReporting(
        [
            iop.SoftwareRelease("jauspy", version("jauspy"), "JAUS node manager, services and operator control"),
            iop.SoftwareRelease("Python", platform.python_version(), "runs jauspy"),
        ]
    )


def _data_logging(context: MasterContext) -> Service | None:
    logger = context.build.shared.traffic_logger
    return None if logger is None else iop.DataLogging(logger)


def _parts_of(context: MasterContext) -> Callable[[], Sequence[RigidPart]]:
    """The rigid parts of the robot in its present posture."""
    parts, groups = RigidParts(context.model.description), context.robot.groups
    return lambda: parts.at(joint_positions(groups.values()))


def _health(context: MasterContext) -> Service:
    shared = context.build.shared
    return iop.HealthReporter(health_checks(context.build), shared.reminders, shared.hours)


def _self_collision(context: MasterContext) -> Service | None:
    guard = SelfCollisionGuard.of(context.robot)
    return None if guard is None else iop.SelfCollisionAvoidancePolicyManager(guard)


def _guarded_teleop(context: MasterContext) -> Service | None:
    guard = ObstacleGuard.of(context.robot)
    return None if guard is None else iop.GuardedTeleopPolicyManager(guard)


def _motion_guards(context: MasterContext) -> Service | None:
    guards = tuple(guards_of(context.robot))
    return iop.MotionGuards(guards) if guards else None


_LINKS: Final = "links that can touch each other, and numpy"
_CHASSIS: Final = "a chassis, a lidar or a camera, and numpy"


def _platform_state(context: MasterContext) -> Service:
    return iop.PlatformState(id for id in context.build.modules if id != context.build.id)


SERVICES: Final[Mapping[str, ServiceEntry[Any]]] = {
    "EnhancedAccessControl": ServiceEntry(MasterContext, lambda _: iop.EnhancedAccessControl()),
    "PlatformState": ServiceEntry(MasterContext, _platform_state),
    "PlatformMode": ServiceEntry(MasterContext, lambda _: iop.PlatformMode()),
    "UnsolicitedHeartbeat": ServiceEntry(MasterContext, lambda _: iop.UnsolicitedHeartbeat()),
    "UnsolicitedBroadcastControlAvailable": ServiceEntry(
        MasterContext, lambda _: iop.UnsolicitedBroadcastControlAvailable()
    ),
    "SoftwareVersionReporting": ServiceEntry(MasterContext, _software),
    "DataLogging": ServiceEntry(MasterContext, _data_logging, needs="a folder for recordings, as of `jauspy up`"),
    "PhysicalSpecificationService": ServiceEntry(
        MasterContext, lambda context: iop.PhysicalSpecification(_parts_of(context))
    ),
    "ComponentPhysicalProperties": ServiceEntry(
        MasterContext, lambda context: iop.ComponentPhysicalProperties(_parts_of(context))
    ),
    "Communicator": ServiceEntry(MasterContext, lambda _: iop.Communicator()),
    "NodeIDAllocator": ServiceEntry(
        MasterContext, lambda context: iop.NodeIDAllocator(lambda: {id.node for id in context.build.modules})
    ),
    "SubsystemIDAllocator": ServiceEntry(
        MasterContext,
        lambda _: iop.SubsystemIDAllocator(),
        by_default=False,  # a system must have one only, and robots do not know of each other
    ),
    "MountSiteProperties": ServiceEntry(
        MasterContext, lambda context: iop.MountSiteProperties(mount_sites(context.build.modules, context.model))
    ),
    "HealthReporter": ServiceEntry(MasterContext, _health),
    "PowerPlantManager": ServiceEntry(
        MasterContext,
        lambda context: ugv.PowerPlantManager(battery) if (battery := Battery.of(context.robot)) else None,
        needs="a battery ([battery])",
    ),
    "SelfCollisionAvoidancePolicyManager": ServiceEntry(MasterContext, _self_collision, needs=_LINKS),
    "GuardedTeleopPolicyManager": ServiceEntry(MasterContext, _guarded_teleop, needs=_CHASSIS),
    "MotionGuards": ServiceEntry(MasterContext, _motion_guards, needs=f"{_LINKS}; or {_CHASSIS}"),
}


class Master(Kind[MasterContext]):
    """The kind CM-MAS."""

    type: ClassVar[str] = "CM-MAS"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = SERVICES

    def context(self, build: ModuleBuild) -> MasterContext:
        """The robot as a whole."""
        return MasterContext(build)
