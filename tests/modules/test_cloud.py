"""The scans of a robot as clouds."""

from __future__ import annotations

import asyncio
import math
import struct

import pytest

from jauspy.modules.cloud import points, stream
from jauspy.platform.ranging import LidarSetup, RangeScan
from jauspy.platform.scanner import Scanner

SETUP = LidarSetup("lidar", "lidar_link", rays=4)


class Published:
    def __init__(self) -> None:
        self.clouds: list[tuple[bytes, str, float]] = []

    def publish(self, found: bytes, frame: str, at: float) -> None:
        self.clouds.append((found, frame, at))


def test_points_are_the_ends_of_rays_with_an_echo() -> None:
    scan = RangeScan(0.0, "lidar_link", (0.0, math.pi / 2, math.pi), (2.0, math.inf, 3.0))
    assert struct.unpack("<6f", points(scan)) == pytest.approx((2.0, 0.0, 0.0, -3.0, 0.0, 0.0), abs=1e-6)


async def test_every_scan_is_published_once() -> None:
    lidar, published = Scanner(SETUP, lambda angles: [1.0] * len(angles)), Published()
    task = asyncio.create_task(stream({"lidar": lidar}, published))  # type: ignore[arg-type]
    for scans in (1, 2, 3):
        lidar.step(scans * 1.0)
        async with asyncio.timeout(20):
            while len(published.clouds) < scans:
                await asyncio.sleep(0.01)
        await asyncio.sleep(0.1)
        assert len(published.clouds) == scans
    task.cancel()
    assert {(len(found), frame) for found, frame, _ in published.clouds} == {(48, "lidar_link")}
