"""What was seen of a robot after a step."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from jauspy.geometry.poses import Acceleration, Pose, Twist
from jauspy.platform.contract import Robot
from jauspy.platform.force_torque import Wrench
from jauspy.platform.joints import JointState
from jauspy.platform.ranging import RangeScan


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The robot's state at one moment; `time` is the robot's own, in seconds."""

    time: float
    pose: Pose
    twist: Twist
    acceleration: Acceleration
    joints: Mapping[str, JointState]
    """The state of its other joints, by group."""
    scans: Mapping[str, RangeScan | None]
    """The last scans of its lidars."""
    wrenches: Mapping[str, Wrench]
    """The last measurements of its sensors of force and torque."""


def look(robot: Robot) -> Snapshot:
    """The robot's state now."""
    drive = robot.drive
    joints = {name: group.state() for name, group in robot.groups.items()}
    scans = {name: lidar.scan for name, lidar in robot.lidars.items()}
    wrenches = {name: sensor.wrench for name, sensor in robot.force_torque.items()}
    return Snapshot(robot.time, drive.pose(), drive.twist(), drive.acceleration(), joints, scans, wrenches)
