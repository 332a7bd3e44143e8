"""Where the arm's joints must be, against the forward kinematics of its specification."""

import math

import pytest

from jauspy.demo import plan
from jauspy.demo.arm import ArmKinematics
from jauspy.demo.plan import Plan
from jauspy.errors import RequestError
from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.poses import Transform
from jauspy.robot.robot_files import load, robot_model

MODEL = robot_model(load("inc1"))
GROUP = MODEL.groups["arm"]
GEOMETRY = manipulator_geometry(MODEL.description.chain(GROUP.base, GROUP.tip))


@pytest.fixture(scope="module")
def hand() -> ArmKinematics:
    return ArmKinematics(MODEL)


def last_link(joints: dict[str, float]) -> Transform:
    """The pose of the arm's last link in the base link's frame, by its specification."""
    return GEOMETRY.forward(GEOMETRY.from_urdf([joints[name] for name in GROUP.joints]))


@pytest.mark.parametrize("target", [(0.9, 0.0, 0.41), (0.85, 0.12, 0.53), (0.7, -0.2, 0.7), (0.2, 0.6, 0.5)])
def test_tool_reaches_the_pose_and_is_level(hand: ArmKinematics, target: tuple[float, float, float]) -> None:
    last = last_link(hand.joints(*hand.around(target)))
    assert last.apply(GEOMETRY.tool) == pytest.approx(target, abs=1e-6)
    along = last.rotate(GEOMETRY.tool)
    assert along[2] == pytest.approx(0.0, abs=1e-6)
    assert math.atan2(along[1], along[0]) == pytest.approx(math.atan2(target[1], target[0] - hand.axis))


@pytest.mark.parametrize("goals", plan.PLANS.values(), ids=plan.PLANS)
def test_gripper_points_down_in_the_view_pose(hand: ArmKinematics, goals: Plan) -> None:
    distance, height, pitch = goals.view
    last = last_link(hand.joints(0.3, distance, height, pitch))
    x, y, z = last.apply(GEOMETRY.tool)
    assert (math.hypot(x - hand.axis, y), z) == pytest.approx((distance, height))
    along = last.rotate(GEOMETRY.tool)
    assert math.atan2(along[2], math.hypot(along[0], along[1])) == pytest.approx(pitch)


@pytest.mark.parametrize("goals", plan.PLANS.values(), ids=plan.PLANS)
def test_all_poses_of_the_plan_are_reachable(hand: ArmKinematics, goals: Plan) -> None:
    thing, goal = goals.thing, goals.goal
    ahead, aside = rotated(goal.heading, thing.x - goal.x, thing.y - goal.y)
    for error in (-0.1, 0.1):
        turn, distance, height = hand.around(
            (ahead + error, aside + plan.DRIVE_TOLERANCE[0], thing.support + thing.grip_height)
        )
        for farther, higher in (goals.high, goals.over, *goals.approach):
            hand.joints(turn, distance + farther, height + higher, goals.pitch)
    hand.joints(0.0, *goals.view)


def rotated(yaw: float, x: float, y: float) -> tuple[float, float]:
    """A direction of the local frame in that of a robot with this heading."""
    return math.cos(yaw) * x + math.sin(yaw) * y, math.cos(yaw) * y - math.sin(yaw) * x


def test_unreachable_pose_raises_an_error(hand: ArmKinematics) -> None:
    with pytest.raises(RequestError, match=r"cannot reach 1\.50 m"):
        hand.joints(0.0, 1.5, 0.4)
