"""Straight motions of a grasp as postures, each from the one before."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from jauspy.geometry.poses import Transform
from jauspy.planning.arm_goals import PostureSearch
from jauspy.planning.arm_model import ArmModel
from jauspy.planning.grasp_candidates import Candidate
from jauspy.planning.motion import PoseGoal
from jauspy.planning.obstacles import Array

BACK: Final = 0.10
"""Metres of the straight approach."""
LIFT: Final = 0.10
"""Metres by which the thing is lifted."""
LEAST_LIFT: Final = 0.04
ABOVE: Final = 0.08
"""Metres above the place from which it is lowered."""
STEP: Final = 0.01
"""Metres between the postures of a straight motion."""
LARGEST_STEP: Final = 0.25
"""Radians or metres of a joint in such a step; more is another branch of the postures."""


@dataclass(frozen=True, slots=True)
class Ways:
    """A grasp with the postures of its straight motions."""

    candidate: Candidate
    approach: Array
    """From before the thing to the grasp, shape (n, joints)."""
    lift: Array
    """From the grasp upward, or back."""


def find_ways(arm: ArmModel, candidate: Candidate, present: Sequence[float]) -> Ways | None:
    """The straight motions of a grasp; None if the arm cannot make them."""
    reached = PostureSearch(arm, PoseGoal(candidate.pose), np.array(present), 0).run()
    for posture in reached.postures[:3]:
        approach = _line(arm, posture, lambda way: candidate.moved(back=way), BACK)
        if len(approach) <= round(BACK / STEP):
            continue
        lift = _line(arm, posture, lambda way: candidate.moved(up=way), LIFT)
        if len(lift) > LEAST_LIFT / STEP:
            return Ways(candidate, approach[::-1], lift)
    return None


def find_lowerings(arm: ArmModel, candidate: Candidate, present: Sequence[float]) -> Iterator[Ways]:
    """Ways down to where a thing is let go, with the ways back from it in place of the lift."""
    reached = PostureSearch(arm, PoseGoal(candidate.pose), np.array(present), 0).run()
    for posture in reached.postures[:3]:
        lower = _line(arm, posture, lambda way: candidate.moved(up=way), ABOVE)
        back = _line(arm, posture, lambda way: candidate.moved(back=way), BACK)
        if len(lower) > round(ABOVE / STEP) and len(back) > LEAST_LIFT / STEP:
            yield Ways(candidate, lower[::-1], back)


def _line(arm: ArmModel, posture: Array, pose: Callable[[float], Transform], length: float) -> Array:
    """Postures of a straight motion of the tool, as far as it is possible, shape (n, joints)."""
    rows = [posture]
    for number in range(1, round(length / STEP) + 1):
        reached = PostureSearch(arm, PoseGoal(pose(number * STEP)), rows[-1], 0).run(1).postures
        if not len(reached) or np.abs(reached[0] - rows[-1]).max() > LARGEST_STEP:
            break
        rows.append(reached[0])
    return np.array(rows)
