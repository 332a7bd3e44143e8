"""What the simulated cameras see, by GL where there is one, and by rays everywhere."""

from __future__ import annotations

import dataclasses
import math
import os
import pickle
import subprocess
import sys

import pytest
from tests.helpers.sampling import sampled

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np

from jauspy.platform.camera import CameraSetup, Quality
from jauspy.robot.robot_files import load, robot_model
from jauspy_sim.gl_libraries import GL_PACKAGES, choose_gl, missing_gl
from jauspy_sim.rendering import cameras
from jauspy_sim.rendering.rays import DEFAULT_SKY_COLOUR, MAX_RAYS, MAX_RAYS_OF_STILL, RayRenderer, SkyBox
from jauspy_sim.robot import SimulatedRobot

FRONT = CameraSetup("front", "chassis_camera_link", math.radians(80.0))
ARM = CameraSetup("arm", "arm_camera_link", math.radians(80.0))


@pytest.fixture
def robot():
    opened = SimulatedRobot.open(dataclasses.replace(robot_model(load("inc1")), cameras=(FRONT, ARM)), "yard")
    yield opened
    opened.close()


@pytest.fixture(params=["rays", "GL"])
def eye(request, robot, monkeypatch):
    if request.param == "rays":
        monkeypatch.setenv("MUJOCO_GL", "disable")
    elif choose_gl() is None:
        pytest.skip("there is neither libegl1 nor libosmesa6")
    opened = pickle.loads(pickle.dumps(robot.cameras["front"])).open()
    if request.param == "GL" and "rays" in opened.description:
        pytest.skip("GL does not work here")
    yield opened
    opened.close()


def red(image):
    """Where the picture is red, as the cylinder on the table is."""
    channels = image.astype(int)
    return (channels[..., 0] > 2 * channels[..., 1]) & (channels[..., 0] > 2 * channels[..., 2])


def expected(robot, position, width, height):
    """The pixel at which a point of the world is to be seen."""
    number = robot.cameras["front"].number
    x, y, z = robot.data.cam_xmat[number].reshape(3, 3).T @ (position - robot.data.cam_xpos[number])
    focal = width / 2.0 / math.tan(FRONT.fov / 2.0)
    return width / 2.0 - focal * x / z, height / 2.0 + focal * y / z


@pytest.mark.slow
def test_object_appears_at_its_position(robot, eye):
    image = eye.look(640, 480).image
    assert image.shape == (480, 640, 3)
    rows, columns = np.nonzero(red(image))
    (thing,) = np.flatnonzero(robot.model.geom_matid == robot.model.mat("tin").id)
    column, row = expected(robot, robot.data.geom_xpos[thing], 640, 480)
    assert columns.mean() == pytest.approx(column, abs=12.0)
    assert rows.mean() == pytest.approx(row, abs=12.0)


@pytest.mark.slow
def test_depths_match_floor_and_objects(robot, eye):
    frame = eye.measure(160, 120)
    assert frame.image.shape == (120, 160, 3)
    (thing,) = np.flatnonzero(robot.model.geom_matid == robot.model.mat("tin").id)
    number = robot.cameras["front"].number
    at, turn = robot.data.cam_xpos[number], robot.data.cam_xmat[number].reshape(3, 3)
    ahead = -(turn.T @ (robot.data.geom_xpos[thing] - at))[2]
    radius = robot.model.geom_size[thing][0]
    found = frame.distances[red(frame.image)]
    assert ahead - 1.1 * radius < np.median(found) < ahead, "its front is nearer than its middle"
    lowest = frame.distances[-1]
    down = (119.5 - 59.5) / 80.0 * math.tan(FRONT.fov / 2.0)
    assert lowest == pytest.approx(np.full(160, at[2] / down), rel=0.02), "the floor before the robot"
    assert np.isinf(frame.distances[0]).any(), "the sky is nowhere"


@pytest.mark.slow
def test_image_shows_the_state_after_the_last_step(robot, eye):
    before = eye.look(160, 120)
    robot.drive.set_effort(0.0, 0.5)
    robot.advance(1.0)
    after = eye.look(160, 120)
    assert after.taken > before.taken
    assert (after.image != before.image).mean() > 0.1


@pytest.mark.slow
def test_sizes_change_from_picture_to_picture(eye):
    for width, height in ((128, 96), (1280, 720), (640, 350)):
        image = eye.look(width, height).image
        assert image.shape == (height, width, 3)
        assert image.std() > 10.0


@pytest.mark.slow
def test_rays_are_fewer_than_the_pixels_of_a_large_picture(robot, monkeypatch):
    painter = RayRenderer(robot.model, robot.cameras["front"].number, FRONT.fov)
    cast = []
    monkeypatch.setattr(
        painter, "_cast", lambda _, rays, __: cast.append(len(rays)) or (np.zeros((len(rays), 3), np.uint8), None)
    )
    painter.paint(robot.data, 1280, 720)
    painter.paint(robot.data, 100, 100)
    painter.paint(robot.data, 1280, 720, thoroughly=True)
    assert cast[0] <= MAX_RAYS * 1.02
    assert cast[1] == 10_000
    assert MAX_RAYS < cast[2] <= MAX_RAYS_OF_STILL * 1.02


@pytest.mark.slow
def test_failing_gl_falls_back_to_ray_casting_with_a_warning(robot, monkeypatch, caplog):
    monkeypatch.setattr(cameras, "choose_gl", lambda: "no_such_way")
    eye = robot.cameras["arm"].open()
    assert "casts rays" in eye.description
    assert eye.reduced
    assert "no_such_way does not work here" in caplog.text
    eye.close()


