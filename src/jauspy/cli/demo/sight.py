"""Finds the red can in a picture, and where it stands."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import cv2
import numpy as np

from jauspy.errors import RequestError
from jauspy.geometry.poses import Transform
from jauspy.geometry.vectors import Vector, difference

if TYPE_CHECKING:
    from jauspy.platform.camera import Image

REDS: Final = (((0, 140, 40), (8, 255, 255)), ((172, 140, 40), (180, 255, 255)))
"""Hue (in OpenCV's 180 steps), saturation and value, from and to: red is at both ends. Bricks are less saturated."""
LEAST: Final = 2e-4
"""Share of the picture that a spot must have."""


def picture(file: bytes) -> Image:
    """The picture in a JPEG or PNG: red, green and blue."""
    read = cv2.imdecode(np.frombuffer(file, np.uint8), cv2.IMREAD_COLOR)
    if read is None:
        raise RequestError(f"{len(file)} bytes came as a still image, and they are none")
    return cv2.cvtColor(read, cv2.COLOR_BGR2RGB).astype(np.uint8)


def red_spot(image: Image) -> tuple[float, float] | None:
    """Column and row of the middle of the largest red spot, as fractions of the width; None when there is none."""
    colours = cv2.cvtColor(image, cv2.COLOR_RGB2HSV)
    red = np.zeros(image.shape[:2], np.uint8)
    for low, high in REDS:
        red |= cv2.inRange(colours, np.array(low), np.array(high)).astype(np.uint8)
    _, spots, sizes, middles = cv2.connectedComponentsWithStats(red)
    if len(sizes) < 2:
        return None
    largest = 1 + int(np.argmax(sizes[1:, cv2.CC_STAT_AREA]))
    if sizes[largest, cv2.CC_STAT_AREA] < LEAST * red.size:
        return None
    height, width = spots.shape[:2]
    column, row = (float(value) for value in middles[largest])
    return (column + 0.5 - width / 2.0) / width, (row + 0.5 - height / 2.0) / width


def ray(spot: tuple[float, float], fov: float) -> Vector:
    """The direction of a spot in the camera's frame: x is where it looks, y left, z up. `fov`: from left to right."""
    spread = 2.0 * math.tan(fov / 2.0)
    return 1.0, -spread * spot[0], -spread * spot[1]


def at_height(camera: Transform, direction: Vector, height: float) -> Vector | None:
    """Where a ray from the camera comes through that height; None when it never does."""
    far = difference(camera.apply(direction), camera.position)
    if far[2] >= 0.0 or camera.position[2] <= height:
        return None
    times = (height - camera.position[2]) / far[2]
    return camera.position[0] + times * far[0], camera.position[1] + times * far[1], height
