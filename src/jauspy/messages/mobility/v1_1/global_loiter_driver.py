"""urn:jaus:jss:mobility:GlobalLoiterDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalLoiterDriver", "1.1")


@jd.message(_SERVICE, 0x0425, command=True)
class SetGlobalLoiter(jd.Message):
    """SetGlobalLoiter (0x0425): Sets place and pattern to loiter on the globe.

    global_loiter_rec: The middle of the pattern on the globe, the speed and the tolerance
    loiter: The pattern
    """
    GlobalZPosition = mobility_v1_0_types.GlobalZPosition
    PolygonRec = mobility_v1_0_types.PolygonRec
    RaceTrackRec = mobility_v1_0_types.RaceTrackRec

    @jd.record("B")
    class GlobalLoiterRec(jd.Struct):
        """The middle of the pattern on the globe, the speed and the tolerance.

        latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
        longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
        z_position: optional. Vertical position and its datum
        """
        latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
        longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))
        z_position: mobility_v1_0_types.GlobalZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.GlobalZPosition.layout(), default=None)
        reserved_presence: int = 0

    class HoverPreference(IntEnum):
        LAT_LON_PRIORITY = 0
        Z_PRIORITY = 1

    @jd.record()
    class HoverRec(jd.Struct):
        """Staying over the place.

        hover_preference: HoverPreference. Which tolerance matters more when both cannot be kept
        xy_tolerance: 0..100000 meter. Allowed horizontal distance from the place, in metres
        z_tolerance: 0..50000 meter. Allowed vertical distance from the place, in metres
        """
        hover_preference: SetGlobalLoiter.HoverPreference | int = jd.field("HoverPreference", lambda: jd.Number("B", jd.Values(SetGlobalLoiter.HoverPreference)))
        xy_tolerance: float = jd.field("XYTolerance", jd.real("I", 0.0, 100000.0, "meter"))
        z_tolerance: float = jd.field("ZTolerance", jd.real("I", 0.0, 50000.0, "meter"))

    global_loiter_rec: SetGlobalLoiter.GlobalLoiterRec = jd.field("GlobalLoiterRec", lambda: SetGlobalLoiter.GlobalLoiterRec.layout())
    loiter: SetGlobalLoiter.HoverRec | mobility_v1_0_types.PolygonRec | mobility_v1_0_types.RaceTrackRec = jd.field("Loiter", lambda: jd.Union.of("B", hover_rec=SetGlobalLoiter.HoverRec, polygon_rec=mobility_v1_0_types.PolygonRec, race_track_rec=mobility_v1_0_types.RaceTrackRec))


@jd.message(_SERVICE, 0x04AA, command=True)
class SetTravelSpeedExt(jd.Message):
    """SetTravelSpeedExt (0x04AA): Sets the speed on the way as one of several kinds of speed.

    speed: Speed on the way, and its kind
    """
    Speed = mobility_v1_0_types.Speed
    speed: mobility_v1_0_types.Speed = jd.field("Speed", lambda: mobility_v1_0_types.Speed.layout())


@jd.message(_SERVICE, 0x4425)
class ReportGlobalLoiter(jd.Message):
    """ReportGlobalLoiter (0x4425): Tells place and pattern of loitering on the globe.

    global_loiter_rec: The middle of the pattern on the globe, the speed and the tolerance
    loiter: The pattern
    """
    GlobalZPosition = mobility_v1_0_types.GlobalZPosition
    PolygonRec = mobility_v1_0_types.PolygonRec
    RaceTrackRec = mobility_v1_0_types.RaceTrackRec

    @jd.record("B")
    class GlobalLoiterRec(jd.Struct):
        """The middle of the pattern on the globe, the speed and the tolerance.

        latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
        longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
        z_position: optional. Vertical position and its datum
        """
        latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
        longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))
        z_position: mobility_v1_0_types.GlobalZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.GlobalZPosition.layout(), default=None)
        reserved_presence: int = 0

    class HoverPreference(IntEnum):
        LAT_LON_PRIORITY = 0
        Z_PRIORITY = 1

    @jd.record()
    class HoverRec(jd.Struct):
        """Staying over the place.

        hover_preference: HoverPreference. Which tolerance matters more when both cannot be kept
        xy_tolerance: 0..100000 meter. Allowed horizontal distance from the place, in metres
        z_tolerance: 0..50000 meter. Allowed vertical distance from the place, in metres
        """
        hover_preference: ReportGlobalLoiter.HoverPreference | int = jd.field("HoverPreference", lambda: jd.Number("B", jd.Values(ReportGlobalLoiter.HoverPreference)))
        xy_tolerance: float = jd.field("XYTolerance", jd.real("I", 0.0, 100000.0, "meter"))
        z_tolerance: float = jd.field("ZTolerance", jd.real("I", 0.0, 50000.0, "meter"))

    global_loiter_rec: ReportGlobalLoiter.GlobalLoiterRec = jd.field("GlobalLoiterRec", lambda: ReportGlobalLoiter.GlobalLoiterRec.layout())
    loiter: ReportGlobalLoiter.HoverRec | mobility_v1_0_types.PolygonRec | mobility_v1_0_types.RaceTrackRec = jd.field("Loiter", lambda: jd.Union.of("B", hover_rec=ReportGlobalLoiter.HoverRec, polygon_rec=mobility_v1_0_types.PolygonRec, race_track_rec=mobility_v1_0_types.RaceTrackRec))


@jd.message(_SERVICE, 0x2425, query=True)
class QueryGlobalLoiter(jd.Message):
    """QueryGlobalLoiter (0x2425): Asks for place and pattern of loitering on the globe.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportGlobalLoiter
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"))


@jd.message(_SERVICE, 0x44AA)
class ReportTravelSpeedExt(jd.Message):
    """ReportTravelSpeedExt (0x44AA): Tells the speed on the way that was set, and its kind.

    speed: Speed on the way, and its kind
    """
    Speed = mobility_v1_0_types.Speed
    speed: mobility_v1_0_types.Speed = jd.field("Speed", lambda: mobility_v1_0_types.Speed.layout())


@jd.message(_SERVICE, 0x24AA, query=True)
class QueryTravelSpeedExt(jd.Message):
    """QueryTravelSpeedExt (0x24AA): Asks for the speed on the way and its kind."""
    REPORT = ReportTravelSpeedExt
