"""Distances in the planning scene, and paths around obstacles."""

from __future__ import annotations

import math
from itertools import pairwise

import coal
import numpy as np
import pinocchio as pin
import pytest

from jauspy.cell.frames import offset_between, shifted, turned
from jauspy.cell.motion import STEP, MotionPlanner, NoPath, profile
from jauspy.cell.scene import Layout, Piece, PlanningScene, connector_frame, links_of_urdf, output_frame, pieces_of_part
from jauspy.errors import ConfigError

DOWN = turned("x", math.pi)


@pytest.fixture
def scene(layout: Layout) -> PlanningScene:
    return PlanningScene(layout.kinematics, links_of_urdf(layout.urdf, layout.group.joints))


def cube(side: float) -> list[Piece]:
    return [Piece(coal.Box(side, side, side), pin.SE3.Identity())]


def test_distance_to_a_cube_before_the_gripper(layout: Layout, scene: PlanningScene) -> None:
    tool = layout.kinematics.forward(layout.home)
    scene.put("cube", cube(0.1), tool * shifted(z=0.05 + 0.01))
    found = scene.explain(layout.home)
    assert found.distance == pytest.approx(0.01, abs=1e-4)
    assert found.between == ("gripper_1", "cube")


def test_what_is_ignored_or_removed_does_not_count(layout: Layout, scene: PlanningScene) -> None:
    free = scene.clearance(layout.home).distance
    scene.put("cube", cube(0.1), layout.kinematics.forward(layout.home))
    assert scene.clearance(layout.home).distance <= 0.0
    with scene.without("cube"):
        assert scene.clearance(layout.home).distance == free
    assert scene.clearance(layout.home).distance <= 0.0
    scene.remove("cube")
    assert scene.clearance(layout.home).distance == free


def test_a_held_part_counts_as_the_arm(layout: Layout, scene: PlanningScene) -> None:
    tool = layout.kinematics.forward(layout.home)
    scene.put("wall", cube(0.2), tool * shifted(z=0.1 + 0.1 + 0.01))
    before = scene.clearance(layout.home).distance
    scene.hold("cube", cube(0.1), shifted(z=0.05 + 0.001))
    found = scene.explain(layout.home)
    scene.release()
    assert before > 0.015
    assert found.distance == pytest.approx(0.009, abs=1e-4)
    assert found.between == ("cube", "wall")
    assert scene.clearance(layout.home).distance == before


def test_connectors_of_servos_turn_with_the_joint(layout: Layout) -> None:
    elbow = next(each for each in layout.setup.types.values() if each.name.endswith("elbow"))
    straight, bent = connector_frame(elbow, "output"), connector_frame(elbow, "output", math.pi / 2.0)
    assert straight.translation[2] > bent.translation[2]
    assert offset_between(straight, bent)[1] == pytest.approx(math.pi / 2.0)
    assert max(offset_between(output_frame(elbow, math.tau), output_frame(elbow))) < 1e-9
    assert len(pieces_of_part(elbow)) == 2
    with pytest.raises(ConfigError, match="no connector 'side'; it has: output"):
        connector_frame(elbow, "side")


@pytest.mark.slow
def test_a_detour_keeps_its_distance(layout: Layout, scene: PlanningScene) -> None:
    planner = MotionPlanner(scene, layout.kinematics, margin=0.015)
    scene.put("wall", [Piece(coal.Box(0.05, 0.3, 1.3), pin.SE3.Identity())], shifted(0.7, 0.0, 0.65))
    k = layout.kinematics
    start = k.solve(shifted(0.6, 0.5, 0.5) * DOWN, layout.home)[0].positions
    goals = [each for each in k.solve(shifted(0.6, -0.5, 0.5) * DOWN, start) if scene.is_free(each.positions, 0.015)]
    direct = scene.along((start, goals[0].positions), STEP)
    path = planner.to_posture(start, goals[0].positions)
    assert direct.distance < 0.015, "or there is nothing to go around"
    assert path.clearance.distance >= 0.015
    assert scene.along(path.points, STEP / 5.0).distance >= 0.01, "between the checked postures, too"
    again = MotionPlanner(scene, layout.kinematics, margin=0.015).to_posture(start, goals[0].positions)
    assert all(np.array_equal(a, b) for a, b in zip(path.points, again.points, strict=True))


def test_a_goal_inside_something_is_named(layout: Layout, scene: PlanningScene) -> None:
    k = layout.kinematics
    goal = k.solve(shifted(0.6, -0.5, 0.5) * DOWN, layout.home)[0].positions
    scene.put("crate", cube(0.3), shifted(0.6, -0.5, 0.5))
    with pytest.raises(NoPath, match="crate"):
        MotionPlanner(scene, layout.kinematics).to_posture(layout.home, goal)


def test_lines_are_straight(layout: Layout, scene: PlanningScene) -> None:
    k = layout.kinematics
    start = k.solve(shifted(0.6, 0.3, 0.6) * DOWN, layout.home)[0].positions
    path = MotionPlanner(scene, layout.kinematics).line(start, shifted(0.6, 0.3, 0.3) * DOWN)
    for a, b in pairwise(path.points):
        for share in (0.25, 0.5, 0.75):
            x, y, _ = k.forward(a + (b - a) * share).translation
            assert math.hypot(x - 0.6, y - 0.3) < 0.002


def test_joints_arrive_together() -> None:
    start, goal = np.zeros(3), np.array([1.0, -0.5, 0.0])
    found = profile(start, goal, np.full(3, 2.0), np.full(3, 8.0))
    assert found.speeds[:2] == pytest.approx([2.0, 1.0])
    assert found.accelerations[:2] == pytest.approx([8.0, 4.0])
    assert found.duration == pytest.approx(1.0 / 2.0 + 2.0 / 8.0)
    short = profile(start, goal * 0.01, np.full(3, 2.0), np.full(3, 8.0))
    assert short.duration == pytest.approx(2.0 * math.sqrt(0.01 / 8.0))
