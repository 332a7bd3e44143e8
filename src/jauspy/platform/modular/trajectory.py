"""Trajectories of all joints of an arm: time-optimal within limits of velocity, acceleration and jerk, by ruckig."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final, NamedTuple, Protocol

import numpy as np
import ruckig
from numpy.typing import NDArray

Array = NDArray[np.float64]

TORQUE_SAMPLES: Final = 40
"""Moments of a trajectory at which its torques are compared with their limits."""

TORQUE_ROUNDS: Final = 8
"""Number of times that accelerations are lowered until the torques of a trajectory are within limits."""


LONGEST_BRAKING: Final = 0.13
"""Seconds that braking takes at most: with what the shaping adds, an arm stands within 200 ms."""


class Setpoint(NamedTuple):
    """Positions, velocities and accelerations of all joints: rad, rad/s, rad/s^2."""

    q: Array
    v: Array
    a: Array


class Shaper:
    """A moving average of setpoints: it makes the jerk of a motion continuous, so that springs are not excited.

    It keeps all limits, keeps a straight path straight, and is late by half of its length.
    """

    def __init__(self, setpoint: Setpoint, length: int) -> None:
        self._rows = np.repeat(np.concatenate(setpoint)[np.newaxis], max(1, length), axis=0)
        self._joints = len(setpoint.q)
        self._sum = self._rows.sum(axis=0)
        self._index = 0
        self._last = self._rows[0].tobytes()
        self._repeats = len(self._rows)

    @property
    def ended(self) -> bool:
        """True if the mean is the last setpoint, because nothing else came in for the whole length."""
        return self._repeats >= len(self._rows)

    def advance(self, setpoint: Setpoint) -> Setpoint:
        """Take the next setpoint in, and return the mean."""
        row = np.concatenate(setpoint)
        same, self._last = self._last, row.tobytes()
        self._repeats = self._repeats + 1 if self._last == same else 1
        self._sum += row - self._rows[self._index]
        self._rows[self._index] = row
        self._index = (self._index + 1) % len(self._rows)
        if self.ended:
            self._sum = row * len(self._rows)  # without what rounding has left
            return setpoint
        mean, count = self._sum / len(self._rows), self._joints
        return Setpoint(mean[:count], mean[count : 2 * count], mean[2 * count :])


class MotionError(ValueError):
    """A motion that limits do not allow; the message says why."""


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits of each joint: rad/s, rad/s^2, rad/s^3."""

    velocity: tuple[float, ...]
    acceleration: tuple[float, ...]
    jerk: tuple[float, ...]


class Timed(Protocol):
    """Path of all joints over time, at rest at its end."""

    @property
    def duration(self) -> float:
        """Seconds."""
        ...

    def at_time(self, time: float) -> tuple[Any, Any, Any]:
        """Positions, velocities and accelerations at a time from the start."""
        ...


class Motion:
    """Motion along a path; `sample` returns where it is. No angle is wrapped."""

    def __init__(self, path: Timed | None, target: Sequence[float], limits: Limits) -> None:
        """Follow a path to rest at `target`; without a path it is there already."""
        self._time = 0.0
        self._pace = 1.0
        self._brake_time = 0.0
        self._braking = 0.0
        self._limits = limits
        self._path = path
        self.duration: float = path.duration if path is not None else 0.0
        self.target: tuple[float, ...] = tuple(map(float, target))
        self._end = Setpoint(np.array(self.target), np.zeros(len(self.target)), np.zeros(len(self.target)))

    @property
    def ended(self) -> bool:
        """True once the setpoint stands still."""
        return self._time >= self.duration or (self._brake_time > 0.0 and self._braking >= self._brake_time)

    def brake(self) -> None:
        """Come to rest along the path, within the limits of acceleration; the target becomes that point."""
        if self._brake_time or self.ended:
            return
        now = self.sample(self._time)
        needed = max((abs(v) / a for v, a in zip(now.v, self._limits.acceleration, strict=True)), default=0.0)
        self._brake_time = min(
            LONGEST_BRAKING, max(1e-3, 1.5 * needed)
        )  # the steepest slope of the ramp is 1.5 times its mean

    def advance(self, dt: float) -> Setpoint:
        """The setpoint after another `dt` seconds."""
        if self._brake_time <= 0.0:
            self._time += dt
            return self._end if self._time >= self.duration else self.sample(self._time)
        self._braking = min(self._brake_time, self._braking + dt)
        part = self._braking / self._brake_time
        slower = 1.0 - part * part * (3.0 - 2.0 * part)
        slope = -6.0 * part * (1.0 - part) / self._brake_time
        self._time += 0.5 * (self._pace + slower) * dt
        self._pace = slower
        q, v, a = self.sample(self._time)
        found = Setpoint(q, v * slower, a * slower * slower + v * slope)
        if self.ended:
            self._end = found = Setpoint(q, np.zeros_like(q), np.zeros_like(q))
            self.target = tuple(q.tolist())
        return found

    def sample(self, time: float) -> Setpoint:
        """The setpoint `time` seconds after the start, without braking."""
        if self._path is None:
            return self._end
        q, v, a = self._path.at_time(min(time, self.duration))
        return Setpoint(np.array(q), np.array(v), np.array(a))


