"""Where the gripper goes, what counts as grasped and lifted, by an arm that feels what it is told to."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("cv2", reason="OpenCV is not installed")
pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco

from jauspy.demo import plan
from jauspy.demo.arm import ArmKinematics
from jauspy.demo.grasp import Grasp, level
from jauspy.geometry.denavit_hartenberg import manipulator_geometry
from jauspy.geometry.poses import Pose, Transform
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.robot import SimulatedRobot

LEVEL = Transform()
MODEL = robot_model(load("inc1"))
PITCHED = Transform.from_pose(Pose(1.0, 2.0, 0.3, roll=math.radians(-1.0), pitch=math.radians(2.0), yaw=1.2))
"""The base of a robot whose nose is down: 0.95 m ahead of it, that is 33 mm."""


class Robot:
    """Its base does not move."""

    def __init__(self, base: Transform) -> None:
        self._base = base

    async def read(self) -> Robot:
        return self

    def pose(self, *_: str) -> Transform:
        return self._base


class Arm:
    """Its tool rises by `rise` and then sinks by `sinks`; its hand holds what weighs `weight` and is `width` wide."""

    kinematics = ArmKinematics(MODEL)

    def __init__(self, rise: float, sinks: float, width: float, weight: float) -> None:
        self.poses: list[tuple[float, float, float, float]] = []
        self._heights = iter((0.0, rise, rise - sinks))
        self._weights = iter((1.5, 1.5 + weight))
        self._width = width

    async def go(self, *pose: float, duration: float | None = None) -> float:
        self.poses.append(pose)
        return 0.001

    async def tool_height(self) -> float:
        return next(self._heights)

    async def weight(self) -> float:
        return next(self._weights)

    async def width(self) -> float:
        return self._width

    async def open_gripper(self) -> float:
        return 0.1

    async def close_gripper(self) -> float:
        return self._width


@pytest.mark.parametrize(
    ("felt", "grasped", "lifted"),
    [
        ((0.13, 0.001, 0.049, 1.05), True, True),
        ((0.08, 0.0, 0.049, 1.05), True, False),  # not high enough
        ((0.13, 0.05, 0.049, 1.05), True, False),  # it sinks
        ((0.13, 0.0, 0.0, 0.0), False, False),  # nothing is in the hand
        ((0.13, 0.0, 0.049, 0.1), True, False),  # the hand is as wide, and carries nothing
        ((0.13, 0.0, 0.08, 1.05), False, False),  # something else
    ],
)
async def test_lift_requires_height_width_and_weight(
    monkeypatch: pytest.MonkeyPatch, felt: tuple[float, float, float, float], grasped: bool, lifted: bool
) -> None:
    monkeypatch.setattr(plan, "HOLD_TIME", 0.0)
    grasp = Grasp(Arm(*felt), Robot(LEVEL), MODEL, None, size=(640, 480), goals=plan.PLANS["yard"])
    grasp._target = 0.9, 0.1, 0.42
    assert (await grasp.reach()).reached
    assert (await grasp.close()).reached is grasped
    assert (await grasp.lift()).reached is lifted


@pytest.mark.parametrize("world", plan.PLANS)
async def test_gripper_of_a_pitched_robot_is_where_that_of_a_level_one_is(world: str) -> None:
    goals, target = plan.PLANS[world], (0.7, 0.08, 0.3)
    group, tilt = MODEL.groups["arm"], level(PITCHED)
    geometry = manipulator_geometry(MODEL.description.chain(group.base, group.tip))
    places = []
    for base, to_level in ((LEVEL, LEVEL), (PITCHED, tilt)):
        arm = Arm(0.0, 0.0, 0.1, 0.0)
        grasp = Grasp(arm, Robot(base), MODEL, None, size=(640, 480), goals=goals)
        grasp._target = target
        await grasp.reach()
        rows = [[*arm.kinematics.joints(*pose).values()] for pose in arm.poses]
        tools = [to_level @ geometry.forward(geometry.from_urdf(row)) for row in rows]
        places.append([(tool.apply(geometry.tool), tool.rotate(geometry.tool)) for tool in tools])
    for (level_place, level_ahead), (place, ahead) in zip(*places, strict=True):
        # its place is the same, but for the axis of the arm, which the roll moves aside by a millimetre
        assert place == pytest.approx(level_place, abs=0.004)
        assert place[2] == pytest.approx(level_place[2], abs=1e-6)
        assert ahead[2] == pytest.approx(level_ahead[2], abs=1e-4)
    assert places[1][-1][0] == pytest.approx(target, abs=1e-6)


async def test_reach_tells_where_it_aims_and_how_the_chassis_stands() -> None:
    grasp = Grasp(Arm(0.0, 0.0, 0.1, 0.0), Robot(PITCHED), MODEL, None, size=(640, 480), goals=plan.PLANS["yard"])
    grasp._target = 0.9, 0.1, 0.42
    figures = (await grasp.reach()).figures
    assert figures["base_pitch"] == pytest.approx(math.radians(2.0))
    assert figures["base_roll"] == pytest.approx(math.radians(-1.0))
    assert (figures["target_x"], figures["target_y"], figures["target_z"]) == (0.9, 0.1, 0.42)


def test_plan_keeps_the_palm_off_the_table_and_the_fingers_on_the_can() -> None:
    can, robot = plan.PLANS["yard"].thing, SimulatedRobot.open(MODEL, "empty").model
    palm, finger = (largest_half(robot, f"inc1/{link}") for link in ("gripper_link", "left_finger"))
    assert palm == pytest.approx(plan.PALM_BELOW)
    margin = 0.02 + 0.015  # what is to be left, and errors of attitude and of the measured height
    assert can.grip_height - palm >= margin
    assert can.size - can.grip_height - finger >= 0.02


def largest_half(robot: mujoco.MjModel, body: str) -> float:
    """Half of the height of the boxes that a link collides with, m."""
    geoms = [geom for geom in range(robot.ngeom) if robot.body(robot.geom_bodyid[geom]).name == body]
    return max(float(robot.geom_size[geom][2]) for geom in geoms if robot.geom_contype[geom])
