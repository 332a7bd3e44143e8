"""Timing of paths of straight joint motions, within the joints' speeds, accelerations and jerks, by ruckig."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Final

import numpy as np
import ruckig

from jauspy.planning.arm_model import ArmModel
from jauspy.planning.obstacles import Array

PERIOD: Final = 0.02
"""Seconds between the points of a plan."""


def timed(arm: ArmModel, points: Sequence[Array]) -> tuple[Array, Array]:
    """Times (n) and positions (n, joints) of a motion that stops at each point of a path."""
    start, times, rows = 0.0, [np.zeros(1)], [points[0][None]]
    for one, other in pairwise(points):
        moved, at = _straight(arm, one, other)
        times.append(start + at)
        rows.append(moved)
        start += float(at[-1])
    return np.concatenate(times), np.concatenate(rows)


def _straight(arm: ArmModel, one: Array, other: Array) -> tuple[Array, Array]:
    """Positions and times after the start of a straight motion from rest to rest."""
    way = other - one
    length = float(np.abs(way).max())
    moved = np.abs(way) > 1e-9
    # one degree of freedom, the way along the line, so that the joints stay on it
    scale = np.abs(way[moved])
    limits = [float((rows[moved] / scale).min()) for rows in (arm.speeds, arm.accelerations, arm.jerks)]
    if length < 1e-9:
        return other[None], np.array([PERIOD])
    given = ruckig.InputParameter(1)
    given.current_position, given.target_position = [0.0], [1.0]
    given.max_velocity, given.max_acceleration, given.max_jerk = ([limit] for limit in limits)
    trajectory = ruckig.Trajectory(1)
    ruckig.Ruckig(1).calculate(given, trajectory)
    count = max(1, int(np.ceil(trajectory.duration / PERIOD)))
    times = trajectory.duration * np.arange(1, count + 1) / count
    shares = np.array([trajectory.at_time(float(time))[0][0] for time in times])
    return one + shares[:, None] * way, times
