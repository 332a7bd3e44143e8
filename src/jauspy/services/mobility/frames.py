"""REP-103 (x forward, y left, z up) to JAUS (x forward, y right, z down), and back: a half turn about x.

The same half turn takes the world frame of a platform to the local frame of JAUS.
"""

from __future__ import annotations

import math

from jauspy.geometry.poses import Acceleration, Pose, Twist


def jaus_pose(pose: Pose) -> Pose:
    """A pose in the other frame; its own inverse."""
    return Pose(pose.x, -pose.y, -pose.z, wrap(pose.roll), wrap(-pose.pitch), wrap(-pose.yaw))


def jaus_twist(twist: Twist) -> Twist:
    """A body twist in the other frame; its own inverse."""
    return Twist(twist.vx, -twist.vy, -twist.vz, twist.wx, -twist.wy, -twist.wz)


def jaus_acceleration(acceleration: Acceleration) -> Acceleration:
    """A body acceleration in the other frame; its own inverse."""
    a = acceleration
    return Acceleration(a.ax, -a.ay, -a.az, a.wx, -a.wy, -a.wz)


def wrap(angle: float) -> float:
    """The same angle (rad) in -pi..pi."""
    return math.remainder(angle, math.tau)
