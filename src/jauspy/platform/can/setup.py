"""The settings of the tables `[can]` and `[can.drives.NAME]` of a robot's TOML file: the bus and its drives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum

from jauspy.errors import JausError


class DriveFault(JausError):
    """Drives cannot be used. The text names the drive, its state, its error, and what to do."""


class VelocityUnit(Enum):
    """The unit of a drive's velocities (606Ch, 60FFh)."""

    COUNTS_PER_SECOND = "counts/s"
    RPM = "rpm"


@dataclass(frozen=True, slots=True)
class Homing:
    """How a joint finds its position after power-on (CiA 402, 6098h); a drive with an absolute encoder needs none."""

    method: int
    speed: float
    """rad/s or m/s of the joint."""
    timeout: float = 60.0
    """Seconds."""


@dataclass(frozen=True, slots=True)
class Identity:
    """The identity that a drive must report (1018h); None is not compared."""

    vendor: int | None = None
    product: int | None = None
    serial: int | None = None


@dataclass(frozen=True, slots=True)
class DriveSetup:
    """One drive: its node id, the joint or track that it moves, and its units."""

    name: str
    node: int
    """CANopen node id, 1..126."""
    moves: str
    """The joint of the URDF that it moves; of a track, one of its belts."""
    track: str | None = None
    """`left` or `right` for a drive that moves a track."""
    gear_ratio: float = 1.0
    """Turns of the motor for one turn of the gear's output."""
    encoder_counts: int = 4096
    """Counts of the encoder for one turn of the motor."""
    travel: float | None = None
    """Metres for one turn of the gear's output; of prismatic joints and tracks."""
    sign: int = 1
    """-1 if the joint moves backward when the encoder counts up."""
    zero: int = 0
    """Count of the encoder at joint position 0."""
    rated_effort: float | None = None
    """Newton metres or newtons of the joint at the rated torque of the motor; the joint's limit when not given."""
    acceleration: float | None = None
    """The most that is commanded; rad/s^2 or m/s^2."""
    stop_deceleration: float | None = None
    """Of a quick stop; by default the joint stops from full speed in `STOP_TIME`."""
    following_error: float = 0.1
    """Radians or metres between command and joint that are a fault."""
    following_time: float = 0.2
    """Seconds for which the following error may be larger."""
    homing: Homing | None = None
    identity: Identity = field(default_factory=Identity)
    eds: str | None = None
    """The drive's EDS file, which its identity must match."""
    velocity_unit: VelocityUnit = VelocityUnit.COUNTS_PER_SECOND
    brake_release: float = 0.0
    """Seconds that its brake needs to release after it got power, in which it is not moved."""
    temperature: int | None = None
    """Index of the object with the temperature in 0.1 degrees Celsius; it is not standardised."""


STOP_TIME = 0.12
"""Seconds of a quick stop from full speed, unless a drive has a `stop_deceleration`."""


@dataclass(frozen=True, slots=True)
class CanSetup:
    """The bus and its drives."""

    bus: str
    """As in `socketcan:can0`, `udp_multicast:239.0.0.1` or `virtual:motors`."""
    bit_rate: int = 1_000_000
    sync_rate: float = 200.0
    """SYNC messages per second, each with one command to each drive."""
    node: int = 127
    """The node id of the robot itself, whose heartbeat the drives watch."""
    heartbeat: float = 0.05
    """Seconds between two heartbeats."""
    heartbeat_timeout: float = 0.2
    """Seconds without a heartbeat after which a drive stops, and after which a drive counts as lost."""
    status_timeout: float = 0.05
    """Seconds without a PDO after which a drive counts as silent."""
    drives: Mapping[str, DriveSetup] = field(default_factory=dict)
