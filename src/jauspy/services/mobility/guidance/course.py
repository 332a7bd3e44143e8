"""The kinds of course that the pilot can follow; each says, again and again, how to move on."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Protocol

from jauspy.geometry.poses import Pose
from jauspy.services.mobility.guidance.heading import head_for, turn_of
from jauspy.services.mobility.guidance.motion import STANDSTILL, Limits, Motion

LOOKS_THERE: Final = 0.03
"""Radians from a heading at which a robot that shall stand there stops turning."""


class Course(Protocol):
    """Where to go."""

    @property
    def limits(self) -> Limits | None:
        """How fast the motion may change; None: as the chassis likes it."""
        ...

    def steer(self, pose: Pose, /) -> Motion | None:
        """The motion wanted at a pose (JAUS axes, world); None when there is nothing more to do."""
        ...


@dataclass(frozen=True, slots=True)
class VelocityCourse:
    """A motion that is given as such."""

    motion: Motion
    limits: Limits

    def steer(self, _: Pose) -> Motion:
        """Always the same."""
        return self.motion


@dataclass(frozen=True, slots=True)
class VectorCourse:
    """A heading in the world, which may change with its frame, at a speed (m/s, negative backward)."""

    heading: Callable[[], float]
    speed: float
    max_turn_rate: float
    limits: None = None

    def steer(self, pose: Pose) -> Motion:
        """Towards the heading, without an end."""
        error = turn_of(pose.yaw, self.heading())
        if self.speed == 0.0 and abs(error) < LOOKS_THERE:
            return STANDSTILL
        return head_for(error, self.speed, self.max_turn_rate)


@dataclass(frozen=True, slots=True)
class Halt:
    """Slows down and waits."""

    limits: None = None

    def steer(self, _: Pose) -> Motion:
        """Stand still."""
        return STANDSTILL


def reversed_yaw(yaw: float) -> float:
    """The direction in which a robot drives that drives backward."""
    return math.remainder(yaw + math.pi, math.tau)
