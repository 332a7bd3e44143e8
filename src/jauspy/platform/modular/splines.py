"""Splines of all joints through points at given times: cubic, or quintic where accelerations are given.

Vectors and columns are in the order of the joints; s, rad, rad/s, rad/s^2.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from jauspy.platform.modular.trajectory import Limits, MotionError, Setpoint

Array = NDArray[np.float64]

MIN_INTERVAL: Final = 0.01
"""Seconds between two points at least."""

SAMPLES: Final = 8
"""Moments between two points at which velocities and accelerations are compared with their limits."""

TORQUE_SAMPLES: Final = 200
"""Moments of a trajectory at which its torques are compared with their limits, and at least one between two points."""


@dataclass(frozen=True, slots=True)
class Knots:
    """Points in the columns' order of the joints, one row each; NaN for a velocity or acceleration that is free."""

    times: Array
    positions: Array
    velocities: Array
    accelerations: Array


class Spline:
    """Path of the joints through the points, from a setpoint to rest at the last point.

    Where a velocity is free it is the one that keeps the acceleration continuous. A joint for which an acceleration is
    given has polynomials of degree five, whose free accelerations are those of the cubic spline.
    """

    def __init__(self, start: Setpoint, knots: Knots) -> None:
        """Raises `MotionError` for times that are not in order, and for a point that cannot be the last."""
        _check_times(knots.times)
        self._times = times = np.concatenate(([0.0], knots.times))
        q = np.vstack((start.q, knots.positions))
        v = np.vstack((start.v, knots.velocities))
        a = np.vstack((start.a, knots.accelerations))
        quintic = np.isfinite(knots.accelerations).any(axis=0)
        v[-1] = np.where(np.isnan(v[-1]), 0.0, v[-1])
        a[-1] = np.where(np.isnan(a[-1]), 0.0, a[-1])
        if v[-1].any() or (a[-1] * quintic).any():
            raise MotionError("the last point has a velocity or an acceleration; the arm comes to rest there")
        steps = np.diff(times)[:, np.newaxis]
        v = _velocities(steps, q, v)
        self._coefficients = _cubic(steps, q, v)
        if quintic.any():
            a = np.where(np.isnan(a), _accelerations(self._coefficients, steps), a)
            self._coefficients[..., quintic] = _quintic(steps, q, v, a)[..., quintic]
        self.duration: float = float(times[-1])
        """Seconds from the start to the last point."""

    def at_time(self, time: float) -> tuple[Array, Array, Array]:
        """Positions, velocities and accelerations of the joints."""
        q, v, a = self._sample(np.array([time]))
        return q[0], v[0], a[0]

    def check(
        self, names: Sequence[str], limits: Limits, torques: Callable[[Setpoint], Array], allowed: Sequence[float]
    ) -> None:
        """Raise `MotionError` with joint, time and figure if the path exceeds a limit.

        `torques` returns those of the motors (N m) at a setpoint, `allowed` are the largest of each joint (N m).
        """
        moments = self._moments(SAMPLES)
        _, speeds, accelerations = self._sample(moments)
        _check_table(names, moments, speeds, limits.velocity, "turns at {} rad/s")
        _check_table(names, moments, accelerations, limits.acceleration, "accelerates by {} rad/s^2")
        moments = self._moments(max(1, TORQUE_SAMPLES // (len(self._times) - 1)))
        needed = np.array([torques(Setpoint(*rows)) for rows in zip(*self._sample(moments), strict=True)])
        _check_table(names, moments, needed, allowed, "needs {} N m")

    def _moments(self, count: int) -> Array:
        """Times at the points, and this number of them in each interval."""
        parts = np.arange(count) / count
        moments = self._times[:-1, np.newaxis] + np.diff(self._times)[:, np.newaxis] * parts
        return np.append(moments.ravel(), self._times[-1])

    def _sample(self, times: Array) -> tuple[Array, Array, Array]:
        """Positions, velocities and accelerations, a row for each of these times."""
        last = len(self._times) - 2
        intervals = np.clip(np.searchsorted(self._times, times, side="right") - 1, 0, last)
        c0, c1, c2, c3, c4, c5 = self._coefficients[:, intervals]
        t = (times - self._times[intervals])[:, np.newaxis]
        q = c0 + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * c5))))
        v = c1 + t * (2.0 * c2 + t * (3.0 * c3 + t * (4.0 * c4 + t * 5.0 * c5)))
        a = 2.0 * c2 + t * (6.0 * c3 + t * (12.0 * c4 + t * 20.0 * c5))
        return q, v, a


