"""Plans of arms: free of contact by MuJoCo, within all limits, and reasons where there is none."""

from __future__ import annotations

import math
import time

import numpy as np
import pytest

pytest.importorskip("ompl", reason="needs jauspy[planning]")
pytest.importorskip("mujoco", reason="needs jauspy[sim]")

from tests.helpers.box_scenes import scene
from tests.helpers.mujoco_contacts import MujocoContacts
from tests.helpers.seven_joints import seven_joints

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose, Transform
from jauspy.planning.arm_planner import ArmPlanner
from jauspy.planning.motion import JointGoal, NoPlan, Plan, PlanRequest, PoseGoal, Reason, RegionGoal
from jauspy.planning.obstacles import Box, Cylinder, Obstacles, Sphere
from jauspy.platform.description import RobotModel
from jauspy.robot.robot_files import load, robot_model

ARMS = {"inc1": "arm", "cell": "ur10", "seven": "arm"}


def model_of(name: str) -> RobotModel:
    return seven_joints() if name == "seven" else robot_model(load(name))


@pytest.fixture(scope="module")
def robots() -> dict[str, tuple[RobotModel, ArmPlanner]]:
    models = {name: model_of(name) for name in ARMS}
    return {name: (model, ArmPlanner(model, ARMS[name])) for name, model in models.items()}


@pytest.fixture(scope="module")
def inc1(robots) -> ArmPlanner:
    return robots["inc1"][1]


STOWED = (0.0, 2.7, -2.6, -0.1, 0.0)
AHEAD = (0.0, 1.2, -1.2, -0.3, 0.0)


def contacts_of(plan: Plan, checker: MujocoContacts) -> set[frozenset[str]]:
    found = set()
    for one, other in zip(plan.positions[:-1], plan.positions[1:], strict=True):
        for share in (0.0, 0.5):
            found |= checker.at(one + share * (other - one))
    return found | checker.at(plan.positions[-1])


def check_limits(plan: Plan, planner: ArmPlanner) -> None:
    arm = planner.arm
    assert plan.times[0] == 0.0
    assert (np.diff(plan.times) > 0.0).all()
    speeds = np.diff(plan.positions, axis=0) / np.diff(plan.times)[:, None]
    assert (np.abs(speeds) <= arm.speeds * 1.0001).all()
    padded = np.vstack([np.zeros(speeds.shape[1]), speeds, np.zeros(speeds.shape[1])])
    middles = (plan.times[:-1] + plan.times[1:]) / 2.0
    gaps = np.diff(np.concatenate([[plan.times[0]], middles, [plan.times[-1]]]))
    accelerations = np.diff(padded, axis=0) / gaps[:, None]
    assert (np.abs(accelerations) <= arm.accelerations * 1.02).all()
    assert (plan.positions >= arm.lower - 1e-9).all()
    assert (plan.positions <= arm.upper + 1e-9).all()


def planned(planner: ArmPlanner, request: PlanRequest) -> Plan | Reason:
    try:
        return planner.plan(request)
    except NoPlan as error:
        return error.reason


@pytest.mark.slow
@pytest.mark.parametrize("name", ARMS)
def test_plans_among_boxes_touch_nothing(robots, name: str) -> None:
    model, planner = robots[name]
    solved = 0
    for seed in range(4):
        s = scene(planner.arm, seed)
        plan = planned(planner, PlanRequest(s.start, s.goal, s.obstacles, seed=seed, time_limit=2.0))
        if plan is Reason.NO_WAY:
            continue
        solved += 1
        assert contacts_of(plan, MujocoContacts(model, ARMS[name], s.obstacles)) == set()
        assert plan.clearance >= planner.margin - 0.01
        assert np.allclose(plan.positions[0], s.start)
        check_limits(plan, planner)
        if isinstance(s.goal, PoseGoal):
            tool = planner.arm.tool(planner.arm.frames(plan.positions[-1:]))[0]
            assert np.linalg.norm(tool[:3, 3] - s.goal.pose.position) < 1e-3
            assert np.allclose(tool[:3, :3], s.goal.pose.rotation, atol=5e-3)
        else:
            assert np.allclose(plan.positions[-1], s.end)
    assert solved >= 2


