"""Points that a depth camera sees, for a guard in the robot's process; a worker process (`run`) measures them."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from jauspy.logs import get_logger
from jauspy.platform.camera import CameraSession, CameraSource, DepthFrame
from jauspy.worker_process import Parent, SupervisedWorker, WorkerReady

NICENESS: Final = 5
"""Nice value above that of the robot's process."""
SIZE: Final = (64, 40)
"""Pixels across and down: at 1 m, one of 80 degrees is 3 cm wide."""
PERIOD: Final = 0.1
"""Seconds between two measurements."""

_LOG: Final = get_logger("jauspy.cloud")


@dataclass(frozen=True, slots=True)
class SightingStream:
    """A depth camera."""

    camera: CameraSource
    range: tuple[float, float]
    """Least and greatest distance along the camera's x axis, metres."""


@dataclass(frozen=True, slots=True)
class Seen:
    """The points of one measurement: float32 rows of x, y and z in the frame of the camera's link, metres."""

    points: bytes
    taken: float
    """When it was taken, in seconds of the machine's monotonic clock."""


class SightingProcess(SupervisedWorker):
    """Measures between `open` and `close`, and calls `on_seen` with points and their age in seconds."""

    def __init__(self, stream: SightingStream, on_seen: Callable[[bytes, float], None]) -> None:
        super().__init__("jauspy.cloud.sightings", NICENESS, f"sightings of {stream.camera.setup.name}", _LOG)
        self._stream, self._on_seen = stream, on_seen

    async def open(self) -> None:
        """Start; without effect when open."""
        self._supervise()

    @property
    def _descriptors(self) -> tuple[int, ...]:
        return self._stream.camera.descriptors

    def _on_started(self) -> None:
        self._send(self._stream)

    def _on_message(self, message: object) -> None:
        if isinstance(message, Seen):
            self._on_seen(message.points, max(0.0, time.monotonic() - message.taken))
        else:
            super()._on_message(message)


def run(stream: SightingStream, parent: Parent) -> None:
    """Send points until the parent closes the connection."""
    camera = stream.camera.open()
    try:
        parent.send(WorkerReady(camera.description))
        due = time.monotonic()
        while not parent.ended:
            for _ in parent.receive(max(0.0, due - time.monotonic())):
                pass
            if time.monotonic() >= due:
                due = max(due + PERIOD, time.monotonic())
                parent.send(look(camera, stream))
    finally:
        camera.close()


def look(camera: CameraSession, stream: SightingStream) -> Seen:
    """One measurement."""
    frame = camera.measure(*SIZE)
    return Seen(points(frame, stream.camera.setup.fov, stream.range), frame.taken)


def points(frame: DepthFrame, fov: float, reach: tuple[float, float]) -> bytes:
    """The pixels as points in the frame of the camera's link; `fov` is horizontal, in radians.

    Those nearer than `reach` metres are left out, and those beyond get its greatest distance: nothing is before them.
    """
    import numpy as np  # noqa: PLC0415 - only robots with a simulation or sensors have it

    distances = frame.distances
    rows, columns = np.nonzero(distances >= reach[0])
    height, width = distances.shape
    pixel = 2.0 * math.tan(fov / 2.0) / width
    x = np.minimum(distances[rows, columns], reach[1])
    y, z = x * (pixel * ((width - 1) / 2.0 - columns)), x * (pixel * ((height - 1) / 2.0 - rows))
    return np.stack((x, y, z), axis=1).astype("<f4").tobytes()
