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
from jauspy.cloud.stream import CloudPublisher
from jauspy.errors import ConfigError
from jauspy.platform.camera import CameraSource
from jauspy.platform.ranging import RangeFinder, RangeScan
from jauspy.robot.config import RobotConfig

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
    def cameras(self) -> Mapping[str, CameraSource]:
        """The cameras, by name."""
        ...


class Clouds:
    """The addresses at which a robot's clouds are published.

    `requested`: an address, as in `tcp://127.0.0.1:5565`, for the scans of all lidars, and `NAME=ADDRESS` for those of
    one lidar, or the clouds of one depth camera; besides the `[[clouds]]` of the file, whose address it replaces.
    `ConfigError` for a name that is neither, or for an address that occurs twice.
    """

    def __init__(self, config: RobotConfig, requested: Iterable[str]) -> None:
        asked = [_name_and_address(text) for text in requested]
        named = {name for name, _ in asked}
        pairs = [*asked, *((cloud.source, cloud.address) for cloud in config.clouds if cloud.source not in named)]
        for name, address in pairs:
            if [other for _, other in pairs].count(address) > 1:
                raise ConfigError(f"--cloud: {address} is there twice; each stream needs its own address")
            if [other for other, _ in pairs].count(name) > 1:
                raise ConfigError(f"--cloud: {name or 'the lidars'} would be published twice; one address is enough")
        self._addresses = dict(pairs)
        self._settings = {camera.name: camera.depth for camera in config.cameras if camera.depth is not None}
        self._lidars = frozenset(lidar.name for lidar in config.lidars)
        for name in self._addresses:
            if name and name not in self._settings and name not in self._lidars:
                lidars, cameras = (", ".join(sorted(known)) or "none" for known in (self._lidars, self._settings))
                raise ConfigError(
                    f"--cloud: {name!r} is no lidar ({lidars}) and no camera with `depth` ({cameras}) in its file"
                )
            if name in self._settings and name in self._lidars:
                raise ConfigError(f"--cloud: {name!r} is a lidar and a camera; give one of them another name")
        self._processes: dict[str, DepthProcess] = {}

    @property
    def addresses(self) -> Mapping[str, str]:
        """Addresses by source; those of all lidars have the empty name."""
        return dict(self._addresses)

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
                if name in self._settings:
                    depth = DepthStream(robot.cameras[name], self._settings[name], address)
                    self._processes[name] = await stack.enter_async_context(DepthProcess(depth))
                else:
                    publisher = stack.enter_context(CloudPublisher(address))
                    lidars = {name: robot.lidars[name]} if name else robot.lidars
                    stack.push_async_callback(_stop, asyncio.create_task(stream(lidars, publisher)))
            yield


def _name_and_address(text: str) -> tuple[str, str]:
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
    if scan.layers:
        return _layered_points(scan)
    rays = zip(scan.angles, scan.ranges, strict=True)
    ends = [(far * math.cos(angle), far * math.sin(angle), 0.0) for angle, far in rays if math.isfinite(far)]
    return struct.pack(f"<{3 * len(ends)}f", *(value for end in ends for value in end))


def _layered_points(scan: RangeScan) -> bytes:
    import numpy as np  # noqa: PLC0415 - comes with the extra `cloud`

    image = scan.image()
    layers, columns = np.nonzero(np.isfinite(image))
    far, up, bearing = image[layers, columns], np.array(scan.inclinations)[layers], np.array(scan.angles)[columns]
    level = far * np.cos(up)
    ends = np.stack([level * np.cos(bearing), level * np.sin(bearing), far * np.sin(up)], axis=1)
    return ends.astype("<f4").tobytes()


async def _stop(task: asyncio.Task[None]) -> None:
    """Cancel the task; raises the error that ended it, if any."""
    task.cancel()
    with suppress(asyncio.CancelledError):
        await task
