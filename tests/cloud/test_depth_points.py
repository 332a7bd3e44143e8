"""Coloured points out of distances."""

from __future__ import annotations

import math

import pytest

pytest.importorskip("numpy", reason="the extra 'cloud' is not installed")

import numpy as np

from jauspy.cloud.depth import DepthSettings, coloured_points
from jauspy.platform.camera import DepthFrame

FOV = math.radians(90.0)
"""A picture four pixels wide spans 2 m at a distance of 1 m: half a metre for each."""


def points(distances: object, image: object = None, **settings: float) -> object:
    distances = np.array(distances, np.float32)
    picture = np.zeros((*distances.shape, 3), np.uint8) if image is None else np.array(image, np.uint8)
    found = coloured_points(DepthFrame(picture, distances, 0.0), FOV, DepthSettings(**settings))
    return np.frombuffer(found, "<f4").reshape(-1, 6)


def test_pixel_centres_left_and_up_are_positive() -> None:
    found = points([[2.0, 2.0, 2.0, 4.0], [1.0, 1.0, 1.0, 1.0]])
    assert found[0, :3] == pytest.approx((2.0, 1.5, 0.5)), "upper left"
    assert found[3, :3] == pytest.approx((4.0, -3.0, 1.0)), "upper right, twice as far"
    assert found[4, :3] == pytest.approx((1.0, 0.75, -0.25)), "lower left"


def test_pixels_out_of_range_give_no_points() -> None:
    found = points([[math.inf, 0.4, 0.5, 5.0, 5.1, math.inf]], range=(0.5, 5.0))
    assert found[:, 0].tolist() == [0.5, 5.0]


def test_colours_are_from_0_to_1() -> None:
    found = points([[1.0, 1.0]], [[[255, 0, 51], [0, 102, 0]]])
    assert found[0, 3:] == pytest.approx((1.0, 0.0, 0.2))
    assert found[1, 3:] == pytest.approx((0.0, 0.4, 0.0))
