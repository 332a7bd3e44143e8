"""A planner that knows straight ways in the space of the joints only, and checks them against the robot itself."""

from __future__ import annotations

import math

import numpy as np

from jauspy.geometry.frames import FrameTree
from jauspy.geometry.joint_routes import positions_between
from jauspy.planning.motion import JointGoal, NoPlan, Plan, PlanRequest, Reason
from jauspy.platform.description import RobotModel
from jauspy.platform.link_clearances import clearances_of

SPEED = 0.4
"""rad/s and m/s of the joint with the longest way."""
BELOW = 0.2
"""Metres up to which clearances are measured."""


class StraightPlanner:
    """Plans for a group of a robot; goals are positions of joints, or the posture of the tool that `poses` names."""

    def __init__(self, model: RobotModel, group: str) -> None:
        self._joints = model.groups[group].joints
        self._clearances = clearances_of(model, self._joints)
        self._tree = FrameTree(model.description)
        self._tip = model.groups[group].tip
        self.requests: list[PlanRequest] = []

    def plan(self, request: PlanRequest) -> Plan:
        """The straight way; `NoPlan` if the robot would touch itself."""
        self.requests.append(request)
        if not isinstance(request.goal, JointGoal):
            raise NoPlan(Reason.NO_WAY, "this planner knows joints only")
        start, goal = request.start, request.goal.positions
        least = math.inf
        for positions in positions_between(start, goal, 0.05):
            near = self._clearances.at(dict(zip(self._joints, positions, strict=True)), BELOW)
            least = min(least, *near.values(), BELOW)
        if least <= 0.0:
            raise NoPlan(Reason.GOAL_COLLIDES, "the arm would touch the robot")
        way = max(abs(a - b) for a, b in zip(start, goal, strict=True))
        times = np.array([0.0, max(way / SPEED, 0.01)])
        return Plan(times, np.array([start, goal]), least, 0.001)
