"""The settings of the tables `[can]` and `[can.drives.NAME]` of a robot's TOML file: the bus and its drives."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Annotated, Literal, TypeAlias

from annotated_types import Interval, Len, MaxLen, MinLen

from jauspy.platform.tables import Converted, Identifier, Positive, Table, UrdfName


class VelocityUnit(Enum):
    """The unit of a drive's velocities (606Ch, 60FFh)."""

    COUNTS_PER_SECOND = "counts/s"
    RPM = "rpm"


_NodeId: TypeAlias = Annotated[int, Interval(ge=1, le=127)]
_Code: TypeAlias = Annotated[int, Interval(ge=0, le=0xFFFFFFFF)]
_TemperatureObject: TypeAlias = Annotated[int, Interval(ge=0x2000, le=0x6FFF)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Homing(Table):
    """Search of a joint without an absolute encoder for its position after power-on (CiA 402, 6098h)."""

    method: Annotated[int, Interval(ge=-128, le=127)]
    """A method of CiA 402, as in the drive's manual."""
    speed: Positive
    """rad/s or m/s of the joint."""
    timeout: Positive = 60.0
    """Seconds."""


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveTable(Table):
    """One servo drive, as in the file: the table `[can.drives.NAME]`."""

    node: _NodeId
    """CANopen node id of the drive."""
    joint: UrdfName | None = None
    """The joint of the URDF that it moves; or a track:"""
    track: Literal["left", "right"] | None = None
    gear_ratio: Positive = 1.0
    """Turns of the motor for one turn of the gear's output."""
    encoder_counts: Annotated[int, Interval(ge=1, le=2**24)]
    """Counts of its encoder for one turn of the motor."""
    travel: Positive | None = None
    """Metres for one turn of the gear's output: the pitch of a spindle, the circumference of a sprocket."""
    sign: Literal[1, -1] = 1
    """-1 if the joint moves backward when the encoder counts up."""
    zero: Annotated[int, Interval(ge=-(2**31), lt=2**31)] = 0
    """Count of the encoder where the joint is at 0."""
    rated_effort: Positive | None = None
    """Newton metres or newtons of the joint at the motor's rated torque; by default the effort in the URDF."""
    acceleration: Positive | None = None
    """The largest of a track that is commanded, m/s^2."""
    stop_deceleration: Positive | None = None
    """Deceleration of a quick stop, rad/s^2 or m/s^2; by default it stops from full speed in `STOP_TIME`."""
    following_error: Positive = 0.1
    """Radians or metres between command and joint that are a fault after `following_time` seconds."""
    following_time: Annotated[float, Interval(ge=0.0, le=10.0)] = 0.2
    brake_release: Annotated[float, Interval(ge=0.0, le=5.0)] = 0.0
    """Seconds that its brake needs to release after it got power; it is not moved before."""
    homing: Homing | None = None
    """None for a drive with an absolute encoder."""
    eds: Annotated[str, MinLen(1)] | None = None
    """EDS file, whose vendor and product the drive must have. A relative path starts at this file."""
    vendor: _Code | None = None
    product: _Code | None = None
    serial: _Code | None = None
    """The serial number that it must report (1018h). With serial numbers, swapped drives are noticed."""
    velocity_unit: VelocityUnit = VelocityUnit.COUNTS_PER_SECOND
    """The unit of its velocities (606Ch, 60FFh)."""
    temperature: _TemperatureObject | None = None
    """Index of the object with its temperature in 0.1 degrees Celsius, for `jauspy can drives`; not standardised."""

    def __post_init__(self) -> None:
        if (self.joint is None) == (self.track is None):
            raise ValueError("joint: give either the joint that the drive moves or its track, as in track = 'left'")
        if self.acceleration is not None and self.track is None:
            raise ValueError("acceleration: is of tracks; joints accelerate as each command says")


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveSetup(DriveTable):
    """One drive of a robot, with what it moves in the URDF."""

    name: str
    moves: str
    """The joint of the URDF that it moves; of a track, one of its belts."""


STOP_TIME = 0.12
"""Seconds of a quick stop from full speed, unless a drive has a `stop_deceleration`."""


def _check_bus(bus: str) -> str:
    """Refuse channels that drivers take as the URL of a port, which may write files, and libraries of options."""
    _, _, rest = bus.partition(":")
    channel, _, options = rest.partition(",")
    is_path = "/" in channel and not (channel.startswith("/dev/") and ".." not in channel)
    if "://" in bus or is_path or "/" in options or "\\" in bus or re.search(r"\bdll\b", options):
        raise ValueError("it is not INTERFACE:CHANNEL with a device of /dev; give others by --bus")
    return bus


@dataclass(frozen=True, slots=True, kw_only=True)
class CanTable(Table):
    """The CAN bus of a robot and its drives, as in the file: the table `[can]`."""

    bus: Annotated[str, Len(3, 200), Converted(_check_bus)] = "virtual:motors"
    """INTERFACE:CHANNEL of python-can, as in `socketcan:can0`; `virtual:` has simulated drives in the same process.
    With `udp_multicast:` each machine that receives the group can move the drives."""
    bit_rate: Annotated[int, Interval(ge=10_000, le=1_000_000)] = 1_000_000
    sync_rate: Annotated[float, Interval(ge=10.0, le=1000.0)] = 200.0
    """SYNC messages per second, each with one command to each drive."""
    node: _NodeId = 127
    """The node id of the robot itself, whose heartbeat the drives watch."""
    heartbeat: Annotated[float, Interval(ge=0.01, le=1.0)] = 0.05
    """Seconds between two heartbeats."""
    heartbeat_timeout: Annotated[float, Interval(ge=0.03, le=5.0)] = 0.2
    """Seconds without a heartbeat after which a drive stops, and after which a drive counts as lost."""
    status_timeout: Annotated[float, Interval(ge=0.01, le=5.0)] = 0.05
    """Seconds without a PDO after which a drive counts as silent."""
    temperature: _TemperatureObject | None = None
    """The `temperature` of drives that have none of their own."""
    drives: Annotated[Mapping[Annotated[Identifier, MaxLen(40)], DriveTable], Len(1, 64)]

    def __post_init__(self) -> None:
        taken = Counter([self.node, *(drive.node for drive in self.drives.values())])
        for name, drive in self.drives.items():
            if taken[drive.node] > 1:
                raise ValueError(f"drives.{name}.node = {drive.node}: another drive or the robot has it, too")
        if self.heartbeat * 2.0 >= self.heartbeat_timeout:
            raise ValueError(
                f"heartbeat = {self.heartbeat}: must be less than half of heartbeat_timeout = {self.heartbeat_timeout}"
            )


@dataclass(frozen=True, slots=True, kw_only=True)
class CanSetup(CanTable):
    """The CAN bus of a robot, with drives that match it."""

    drives: Mapping[str, DriveSetup]
