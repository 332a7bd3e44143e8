"""urn:jaus:jss:iop:HandoffController 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd
from jauspy.messages.iop.v1_1 import enhanced_access_control as iop_v1_1_enhanced_access_control

_SERVICE = jd.Service("urn:jaus:jss:iop:HandoffController", "1.1")


@jd.message(_SERVICE, 0xFF38, query=True)
class RequestReleaseControl(jd.Message):
    """RequestReleaseControl (0xFF38): Tells the controlling client who asks for control.

    request_release_control_list: 0..255 items. The requests
    """

    @jd.record()
    class RequestReleaseControlRec(jd.Struct):
        """id: Number of the request
        src_subsystem_id: 1..65534. Subsystem of the asking client
        src_node_id: 0..254. Node of the asking client
        src_component_id: 0..254. Component of the asking client
        authority_code: Authority of the asking client
        explanation: up to 255 characters. Why control is wanted, for people
        """
        id: int = jd.field("ID", jd.Number("B"))
        src_subsystem_id: int = jd.field("SrcSubsystemID", jd.Number("H", jd.Values(None, ((1, 65534),))))
        src_node_id: int = jd.field("SrcNodeID", jd.Number("B", jd.Values(None, ((0, 254),))))
        src_component_id: int = jd.field("SrcComponentID", jd.Number("B", jd.Values(None, ((0, 254),))))
        authority_code: int = jd.field("AuthorityCode", jd.Number("B"))
        explanation: str = jd.field("Explanation", jd.Text(count=jd.Count("B", 0, 255)))

    request_release_control_list: list[RequestReleaseControl.RequestReleaseControlRec] = jd.field("RequestReleaseControlList", lambda: jd.Repeat(jd.Count("B", 0, 255), RequestReleaseControl.RequestReleaseControlRec.layout()))

@jd.derived(_SERVICE)
class ConfirmHandoffRequest(iop_v1_1_enhanced_access_control.ConfirmHandoffRequest): ...

@jd.derived(_SERVICE)
class ReportHandoffTimeout(iop_v1_1_enhanced_access_control.ReportHandoffTimeout): ...

@jd.derived(_SERVICE)
class ReportEnhancedTimeout(iop_v1_1_enhanced_access_control.ReportEnhancedTimeout): ...

@jd.derived(_SERVICE)
class ConfirmReleaseControl(iop_v1_1_enhanced_access_control.ConfirmReleaseControl): ...

@jd.derived(_SERVICE)
class RequestHandoff(iop_v1_1_enhanced_access_control.RequestHandoff): ...

@jd.derived(_SERVICE)
class QueryHandoffTimeout(iop_v1_1_enhanced_access_control.QueryHandoffTimeout):
    REPORT = ReportHandoffTimeout

@jd.derived(_SERVICE)
class QueryEnhancedTimeout(iop_v1_1_enhanced_access_control.QueryEnhancedTimeout):
    REPORT = ReportEnhancedTimeout

@jd.derived(_SERVICE)
class RemoveHandoffRequest(iop_v1_1_enhanced_access_control.RemoveHandoffRequest): ...
