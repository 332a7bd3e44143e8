"""Makes what a backend needs out of a robot's TOML and its URDF."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import xacro

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import JointKind, RobotDescription, parse_urdf
from jauspy.geometry.vectors import dot
from jauspy.modules.config import RobotConfig
from jauspy.modules.config_joints import GroupConfig, JointConfig
from jauspy.platform.description import RobotModel

SQUARE: Final = 1e-3
"""Cosine of an angle that counts as a right one."""


def robot_model(config: RobotConfig) -> RobotModel:
    """The robot that a TOML file describes; `ConfigError` names the key that does not fit the URDF."""
    description = _read(config.urdf)
    _check_tracks(config, description)
    for name, group in config.groups.items():
        _check_group(f"groups.{name}", group, description)
    groups = {name: group.setup() for name, group in config.groups.items()}
    lidars = tuple(lidar.setup() for lidar in config.lidars)
    for number, lidar in enumerate(lidars):
        _check_link(f"lidars[{number}].link", lidar.link, description)
    force_torque = tuple(sensor.setup() for sensor in config.force_torque)
    for number, sensor in enumerate(force_torque):
        _check_carried(f"force_torque[{number}].link", sensor.link, description)
    cameras = tuple(camera.setup() for camera in config.cameras)
    for number, camera in enumerate(cameras):
        _check_link(f"cameras[{number}].link", camera.link, description)
    for module in config.modules:
        if module.group is not None and module.camera is not None:
            (link,) = (camera.link for camera in cameras if camera.name == module.camera)
            _check_pan_tilt(f"groups.{module.group}", config.groups[module.group], link, description)
    return RobotModel(description, config.tracks.setup(), groups, lidars, cameras, force_torque)


def _read(path: str) -> RobotDescription:
    text = _expanded(path)
    try:
        return parse_urdf(text)
    except ConfigError as error:
        raise ConfigError(f"urdf: {path}: {error}") from error


def _expanded(path: str) -> str:
    if not Path(path).is_file():
        raise ConfigError(f"urdf: {path}: there is no such file")
    try:
        return str(xacro.process_file(path).toxml())
    except Exception as error:  # xacro evaluates expressions: anything may come out of them
        raise ConfigError(f"urdf: {path}: xacro cannot expand it: {error}") from error


def _check_tracks(config: RobotConfig, description: RobotDescription) -> None:
    sides = (("left", config.tracks.left), ("right", config.tracks.right))
    for key, name in ((key, name) for key, names in sides for name in names):
        joint = description.joints.get(name)
        if joint is None or joint.kind is not JointKind.PRISMATIC:
            known = [each.name for each in description.joints.values() if each.kind is JointKind.PRISMATIC]
            raise ConfigError(
                f"tracks.{key}: {name!r} is not a prismatic joint of the URDF; those are: {', '.join(known)}"
            )


def _check_link(key: str, link: str, description: RobotDescription) -> None:
    if link not in description.links():
        raise ConfigError(f"{key}: the URDF has no link {link!r}; it has: {', '.join(sorted(description.links()))}")


def _check_pan_tilt(key: str, group: GroupConfig, camera: str, description: RobotDescription) -> None:
    """Two revolute joints at right angles that carry the camera."""
    moving = [description.joint(joint.name) for joint in group.joints]
    if [joint.kind for joint in moving] != [JointKind.REVOLUTE] * 2:
        raise ConfigError(f"{key}.joints: to pan and tilt a camera takes two revolute joints, no more and no others")
    if moving[1] not in description.chain(description.root(), camera):
        raise ConfigError(f"{key}: the camera is on {camera!r}, which {moving[1].name!r} does not move")
    frame = Transform()
    for joint in description.chain(moving[0].child, moving[1].child):
        frame = frame @ Transform.from_pose(joint.origin)
    if abs(dot(moving[0].axis, frame.rotate(moving[1].axis))) > SQUARE:
        raise ConfigError(f"{key}.joints: their axes are not at right angles; one pans, the other one tilts")


def _check_carried(key: str, link: str, description: RobotDescription) -> None:
    _check_link(key, link, description)
    if link == description.root():
        raise ConfigError(f"{key}: nothing carries {link!r}; a sensor is between a link and the link that carries it")


def _check_group(key: str, group: GroupConfig, description: RobotDescription) -> None:
    for link in (group.base, group.tip):
        _check_link(key, link, description)
    for number, joint in enumerate(group.joints):
        _check_joint(f"{key}.joints[{number}]", joint, description)
    moving = [j.name for j in description.chain(group.base, group.tip) if j.kind is not JointKind.FIXED]
    if moving != [joint.name for joint in group.joints]:
        raise ConfigError(
            f"{key}.joints: between {group.base} and {group.tip} move, in this order: {', '.join(moving)}"
        )


def _check_joint(key: str, config: JointConfig, description: RobotDescription) -> None:
    try:
        joint = description.joint(config.name)
    except ConfigError as error:
        raise ConfigError(f"{key}.name: {error}") from error
    if joint.kind is JointKind.FIXED:
        raise ConfigError(f"{key}.name: {config.name!r} does not move")
    if not joint.lower <= config.start <= joint.upper:
        raise ConfigError(f"{key}.start = {config.start}: {config.name!r} moves from {joint.lower} to {joint.upper}")
