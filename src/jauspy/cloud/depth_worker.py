"""The process of a depth camera's clouds, started by `depth_process`: looks, measures, publishes.

Standard input brings what to publish, and ends when the robot's process does; on standard output it says, as lines of
JSON, how it comes to its pictures and what it has counted.
"""

from __future__ import annotations

import json
import math
import os
import pickle
import select
import sys
import time
from collections import Counter
from collections.abc import Callable
from typing import Final, TypeAlias

import numpy as np

from jauspy.cloud.depth import DepthSettings, DepthStream
from jauspy.cloud.message import XYZ_RGB
from jauspy.cloud.socket import CloudPublisher
from jauspy.platform.camera import DepthFrame, Eye
from jauspy.workers import give_way


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


POLITENESS: Final = 5
"""By how much it is nicer than the robot's process: clouds never delay control."""

COUNTER_INTERVAL: Final = 1.0
"""Seconds between two reports of the counters."""

Say: TypeAlias = Callable[[dict[str, object]], None]
"""Tells the robot's process something."""


def main() -> None:
    """Publish until standard input ends."""
    say = _speaker()
    give_way(POLITENESS)
    source = sys.stdin.buffer
    stream = pickle.load(source)  # noqa: S301 - the robot's process wrote it
    if not isinstance(stream, DepthStream):
        raise TypeError(f"{type(stream)} is not a DepthStream")
    with CloudPublisher(stream.address) as publisher:
        eye = stream.camera.open()
        try:
            say({"description": eye.description})
            _publish(stream, eye, publisher, source.fileno(), say)
        finally:
            eye.close()


def _publish(stream: DepthStream, eye: Eye, publisher: CloudPublisher, source: int, say: Say) -> None:
    counters: Counter[str] = Counter()
    period = 1.0 / stream.settings.rate
    due = told = time.monotonic()
    while not select.select([source], [], [], max(0.0, due - time.monotonic()))[0]:
        late = max(0, int((time.monotonic() - due) / period))
        due += period * (1 + late)
        counters["skipped"] += late
        counters["points"] += _look(stream, eye, publisher)
        counters["published"] += 1
        if time.monotonic() - told >= COUNTER_INTERVAL:
            told = time.monotonic()
            say({"counters": counters})


def _look(stream: DepthStream, eye: Eye, publisher: CloudPublisher) -> int:
    """Publish one cloud; how many points it has."""
    setup, settings = stream.camera.setup, stream.settings
    frame = eye.measure(settings.width, settings.height)
    points = coloured_points(frame, setup.fov, settings)
    age = time.monotonic() - frame.taken
    publisher.publish(points, setup.link, time.time() - age, XYZ_RGB)
    return len(points) // (4 * XYZ_RGB)


def _speaker() -> Say:
    """Standard output for these lines alone; what libraries print goes to standard error."""
    out = os.fdopen(os.dup(sys.stdout.fileno()), "w", buffering=1)
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    return lambda words: print(json.dumps(words), file=out)


if __name__ == "__main__":
    try:
        main()
    except BrokenPipeError:  # nobody is there to hear
        sys.exit()
