"""Streams what a robot's lidars see as point clouds."""

from __future__ import annotations

import asyncio
import math
import struct
import time
from collections.abc import Mapping
from typing import Final

from jauspy.cloud.socket import CloudPublisher
from jauspy.platform.ranging import RangeFinder, RangeScan

POLL: Final = 0.02
"""Seconds between two looks for a new scan."""


async def stream(lidars: Mapping[str, RangeFinder], publisher: CloudPublisher) -> None:
    """Publish every new scan, in the frame of the lidar's link, until cancelled."""
    sent: dict[str, RangeScan | None] = {}
    while True:
        for name, lidar in lidars.items():
            scan = lidar.scan
            if scan is not None and scan is not sent.get(name):
                sent[name] = scan
                publisher.publish(points(scan), scan.frame, time.time() - lidar.age)
        await asyncio.sleep(POLL)


def points(scan: RangeScan) -> bytes:
    """The ends of the rays that met something, as x, y, z in float32, little-endian."""
    rays = zip(scan.angles, scan.ranges, strict=True)
    ends = [(far * math.cos(angle), far * math.sin(angle), 0.0) for angle, far in rays if math.isfinite(far)]
    return struct.pack(f"<{3 * len(ends)}f", *(value for end in ends for value in end))
