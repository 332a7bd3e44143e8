"""When a joint that is to reach a position counts as blocked."""

from __future__ import annotations

import math
import random

import pytest

from jauspy.platform.joints import JointState
from jauspy.robot.robot_files import load, robot_model
from jauspy.services.manipulator.blocked_joints import BLOCKED_TIME, LEAST_SHORT, StandstillWatch

JOINT = next(joint for joint in robot_model(load("inc1")).description.joints.values() if joint.turns and joint.velocity)
PERIOD = 0.05


def blocked_at(limits: tuple[float, float], way: float, position, seconds: float = 10.0) -> float | None:
    """Seconds after which the joint counts as blocked, of a motion of `way`; None if it never does."""
    watch = StandstillWatch([JOINT], [limits])
    for step in range(math.ceil(seconds / PERIOD)):
        now = step * PERIOD
        present = position(now)
        if watch.blocked(now, JointState((present,), (0.0,), (1.0,)), [way - present]):
            return now
    return None


@pytest.mark.parametrize("acceleration", [2.0, 0.1, 0.01, 0.004, 0.001])
def test_a_joint_that_follows_its_profile_is_not_blocked(acceleration: float) -> None:
    """It begins late, by friction, and trembles: one that has to turn by 0.02 rad while others turn by 2."""
    noise = random.Random(1)

    def position(now: float) -> float:
        return min(way, 0.5 * acceleration * max(0.0, now - 0.45) ** 2) + noise.uniform(-5e-5, 5e-5)

    way = 0.02
    assert blocked_at((1.0, acceleration), way, position) is None


@pytest.mark.parametrize(("limits", "after"), [((1.0, 2.0), BLOCKED_TIME), ((1.0, 0.004), 1.42), ((0.002, 1.0), 2.0)])
def test_a_joint_that_stands_is_blocked_as_soon_as_it_should_be_seen_to_move(limits, after: float) -> None:
    found = blocked_at(limits, 0.5, lambda now: 0.0)
    assert found is not None
    assert after <= found <= after + 2.0 * PERIOD


def test_a_joint_at_its_position_or_with_no_motion_to_make_is_never_blocked() -> None:
    assert blocked_at((1.0, 1.0), 0.9 * LEAST_SHORT, lambda now: 0.0) is None
    assert blocked_at((0.0, 0.0), 0.5, lambda now: 0.0) is None