@pytest.mark.parametrize(
    ("set_to", "chosen"), [("disable", None), ("osmesa", "osmesa"), ("EGL", "egl"), ("glfw", None)]
)
def test_mujoco_gl_selects_the_library(monkeypatch, set_to, chosen):
    monkeypatch.setenv("MUJOCO_GL", set_to)
    assert choose_gl() == chosen


@pytest.mark.slow
@pytest.mark.parametrize("way", [pytest.param("egl", marks=pytest.mark.slow), "osmesa"])
def test_each_gl_library_renders(way):
    """In a process of its own: one process has one way, and the other tests here have EGL where there is one."""
    if missing_gl(way):
        pytest.skip(f"{GL_PACKAGES[way]} is not installed")
    code = (
        "from jauspy.robot.robot_files import robot_model; from jauspy.robot.robot_files import load;"
        "from jauspy_sim.robot import SimulatedRobot;"
        "robot = SimulatedRobot.open(robot_model(load('inc1')), 'empty'); eye = robot.cameras['chassis'].open();"
        "print(eye.look(320, 240).image.std() > 10.0, eye.description)"
    )
    environment = {**os.environ, "MUJOCO_GL": way}
    environment.pop("PYOPENGL_PLATFORM", None)  # which pictures taken in this process have left there
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment)
    if "casts rays" in run.stdout:
        pytest.skip(f"{way} does not work here")
    assert run.stdout.startswith(f"True renders with {way.upper()}\n"), run.stdout


@pytest.mark.slow
def test_rendering_does_not_change_the_trajectory():
    def trajectory(*cameras):
        robot = SimulatedRobot.open(dataclasses.replace(robot_model(load("inc1")), cameras=cameras), "yard")
        robot.drive.set_effort(0.4, 0.2)
        robot.advance(1.0)
        robot.close()
        return robot.drive.pose()

    assert trajectory() == trajectory(FRONT, ARM)


@pytest.mark.slow
def test_images_are_not_rendered_in_the_robot_process():
    """Importing and running the backend loads neither GL nor the packages of the extra `video`."""
    code = (
        "import sys; from jauspy.robot.robot_files import robot_model; from jauspy.robot.robot_files import load;"
        "from jauspy_sim.robot import SimulatedRobot; SimulatedRobot.open(robot_model(load('inc1')), 'yard');"
        "print(sorted({'OpenGL', 'av', 'cv2'} & set(sys.modules)))"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=os.environ)
    assert run.stdout == "[]\n"


# --- what it looks like


def eyes(robot, name, monkeypatch):
    """By rays, and by GL."""
    if choose_gl() is None:
        pytest.skip("there is neither libegl1 nor libosmesa6")
    by_gl = robot.cameras[name].open()
    if "rays" in by_gl.description:
        pytest.skip("GL does not work here")
    monkeypatch.setenv("MUJOCO_GL", "disable")
    return robot.cameras[name].open(), by_gl


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "world"), sampled([(n, w) for w in ("yard", "empty", "rough") for n in ("front", "arm")], 2, several=True)
)
def test_ray_casting_and_gl_agree(world, name, monkeypatch):
    """Sky, floor, lights, and the gripper, which is near and of simple shapes to rays; edges and what is far differ.

    So does what is only drawn: in the yard paint, plants, and the front of the workshop.
    """
    model = dataclasses.replace(robot_model(load("inc1")), cameras=(FRONT, ARM), quality=Quality.LOW)
    robot = SimulatedRobot.open(model, world)
    seen = [eye.look(160, 120).image.astype(int) for eye in eyes(robot, name, monkeypatch)]
    robot.close()
    different = np.abs(seen[0] - seen[1]).max(axis=2) > 24
    assert different.mean() < (0.3 if world == "yard" else 0.2 if name == "arm" else 0.1)
    if (name, world) != ("arm", "yard"):  # there the workshop is before the sky
        sky = seen[0][2, 80]
        assert sky[2] > sky[1] > sky[0] > 80
        assert np.abs(seen[1][2, 80] - sky).max() < 16


def test_a_gradient_of_the_sky_is_lighter_towards_the_horizon():
    texture = '<texture type="skybox" builtin="gradient" rgb1="0.36 0.56 0.82" rgb2="1 1 0.94" width="256"/>'
    sky = SkyBox(mujoco.MjModel.from_xml_string(f"<mujoco><asset>{texture}</asset></mujoco>"))
    up, slanting, level, down = sky.colours(np.array([[0, 0, 1], [0.6, 0, 0.8], [0, 1, 0], [0, 0, -1]], float)).sum(1)
    assert up < slanting < level < down


def test_world_without_sky_box_has_the_default_sky():
    model = mujoco.MjModel.from_xml_string("<mujoco><worldbody><geom size='1'/></worldbody></mujoco>")
    assert (SkyBox(model).colours(np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])) == DEFAULT_SKY_COLOUR).all()


def test_ray_casting_shows_the_floor_pattern_unless_too_fine(monkeypatch):
    monkeypatch.setenv("MUJOCO_GL", "disable")
    robot = SimulatedRobot.open(dataclasses.replace(robot_model(load("inc1")), cameras=(FRONT,)), "empty")
    eye = robot.cameras["front"].open()
    rows = eye.look(160, 120).image.astype(int).sum(axis=2)
    eye.close()
    robot.close()
    near, far = rows[-2], rows[62]
    assert np.ptp(near) > 0.08 * near.mean()
    assert np.ptp(far) < 0.04 * far.mean()
