"""The quality of rendered pictures: shadows, and what is left out when pictures take too long."""

from __future__ import annotations

import dataclasses
import math
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager

import pytest
from tests.helpers.sampling import sampled

pytest.importorskip("mujoco", reason="MuJoCo is not installed")
pytest.importorskip("cv2", reason="the extra 'video' is not installed")

from jauspy.platform.camera import CameraSetup, Quality
from jauspy.robot.robot_files import load, robot_model
from jauspy.video.imaging import Imaging
from jauspy_sim.gl_libraries import choose_gl
from jauspy_sim.robot import SimulatedRobot

FRONT = CameraSetup("front", "chassis_camera_link", math.radians(80.0))


@pytest.fixture(scope="module")
def robots():
    if choose_gl() is None:
        pytest.skip("there is neither libegl1 nor libosmesa6")
    model = dataclasses.replace(robot_model(load("inc1")), cameras=(FRONT,))
    opened = {quality: SimulatedRobot.open(dataclasses.replace(model, quality=quality), "house") for quality in Quality}
    yield opened
    for robot in opened.values():
        robot.close()


@contextmanager
def opened(robot):
    """A session; one at a time, because GL has one present context in a thread."""
    eye = robot.cameras["front"].open()
    if "rays" in eye.description:
        pytest.skip("GL does not work here")
    yield eye
    eye.close()


def seen(robot, eye):
    return Imaging(robot.cameras["front"].setup).take(eye, 320, 240).image.astype(int)


def picture(robot):
    with opened(robot) as eye:
        return seen(robot, eye)


@pytest.mark.slow
@pytest.mark.parametrize("quality", sampled([Quality.HIGH, Quality.MEDIUM], 1))
def test_shadows_are_darker_and_nothing_else_changes(robots, quality):
    plain, shaded = (picture(robots[each]).mean(axis=2) for each in (Quality.LOW, quality))
    darker = shaded < 0.85 * plain
    same = abs(shaded - plain) < 3.0
    assert 0.01 < darker.mean() < 0.5
    assert (darker | same).mean() > 0.9


@pytest.mark.slow
def test_both_ways_to_make_shadows_agree(robots):
    """MuJoCo's own, and those that are computed from depths."""
    plain, computed, drawn = (picture(robot).mean(axis=2) for robot in robots.values())
    dark = [each < 0.85 * plain for each in (computed, drawn)]
    both = dark[0] & dark[1]
    assert both.sum() > 0.7 * dark[0].sum()
    assert computed[both].mean() == pytest.approx(drawn[both].mean(), rel=0.15)


@pytest.mark.slow
def test_a_camera_that_is_too_slow_leaves_shadows_out_and_says_so(robots):
    plain = picture(robots[Quality.LOW])
    with opened(robots[Quality.MEDIUM]) as eye:
        assert not eye.reduced
        assert eye.simplifications == 1
        shaded, before = seen(robots[Quality.MEDIUM], eye), eye.description
        eye.simplify(1)
        assert eye.reduced
        assert eye.description == f"{before}, without shadows: better pictures take too long here"
        assert abs(seen(robots[Quality.MEDIUM], eye) - plain).mean() < 0.5
        eye.simplify(0)
        assert (eye.reduced, eye.description) == (False, before)
        assert abs(seen(robots[Quality.MEDIUM], eye) - shaded).mean() < 0.5


@pytest.mark.slow
@pytest.mark.parametrize(("quality", "count"), [(Quality.LOW, 0), (Quality.HIGH, 2)])
def test_the_number_of_lower_qualities(robots, quality, count):
    with opened(robots[quality]) as eye:
        assert eye.simplifications == count
        eye.simplify(5)
        assert eye.description.endswith("without shadows: better pictures take too long here") is (count > 0)


@pytest.mark.slow
def test_a_camera_goes_from_one_thread_to_the_next(robots):
    """The context of GL is current in one thread only."""
    robot = robots[Quality.MEDIUM]
    with opened(robot) as eye:
        first = seen(robot, eye)
        for _ in range(3):
            eye.release()
            with ThreadPoolExecutor(1) as thread:
                again = thread.submit(lambda: (seen(robot, eye), eye.release())).result(60)[0]
            assert (again == first).all()
        assert (seen(robot, eye) == first).all()
