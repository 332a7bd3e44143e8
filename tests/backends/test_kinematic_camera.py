from __future__ import annotations

import dataclasses
import math
import pickle

import pytest

pytest.importorskip("numpy", reason="the extra 'video' is not installed")

import numpy as np

from jauspy.backends import kinematic_camera
from jauspy.backends.kinematic import KinematicRobot
from jauspy.geometry.poses import Pose
from jauspy.platform.camera import CameraSetup
from jauspy.platform.joints import ControlMode, Target
from jauspy.robot.robot_files import load, robot_model

SKY = (150, 190, 230)
FRONT = CameraSetup("front", "chassis_camera_link", math.radians(90.0))
ARM = CameraSetup("arm", "arm_camera_link", math.radians(60.0))


@pytest.fixture
def robot():
    opened = KinematicRobot(dataclasses.replace(robot_model(load("inc1")), cameras=(FRONT, ARM)))
    yield opened
    opened.close()


@pytest.fixture
def eye(robot):
    opened = pickle.loads(pickle.dumps(robot.cameras["front"])).open()
    yield opened
    opened.close()


def sky(image):
    return (image == SKY).all(axis=2)


def test_horizon_of_a_level_camera_is_centred(eye):
    image = eye.look(320, 240).image
    assert image.shape == (240, 320, 3)
    assert sky(image)[:118].all()
    assert not sky(image)[124:].any()


def test_floor_squares_have_the_right_edges(eye):
    """The camera is 0.376 m ahead of the robot and 0.24 m high; what is d ahead is seen 0.24/d below the middle."""
    image = eye.look(801, 601).image
    column = image[:, 401 + 20].astype(int).sum(axis=1)
    for edge in (1.0, 2.0):
        row = 300 + 400 * 0.24 / (edge - 0.376)
        near, far = column[round(row) + 3], column[round(row) - 3]
        assert abs(near - far) > 60, f"no edge at {edge} m"


def test_images_follow_the_motion_with_times(robot, eye):
    before = eye.look(160, 120)
    robot.drive.set_effort(0.5, 0.0)
    robot.advance(1.0)
    after = eye.look(160, 120)
    assert after.taken > before.taken
    assert (after.image != before.image).any()


def test_arm_camera_moves_with_its_joints(robot):
    eye = robot.cameras["arm"].open()
    arm = robot.groups["arm"]
    shares = []
    for pitch in (0.35, 1.35, -0.65):  # it looks down by 0.35 when the hand is level
        targets = [0.0, 0.0, 0.0, pitch, 0.0]
        arm.command([Target(ControlMode.POSITION, value) for value in targets])
        robot.advance(10.0)
        shares.append(sky(eye.look(160, 120).image).mean())
    eye.close()
    level, up, down = shares
    assert up > 0.9
    assert down < 0.1
    assert 0.1 < level < 0.9


def test_a_robot_without_cameras_has_none():
    model = dataclasses.replace(robot_model(load("igvc")), cameras=())
    assert KinematicRobot(model).cameras == {}


def test_missing_numpy_error_names_the_extra(robot, monkeypatch):
    def fail(_):
        raise ImportError("No module named 'numpy'")

    monkeypatch.setattr(kinematic_camera, "FloorCameraSession", fail)
    with pytest.raises(Exception, match=r"cameras need NumPy: pip install 'jauspy\[video\]'"):
        robot.cameras["front"].open()


def test_distances_are_those_of_the_floor(eye):
    frame = eye.measure(320, 240)
    image, far = frame.image, frame.distances
    assert (image == eye.look(320, 240).image).all()
    assert (np.isinf(far) == sky(image)).all()
    below = (np.arange(240) + 0.5 - 120.0) / 160.0  # metres down for each metre ahead, at 90 degrees across
    assert far[120:, 7] == pytest.approx(0.24 / below[120:], rel=1e-4)


def test_pictures_of_a_robot_at_rest_have_new_times(robot, eye):
    robot.advance(0.1)
    before = eye.look(160, 120)
    robot.advance(0.1)
    after = eye.look(160, 120)
    assert after.taken > before.taken
    assert (after.image == before.image).all()


def test_a_robot_at_rest_that_is_placed_elsewhere_is_seen_there(robot, eye):
    robot.advance(0.1)
    before = eye.look(160, 120)
    robot.place(Pose(x=0.3))
    robot.advance(0.1)
    assert (eye.look(160, 120).image != before.image).any()
