"""Commands to the parts that every robot has. Sent by any thread; the thread that owns the robot applies them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from jauspy.platform.contract import Command, DriveBase, PartId, Robot
from jauspy.platform.joints import JointGroup, Target
from jauspy.platform.ranging import RangeFinder, ScanSettings

CHASSIS: Final = PartId(DriveBase)


@dataclass(frozen=True, slots=True)
class DriveEffort(Command):
    """Drive with fractions of the full effort, -1..1; positive z turns left, positive y is left."""

    linear_x: float
    rotational_z: float
    linear_y: float = 0.0
    part: PartId = CHASSIS

    def apply(self, robot: Robot) -> None:
        """Set the effort."""
        robot.drive.set_effort(self.linear_x, self.rotational_z, self.linear_y)


@dataclass(frozen=True, slots=True)
class DriveStop(Command):
    """Brake the chassis to a standstill."""

    part: PartId = CHASSIS

    def apply(self, robot: Robot) -> None:
        """Brake the chassis."""
        robot.drive.stop()


@dataclass(frozen=True, slots=True)
class JointTargets(Command):
    """Targets of the joints of a group, base to tip; None keeps a joint's target."""

    group: str
    targets: tuple[Target | None, ...]
    hold: bool = False
    """True to hold all joints first; those with a target then follow it."""

    @property
    def part(self) -> PartId:
        """The group."""
        return PartId(JointGroup, self.group)

    def apply(self, robot: Robot) -> None:
        """Hold, then follow the targets."""
        group = robot.groups[self.group]
        if self.hold:
            group.hold()
        group.command(self.targets)

    def merged(self, pending: Command) -> JointTargets:
        """Merge with a pending command: the later target of each joint counts; a hold cancels earlier targets."""
        if self.hold or not isinstance(pending, JointTargets):
            return self
        targets = tuple(new or old for new, old in zip(self.targets, pending.targets, strict=True))
        return JointTargets(self.group, targets, pending.hold)


@dataclass(frozen=True, slots=True)
class LidarSettings(Command):
    """Settings of a lidar, applied from its next scan on."""

    lidar: str
    settings: ScanSettings

    @property
    def part(self) -> PartId:
        """The lidar."""
        return PartId(RangeFinder, self.lidar)

    def apply(self, robot: Robot) -> None:
        """Configure the lidar."""
        robot.lidars[self.lidar].configure(self.settings)
