"""urn:jaus:jss:mobility:GlobalPathSegmentDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalPathSegmentDriver", "1.0")


@jd.message(_SERVICE, 0x040F, presence="B", command=True, kw_only=True)
class SetGlobalPathSegment(jd.Message):
    """SetGlobalPathSegment (0x040F): Describes a path segment on the globe; sent as an element of the list, not by itself.

    p1_latitude: -90..90 degree. Latitude of the shaping point P1 (WGS 84), in degrees
    p1_longitude: -180..180 degree. Longitude of the shaping point P1 (WGS 84), in degrees
    p1_altitude: -10000..35000 meter, optional. Altitude of the shaping point P1 (WGS 84), in metres
    p2_latitude: -90..90 degree. Latitude of the end point P2 (WGS 84), in degrees
    p2_longitude: -180..180 degree. Longitude of the end point P2 (WGS 84), in degrees
    p2_altitude: -10000..35000 meter, optional. Altitude of the end point P2 (WGS 84), in metres
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    p1_latitude: float = jd.field("P1_Latitude", jd.real("I", -90.0, 90.0, "degree"))
    p1_longitude: float = jd.field("P1_Longitude", jd.real("I", -180.0, 180.0, "degree"))
    p1_altitude: float | None = jd.field("P1_Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    p2_latitude: float = jd.field("P2_Latitude", jd.real("I", -90.0, 90.0, "degree"))
    p2_longitude: float = jd.field("P2_Longitude", jd.real("I", -180.0, 180.0, "degree"))
    p2_altitude: float | None = jd.field("P2_Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    weighting_factor: float = jd.field("WeightingFactor", jd.real("H", 0.0, 500.0))
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x041E, presence="B")
class ExecuteList(jd.Message):
    """ExecuteList (0x041E): Starts the list at an element, at a speed.

    speed: 0..327.67 meter per second. Speed to go through the list, in metres per second
    element_uid: optional. The element to start with
    """
    speed: float = jd.field("Speed", jd.real("H", 0.0, 327.67, "meter per second"))
    element_uid: int | None = jd.field("ElementUID", jd.Number("H"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x440A)
class ReportTravelSpeed(jd.Message):
    """ReportTravelSpeed (0x440A): Tells the speed on the way that was set.

    speed: 0..327.67 meter per second. Speed on the way, in metres per second
    """
    speed: float = jd.field("Speed", jd.real("H", 0.0, 327.67, "meter per second"))


@jd.message(_SERVICE, 0x240A, query=True)
class QueryTravelSpeed(jd.Message):
    """QueryTravelSpeed (0x240A): Asks for the speed on the way."""
    REPORT = ReportTravelSpeed


@jd.message(_SERVICE, 0x440F, presence="B", kw_only=True)
class ReportGlobalPathSegment(jd.Message):
    """ReportGlobalPathSegment (0x440F): Tells the path segment on the globe being followed.

    p1_latitude: -90..90 degree. Latitude of the shaping point P1 (WGS 84), in degrees
    p1_longitude: -180..180 degree. Longitude of the shaping point P1 (WGS 84), in degrees
    p1_altitude: -10000..35000 meter, optional. Altitude of the shaping point P1 (WGS 84), in metres
    p2_latitude: -90..90 degree. Latitude of the end point P2 (WGS 84), in degrees
    p2_longitude: -180..180 degree. Longitude of the end point P2 (WGS 84), in degrees
    p2_altitude: -10000..35000 meter, optional. Altitude of the end point P2 (WGS 84), in metres
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    p1_latitude: float = jd.field("P1_Latitude", jd.real("I", -90.0, 90.0, "degree"))
    p1_longitude: float = jd.field("P1_Longitude", jd.real("I", -180.0, 180.0, "degree"))
    p1_altitude: float | None = jd.field("P1_Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    p2_latitude: float = jd.field("P2_Latitude", jd.real("I", -90.0, 90.0, "degree"))
    p2_longitude: float = jd.field("P2_Longitude", jd.real("I", -180.0, 180.0, "degree"))
    p2_altitude: float | None = jd.field("P2_Altitude", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    weighting_factor: float = jd.field("WeightingFactor", jd.real("H", 0.0, 500.0))
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x240F, query=True)
class QueryGlobalPathSegment(jd.Message):
    """QueryGlobalPathSegment (0x240F): Asks for the path segment on the globe being followed.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportGlobalPathSegment
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x7)


@jd.message(_SERVICE, 0x441E)
class ReportActiveElement(jd.Message):
    """ReportActiveElement (0x441E): Tells which element of the list is being carried out.

    element_uid: The element being carried out; 0 when there is none
    """
    element_uid: int = jd.field("ElementUID", jd.Number("H"))


@jd.message(_SERVICE, 0x241E, query=True)
class QueryActiveElement(jd.Message):
    """QueryActiveElement (0x241E): Asks which element of the list is being carried out."""
    REPORT = ReportActiveElement
