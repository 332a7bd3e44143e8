"""Velocities of the joints that move the tool point along a straight line, and turn the last link evenly.

Each look is one problem of least squares. It asks for the wanted velocity times a share of it, so that where joints
come to a limit, or the arm is stretched out, the tool slows down on its line instead of leaving it. The line counts
more than the share, and the share more than the attitude, which an arm of few joints cannot keep.
"""

from __future__ import annotations

import math
from operator import mul
from typing import TYPE_CHECKING, Final

from jauspy.geometry.kinematics import InverseKinematics, KinematicState, forward_kinematics
from jauspy.geometry.least_squares import bounded_least_squares
from jauspy.geometry.vectors import Vector, scaled
from jauspy.services.manipulator.pace import brakeable, ramped, slowed
from jauspy.services.manipulator.tool_line import ToolLine

if TYPE_CHECKING:
    from jauspy.services.manipulator.arm import Arm

STILL: Final[Vector] = (0.0, 0.0, 0.0)
SHARE: Final = 0.1
"""How much the share of the velocity counts, beside the line that the tool point is on."""
ATTITUDE: Final = 0.01
"""Metres that a radian of the last link's attitude counts as."""
DAMPING: Final = 0.003
"""Metres that a radian of a joint counts as."""
NEARLY_SINGULAR: Final = 0.1
"""Likeness (see `_likeness`) below which damping grows, and a way out is looked for."""
SINGULAR_DAMPING: Final = 0.05
"""What damping grows to, so that joints do not race and jitter."""
CORRECTION: Final = 3.0
"""Part of its deviation from the line that the tool makes good in a second."""
AHEAD: Final = 0.01
"""Metres ahead on the line that a way out leads to."""
STEPS: Final = 10
"""Of a search for a way out, which is over at once where there is one."""
BEND: Final = 0.05
"""Radians or metres by which joints are bent to look for one."""


class ToolMotion:
    """A motion of an arm's tool. It begins where the arm is, at the velocities that the joints have."""

    def __init__(self, arm: Arm) -> None:
        self._arm = arm
        self._rates = list(arm.state().velocities)
        self._line = ToolLine(arm.kinematic_state().tool, STILL, STILL)

    @property
    def is_over(self) -> bool:
        """The tool was told to stop, and has."""
        return not self._line.speed and not any(self._rates)

    def follow(self, turning: Vector, moving: Vector) -> None:
        """Turn at so many rad/s and move at so many m/s, on a line from here; the same again goes on as before."""
        if (turning, moving) != (self._line.turning, self._line.moving):
            self._line = ToolLine(self._arm.kinematic_state().tool, turning, moving)

    def rates(self, dt: float) -> list[float]:
        """What the joints are to do for the next `dt` seconds, within their limits and the motion profile."""
        now, profiles = self._arm.kinematic_state(), self._arm.profiles
        wanted = self._wanted(now, dt) if self._line.speed else [0.0] * len(profiles)
        self._rates = ramped(self._rates, slowed(wanted, profiles), profiles, dt)
        self._line.advance(now, self._rates, dt)
        return self._rates

    def _wanted(self, now: KinematicState, dt: float) -> list[float]:
        lack = max(0.0, 1.0 - _likeness(now) / NEARLY_SINGULAR)
        way = self._way_out() if lack and any(self._line.moving) else None
        return way or self._solve(now, DAMPING + (SINGULAR_DAMPING - DAMPING) * lack * lack, dt)

    def _way_out(self) -> list[float] | None:
        """To a place further on the line, if there is one: slopes do not tell how a stretched arm is drawn in."""
        arm, positions = self._arm, self._arm.state().positions
        goal = self._line.further(AHEAD)
        search = InverseKinematics(
            arm.geometry.links, arm.tool, goal, self._bent(), arm.limits, starts=1, weights=((ATTITUDE,),)
        )
        found = search.advance(STEPS)
        if found is None or not found.reaches_point:
            return None
        part = math.hypot(*self._line.moving) / AHEAD
        return [part * (there - here) for there, here in zip(found.positions, positions, strict=True)]

    def _bent(self) -> list[float]:
        """The joints as they are, a little bent to the side that gives the tool more freedom."""
        arm, positions = self._arm, self._arm.state().positions
        sides = ([p + (bend if number % 2 else -bend) for number, p in enumerate(positions)] for bend in (BEND, -BEND))
        return max(sides, key=lambda bent: _likeness(forward_kinematics(arm.geometry.links, bent, arm.tool)))

    def _solve(self, now: KinematicState, damping: float, dt: float) -> list[float]:
        """The best velocities of the joints; one more unknown is the share of the wanted velocity."""
        line, joints = self._line, len(self._rates)
        turn, way = line.deviation(now.tool)
        rows: list[list[float]] = [[*row, -v] for *row, v in zip(*now.linear_jacobian, line.moving, strict=True)]
        rows += [
            [ATTITUDE * value for value in (*row, -w)]
            for *row, w in zip(*now.angular_jacobian, line.turning, strict=True)
        ]
        rows.append([0.0] * joints + [SHARE * line.speed])
        wanted = [*scaled(way, CORRECTION), *scaled(turn, CORRECTION * ATTITUDE), SHARE * line.speed]
        lower, upper = self._bounds(dt)
        return bounded_least_squares(rows, wanted, [*lower, 0.0], [*upper, 1.0], [damping] * joints + [1e-6])[:-1]

    def _bounds(self, dt: float) -> tuple[list[float], list[float]]:
        """How fast the joints may go so as to stop at their limits."""
        rows = list(zip(self._arm.state().positions, self._arm.limits, self._arm.profiles, strict=True))
        lower = [-brakeable(position - low, profile, dt) for position, (low, _), profile in rows]
        return lower, [brakeable(high - position, profile, dt) for position, (_, high), profile in rows]


def _likeness(now: KinematicState) -> float:
    """How much alike the joints can move the tool point in all directions: 1, or 0 when in one they cannot."""
    axes = list(zip(*now.linear_jacobian, strict=True))
    products = [[sum(map(mul, a, b)) for b in axes] for a in axes]
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = products
    volume = xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz)
    return math.sqrt(max(0.0, volume) / max(1e-30, ((xx + yy + zz) / 3.0) ** 3))
