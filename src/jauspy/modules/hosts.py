"""Makes the host of each module of a robot, by the module's type."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import datetime
from typing import Final, Protocol

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.modules.config import ModuleConfig, RobotConfig
from jauspy.modules.end_effector import cm_eef
from jauspy.modules.manipulator import cm_man
from jauspy.modules.mobility import cm_mob, vehicle_of
from jauspy.modules.pan_tilt import unit_of
from jauspy.modules.sensors import Sensors, cm_sen
from jauspy.modules.vision import cm_vis, mounted_camera
from jauspy.platform.contract import DriveBase
from jauspy.platform.description import RobotModel
from jauspy.platform.force_torque import ForceTorqueSensor
from jauspy.platform.joints import JointGroup
from jauspy.platform.ranging import RangeFinder
from jauspy.services.core import Identity
from jauspy.services.environment_sensing import VideoSource
from jauspy.services.host import Host

NO_VIDEOS: Final[Mapping[str, VideoSource]] = {}
"""Of a robot without a CM-VIS."""


class Body(Protocol):
    """What the modules move and read: a robot, or its parts as other threads see them."""

    @property
    def drive(self) -> DriveBase:
        """The chassis."""
        ...

    @property
    def groups(self) -> Mapping[str, JointGroup]:
        """The other joints."""
        ...

    @property
    def lidars(self) -> Mapping[str, RangeFinder]:
        """The lidars."""
        ...

    @property
    def force_torque(self) -> Mapping[str, ForceTorqueSensor]:
        """The sensors of force and torque."""
        ...


def host_of(
    config: RobotConfig,
    module: ModuleConfig,
    model: RobotModel,
    body: Body,
    identities: Mapping[int, Identity],
    *,
    videos: Mapping[str, VideoSource] = NO_VIDEOS,
    utc_now: Callable[[], datetime],
    now: float,
) -> Host:
    """The host of a module. `videos`: the cameras by name. `now`: seconds of the clock that runs it."""
    id = config.id_of(module)
    if module.type == "CM-SEN":
        sensors = Sensors.of(config, model, body)
        return cm_sen(id, sensors, module, identities=identities, utc_now=utc_now, now=now)
    if module.camera is not None:
        camera = mounted_camera(config, model, videos[module.camera], body.groups)
        unit = unit_of(module, model, body.groups)
        return cm_vis(id, camera, unit, module, identities=identities, utc_now=utc_now, now=now)
    if module.moves is None:
        vehicle = vehicle_of(config, model, body.drive)
        return cm_mob(id, vehicle, module, identities=identities, utc_now=utc_now, now=now)
    joints = body.groups.get(module.moves)
    if joints is None:
        raise ConfigError(f"{id} moves the group {module.moves!r}, and the backend has no such joints")
    if module.type == "CM-MAN":
        return cm_man(id, joints, module, identities=identities, utc_now=utc_now, now=now)
    return cm_eef(id, joints, _carrier(config, module, model), module, identities=identities, utc_now=utc_now, now=now)


def _carrier(config: RobotConfig, module: ModuleConfig, model: RobotModel) -> JausID:
    """The CM-MAN whose joints carry the end effector of a module; the module itself when none does."""
    description = model.description
    base = model.groups[module.moves or ""].base
    carrying = {joint.name for joint in description.chain(description.root(), base)}
    arms = (other for other in config.modules if other.type == "CM-MAN" and other.moves in model.groups)
    found = (arm for arm in arms if carrying.intersection(model.groups[arm.moves or ""].joints))
    return config.id_of(next(found, module))
