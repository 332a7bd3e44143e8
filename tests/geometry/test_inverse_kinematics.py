"""Positions of the joints for poses of the tool: forward kinematics of what is found is the pose."""

import math
import random

import pytest
from tests.geometry.test_denavit_hartenberg import random_chain
from tests.services.manipulator.arms import ROBOTS, arm_of, found_by, random_positions, search_for, tool_at, whole

from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.kinematics import InverseKinematics, forward_kinematics
from jauspy.geometry.poses import Transform, rotation_vector
from jauspy.geometry.urdf import JointKind
from jauspy.geometry.vectors import add, rotation_about

MILLIMETRE, HALF_A_DEGREE = 0.001, math.radians(0.5)


def errors(there: Transform, goal: Transform) -> tuple[float, float]:
    """Metres and radians."""
    return math.dist(there.position, goal.position), math.hypot(*rotation_vector(there.rotation, goal.rotation))


@pytest.mark.slow
@pytest.mark.parametrize("robot", ROBOTS)
@pytest.mark.parametrize("seed", range(8))
def test_all_reachable_poses_are_found(robot: str, seed: int) -> None:
    arm, rng = arm_of(robot), random.Random(seed)
    for _ in range(6):
        goal = tool_at(arm, random_positions(arm, rng))
        found = found_by(arm, goal)
        distance, turn = errors(tool_at(arm, list(found.positions)), goal)
        assert distance < MILLIMETRE
        assert turn < HALF_A_DEGREE
        assert found.reaches_pose
        assert (found.distance, found.angle) == pytest.approx((distance, turn), abs=1e-9)
        assert all(low <= p <= high for p, (low, high) in zip(found.positions, arm.limits, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize("robot", ROBOTS)
def test_reachable_point_is_reached_with_any_attitude(robot: str) -> None:
    arm, rng = arm_of(robot), random.Random(2)
    for _ in range(12):
        point, attitude = (tool_at(arm, random_positions(arm, rng)) for _ in range(2))
        found = found_by(arm, Transform(attitude.rotation, point.position))
        assert found.reaches_point
        assert math.dist(tool_at(arm, list(found.positions)).position, point.position) < MILLIMETRE


def test_the_nearest_attitude_is_taken_if_the_goal_s_is_out_of_reach() -> None:
    arm = arm_of("inc1")
    reachable = tool_at(arm, list(arm.geometry.from_urdf((0.3, 1.2, -1.4, -0.4, 0.2))))
    aside = Transform(rotation_about((0.0, 0.0, 1.0), 0.3)) @ Transform(
        reachable.rotation
    )  # only the first joint turns so
    found = found_by(arm, Transform(aside.rotation, reachable.position))
    assert found.reaches_point
    assert not found.reaches_pose
    assert found.angle < 0.3, "no worse than without trying"


@pytest.mark.parametrize("robot", ROBOTS)
@pytest.mark.parametrize("offset", [(3.0, 0.0, 0.0), (0.0, 0.0, -25.0), (-30.0, 30.0, 30.0)])
def test_a_point_out_of_reach_is_not_reached(robot: str, offset) -> None:
    arm = arm_of(robot)
    tool = arm.kinematic_state().tool
    found = found_by(arm, Transform(tool.rotation, add(tool.position, offset)))
    assert not found.reaches_point
    assert all(map(math.isfinite, found.positions))


def test_nearby_pose_is_reached_directly() -> None:
    arm = arm_of("inc1", (0.4, 1.2, -0.9, 0.3, -0.5))
    positions = arm.state().positions
    there = [p + change for p, change in zip(positions, (0.1, -0.1, 0.1, 0.1, 0.1), strict=True)]
    assert found_by(arm, tool_at(arm, there)).positions == pytest.approx(there, abs=0.01)


@pytest.mark.parametrize("whole_pose", [True, False])
def test_of_several_solutions_the_one_with_the_shortest_motion_is_taken(whole_pose: bool) -> None:
    """The elbow stays up: with the elbow down, which fits no better, the arm would turn over."""
    start = (0.39, 1.6, -2.34, 0.74, 0.0)
    arm = arm_of("inc1", start)
    goal = tool_at(arm, list(arm.geometry.from_urdf((0.19, 1.63, -1.81, 0.18, 0.0))))
    attitude = goal if whole_pose else tool_at(arm, list(arm.state().positions))
    found = found_by(arm, Transform(attitude.rotation, goal.position))
    assert found.reaches_pose is whole_pose
    assert found.reaches_point
    assert arm.geometry.to_urdf(found.positions) == pytest.approx((0.19, 1.63, -1.81, 0.18, 0.0), abs=0.03)
    assert found.travel == pytest.approx(0.56, abs=0.05), "the wrist turns by 0.56 rad at 1.5 rad/s, the elbow by 0.53"


def test_a_shorter_motion_is_looked_for_when_the_first_one_is_long() -> None:
    arm, rng = arm_of("inc1"), random.Random(5)
    longer = 0
    for _ in range(10):
        start, goal = random_positions(arm, rng), tool_at(arm, random_positions(arm, rng))
        search = InverseKinematics(arm.geometry.links, arm.tool, goal, start, arm.limits)
        first = None
        while (found := search.advance(1)) is None:
            first = search.best if first is None and search.best.reaches_pose else first
        assert first is not None
        assert found.reaches_pose
        assert found.travel <= first.travel
        longer += first.travel > found.travel + 0.3
    assert longer


def test_arms_of_any_kind_reach_their_poses() -> None:
    kinds = set()
    for seed in range(14):
        rng = random.Random(seed)
        found = manipulator_geometry(random_chain(rng))
        spans = [1.5 if link.is_revolute else 0.3 for link in found.links]
        limits = [
            (link.zero_position - span, link.zero_position + span)
            for link, span in zip(found.links, spans, strict=True)
        ]
        goal = forward_kinematics(found.links, [rng.uniform(*limit) for limit in limits], found.tool).tool
        kinds.update((len(limits), link.joint.kind) for link in found.links)
        middle = [link.zero_position for link in found.links]
        there = whole(InverseKinematics(found.links, found.tool, goal, middle, limits))
        distance, turn = errors(forward_kinematics(found.links, there.positions, found.tool).tool, goal)
        assert distance < MILLIMETRE, seed
        assert turn < HALF_A_DEGREE, seed
    assert {number for number, _ in kinds} >= {1, 2, 3, 4, 5, 7}
    assert {kind for _, kind in kinds} == {JointKind.REVOLUTE, JointKind.PRISMATIC}


@pytest.mark.slow
def test_a_search_advances_in_parts_and_ends() -> None:
    arm = arm_of("inc1")
    tool = arm.kinematic_state().tool
    goal = Transform(tool.rotation, add(tool.position, (3.0, 0.0, 0.0)))
    search, looks = search_for(arm, goal), 0
    while (found := search.advance(20)) is None:
        looks += 1
        assert looks < 200
    assert found == found_by(arm, goal)


def test_the_same_arguments_give_the_same_positions() -> None:
    goal = tool_at(arm_of("inc1"), random_positions(arm_of("inc1"), random.Random(5)))
    assert found_by(arm_of("inc1"), goal) == found_by(arm_of("inc1"), goal)
