"""The points of a scan, as RangeSensor reports them."""

from __future__ import annotations

import bz2
import lzma
import math
import zlib
from collections.abc import Callable, Mapping
from typing import Final

from jauspy.geometry.poses import Transform
from jauspy.messages.core import TimeStamp
from jauspy.messages.environment_sensing.v2_0.range_sensor import QueryRangeSensorCompressedData, ReportRangeSensorData
from jauspy.platform.ranging import RangeFinder, RangeScan
from jauspy.services.messaging import requested_fields

Point = ReportRangeSensorData.RangeSensorDataPointRec

VALIDITY_BIT: Final = 1 << 1
"""Of a query's presence vector: it asks for RangeValidity."""

COUNT: Final = 2
"""Bytes of the count of a list of points."""

_Compression = QueryRangeSensorCompressedData.DataCompression
COMPRESS: Final[Mapping[int, Callable[[bytes], bytes]]] = {
    _Compression.NONE: bytes,
    _Compression.DEFLATE: zlib.compress,
    _Compression.BZIP2: bz2.compress,
    _Compression.LZMA: lambda data: lzma.compress(data, lzma.FORMAT_ALONE),
}
"""AS6060 names the methods and not the containers: these are zlib's (RFC 1950), .bz2 and .lzma."""


def points(scan: RangeScan, lidar: RangeFinder, asked: int, frame: Transform | None = None) -> list[Point]:
    """The rays that met something, and those that did not if the query asks which are valid.

    In the sensor's own frame, or, when its frame in the vehicle's is given, in the vehicle's; both with JAUS's axes.
    """
    tells_validity = bool(asked & VALIDITY_BIT)
    rays = enumerate(zip(scan.angles, scan.ranges, strict=True))
    found = [(number, ray) for number, ray in rays if tells_validity or math.isfinite(ray[1])]
    return [requested_fields(_point(number, ray, lidar, frame), asked) for number, ray in found]


def _point(number: int, ray: tuple[float, float], lidar: RangeFinder, frame: Transform | None) -> Point:
    angle, distance = ray
    limits = lidar.settings
    metres = min(limits.most, max(limits.least, distance))
    bearing, inclination = -angle, 0.0  # JAUS counts clockwise
    if frame is not None:
        metres, bearing, inclination = _polar(frame, metres, bearing)
    return Point(
        point_id=number,
        range=metres,
        range_validity=int(math.isfinite(distance)),
        range_error_rms=lidar.setup.noise,
        bearing=bearing,
        bearing_validity=1,
        bearing_error_rms=0.0,
        inclination=inclination,
        inclination_validity=1,
        inclination_error_rms=0.0,
    )


def _polar(frame: Transform, distance: float, bearing: float) -> tuple[float, float, float]:
    x, y, z = frame.apply((distance * math.cos(bearing), distance * math.sin(bearing), 0.0))
    across = math.hypot(x, y)
    return math.hypot(across, z), math.atan2(y, x), math.atan2(-z, across)  # about y, which is right: up is positive


def data_rec(sensor: int, in_vehicle: bool, stamp: TimeStamp) -> ReportRangeSensorData.RangeSensorDataRec:
    """The head of a report."""
    return ReportRangeSensorData.RangeSensorDataRec(sensor, int(in_vehicle), stamp)


def encoded(found: list[Point], head: ReportRangeSensorData.RangeSensorDataRec) -> bytes:
    """The list of points alone, with its count, as it stands in a report that is not compressed."""
    empty, full = (
        ReportRangeSensorData([ReportRangeSensorData.RangeSensorDataSeq(head, each)]).encode() for each in ([], found)
    )
    return full[len(empty) - COUNT :]
