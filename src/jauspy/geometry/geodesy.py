"""Positions on the WGS-84 ellipsoid and in the tangent plane of a place (docs/adr/0038-georeference.md)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

from jauspy.geometry.vectors import Vector

SEMI_MAJOR_AXIS: Final = 6378137.0
"""Semi-major axis, metres."""
FLATTENING: Final = 1.0 / 298.257223563
_E2: Final = FLATTENING * (2.0 - FLATTENING)


@dataclass(frozen=True, slots=True)
class Geodetic:
    """Latitude and longitude in radians, height above the ellipsoid in metres."""

    latitude: float
    longitude: float
    height: float = 0.0


def to_ecef(place: Geodetic) -> Vector:
    """Earth-centred, Earth-fixed coordinates, metres."""
    sine, cosine = math.sin(place.latitude), math.cos(place.latitude)
    normal = SEMI_MAJOR_AXIS / math.sqrt(1.0 - _E2 * sine**2)
    return (
        (normal + place.height) * cosine * math.cos(place.longitude),
        (normal + place.height) * cosine * math.sin(place.longitude),
        (normal * (1.0 - _E2) + place.height) * sine,
    )


def from_ecef(point: Vector) -> Geodetic:
    """The inverse of `to_ecef`: fixed-point iteration, exact to nanometres on and near the ground."""
    x, y, z = point
    axis_distance = math.hypot(x, y)
    latitude = math.atan2(z, axis_distance * (1.0 - _E2))
    normal = SEMI_MAJOR_AXIS
    for _ in range(6):
        normal = SEMI_MAJOR_AXIS / math.sqrt(1.0 - _E2 * math.sin(latitude) ** 2)
        latitude = math.atan2(z + _E2 * normal * math.sin(latitude), axis_distance)
    # Of the two ways to the height one loses its digits at the poles and the other at the equator.
    height = axis_distance * math.cos(latitude) + z * math.sin(latitude) - SEMI_MAJOR_AXIS**2 / normal
    return Geodetic(latitude, math.atan2(y, x), height)


def to_ned(origin: Geodetic, place: Geodetic) -> Vector:
    """Metres north, east and down from the origin, in its tangent plane."""
    x, y, z = (coordinate - reference for coordinate, reference in zip(to_ecef(place), to_ecef(origin), strict=True))
    sine, cosine = math.sin(origin.latitude), math.cos(origin.latitude)
    outward = math.cos(origin.longitude) * x + math.sin(origin.longitude) * y
    east = -math.sin(origin.longitude) * x + math.cos(origin.longitude) * y
    return -sine * outward + cosine * z, east, -cosine * outward - sine * z


def from_ned(origin: Geodetic, north: float, east: float, down: float) -> Geodetic:
    """The position at offsets north, east and down of the origin, in metres: the inverse of `to_ned`."""
    sine, cosine = math.sin(origin.latitude), math.cos(origin.latitude)
    outward = -sine * north - cosine * down
    x, y, z = to_ecef(origin)
    return from_ecef(
        (
            x + math.cos(origin.longitude) * outward - math.sin(origin.longitude) * east,
            y + math.sin(origin.longitude) * outward + math.cos(origin.longitude) * east,
            z + cosine * north - sine * down,
        )
    )


def meridian_convergence(origin: Geodetic, place: Geodetic) -> float:
    """The angle, in radians, by which true north at a place near the origin lies to the left of the origin's north."""
    return math.remainder(place.longitude - origin.longitude, math.tau) * math.sin(origin.latitude)
