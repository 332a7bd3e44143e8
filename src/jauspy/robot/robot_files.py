"""Finds, reads and checks TOML files that describe robots: those that come with jauspy, and a user's own."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from importlib.resources import as_file, files
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any, Final

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from jauspy.config_errors import explain, line_prefix
from jauspy.errors import ConfigError
from jauspy.geometry.poses import Transform
from jauspy.geometry.urdf import Joint, JointKind, RobotDescription
from jauspy.geometry.vectors import dot
from jauspy.platform.description import GroupSetup, RobotModel, TrackSetup, is_world_file
from jauspy.platform.servo_drives import CanSetup
from jauspy.platform.wheels import wheel_setup
from jauspy.robot.audit_files import own_path
from jauspy.robot.can_drives import can_setup
from jauspy.robot.config import GroupConfig, JointConfig, JointLimitsConfig, RobotConfig
from jauspy.robot.missing_parts import MissingPolicy
from jauspy.robot.poses import named_poses
from jauspy.robot.urdf_files import read_urdf
from jauspy.robot.urdf_paths import PackagePaths
from jauspy.user_files import read_file, read_toml

SUFFIX: Final = ".toml"
PARTS: Final = "_parts.toml"
"""Suffix of files with types of parts, which do not describe robots."""
_FOLDER: Final = files("jauspy") / "robots"

FILES: Final = ("urdf", "operators")
"""Keys with the path of a file; relative ones start at the TOML file."""
PATHS: Final = ("package_path", "model_path")
"""Keys with lists of directories; relative ones start at the TOML file."""
OWN_PATHS: Final = {"audit_log": "--audit-log FILE", "record_to": "--record-to DIR"}
"""Keys for what a robot writes, below the folder of its file; with the options of `jauspy up` for other places."""
OWN_JOINTS: Final = frozenset({"urdf", "groups"})
"""Keys with which a file has joints of its own, so that it does not inherit poses."""
MAX_EXTENSIONS: Final = 8
"""Maximal length of a chain of files that extend each other."""


def known() -> list[str]:
    """Return the names of the robots that come with jauspy, sorted."""
    names = [path.name for path in _FOLDER.iterdir()]
    return sorted(name.removesuffix(SUFFIX) for name in names if name.endswith(SUFFIX) and not name.endswith(PARTS))


def load(name_or_path: str | Path) -> RobotConfig:
    """Return the robot of that name or TOML file. Raises `ConfigError` with the invalid key and its permitted values.

    With `extends = "inc1"` (a name or a path), a file inherits all keys of that file that it does not set itself.
    """
    source = _find(name_or_path, Path())
    data = _read(source, MAX_EXTENSIONS)
    try:
        config = RobotConfig.model_validate(data)
    except ValidationError as error:
        text = source.read_text()
        problems = "\n".join(
            f"  {line_prefix(text, cause['loc'])}{explain(cause, RobotConfig)}"
            for cause in _causes(error.errors(include_url=False))
        )
        raise ConfigError(f"{source}: is not a description of a robot:\n{problems}") from error
    config.set_file(str(source))
    return config


def _causes(problems: list[ErrorDetails]) -> list[ErrorDetails]:
    """Return the problems without those that follow from others: a list with an invalid item is also too short."""
    places = [problem["loc"] for problem in problems]
    return [p for p in problems if not any(q != p["loc"] and q[: len(p["loc"])] == p["loc"] for q in places)]


def _own_path(folder: Path, given: object, key: str, hint: str) -> object:
    """The path of a file that the robot writes, absolute; a value that is no path is returned as it is."""
    return str(own_path(folder, given, key, hint)) if isinstance(given, str) and given else given


def _place_own_files(data: dict[str, Any], folder: Path) -> None:
    """Make the paths of files that the robot writes absolute. Raises `ConfigError` for one elsewhere."""
    for key, option in OWN_PATHS.items():
        if key in data:
            data[key] = _own_path(folder, data[key], key, f"to write elsewhere, start it with jauspy up {option}")
    health = data.get("health")
    if isinstance(health, dict) and "hour_meter" in health:
        health["hour_meter"] = _own_path(
            folder, health["hour_meter"], "health.hour_meter", "name a file beside the robot's"
        )
    loudspeakers = data.get("loudspeakers")
    for loudspeaker in loudspeakers if isinstance(loudspeakers, list) else ():
        if isinstance(loudspeaker, dict) and "folder" in loudspeaker:
            hint = "to write elsewhere, start it with jauspy up --announcements FOLDER"
            loudspeaker["folder"] = _own_path(folder, loudspeaker["folder"], "loudspeakers.folder", hint)


def _read(source: Traversable, extensions: int) -> dict[str, Any]:
    """Return the keys of a file and of those that it extends; paths are relative to the file that sets them."""
    with as_file(source) as file:
        data, folder = read_toml(file), file.parent
    for key in FILES:
        if isinstance(data.get(key), str) and data[key]:
            data[key] = str(folder / data[key])
    try:
        _place_own_files(data, folder)
    except ConfigError as error:
        raise ConfigError(f"{source}: {error}") from error
    if isinstance(world := data.get("world"), str) and is_world_file(world):
        data["world"] = str(folder / Path(world).expanduser())
    for key in PATHS:
        if isinstance(paths := data.get(key), list):
            data[key] = [str(folder / Path(path).expanduser()) if isinstance(path, str) else path for path in paths]
    _read_part_types(data.get("cell"), folder)
    _place_eds_files(data.get("can"), folder)
    other = data.pop("extends", None)
    if other is None:
        return data
    if not isinstance(other, str) or not extensions:
        raise ConfigError(f"{source}: extends = {other!r}: it must name another robot, and not lead back to this one")
    inherited = _read(_find(other, folder), extensions - 1)
    if data.keys() & OWN_JOINTS:
        inherited.pop("poses", None)
    return inherited | data


def _read_part_types(cell: object, folder: Path) -> None:
    """Replace the path of a file with types of parts by its content."""
    if isinstance(cell, dict) and isinstance(path := cell.get("types"), str):
        cell["types"] = read_toml(folder / path).get("types", {})


def _place_eds_files(can: object, folder: Path) -> None:
    """Make the paths of drives' EDS files relative to the robot's file."""
    drives = can.get("drives") if isinstance(can, dict) else None
    for drive in drives.values() if isinstance(drives, dict) else ():
        if isinstance(drive, dict) and isinstance(path := drive.get("eds"), str) and path:
            drive["eds"] = str(folder / path)


def _find(name_or_path: str | Path, folder: Path) -> Traversable:
    text = str(name_or_path)
    if isinstance(name_or_path, Path) or text.endswith(SUFFIX) or "/" in text:
        return folder / name_or_path
    if text not in known():
        raise ConfigError(
            f"there is no robot {text!r}; the robots are: {', '.join(known())}; or give the path of a .toml file"
        )
    return _FOLDER / f"{text}{SUFFIX}"


MAX_AXIS_COSINE: Final = 1e-3
"""Largest cosine between axes that are taken as perpendicular."""


def robot_model(config: RobotConfig) -> RobotModel:
    """Return the model of a robot. Raises `ConfigError` with file, line and key that do not match the URDF."""
    try:
        return _robot_model(config)
    except ConfigError as error:
        raise with_place(error, config.file) from error


_KEY: Final = re.compile(r"(\w+)((?:\.[\w-]+|\[\d+\])*)[: ]")


def with_place(error: ConfigError, file: str) -> ConfigError:
    """The error with the robot's file and the line of the key with which it begins, as in `tracks.left: ...`."""
    key = _KEY.match(str(error))
    if not file or key is None or key[1] not in RobotConfig.model_fields:
        return error
    keys = [int(part) if part.isdigit() else part for part in re.findall(r"[\w-]+", key[0])]
    return ConfigError(f"{file}: {line_prefix(read_file(Path(file)).decode(), keys)}{error}")


