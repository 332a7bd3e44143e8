"""urn:jaus:jss:iop:CostMap2DClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.iop.v1_1 import cost_map2d as iop_v1_1_cost_map2d


class ReportCostMap2D(iop_v1_1_cost_map2d.ReportCostMap2D):
    """ReportCostMap2D (0xD742): Tells the map of an area."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"


class ReportNoGoZones(iop_v1_1_cost_map2d.ReportNoGoZones):
    """ReportNoGoZones (0xD743): Tells the zones that must not be entered."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class AddNoGoZoneResponse(rt.Message):
    """AddNoGoZoneResponse (0xD744): Tells whether a zone was added.

    request_id: Repeated in the answer, to match it with its request
    response_code: ResponseCode. Whether the zone was added, and if not, why
    zone_id: Number of the zone
    """

    CODE = 0xD744
    NAME = "AddNoGoZoneResponse"
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        SUCCESS = 0
        GLOBAL_VERTICES_NOT_SUPPORTED = 1
        LOCAL_VERTICES_NOT_SUPPORTED = 2

    request_id: int
    response_code: AddNoGoZoneResponse.ResponseCode | int
    zone_id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestID", rt.Number("H")),
            ("ResponseCode", rt.Number("B", rt.Values(AddNoGoZoneResponse.ResponseCode))),
            ("ZoneID", rt.Number("H")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.request_id, response_code_, self.zone_id = _S_2HBH.unpack(data)
        if code != 0xD744: raise rt.Reject
        self.response_code = _E_AddNoGoZoneResponse_ResponseCode[response_code_]
        return self

    def _pack(self) -> bytes:
        response_code_ = self.response_code
        if response_code_ not in _E_AddNoGoZoneResponse_ResponseCode: raise rt.Reject
        return _S_2HBH.pack(0xD744, self.request_id, response_code_, self.zone_id)


class QueryCostMap2D(iop_v1_1_cost_map2d.QueryCostMap2D):
    """QueryCostMap2D (0xD738): Asks for the map of an area."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportCostMap2D]]


class QueryNoGoZones(iop_v1_1_cost_map2d.QueryNoGoZones):
    """QueryNoGoZones (0xD739): Asks for the zones that must not be entered."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportNoGoZones]]


class AddNoGoZone(iop_v1_1_cost_map2d.AddNoGoZone):
    """AddNoGoZone (0xD740): Adds a zone that must not be entered."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"


class RemoveNoGoZone(iop_v1_1_cost_map2d.RemoveNoGoZone):
    """RemoveNoGoZone (0xD741): Removes a zone."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"


_E_AddNoGoZoneResponse_ResponseCode = rt.members(AddNoGoZoneResponse.ResponseCode)
_S_2HBH = rt.Packer("<2HBH")
QueryCostMap2D.REPORT = ReportCostMap2D
QueryNoGoZones.REPORT = ReportNoGoZones
