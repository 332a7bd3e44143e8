"""urn:jaus:jss:iop:CostMap2DClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

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


class AddNoGoZoneResponse(iop_v1_1_cost_map2d.AddNoGoZoneResponse):
    """AddNoGoZoneResponse (0xD744): Tells whether a zone was added."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"


class QueryCostMap2D(iop_v1_1_cost_map2d.QueryCostMap2D):
    """QueryCostMap2D (0xD738): Asks for the map of an area."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"


class QueryNoGoZones(iop_v1_1_cost_map2d.QueryNoGoZones):
    """QueryNoGoZones (0xD739): Asks for the zones that must not be entered."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:CostMap2DClient"
    VERSION = "1.1"


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


