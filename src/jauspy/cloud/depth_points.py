"""Coloured points out of what a depth camera measures. Needs NumPy."""

from __future__ import annotations

import math

import numpy as np

from jauspy.cloud.depth import DepthSettings
from jauspy.platform.camera import DepthFrame


def coloured_points(frame: DepthFrame, fov: float, settings: DepthSettings) -> bytes:
    """The pixels within range as rows of x, y, z, red, green, blue in float32, in the frame of the camera's link.

    `fov`: from the left edge of the picture to the right one, radians.
    """
    along = frame.distances
    rows, columns = np.nonzero((along >= settings.least) & (along <= settings.most))
    height, width = along.shape
    pixel = 2.0 * math.tan(fov / 2.0) / width
    points = np.empty((len(rows), 6), "<f4")
    points[:, 0] = x = along[rows, columns]
    points[:, 1] = x * (pixel * ((width - 1) / 2.0 - columns))
    points[:, 2] = x * (pixel * ((height - 1) / 2.0 - rows))
    points[:, 3:] = frame.image[rows, columns] * np.float32(1.0 / 255.0)
    return points.tobytes()
