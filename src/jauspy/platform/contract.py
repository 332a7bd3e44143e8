"""The contract of robots that jauspy's capability modules drive.

Frames follow REP-103: x forward, y left, z up; metres, seconds, radians. The services turn them into JAUS's frames
(y right or east, z down). A robot is not thread-safe: all calls come from one thread. Other threads send commands and
read snapshots through a `RobotLink`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, Protocol, Self, runtime_checkable

from jauspy.geometry.poses import Acceleration, Pose, Twist

if TYPE_CHECKING:
    from jauspy.platform.camera import CameraSource
    from jauspy.platform.force_torque import ForceTorqueSensor, Wrench
    from jauspy.platform.joints import JointGroup, JointState
    from jauspy.platform.ranging import RangeFinder, RangeScan


class DriveBase(Protocol):
    """A chassis that drives on the ground."""

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        """Drive with fractions of the full effort, -1..1, clamped; positive z turns left. Holds until changed.

        Of a chassis that steers, z is the angle as a fraction of the greatest; y (left) is for one that moves sideways.
        """
        ...

    def stop(self) -> None:
        """Brake to a standstill and hold it, until the next `set_effort`; the same as an effort of zero."""
        ...

    def pose(self) -> Pose:
        """Pose of the base in the world, whose origin is where a robot that is alone started."""
        ...

    def twist(self) -> Twist:
        """Velocity of the base in its own frame."""
        ...

    def acceleration(self) -> Acceleration:
        """Acceleration of the base in its own frame, averaged over the last `Robot.advance`; zero before the first."""
        ...


class RobotParts(Protocol):
    """The parts of a robot that can be commanded and read: of the robot itself, or proxies for other threads."""

    @property
    def drive(self) -> DriveBase:
        """The chassis."""
        ...

    @property
    def groups(self) -> Mapping[str, JointGroup]:
        """Joints besides the chassis, by the names of their groups in the description: `arm`, `gripper`."""
        ...

    @property
    def lidars(self) -> Mapping[str, RangeFinder]:
        """Lidars by name, in the order of the description."""
        ...

    @property
    def force_torque(self) -> Mapping[str, ForceTorqueSensor]:
        """Sensors of force and torque by name, in the order of the description."""
        ...

    @property
    def optional_parts(self) -> Sequence[OptionalPart]:
        """Parts that not every robot has; found by their types, as in `ParkingBrake.of(robot)`."""
        ...


class Robot(RobotParts, Protocol):
    """One robot of a backend, at rest when opened: at the world's origin, or where it is placed among others."""

    @property
    def cameras(self) -> Mapping[str, CameraSource]:
        """Cameras by name; each shows the state after the last `advance`."""
        ...

    @property
    def time(self) -> float:
        """Seconds of the robot's own time since it was opened."""
        ...

    def advance(self, dt: float) -> None:
        """Advance by `dt` seconds; a backend with fixed steps carries the remainder over to the next call."""
        ...

    def close(self) -> None:
        """Stop, and release all resources. May be called twice."""
        ...


class DisabledRobot(Robot, Protocol):
    """A robot that was opened before its motors are enabled."""

    def enable(self) -> None:
        """Enable the motors, at rest; called once, by the robot's thread, when everything else of the robot runs.

        Raises `ConfigError` if the robot cannot be used. After any other exception the next `advance` tries again.
        """
        ...


@runtime_checkable
class Viewable(Protocol):
    """A robot whose world can be shown in a window of its simulator."""

    def view(self) -> None:
        """Open the window, until the robot is closed; raises `ConfigError` without a display."""
        ...


@runtime_checkable
class Counting(Protocol):
    """A robot that counts what happens, as on its bus."""

    @property
    def counters(self) -> Mapping[str, int]:
        """Numbers by name; may be read by another thread than that of `advance`."""
        ...


@runtime_checkable
class SharesWorld(Protocol):
    """A robot that shares its world, and so its state, with others, which other threads advance."""

    @property
    def world_lock(self) -> AbstractContextManager[object]:
        """The lock of the world; whoever calls the robot or its parts holds it."""
        ...


class PartId(NamedTuple):
    """A part of a robot that is commanded: its kind, as in `DriveBase` or `JointGroup`, and its name among those."""

    kind: type
    name: str = ""


class Command(ABC):
    """A command to one part of a robot. Any thread may send it; the robot's own thread applies it."""

    @property
    @abstractmethod
    def part(self) -> PartId:
        """The part that it is for. Of several commands to a part, sent before the next step, one is applied."""

    @abstractmethod
    def apply(self, robot: Robot) -> None:
        """Execute the command, in the robot's thread."""

    def merged(self, pending: Command) -> Command:  # noqa: ARG002 - most commands replace what is pending
        """The command to apply in place of this one and an earlier one to the same part that is still pending."""
        return self


class OptionalPart(ABC):
    """A part that not every robot has. A subclass is the contract of one kind of part, as `ParkingBrake` is."""

    @classmethod
    def of(cls, robot: RobotParts) -> Self | None:
        """The robot's part of this kind; None if it has none."""
        return next((part for part in robot.optional_parts if isinstance(part, cls)), None)

    @property
    @abstractmethod
    def id(self) -> PartId:
        """Kind of the part, and its name among those; commands to the part have the same id."""

    @abstractmethod
    def state(self) -> object:
        """Present state of the part, for snapshots: an object that never changes afterwards."""

    def stop(self) -> None:
        """Stop all motion of the part immediately; for parts that move. May be called twice."""
        return

    @abstractmethod
    def proxy(self, link: RobotLink) -> OptionalPart:
        """The same part for other threads: it submits commands, and reads `link.snapshot.parts[self.id]`."""


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The state of a robot after a step; `time` is the robot's own, in seconds."""

    time: float
    pose: Pose
    twist: Twist
    acceleration: Acceleration
    joints: Mapping[str, JointState]
    """States of joints, by group."""
    scans: Mapping[str, RangeScan | None]
    """The last scans, by lidar."""
    wrenches: Mapping[str, Wrench]
    """The last measurements, by sensor of force and torque."""
    parts: Mapping[PartId, object]
    """The states of optional parts."""

    @classmethod
    def of(cls, robot: Robot) -> Self:
        """The present state."""
        drive = robot.drive
        joints = {name: group.state() for name, group in robot.groups.items()}
        scans = {name: lidar.scan for name, lidar in robot.lidars.items()}
        wrenches = {name: sensor.wrench for name, sensor in robot.force_torque.items()}
        parts = {part.id: part.state() for part in robot.optional_parts}
        return cls(
            time=robot.time,
            pose=drive.pose(),
            twist=drive.twist(),
            acceleration=drive.acceleration(),
            joints=joints,
            scans=scans,
            wrenches=wrenches,
            parts=parts,
        )


class RobotLink(Protocol):
    """Passes commands and snapshots between other threads and the thread that owns a robot; thread-safe."""

    def submit(self, command: Command) -> None:
        """Submit a command for the next step; it is merged with a pending command to the same part."""
        ...

    @property
    def snapshot(self) -> Snapshot:
        """The state after the last step."""
        ...
