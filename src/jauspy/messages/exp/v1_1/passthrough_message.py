"""urn:jaus:jss:exp:aeodrs:PassthroughMessage 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:PassthroughMessage", "1.1")


@jd.message(_SERVICE, 0xD703)
class ReportPassthroughMessageProperties(jd.Message):
    """ReportPassthroughMessageProperties (0xD703): Use of the filter and the components behind it.

    mapped_component_list: 0..255 items. Components behind this filter
    """
    FilterType = iop_v1_0_types.FilterType
    JAUS_ID = iop_v1_0_types.JAUS_ID

    @jd.record()
    class FilterTypeRec(jd.Struct):
        """filter_type: Bit set: the filter serves this use"""
        filter_type: iop_v1_0_types.FilterType = jd.field("FilterType", lambda: iop_v1_0_types.FilterType.layout())

    @jd.record()
    class MappedComponentRec(jd.Struct):
        """jaus_id: Component that receives the filtered messages"""
        jaus_id: iop_v1_0_types.JAUS_ID = jd.field("JAUS_ID", lambda: iop_v1_0_types.JAUS_ID.layout())

    filter_type_rec: ReportPassthroughMessageProperties.FilterTypeRec = jd.field("FilterTypeRec", lambda: ReportPassthroughMessageProperties.FilterTypeRec.layout())
    mapped_component_list: list[ReportPassthroughMessageProperties.MappedComponentRec] = jd.field("MappedComponentList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportPassthroughMessageProperties.MappedComponentRec.layout()))


@jd.message(_SERVICE, 0xD702, query=True)
class QueryPassthroughMessageProperties(jd.Message):
    """QueryPassthroughMessageProperties (0xD702): Asks for the filter's use and targets."""
    REPORT = ReportPassthroughMessageProperties


@jd.message(_SERVICE, 0xD701, command=True)
class SetPassthroughMessage(jd.Message):
    """SetPassthroughMessage (0xD701): Hands over messages to be checked and passed on.

    set_passthrough_message_list: 0..65535 items. One entry a message
    """

    @jd.bit_field("I")
    class TargetJausID(jd.Struct):
        """Component the message is meant for.

        component_id: bits 0..7. Component ID.
        node_id: bits 8..15. Node ID.
        subsystem_id: bits 16..31. Subsystem ID.
        """
        component_id: int = jd.bits(0, 0xFF, jd.Values(None, ((1, 255),)))
        node_id: int = jd.bits(8, 0xFF, jd.Values(None, ((1, 255),)))
        subsystem_id: int = jd.bits(16, 0xFFFF, jd.Values(None, ((1, 65535),)))

    @jd.record()
    class SetPassthroughMessageRec(jd.Struct):
        """target_jaus_id: Component the message is meant for
        passthrough_msg: octets. The wrapped message, as the payload of a JAUS message
        """
        target_jaus_id: SetPassthroughMessage.TargetJausID = jd.field("TargetJausID", lambda: SetPassthroughMessage.TargetJausID.layout())
        passthrough_msg: bytes = jd.field("PassthroughMsg", jd.Blob(jd.Count("I", 0, 2147483647)))

    set_passthrough_message_list: list[SetPassthroughMessage.SetPassthroughMessageRec] = jd.field("SetPassthroughMessageList", lambda: jd.Repeat(jd.Count("H", 0, 65535), SetPassthroughMessage.SetPassthroughMessageRec.layout()))
