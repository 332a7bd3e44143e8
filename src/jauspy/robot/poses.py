"""The named poses of a robot's file, checked against its description."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from jauspy.errors import ConfigError
from jauspy.geometry.joint_routes import MARGIN
from jauspy.geometry.urdf import RobotDescription
from jauspy.platform.description import RobotModel
from jauspy.platform.link_clearances import clearances_of
from jauspy.platform.named_poses import NamedPose
from jauspy.robot.config import RobotConfig


def named_poses(config: RobotConfig, model: RobotModel) -> tuple[NamedPose, ...]:
    """Return the poses, in radians and metres.

    Raises `ConfigError`, which begins with the key, for positions out of a joint's range, and for links that would be
    in contact in a pose.
    """
    poses = tuple(
        NamedPose(number, name, _positions(name, given, model.description))
        for number, (name, given) in enumerate(config.poses.items(), 1)
    )
    if poses:
        _check_contacts(model, poses)
    return poses


def _positions(pose: str, given: Mapping[str, float], description: RobotDescription) -> dict[str, float]:
    found = {}
    for name, value in given.items():
        joint = description.joint(name)
        position = math.radians(value) if joint.turns else value
        if not joint.lower <= position <= joint.upper:
            scale, unit = (math.degrees(1.0), "degrees") if joint.turns else (1.0, "metres")
            raise ConfigError(
                f"poses.{pose}.{name} = {value:g}: is out of range; the joint moves from {joint.lower * scale:.4g} to "
                f"{joint.upper * scale:.4g} {unit}"
            )
        found[name] = position
    return found


def _check_contacts(model: RobotModel, poses: Iterable[NamedPose]) -> None:
    moved = {name for pose in poses for name in pose.positions}
    clearances = clearances_of(model, moved)
    start = {
        name: value for group in model.groups.values() for name, value in zip(group.joints, group.start, strict=True)
    }
    for pose in poses:
        for (one, other), clearance in clearances.at({**start, **pose.positions}, MARGIN).items():
            distance = f"{1000.0 * abs(clearance):.0f} mm"
            how = f"{distance} apart" if clearance > 0.0 else f"{distance} in each other"
            raise ConfigError(
                f"poses.{pose.name}: {one} and {other} would be {how}; the boxes around their collision shapes must "
                f"be {1000.0 * MARGIN:.0f} mm apart"
            )
