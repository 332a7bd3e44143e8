"""Acceleration from two velocities, for backends without an inertial sensor."""

from __future__ import annotations

from jauspy.geometry.poses import Acceleration, Twist


def mean_acceleration(before: Twist, after: Twist, dt: float) -> Acceleration:
    """Mean over the `dt` seconds (more than 0) between two body twists.

    The frame turns with the body, so the change of its velocity lacks what turning it takes: the rate times the speed.
    """
    vx, vy, vz = _mean(before.vx, after.vx), _mean(before.vy, after.vy), _mean(before.vz, after.vz)
    wx, wy, wz = _mean(before.wx, after.wx), _mean(before.wy, after.wy), _mean(before.wz, after.wz)
    return Acceleration(
        ax=(after.vx - before.vx) / dt + wy * vz - wz * vy,
        ay=(after.vy - before.vy) / dt + wz * vx - wx * vz,
        az=(after.vz - before.vz) / dt + wx * vy - wy * vx,
        wx=(after.wx - before.wx) / dt,
        wy=(after.wy - before.wy) / dt,
        wz=(after.wz - before.wz) / dt,
    )


def _mean(before: float, after: float) -> float:
    return (before + after) / 2.0
