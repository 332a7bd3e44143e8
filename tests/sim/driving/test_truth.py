"""The truth about drives, of a box in a small world: heights, contacts, the way, and what a depth camera sees."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco
import numpy as np

from jauspy.errors import ConfigError
from jauspy.geometry.poses import Pose
from jauspy_sim.driving.true_heights import ABOVE
from jauspy_sim.driving.truth import DrivingTruth

STEP = 0.2
SHAPES = """
  <geom name="floor" type="plane" size="0 0 1"/>
  <geom name="wall" type="box" pos="2.0 0 0.5" size="0.2 2.0 0.5"/>
  <geom name="door" type="box" pos="-3.0 0 0.5" size="0.01 1.0 0.5"/>
  <geom name="shelf" type="box" pos="0 -4 1.0" size="0.5 0.5 0.02"/>
  <geom name="step" type="box" pos="-5 5 0.05" size="1 1 0.05"/>
  <geom name="fence" type="box" pos="-5.02 5 0.5" size="0.01 0.5 0.5"/>
  <geom name="above the shop" type="box" pos="7.0 -4 5.0" size="0.15 0.5 2.0"/>
  <geom name="shop" type="box" pos="7.0 -4 1.5" size="0.15 0.5 1.5"/>
  <geom name="kerb" type="box" pos="12 8 0.05" size="1 1 0.05"/>
  <geom name="tower" type="box" pos="5 -4 3.5" size="0.3 0.3 3.5"/>
"""
CRATE = '<body name="crate" pos="5 5 0.2"><freejoint/><geom type="box" size="0.2 0.2 0.2"/></body>'
ROBOT = """
  <body name="me/base" pos="0 0 0.11">
    <joint name="x" type="slide" axis="1 0 0"/><joint name="y" type="slide" axis="0 1 0"/>
    <joint name="z" type="slide" axis="0 0 1"/>
    <geom type="box" size="0.3 0.2 0.1" mass="10" friction="0.1"/>
    <body name="me/camera" pos="0.3 0 0.1"/>
  </body>
"""


class Box:
    """A robot that is a box, and slides as fast as it is told to."""

    def __init__(self, *things: str) -> None:
        self._model = mujoco.MjModel.from_xml_string(
            f"<mujoco><worldbody>{SHAPES}{''.join(things)}{ROBOT}</worldbody></mujoco>"
        )
        self._data = mujoco.MjData(self._model)
        mujoco.mj_forward(self._model, self._data)
        self.truth = DrivingTruth(self._model, self._data, "me/", self.pose, STEP)

    def pose(self) -> Pose:
        x, y, z = self._data.body("me/base").xpos.tolist()
        return Pose(x, y, z - 0.11)

    def slide(self, vx: float, vy: float, seconds: float) -> None:
        for _ in range(round(seconds / 0.002)):
            self._data.joint("x").qvel, self._data.joint("y").qvel = vx, vy
            mujoco.mj_step(self._model, self._data)
            self.truth.watch.step(self._data.time)


@pytest.fixture(scope="module")
def still() -> Box:
    return Box(CRATE)


def height(box: Box, x: float, y: float) -> float:
    heights = box.truth.heights
    column, row = (
        math.floor((value - low) / heights.resolution) for value, low in zip((x, y), heights.origin, strict=True)
    )
    return float(heights.heights[row, column])


@pytest.mark.parametrize(
    ("x", "y", "wanted"),
    [
        (8.0, 8.0, 0.0),
        (2.0, 1.0, 1.0),
        (-5.5, 5.0, 0.1),
        (-2.99, 0.0, ABOVE),
        (0.0, -4.0, 0.0),
        (0.0, 0.0, 0.0),
        (5.0, 5.0, 0.4),
        (-5.02, 5.0, ABOVE),
        (5.0, -4.0, 7.0),
    ],
    ids=[
        *("floor", "wall", "step", "thin door", "below a shelf", "below the robot", "crate"),
        *("thin fence on a step", "wall higher than 4 m"),
    ],
)
def test_heights_of_the_world_without_the_robot(still: Box, x: float, y: float, wanted: float) -> None:
    assert height(still, x, y) == pytest.approx(wanted, abs=1e-3)


def test_a_wall_on_which_another_one_stands_is_an_obstacle(still: Box) -> None:
    assert height(still, 7.05, -4.0) > 2.9
    assert height(still, 7.25, -4.0) == pytest.approx(0.0, abs=1e-3)


def test_heights_beyond_the_border_of_the_map_are_measured_where_they_are_needed(still: Box) -> None:
    heights = still.truth.heights
    assert heights.highest_around(2.0, 0.0) == pytest.approx(1.0, abs=1e-3)
    assert heights.highest_around(10.99, 8.0) == pytest.approx(0.1, abs=1e-3), "of the kerb, 1 cm away"
    assert heights.highest_around(11.05, 8.0) == pytest.approx(0.1, abs=1e-3)
    assert heights.highest_around(-14.0, 0.0) == pytest.approx(0.0, abs=1e-3)


def test_a_depth_camera_sees_the_wall_with_noise(still: Box) -> None:
    points = still.truth.depth_camera("camera", 3).look()
    assert points.dtype == np.float32
    ahead = points[(np.abs(points[:, 1]) < 0.3) & (np.abs(points[:, 2]) < 0.1)]
    assert len(ahead) > 20
    assert ahead[:, 0].mean() == pytest.approx(1.5, abs=0.005)
    assert 0.001 < ahead[:, 0].std() < 0.01
    again, other = (still.truth.depth_camera("camera", seed).look() for seed in (3, 4))
    assert np.array_equal(points, again)
    assert not np.array_equal(points, other)


def test_the_ground_is_not_touched_and_the_way_is_measured() -> None:
    box = Box()
    box.slide(1.0, 0.0, 0.5)
    assert (box.truth.way, box.truth.contacts) == (0.0, {}), "nothing is measured before the drive begins"
    box.truth.begin()
    box.slide(0.0, 1.0, 1.0)
    assert box.truth.way == pytest.approx(1.0, abs=0.06)
    assert box.truth.contacts == {}
    box.truth.begin()
    assert box.truth.way == 0.0


def test_a_wall_and_a_thing_are_touched_and_the_face_of_a_step_is_not() -> None:
    box = Box(CRATE)
    box.truth.begin()
    box.slide(1.0, 0.0, 2.0)
    assert set(box.truth.contacts) == {"wall"}
    box.slide(-1.0, 0.0, 0.5)
    box.truth.begin()
    box.slide(-1.0, 0.0, 0.2)
    assert box.truth.contacts == {}, "it has left the wall"
    here = box.pose()
    assert box.truth.put_thing(here.x, here.y + 0.5) == "crate"
    assert height(box, here.x, here.y + 0.5) == 0.0
    box.truth.measure_heights()
    assert height(box, here.x, here.y + 0.5) == pytest.approx(0.4, abs=1e-3)
    box.truth.begin()
    box.slide(0.0, 1.0, 0.5)
    assert box.truth.contacts["crate"] > 10
    climber = Box()
    climber.slide(-4.0, 0.0, 0.4)
    climber.slide(0.0, 5.0, 1.0)
    climber.truth.begin()
    climber.slide(-2.0, 0.0, 1.1)
    assert -3.85 < climber.pose().x < -3.65, "it presses against the step"
    assert climber.truth.contacts == {}


def test_a_world_without_a_thing_says_so() -> None:
    with pytest.raises(ConfigError, match="nothing that could be put into the way: crate, bin, sofa"):
        Box().truth.put_thing(1.0, 0.0)
