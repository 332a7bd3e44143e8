"""CM-SEN, the sensor module: tells what the lidars and the sensors of force and torque measure."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Protocol, Self

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.poses import Transform
from jauspy.ids import JausID
from jauspy.modules.capability import capability
from jauspy.modules.carriers import carrier_of
from jauspy.modules.config import ModuleConfig, RobotConfig
from jauspy.platform.description import RobotModel
from jauspy.platform.force_torque import ForceTorqueSensor as Gauge
from jauspy.platform.joints import JointGroup, joint_positions
from jauspy.platform.ranging import RangeFinder
from jauspy.services.core import Identity
from jauspy.services.environment_sensing import ForceTorqueSensor, Mounted, MountedGauge, RangeSensor
from jauspy.services.host import Host
from jauspy.services.service import Service


class Carrier(Protocol):
    """What carries sensors."""

    @property
    def groups(self) -> Mapping[str, JointGroup]:
        """The joints that move them."""
        ...

    @property
    def lidars(self) -> Mapping[str, RangeFinder]:
        """The lidars."""
        ...

    @property
    def force_torque(self) -> Mapping[str, Gauge]:
        """The sensors of force and torque."""
        ...


@dataclass(frozen=True, slots=True)
class Sensors:
    """A robot's sensors, and where each is on the robot, whatever its joints do."""

    lidars: tuple[Mounted, ...]
    gauges: tuple[MountedGauge, ...]

    @classmethod
    def of(cls, config: RobotConfig, model: RobotModel, body: Carrier) -> Self:
        """All of them, in the order of its description."""
        tree, groups = FrameTree(model.description), body.groups
        lidars = ((lidar, lidar.setup.link) for lidar in body.lidars.values())
        gauges = ((gauge, gauge.setup.link) for gauge in body.force_torque.values())
        return cls(
            tuple(
                Mounted(frame_of(tree, link, groups), tree.is_fixed(link), carrier_of(config, model, link), lidar=lidar)
                for lidar, link in lidars
            ),
            tuple(MountedGauge(gauge, frame_of(tree, link, groups)) for gauge, link in gauges),
        )


def frame_of(tree: FrameTree, link: str, groups: Mapping[str, JointGroup]) -> Callable[[], Transform]:
    """Tells where a link is in the root link's frame now."""
    if tree.is_fixed(link):
        fixed = tree.pose(link)
        return lambda: fixed
    return lambda: tree.pose(link, joint_positions(groups.values()))


def cm_sen(
    id: JausID,
    sensors: Sensors,
    config: ModuleConfig,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
) -> Host:
    """The component's host; it moves nothing."""
    services: list[Service] = []
    if sensors.lidars and config.offers("RangeSensor"):
        services.append(RangeSensor(sensors.lidars))
    if sensors.gauges and config.offers("ForceTorqueSensor"):
        services.append(ForceTorqueSensor(sensors.gauges))
    return capability(id, config, services, identities=identities, utc_now=utc_now, now=now)
