"""What a robot must offer to be driven by jauspy's capability modules.

Frames follow REP-103: x forward, y left, z up; metres, seconds, radians. The services turn them into JAUS's frames
(y right or east, z down). A robot is not thread-safe: all calls come from one thread, or under its runner's lock.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Protocol

from jauspy.geometry.poses import Acceleration, Pose, Twist

if TYPE_CHECKING:
    from jauspy.platform.camera import Camera
    from jauspy.platform.description import RobotModel
    from jauspy.platform.force_torque import ForceTorqueSensor
    from jauspy.platform.joints import JointGroup
    from jauspy.platform.ranging import RangeFinder


class DriveBase(Protocol):
    """A chassis that drives on the ground."""

    def set_effort(self, linear_x: float, rotational_z: float) -> None:
        """Drive with fractions of the full effort, -1..1, clamped; positive z turns left. Holds until changed."""
        ...

    def stop(self) -> None:
        """Brake to a standstill and hold it, until the next `set_effort`; the same as an effort of zero."""
        ...

    def pose(self) -> Pose:
        """Pose of the base in the world, whose origin is where the robot started."""
        ...

    def twist(self) -> Twist:
        """Velocity of the base in its own frame."""
        ...

    def acceleration(self) -> Acceleration:
        """Acceleration of the base in its own frame, averaged over the last `Robot.advance`; zero before the first."""
        ...


class Robot(Protocol):
    """One robot of a backend, at rest at the world's origin when opened."""

    @property
    def drive(self) -> DriveBase:
        """The chassis."""
        ...

    @property
    def groups(self) -> Mapping[str, JointGroup]:
        """Its other joints, by the names that its description gives them: `arm`, `gripper`."""
        ...

    @property
    def cameras(self) -> Mapping[str, Camera]:
        """Its cameras, by name; each shows the state after the last `advance`."""
        ...

    @property
    def lidars(self) -> Mapping[str, RangeFinder]:
        """Its lidars, by name, in the order of its description."""
        ...

    @property
    def force_torque(self) -> Mapping[str, ForceTorqueSensor]:
        """Its sensors of force and torque, by name, in the order of its description."""
        ...

    @property
    def time(self) -> float:
        """Seconds of the robot's own time since it was opened."""
        ...

    def advance(self, dt: float) -> None:
        """Let `dt` seconds pass; a backend with fixed steps carries what is left over to the next call."""
        ...

    def close(self) -> None:
        """Stop, and release what the backend holds; twice is fine."""
        ...


class Backend(Protocol):
    """Where robots come from: a simulator, a bus, arithmetic."""

    @property
    def name(self) -> str:
        """The name it has in configuration files, e.g. `kinematic`."""
        ...

    def open(self, robot: RobotModel, world: str) -> Robot:
        """That robot in that world; `ConfigError` lists the known worlds."""
        ...
