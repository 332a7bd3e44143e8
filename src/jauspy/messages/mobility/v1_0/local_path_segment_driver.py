"""urn:jaus:jss:mobility:LocalPathSegmentDriver 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalPathSegmentDriver", "1.0")


@jd.message(_SERVICE, 0x0410, presence="B", command=True, kw_only=True)
class SetLocalPathSegment(jd.Message):
    """SetLocalPathSegment (0x0410): Describes a path segment in the local frame; sent as an element of the list, not by itself.

    p1_x: -100000..100000 meter. Position of the shaping point P1 along X, in metres
    p1_y: -100000..100000 meter. Position of the shaping point P1 along Y, in metres
    p1_z: -10000..35000 meter, optional. Position of the shaping point P1 along Z, in metres
    p2_x: -100000..100000 meter. Position of the end point P2 along X, in metres
    p2_y: -100000..100000 meter. Position of the end point P2 along Y, in metres
    p2_z: -10000..35000 meter, optional. Position of the end point P2 along Z, in metres
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    p1_x: float = jd.field("P1_X", jd.real("I", -100000.0, 100000.0, "meter"))
    p1_y: float = jd.field("P1_Y", jd.real("I", -100000.0, 100000.0, "meter"))
    p1_z: float | None = jd.field("P1_Z", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    p2_x: float = jd.field("P2_X", jd.real("I", -100000.0, 100000.0, "meter"))
    p2_y: float = jd.field("P2_Y", jd.real("I", -100000.0, 100000.0, "meter"))
    p2_z: float | None = jd.field("P2_Z", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    weighting_factor: float = jd.field("WeightingFactor", jd.real("H", 0.0, 500.0))
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0

@jd.derived(_SERVICE)
class ExecuteList(mobility_v1_0_global_path_segment_driver.ExecuteList): ...

@jd.derived(_SERVICE)
class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed): ...

@jd.derived(_SERVICE)
class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    REPORT = ReportTravelSpeed


@jd.message(_SERVICE, 0x4410, presence="B", kw_only=True)
class ReportLocalPathSegment(jd.Message):
    """ReportLocalPathSegment (0x4410): Tells the path segment in the local frame being followed.

    p1_x: -100000..100000 meter. Position of the shaping point P1 along X, in metres
    p1_y: -100000..100000 meter. Position of the shaping point P1 along Y, in metres
    p1_z: -10000..35000 meter, optional. Position of the shaping point P1 along Z, in metres
    p2_x: -100000..100000 meter. Position of the end point P2 along X, in metres
    p2_y: -100000..100000 meter. Position of the end point P2 along Y, in metres
    p2_z: -10000..35000 meter, optional. Position of the end point P2 along Z, in metres
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """
    p1_x: float = jd.field("P1_X", jd.real("I", -100000.0, 100000.0, "meter"))
    p1_y: float = jd.field("P1_Y", jd.real("I", -100000.0, 100000.0, "meter"))
    p1_z: float | None = jd.field("P1_Z", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    p2_x: float = jd.field("P2_X", jd.real("I", -100000.0, 100000.0, "meter"))
    p2_y: float = jd.field("P2_Y", jd.real("I", -100000.0, 100000.0, "meter"))
    p2_z: float | None = jd.field("P2_Z", jd.real("I", -10000.0, 35000.0, "meter"), default=None)
    weighting_factor: float = jd.field("WeightingFactor", jd.real("H", 0.0, 500.0))
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x2410, query=True)
class QueryLocalPathSegment(jd.Message):
    """QueryLocalPathSegment (0x2410): Asks for the path segment in the local frame being followed.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportLocalPathSegment
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x7)

@jd.derived(_SERVICE)
class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement): ...

@jd.derived(_SERVICE)
class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    REPORT = ReportActiveElement
