"""Publishes the scans of a robot's lidars and the images of its depth cameras as point clouds."""

from __future__ import annotations

import asyncio
import math
import struct
import time
from collections import Counter
from collections.abc import AsyncIterator, Iterable, Mapping
from contextlib import AsyncExitStack, asynccontextmanager, suppress
from typing import Final, Protocol

from jauspy.cloud.depth import DepthProcess, DepthStream
from jauspy.cloud.socket import CloudPublisher
from jauspy.errors import ConfigError
from jauspy.modules.config import RobotConfig
from jauspy.platform.camera import Camera
from jauspy.platform.ranging import RangeFinder, RangeScan

POLL_INTERVAL: Final = 0.02
"""Seconds between two checks for a new scan."""


class SensorSource(Protocol):
    """The lidars and cameras of a running robot."""

    @property
    def config(self) -> RobotConfig:
        """The configuration of the robot."""
        ...

    @property
    def lidars(self) -> Mapping[str, RangeFinder]:
        """The lidars, by name."""
        ...

    @property
    def cameras(self) -> Mapping[str, Camera]:
        """The cameras, by name."""
        ...


class Clouds:
    """The addresses at which a robot's clouds are published.

    `requested`: an address, as in `tcp://127.0.0.1:5565`, for the scans of all lidars, and `CAMERA=ADDRESS` for the
    clouds of each depth camera. `ConfigError` for a camera without depth, or for an address that occurs twice.
    """

    def __init__(self, config: RobotConfig, requested: Iterable[str]) -> None:
        pairs = [_camera_and_address(each) for each in requested]
        for name, address in pairs:
            if [other for _, other in pairs].count(address) > 1:
                raise ConfigError(f"--cloud: {address} is there twice; each stream needs an address of its own")
            if [other for other, _ in pairs].count(name) > 1:
                raise ConfigError(f"--cloud: {name or 'the lidars'} would be published twice; one address is enough")
        self._addresses = dict(pairs)
        self._settings = {each.name: each.depth.settings() for each in config.cameras if each.depth is not None}
        for name in self._addresses:
            if name and name not in self._settings:
                known = ", ".join(self._settings) or "none"
                raise ConfigError(
                    f"--cloud: {name!r} is no camera with `depth` in the robot's file; those are: {known}"
                )
        self._processes: dict[str, DepthProcess] = {}

    @property
    def counters(self) -> Mapping[str, int]:
        """The counters of the depth cameras, with their names as prefix."""
        counted = ((f"cloud.{name}", process.counters) for name, process in self._processes.items())
        return Counter({f"{name}.{what}": count for name, found in counted for what, count in found.items()})

    @asynccontextmanager
    async def published(self, robot: SensorSource) -> AsyncIterator[None]:
        """Publish within the context; raises `TransportError` if an address cannot be used."""
        async with AsyncExitStack() as stack:
            for name, address in self._addresses.items():
                if name:
                    depth = DepthStream(robot.cameras[name], self._settings[name], address)
                    self._processes[name] = await stack.enter_async_context(DepthProcess(depth))
                else:
                    publisher = stack.enter_context(CloudPublisher(address))
                    stack.push_async_callback(_stop, asyncio.create_task(stream(robot.lidars, publisher)))
            yield


def _camera_and_address(text: str) -> tuple[str, str]:
    name, equals, address = text.partition("=")
    return (name, address) if equals and "/" not in name else ("", text)


async def stream(lidars: Mapping[str, RangeFinder], publisher: CloudPublisher) -> None:
    """Publish every new scan, in the frame of the lidar's link, until cancelled."""
    sent: dict[str, RangeScan | None] = {}
    while True:
        for name, lidar in lidars.items():
            scan = lidar.scan
            if scan is not None and scan is not sent.get(name):
                sent[name] = scan
                publisher.publish(points(scan), scan.frame, time.time() - lidar.age)
        await asyncio.sleep(POLL_INTERVAL)


def points(scan: RangeScan) -> bytes:
    """Return the end points of the rays with an echo, in the lidar's frame: x, y, z as float32, little-endian."""
    rays = zip(scan.angles, scan.ranges, strict=True)
    ends = [(far * math.cos(angle), far * math.sin(angle), 0.0) for angle, far in rays if math.isfinite(far)]
    return struct.pack(f"<{3 * len(ends)}f", *(value for end in ends for value in end))


async def _stop(task: asyncio.Task[None]) -> None:
    """Cancel the task; raises the error that ended it, if any."""
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task
