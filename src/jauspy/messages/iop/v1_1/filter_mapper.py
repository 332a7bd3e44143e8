"""urn:jaus:jss:iop:FilterMapper 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:iop:FilterMapper", "1.1")


@jd.message(_SERVICE, 0xC532)
class ReportComponentMappings(jd.Message):
    """ReportComponentMappings (0xC532): Components that each filter covers; services both sides share are taken as joined.

    flitering_component_list: 0..255 items. One entry a filter
    """
    JAUS_ID = iop_v1_0_types.JAUS_ID

    @jd.record()
    class FilteringComponentRec(jd.Struct):
        """jaus_id: Component that filters"""
        jaus_id: iop_v1_0_types.JAUS_ID = jd.field("JAUS_ID", lambda: iop_v1_0_types.JAUS_ID.layout())

    @jd.record()
    class MappedComponentRec(jd.Struct):
        """jaus_id: Component that receives the filtered messages"""
        jaus_id: iop_v1_0_types.JAUS_ID = jd.field("JAUS_ID", lambda: iop_v1_0_types.JAUS_ID.layout())

    @jd.record()
    class FliteringComponentSeq(jd.Struct):
        """mapped_component_list: 0..255 items. Components behind this filter"""
        filtering_component_rec: ReportComponentMappings.FilteringComponentRec = jd.field("FilteringComponentRec", lambda: ReportComponentMappings.FilteringComponentRec.layout())
        mapped_component_list: list[ReportComponentMappings.MappedComponentRec] = jd.field("MappedComponentList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportComponentMappings.MappedComponentRec.layout()))

    flitering_component_list: list[ReportComponentMappings.FliteringComponentSeq] = jd.field("FliteringComponentList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportComponentMappings.FliteringComponentSeq.layout()))


@jd.message(_SERVICE, 0xC530, query=True)
class QueryComponentMappings(jd.Message):
    """QueryComponentMappings (0xC530): Asks which components each filter covers."""
    REPORT = ReportComponentMappings


@jd.message(_SERVICE, 0xC531)
class ReportFilterType(jd.Message):
    """ReportFilterType (0xC531): Uses of this filter, several at once if need be.

    filter_type: Bit set: the filter serves this use
    """
    FilterType = iop_v1_0_types.FilterType
    filter_type: iop_v1_0_types.FilterType = jd.field("FilterType", lambda: iop_v1_0_types.FilterType.layout())


@jd.message(_SERVICE, 0xC529, query=True)
class QueryFilterType(jd.Message):
    """QueryFilterType (0xC529): Asks what the filter is for."""
    REPORT = ReportFilterType
