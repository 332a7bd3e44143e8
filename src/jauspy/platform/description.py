"""Descriptions of robots: links and joints from the URDF, and the parameters that backends need to move them.

Frames and units are URDF's (REP-103): metres, radians, kilograms; a joint's frame is given in its parent link's.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Final

from annotated_types import Interval, Len

from jauspy.geometry.urdf import RobotDescription
from jauspy.platform.battery import BatterySetup
from jauspy.platform.camera import CameraSetup, Quality
from jauspy.platform.force_torque import ForceTorqueSetup
from jauspy.platform.joints import ContactReaction, JointGains, JointSensors
from jauspy.platform.lights import LampSetup, TimeOfDay
from jauspy.platform.localization import EXACT, LocalizationSetup
from jauspy.platform.modular.parts import CellSetup
from jauspy.platform.named_poses import NamedPose
from jauspy.platform.ranging import LidarSetup
from jauspy.platform.servo_drives import CanSetup
from jauspy.platform.sound import LoudspeakerSetup, MicrophoneSetup, ToneSetup
from jauspy.platform.stability_setup import StabilitySetup
from jauspy.platform.tables import Converted, Table, UrdfName, check_order
from jauspy.platform.wheels import WheelSetup

WORLD_SUFFIXES: Final = (".xml", ".mjcf", ".sdf", ".world", ".toml")
"""Suffixes of files with worlds: MJCF, SDF, a list of objects."""


def is_world_file(world: str) -> bool:
    """True for the path of a world's file, False for the name of a world that a backend includes."""
    return "/" in world or world.lower().endswith(WORLD_SUFFIXES)


@dataclass(frozen=True, slots=True)
class GroupSetup:
    """Joints that are commanded together, base to tip, and their controllers."""

    joints: tuple[str, ...]
    gains: Mapping[str, JointGains]
    base: str
    """The link that carries the group."""
    tip: str
    """The link at its end: a tool, a finger."""
    rate: float
    """Rate of the controllers, in hertz."""
    start: tuple[float, ...]
    """Initial positions of the joints."""
    feed_forward: bool = False
    """True if their controllers know the robot's dynamics, and apply what a motion needs before an error appears."""
    contact: ContactReaction = ContactReaction.IGNORE
    """What they do when something is in their way, which needs `feed_forward`."""
    sensors: JointSensors | None = None
    """Errors of what the joints measure; None measures exactly."""


@dataclass(frozen=True, slots=True)
class TrackSetup(Table):
    """A chassis on tracks, the table `[tracks]`: prismatic joints of the URDF, the belts of each side.

    The first joint of a side has the motor; the others, such as those of flippers, run with it.
    """

    left: Annotated[tuple[UrdfName, ...], Len(1, 4)]
    right: Annotated[tuple[UrdfName, ...], Len(1, 4)]
    inertia: Annotated[float, Interval(gt=0.0, le=1000.0)] = 6.0
    """Inertia of rotors and sprockets at the belts of a side, in kilograms."""
    turning_point: Annotated[float, Interval(ge=-10.0, le=10.0)] = 0.0
    """Metres from the base forward to the point that does not move sideways in a turn, for odometry."""


@dataclass(frozen=True, slots=True)
class TiltSetup(Table):
    """The table `tilt_guard`: the tilt at which the driver services stop the robot; 180 degrees is no limit."""

    pitch: Annotated[float, Interval(ge=5.0, le=180.0), Converted(math.radians)] = math.radians(60.0)
    """Radians (degrees in the file), nose up or down."""
    roll: Annotated[float, Interval(ge=5.0, le=180.0), Converted(math.radians)] = math.radians(45.0)
    """Radians (degrees in the file), to either side."""


@dataclass(frozen=True, slots=True)
class SelfCollisionSetup(Table):
    """The table `self_collision`: the guard that stops joints before links of the robot touch each other."""

    enabled: bool = False
    """True if it is on when the robot starts; a client may switch it."""
    distance: Annotated[float, Interval(ge=0.002, le=0.5)] = 0.01
    """Metres at which links stop."""


@dataclass(frozen=True, slots=True)
class GuardedTeleopSetup(Table):
    """The table `guarded_teleop`: the guard that stops the chassis before obstacles that its sensors see."""

    enabled: bool = False
    """True if it is on when the robot starts; a client may switch it."""
    distance: Annotated[float, Interval(ge=0.02, le=5.0)] = 0.15
    """Metres from the chassis at which it stops."""
    height: tuple[Annotated[float, Interval(ge=-1.0, le=10.0)], Annotated[float, Interval(ge=-1.0, le=10.0)]] = (
        0.1,
        1.0,
    )
    """Metres above the ground under the chassis between which a point is an obstacle."""

    def __post_init__(self) -> None:
        check_order("height", self.height, "the lowest and then the greatest height of an obstacle")


@dataclass(frozen=True, slots=True)
class RobotModel:
    """All that a backend needs to make a robot."""

    description: RobotDescription
    tracks: TrackSetup | None
    """None, without wheels either: the base is fixed to the world."""
    groups: Mapping[str, GroupSetup] = field(default_factory=dict)
    lidars: tuple[LidarSetup, ...] = ()
    cameras: tuple[CameraSetup, ...] = ()
    force_torque: tuple[ForceTorqueSetup, ...] = ()
    model_path: tuple[str, ...] = ()
    """Directories in which an SDF world's `model://` is searched before those of the environment."""
    cell: CellSetup | None = None
    """Factory cell around the robot; None for a robot that is not in one."""
    can: CanSetup | str | None = None
    """The drives on its CAN bus, for the backend `can`; a sentence if they do not match the robot."""
    wheels: WheelSetup | None = None
    """Wheels in place of tracks."""
    tilt_guard: TiltSetup | None = None
    """Tilt from which on the robot is stopped; None for no limit."""
    self_collision: SelfCollisionSetup = SelfCollisionSetup()
    guarded_teleop: GuardedTeleopSetup = GuardedTeleopSetup()
    depth_cameras: tuple[str, ...] = ()
    """Names of the cameras that measure depths."""
    localization: LocalizationSetup = EXACT
    """Measurement of its pose; for robots with a chassis."""
    lamps: tuple[LampSetup, ...] = ()
    time_of_day: TimeOfDay = TimeOfDay.DAY
    """Light of the simulated world."""
    quality: Quality = Quality.MEDIUM
    """Quality of the pictures of its cameras in a simulation."""
    stability: StabilitySetup | None = None
    """Protection against tipping over; None for a robot without it."""
    battery: BatterySetup | None = None
    """The battery of a simulated robot; None for a supply that never ends."""
    poses: tuple[NamedPose, ...] = ()
    """Named poses of its joints."""
    microphones: tuple[MicrophoneSetup, ...] = ()
    loudspeakers: tuple[LoudspeakerSetup, ...] = ()
    tones: tuple[ToneSetup, ...] = ()
    """Sounds of its world that never end."""
