"""Resolved-rate control: joint velocities that move the tool point on a straight line and rotate the last link evenly.

Each step is a linear least-squares problem for the joint velocities and the share of the commanded velocity. Where a
joint meets its limit, or the arm is stretched out, the share falls: the tool slows down on its line instead of leaving
it. The line has priority over the share, and the share over the attitude, which an arm of few joints cannot keep.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from operator import mul
from typing import Final

from jauspy.geometry.kinematics import InverseKinematics, KinematicState, forward_kinematics
from jauspy.geometry.least_squares import bounded_least_squares
from jauspy.geometry.poses import Transform, rotation_vector
from jauspy.geometry.vectors import Rotation, Vector, add, difference, dot, rotation_about, scaled
from jauspy.services.manipulator.arm import Arm, MotionProfile

SHARE_WEIGHT: Final = 0.1
"""Weight of the share of the commanded velocity, relative to that of the line."""
ATTITUDE_WEIGHT: Final = 0.01
"""Metres that a radian of the last link's attitude counts as."""
DAMPING: Final = 0.001
"""Metres that a radian of a joint counts as."""
SINGULAR_DAMPING: Final = 0.05
"""The damping at a singularity, which keeps joints from racing."""
MIN_ISOTROPY: Final = 0.1
"""Isotropy below which the arm is near a singularity: damping grows, and an escape is searched."""
CORRECTION_RATE: Final = 3.0
"""Part of its deviation from the line that the tool corrects in a second."""
LOOK_AHEAD: Final = 0.01
"""Metres ahead on the line to which an escape leads."""
MAX_ESCAPE_STEPS: Final = 10
"""Steps of inverse kinematics for an escape."""
ESCAPE_BEND: Final = 0.05
"""Radians or metres by which the joints are bent where the search for an escape starts."""
MAX_LAG: Final = 0.02
"""Metres or radians that the tool may fall behind the line's pose before that waits."""
METRES_PER_RADIAN: Final = 0.3
"""Metres per second that a radian per second counts as in the speed of a motion."""
ZERO: Final[Vector] = (0.0, 0.0, 0.0)


