"""Planner of arm motions: straight where that is free, else by RRT-connect of OMPL, then shortened, timed and checked.

Kuffner and LaValle, "RRT-Connect: An efficient approach to single-query path planning", ICRA 2000.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Any, Final

import numpy as np
from ompl import base, geometric, util

from jauspy.planning.arm_goals import PostureSearch, Reached
from jauspy.planning.arm_model import ArmModel
from jauspy.planning.contacts import Contacts
from jauspy.planning.motion import JointGoal, NoPlan, Plan, PlanRequest, PoseGoal, Reason, RegionGoal
from jauspy.planning.obstacles import Array, Obstacles, Primitive
from jauspy.planning.timing import timed
from jauspy.platform.description import RobotModel

MARGIN: Final = 0.01
"""Metres that are kept from obstacles and between links."""
WATCHED: Final = 0.5
"""Part of the margin that is kept while a motion is carried out."""
RANGE: Final = 1.0
"""Radians of one extension of a tree."""
GOALS: Final = 8
"""Postures at the goal to which straight motions are tried at most."""
ROOMS: Final[Sequence[tuple[float, int | None, int]]] = ((2.0, 100, GOALS), (math.tau, None, 40))
"""Radians around start and goals in which a search samples, the motions that it checks at most, and the postures at the
goal to which it goes at most."""
SEARCHED: Final = 0.9
"""Part of the time limit after which the search is given up; the rest is for what comes before and after it."""
SHORTCUTS: Final = 40
"""Shortcuts that are tried."""
GAIN: Final = 0.02
"""Part of the path that a shortcut must save, to be checked at all."""
IN_VAIN: Final = 12
"""Shortcuts in a row that are not free, after which no more are tried."""
LIMIT_TOLERANCE: Final = 1e-6
"""Radians or metres by which given positions may be outside of the joints' limits."""

util.noOutputHandler()


class ArmPlanner:
    """Plans motions of one arm; the same seed gives the same plan, unless time runs out."""

    def __init__(
        self, model: RobotModel, group: str, *, margin: float = MARGIN, others: Mapping[str, float] | None = None
    ) -> None:
        """Prepare the planner of a group of joints.

        `margin`: metres to keep from obstacles and between links, less where the arm is nearer at the start.
        `others`: positions (rad, m) of joints of other groups; without, where the robot starts. Raises `ConfigError`.
        """
        self.arm = ArmModel(model, group, others)
        self.margin = margin

    def plan(self, request: PlanRequest) -> Plan:
        """Find a motion; `NoPlan` with a reason if there is none."""
        return _Planning(self.arm, request, self.margin).run()

    def obstruction(self, positions: Array, obstacles: Obstacles, payload: Primitive | None = None) -> str:
        """What is in the way of straight motions between positions, shape (n, joints), in words; empty if nothing.

        Half of the margin counts, so that noise of sensors does not stop a motion that was planned with all of it.
        """
        contacts = Contacts(self.arm, obstacles, WATCHED * self.margin, payload)
        here = contacts.allow(positions[0])
        if here.metres <= 0.0:
            return f"{_named(here.between)} touch"
        for one, other in pairwise(positions):
            if not contacts.is_motion_free(one, other):
                return f"{_named(contacts.clearance([one, other]).between)} would come too near to each other"
        return ""


