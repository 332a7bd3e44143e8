"""A lap through hall, corridor and living room of the world `house`, with the robot's own odometry: it closes."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
from tests.helpers.robot import described
from tests.mapping.test_round import planar, rounds
from tests.mapping.test_tour import LIDAR

from jauspy.mapping.grid import OccupancyGrid
from jauspy.mapping.mapper import Mapper
from jauspy.platform.localization import Localization
from jauspy.platform.localizer import Localizer
from jauspy_sim.robot import SimulatedRobot

pytestmark = pytest.mark.slow

START = (2.7, 0.0)
LAP = [(7.3, 0.0), (7.3, 1.2), (4.5, 1.2), (4.0, 1.85), (2.6, 1.85), START]
"""Metres in the world; the robot begins in the hall, and ends there."""


def test_a_lap_of_the_house_closes_within_5_cm() -> None:
    model = replace(described("inc1")[1], cameras=(), force_torque=())
    robot = SimulatedRobot.open(model, "house")
    joint = robot.model.body(f"{robot.name_prefix}base_link").jntadr[0]
    address = robot.model.jnt_qposadr[joint]
    robot.data.qpos[address : address + 2] = START
    mujoco.mj_forward(robot.model, robot.data)
    known = Localization.of(robot)
    assert known is not None
    tracks = Localizer(replace(model.localization, imu=None, gnss=None), robot.drive)
    matched, alone = Mapper(OccupancyGrid(24.0)), Mapper(OccupancyGrid(24.0), matching=False)
    begun = planar(robot.drive.pose())
    errors: dict[str, list[float]] = {"matched": [], "tracks": []}
    way, last = 0.0, begun
    for _ in rounds(robot, LAP):
        for _ in range(5):
            robot.advance(0.02)
            tracks.step(robot.time)
        true = planar(robot.drive.pose())
        way, last = way + math.dist(true[:2], last[:2]), true
        scan = robot.lidars["lidar"].scan
        assert scan is not None
        for name, mapper, odometry in (("matched", matched, known), ("tracks", alone, tracks)):
            placed = mapper.add(planar(odometry.state().local.pose), LIDAR, scan.angles, scan.ranges)
            errors[name].append(math.dist(placed[:2], true.relative_to(begun)[:2]))
    assert way > 11.0
    assert math.dist(last[:2], START) < 0.35, "it has come back"
    assert errors["tracks"][-1] > 0.2, "there is something to close: tracks skid in each corner"
    assert errors["matched"][-1] < 0.05
    assert max(errors["matched"]) < 0.1
