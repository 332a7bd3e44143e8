"""Joints that do not reach their positions, because something is in the way or their load is too heavy."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from jauspy.geometry.urdf import Joint
from jauspy.platform.joints import JointState

BLOCKED_TIME: Final = 0.7
"""Seconds for which a joint stands still before it counts as blocked; a slow one longer, see `LEAST_SEEN`."""
LEAST_SHORT: Final = 0.015
"""Radians or metres from its position from which on a joint that stands still is blocked."""
LEAST_MOTION: Final = 0.003
"""Radians or metres in that time with which a fast joint counts as moving."""
SLOW: Final = 0.25
"""Share of the motion that its profile permits in that time, with which a slow joint counts as moving."""
LEAST_SEEN: Final = 0.001
"""Radians or metres of that share: less hides in friction and noise, so that a slow joint gets more time. One that
turns by 0.02 rad while others turn by 2 moves by a thousandth of that in the first tenth."""


@dataclass(frozen=True, slots=True)
class BlockedJoint:
    """A joint that does not follow."""

    joint: Joint
    effort: float
    """Effort with which it pushed, or that of something that it has met, N m or N."""
    short: float
    """Radians or metres from its position; 0 for a motion without one."""

    def __str__(self) -> str:
        push, way = ("N m", "rad") if self.joint.turns else ("N", "m")
        short = f", {abs(self.short):.2f} {way} short" if self.short else ""
        return f"{self.joint.name}, {abs(self.effort):.0f} {push}{short}"


class StandstillWatch:
    """Watches the joints during one command to positions; positions and ways as the description counts them."""

    def __init__(self, joints: Sequence[Joint], limits: Sequence[tuple[float, float]]) -> None:
        self._joints = joints
        self._times = [_time(*limit) for limit in limits]
        self._least = [min(LEAST_MOTION, _share(*row)) for row in zip(self._times, limits, strict=True)]
        self._since: list[tuple[float, float]] | None = None

    def blocked(self, now: float, state: JointState, ways: Sequence[float]) -> tuple[BlockedJoint, ...]:
        """The joints that have stood still for too long, where `ways` are left to their positions."""
        if self._since is None:
            self._since = [(position, now) for position in state.positions]
        found = []
        for number, (joint, position, way) in enumerate(zip(self._joints, state.positions, ways, strict=True)):
            start, since = self._since[number]
            if abs(way) < LEAST_SHORT or abs(position - start) > self._least[number]:
                self._since[number] = (position, now)
            elif now - since >= self._times[number]:
                found.append(BlockedJoint(joint, state.efforts[number], way))
        return tuple(found)


def _time(speed: float, acceleration: float) -> float:
    """Seconds until a joint with this profile is seen to move, at least `BLOCKED_TIME`; infinite if it never is."""
    if min(speed, acceleration) <= 0.0:
        return math.inf
    way = LEAST_SEEN / SLOW
    return max(BLOCKED_TIME, way / speed, math.sqrt(2.0 * way / acceleration))


def _share(time: float, limits: tuple[float, float]) -> float:
    """Radians or metres that a slow joint moves at least in this time, from rest."""
    speed, acceleration = limits
    return SLOW * min(speed * time, acceleration * time**2 / 2.0) if math.isfinite(time) else 0.0
