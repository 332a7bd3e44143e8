"""Point clouds of a depth camera, published by a worker process."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from jauspy.cloud.socket import CloudPublisher
from jauspy.logs import get_logger
from jauspy.platform.camera import Camera
from jauspy.worker_process import SupervisedWorker

NICENESS: Final = 5
"""Nice value above that of the robot's process, so that clouds never delay control."""

_LOG: Final = get_logger("jauspy.cloud")


@dataclass(frozen=True, slots=True)
class DepthSettings:
    """Settings of the clouds of a camera."""

    width: int = 400
    height: int = 250
    """Pixels that are measured: each one with something in range becomes a point."""
    rate: float = 10.0
    """Clouds per second."""
    min_distance: float = 0.2
    max_distance: float = 10.0
    """Range of distances along the camera's x axis, in metres."""


@dataclass(frozen=True, slots=True)
class DepthStream:
    """A camera and the address at which its clouds are published."""

    camera: Camera
    settings: DepthSettings
    address: str


class DepthProcess(SupervisedWorker):
    """Publishes clouds between `open` and `close`.

    Counters: clouds `published`, their `points`, clouds `skipped` because the worker was too slow, workers `started`.
    """

    def __init__(self, stream: DepthStream) -> None:
        super().__init__("jauspy.cloud.depth_worker", NICENESS, f"depth camera {stream.camera.setup.name}", _LOG)
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
