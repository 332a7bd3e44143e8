"""Point clouds of a depth camera: a worker process (`run`) measures, computes points and publishes them."""

from __future__ import annotations

import math
import time
from collections import Counter
from dataclasses import dataclass
from typing import Annotated, Final

from annotated_types import Interval

from jauspy.cloud.stream import MAX_POINTS, XYZ_RGB, CloudPublisher
from jauspy.logs import get_logger
from jauspy.platform.camera import CameraSession, CameraSource, DepthFrame
from jauspy.platform.tables import Table, check_order
from jauspy.worker_process import CountersReport, Parent, SupervisedWorker, WorkerReady

NICENESS: Final = 5
"""Nice value above that of the robot's process, so that clouds never delay control."""

_LOG: Final = get_logger("jauspy.cloud")


@dataclass(frozen=True, slots=True)
class DepthSettings(Table):
    """Point clouds of a depth camera: the table `depth`."""

    size: tuple[Annotated[int, Interval(ge=16, le=1920)], Annotated[int, Interval(ge=16, le=1080)]] = (400, 250)
    """Pixels across and down that are measured: each one with something in range becomes a point."""
    rate: Annotated[float, Interval(gt=0.0, le=60.0)] = 10.0
    """Clouds per second."""
    range: tuple[Annotated[float, Interval(ge=0.0)], Annotated[float, Interval(gt=0.0, le=1000.0)]] = (0.2, 10.0)
    """Minimal and maximal distance along the camera's x axis, in metres."""

    def __post_init__(self) -> None:
        check_order("range", self.range, "the minimal and then the maximal distance")
        if math.prod(self.size) > MAX_POINTS:
            raise ValueError(f"size: {list(self.size)} are too many points for one message; it has {MAX_POINTS}")


@dataclass(frozen=True, slots=True)
class DepthStream:
    """A camera and the address at which its clouds are published."""

    camera: CameraSource
    settings: DepthSettings
    address: str


class DepthProcess(SupervisedWorker):
    """Publishes clouds between `open` and `close`.

    Counters: clouds `published`, their `points`, clouds `skipped` because the worker was too slow, workers `started`.
    """

    def __init__(self, stream: DepthStream) -> None:
        super().__init__("jauspy.cloud.depth", NICENESS, f"depth camera {stream.camera.setup.name}", _LOG)
        self._stream = stream

    async def open(self) -> None:
        """Start; without effect when open.

        Raises `ConfigError` without pynng, `TransportError` when the address cannot be used.
        """
        if self._task is None:
            CloudPublisher(self._stream.address).close()
            self._supervise()

    @property
    def _descriptors(self) -> tuple[int, ...]:
        return self._stream.camera.descriptors

    def _on_started(self) -> None:
        self._send(self._stream)


COUNTER_INTERVAL: Final = 1.0
"""Seconds between two reports of the counters."""


def run(stream: DepthStream, parent: Parent) -> None:
    """Publish clouds until the parent closes the connection."""
    with CloudPublisher(stream.address) as publisher:
        camera = stream.camera.open()
        try:
            parent.send(WorkerReady(camera.description))
            _publish(stream, camera, publisher, parent)
        finally:
            camera.close()


def _publish(stream: DepthStream, camera: CameraSession, publisher: CloudPublisher, parent: Parent) -> None:
    counters: Counter[str] = Counter()
    period = 1.0 / stream.settings.rate
    due = reported_at = time.monotonic()
    while True:
        for _ in parent.receive(max(0.0, due - time.monotonic())):
            pass
        if parent.ended:
            return
        skipped = max(0, int((time.monotonic() - due) / period))
        due += period * (1 + skipped)
        counters["skipped"] += skipped
        counters["points"] += _publish_cloud(stream, camera, publisher)
        counters["published"] += 1
        if time.monotonic() - reported_at >= COUNTER_INTERVAL:
            reported_at = time.monotonic()
            parent.send(CountersReport(dict(counters)))


def _publish_cloud(stream: DepthStream, camera: CameraSession, publisher: CloudPublisher) -> int:
    """Publish one cloud; returns its number of points."""
    setup, settings = stream.camera.setup, stream.settings
    frame = camera.measure(*settings.size)
    points = coloured_points(frame, setup.fov, settings)
    age = time.monotonic() - frame.taken
    publisher.publish(points, setup.link, time.time() - age, XYZ_RGB)
    return len(points) // (4 * XYZ_RGB)


def coloured_points(frame: DepthFrame, fov: float, settings: DepthSettings) -> bytes:
    """The pixels in range as points, in the frame of the camera's link.

    `fov` is the horizontal field of view in radians. Returns float32 rows of shape (points, 6): x, y, z in metres, and
    red, green, blue from 0 to 1.
    """
    import numpy as np  # noqa: PLC0415 - comes with the extra `cloud`

    distances = frame.distances
    rows, columns = np.nonzero((distances >= settings.range[0]) & (distances <= settings.range[1]))
    height, width = distances.shape
    pixel = 2.0 * math.tan(fov / 2.0) / width
    points = np.empty((len(rows), 6), "<f4")
    points[:, 0] = x = distances[rows, columns]
    points[:, 1] = x * (pixel * ((width - 1) / 2.0 - columns))
    points[:, 2] = x * (pixel * ((height - 1) / 2.0 - rows))
    points[:, 3:] = frame.image[rows, columns] * np.float32(1.0 / 255.0)
    return points.tobytes()