def test_the_checker_sees_a_motion_straight_through_a_wall(robots) -> None:
    model, planner = robots["inc1"]
    wall = Obstacles([Box(Transform(position=(0.7, 0.0, 0.5)), (0.05, 0.05, 1.0), "wall")])
    one, other = np.array([0.6, 1.0, -1.0, 0.0, 0.0]), np.array([-0.6, 1.0, -1.0, 0.0, 0.0])
    positions = one + np.linspace(0.0, 1.0, 60)[:, None] * (other - one)
    straight = Plan(np.arange(60.0), positions, 0.0, 0.0)
    checker = MujocoContacts(model, "arm", wall)
    assert any("obstacle 0" in pair for pair in contacts_of(straight, checker))
    around = planner.plan(PlanRequest(tuple(one), JointGoal(tuple(other)), wall, time_limit=5.0))
    assert contacts_of(around, checker) == set()
    assert len(around.positions) > len(straight.positions)
    again = planner.plan(PlanRequest(tuple(one), JointGoal(tuple(other)), wall, time_limit=5.0))
    assert np.array_equal(again.positions, around.positions)


def test_a_free_motion_is_straight_and_the_same_again(inc1) -> None:
    request = PlanRequest(STOWED, JointGoal(AHEAD), Obstacles())
    plan = inc1.plan(request)
    again = inc1.plan(request)
    assert np.array_equal(plan.positions, again.positions)
    way = np.array(AHEAD) - STOWED
    shares = (plan.positions - STOWED)[:, 1] / way[1]
    assert np.allclose(plan.positions, STOWED + shares[:, None] * way)


def test_voxels_are_obstacles(robots) -> None:
    model, planner = robots["inc1"]
    y, z = np.meshgrid(np.arange(-0.03, 0.04, 0.02), np.arange(0.01, 1.0, 0.02))
    voxels = np.stack([np.full(y.size, 0.71), y.ravel(), z.ravel()], axis=1) + 0.003
    obstacles = Obstacles(voxels=voxels)
    one, other = (0.6, 1.0, -1.0, 0.0, 0.0), (-0.6, 1.0, -1.0, 0.0, 0.0)
    plan = planner.plan(PlanRequest(one, JointGoal(other), obstacles, time_limit=5.0))
    assert contacts_of(plan, MujocoContacts(model, "arm", obstacles)) == set()
    assert planner.plan(PlanRequest(one, JointGoal(other), Obstacles())).duration < plan.duration


def test_a_payload_keeps_clear_too(robots) -> None:
    model, planner = robots["inc1"]
    beam = Cylinder(Transform(), 0.02, 0.6, "beam")
    post = Obstacles([Cylinder(Transform(position=(1.0, 0.0, 0.5)), 0.04, 1.2, "post")])
    one, other = (0.7, 1.0, -1.0, 0.0, 0.0), (-0.7, 1.0, -1.0, 0.0, 0.0)
    plan = planner.plan(PlanRequest(one, JointGoal(other), post, payload=beam, time_limit=5.0))
    checker = MujocoContacts(model, "arm", post, beam)
    assert {pair for pair in contacts_of(plan, checker) if "obstacle 0" in pair} == set()


def test_a_region_is_reached_without_its_middle(inc1) -> None:
    region = RegionGoal(Transform.from_pose(Pose(0.75, 0.25, 0.5, 0.0, 0.4, 0.0)), (0.2, 0.2, 0.1), 0.6)
    plan = inc1.plan(PlanRequest(STOWED, region, Obstacles(), time_limit=5.0))
    tool = inc1.arm.tool(inc1.arm.frames(plan.positions[-1:]))[0]
    inside = np.array(region.pose.rotation).T @ (tool[:3, 3] - region.pose.position)
    assert (np.abs(inside) <= np.array(region.size) / 2.0 + 1e-3).all()
    turn = np.array(region.pose.rotation).T @ tool[:3, :3]
    assert math.acos(min(1.0, (np.trace(turn) - 1.0) / 2.0)) <= region.angle + 5e-3


def test_a_point_alone_may_be_reached_with_any_attitude(inc1) -> None:
    goal = PoseGoal(Transform(position=(0.6, 0.4, 0.4)), attitude=False)
    plan = inc1.plan(PlanRequest(STOWED, goal, Obstacles()))
    tool = inc1.arm.tool(inc1.arm.frames(plan.positions[-1:]))[0]
    assert np.linalg.norm(tool[:3, 3] - goal.pose.position) < 1e-3


IN_THE_ARM = Sphere(Transform(position=(0.75, 0.0, 0.4)), 0.3, "ball")
SHELL = [
    Box(Transform(position=(0.45, 0.0, 0.9)), (1.6, 1.6, 0.05), "lid"),
    *(Box(Transform(position=(0.45, y, 0.5)), (1.6, 0.05, 1.0), "side") for y in (-0.6, 0.6)),
]


