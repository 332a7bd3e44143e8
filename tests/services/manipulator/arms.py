"""Arms on the kinematic backend, and poses that they can reach."""

from __future__ import annotations

import random
from dataclasses import replace

from tests.helpers.robot import described

from jauspy.backends.kinematic import KinematicJoints
from jauspy.geometry.kinematics import InverseKinematics, Solution, forward_kinematics
from jauspy.geometry.poses import Transform
from jauspy.services.manipulator.arm import Arm

ROBOTS = ("inc1", "inc1_pprm")


def arm_of(robot: str, start: tuple[float, ...] | None = None, group: str = "arm") -> Arm:
    """Its arm; `start` as its URDF counts."""
    _, model = described(robot)
    setup = model.groups[group]
    return Arm(KinematicJoints(model.description, replace(setup, start=start or setup.start)))


def random_positions(arm: Arm, rng: random.Random) -> list[float]:
    return [rng.uniform(low, high) for low, high in arm.limits]


def tool_at(arm: Arm, positions: list[float]) -> Transform:
    return forward_kinematics(arm.geometry.links, positions, arm.tool).tool


def search_for(arm: Arm, goal: Transform) -> InverseKinematics:
    return InverseKinematics(arm.geometry.links, arm.tool, goal, arm.state().positions, arm.limits)


def whole(search: InverseKinematics) -> Solution:
    while (found := search.advance(100)) is None:
        pass
    return found


def found_by(arm: Arm, goal: Transform) -> Solution:
    return whole(search_for(arm, goal))
