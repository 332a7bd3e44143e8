"""Proxies of a robot's parts for other threads: they submit commands and read the last snapshot."""

from __future__ import annotations

from collections.abc import Sequence

from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.geometry.urdf import Joint
from jauspy.platform.commands import DriveEffort, DriveStop, JointTargets, LidarSettings
from jauspy.platform.contract import RobotLink
from jauspy.platform.force_torque import ForceTorqueSensor, ForceTorqueSetup, Wrench
from jauspy.platform.joints import JointGroup, JointState, Target
from jauspy.platform.ranging import LidarSetup, RangeFinder, RangeScan, ScanSettings


class DriveProxy:
    """A `DriveBase`."""

    def __init__(self, link: RobotLink) -> None:
        self._link = link

    def set_effort(self, linear_x: float, rotational_z: float, linear_y: float = 0.0) -> None:
        """Drive with fractions of the full effort, -1..1; positive z turns left, positive y is left."""
        self._link.submit(DriveEffort(linear_x, rotational_z, linear_y))

    def stop(self) -> None:
        """Brake to a standstill."""
        self._link.submit(DriveStop())

    def pose(self) -> Pose:
        """Pose of the base in the world."""
        return self._link.snapshot.pose

    def twist(self) -> Twist:
        """Velocity of the base in its own frame."""
        return self._link.snapshot.twist

    def acceleration(self) -> Acceleration:
        """Acceleration of the base in its own frame."""
        return self._link.snapshot.acceleration


class JointGroupProxy:
    """A `JointGroup`."""

    def __init__(self, name: str, group: JointGroup, link: RobotLink) -> None:
        self._name = name
        self._joints, self._chain = group.joints, group.chain
        self._link = link

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints that move, base to tip."""
        return self._joints

    @property
    def chain(self) -> tuple[Joint, ...]:
        """All joints from base to tip, fixed ones included."""
        return self._chain

    def command(self, targets: Sequence[Target | None]) -> None:
        """Set the targets of the joints, base to tip; None keeps a joint's target."""
        if len(targets) != len(self._joints):
            raise ValueError(f"{len(targets)} targets for the {len(self._joints)} joints of {self._name!r}")
        self._link.submit(JointTargets(self._name, tuple(targets)))

    def hold(self) -> None:
        """Stop, and hold the present positions."""
        self._link.submit(JointTargets(self._name, (None,) * len(self._joints), hold=True))

    def state(self) -> JointState:
        """Positions, velocities and efforts after the last step."""
        return self._link.snapshot.joints[self._name]


class LidarProxy:
    """A `RangeFinder`."""

    def __init__(self, name: str, lidar: RangeFinder, link: RobotLink) -> None:
        self._name = name
        self._setup, self._settings = lidar.setup, lidar.settings
        self._link = link

    @property
    def setup(self) -> LidarSetup:
        """Link, rate and limits."""
        return self._setup

    @property
    def settings(self) -> ScanSettings:
        """The settings that were last commanded."""
        return self._settings

    def configure(self, settings: ScanSettings) -> None:
        """Measure with these settings from the next scan on."""
        self._settings = settings
        self._link.submit(LidarSettings(self._name, settings))

    @property
    def scan(self) -> RangeScan | None:
        """The last scan; None while it is not active."""
        return self._link.snapshot.scans[self._name]

    @property
    def age(self) -> float:
        """Seconds since the last scan; 0 without one."""
        snapshot = self._link.snapshot
        scan = snapshot.scans[self._name]
        return snapshot.time - scan.time if scan else 0.0


class ForceTorqueProxy:
    """A `ForceTorqueSensor`."""

    def __init__(self, name: str, sensor: ForceTorqueSensor, link: RobotLink) -> None:
        self._name, self._setup = name, sensor.setup
        self._link = link

    @property
    def setup(self) -> ForceTorqueSetup:
        """Link, rate and limits."""
        return self._setup

    @property
    def wrench(self) -> Wrench:
        """The last measurement."""
        return self._link.snapshot.wrenches[self._name]