@pytest.mark.parametrize(
    ("start", "goal", "obstacles", "reason", "words"),
    [
        (STOWED, PoseGoal(Transform(position=(3.0, 0.0, 0.5))), (), Reason.OUT_OF_REACH, "no nearer than"),
        (
            STOWED,
            PoseGoal(Transform.from_pose(Pose(0.6, 0.3, 0.4, 1.2, 0.0, 2.0))),
            (),
            Reason.OUT_OF_REACH,
            "not with this attitude",
        ),
        (STOWED, JointGoal(AHEAD), (IN_THE_ARM,), Reason.GOAL_COLLIDES, "and ball would touch"),
        (AHEAD, JointGoal(STOWED), (IN_THE_ARM,), Reason.START_COLLIDES, "ball"),
        (STOWED, JointGoal((9.0, 0.0, 0.0, 0.0, 0.0)), (), Reason.OUTSIDE_LIMITS, "base_link_to_arm_link_1 at 9.000"),
        (STOWED, JointGoal((0.0,)), (), Reason.OUTSIDE_LIMITS, "1 positions; the arm has 5 joints"),
    ],
)
def test_what_cannot_be_done_is_said_with_its_reason(inc1, start, goal, obstacles, reason, words) -> None:  # noqa: PLR0917
    begin = time.process_time()
    with pytest.raises(NoPlan, match=words) as caught:
        inc1.plan(PlanRequest(start, goal, Obstacles(obstacles)))
    assert caught.value.reason is reason
    assert time.process_time() - begin < 1.0


BALL_AT_GOAL = {
    "inc1": ((0.9, 0.0, 0.5), (0.0, 2.7, -2.6, -0.1, 0.0)),
    "cell": ((0.7, 0.3, 1.2), (0.0, -1.6, 1.6, 0.0, 0.0, 0.0)),
    "seven": ((0.5, 0.2, 0.5), (2.5, 0.4, 0.0, 1.2, 0.0, 0.8, 0.0)),
}
"""A point in reach, and a posture that is away from it."""


@pytest.mark.parametrize("name", ARMS)
def test_what_cannot_be_reached_is_said_within_a_second(robots, name: str) -> None:
    _, planner = robots[name]
    point, start = BALL_AT_GOAL[name]
    planner.plan(PlanRequest(start, PoseGoal(Transform(position=point), attitude=False), Obstacles()))
    ball = Obstacles([Sphere(Transform(position=point), 0.15, "ball")])
    for place, obstacles, reason in (
        ((9.0, 0.0, 0.5), Obstacles(), Reason.OUT_OF_REACH),
        (point, ball, Reason.GOAL_COLLIDES),
    ):
        begin = time.process_time()
        with pytest.raises(NoPlan) as caught:
            planner.plan(PlanRequest(start, PoseGoal(Transform(position=place), attitude=False), obstacles))
        assert caught.value.reason is reason
        assert time.process_time() - begin < 1.0


def test_a_search_ends_when_nobody_waits_for_it(robots) -> None:
    asked = []

    def is_cancelled() -> bool:
        asked.append(True)
        return len(asked) > 3

    request = PlanRequest(*blocked(), time_limit=60.0, is_cancelled=is_cancelled)
    with pytest.raises(NoPlan, match="cancelled") as caught:
        robots["seven"][1].plan(request)
    assert caught.value.reason is Reason.CANCELLED
    assert len(asked) < 100


def blocked() -> tuple[tuple[float, ...], JointGoal, Obstacles]:
    """Start, goal and obstacles between which there is no way, for the arm of seven joints."""
    around = ((0.62, 0.0, 1.0, 3.0), (-0.62, 0.0, 1.0, 3.0), (0.0, 0.62, 0.3, 1.0), (0.0, -0.62, 0.3, 1.0))
    slab = [Box(Transform(position=(x, y, 0.72)), (a, b, 0.04), "slab") for x, y, a, b in around]
    return (0.0,) * 7, JointGoal((0.0, 1.9, 0.0, 0.0, 0.0, 0.0, 0.0)), Obstacles(slab)


@pytest.mark.slow
def test_no_way_is_said_within_a_second(robots) -> None:
    begin = time.process_time()
    with pytest.raises(NoPlan, match=r"no way to the goal was found within 1 s") as caught:
        robots["seven"][1].plan(PlanRequest(*blocked()))
    assert caught.value.reason is Reason.NO_WAY
    assert time.process_time() - begin < 1.0


def test_an_unknown_group_is_named() -> None:
    with pytest.raises(ConfigError, match="no group 'tail'"):
        ArmPlanner(seven_joints(), "tail")
