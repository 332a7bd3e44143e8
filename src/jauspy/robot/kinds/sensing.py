"""CM-SEN: lidars, and sensors of force and torque."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Final

from jauspy.geometry.frames import FrameTree
from jauspy.platform.contract import PartId, RobotParts
from jauspy.platform.ranging import RangeFinder
from jauspy.services import iop
from jauspy.services.environment_sensing import (
    ForceTorqueSensorService,
    MountedForceTorqueSensor,
    MountedLidar,
    RangeSensor,
)

from .kind import Kind, Module, ModuleBuild, ServiceEntry
from .mounting import frame_of, joint_of

LIDARS: Final = "lidars"
FORCE_TORQUE: Final = "sensors of force and torque"


@dataclass(frozen=True, slots=True)
class SensorContext:
    """Parts from which the services of a CM-SEN are made."""

    module: ClassVar[str] = "CM-SEN"
    moving: ClassVar[None] = None
    robot: RobotParts
    lidars: tuple[MountedLidar, ...]
    force_torque: tuple[MountedForceTorqueSensor, ...]
    """The sensors of force and torque."""


SERVICES: Final[Mapping[str, ServiceEntry[Any]]] = {
    "RangeSensor": ServiceEntry(
        SensorContext, lambda context: RangeSensor(context.lidars) if context.lidars else None, needs=LIDARS
    ),
    "ForceTorqueSensor": ServiceEntry(
        SensorContext,
        lambda context: ForceTorqueSensorService(context.force_torque) if context.force_torque else None,
        needs=FORCE_TORQUE,
    ),
    "IOPForceTorqueSensor": ServiceEntry(
        SensorContext,
        lambda context: iop.ForceTorqueSensor(context.force_torque) if context.force_torque else None,
        needs=FORCE_TORQUE,
    ),
}


class Sensing(Kind[SensorContext]):
    """The kind CM-SEN."""

    type: ClassVar[str] = "CM-SEN"
    services: ClassVar[Mapping[str, ServiceEntry[Any]]] = SERVICES

    def context(self, build: ModuleBuild) -> SensorContext:
        """The sensors, in the order of the robot's description."""
        tree, robot = FrameTree(build.model.description), build.robot
        lidars = tuple(
            MountedLidar(
                frame_of(tree, lidar.setup.link, robot.groups),
                tree.is_fixed(lidar.setup.link),
                joint_of(build.modules, build.model, lidar.setup.link),
                lidar=lidar,
            )
            for lidar in robot.lidars.values()
        )
        force_torque = tuple(
            MountedForceTorqueSensor(sensor, frame_of(tree, sensor.setup.link, robot.groups))
            for sensor in robot.force_torque.values()
        )
        return SensorContext(robot, lidars, force_torque)

    def uses(self, module: Module, part: PartId) -> bool:
        """True for lidars."""
        return part.kind is RangeFinder
