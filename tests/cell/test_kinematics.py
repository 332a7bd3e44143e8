"""Inverse kinematics of the UR10."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jauspy.cell.frames import offset_between, shifted, turned
from jauspy.cell.kinematics import MIN_CONDITION, ArmKinematics
from jauspy.cell.scene import Layout
from jauspy.errors import ConfigError

DOWN = turned("x", math.pi)


def test_every_posture_is_found_again(layout: Layout) -> None:
    k, random = layout.kinematics, np.random.default_rng(3)
    tried = 0
    while tried < 40:
        q = random.uniform(-3.0, 3.0, 6)
        if k.condition(q) < MIN_CONDITION:
            continue
        tried += 1
        solutions = k.solve(k.forward(q), q)
        assert np.max(np.abs(solutions[0].positions - q)) < 1e-4, "the closest one is that posture"
        assert all(max(offset_between(k.forward(each.positions), k.forward(q))) < 1e-5 for each in solutions)


def test_solutions_are_ordered_by_the_time_to_get_there(layout: Layout) -> None:
    k = layout.kinematics
    found = k.solve(shifted(0.5, 0.5, 0.4) * DOWN, layout.home)
    times = [k.distance(each.positions, layout.home) for each in found]
    assert len(found) >= 4
    assert times == sorted(times)


def test_poses_out_of_reach_have_no_solution(layout: Layout) -> None:
    assert layout.kinematics.solve(shifted(3.0) * DOWN, layout.home) == []


def test_singular_postures_are_left_out(layout: Layout) -> None:
    k = layout.kinematics
    q = np.array([0.3, -1.2, 1.4, -1.5, 0.0, 0.2])  # wrist_2 at zero: the axes of wrist_1 and wrist_3 are parallel
    assert k.condition(q) < 1e-6
    assert all(each.condition >= MIN_CONDITION for each in k.solve(k.forward(q), q))


def test_joints_turn_to_the_nearest_equal_angle(layout: Layout) -> None:
    k = layout.kinematics
    q = np.array([0.3, -1.2, 1.4, -1.5, 1.0, 0.2])
    near = q + np.array([math.tau, 0.0, 0.0, 0.0, 0.0, -math.tau])
    near[0] = 6.0
    found = k.unwound(q, near)
    assert found is not None
    assert found[5] == pytest.approx(0.2 - math.tau)
    assert np.all(found <= k.upper)


def test_unknown_names_are_named(layout: Layout) -> None:
    with pytest.raises(ConfigError, match="no joint 'knee'"):
        ArmKinematics(layout.urdf, ["knee"], "gripper")
    with pytest.raises(ConfigError, match="no link 'hand'"):
        ArmKinematics(layout.urdf, layout.group.joints, "hand")
