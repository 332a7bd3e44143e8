"""Where the local frame of a robot is on the globe, from its local and global pose of the same moment."""

from __future__ import annotations

import asyncio
import math
from dataclasses import dataclass

from jauspy.errors import JausError
from jauspy.geometry.geodesy import Geodetic, from_ned, to_ned
from jauspy.messages.mobility import QueryGlobalPose, QueryLocalPose, ReportGlobalPose, ReportLocalPose
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot

GLOBAL_SENSOR, LOCAL_SENSOR = "mobility:GlobalPoseSensor", "mobility:LocalPoseSensor"


@dataclass(frozen=True, slots=True)
class GeographicFrame:
    """A local frame on the globe: its origin, and the direction of x, in radians clockwise from true north."""

    origin: Geodetic
    heading: float

    def to_globe(self, x: float, y: float) -> tuple[float, float]:
        """Latitude and longitude in degrees of a point of the local frame (metres, y to the left of x)."""
        cosine, sine = math.cos(self.heading), math.sin(self.heading)
        place = from_ned(self.origin, x * cosine + y * sine, x * sine - y * cosine, 0.0)
        return math.degrees(place.latitude), math.degrees(place.longitude)

    def to_local(self, latitude: float, longitude: float) -> tuple[float, float]:
        """The point of the local frame, in metres, at a latitude and longitude in degrees."""
        place = Geodetic(math.radians(latitude), math.radians(longitude), self.origin.height)
        north, east, _ = to_ned(self.origin, place)
        cosine, sine = math.cos(self.heading), math.sin(self.heading)
        return north * cosine + east * sine, north * sine - east * cosine


def frame_of(local: ReportLocalPose, globe: ReportGlobalPose) -> GeographicFrame | None:
    """The frame in which a robot is at both poses; None if one of them lacks a value."""
    if local.x is None or local.y is None or local.yaw is None:
        return None
    if globe.latitude is None or globe.longitude is None or globe.yaw is None:
        return None
    heading = math.remainder(globe.yaw - local.yaw, math.tau)  # both clockwise
    here = Geodetic(math.radians(globe.latitude), math.radians(globe.longitude))
    x, y = local.x, -local.y
    cosine, sine = math.cos(heading), math.sin(heading)
    return GeographicFrame(from_ned(here, -(x * cosine + y * sine), -(x * sine - y * cosine), 0.0), heading)


async def find_frame(ocu: OCU, robot: Robot) -> tuple[GeographicFrame | None, tuple[float, float, float] | None]:
    """The frame of a robot, and its pose in it (x, y in metres, yaw in radians); None for what is not reported."""
    found = {
        sensor: next((component for component in robot.components if component.find(sensor)), None)
        for sensor in (LOCAL_SENSOR, GLOBAL_SENSOR)
    }
    local_sensor, global_sensor = found[LOCAL_SENSOR], found[GLOBAL_SENSOR]
    if local_sensor is None:
        return None, None
    try:
        if global_sensor is None:
            local = await ocu.query(local_sensor.id, QueryLocalPose(), expects=ReportLocalPose, retries=0)
            globe = None
        else:
            local, globe = await asyncio.gather(
                ocu.query(local_sensor.id, QueryLocalPose(), expects=ReportLocalPose, retries=0),
                ocu.query(global_sensor.id, QueryGlobalPose(), expects=ReportGlobalPose, retries=0),
            )
    except JausError:
        return None, None
    if local.x is None or local.y is None:
        return None, None
    pose = (local.x, -local.y, -(local.yaw or 0.0))
    return (None if globe is None else frame_of(local, globe)), pose
