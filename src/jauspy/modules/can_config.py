"""The table `[can]` of a robot's TOML file, and a table `[can.drives.NAME]` for each drive."""

from __future__ import annotations

import configparser
import re
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Literal, Self, TypeAlias

from pydantic import AfterValidator, Field, PrivateAttr, model_validator

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import JointKind, RobotDescription
from jauspy.modules.config_base import StrictConfig
from jauspy.platform.can.setup import CanSetup, DriveSetup, Homing, Identity, VelocityUnit
from jauspy.platform.description import GroupSetup, TrackSetup
from jauspy.user_files import read_file

Positive: TypeAlias = Annotated[float, Field(gt=0.0, allow_inf_nan=False)]
NodeId: TypeAlias = Annotated[int, Field(ge=1, le=127)]
Code: TypeAlias = Annotated[int, Field(ge=0, le=0xFFFFFFFF)]
TemperatureObject: TypeAlias = Annotated[int, Field(ge=0x2000, le=0x6FFF)]
Name: TypeAlias = Annotated[str, Field(min_length=1, max_length=40, pattern=r"^[A-Za-z0-9_.+-]+$")]


class HomingConfig(StrictConfig):
    """How a joint without an absolute encoder finds its position after power-on."""

    method: Annotated[int, Field(ge=-128, le=127)]
    """A method of CiA 402 (6098h), as in the drive's manual."""
    speed: Positive
    """Of the joint, rad/s or m/s."""
    timeout: Positive = 60.0
    """Seconds."""


class DriveConfig(StrictConfig):
    """One servo drive."""

    node: NodeId
    """Its CANopen node id."""
    joint: Annotated[str, Field(min_length=1, max_length=80)] | None = None
    """The joint of the URDF that it moves; or a track:"""
    track: Literal["left", "right"] | None = None
    gear_ratio: Positive = 1.0
    """Turns of the motor for one turn of the gear's output."""
    encoder_counts: Annotated[int, Field(ge=1, le=2**24)]
    """Counts of its encoder for one turn of the motor."""
    travel: Positive | None = None
    """Metres for one turn of the gear's output: the pitch of a spindle, the circumference of a sprocket."""
    sign: Literal[1, -1] = 1
    """-1 if the joint moves backward when the encoder counts up."""
    zero: Annotated[int, Field(ge=-(2**31), lt=2**31)] = 0
    """Count of the encoder where the joint is at 0."""
    rated_effort: Positive | None = None
    """Newton metres or newtons of the joint at the motor's rated torque; by default the effort in the URDF."""
    acceleration: Positive | None = None
    """Of a track, m/s^2."""
    stop_deceleration: Positive | None = None
    """Of a quick stop, rad/s^2 or m/s^2; by default it stops from full speed in 0.12 s."""
    following_error: Positive = 0.1
    """Radians or metres between command and joint that are a fault after `following_time` seconds."""
    following_time: Annotated[float, Field(ge=0.0, le=10.0)] = 0.2
    brake_release: Annotated[float, Field(ge=0.0, le=5.0)] = 0.0
    """Seconds that its brake needs to release after it got power; it is not moved before."""
    homing: HomingConfig | None = None
    eds: Annotated[str, Field(min_length=1)] | None = None
    """Its EDS file; vendor and product of the drive must be those of the file. A relative path starts at this file."""
    vendor: Code | None = None
    product: Code | None = None
    serial: Code | None = None
    """The serial number that it must report (1018h). With serial numbers, swapped drives are noticed."""
    velocity_unit: Literal["counts/s", "rpm"] = "counts/s"
    """The unit of its velocities (606Ch, 60FFh)."""
    temperature: TemperatureObject | None = None
    """Index of the object with its temperature in 0.1 degrees Celsius, for `jauspy can drives`."""

    @model_validator(mode="after")
    def _check_moves(self) -> Self:
        if (self.joint is None) == (self.track is None):
            raise ValueError("joint: give either the joint that the drive moves or its track, as in track = 'left'")
        if self.acceleration is not None and self.track is None:
            raise ValueError("acceleration: is of tracks; joints accelerate as each command says")
        return self


def _check_bus(bus: str) -> str:
    """Refuse channels that drivers take as the URL of a port, which may write files, and libraries of options."""
    _, _, rest = bus.partition(":")
    channel, _, options = rest.partition(",")
    is_path = "/" in channel and not (channel.startswith("/dev/") and ".." not in channel)
    if "://" in bus or is_path or "/" in options or "\\" in bus or re.search(r"\bdll\b", options):
        raise ValueError(f"bus: {bus!r} is not INTERFACE:CHANNEL with a device of /dev; give others by --bus")
    return bus


