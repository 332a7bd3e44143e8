"""urn:jaus:jss:iop:CostMap2D 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:CostMap2D", "1.1")


@jd.message(_SERVICE, 0xD742)
class ReportCostMap2D(jd.Message):
    """ReportCostMap2D (0xD742): Tells the map of an area.

    cost_map2d_rec: Size of the map
    cost_map2d_pose_var: Middle of the map, on the globe or in the local frame
    cost_map2d_data_var: The cells, row by row: costs, costs with confidence, or runs of equal cost
    """
    CostMap2DRec = iop_v1_0_types.CostMap2DRec
    CostMap2DGlobalPoseRec = iop_v1_0_types.CostMap2DGlobalPoseRec
    CostMap2DLocalPoseRec = iop_v1_0_types.CostMap2DLocalPoseRec
    CostDataRec = iop_v1_0_types.CostDataRec
    CostAndConfidenceDataRec = iop_v1_0_types.CostAndConfidenceDataRec
    RunLengthEncodedDataRec = iop_v1_0_types.RunLengthEncodedDataRec

    @jd.record()
    class CostDataList(jd.Struct):
        """The cells.

        cost_data_list: 0..65535 items. The cells
        """
        cost_data_list: list[iop_v1_0_types.CostDataRec] = jd.field("CostDataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), iop_v1_0_types.CostDataRec.layout()))

    @jd.record()
    class CostAndConfidenceDataList(jd.Struct):
        """The cells.

        cost_and_confidence_data_list: 0..65535 items. The cells
        """
        cost_and_confidence_data_list: list[iop_v1_0_types.CostAndConfidenceDataRec] = jd.field("CostAndConfidenceDataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), iop_v1_0_types.CostAndConfidenceDataRec.layout()))

    @jd.record()
    class RunLengthEncodedDataList(jd.Struct):
        """The runs.

        run_length_encoded_data_list: 0..65535 items. The runs
        """
        run_length_encoded_data_list: list[iop_v1_0_types.RunLengthEncodedDataRec] = jd.field("RunLengthEncodedDataList", lambda: jd.Repeat(jd.Count("H", 0, 65535), iop_v1_0_types.RunLengthEncodedDataRec.layout()))

    cost_map2d_rec: iop_v1_0_types.CostMap2DRec = jd.field("CostMap2DRec", lambda: iop_v1_0_types.CostMap2DRec.layout())
    cost_map2d_pose_var: iop_v1_0_types.CostMap2DGlobalPoseRec | iop_v1_0_types.CostMap2DLocalPoseRec = jd.field("CostMap2DPoseVar", lambda: jd.Union.of("B", cost_map2d_global_pose_rec=iop_v1_0_types.CostMap2DGlobalPoseRec, cost_map2d_local_pose_rec=iop_v1_0_types.CostMap2DLocalPoseRec))
    cost_map2d_data_var: ReportCostMap2D.CostDataList | ReportCostMap2D.CostAndConfidenceDataList | ReportCostMap2D.RunLengthEncodedDataList = jd.field("CostMap2DDataVar", lambda: jd.Union.of("B", cost_data_list=ReportCostMap2D.CostDataList, cost_and_confidence_data_list=ReportCostMap2D.CostAndConfidenceDataList, run_length_encoded_data_list=ReportCostMap2D.RunLengthEncodedDataList))


@jd.message(_SERVICE, 0xD738, presence="B", query=True)
class QueryCostMap2D(jd.Message):
    """QueryCostMap2D (0xD738): Asks for the map of an area.

    query_cost_map2d_rec: optional. Size of the wanted map
    query_cost_map2d_center_var: optional. Middle of the wanted map, on the globe or in the local frame
    """
    REPORT = ReportCostMap2D
    QueryCostMap2DRec = iop_v1_0_types.QueryCostMap2DRec
    CostMap2DGlobalPoseRec = iop_v1_0_types.CostMap2DGlobalPoseRec
    CostMap2DLocalPoseRec = iop_v1_0_types.CostMap2DLocalPoseRec
    query_cost_map2d_rec: iop_v1_0_types.QueryCostMap2DRec | None = jd.field("QueryCostMap2DRec", lambda: iop_v1_0_types.QueryCostMap2DRec.layout(), default=None)
    query_cost_map2d_center_var: iop_v1_0_types.CostMap2DGlobalPoseRec | iop_v1_0_types.CostMap2DLocalPoseRec | None = jd.field("QueryCostMap2DCenterVar", lambda: jd.Union.of("B", cost_map2d_global_pose_rec=iop_v1_0_types.CostMap2DGlobalPoseRec, cost_map2d_local_pose_rec=iop_v1_0_types.CostMap2DLocalPoseRec), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xD743)
class ReportNoGoZones(jd.Message):
    """ReportNoGoZones (0xD743): Tells the zones that must not be entered.

    no_go_zones_list: 0..65535 items. The zones
    """
    GlobalVertexRec = iop_v1_0_types.GlobalVertexRec
    LocalVertexRec = iop_v1_0_types.LocalVertexRec

    @jd.record()
    class ZoneIDRec(jd.Struct):
        """One zone.

        zone_id: Number of the zone
        """
        zone_id: int = jd.field("ZoneID", jd.Number("H"))

    @jd.record()
    class GlobalVertexList(jd.Struct):
        """Corners on the globe.

        global_vertex_list: 0..255 items. Corners on the globe
        """
        global_vertex_list: list[iop_v1_0_types.GlobalVertexRec] = jd.field("GlobalVertexList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.GlobalVertexRec.layout()))

    @jd.record()
    class LocalVertexList(jd.Struct):
        """Corners in the local frame.

        local_vertex_list: 0..255 items. Corners in the local frame
        """
        local_vertex_list: list[iop_v1_0_types.LocalVertexRec] = jd.field("LocalVertexList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.LocalVertexRec.layout()))

    @jd.record()
    class NoGoZoneSeq(jd.Struct):
        """zone_id_rec: One zone
        vertex_var: Corners, on the globe or in the local frame
        """
        zone_id_rec: ReportNoGoZones.ZoneIDRec = jd.field("ZoneIDRec", lambda: ReportNoGoZones.ZoneIDRec.layout())
        vertex_var: ReportNoGoZones.GlobalVertexList | ReportNoGoZones.LocalVertexList = jd.field("VertexVar", lambda: jd.Union.of("B", global_vertex_list=ReportNoGoZones.GlobalVertexList, local_vertex_list=ReportNoGoZones.LocalVertexList))

    no_go_zones_list: list[ReportNoGoZones.NoGoZoneSeq] = jd.field("NoGoZonesList", lambda: jd.Repeat(jd.Count("H", 0, 65535), ReportNoGoZones.NoGoZoneSeq.layout()))


@jd.message(_SERVICE, 0xD739, query=True)
class QueryNoGoZones(jd.Message):
    """QueryNoGoZones (0xD739): Asks for the zones that must not be entered.

    zone_id: Number of the zone
    """
    REPORT = ReportNoGoZones
    zone_id: int = jd.field("ZoneID", jd.Number("H"))


@jd.message(_SERVICE, 0xD740, command=True)
class AddNoGoZone(jd.Message):
    """AddNoGoZone (0xD740): Adds a zone that must not be entered.

    request_id_rec: The number of the request
    vertex_var: Corners, on the globe or in the local frame
    """
    GlobalVertexRec = iop_v1_0_types.GlobalVertexRec
    LocalVertexRec = iop_v1_0_types.LocalVertexRec

    @jd.record()
    class RequestIDRec(jd.Struct):
        """The number of the request.

        request_id: Repeated in the answer, to match it with its request
        """
        request_id: int = jd.field("RequestID", jd.Number("H"))

    @jd.record()
    class GlobalVertexList(jd.Struct):
        """Corners on the globe.

        global_vertex_list: 0..255 items. Corners on the globe
        """
        global_vertex_list: list[iop_v1_0_types.GlobalVertexRec] = jd.field("GlobalVertexList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.GlobalVertexRec.layout()))

    @jd.record()
    class LocalVertexList(jd.Struct):
        """Corners in the local frame.

        local_vertex_list: 0..255 items. Corners in the local frame
        """
        local_vertex_list: list[iop_v1_0_types.LocalVertexRec] = jd.field("LocalVertexList", lambda: jd.Repeat(jd.Count("B", 0, 255), iop_v1_0_types.LocalVertexRec.layout()))

    request_id_rec: AddNoGoZone.RequestIDRec = jd.field("RequestIDRec", lambda: AddNoGoZone.RequestIDRec.layout())
    vertex_var: AddNoGoZone.GlobalVertexList | AddNoGoZone.LocalVertexList = jd.field("VertexVar", lambda: jd.Union.of("B", global_vertex_list=AddNoGoZone.GlobalVertexList, local_vertex_list=AddNoGoZone.LocalVertexList))


@jd.message(_SERVICE, 0xD741, command=True)
class RemoveNoGoZone(jd.Message):
    """RemoveNoGoZone (0xD741): Removes a zone.

    zone_id: Number of the zone
    """
    zone_id: int = jd.field("ZoneID", jd.Number("H"))


@jd.message(_SERVICE, 0xD744)
class AddNoGoZoneResponse(jd.Message):
    """AddNoGoZoneResponse (0xD744): Tells whether a zone was added.

    request_id: Repeated in the answer, to match it with its request
    response_code: ResponseCode. Whether the zone was added, and if not, why
    zone_id: Number of the zone
    """

    class ResponseCode(IntEnum):
        SUCCESS = 0
        GLOBAL_VERTICES_NOT_SUPPORTED = 1
        LOCAL_VERTICES_NOT_SUPPORTED = 2

    request_id: int = jd.field("RequestID", jd.Number("H"))
    response_code: AddNoGoZoneResponse.ResponseCode | int = jd.field("ResponseCode", lambda: jd.Number("B", jd.Values(AddNoGoZoneResponse.ResponseCode)))
    zone_id: int = jd.field("ZoneID", jd.Number("H"))