def _robot_model(config: RobotConfig) -> RobotModel:
    own_folder = (Path(config.file).parent,) if config.file else ()
    packages = PackagePaths(tuple(map(Path, config.package_path)), own=own_folder)
    policy = MissingPolicy(config.skip_missing_packages, config.placeholder_meshes)
    description = read_urdf(config.urdf, packages, config.xacro_arguments, policy)
    description = _with_limits(description, config.joint_limits)
    if config.tracks is not None:
        _check_tracks(config.tracks, description)
    for name, group in config.groups.items():
        _check_group(f"groups.{name}", group, description)
    groups = {name: group.setup() for name, group in config.groups.items()}
    for number, lidar in enumerate(config.lidars):
        _check_link(f"lidars[{number}].link", lidar.link, description)
    for number, sensor in enumerate(config.force_torque):
        _check_carried(f"force_torque[{number}].link", sensor.link, description)
    cameras = tuple(camera.setup() for camera in config.cameras)
    for number, camera in enumerate(cameras):
        if camera.outside is None:
            _check_link(f"cameras[{number}].link", camera.link, description)
    for module in config.modules:
        if module.group is not None and module.camera is not None:
            if any(camera.outside and camera.name == module.camera for camera in cameras):
                raise ConfigError(f"modules: nothing turns {module.camera!r}, a camera outside of the robot: no group")
            (link,) = (camera.link for camera in cameras if camera.name == module.camera)
            _check_pan_tilt(f"groups.{module.group}", config.groups[module.group], link, description)
    if (cell := config.cell) is not None and cell.gripper:
        _check_link("cell.gripper", cell.gripper, description)
    for number, lamp in enumerate(config.lights):
        _check_link(f"lights[{number}].link", lamp.link, description)
    for number, microphone in enumerate(config.microphones):
        _check_link(f"microphones[{number}].link", microphone.link, description)
    for number, loudspeaker in enumerate(config.loudspeakers):
        _check_link(f"loudspeakers[{number}].link", loudspeaker.link, description)
    model = RobotModel(
        description,
        config.tracks,
        groups,
        lidars=config.lidars,
        cameras=cameras,
        force_torque=config.force_torque,
        cell=config.cell,
        can=_can_setup(config, description, groups),
        wheels=wheel_setup(description, config.wheels) if config.wheels else None,
        tilt_guard=config.tilt_guard,
        self_collision=config.self_collision,
        guarded_teleop=config.guarded_teleop,
        depth_cameras=tuple(camera.name for camera in config.cameras if camera.depth is not None),
        lamps=config.lights,
        time_of_day=config.time_of_day,
        localization=config.localization.with_receiver(has_origin=config.origin is not None),
        quality=config.quality,
        battery=config.battery,
        stability=config.stability,
        model_path=config.model_path,
        microphones=config.microphones,
        loudspeakers=config.loudspeakers,
        tones=config.tones,
    )
    return replace(model, poses=named_poses(config, model))


