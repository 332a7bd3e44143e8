"""A red can in a picture, and where it stands."""

import math

import pytest

pytest.importorskip("numpy", reason="NumPy is not installed")
pytest.importorskip("cv2", reason="OpenCV is not installed")

import cv2
import numpy as np

from jauspy.demo import grasp
from jauspy.geometry.poses import Pose, Transform

FOV = math.radians(80.0)
BRICK, CAN = (110, 70, 60), (120, 30, 24)


def scene(*rectangles):
    image = np.full((240, 320, 3), BRICK, np.uint8)
    for left, top, width, height in rectangles:
        image[top : top + height, left : left + width] = CAN
    return image


def test_largest_red_region_is_used() -> None:
    column, row = grasp.red_region(scene((10, 10, 3, 3), (200, 150, 20, 40)))
    assert (column, row) == (pytest.approx((210 - 160) / 320), pytest.approx((170 - 120) / 320))


def test_parts_of_one_thing_are_one_region() -> None:
    column, row = grasp.red_region(scene((100, 100, 20, 20), (130, 100, 20, 20), (300, 10, 18, 22)))
    assert (column, row) == (pytest.approx((125 - 160) / 320), pytest.approx((110 - 120) / 320))


def test_bricks_and_specks_are_ignored() -> None:
    assert grasp.red_region(scene()) is None
    assert grasp.red_region(scene((5, 5, 3, 3))) is None


def test_ray_intersects_at_the_position_of_the_can() -> None:
    camera = Transform.from_pose(Pose(1.0, 2.0, 0.8, pitch=0.3, yaw=0.5))
    can = (1.7, 2.6, 0.41)
    x, y, z = camera.inverse().apply(can)
    spread = 2.0 * math.tan(FOV / 2.0)
    point = (-y / x / spread, -z / x / spread)
    assert grasp.at_height(camera, grasp.ray(point, FOV), 0.41) == pytest.approx(can)


def test_height_of_a_can_is_measured_by_its_edges() -> None:
    """From above and obliquely, by a camera that is not level."""
    camera = Transform.from_pose(Pose(0.3, -0.1, 0.75, pitch=0.6, roll=0.01, yaw=0.2))
    ends = [camera.inverse().apply((0.85, 0.05, height)) for height in (0.36, 0.46)]
    low, high = ((1.0, y / x, z / x) for x, y, z in ends)
    assert grasp.lower_end(camera, low, high, 0.1) == pytest.approx(0.36, abs=1e-9)


@pytest.mark.parametrize("lean", [0, 6])
def test_ends_of_a_can_are_those_of_its_axis(lean: int) -> None:
    """A can that is not in the middle of the picture leans; its lower edge is round."""
    image = np.full((240, 320, 3), BRICK, np.uint8)
    corners = [(200, 100), (220, 100), (220 + lean, 140), (200 + lean, 140)]
    cv2.fillPoly(image, [np.array(corners, np.int32)], CAN)
    cv2.ellipse(image, (210 + lean, 140), (10, 4), 0.0, 0.0, 180.0, CAN, -1)
    (left, top), (right, bottom) = grasp.red_band(image)
    assert {type(each) for each in (left, top, right, bottom)} == {float}, "as figures of summary.json are"
    assert (top, bottom) == (pytest.approx((100 - 120) / 320), pytest.approx((145 - 120) / 320))
    assert (left, right) == pytest.approx(((210.5 - 160) / 320, (210.5 + lean - 160) / 320), abs=1.0 / 320)
    assert grasp.red_band(scene()) is None


def test_upward_ray_has_no_intersection() -> None:
    assert grasp.at_height(Transform.from_pose(Pose(z=0.8)), grasp.ray((0.0, -0.1), FOV), 0.41) is None
    assert grasp.at_height(Transform.from_pose(Pose(z=0.3)), grasp.ray((0.0, 0.1), FOV), 0.41) is None
