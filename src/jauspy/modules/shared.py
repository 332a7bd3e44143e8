"""A robot's parts for all threads: commands act with its next step, states are those after the last one."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from typing import TypeAlias

from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.geometry.urdf import Joint
from jauspy.modules.snapshot import Snapshot
from jauspy.platform.contract import Robot
from jauspy.platform.force_torque import ForceTorqueSensor, ForceTorqueSetup, Wrench
from jauspy.platform.joints import JointGroup, JointState, Target
from jauspy.platform.ranging import LidarSetup, RangeFinder, RangeScan, ScanSettings

Order: TypeAlias = Callable[[Robot], None]
"""What the robot's thread is to do."""

Post: TypeAlias = Callable[[str, Order], None]
"""Leaves an order with the thread, in place of the one that has the same key."""

Sight: TypeAlias = Callable[[], Snapshot]


class SharedDrive:
    """A `DriveBase`."""

    def __init__(self, post: Post, sight: Sight) -> None:
        self._post = post
        self._sight = sight

    def set_effort(self, linear_x: float, rotational_z: float) -> None:
        """Drive with fractions of the full effort, -1..1; positive z turns left."""
        self._post("drive", lambda robot: robot.drive.set_effort(linear_x, rotational_z))

    def stop(self) -> None:
        """Brake to a standstill."""
        self._post("drive", lambda robot: robot.drive.stop())

    def pose(self) -> Pose:
        """Pose of the base in the world."""
        return self._sight().pose

    def twist(self) -> Twist:
        """Velocity of the base in its own frame."""
        return self._sight().twist

    def acceleration(self) -> Acceleration:
        """Acceleration of the base in its own frame."""
        return self._sight().acceleration


class SharedJoints:
    """A `JointGroup`: what was ordered before the next step all counts, the later over the earlier."""

    def __init__(self, name: str, group: JointGroup, post: Post, sight: Sight) -> None:
        self._name = name
        self._joints, self._chain = group.joints, group.chain
        self._post = post
        self._sight = sight
        self._lock = threading.Lock()
        self._holding = False
        self._targets: list[Target | None] = [None] * len(self._joints)

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints that move, base to tip."""
        return self._joints

    @property
    def chain(self) -> tuple[Joint, ...]:
        """All joints from base to tip, fixed ones included."""
        return self._chain

    def command(self, targets: Sequence[Target | None]) -> None:
        """What each joint is to do from now on, base to tip; None leaves a joint at what it does."""
        with self._lock:
            self._targets = [new or old for new, old in zip(targets, self._targets, strict=True)]
            self._post(self._name, self._deliver)

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        with self._lock:
            self._holding = True
            self._targets = [None] * len(self._joints)
            self._post(self._name, self._deliver)

    def state(self) -> JointState:
        """Positions, velocities and efforts after the last step."""
        return self._sight().joints[self._name]

    def _deliver(self, robot: Robot) -> None:
        with self._lock:
            holding, self._holding = self._holding, False
            targets, self._targets = self._targets, [None] * len(self._joints)
        group = robot.groups[self._name]
        if holding:
            group.hold()
        group.command(targets)


class SharedLidar:
    """A `RangeFinder`."""

    def __init__(self, lidar: RangeFinder, post: Post, sight: Sight) -> None:
        self._setup, self._settings = lidar.setup, lidar.settings
        self._post = post
        self._sight = sight

    @property
    def setup(self) -> LidarSetup:
        """What it can do."""
        return self._setup

    @property
    def settings(self) -> ScanSettings:
        """What it was told to do."""
        return self._settings

    def configure(self, settings: ScanSettings) -> None:
        """Measure so from the next scan on."""
        self._settings, name = settings, self._setup.name
        self._post(f"lidar {name}", lambda robot: robot.lidars[name].configure(settings))

    @property
    def scan(self) -> RangeScan | None:
        """The last scan; None while it is not active."""
        return self._sight().scans[self._setup.name]

    @property
    def age(self) -> float:
        """Seconds since the last scan; 0 without one."""
        seen = self._sight()
        scan = seen.scans[self._setup.name]
        return seen.time - scan.time if scan else 0.0


class SharedForceTorque:
    """A `ForceTorqueSensor`."""

    def __init__(self, sensor: ForceTorqueSensor, sight: Sight) -> None:
        self._setup = sensor.setup
        self._sight = sight

    @property
    def setup(self) -> ForceTorqueSetup:
        """What it can do."""
        return self._setup

    @property
    def wrench(self) -> Wrench:
        """The last measurement."""
        return self._sight().wrenches[self._setup.name]