def _with_limits(description: RobotDescription, limits: Mapping[str, JointLimitsConfig]) -> RobotDescription:
    """The robot with the limits of the table `joint_limits`."""
    joints = dict(description.joints)
    for name, given in limits.items():
        if name not in joints or joints[name].kind is JointKind.FIXED:
            moving = ", ".join(joint.name for joint in joints.values() if joint.kind is not JointKind.FIXED)
            raise ConfigError(f"joint_limits: the URDF has no joint {name!r} that moves; it has: {moving or 'none'}")
        changed = {key: value for key, value in given.model_dump().items() if value is not None}
        joints[name] = joint = replace(joints[name], **changed)
        if joint.lower > joint.upper:
            raise ConfigError(f"joint_limits.{name}: lower {joint.lower:g} is above upper {joint.upper:g}")
    return replace(description, joints=joints) if limits else description


def _can_setup(
    config: RobotConfig, description: RobotDescription, groups: Mapping[str, GroupSetup]
) -> CanSetup | str | None:
    """The drives, or a text why they do not match the robot: a file may inherit drives that it does not use."""
    try:
        return None if config.can is None else can_setup(config.can, description, config.tracks, groups)
    except ConfigError as error:
        return str(with_place(error, config.file))


def _check_tracks(tracks: TrackSetup, description: RobotDescription) -> None:
    sides = (("left", tracks.left), ("right", tracks.right))
    for key, name in ((key, name) for key, names in sides for name in names):
        joint = description.joints.get(name)
        if joint is None or joint.kind is not JointKind.PRISMATIC:
            known = [joint.name for joint in description.joints.values() if joint.kind is JointKind.PRISMATIC]
            raise ConfigError(
                f"tracks.{key}: {name!r} is not a prismatic joint of the URDF; those are: {', '.join(known)}"
            )
        if not (joint.effort > 0.0 and joint.velocity > 0.0):
            raise ConfigError(f"tracks.{key}: {name!r} needs a <limit> with effort (N) and velocity (m/s) above 0")


