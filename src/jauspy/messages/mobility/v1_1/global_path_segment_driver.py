"""urn:jaus:jss:mobility:GlobalPathSegmentDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalPathSegmentDriver", "1.1")


@jd.message(_SERVICE, 0x041E, presence="B", command=True)
class ExecuteList(jd.Message):
    """ExecuteList (0x041E): Starts the list at an element, at a speed.

    speed: 0..327.67 meter per second. Speed to go through the list, in metres per second
    element_uid: optional. The element to start with
    """
    speed: float = jd.field("Speed", jd.real("H", 0.0, 327.67, "meter per second"))
    element_uid: int | None = jd.field("ElementUID", jd.Number("H"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x04AE, presence="B", command=True)
class ExecuteListExt(jd.Message):
    """ExecuteListExt (0x04AE): Starts the list at an element, at one of several kinds of speed.

    speed: Speed to go through the list, and its kind
    element_uid: optional. The element to start with
    """
    Speed = mobility_v1_0_types.Speed
    speed: mobility_v1_0_types.Speed = jd.field("Speed", lambda: mobility_v1_0_types.Speed.layout())
    element_uid: int | None = jd.field("ElementUID", jd.Number("H"), default=None)
    reserved_presence: int = 0

@jd.derived(_SERVICE)
class ReportTravelSpeed(mobility_v1_0_global_path_segment_driver.ReportTravelSpeed): ...

@jd.derived(_SERVICE)
class QueryTravelSpeed(mobility_v1_0_global_path_segment_driver.QueryTravelSpeed):
    REPORT = ReportTravelSpeed

@jd.derived(_SERVICE)
class ReportTravelSpeedExt(mobility_v1_1_global_loiter_driver.ReportTravelSpeedExt): ...

@jd.derived(_SERVICE)
class QueryTravelSpeedExt(mobility_v1_1_global_loiter_driver.QueryTravelSpeedExt):
    REPORT = ReportTravelSpeedExt

@jd.derived(_SERVICE)
class ReportGlobalPathSegment(mobility_v1_0_global_path_segment_driver.ReportGlobalPathSegment): ...

@jd.derived(_SERVICE)
class QueryGlobalPathSegment(mobility_v1_0_global_path_segment_driver.QueryGlobalPathSegment):
    REPORT = ReportGlobalPathSegment


@jd.message(_SERVICE, 0x44AF, presence="B", kw_only=True)
class ReportGlobalPathSegmentExt(jd.Message):
    """ReportGlobalPathSegmentExt (0x44AF): Tells the path segment on the globe, with its vertical datum.

    p1_latitude: -90..90 degree. Latitude of the shaping point P1 (WGS 84), in degrees
    p1_longitude: -180..180 degree. Longitude of the shaping point P1 (WGS 84), in degrees
    p1_z_position: optional. Vertical position of the shaping point P1 and its datum
    p2_latitude: -90..90 degree. Latitude of the end point P2 (WGS 84), in degrees
    p2_longitude: -180..180 degree. Longitude of the end point P2 (WGS 84), in degrees
    p_z_position: optional. Vertical position of the end point P2 and its datum
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    class P1_ZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(ReportGlobalPathSegmentExt.P1_ZPositionChoice)))
    class P1_ZPosition(jd.Struct):
        """Vertical position of the shaping point P1 and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """
        choice: ReportGlobalPathSegmentExt.P1_ZPositionChoice | int
        value: float

    class P_ZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(ReportGlobalPathSegmentExt.P_ZPositionChoice)))
    class P_ZPosition(jd.Struct):
        """Vertical position of the end point P2 and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """
        choice: ReportGlobalPathSegmentExt.P_ZPositionChoice | int
        value: float

    p1_latitude: float = jd.field("P1_Latitude", jd.real("I", -90.0, 90.0, "degree"))
    p1_longitude: float = jd.field("P1_Longitude", jd.real("I", -180.0, 180.0, "degree"))
    p1_z_position: ReportGlobalPathSegmentExt.P1_ZPosition | None = jd.field("P1_ZPosition", lambda: ReportGlobalPathSegmentExt.P1_ZPosition.layout(), default=None)
    p2_latitude: float = jd.field("P2_Latitude", jd.real("I", -90.0, 90.0, "degree"))
    p2_longitude: float = jd.field("P2_Longitude", jd.real("I", -180.0, 180.0, "degree"))
    p_z_position: ReportGlobalPathSegmentExt.P_ZPosition | None = jd.field("P_ZPosition", lambda: ReportGlobalPathSegmentExt.P_ZPosition.layout(), default=None)
    weighting_factor: float = jd.field("WeightingFactor", jd.real("H", 0.0, 500.0))
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x24AF, query=True)
class QueryGlobalPathSegmentExt(jd.Message):
    """QueryGlobalPathSegmentExt (0x24AF): Asks for the path segment on the globe in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportGlobalPathSegmentExt
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x7)

@jd.derived(_SERVICE)
class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement): ...

@jd.derived(_SERVICE)
class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    REPORT = ReportActiveElement
