"""CM-SEN, the sensor module: tells what the lidars measure."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from datetime import datetime

from jauspy.ids import JausID
from jauspy.modules.capability import capability
from jauspy.modules.config import ModuleConfig
from jauspy.platform.description import Description
from jauspy.platform.joints import JointGroup
from jauspy.platform.ranging import RangeFinder
from jauspy.platform.transforms import FrameTree, joint_positions
from jauspy.platform.vectors import Transform
from jauspy.services.core import Identity
from jauspy.services.environment_sensing import Mounted, RangeSensor
from jauspy.services.host import Host
from jauspy.services.service import Service


def mounted(
    description: Description, lidars: Mapping[str, RangeFinder], groups: Mapping[str, JointGroup]
) -> list[Mounted]:
    """The lidars, and where each is on the robot, whatever its joints do."""
    tree = FrameTree(description)

    def frame_of(link: str) -> Callable[[], Transform]:
        if tree.is_fixed(link):
            fixed = tree.pose(link)
            return lambda: fixed
        return lambda: tree.pose(link, joint_positions(groups.values()))

    return [Mounted(lidar, frame_of(lidar.setup.link), tree.is_fixed(lidar.setup.link)) for lidar in lidars.values()]


def cm_sen(
    id: JausID,
    lidars: Sequence[Mounted],
    config: ModuleConfig,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
) -> Host:
    """The component's host; it moves nothing."""
    services: list[Service] = [RangeSensor(lidars)] if lidars and config.offers("RangeSensor") else []
    return capability(id, config, services, identities=identities, utc_now=utc_now, now=now)
