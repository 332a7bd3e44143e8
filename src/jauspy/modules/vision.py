"""CM-VIS, the vision module: streams what a camera sees, takes still images, and turns it, if it has a mount."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import datetime
from typing import Final

from jauspy.geometry.frames import FrameTree
from jauspy.ids import JausID
from jauspy.modules.capability import capability
from jauspy.modules.carriers import carrier_of
from jauspy.modules.config import ModuleConfig, RobotConfig
from jauspy.modules.pan_tilt import services_of
from jauspy.modules.sensors import frame_of
from jauspy.platform.description import RobotModel
from jauspy.platform.joints import JointGroup
from jauspy.services.core import Identity
from jauspy.services.environment_sensing import (
    DigitalResourceDiscovery,
    DigitalVideo,
    H264VideoEncoding,
    StillImage,
    VideoCamera,
    VideoSource,
    Viewers,
    VisualSensor,
)
from jauspy.services.host import Host
from jauspy.services.manipulator import PanTilt
from jauspy.services.service import Service

CHOICE: Final[Mapping[str, Callable[[Viewers], Service]]] = {
    "VisualSensor": lambda viewers: VisualSensor(viewers.cameras),
    "DigitalVideo": DigitalVideo,
    "H264VideoEncoding": lambda viewers: H264VideoEncoding(viewers.cameras),
    "StillImage": lambda viewers: StillImage(viewers.cameras),
    "DigitalResourceDiscovery": DigitalResourceDiscovery,
}


def mounted_camera(
    config: RobotConfig, model: RobotModel, source: VideoSource, groups: Mapping[str, JointGroup]
) -> VideoCamera:
    """The camera, and where it is on the robot, whatever its joints do."""
    tree, link = FrameTree(model.description), source.setup.link
    return VideoCamera(
        frame_of(tree, link, groups), tree.is_fixed(link), carrier_of(config, model, link), source=source
    )


def cm_vis(
    id: JausID,
    camera: VideoCamera,
    unit: PanTilt | None,
    config: ModuleConfig,
    *,
    identities: Mapping[int, Identity],
    utc_now: Callable[[], datetime],
    now: float,
) -> Host:
    """The component's host; its camera is sensor 1. `unit` carries the camera; with it comes a watchdog."""
    viewers = Viewers({1: camera})
    services = [make(viewers) for name, make in CHOICE.items() if config.offers(name)]
    services += services_of(unit, config) if unit else []
    return capability(id, config, services, unit, identities=identities, utc_now=utc_now, now=now)
