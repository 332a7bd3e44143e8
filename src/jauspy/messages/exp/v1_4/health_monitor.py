"""urn:jaus:jss:exp:aeodrs:HealthMonitor 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.exp.v1_0 import types as exp_v1_0_types

_SERVICE = jd.Service("urn:jaus:jss:exp:aeodrs:HealthMonitor", "1.4")


@jd.message(_SERVICE, 0xFD10)
class ReportUGVSummary(jd.Message):
    """ReportUGVSummary (0xFD10): Tells the health of the vehicle.

    ugv_severity_rec: How serious the state of the vehicle is
    severity_list: 0..255 items. The parts of the vehicle
    """
    UGVSeverityRec = exp_v1_0_types.UGVSeverityRec
    SeverityRec = exp_v1_0_types.SeverityRec

    @jd.record()
    class NodeID(jd.Struct):
        """Node number.

        node_id: Node number
        """
        node_id: int = jd.field("NodeID", jd.Number("B"))

    @jd.record()
    class SeveritySequence(jd.Struct):
        """node_id: Node number
        severity_rec: How serious the state of one part is
        """
        node_id: ReportUGVSummary.NodeID = jd.field("NodeID", lambda: ReportUGVSummary.NodeID.layout())
        severity_rec: exp_v1_0_types.SeverityRec = jd.field("SeverityRec", lambda: exp_v1_0_types.SeverityRec.layout())

    ugv_severity_rec: exp_v1_0_types.UGVSeverityRec = jd.field("UGVSeverityRec", lambda: exp_v1_0_types.UGVSeverityRec.layout())
    severity_list: list[ReportUGVSummary.SeveritySequence] = jd.field("SeverityList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportUGVSummary.SeveritySequence.layout()))


@jd.message(_SERVICE, 0xED10, query=True)
class QueryUGVSummary(jd.Message):
    """QueryUGVSummary (0xED10): Asks for the health of the vehicle."""
    REPORT = ReportUGVSummary


@jd.message(_SERVICE, 0xDD10, command=True)
class UpdateUGVSummary(jd.Message):
    """UpdateUGVSummary (0xDD10): Asks for the health to be found out anew."""