class _Planning:
    """The work on one request."""

    def __init__(self, arm: ArmModel, request: PlanRequest, margin: float) -> None:
        self._begin = time.perf_counter()
        self._deadline = self._begin + SEARCHED * request.time_limit
        self._arm, self._request = arm, request
        self._rng = np.random.default_rng(request.seed)
        self._start = _within_limits(arm, request.start, "the start")
        self._contacts = Contacts(arm, request.obstacles, margin, request.payload)

    def run(self) -> Plan:
        """The plan."""
        contacts = self._contacts
        here = contacts.allow(self._start)
        if here.metres <= 0.0:
            raise NoPlan(Reason.START_COLLIDES, f"the arm is in contact: {_named(here.between)} touch")
        goals = self._goals()
        points = self._path(goals)
        times, positions = timed(self._arm, points)
        found = contacts.clearance(points)
        return Plan(times, positions, found.metres, time.perf_counter() - self._begin)

    # --- goals ----------------------------------------------------------------------------------------------------

    def _goals(self) -> Array:
        """Free postures at the goal, the nearest first; `NoPlan` without one."""
        goal = self._request.goal
        if isinstance(goal, JointGoal):
            postures = _within_limits(self._arm, goal.positions, "the goal")[None]
            free = self._free(postures)
            if not len(free):
                self._refuse(postures[0])
            return free
        search = PostureSearch(self._arm, goal, self._start, self._request.seed)
        seen: Array | None = None
        for starts in (48, 96, 192):
            reached = search.run(starts)
            if len(reached.postures):
                seen = reached.postures if seen is None else seen
                free = self._free(reached.postures)
                if len(free):
                    return free
            if time.perf_counter() > self._begin + 0.5 * self._request.time_limit:
                break
        if seen is None:
            raise NoPlan(Reason.OUT_OF_REACH, self._unreached(goal, reached))
        self._refuse(seen[0])
        raise AssertionError

    def _unreached(self, goal: PoseGoal | RegionGoal, reached: Reached) -> str:
        """The sentence for a goal that no posture reaches: whether it is the point or the attitude."""
        size = goal.size if isinstance(goal, RegionGoal) else (0.0, 0.0, 0.0)
        anyhow = PostureSearch(self._arm, RegionGoal(goal.pose, size, math.tau), self._start, self._request.seed).run()
        if not len(anyhow.postures):
            nearest = min(anyhow.distance, reached.distance)
            return f"the goal is out of reach: the tool comes no nearer than {1000.0 * nearest:.0f} mm"
        angle = PostureSearch(self._arm, goal, self._start, self._request.seed).angle(anyhow.postures)
        return (
            "the point is in reach, but not with this attitude: "
            f"of {len(anyhow.postures)} postures there the nearest is {math.degrees(angle):.0f} degrees off"
        )

    def _refuse(self, posture: Array) -> None:
        found = self._contacts.distance(posture)
        raise NoPlan(
            Reason.GOAL_COLLIDES,
            f"at the goal {_named(found.between)} would "
            + (f"be {1000.0 * found.metres:.0f} mm apart" if found.metres > 0.0 else "touch"),
        )

    # --- paths ----------------------------------------------------------------------------------------------------

    def _path(self, goals: Array) -> list[Array]:
        for goal in goals[:GOALS]:
            if self._contacts.is_motion_free(self._start, goal):
                return [self._start, goal]
        for finely in (False, True):
            points = self._shortened(self._search(goals, finely), finely)
            if finely or all(self._contacts.is_motion_free(*pair) for pair in pairwise(points)):
                break
        return points

    def _search(self, goals: Array, finely: bool) -> list[Array]:
        points = None
        for room, motions, most in ROOMS:
            ends = goals[:most]
            low, high = np.minimum(self._start, ends.min(axis=0)), np.maximum(self._start, ends.max(axis=0))
            bounds = np.maximum(self._arm.lower, low - room), np.minimum(self._arm.upper, high + room)
            seconds, seed = max(self._deadline - time.perf_counter(), 0.01), self._request.seed
            points = connect(
                self._contacts,
                self._start,
                ends,
                bounds,
                seconds=seconds,
                seed=seed,
                motions=motions,
                finely=finely,
                is_cancelled=self._request.is_cancelled,
            )
            if points is not None:
                break
            if self._request.is_cancelled():
                raise NoPlan(Reason.CANCELLED, "the search was cancelled")
        if points is None:
            raise NoPlan(
                Reason.NO_WAY,
                f"no way to the goal was found within {self._request.time_limit:g} s of search; "
                f"{len(goals)} of its postures are free",
            )
        return points

    def _shortened(self, points: list[Array], finely: bool) -> list[Array]:
        """A path with fewer and shorter pieces."""
        failures = 0
        for _ in range(SHORTCUTS):
            if len(points) <= 2 or failures == IN_VAIN:
                break
            lengths = [self._length(a, b) for a, b in pairwise(points)]
            marks = np.concatenate([[0.0], np.cumsum(lengths)])
            one, other = sorted(self._rng.uniform(0.0, marks[-1], 2).tolist())
            first, last = (int(np.searchsorted(marks, mark, side="right")) - 1 for mark in (one, other))
            failures += 1
            if first == last:
                continue
            a = points[first] + (points[first + 1] - points[first]) * ((one - marks[first]) / lengths[first])
            b = points[last] + (points[last + 1] - points[last]) * ((other - marks[last]) / lengths[last])
            if other - one - self._length(a, b) < GAIN * marks[-1]:
                continue
            if self._contacts.is_motion_free(a, b, finely=finely):
                points = [*points[: first + 1], a, b, *points[last + 1 :]]
                failures = 0
        index = 0
        while index + 2 < len(points):
            if self._contacts.is_motion_free(points[index], points[index + 2], finely=finely):
                del points[index + 1]
            else:
                index += 1
        return points

    def _length(self, one: Array, other: Array) -> float:
        return float(np.linalg.norm((other - one) * self._arm.scales))

    def _free(self, postures: Array) -> Array:
        """Those that keep the margin."""
        return postures[[self._contacts.is_free(posture) for posture in postures]]


