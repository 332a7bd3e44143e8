"""urn:jaus:jss:iop:CostMap2DClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_1 import cost_map2d as iop_v1_1_cost_map2d

_SERVICE = jd.Service("urn:jaus:jss:iop:CostMap2DClient", "1.1")

@jd.derived(_SERVICE)
class ReportCostMap2D(iop_v1_1_cost_map2d.ReportCostMap2D): ...

@jd.derived(_SERVICE)
class ReportNoGoZones(iop_v1_1_cost_map2d.ReportNoGoZones): ...


@jd.message(_SERVICE, 0xD744, query=True)
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

@jd.derived(_SERVICE)
class QueryCostMap2D(iop_v1_1_cost_map2d.QueryCostMap2D):
    REPORT = ReportCostMap2D

@jd.derived(_SERVICE)
class QueryNoGoZones(iop_v1_1_cost_map2d.QueryNoGoZones):
    REPORT = ReportNoGoZones

@jd.derived(_SERVICE)
class AddNoGoZone(iop_v1_1_cost_map2d.AddNoGoZone): ...

@jd.derived(_SERVICE)
class RemoveNoGoZone(iop_v1_1_cost_map2d.RemoveNoGoZone): ...
