"""urn:jaus:jss:mobility:GlobalOperatingZone 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.mobility.v1_0 import types as mobility_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:mobility:GlobalOperatingZone", "1.1")


@jd.message(_SERVICE, 0x0423, command=True)
class SetGlobalOperatingZone(jd.Message):
    """SetGlobalOperatingZone (0x0423): Sets the zone on the globe to stay in and those to keep out of.

    global_operating_zone: 0..255 items. Corners of the zone to stay in
    global_exclusion_zones: 0..255 items. The zones to keep out of
    """

    class MinZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(SetGlobalOperatingZone.MinZPositionChoice)))
    class MinZPosition(jd.Struct):
        """Lower limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """
        choice: SetGlobalOperatingZone.MinZPositionChoice | int
        value: float

    class MaxZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(SetGlobalOperatingZone.MaxZPositionChoice)))
    class MaxZPosition(jd.Struct):
        """Upper limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """
        choice: SetGlobalOperatingZone.MaxZPositionChoice | int
        value: float

    @jd.record("B")
    class GlobalPolygonPointRec(jd.Struct):
        """A corner on the globe with its vertical limits.

        latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
        longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
        min_z_position: optional. Lower limit of the vertical position, and its datum
        max_z_position: optional. Upper limit of the vertical position, and its datum
        """
        latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
        longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))
        min_z_position: SetGlobalOperatingZone.MinZPosition | None = jd.field("MinZPosition", lambda: SetGlobalOperatingZone.MinZPosition.layout(), default=None)
        max_z_position: SetGlobalOperatingZone.MaxZPosition | None = jd.field("MaxZPosition", lambda: SetGlobalOperatingZone.MaxZPosition.layout(), default=None)
        reserved_presence: int = 0

    class ZoneID(IntEnum):
        RESERVED = 0
        OPERATING_ZONE = 1

    @jd.record()
    class GlobalExclusionZoneRec(jd.Struct):
        """Number of the zone.

        zone_id: ZoneID or 2..65535. Number of the zone
        """
        zone_id: SetGlobalOperatingZone.ZoneID | int = jd.field("ZoneID", lambda: jd.Number("H", jd.Values(SetGlobalOperatingZone.ZoneID, ((2, 65535),))))

    @jd.record()
    class GlobalExclusionZoneSeq(jd.Struct):
        """global_exclusion_zone_rec: Number of the zone
        global_polygon_point_rec: A corner on the globe with its vertical limits
        """
        global_exclusion_zone_rec: SetGlobalOperatingZone.GlobalExclusionZoneRec = jd.field("GlobalExclusionZoneRec", lambda: SetGlobalOperatingZone.GlobalExclusionZoneRec.layout())
        global_polygon_point_rec: SetGlobalOperatingZone.GlobalPolygonPointRec = jd.field("GlobalPolygonPointRec", lambda: SetGlobalOperatingZone.GlobalPolygonPointRec.layout())

    global_operating_zone: list[SetGlobalOperatingZone.GlobalPolygonPointRec] = jd.field("GlobalOperatingZone", lambda: jd.Repeat(jd.Count("B", 0, 255), SetGlobalOperatingZone.GlobalPolygonPointRec.layout()))
    global_exclusion_zones: list[list[SetGlobalOperatingZone.GlobalExclusionZoneSeq]] = jd.field("GlobalExclusionZones", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Repeat(jd.Count("B", 0, 255), SetGlobalOperatingZone.GlobalExclusionZoneSeq.layout())))


@jd.message(_SERVICE, 0x0422, command=True)
class DeleteZone(jd.Message):
    """DeleteZone (0x0422): Removes zones.

    zone_id_list: 0..255 items. The zones to remove
    """
    ZoneIDRec = mobility_v1_0_types.ZoneIDRec
    zone_id_list: list[mobility_v1_0_types.ZoneIDRec] = jd.field("ZoneIDList", lambda: jd.Repeat(jd.Count("B", 0, 255), mobility_v1_0_types.ZoneIDRec.layout()))


@jd.message(_SERVICE, 0x4423)
class ReportGlobalOperatingZone(jd.Message):
    """ReportGlobalOperatingZone (0x4423): Tells zones on the globe.

    global_operating_zone: 0..255 items. Corners of the zone to stay in
    global_exclusion_zones: 0..255 items. The zones to keep out of
    """

    class MinZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(ReportGlobalOperatingZone.MinZPositionChoice)))
    class MinZPosition(jd.Struct):
        """Lower limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """
        choice: ReportGlobalOperatingZone.MinZPositionChoice | int
        value: float

    class MaxZPositionChoice(IntEnum):
        ALTITUDE_AGL = 0
        ALTITUDE_MSL = 1
        ALTITUDE_ASF = 2
        DEPTH = 3

    @jd.variable(lambda cls: jd.Choice(cls, {0: jd.real("I", -50000.0, 50000.0, "meter"), 1: jd.real("I", -50000.0, 50000.0, "meter"), 2: jd.real("I", -50000.0, 50000.0, "meter"), 3: jd.real("I", -50000.0, 50000.0, "meter")}, jd.Values(ReportGlobalOperatingZone.MaxZPositionChoice)))
    class MaxZPosition(jd.Struct):
        """Upper limit of the vertical position, and its datum.

        0: meter, -50000..50000 meter
        1: meter, -50000..50000 meter
        2: meter, -50000..50000 meter
        3: meter, -50000..50000 meter
        """
        choice: ReportGlobalOperatingZone.MaxZPositionChoice | int
        value: float

    @jd.record("B")
    class GlobalPolygonPointRec(jd.Struct):
        """A corner on the globe with its vertical limits.

        latitude: -90..90 degree. Latitude (WGS 84), in degrees; positive to the north
        longitude: -180..180 degree. Longitude (WGS 84), in degrees; positive to the east
        min_z_position: optional. Lower limit of the vertical position, and its datum
        max_z_position: optional. Upper limit of the vertical position, and its datum
        """
        latitude: float = jd.field("Latitude", jd.real("I", -90.0, 90.0, "degree"))
        longitude: float = jd.field("Longitude", jd.real("I", -180.0, 180.0, "degree"))
        min_z_position: ReportGlobalOperatingZone.MinZPosition | None = jd.field("MinZPosition", lambda: ReportGlobalOperatingZone.MinZPosition.layout(), default=None)
        max_z_position: ReportGlobalOperatingZone.MaxZPosition | None = jd.field("MaxZPosition", lambda: ReportGlobalOperatingZone.MaxZPosition.layout(), default=None)
        reserved_presence: int = 0

    class ZoneID(IntEnum):
        RESERVED = 0
        OPERATING_ZONE = 1

    @jd.record()
    class GlobalExclusionZoneRec(jd.Struct):
        """Number of the zone.

        zone_id: ZoneID or 2..65535. Number of the zone
        """
        zone_id: ReportGlobalOperatingZone.ZoneID | int = jd.field("ZoneID", lambda: jd.Number("H", jd.Values(ReportGlobalOperatingZone.ZoneID, ((2, 65535),))))

    @jd.record()
    class GlobalExclusionZoneSeq(jd.Struct):
        """global_exclusion_zone_rec: Number of the zone
        global_polygon_point_rec: A corner on the globe with its vertical limits
        """
        global_exclusion_zone_rec: ReportGlobalOperatingZone.GlobalExclusionZoneRec = jd.field("GlobalExclusionZoneRec", lambda: ReportGlobalOperatingZone.GlobalExclusionZoneRec.layout())
        global_polygon_point_rec: ReportGlobalOperatingZone.GlobalPolygonPointRec = jd.field("GlobalPolygonPointRec", lambda: ReportGlobalOperatingZone.GlobalPolygonPointRec.layout())

    global_operating_zone: list[ReportGlobalOperatingZone.GlobalPolygonPointRec] = jd.field("GlobalOperatingZone", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportGlobalOperatingZone.GlobalPolygonPointRec.layout()))
    global_exclusion_zones: list[list[ReportGlobalOperatingZone.GlobalExclusionZoneSeq]] = jd.field("GlobalExclusionZones", lambda: jd.Repeat(jd.Count("B", 0, 255), jd.Repeat(jd.Count("B", 0, 255), ReportGlobalOperatingZone.GlobalExclusionZoneSeq.layout())))


@jd.message(_SERVICE, 0x2423, query=True)
class QueryGlobalOperatingZone(jd.Message):
    """QueryGlobalOperatingZone (0x2423): Asks for zones on the globe.

    query_zone_id: QueryZoneID or 2..65535. Number of the wanted zone; 0 is all, 1 the operating zone
    """
    REPORT = ReportGlobalOperatingZone

    class QueryZoneID(IntEnum):
        ALL_ZONES = 0
        OPERATING_ZONE = 1

    query_zone_id: QueryGlobalOperatingZone.QueryZoneID | int = jd.field("QueryZoneID", lambda: jd.Number("H", jd.Values(QueryGlobalOperatingZone.QueryZoneID, ((2, 65535),))))


@jd.message(_SERVICE, 0x4424)
class ReportExcursion(jd.Message):
    """ReportExcursion (0x4424): Tells for each zone whether the platform respects it.

    excursion: 0..255 items. The zones and whether they are respected
    """
    ExcursionRec = mobility_v1_0_types.ExcursionRec
    excursion: list[mobility_v1_0_types.ExcursionRec] = jd.field("Excursion", lambda: jd.Repeat(jd.Count("B", 0, 255), mobility_v1_0_types.ExcursionRec.layout()))


@jd.message(_SERVICE, 0x2424, query=True)
class QueryExcursion(jd.Message):
    """QueryExcursion (0x2424): Asks whether the platform is where it may be.

    query_zone_id: QueryZoneID or 2..65535. Number of the wanted zone; 0 is all, 1 the operating zone
    """
    REPORT = ReportExcursion

    class QueryZoneID(IntEnum):
        ALL_ZONES = 0
        OPERATING_ZONE = 1

    query_zone_id: QueryExcursion.QueryZoneID | int = jd.field("QueryZoneID", lambda: jd.Number("H", jd.Values(QueryExcursion.QueryZoneID, ((2, 65535),))))
