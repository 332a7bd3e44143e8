"""urn:jaus:jss:mobility:LocalLoiterDriver 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types
from jauspy.messages.mobility.v1_1 import global_loiter_driver as mobility_v1_1_global_loiter_driver

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalLoiterDriver", "1.1")


@jd.message(_SERVICE, 0x0426, command=True)
class SetLocalLoiter(jd.Message):
    """SetLocalLoiter (0x0426): Sets place and pattern to loiter in the local frame.

    local_loiter_rec: The middle of the pattern in the local frame, the speed and the tolerance
    loiter: The pattern
    """
    ZPosition = mobility_v1_0_types.ZPosition
    PolygonRec = mobility_v1_0_types.PolygonRec
    RaceTrackRec = mobility_v1_0_types.RaceTrackRec

    @jd.record("B")
    class LocalLoiterRec(jd.Struct):
        """The middle of the pattern in the local frame, the speed and the tolerance.

        x: -20000000..20000000 meter. Position along X, in metres
        y: -20000000..20000000 meter. Position along Y, in metres
        z_position: optional. Vertical position and its datum
        """
        x: float = jd.field("X", jd.real("I", -20000000.0, 20000000.0, "meter"))
        y: float = jd.field("Y", jd.real("I", -20000000.0, 20000000.0, "meter"))
        z_position: mobility_v1_0_types.ZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.ZPosition.layout(), default=None)
        reserved_presence: int = 0

    class HoverPreference(IntEnum):
        XY_PRIORITY = 0
        Z_PRIORITY = 1

    @jd.record()
    class HoverRec(jd.Struct):
        """Staying over the place.

        hover_preference: HoverPreference. Which tolerance matters more when both cannot be kept
        xy_tolerance: 0..100000 meter. Allowed horizontal distance from the place, in metres
        z_tolerance: 0..50000 meter. Allowed vertical distance from the place, in metres
        """
        hover_preference: SetLocalLoiter.HoverPreference | int = jd.field("HoverPreference", lambda: jd.Number("B", jd.Values(SetLocalLoiter.HoverPreference)))
        xy_tolerance: float = jd.field("XYTolerance", jd.real("I", 0.0, 100000.0, "meter"))
        z_tolerance: float = jd.field("ZTolerance", jd.real("I", 0.0, 50000.0, "meter"))

    local_loiter_rec: SetLocalLoiter.LocalLoiterRec = jd.field("LocalLoiterRec", lambda: SetLocalLoiter.LocalLoiterRec.layout())
    loiter: SetLocalLoiter.HoverRec | mobility_v1_0_types.PolygonRec | mobility_v1_0_types.RaceTrackRec = jd.field("Loiter", lambda: jd.Union.of("B", hover_rec=SetLocalLoiter.HoverRec, polygon_rec=mobility_v1_0_types.PolygonRec, race_track_rec=mobility_v1_0_types.RaceTrackRec))

@jd.derived(_SERVICE)
class SetTravelSpeedExt(mobility_v1_1_global_loiter_driver.SetTravelSpeedExt): ...


@jd.message(_SERVICE, 0x4426)
class ReportLocalLoiter(jd.Message):
    """ReportLocalLoiter (0x4426): Tells place and pattern of loitering in the local frame.

    local_loiter_rec: The middle of the pattern in the local frame, the speed and the tolerance
    loiter: The pattern
    """
    ZPosition = mobility_v1_0_types.ZPosition
    PolygonRec = mobility_v1_0_types.PolygonRec
    RaceTrackRec = mobility_v1_0_types.RaceTrackRec

    @jd.record("B")
    class LocalLoiterRec(jd.Struct):
        """The middle of the pattern in the local frame, the speed and the tolerance.

        x: -20000000..20000000 meter. Position along X, in metres
        y: -20000000..20000000 meter. Position along Y, in metres
        z_position: optional. Vertical position and its datum
        """
        x: float = jd.field("X", jd.real("I", -20000000.0, 20000000.0, "meter"))
        y: float = jd.field("Y", jd.real("I", -20000000.0, 20000000.0, "meter"))
        z_position: mobility_v1_0_types.ZPosition | None = jd.field("ZPosition", lambda: mobility_v1_0_types.ZPosition.layout(), default=None)
        reserved_presence: int = 0

    class HoverPreference(IntEnum):
        XY_PRIORITY = 0
        Z_PRIORITY = 1

    @jd.record()
    class HoverRec(jd.Struct):
        """Staying over the place.

        hover_preference: HoverPreference. Which tolerance matters more when both cannot be kept
        xy_tolerance: 0..100000 meter. Allowed horizontal distance from the place, in metres
        z_tolerance: 0..50000 meter. Allowed vertical distance from the place, in metres
        """
        hover_preference: ReportLocalLoiter.HoverPreference | int = jd.field("HoverPreference", lambda: jd.Number("B", jd.Values(ReportLocalLoiter.HoverPreference)))
        xy_tolerance: float = jd.field("XYTolerance", jd.real("I", 0.0, 100000.0, "meter"))
        z_tolerance: float = jd.field("ZTolerance", jd.real("I", 0.0, 50000.0, "meter"))

    local_loiter_rec: ReportLocalLoiter.LocalLoiterRec = jd.field("LocalLoiterRec", lambda: ReportLocalLoiter.LocalLoiterRec.layout())
    loiter: ReportLocalLoiter.HoverRec | mobility_v1_0_types.PolygonRec | mobility_v1_0_types.RaceTrackRec = jd.field("Loiter", lambda: jd.Union.of("B", hover_rec=ReportLocalLoiter.HoverRec, polygon_rec=mobility_v1_0_types.PolygonRec, race_track_rec=mobility_v1_0_types.RaceTrackRec))


@jd.message(_SERVICE, 0x2426, query=True)
class QueryLocalLoiter(jd.Message):
    """QueryLocalLoiter (0x2426): Asks for place and pattern of loitering in the local frame.

    presence_vector: Optional fields that the report is to have: bit i asks for the i-th of them, from 0
    """
    REPORT = ReportLocalLoiter
    presence_vector: int = jd.field("PresenceVector", jd.Number("B"))

@jd.derived(_SERVICE)
class ReportTravelSpeedExt(mobility_v1_1_global_loiter_driver.ReportTravelSpeedExt): ...

@jd.derived(_SERVICE)
class QueryTravelSpeedExt(mobility_v1_1_global_loiter_driver.QueryTravelSpeedExt):
    REPORT = ReportTravelSpeedExt
