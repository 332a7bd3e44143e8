"""Where the world of a platform lies on the globe."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from jauspy.geometry.geodesy import Geodetic, from_ned, meridian_convergence, to_ned
from jauspy.geometry.poses import Pose, wrap_angle
from jauspy.services.mobility.guidance.leg import Point


@dataclass(frozen=True, slots=True)
class GlobalPose:
    """Latitude and longitude in degrees, as JAUS has them; altitude above the WGS-84 ellipsoid in metres.

    The heading is in radians, clockwise from true north.
    """

    latitude: float
    longitude: float
    altitude: float = 0.0
    heading: float = 0.0


class GlobalFrame:
    """The world's origin lies at `origin`, whose heading is that of the world's x axis; poses are in JAUS axes."""

    def __init__(self, origin: GlobalPose) -> None:
        self._anchor = Pose()
        self._shown = origin

    def set(self, raw: Pose, shown: GlobalPose) -> None:
        """The platform, in the world at `raw`, is at `shown` from now on."""
        self._anchor, self._shown = raw, shown

    def show(self, pose: Pose) -> GlobalPose:
        """A pose in the world, on the globe."""
        ahead, right = pose.x - self._anchor.x, pose.y - self._anchor.y
        sine, cosine = math.sin(self._turn), math.cos(self._turn)
        there = from_ned(
            self._place, cosine * ahead - sine * right, sine * ahead + cosine * right, pose.z - self._anchor.z
        )
        heading = wrap_angle(pose.yaw + self._turn + meridian_convergence(self._place, there))
        return GlobalPose(math.degrees(there.latitude), math.degrees(there.longitude), there.height, heading)

    def place(self, latitude: float, longitude: float) -> Point:
        """Where a point of the globe (degrees) is in the world, straight below or above it."""
        there = replace(self._place, latitude=math.radians(latitude), longitude=math.radians(longitude))
        north, east, _ = to_ned(self._place, there)
        sine, cosine = math.sin(self._turn), math.cos(self._turn)
        return Point(self._anchor.x + cosine * north + sine * east, self._anchor.y - sine * north + cosine * east)

    def heading(self, heading: float) -> float:
        """A true heading, in the world; at the anchor, so that it is off by the convergence of the meridians."""
        return wrap_angle(heading - self._turn)

    @property
    def _place(self) -> Geodetic:
        shown = self._shown
        return Geodetic(math.radians(shown.latitude), math.radians(shown.longitude), shown.altitude)

    @property
    def _turn(self) -> float:
        """From the world's headings to true ones."""
        return self._shown.heading - self._anchor.yaw
