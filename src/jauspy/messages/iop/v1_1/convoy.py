"""urn:jaus:jss:iop:Convoy 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:Convoy", "1.1")


@jd.message(_SERVICE, 0xF102)
class ReportConvoyDetails(jd.Message):
    """ReportConvoyDetails (0xF102): Make-up of the convoys.

    convoy_list: 0..255 items. One entry a convoy
    """

    @jd.record()
    class ConvoyRecord(jd.Struct):
        """Convoy.

        convoy_id: Number of the convoy
        head_id: Subsystem number of the vehicle at the front
        """
        convoy_id: int = jd.field("ConvoyID", jd.Number("b"))
        head_id: int = jd.field("HeadID", jd.Number("H"))

    @jd.record()
    class ConvoyOrderRec(jd.Struct):
        """Convoy order.

        leader_id: Subsystem number of the vehicle ahead
        vehicle_id: Subsystem number of the vehicle that follows it
        """
        leader_id: int = jd.field("LeaderID", jd.Number("H"))
        vehicle_id: int = jd.field("VehicleID", jd.Number("H"))

    @jd.record()
    class ConvoySeq(jd.Struct):
        """convoy_record: Convoy
        convoy_order_list: 0..255 items. Which vehicle follows which
        """
        convoy_record: ReportConvoyDetails.ConvoyRecord = jd.field("ConvoyRecord", lambda: ReportConvoyDetails.ConvoyRecord.layout())
        convoy_order_list: list[ReportConvoyDetails.ConvoyOrderRec] = jd.field("ConvoyOrderList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportConvoyDetails.ConvoyOrderRec.layout()))

    convoy_list: list[ReportConvoyDetails.ConvoySeq] = jd.field("ConvoyList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportConvoyDetails.ConvoySeq.layout()))


@jd.message(_SERVICE, 0xF100, query=True)
class QueryConvoyDetails(jd.Message):
    """QueryConvoyDetails (0xF100): Asks for the make-up of the convoys."""
    REPORT = ReportConvoyDetails


@jd.message(_SERVICE, 0xF101, command=True)
class UpdateConvoyDetails(jd.Message):
    """UpdateConvoyDetails (0xF101): Sets the make-up of convoys.

    convoy_list: 0..255 items. One entry a convoy
    """

    @jd.record()
    class ConvoyRecord(jd.Struct):
        """Convoy.

        convoy_id: Number of the convoy
        head_id: Subsystem number of the vehicle at the front
        """
        convoy_id: int = jd.field("ConvoyID", jd.Number("b"))
        head_id: int = jd.field("HeadID", jd.Number("H"))

    @jd.record()
    class ConvoyOrderRec(jd.Struct):
        """Convoy order.

        leader_id: Subsystem number of the vehicle ahead
        vehicle_id: Subsystem number of the vehicle that follows it
        """
        leader_id: int = jd.field("LeaderID", jd.Number("H"))
        vehicle_id: int = jd.field("VehicleID", jd.Number("H"))

    @jd.record()
    class ConvoySeq(jd.Struct):
        """convoy_record: Convoy
        convoy_order_list: 0..255 items. Which vehicle follows which
        """
        convoy_record: UpdateConvoyDetails.ConvoyRecord = jd.field("ConvoyRecord", lambda: UpdateConvoyDetails.ConvoyRecord.layout())
        convoy_order_list: list[UpdateConvoyDetails.ConvoyOrderRec] = jd.field("ConvoyOrderList", lambda: jd.Repeat(jd.Count("B", 0, 255), UpdateConvoyDetails.ConvoyOrderRec.layout()))

    convoy_list: list[UpdateConvoyDetails.ConvoySeq] = jd.field("ConvoyList", lambda: jd.Repeat(jd.Count("B", 0, 255), UpdateConvoyDetails.ConvoySeq.layout()))
