"""The interface of planners of arm motions: a request, and the plan or the reason why there is none."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Protocol, TypeAlias

from jauspy.errors import RequestError
from jauspy.geometry.poses import Transform
from jauspy.planning.obstacles import Array, Obstacles, Primitive


@dataclass(frozen=True, slots=True)
class JointGoal:
    """Positions of all joints of the arm, in radians or metres."""

    positions: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class PoseGoal:
    """A pose of the tool in the robot's base frame. Without `attitude` only its point counts."""

    pose: Transform
    attitude: bool = True


@dataclass(frozen=True, slots=True)
class RegionGoal:
    """Any pose with the tool point within a box (metres, axes of `pose`) and an attitude within an angle (radians)."""

    pose: Transform
    size: tuple[float, float, float]
    angle: float


Goal: TypeAlias = JointGoal | PoseGoal | RegionGoal


def _never() -> bool:
    return False


@dataclass(frozen=True, slots=True)
class PlanRequest:
    """A motion that is asked for. Obstacles and goals are in the frame of the robot's base."""

    start: tuple[float, ...]
    """Positions of the joints now, in radians or metres."""
    goal: Goal
    obstacles: Obstacles
    payload: Primitive | None = None
    """A held thing, in the frame of the tool."""
    time_limit: float = 1.0
    """Seconds of search after which there is no way."""
    seed: int = 0
    is_cancelled: Callable[[], bool] = _never
    """Asked during the search, from the thread that plans: True if nobody waits for the plan any more."""


class Reason(Enum):
    """Reasons why there is no plan, or why a motion ended early; the values are those that MotionPlanner reports."""

    OUT_OF_REACH = 1
    GOAL_COLLIDES = 2
    START_COLLIDES = 3
    OUTSIDE_LIMITS = 4
    NO_WAY = 5
    WRONG_REQUEST = 6
    """Numbers that are none, or a joint or a frame that the robot does not have."""
    NO_SUCH_PLAN = 7
    DEVIATED = 8
    """The arm left the planned way."""
    NEW_OBSTACLE = 9
    """Something is near what is left of the way."""
    ARM_REFUSED = 10
    """The arm is not ready, is controlled by another client, or does not answer."""
    ARM_STOPPED = 11
    """The arm ended the motion before its end: it is blocked, or a guard stopped it."""
    CANCELLED = 12
    NO_SIGHT = 13
    """It is not known what is around the arm."""
    PLANNER_FAILED = 14


class NoPlan(RequestError):
    """There is no plan; the message names the reason in words, with the obstacle or the joint."""

    def __init__(self, reason: Reason, text: str) -> None:
        super().__init__(text)
        self.reason = reason


@dataclass(frozen=True, slots=True)
class Plan:
    """A timed motion of all joints, linear between its points: no joint exceeds its speed or acceleration."""

    times: Array
    """Seconds from the start of the motion, shape (n,); the first is 0."""
    positions: Array
    """Radians or metres, shape (n, joints)."""
    clearance: float
    """Smallest distance in metres to obstacles and to the robot itself on the way, as the exact check measures it."""
    planning_time: float
    """Seconds that the plan took."""

    @property
    def duration(self) -> float:
        """Seconds."""
        return float(self.times[-1])


class MotionPlanner(Protocol):
    """Plans motions of one arm."""

    def plan(self, request: PlanRequest) -> Plan:
        """Find a motion; `NoPlan` with a reason if there is none."""
        ...