class CanConfig(StrictConfig):
    """The CAN bus of a robot, and its drives."""

    bus: Annotated[str, Field(min_length=3, max_length=200), AfterValidator(_check_bus)] = "virtual:motors"
    """INTERFACE:CHANNEL of python-can, as in `socketcan:can0`; `virtual:` has simulated drives in the same process.
    With `udp_multicast:` each machine that receives the group can move the drives."""
    bit_rate: Annotated[int, Field(ge=10_000, le=1_000_000)] = 1_000_000
    sync_rate: Annotated[float, Field(ge=10.0, le=1000.0)] = 200.0
    """Commands to each drive per second."""
    node: NodeId = 127
    """The node id of the robot itself."""
    heartbeat: Annotated[float, Field(ge=0.01, le=1.0)] = 0.05
    heartbeat_timeout: Annotated[float, Field(ge=0.03, le=5.0)] = 0.2
    """Seconds; without a heartbeat for so long, a drive stops, and counts as lost."""
    status_timeout: Annotated[float, Field(ge=0.01, le=5.0)] = 0.05
    """Seconds without a PDO after which a drive counts as silent."""
    temperature: TemperatureObject | None = None
    """The `temperature` of drives that have none of their own."""
    drives: Annotated[Mapping[Name, DriveConfig], Field(min_length=1, max_length=64)]

    _file: str = PrivateAttr(default="")

    @property
    def file(self) -> str:
        """The robot's file, for error messages; empty if there is none."""
        return self._file

    def set_file(self, file: str) -> None:
        """Set the robot's file."""
        self._file = file

    @model_validator(mode="after")
    def _check_nodes(self) -> Self:
        taken = Counter([self.node, *(drive.node for drive in self.drives.values())])
        for name, drive in self.drives.items():
            if taken[drive.node] > 1:
                raise ValueError(f"drives.{name}.node = {drive.node}: another drive or the robot has it, too")
        if self.heartbeat * 2.0 >= self.heartbeat_timeout:
            raise ValueError(
                f"heartbeat = {self.heartbeat}: must be less than half of heartbeat_timeout = {self.heartbeat_timeout}"
            )
        return self


def can_setup(
    config: CanConfig, description: RobotDescription, tracks: TrackSetup | None, groups: Mapping[str, GroupSetup]
) -> CanSetup:
    """Return the setup for the backend. Raises `ConfigError` with the key that does not match the robot."""
    drives: dict[str, DriveSetup] = {}
    moved: dict[str, str] = {}
    for name, drive in config.drives.items():
        key = f"can.drives.{name}"
        moves = _moved_by(key, drive, tracks, groups)
        what = f"{drive.track} track" if drive.track else f"joint {moves!r}"
        if what in moved:
            raise ConfigError(f"{key}: the drive {moved[what]!r} moves the {what} already")
        moved[what] = name
        if description.joint(moves).kind is JointKind.PRISMATIC and drive.travel is None:
            raise ConfigError(
                f"{key}.travel: is missing; {moves!r} is prismatic: give the metres of one turn of the gear's output"
            )
        drives[name] = _drive(name, drive, moves, key, config.temperature)
    sides = ("left", "right") if tracks else ()
    wanted = [*(f"{side} track" for side in sides), *(f"joint {j!r}" for g in groups.values() for j in g.joints)]
    if missing := [what for what in wanted if what not in moved]:
        raise ConfigError(f"can.drives: no drive moves the {missing[0]}; add a table [can.drives.NAME]")
    return CanSetup(
        config.bus,
        config.bit_rate,
        config.sync_rate,
        config.node,
        config.heartbeat,
        config.heartbeat_timeout,
        config.status_timeout,
        drives,
    )


def _moved_by(key: str, drive: DriveConfig, tracks: TrackSetup | None, groups: Mapping[str, GroupSetup]) -> str:
    if drive.joint is not None:
        known = [joint for group in groups.values() for joint in group.joints]
        if drive.joint not in known:
            raise ConfigError(f"{key}.joint = {drive.joint!r}: is in no group; those of groups are: {', '.join(known)}")
        return drive.joint
    if tracks is None:
        raise ConfigError(f"{key}.track: the robot has no [tracks]")
    return tracks.left[0] if drive.track == "left" else tracks.right[0]


def _drive(name: str, drive: DriveConfig, moves: str, key: str, temperature: int | None) -> DriveSetup:
    identity = Identity(drive.vendor, drive.product, drive.serial)
    if drive.eds is not None:
        try:
            vendor, product = identity_of(Path(drive.eds))
        except ConfigError as error:
            raise ConfigError(f"{key}.eds: {error}") from error
        identity = Identity(drive.vendor or vendor, drive.product or product, drive.serial)
    homing = drive.homing
    return DriveSetup(
        name,
        drive.node,
        moves,
        drive.track,
        drive.gear_ratio,
        drive.encoder_counts,
        drive.travel,
        drive.sign,
        drive.zero,
        drive.rated_effort,
        drive.acceleration,
        drive.stop_deceleration,
        drive.following_error,
        drive.following_time,
        Homing(homing.method, homing.speed, homing.timeout) if homing else None,
        identity,
        drive.eds,
        VelocityUnit(drive.velocity_unit),
        drive.brake_release,
        drive.temperature or temperature,
    )


def identity_of(path: Path) -> tuple[int | None, int | None]:
    """Vendor and product code in a drive's EDS file (CiA 306); None for missing entries. Raises `ConfigError`."""
    parser = configparser.RawConfigParser(strict=False, allow_no_value=True)
    try:
        parser.read_string(read_file(path).decode("utf-8", "replace"))
    except configparser.Error as error:
        line = getattr(error, "lineno", 0)  # its text has the content of the line, which may be of any file
        raise ConfigError(f"{path}{f':{line}' if line else ''}: is not an EDS file: {type(error).__name__}") from error
    if not parser.has_section("DeviceInfo"):
        raise ConfigError(f"{path}: is not an EDS file: it has no section [DeviceInfo]")
    found = []
    for key in ("VendorNumber", "ProductNumber"):
        text = parser.get("DeviceInfo", key, fallback=None)
        try:
            found.append(int(text, 0) or None if text else None)
        except ValueError:
            raise ConfigError(f"{path}: {key}={text!r} is not a number") from None
    return found[0], found[1]
