"""Cameras outside of the robot: where they are, and that they show it."""

from __future__ import annotations

import dataclasses
import math

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import numpy as np

from jauspy.platform.camera import CameraSetup, OutsideSetup, Viewpoint
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.robot import SimulatedRobot

CAMERAS = {
    "fixed": OutsideSetup(Viewpoint.FIXED, position=(-2.0, -2.0, 1.5)),
    "chase": OutsideSetup(Viewpoint.CHASE, distance=2.0, height=1.2),
    "walled": OutsideSetup(Viewpoint.CHASE, distance=8.0, height=0.1),
}


@pytest.fixture(scope="module")
def robot():
    setups = tuple(CameraSetup(name, "", math.radians(50.0), outside=setup) for name, setup in CAMERAS.items())
    opened = SimulatedRobot.open(dataclasses.replace(robot_model(load("inc1")), cameras=setups), "yard")
    yield opened
    opened.close()


@pytest.fixture
def look(robot, monkeypatch):
    monkeypatch.setenv("MUJOCO_GL", "disable")
    sessions = []

    def taken(name):
        sessions.append(session := robot.cameras[name].open())
        return session, session.look(160, 120)

    yield taken
    for session in sessions:
        session.close()


@pytest.mark.parametrize("name", ["fixed", "chase"])
def test_the_robot_is_in_the_middle_of_the_picture(robot, look, name):
    _, frame = look(name)
    red, green, blue = (frame.image[45:75, 60:100, channel].astype(int) for channel in range(3))
    olive = (green > blue + 8) & (green >= red)
    assert olive.mean() > 0.1
    edges = frame.image[:, :8].astype(int)
    assert ((edges[..., 1] > edges[..., 2] + 8) & (edges[..., 1] >= edges[..., 0])).mean() < 0.02


def test_a_chasing_camera_is_behind_and_above(robot, look):
    session, _ = look("chase")
    at = session._data.cam_xpos[robot.cameras["chase"].number]
    base = robot.data.body("inc1/base_link").xpos
    assert at - base == pytest.approx([-2.0, 0.0, 1.2], abs=0.05)


def test_a_wall_does_not_come_between(robot, look):
    session, _ = look("walled")
    at = session._data.cam_xpos[robot.cameras["walled"].number]
    assert -3.0 < at[0] < -2.0  # the wall behind begins at -3
    assert np.isfinite(at).all()