def _check_times(times: Array) -> None:
    before = 0.0
    for number, time in enumerate(times.tolist(), 1):
        if time - before < MIN_INTERVAL:
            raise MotionError(
                f"point {number} is at {time:.4g} s, {1000.0 * (time - before):.4g} ms after the one before; "
                f"it takes at least {1000.0 * MIN_INTERVAL:.0f} ms"
            )
        before = time


def _check_table(names: Sequence[str], moments: Array, found: Array, limits: Sequence[float], text: str) -> None:
    found = np.abs(found)
    over = found / np.array(limits)
    if over.size and over.max() > 1.0 + 1e-9:
        moment, joint = divmod(int(np.argmax(over)), over.shape[1])
        figure = text.format(f"{found[moment, joint]:.3g}")
        raise MotionError(f"{names[joint]} {figure} at {moments[moment]:.3g} s; its limit is {limits[joint]:.3g}")


def _velocities(steps: Array, q: Array, v: Array) -> Array:
    """Velocities at all points: given ones, and those that make the acceleration continuous where they are NaN.

    The equations are tridiagonal; those of the first and last point are given.
    """
    found = np.where(np.isnan(v), 0.0, v)
    slopes = 3.0 * np.diff(q, axis=0) / steps**2
    upper = np.zeros_like(q)
    for row in range(1, len(q) - 1):
        free = np.isnan(v[row])
        before, after = 1.0 / steps[row - 1], 1.0 / steps[row]
        pivot = 2.0 * (before + after) - before * upper[row - 1]
        upper[row] = np.where(free, after / pivot, 0.0)
        solved = (slopes[row - 1] + slopes[row] - before * found[row - 1]) / pivot
        found[row] = np.where(free, solved, v[row])
    for row in range(len(q) - 2, 0, -1):
        found[row] -= upper[row] * found[row + 1]
    return found


def _cubic(steps: Array, q: Array, v: Array) -> Array:
    """Coefficients by power, interval and joint of the polynomials with these values at both ends."""
    slope = np.diff(q, axis=0) / steps
    v0, v1 = v[:-1], v[1:]
    zeros = np.zeros_like(slope)
    return np.array(
        [q[:-1], v0, (3.0 * slope - 2.0 * v0 - v1) / steps, (v0 + v1 - 2.0 * slope) / steps**2, zeros, zeros]
    )


def _accelerations(coefficients: Array, steps: Array) -> Array:
    """Accelerations of cubic polynomials at the points: the mean of those before and after."""
    begin = 2.0 * coefficients[2]
    end = begin + 6.0 * coefficients[3] * steps
    return np.vstack((begin[:1], 0.5 * (end[:-1] + begin[1:]), end[-1:]))


def _quintic(steps: Array, q: Array, v: Array, a: Array) -> Array:
    way, h = np.diff(q, axis=0), steps
    v0, v1, a0, a1 = v[:-1], v[1:], a[:-1], a[1:]
    off = way - v0 * h - 0.5 * a0 * h**2
    slope = (v1 - v0 - a0 * h) * h
    bend = (a1 - a0) * h**2
    return np.array(
        [
            q[:-1],
            v0,
            0.5 * a0,
            (10.0 * off - 4.0 * slope + 0.5 * bend) / h**3,
            (-15.0 * off + 7.0 * slope - bend) / h**4,
            (6.0 * off - 3.0 * slope + 0.5 * bend) / h**5,
        ]
    )
