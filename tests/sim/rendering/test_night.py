"""Cameras in the dark: the sky gives little light, and the robot's lamps light what they see."""

from __future__ import annotations

import dataclasses
import math

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import numpy as np

from jauspy.platform.camera import CameraSetup
from jauspy.platform.lights import DAYLIGHT, LampSetup, Switch, TimeOfDay, lamps_of
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.gl_libraries import choose_gl
from jauspy_sim.robot import SimulatedRobot

FRONT = CameraSetup("front", "chassis_camera_link", math.radians(80.0))
LAMP = LampSetup("lamp", "base_link", Switch.HEADLIGHTS, math.radians(40.0), 1000.0, (0.36, 0.25, 0.3), 0.3)


@pytest.fixture(scope="module")
def robot():
    model = robot_model(load("inc1"))
    dark = dataclasses.replace(model, cameras=(FRONT,), lamps=(LAMP,), time_of_day=TimeOfDay.NIGHT)
    opened = SimulatedRobot.open(dark, "yard")
    yield opened
    opened.close()


@pytest.fixture(scope="module", params=["rays", "GL"])
def eye(request, robot):
    with pytest.MonkeyPatch.context() as patch:
        if request.param == "rays":
            patch.setenv("MUJOCO_GL", "disable")
        elif choose_gl() is None:
            pytest.skip("there is neither libegl1 nor libosmesa6")
        opened = robot.cameras["front"].open()
    if request.param == "GL" and "rays" in opened.description:
        pytest.skip("GL does not work here")
    yield opened
    opened.close()


def light(robot, eye, level, **options):
    (lamp,) = lamps_of(robot)
    lamp.set(level)
    robot.advance(0.01)
    return eye.look(320, 240, **options).light


def pixel(robot, point):
    """Row and column at which a point of the world is seen."""
    number = robot.cameras["front"].number
    x, y, z = robot.data.cam_xmat[number].reshape(3, 3).T @ (np.array(point) - robot.data.cam_xpos[number])
    focal = 160.0 / math.tan(FRONT.fov / 2.0)
    return round(120.0 + focal * y / z), round(160.0 - focal * x / z)


def lamp_position(robot):
    body = robot.data.body("inc1/base_link")
    turn = body.xmat.reshape(3, 3)
    down = np.array([math.cos(LAMP.tilt), 0.0, -math.sin(LAMP.tilt)])
    return body.xpos + turn @ np.array(LAMP.position), turn @ down


@pytest.mark.slow
def test_without_lamps_only_the_sky_gives_light(robot, eye):
    dark = light(robot, eye, 0.0)
    assert dark == pytest.approx(np.full((240, 320), TimeOfDay.NIGHT.sky))


def test_a_lamp_lights_its_cone_as_photometry_says(robot, eye):
    lit = light(robot, eye, 1.0, thoroughly=True)
    at, ahead = lamp_position(robot)
    far = -at[2] / ahead[2]
    floor = at + far * ahead
    row, column = pixel(robot, floor)
    expected = LAMP.intensity * -ahead[2] / far**2 / DAYLIGHT
    assert lit[row, column] == pytest.approx(expected, rel=0.1)
    half = light(robot, eye, 0.5, thoroughly=True)
    assert half[row, column] == pytest.approx(expected / 2, rel=0.1)
    outside = pixel(robot, floor + np.array([0.0, -1.3 * far * math.tan(LAMP.cone / 2), 0.0]))
    assert lit[outside] == pytest.approx(TimeOfDay.NIGHT.sky)


def test_things_cast_shadows(robot, eye):
    if eye.reduced:
        pytest.skip("rays cast no shadows")
    at, ahead = lamp_position(robot)
    joint = robot.model.body("carton_2").jntadr[0]
    place = slice(robot.model.jnt_qposadr[joint], robot.model.jnt_qposadr[joint] + 3)
    before = robot.data.qpos[place].copy()
    robot.data.qpos[place] = at + 0.6 * ahead
    lit = light(robot, eye, 1.0, thoroughly=True)
    robot.data.qpos[place] = before
    free = light(robot, eye, 1.0, thoroughly=True)
    # The camera is to the right of the lamp, and sees the floor behind the box.
    row, column = pixel(robot, at - 1.1 * at[2] / ahead[2] * ahead + [0.0, 0.0, 0.0])
    behind = slice(row - 2, row + 3), slice(column - 2, column + 3)
    assert lit[behind].min() == pytest.approx(TimeOfDay.NIGHT.sky, rel=0.1)
    assert free[behind].min() > 10 * TimeOfDay.NIGHT.sky