def connect(
    contacts: Contacts,
    start: Array,
    goals: Array,
    bounds: tuple[Array, Array],
    *,
    seconds: float,
    seed: int,
    motions: int | None = None,
    finely: bool = True,
    is_cancelled: Callable[[], bool] = lambda: False,
) -> list[Array] | None:
    """A path of straight motions to one of the goals by a planner of OMPL; None if time or motions were not enough."""
    count = len(start)
    scales = contacts.arm.scales
    space = base.RealVectorStateSpace(count)
    limits = base.RealVectorBounds(count)
    for column in range(count):
        limits.setLow(column, float(bounds[0][column] * scales[column]))
        limits.setHigh(column, float(bounds[1][column] * scales[column]))
    space.setBounds(limits)
    util.RNG.setSeed(seed + 1)
    information = base.SpaceInformation(space)
    check = _MotionCheck(information, contacts, finely)
    information.setMotionValidator(check)
    information.setStateValidityChecker(_NoCheck(information))
    information.setup()
    problem = base.ProblemDefinition(information)
    problem.addStartState(_state(space, start * scales))
    goal = base.GoalStates(information)
    for posture in goals:
        goal.addState(_state(space, posture * scales))
    problem.setGoal(goal)
    planner = geometric.RRTConnect(information)
    planner.setRange(RANGE)
    planner.setProblemDefinition(problem)
    planner.setup()
    end = time.perf_counter() + seconds
    most = math.inf if motions is None else motions
    ended = base.PlannerTerminationCondition(
        lambda: check.motions >= most or time.perf_counter() > end or is_cancelled()
    )
    if planner.solve(ended).getStatus() != base.PlannerStatus.EXACT_SOLUTION:
        return None
    path = problem.getSolutionPath()
    return [_values(path.getState(number), count) / scales for number in range(path.getStateCount())]


class _NoCheck(base.StateValidityChecker):  # type: ignore[misc]
    """States alone are not checked: each is the end of a motion that is."""

    def isValid(self, state: Any) -> bool:  # noqa: N802, ARG002 - OMPL's name
        return True


class _MotionCheck(base.MotionValidator):  # type: ignore[misc]
    """Checks straight motions in joint space."""

    def __init__(self, information: Any, contacts: Contacts, finely: bool) -> None:
        super().__init__(information)
        self.motions = 0
        """Motions that were checked."""
        self._finely = finely
        self._contacts, self._scales = contacts, contacts.arm.scales

    def checkMotion(self, one: Any, other: Any) -> bool:  # noqa: N802 - OMPL's name
        self.motions += 1
        count = len(self._scales)
        a, b = _values(one, count) / self._scales, _values(other, count) / self._scales
        return self._contacts.is_motion_free(a, b, finely=self._finely)


def _state(space: Any, values: Array) -> Any:
    state = space.allocState()
    for column, value in enumerate(values.tolist()):
        state[column] = value
    return state


def _values(state: Any, count: int) -> Array:
    found: Array = np.array([state[column] for column in range(count)])
    return found


def _within_limits(arm: ArmModel, positions: Sequence[float], what: str) -> Array:
    """The positions, within the limits to the last bit. `NoPlan` if there are too few, or one is outside."""
    q = np.array(positions, float)
    if len(q) != len(arm.joints):
        raise NoPlan(Reason.OUTSIDE_LIMITS, f"{what} has {len(q)} positions; the arm has {len(arm.joints)} joints")
    for name, value, low, high in zip(arm.joints, q.tolist(), arm.lower.tolist(), arm.upper.tolist(), strict=True):
        if not low - LIMIT_TOLERANCE <= value <= high + LIMIT_TOLERANCE:
            raise NoPlan(
                Reason.OUTSIDE_LIMITS, f"{what} has {name} at {value:.3f}; its limits are {low:.3f} and {high:.3f}"
            )
    within: Array = np.clip(q, arm.lower, arm.upper)
    return within


def _named(between: tuple[str, str]) -> str:
    return f"{between[0]} and {between[1]}"
