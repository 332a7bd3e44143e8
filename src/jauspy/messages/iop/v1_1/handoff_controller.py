"""urn:jaus:jss:iop:HandoffController 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.iop.v1_1 import enhanced_access_control as iop_v1_1_enhanced_access_control


@dataclass(slots=True, repr=False)
class RequestReleaseControl(rt.Message):
    """RequestReleaseControl (0xFF38): Tells the controlling client who asks for control.

    request_release_control_list: 0..255 items. The requests
    """

    CODE = 0xFF38
    NAME = "RequestReleaseControl"
    SERVICE = "urn:jaus:jss:iop:HandoffController"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True

    @dataclass(slots=True, repr=False)
    class RequestReleaseControlRec(rt.Struct):
        """RequestReleaseControlRec.

        id: Number of the request
        src_subsystem_id: 1..65534. Subsystem of the asking client
        src_node_id: 0..254. Node of the asking client
        src_component_id: 0..254. Component of the asking client
        authority_code: Authority of the asking client
        explanation: up to 255 characters. Why control is wanted, for people
        """

        id: int
        src_subsystem_id: int
        src_node_id: int
        src_component_id: int
        authority_code: int
        explanation: str

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("ID", rt.Number("B")),
                ("SrcSubsystemID", rt.Number("H", rt.Values(None, ((1, 65534),)))),
                ("SrcNodeID", rt.Number("B", rt.Values(None, ((0, 254),)))),
                ("SrcComponentID", rt.Number("B", rt.Values(None, ((0, 254),)))),
                ("AuthorityCode", rt.Number("B")),
                ("Explanation", rt.Text(count=rt.Count("B", 0, 255))),
            )

    request_release_control_list: list[RequestReleaseControl.RequestReleaseControlRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("RequestReleaseControlList", rt.Repeat(rt.Count("B", 0, 255), RequestReleaseControl.RequestReleaseControlRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x38 or data[1] != 0xFF: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        request_release_control_list_count_ = data[2]
        if request_release_control_list_count_ * 7 > size - 3: raise rt.Reject
        at = 3
        request_release_control_list_ = []
        for _ in range(request_release_control_list_count_):
            item_ = rt.new(RequestReleaseControl.RequestReleaseControlRec)
            item_.id, src_subsystem_id_, src_node_id_, src_component_id_, item_.authority_code = _S_BH3B.unpack_from(data, at)
            if not 1 <= src_subsystem_id_ <= 65534: raise rt.Reject
            item_.src_subsystem_id = src_subsystem_id_
            if src_node_id_ > 254: raise rt.Reject
            item_.src_node_id = src_node_id_
            if src_component_id_ > 254: raise rt.Reject
            item_.src_component_id = src_component_id_
            explanation_end_ = at + 7 + data[at + 6]
            item_.explanation = data[at + 7:explanation_end_].decode("latin-1")
            at = explanation_end_
            request_release_control_list_.append(item_)
        self.request_release_control_list = request_release_control_list_
        if at != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x38\xff")
        request_release_control_list_ = self.request_release_control_list
        if type(request_release_control_list_) is not list: raise rt.Reject
        out.append(len(request_release_control_list_))
        for item_ in request_release_control_list_:
            if type(item_) is not RequestReleaseControl.RequestReleaseControlRec: raise rt.Reject
            src_subsystem_id_ = item_.src_subsystem_id
            if not 1 <= src_subsystem_id_ <= 65534: raise rt.Reject
            src_node_id_ = item_.src_node_id
            if not 0 <= src_node_id_ <= 254: raise rt.Reject
            src_component_id_ = item_.src_component_id
            if not 0 <= src_component_id_ <= 254: raise rt.Reject
            out += _S_BH3B.pack(item_.id, src_subsystem_id_, src_node_id_, src_component_id_, item_.authority_code)
            explanation_raw_ = item_.explanation.encode("latin-1")
            out.append(len(explanation_raw_))
            out += explanation_raw_
        return bytes(out)


class ConfirmHandoffRequest(iop_v1_1_enhanced_access_control.ConfirmHandoffRequest):
    """ConfirmHandoffRequest (0xFF35): Tells what has become of a request for control."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:HandoffController"
    VERSION = "1.1"


class ReportHandoffTimeout(iop_v1_1_enhanced_access_control.ReportHandoffTimeout):
    """ReportHandoffTimeout (0xFF36): Tells the timeout of handoff requests."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:HandoffController"
    VERSION = "1.1"


class ReportEnhancedTimeout(iop_v1_1_enhanced_access_control.ReportEnhancedTimeout):
    """ReportEnhancedTimeout (0xFF37): Tells the timeout of enhanced access control."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:HandoffController"
    VERSION = "1.1"


class ConfirmReleaseControl(iop_v1_1_enhanced_access_control.ConfirmReleaseControl):
    """ConfirmReleaseControl (0xFF39): Tells whether the controlling client hands over."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:HandoffController"
    VERSION = "1.1"


class RequestHandoff(iop_v1_1_enhanced_access_control.RequestHandoff):
    """RequestHandoff (0xFF31): Asks for control to be handed over."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:HandoffController"
    VERSION = "1.1"


class QueryHandoffTimeout(iop_v1_1_enhanced_access_control.QueryHandoffTimeout):
    """QueryHandoffTimeout (0xFF32): Asks for the timeout of handoff requests."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:HandoffController"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportHandoffTimeout]]


class QueryEnhancedTimeout(iop_v1_1_enhanced_access_control.QueryEnhancedTimeout):
    """QueryEnhancedTimeout (0xFF33): Asks for the timeout of enhanced access control."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:HandoffController"
    VERSION = "1.1"
    REPORT: ClassVar[type[ReportEnhancedTimeout]]


class RemoveHandoffRequest(iop_v1_1_enhanced_access_control.RemoveHandoffRequest):
    """RemoveHandoffRequest (0xFF34): Takes back a request for control."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:HandoffController"
    VERSION = "1.1"


_S_BH3B = rt.Packer("<BH3B")
QueryHandoffTimeout.REPORT = ReportHandoffTimeout
QueryEnhancedTimeout.REPORT = ReportEnhancedTimeout
