"""The local and the global frame of JAUS in the world of a platform; one of each for all services of a component.

The world's frame has JAUS axes here: x forward, y right, z down where the robot started.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from jauspy.geometry.geodesy import Geodetic, from_ned, meridian_convergence, to_ned
from jauspy.geometry.poses import PlanarPoint, Pose, wrap_angle


class LocalFrame:
    """The frame in which local poses are reported: the world's, until a client sets its own pose in it."""

    def __init__(self) -> None:
        self._world = self._local = Pose()

    def set(self, world: Pose, local: Pose) -> None:
        """Shift the frame, and turn it about z, so that the platform, at `world`, has the pose `local`."""
        self._world, self._local = world, local

    def from_world(self, pose: Pose) -> Pose:
        """A pose of the world in this frame."""
        world, local = self._world, self._local
        x, y = _rotated(pose.x - world.x, pose.y - world.y, self._turn)
        return replace(
            pose, x=local.x + x, y=local.y + y, z=local.z + pose.z - world.z, yaw=wrap_angle(pose.yaw + self._turn)
        )

    def to_world(self, x: float, y: float) -> PlanarPoint:
        """A point of this frame (m) in the world."""
        dx, dy = _rotated(x - self._local.x, y - self._local.y, -self._turn)
        return PlanarPoint(self._world.x + dx, self._world.y + dy)

    def heading_to_world(self, yaw: float) -> float:
        """A heading of this frame (rad) in the world."""
        return wrap_angle(yaw - self._turn)

    @property
    def _turn(self) -> float:
        """Added to headings of the world, gives headings of this frame."""
        return self._local.yaw - self._world.yaw


def _rotated(x: float, y: float, angle: float) -> tuple[float, float]:
    return math.cos(angle) * x - math.sin(angle) * y, math.sin(angle) * x + math.cos(angle) * y


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
    """The frame in which global poses are reported. `origin`: pose of the world's origin and x axis on the globe."""

    def __init__(self, origin: GlobalPose) -> None:
        self._world = Pose()
        self._global = origin

    def set(self, world: Pose, globe: GlobalPose) -> None:
        """Place the world so that the platform, at `world`, has the global pose `globe`."""
        self._world, self._global = world, globe

    def from_world(self, pose: Pose) -> GlobalPose:
        """A pose of the world on the globe."""
        ahead, right = pose.x - self._world.x, pose.y - self._world.y
        sine, cosine = math.sin(self._turn), math.cos(self._turn)
        position = from_ned(
            self._anchor, cosine * ahead - sine * right, sine * ahead + cosine * right, pose.z - self._world.z
        )
        heading = wrap_angle(pose.yaw + self._turn + meridian_convergence(self._anchor, position))
        return GlobalPose(math.degrees(position.latitude), math.degrees(position.longitude), position.height, heading)

    def to_world(self, latitude: float, longitude: float) -> PlanarPoint:
        """A point of the globe (degrees) in the world, at the height of the platform when the frame was set."""
        position = replace(self._anchor, latitude=math.radians(latitude), longitude=math.radians(longitude))
        north, east, _ = to_ned(self._anchor, position)
        sine, cosine = math.sin(self._turn), math.cos(self._turn)
        return PlanarPoint(self._world.x + cosine * north + sine * east, self._world.y - sine * north + cosine * east)

    def heading_to_world(self, heading: float) -> float:
        """A true heading (rad) in the world; away from the anchor it is off by the convergence of the meridians."""
        return wrap_angle(heading - self._turn)

    @property
    def _anchor(self) -> Geodetic:
        place = self._global
        return Geodetic(math.radians(place.latitude), math.radians(place.longitude), place.altitude)

    @property
    def _turn(self) -> float:
        """Added to headings of the world, gives true headings."""
        return self._global.heading - self._world.yaw