class ToolMotion:
    """A motion of an arm's tool, which starts at the present positions and velocities of the joints."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm
        self._rates = list(arm.state().velocities)
        self._line = ToolLine(arm.kinematic_state().tool, ZERO, ZERO)

    @property
    def is_finished(self) -> bool:
        """True if zero velocity is commanded and the joints stand."""
        return not self._line.speed and not any(self._rates)

    def follow(self, angular: Vector, linear: Vector) -> None:
        """Move at `angular` rad/s and `linear` m/s on a line from here; the same velocity again keeps the line."""
        if (angular, linear) != (self._line.angular, self._line.linear):
            self._line = ToolLine(self._arm.kinematic_state().tool, angular, linear)

    def rates(self, dt: float) -> list[float]:
        """Joint velocities for the next `dt` seconds, within limits and motion profile."""
        now, profiles = self._arm.kinematic_state(), self._arm.profiles
        wanted = self._unlimited(now, dt) if self._line.speed else [0.0] * len(profiles)
        self._rates = limited_change(self._rates, scaled_to_speed(wanted, profiles), profiles, dt)
        self._line.advance(now, self._rates, dt)
        return self._rates

    def _unlimited(self, now: KinematicState, dt: float) -> list[float]:
        deficit = max(0.0, 1.0 - _isotropy(now) / MIN_ISOTROPY)
        escape = self._escape() if deficit and any(self._line.linear) else None
        return escape or self._solve(now, DAMPING + (SINGULAR_DAMPING - DAMPING) * deficit * deficit, dt)

    def _escape(self) -> list[float] | None:
        """Velocities to a pose further on the line, if there is one: a singular Jacobian shows no way back."""
        arm, positions = self._arm, self._arm.state().positions
        goal = self._line.ahead(LOOK_AHEAD)
        search = InverseKinematics(
            arm.geometry.links,
            arm.tool,
            goal,
            self._start_positions(),
            arm.limits,
            starts=1,
            weights=((ATTITUDE_WEIGHT,),),
        )
        found = search.advance(MAX_ESCAPE_STEPS)
        if found is None or not found.reaches_point:
            return None
        rate = math.hypot(*self._line.linear) / LOOK_AHEAD
        return [rate * (target - position) for target, position in zip(found.positions, positions, strict=True)]

    def _start_positions(self) -> list[float]:
        """The present positions, bent a little to the side of greater isotropy."""
        arm, positions = self._arm, self._arm.state().positions
        sides = (
            [p + (bend if number % 2 else -bend) for number, p in enumerate(positions)]
            for bend in (ESCAPE_BEND, -ESCAPE_BEND)
        )
        return max(sides, key=lambda bent: _isotropy(forward_kinematics(arm.geometry.links, bent, arm.tool)))

    def _solve(self, now: KinematicState, damping: float, dt: float) -> list[float]:
        """Joint velocities by least squares; one more unknown is the share of the commanded velocity."""
        line, joints = self._line, len(self._rates)
        turn, way = line.deviation(now.tool)
        middle = self._half_a_step_ahead(dt)
        rows: list[list[float]] = [[*row, -v] for *row, v in zip(*middle.linear_jacobian, line.linear, strict=True)]
        rows += [
            [ATTITUDE_WEIGHT * value for value in (*row, -w)]
            for *row, w in zip(*middle.angular_jacobian, line.angular, strict=True)
        ]
        rows.append([0.0] * joints + [SHARE_WEIGHT * line.speed])
        wanted = [
            *scaled(way, CORRECTION_RATE),
            *scaled(turn, CORRECTION_RATE * ATTITUDE_WEIGHT),
            SHARE_WEIGHT * line.speed,
        ]
        lower, upper = self._bounds(dt)
        return bounded_least_squares(rows, wanted, [*lower, 0.0], [*upper, 1.0], [damping] * joints + [1e-6])[:-1]

    def _half_a_step_ahead(self, dt: float) -> KinematicState:
        """The state whose Jacobian is the mean of the next step: with that of its start, a fast tool bends off."""
        arm = self._arm
        ahead = [p + rate * dt / 2.0 for p, rate in zip(arm.state().positions, self._rates, strict=True)]
        return forward_kinematics(arm.geometry.links, ahead, arm.tool)

    def _bounds(self, dt: float) -> tuple[list[float], list[float]]:
        """The least and the greatest velocity from which each joint can stop at its limits."""
        rows = list(zip(self._arm.state().positions, self._arm.limits, self._arm.profiles, strict=True))
        lower = [-braking_speed(position - low, profile, dt) for position, (low, _), profile in rows]
        return lower, [braking_speed(high - position, profile, dt) for position, (_, high), profile in rows]


def _isotropy(state: KinematicState) -> float:
    """Isotropy of the linear Jacobian: 1 if the tool point moves equally well in all directions, 0 at a singularity."""
    axes = list(zip(*state.linear_jacobian, strict=True))
    products = [[sum(map(mul, a, b)) for b in axes] for a in axes]
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = products
    volume = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz)
    return math.sqrt(max(0.0, volume) / max(1e-30, ((xx + yy + zz) / 3.0) ** 3))


class ToolLine:
    """A pose that moves on a straight line from `start`; at `angular` rad/s and `linear` m/s."""

    def __init__(self, start: Transform, angular: Vector, linear: Vector) -> None:
        self.angular, self.linear = angular, linear
        self._pose = start

    @property
    def speed(self) -> float:
        """Linear and angular speed together, m/s."""
        return math.hypot(*self.linear) + METRES_PER_RADIAN * math.hypot(*self.angular)

    def ahead(self, distance: float) -> Transform:
        """The pose at a distance ahead on the line, in metres."""
        way = scaled(self.linear, distance / math.hypot(*self.linear))
        return Transform(self._pose.rotation, add(self._pose.position, way))

    def deviation(self, tool: Transform) -> tuple[Vector, Vector]:
        """Rotation vector (rad) and translation (m) from the tool to the pose."""
        return rotation_vector(tool.rotation, self._pose.rotation), difference(self._pose.position, tool.position)

    def advance(self, now: KinematicState, rates: Sequence[float], dt: float) -> None:
        """Move as far as the tool does in `dt` seconds with these joint velocities, at most `MAX_LAG` ahead of it."""
        angular, linear = now.velocity(rates)
        time = dt * (_share(linear, self.linear) if any(self.linear) else _share(angular, self.angular))
        position = add(self._pose.position, scaled(self.linear, time))
        self._pose = Transform(_rotated_by(self._pose.rotation, scaled(self.angular, time)), position)
        turn, way = self.deviation(now.tool)
        tool = now.tool
        self._pose = Transform(_rotated_by(tool.rotation, _limited(turn)), add(tool.position, _limited(way)))


def _share(found: Vector, wanted: Vector) -> float:
    square = dot(wanted, wanted)
    return min(1.0, max(0.0, dot(found, wanted) / square)) if square else 0.0


def _rotated_by(rotation: Rotation, turn: Vector) -> Rotation:
    angle = math.hypot(*turn)
    if not angle:
        return rotation
    return (Transform(rotation_about(scaled(turn, 1.0 / angle), angle)) @ Transform(rotation)).rotation


def _limited(offset: Vector) -> Vector:
    length = math.hypot(*offset)
    return scaled(offset, MAX_LAG / length) if length > MAX_LAG else offset


def scaled_to_speed(rates: Sequence[float], profiles: Sequence[MotionProfile]) -> list[float]:
    """Velocities scaled by one factor, so that no joint exceeds its speed and the tool keeps its direction."""
    rows = zip(rates, profiles, strict=True)
    share = min((1.0, *(profile.speed / abs(rate) for rate, profile in rows if abs(rate) > profile.speed)))
    return [rate * share for rate in rates]


def limited_change(
    before: Sequence[float], after: Sequence[float], profiles: Sequence[MotionProfile], dt: float
) -> list[float]:
    """Velocities after `dt` seconds on the way to others, by one factor, so that no joint exceeds its acceleration."""
    share = 1.0
    for old, new, profile in zip(before, after, profiles, strict=True):
        limit = (profile.deceleration if abs(new) < abs(old) else profile.acceleration) * dt
        if abs(new - old) > limit:
            share = min(share, limit / abs(new - old))
    return [old + share * (new - old) for old, new in zip(before, after, strict=True)]


def braking_speed(distance: float, profile: MotionProfile, dt: float) -> float:
    """The speed from which a joint can stop within a distance, when it is commanded every `dt` seconds."""
    change = profile.deceleration * dt
    return math.sqrt(change * change / 4.0 + 2.0 * profile.deceleration * max(0.0, distance)) - change / 2.0
