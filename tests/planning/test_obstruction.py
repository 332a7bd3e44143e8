"""What is in the way of a motion that goes on."""

from __future__ import annotations

import pytest

pytest.importorskip("ompl", reason="OMPL is not installed")
pytest.importorskip("coal", reason="coal is not installed")

import numpy as np

from jauspy.geometry.poses import Transform
from jauspy.planning.arm_planner import ArmPlanner
from jauspy.planning.obstacles import Box, Obstacles
from jauspy.robot import robot_files

PLANNER = ArmPlanner(robot_files.robot_model(robot_files.load("inc1")), "arm")
WAY = np.array([(turn, 0.3, -0.5, 0.2, 0.0) for turn in (-0.7, 0.7)])


def test_nothing_is_in_the_way_of_a_free_motion() -> None:
    assert PLANNER.obstruction(WAY, Obstacles()) == ""
    aside = Obstacles((Box(Transform(position=(-2.0, 0.0, 0.3)), (0.1, 0.1, 0.6), "post"),))
    assert PLANNER.obstruction(WAY, aside) == ""


def test_what_is_in_the_way_is_named() -> None:
    post = Obstacles((Box(Transform(position=(0.8, 0.0, 0.3)), (0.1, 0.1, 0.6), "post"),))
    assert "post" in PLANNER.obstruction(WAY, post)
    assert PLANNER.obstruction(np.array([WAY[1], (0.9, *WAY[1][1:])]), post) == ""  # it is behind the arm
    voxels = Obstacles(voxels=np.array([(0.8, 0.0, 0.36)]), voxel_size=0.04)
    assert PLANNER.obstruction(WAY, voxels)


def test_what_an_arm_touches_already_is_named() -> None:
    arm = Obstacles((Box(Transform(position=(0.3, 0.0, 0.4)), (0.8, 2.0, 0.6), "wall"),))
    assert "wall" in PLANNER.obstruction(WAY, arm)
    assert "touch" in PLANNER.obstruction(WAY, arm)
