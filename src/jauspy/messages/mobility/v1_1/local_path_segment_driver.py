"""urn:jaus:jss:mobility:LocalPathSegmentDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import global_path_segment_driver as mobility_v1_0_global_path_segment_driver
from jauspy.messages.mobility.v1_0 import local_path_segment_driver as mobility_v1_0_local_path_segment_driver
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver
from jauspy.messages.mobility.v1_1 import global_path_segment_driver as mobility_v1_1_global_path_segment_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalPathSegmentDriver", "1.1")

@jd.derived(_SERVICE)
class ExecuteList(mobility_v1_1_global_path_segment_driver.ExecuteList): ...

@jd.derived(_SERVICE)
class ExecuteListExt(mobility_v1_1_global_path_segment_driver.ExecuteListExt): ...

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
class ReportLocalPathSegment(mobility_v1_0_local_path_segment_driver.ReportLocalPathSegment): ...

@jd.derived(_SERVICE)
class QueryLocalPathSegment(mobility_v1_0_local_path_segment_driver.QueryLocalPathSegment):
    REPORT = ReportLocalPathSegment


@jd.message(_SERVICE, 0x44B0, presence="B", kw_only=True)
class ReportLocalPathSegmentExt(jd.Message):
    """ReportLocalPathSegmentExt (0x44B0): Tells the path segment in the local frame, with its vertical datum.

    p1_x: -20000000..20000000 meter. Position of the shaping point P1 along X, in metres
    p1_y: -20000000..20000000 meter. Position of the shaping point P1 along Y, in metres
    p1_z_position: optional. Vertical position of the shaping point P1 and its datum
    p2_x: -20000000..20000000 meter. Position of the end point P2 along X, in metres
    p2_y: -20000000..20000000 meter. Position of the end point P2 along Y, in metres
    p2_z_position: optional. Vertical position of the end point P2 and its datum
    weighting_factor: 0..500. How strongly the curve is drawn to P1; 0 is a straight line
    path_tolerance: 0..100000 meter, optional. Largest distance from the path that is allowed, in metres
    """

    class P1_ZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter"), 4: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(ReportLocalPathSegmentExt.P1_ZPositionChoice)))
    class P1_ZPosition(jd.Struct):
        """Vertical position of the shaping point P1 and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """
        choice: ReportLocalPathSegmentExt.P1_ZPositionChoice | int
        value: float

    class P2_ZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter"), 4: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(ReportLocalPathSegmentExt.P2_ZPositionChoice)))
    class P2_ZPosition(jd.Struct):
        """Vertical position of the end point P2 and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """
        choice: ReportLocalPathSegmentExt.P2_ZPositionChoice | int
        value: float

    p1_x: float = jd.field("P1_X", jd.real("I", -20000000.0, 20000000.0, "meter"))
    p1_y: float = jd.field("P1_Y", jd.real("I", -20000000.0, 20000000.0, "meter"))
    p1_z_position: ReportLocalPathSegmentExt.P1_ZPosition | None = jd.field("P1_ZPosition", lambda: ReportLocalPathSegmentExt.P1_ZPosition.layout(), default=None)
    p2_x: float = jd.field("P2_X", jd.real("I", -20000000.0, 20000000.0, "meter"))
    p2_y: float = jd.field("P2_Y", jd.real("I", -20000000.0, 20000000.0, "meter"))
    p2_z_position: ReportLocalPathSegmentExt.P2_ZPosition | None = jd.field("P2_ZPosition", lambda: ReportLocalPathSegmentExt.P2_ZPosition.layout(), default=None)
    weighting_factor: float = jd.field("WeightingFactor", jd.real("H", 0.0, 500.0))
    path_tolerance: float | None = jd.field("PathTolerance", jd.real("I", 0.0, 100000.0, "meter"), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0x24B0, query=True)
class QueryLocalPathSegmentExt(jd.Message):
    """QueryLocalPathSegmentExt (0x24B0): Asks for the path segment in the local frame in its wider form.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportLocalPathSegmentExt
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"), default=0x7)

@jd.derived(_SERVICE)
class ReportActiveElement(mobility_v1_0_global_path_segment_driver.ReportActiveElement): ...

@jd.derived(_SERVICE)
class QueryActiveElement(mobility_v1_0_global_path_segment_driver.QueryActiveElement):
    REPORT = ReportActiveElement
