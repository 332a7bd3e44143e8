"""Work on one scene of boxes for `planning.py`: a plan, what MuJoCo says of it, a long search, OMPL's defaults."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray
from ompl import base, geometric
from tests.helpers.box_scenes import MARGIN, Scene, scene
from tests.helpers.mujoco_contacts import MujocoContacts
from tests.helpers.seven_joints import seven_joints

from jauspy.planning.arm_goals import PostureSearch
from jauspy.planning.arm_planner import ArmPlanner, connect
from jauspy.planning.contacts import Contacts
from jauspy.planning.motion import JointGoal, NoPlan, Plan, PlanRequest
from jauspy.platform.description import RobotModel
from jauspy.robot.robot_files import load, robot_model

ARMS = {"inc1": "arm", "cell": "ur10", "seven": "arm"}
"""Groups of joints by robot."""
LINE_STEP = 0.02
"""Radians or metres between the postures of straight motions that MuJoCo looks at."""
MEASURED = 0.05
"""Metres up to which MuJoCo measures clearance."""


@dataclass(frozen=True)
class Work:
    """What to do with one scene; times in seconds."""

    arm: str
    seed: int
    limit: float
    long_search: float
    is_compared: bool


def run(work: Work) -> dict[str, Any]:
    """The results for one scene, as a row of the output."""
    model, planner = _arm(work.arm)
    made = scene(planner.arm, work.seed)
    checker = MujocoContacts(model, ARMS[work.arm], made.obstacles)
    row: dict[str, Any] = {"arm": work.arm, "seed": work.seed, "boxes": len(made.obstacles.primitives)}
    request = PlanRequest(made.start, made.goal, made.obstacles, seed=work.seed, time_limit=work.limit)
    line = np.linspace(made.start, made.end, 2 + int(np.abs(np.subtract(made.end, made.start)).max() / LINE_STEP))
    row["straight_touches"] = any(checker.at(posture) for posture in line)
    wall, begin = time.perf_counter(), time.process_time()
    plan, reason = None, None
    try:
        plan = planner.plan(request)
    except NoPlan as error:
        reason = error.reason.name
    row |= {"reason": reason, "seconds": time.process_time() - begin, "wall": time.perf_counter() - wall}
    if plan is not None:
        row |= _judged(planner, plan, checker)
    if plan is None or work.is_compared:
        row["best"] = _long_search(planner, made, work.seed, work.long_search, until_first=plan is None)
    if work.is_compared:
        row["default"] = _by_default(planner, made, work.long_search)
    return row


@lru_cache(maxsize=1)
def _arm(name: str) -> tuple[RobotModel, ArmPlanner]:
    model = seven_joints() if name == "seven" else robot_model(load(name))
    return model, ArmPlanner(model, ARMS[name], margin=MARGIN)


def _judged(planner: ArmPlanner, plan: Plan, checker: MujocoContacts) -> dict[str, Any]:
    """Length of a plan, and its contacts and clearance by MuJoCo at its points and between them."""
    postures = [plan.positions[0]]
    for one, other in pairwise(plan.positions):
        postures += [(one + other) / 2.0, other]
    return {
        "length": length(planner, plan.positions),
        "duration": plan.duration,
        "clearance": plan.clearance,
        "contacts": sum(bool(checker.at(posture)) for posture in postures),
        "clearance_by_mujoco": min(checker.clearance(posture, MEASURED) for posture in postures),
    }


def _long_search(planner: ArmPlanner, made: Scene, seed: int, seconds: float, *, until_first: bool) -> float | None:
    """Length of the shortest way of OMPL for half of the time, then of plans with other seeds; None without one."""
    arm, end = planner.arm, time.perf_counter() + seconds
    contacts = Contacts(arm, made.obstacles, MARGIN)
    start, goals = np.array(made.start), [np.array(made.end)]
    if not isinstance(made.goal, JointGoal):
        found = PostureSearch(arm, made.goal, start, seed).run(192).postures
        goals += [posture for posture in found if contacts.is_free(posture)]
    bounds = np.maximum(arm.lower, -math.tau), np.minimum(arm.upper, math.tau)
    points = connect(contacts, start, np.array(goals), bounds, seconds=seconds / 2.0, seed=seed)
    best, number = math.inf if points is None else length(planner, np.array(points)), 1000
    while (left := end - time.perf_counter()) > 0.0 and not (until_first and best < math.inf):
        try:
            plan = planner.plan(PlanRequest(made.start, made.goal, made.obstacles, seed=number, time_limit=left))
            best = min(best, length(planner, plan.positions))
        except NoPlan:
            pass
        number += 1
    return None if math.isinf(best) else best


def _by_default(planner: ArmPlanner, made: Scene, seconds: float) -> dict[str, Any] | None:
    """OMPL's SimpleSetup: its choice of planner, resolution and simplification, with the same check of postures."""
    arm = planner.arm
    contacts, count = Contacts(arm, made.obstacles, MARGIN), len(arm.joints)
    space = base.RealVectorStateSpace(count)
    limits = base.RealVectorBounds(count)
    for column, (low, high) in enumerate(zip(arm.lower.tolist(), arm.upper.tolist(), strict=True)):
        limits.setLow(column, low)
        limits.setHigh(column, high)
    space.setBounds(limits)
    setup = geometric.SimpleSetup(space)
    setup.setStateValidityChecker(lambda state: contacts.is_free(np.array([state[n] for n in range(count)])))
    states = [space.allocState(), space.allocState()]
    for state, posture in zip(states, (made.start, made.end), strict=True):
        for column, value in enumerate(posture):
            state[column] = value
    setup.setStartAndGoalStates(*states)
    begin = time.process_time()
    if not setup.solve(seconds) or not setup.haveExactSolutionPath():
        return None
    setup.simplifySolution()
    path = setup.getSolutionPath()
    points = np.array([[path.getState(n)[c] for c in range(count)] for n in range(path.getStateCount())])
    return {"seconds": time.process_time() - begin, "length": length(planner, points)}


def length(planner: ArmPlanner, points: NDArray[np.float64]) -> float:
    """Length in the joints, in radians."""
    return float(np.linalg.norm(np.diff(points, axis=0) * planner.arm.scales, axis=1).sum())
