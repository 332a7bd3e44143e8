"""Lidars in MuJoCo's worlds: against walls whose places are known."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from jauspy.platform.ranging import RangeScan
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.robot import SimulatedRobot

INC1 = robot_model(load("inc1"))
(LIDAR,) = INC1.lidars
EXACT = replace(INC1, lidars=(replace(LIDAR, noise=0.0),))


def scan_of(robot: SimulatedRobot) -> RangeScan:
    scan = robot.lidars["lidar"].scan
    assert scan is not None
    return scan


def at(scan: RangeScan, degrees: float) -> float:
    (found,) = (r for a, r in zip(scan.angles, scan.ranges, strict=True) if abs(a - math.radians(degrees)) < 1e-6)
    return found


def test_measures_the_walls_of_the_yard() -> None:
    scan = scan_of(SimulatedRobot.open(EXACT, "yard"))
    assert len(scan.ranges) == 360
    # the lidar stands 0.33 m behind the origin; the walls' faces are at x = -3 and y = 4
    assert at(scan, -180) == pytest.approx(2.67, abs=0.005)
    assert at(scan, 90) == pytest.approx(4.0, abs=0.01)
    assert at(scan, -90) == math.inf, "there is no wall to the right"


def test_own_robot_is_not_measured() -> None:
    assert set(scan_of(SimulatedRobot.open(EXACT, "empty")).ranges) == {math.inf}


@pytest.mark.slow
def test_turns_with_the_robot() -> None:
    robot = SimulatedRobot.open(EXACT, "yard")
    robot.drive.set_effort(0.0, 0.4)
    while robot.drive.pose().yaw < math.radians(45):
        robot.advance(0.01)
    robot.drive.stop()
    robot.advance(0.5)
    pose, scan = robot.drive.pose(), scan_of(robot)
    x, y = pose.x - 0.33 * math.cos(pose.yaw), pose.y - 0.33 * math.sin(pose.yaw)
    beam = pose.yaw + math.radians(45)
    assert at(scan, 45) == pytest.approx((4.0 - y) / math.sin(beam), abs=0.02), f"from {x}, {y}"


@pytest.mark.slow
def test_noise_has_the_given_deviation_and_is_repeatable() -> None:
    first, again = (SimulatedRobot.open(INC1, "yard") for _ in range(2))
    other = SimulatedRobot.open(replace(INC1, lidars=(replace(LIDAR, seed=7),)), "yard")
    exact = scan_of(SimulatedRobot.open(EXACT, "yard")).ranges
    assert scan_of(first) == scan_of(again)
    assert scan_of(first) != scan_of(other)
    errors = [a - b for a, b in zip(scan_of(first).ranges, exact, strict=True) if math.isfinite(b)]
    assert len(errors) > 100
    assert math.sqrt(sum(e * e for e in errors) / len(errors)) == pytest.approx(LIDAR.noise, rel=0.3)


@pytest.mark.slow
def test_scans_do_not_depend_on_the_division_of_time() -> None:
    one, other = (SimulatedRobot.open(INC1, "yard") for _ in range(2))
    for robot in (one, other):
        robot.drive.set_effort(0.3, 0.2)
    one.advance(1.23)
    for _ in range(123):
        other.advance(0.01)
    assert scan_of(one) == scan_of(other)
    assert scan_of(one).time == pytest.approx(1.2)


@pytest.mark.slow
def test_a_lidar_does_not_change_the_trajectory() -> None:
    blind, seeing = (SimulatedRobot.open(model, "yard") for model in (replace(INC1, lidars=()), INC1))
    for robot in (blind, seeing):
        robot.drive.set_effort(0.4, 0.3)
        robot.advance(2.0)
    assert blind.drive.pose() == seeing.drive.pose()
