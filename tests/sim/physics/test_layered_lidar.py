"""Lidars of several layers in MuJoCo's worlds."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

from tests.helpers.robot import described

from jauspy.platform.ranging import LidarSetup, RangeScan
from jauspy_sim.robot import SimulatedRobot

INC1 = replace(described("inc1")[1], cameras=())
LAYERED = LidarSetup("lidar", "lidar_link", rays=120, noise=0.0, layers=5, vertical=(-0.2, 0.2))


def opened(setup: LidarSetup, world: str = "yard") -> SimulatedRobot:
    return SimulatedRobot.open(replace(INC1, lidars=(setup,)), world)


def scan_of(robot: SimulatedRobot) -> RangeScan:
    scan = robot.lidars["lidar"].scan
    assert scan is not None
    return scan


@pytest.mark.slow
def test_the_horizontal_layer_is_what_a_planar_lidar_measures() -> None:
    planar, layered = scan_of(opened(replace(LAYERED, layers=1))), scan_of(opened(LAYERED))
    assert layered.ranges == pytest.approx(planar.ranges, abs=1e-4)
    assert layered.inclination == 0.0
    assert layered.image().shape == (5, 120)
    assert layered.image()[2].tolist() == pytest.approx(planar.ranges, abs=1e-4)
    assert planar.image().shape == (1, 120)


def test_layers_below_meet_the_ground_and_those_above_nothing() -> None:
    robot = opened(LAYERED, "empty")
    image, height = scan_of(robot).image(), robot.data.body("inc1/lidar_link").xpos[2]
    assert image[0] == pytest.approx(height / math.sin(0.2), rel=0.02)
    assert image[1] == pytest.approx(height / math.sin(0.1), rel=0.05)
    assert np.isinf(image[2:]).all()


def test_of_two_layers_as_near_the_upper_one_is_reported() -> None:
    scan = scan_of(opened(replace(LAYERED, layers=4), "empty"))
    assert scan.inclination == pytest.approx(0.2 / 3.0)
    assert set(scan.ranges) == {math.inf}


@pytest.mark.slow
def test_a_scan_in_parts_is_as_from_where_it_began() -> None:
    """3600 rays take several steps, in which the robot turns; a planar lidar measures at once."""
    many = replace(LAYERED, rays=720)
    layered, planar = opened(many), opened(replace(many, layers=1))
    for robot in (layered, planar):
        robot.drive.set_effort(0.0, 0.6)
        robot.advance(0.1)
    began = layered.drive.pose().yaw
    assert scan_of(layered).time < scan_of(planar).time, "it is not complete yet"
    layered.advance(0.08)
    assert layered.drive.pose().yaw > began + 0.01
    assert scan_of(layered).time == scan_of(planar).time
    assert scan_of(layered).ranges == pytest.approx(scan_of(planar).ranges, abs=1e-4)


@pytest.mark.slow
def test_is_the_same_however_time_is_divided() -> None:
    noisy = replace(LAYERED, noise=0.02, rays=720)
    first, again = opened(noisy), opened(noisy)
    for robot, step in ((first, 0.25), (again, 0.01)):
        robot.drive.set_effort(0.3, 0.2)
        for _ in range(round(0.25 / step)):
            robot.advance(step)
    assert scan_of(first) == scan_of(again)
    assert scan_of(first).time > 0.0


def test_settings_hold_for_all_layers() -> None:
    robot = opened(LAYERED)
    lidar = robot.lidars["lidar"]
    lidar.configure(replace(lidar.settings, start=0.0, stop=1.0, max_range=3.0))
    robot.advance(0.2)
    image = scan_of(robot).image()
    assert image.shape == (5, len(scan_of(robot).angles))
    assert 10 < image.shape[1] < 30
    assert float(image[np.isfinite(image)].max()) <= 3.0
    lidar.configure(replace(lidar.settings, active=False))
    robot.advance(0.2)
    assert lidar.scan is None
