"""urn:jaus:jss:mobility:LocalOperatingZone 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_1 import global_operating_zone as mobility_v1_1_global_operating_zone

_SERVICE = jd.Service("urn:jaus:jss:mobility:LocalOperatingZone", "1.1")


@jd.message(_SERVICE, 0x0427, command=True)
class SetLocalOperatingZone(jd.Message):
    """SetLocalOperatingZone (0x0427): Sets the zone in the local frame to stay in and those to keep out of.

    local_operating_zone: 0..255 items. Corners of the zone to stay in
    local_exclusion_zones: 0..255 items. The zones to keep out of
    """

    class MinZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter"), 4: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(SetLocalOperatingZone.MinZPositionChoice)))
    class MinZPosition(jd.Struct):
        """Lower limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """
        choice: SetLocalOperatingZone.MinZPositionChoice | int
        value: float

    class MaxZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter"), 4: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(SetLocalOperatingZone.MaxZPositionChoice)))
    class MaxZPosition(jd.Struct):
        """Upper limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """
        choice: SetLocalOperatingZone.MaxZPositionChoice | int
        value: float

    @jd.record("B")
    class LocalPolygonPointRec(jd.Struct):
        """A corner in the local frame with its vertical limits.

        x: -20000000..20000000 meter. Position along X, in metres
        y: -20000000..20000000 meter. Position along Y, in metres
        min_z_position: optional. Lower limit of the vertical position, and its datum
        max_z_position: optional. Upper limit of the vertical position, and its datum
        """
        x: float = jd.field("X", jd.real("I", -20000000.0, 20000000.0, "meter"))
        y: float = jd.field("Y", jd.real("I", -20000000.0, 20000000.0, "meter"))
        min_z_position: SetLocalOperatingZone.MinZPosition | None = jd.field("MinZPosition", lambda: SetLocalOperatingZone.MinZPosition.layout(), default=None)
        max_z_position: SetLocalOperatingZone.MaxZPosition | None = jd.field("MaxZPosition", lambda: SetLocalOperatingZone.MaxZPosition.layout(), default=None)
        reserved_presence: int = 0

    class ZoneID(IntEnum):
        RESERVED = 0
        OPERATING_ZONE = 1

    @jd.record()
    class LocalExclusionZoneRec(jd.Struct):
        """Number of the zone.

        zone_id: ZoneID or 2..65535. Number of the zone
        """
        zone_id: SetLocalOperatingZone.ZoneID | int = jd.field("ZoneID", lambda: jd.Number("H", jd.Values(SetLocalOperatingZone.ZoneID, ((2, 65535),))))

    @jd.record()
    class LocalExclusionZoneSeq(jd.Struct):
        """local_exclusion_zone_rec: Number of the zone
        local_polygon_point_rec: A corner in the local frame with its vertical limits
        """
        local_exclusion_zone_rec: SetLocalOperatingZone.LocalExclusionZoneRec = jd.field("LocalExclusionZoneRec", lambda: SetLocalOperatingZone.LocalExclusionZoneRec.layout())
        local_polygon_point_rec: SetLocalOperatingZone.LocalPolygonPointRec = jd.field("LocalPolygonPointRec", lambda: SetLocalOperatingZone.LocalPolygonPointRec.layout())

    local_operating_zone: list[SetLocalOperatingZone.LocalPolygonPointRec] = jd.field("LocalOperatingZone", lambda: jd.Repeat(jd.Count("B", 0, 255), SetLocalOperatingZone.LocalPolygonPointRec.layout()))
    local_exclusion_zones: list[list[SetLocalOperatingZone.LocalExclusionZoneSeq]] = jd.field("LocalExclusionZones", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Repeat(jd.Count("B", 0, 255), SetLocalOperatingZone.LocalExclusionZoneSeq.layout())))

@jd.derived(_SERVICE)
class DeleteZone(mobility_v1_1_global_operating_zone.DeleteZone): ...


@jd.message(_SERVICE, 0x4427)
class ReportLocalOperatingZone(jd.Message):
    """ReportLocalOperatingZone (0x4427): Tells zones in the local frame.

    local_operating_zone: 0..255 items. Corners of the zone to stay in
    local_exclusion_zones: 0..255 items. The zones to keep out of
    """

    class MinZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter"), 4: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(ReportLocalOperatingZone.MinZPositionChoice)))
    class MinZPosition(jd.Struct):
        """Lower limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """
        choice: ReportLocalOperatingZone.MinZPositionChoice | int
        value: float

    class MaxZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3
        Z_LOCAL = 4

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter"), 4: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(ReportLocalOperatingZone.MaxZPositionChoice)))
    class MaxZPosition(jd.Struct):
        """Upper limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        4: meter, -50000..50000 meter
        """
        choice: ReportLocalOperatingZone.MaxZPositionChoice | int
        value: float

    @jd.record("B")
    class LocalPolygonPointRec(jd.Struct):
        """A corner in the local frame with its vertical limits.

        x: -20000000..20000000 meter. Position along X, in metres
        y: -20000000..20000000 meter. Position along Y, in metres
        min_z_position: optional. Lower limit of the vertical position, and its datum
        max_z_position: optional. Upper limit of the vertical position, and its datum
        """
        x: float = jd.field("X", jd.real("I", -20000000.0, 20000000.0, "meter"))
        y: float = jd.field("Y", jd.real("I", -20000000.0, 20000000.0, "meter"))
        min_z_position: ReportLocalOperatingZone.MinZPosition | None = jd.field("MinZPosition", lambda: ReportLocalOperatingZone.MinZPosition.layout(), default=None)
        max_z_position: ReportLocalOperatingZone.MaxZPosition | None = jd.field("MaxZPosition", lambda: ReportLocalOperatingZone.MaxZPosition.layout(), default=None)
        reserved_presence: int = 0

    class ZoneID(IntEnum):
        RESERVED = 0
        OPERATING_ZONE = 1

    @jd.record()
    class LocalExclusionZoneRec(jd.Struct):
        """Number of the zone.

        zone_id: ZoneID or 2..65535. Number of the zone
        """
        zone_id: ReportLocalOperatingZone.ZoneID | int = jd.field("ZoneID", lambda: jd.Number("H", jd.Values(ReportLocalOperatingZone.ZoneID, ((2, 65535),))))

    @jd.record()
    class LocalExclusionZoneSeq(jd.Struct):
        """local_exclusion_zone_rec: Number of the zone
        local_polygon_point_rec: A corner in the local frame with its vertical limits
        """
        local_exclusion_zone_rec: ReportLocalOperatingZone.LocalExclusionZoneRec = jd.field("LocalExclusionZoneRec", lambda: ReportLocalOperatingZone.LocalExclusionZoneRec.layout())
        local_polygon_point_rec: ReportLocalOperatingZone.LocalPolygonPointRec = jd.field("LocalPolygonPointRec", lambda: ReportLocalOperatingZone.LocalPolygonPointRec.layout())

    local_operating_zone: list[ReportLocalOperatingZone.LocalPolygonPointRec] = jd.field("LocalOperatingZone", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportLocalOperatingZone.LocalPolygonPointRec.layout()))
    local_exclusion_zones: list[list[ReportLocalOperatingZone.LocalExclusionZoneSeq]] = jd.field("LocalExclusionZones", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Repeat(jd.Count("B", 0, 255), ReportLocalOperatingZone.LocalExclusionZoneSeq.layout())))


@jd.message(_SERVICE, 0x2427, query=True)
class QueryLocalOperatingZone(jd.Message):
    """QueryLocalOperatingZone (0x2427): Asks for zones in the local frame.

    query_zone_id: QueryZoneID or 2..65535. Number of the wanted zone; 0 is all, 1 the operating zone
    """
    REPORT = ReportLocalOperatingZone

    class QueryZoneID(IntEnum):
        ALL_ZONES = 0
        OPERATING_ZONE = 1

    query_zone_id: QueryLocalOperatingZone.QueryZoneID | int = jd.field("QueryZoneID", lambda: jd.Number("H", jd.Values(QueryLocalOperatingZone.QueryZoneID, ((2, 65535),))))

@jd.derived(_SERVICE)
class ReportExcursion(mobility_v1_1_global_operating_zone.ReportExcursion): ...

@jd.derived(_SERVICE)
class QueryExcursion(mobility_v1_1_global_operating_zone.QueryExcursion):
    REPORT = ReportExcursion
