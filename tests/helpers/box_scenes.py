"""Seeded scenes of boxes around an arm, with a free start and a goal that is free."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from jauspy.geometry.poses import Pose, Transform
from jauspy.planning.arm_model import ArmModel
from jauspy.planning.contacts import Contacts
from jauspy.planning.motion import Goal, JointGoal, PoseGoal
from jauspy.planning.obstacles import Box, Obstacles

MARGIN = 0.01


@dataclass(frozen=True)
class Scene:
    obstacles: Obstacles
    start: tuple[float, ...]
    goal: Goal
    end: tuple[float, ...]
    """A posture at the goal."""


def scene(arm: ArmModel, seed: int) -> Scene:
    """5 to 30 boxes of 5 to 30 cm; goals are postures, and poses of the tool, in turn."""
    rng = np.random.default_rng(seed)
    lower, upper = np.maximum(arm.lower, -math.pi), np.minimum(arm.upper, math.pi)
    reach = arm.tool(arm.frames(rng.uniform(lower, upper, (200, len(arm.joints)))))[:, :3, 3]
    low, high = np.quantile(reach, 0.02, axis=0), np.quantile(reach, 0.98, axis=0)
    while True:
        boxes = []
        for number in range(int(rng.integers(5, 31))):
            x, y, z = rng.uniform(low, high).tolist()
            a, b, c = rng.uniform(0.05, 0.3, 3).tolist()
            pose = Pose(x, y, z, 0.0, 0.0, float(rng.uniform(-math.pi, math.pi)))
            boxes.append(Box(Transform.from_pose(pose), (a, b, c), f"box {number}"))
        obstacles = Obstacles(boxes)
        contacts = Contacts(arm, obstacles, MARGIN)
        free = [q for q in rng.uniform(lower, upper, (60, len(arm.joints))) if contacts.is_free(q)]
        if len(free) >= 2:
            break
    start, end = free[0], free[1]
    goal: Goal = JointGoal(tuple(end.tolist()))
    if seed % 2:
        tool = arm.tool(arm.frames(end[None]))[0]
        rows = tuple(tuple(row) for row in tool[:3, :3].tolist())
        goal = PoseGoal(Transform(rows, tuple(tool[:3, 3].tolist())))
    return Scene(obstacles, tuple(start.tolist()), goal, tuple(end.tolist()))