def _check_link(key: str, link: str, description: RobotDescription) -> None:
    if link not in description.links():
        raise ConfigError(f"{key}: the URDF has no link {link!r}; it has: {', '.join(sorted(description.links()))}")


def _check_pan_tilt(key: str, group: GroupConfig, camera: str, description: RobotDescription) -> None:
    """Check that the group has two revolute joints at right angles that carry the camera."""
    moving = [description.joint(joint.name) for joint in group.joints]
    if [joint.turns for joint in moving] != [True, True]:
        raise ConfigError(f"{key}.joints: a pan-tilt unit has exactly two joints, both revolute")
    if moving[1] not in description.chain(description.root(), camera):
        raise ConfigError(f"{key}: the camera is on {camera!r}, which {moving[1].name!r} does not move")
    frame = Transform()
    for joint in description.chain(moving[0].child, moving[1].child):
        frame = frame @ Transform.from_pose(joint.origin)
    if abs(dot(moving[0].axis, frame.rotate(moving[1].axis))) > MAX_AXIS_COSINE:
        raise ConfigError(f"{key}.joints: their axes are not at right angles")


def _check_carried(key: str, link: str, description: RobotDescription) -> None:
    _check_link(key, link, description)
    if link == description.root():
        raise ConfigError(f"{key}: nothing carries {link!r}; a sensor is between a link and the link that carries it")


def _check_group(key: str, group: GroupConfig, description: RobotDescription) -> None:
    for link in (group.base, group.tip):
        _check_link(key, link, description)
    for number, joint in enumerate(group.joints):
        _check_joint(f"{key}.joints[{number}]", joint, description)
    moving = [j.name for j in description.chain(group.base, group.tip) if j.is_independent]
    if moving != [joint.name for joint in group.joints]:
        raise ConfigError(
            f"{key}.joints: the joints from {group.base} to {group.tip} that move are, in order: {', '.join(moving)}"
        )


def check_motor(key: str, joint: Joint) -> None:
    """Check that a joint that is commanded has a speed and an effort; raises `ConfigError`."""
    if joint.velocity <= 0.0 or joint.effort <= 0.0:
        raise ConfigError(
            f'{key}: the joint {joint.name!r} needs <limit effort="..." velocity="..."> above zero in the URDF, '
            f"and has effort {joint.effort:g} and velocity {joint.velocity:g}"
            + (f" at {joint.place}" if joint.place else "")
            + f"; or give both in the TOML file, as in [joint_limits.{joint.name}]"
        )


def _check_joint(key: str, config: JointConfig, description: RobotDescription) -> None:
    try:
        joint = description.joint(config.name)
    except ConfigError as error:
        raise ConfigError(f"{key}.name: {error}") from error
    if joint.kind is JointKind.FIXED:
        raise ConfigError(f"{key}.name: {config.name!r} does not move")
    if joint.mimics is not None:
        raise ConfigError(f"{key}.name: {config.name!r} mimics {joint.mimics!r}, and follows it without a command")
    check_motor(f"{key}.name", joint)
    if not joint.lower <= config.start <= joint.upper:
        raise ConfigError(f"{key}.start = {config.start}: {config.name!r} moves from {joint.lower} to {joint.upper}")