class PlannedMotion(Motion):
    """Motion from a setpoint to rest at a target, as fast as limits allow or in a given time."""

    def __init__(
        self,
        start: Setpoint,
        target: Sequence[float] | None,
        limits: Limits,
        duration: float = 0.0,
        shaping: float = 0.0,
    ) -> None:
        """Plan it; `duration` 0 takes as long as the limits demand; without a target it only comes to rest.

        `shaping` seconds of a given duration are for the `Shaper`. Raises `MotionError`.
        """
        path = _plan(start, target, limits, duration, shaping)
        if target is None:
            target = path.at_time(path.duration)[0] if path is not None else start.q.tolist()
        super().__init__(path, target, limits)


def _plan(
    start: Setpoint, target: Sequence[float] | None, limits: Limits, duration: float, shaping: float
) -> ruckig.Trajectory | None:
    count = len(start.q)
    if not count:
        return None
    request = ruckig.InputParameter(count)
    request.current_position, request.current_velocity = start.q.tolist(), start.v.tolist()
    request.current_acceleration = start.a.tolist()
    if target is None:
        request.control_interface = ruckig.ControlInterface.Velocity
    else:
        request.target_position = list(target)
    # where the arm still moves its joints may be a little beyond limits that a new payload has lowered
    request.max_velocity = [max(v, 1.001 * abs(now)) for v, now in zip(limits.velocity, start.v, strict=True)]
    request.max_acceleration = [max(a, 1.001 * abs(now)) for a, now in zip(limits.acceleration, start.a, strict=True)]
    request.max_jerk = list(limits.jerk)
    request.synchronization = ruckig.Synchronization.Time if target is None else ruckig.Synchronization.Phase
    trajectory = ruckig.Trajectory(count)
    planner = ruckig.Ruckig(count)
    _calculate(planner, request, trajectory, f"no trajectory to {_text(target)} within the limits")
    shortest = trajectory.duration + shaping
    if duration and duration < shortest - 1e-6:
        raise MotionError(f"a duration of {duration:.3g} s is too short: within the limits it takes {shortest:.3f} s")
    if duration > shortest:
        request.minimum_duration = duration - shaping
        _calculate(planner, request, trajectory, f"no trajectory to {_text(target)} in {duration:.3g} s")
    return trajectory


def _calculate(
    planner: ruckig.Ruckig, request: ruckig.InputParameter, trajectory: ruckig.Trajectory, problem: str
) -> None:
    try:
        result = planner.calculate(request, trajectory)
    except ruckig.RuckigError as error:
        raise MotionError(problem) from error
    if result < 0:
        raise MotionError(f"{problem} ({result})")


def plan_within_torques(
    start: Setpoint,
    target: Sequence[float],
    limits: Limits,
    torque_ratio: Callable[[Setpoint], float],
    *,
    duration: float = 0.0,
    shaping: float = 0.0,
) -> PlannedMotion:
    """Plan a motion whose torques stay within limits: accelerations are lowered until they do.

    `torque_ratio` returns the largest torque at a setpoint as a fraction of its limit. Raises `MotionError`; the
    message completes "motion refused: ".
    """
    ratio = math.inf
    for _ in range(TORQUE_ROUNDS):
        try:
            motion = PlannedMotion(start, target, limits, duration, shaping)
        except MotionError:
            if ratio < math.inf:
                break
            raise
        times = np.linspace(0.0, motion.duration, TORQUE_SAMPLES)
        ratio = max((torque_ratio(motion.sample(float(time))) for time in times), default=0.0)
        if ratio <= 1.0:
            return motion
        slower = min(0.9, max(0.3, 1.0 / ratio))
        lowered = tuple(limit * slower for limit in limits.acceleration)
        limits = Limits(limits.velocity, lowered, tuple(limit * slower for limit in limits.jerk))
    raise MotionError(
        f"the motion to {_text(target)}{f' in {duration:.3g} s' if duration else ''} needs {ratio:.2f} times the "
        "torque that a servo module has"
    )


def _text(target: Sequence[float] | None) -> str:
    if target is None:
        return "rest"
    return "(" + ", ".join(f"{position:.4g}" for position in target) + ") rad"
