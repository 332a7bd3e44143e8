"""urn:jaus:jss:exp:aeodrs:HealthMonitor 1.4. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.exp.v1_0 import types as exp_v1_0_types


@dataclass(slots=True, repr=False)
class QueryUGVSummary(rt.Message):
    """QueryUGVSummary (0xED10): Asks for the health of the vehicle."""

    CODE = 0xED10
    NAME = "QueryUGVSummary"
    SERVICE = "urn:jaus:jss:exp:aeodrs:HealthMonitor"
    VERSION = "1.4"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportUGVSummary]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x10\xed': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xED10)


@dataclass(slots=True, repr=False)
class UpdateUGVSummary(rt.Message):
    """UpdateUGVSummary (0xDD10): Asks for the health to be found out anew."""

    CODE = 0xDD10
    NAME = "UpdateUGVSummary"
    SERVICE = "urn:jaus:jss:exp:aeodrs:HealthMonitor"
    VERSION = "1.4"
    IS_COMMAND = True
    IS_QUERY = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x10\xdd': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xDD10)


@dataclass(slots=True, repr=False)
class ReportUGVSummary(rt.Message):
    """ReportUGVSummary (0xFD10): Tells the health of the vehicle.

    ugv_severity_rec: How serious the state of the vehicle is
    severity_list: 0..255 items. The parts of the vehicle
    """

    CODE = 0xFD10
    NAME = "ReportUGVSummary"
    SERVICE = "urn:jaus:jss:exp:aeodrs:HealthMonitor"
    VERSION = "1.4"
    IS_COMMAND = False
    IS_QUERY = False

    UGVSeverityRec = exp_v1_0_types.UGVSeverityRec
    SeverityRec = exp_v1_0_types.SeverityRec

    @dataclass(slots=True, repr=False)
    class NodeID(rt.Struct):
        """Node number.

        node_id: Node number
        """

        node_id: int

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NodeID", rt.Number("B")),
            )

    @dataclass(slots=True, repr=False)
    class SeveritySequence(rt.Struct):
        """SeveritySequence.

        node_id: Node number
        severity_rec: How serious the state of one part is
        """

        node_id: ReportUGVSummary.NodeID
        severity_rec: exp_v1_0_types.SeverityRec

        @classmethod
        def _layout(cls) -> rt.Item:
            return rt.composite(
                cls, None,
                ("NodeID", ReportUGVSummary.NodeID.layout()),
                ("SeverityRec", exp_v1_0_types.SeverityRec.layout()),
            )

    ugv_severity_rec: exp_v1_0_types.UGVSeverityRec
    severity_list: list[ReportUGVSummary.SeveritySequence]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("UGVSeverityRec", exp_v1_0_types.UGVSeverityRec.layout()),
            ("SeverityList", rt.Repeat(rt.Count("B", 0, 255), ReportUGVSummary.SeveritySequence.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x10 or data[1] != 0xFD: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        severity_ = data[2]
        self.ugv_severity_rec = exp_v1_0_types.UGVSeverityRec(_E_UGVSeverityRec_Severity[severity_])
        severity_list_count_ = data[3]
        severity_list_end_ = 4 + severity_list_count_ * 2
        self.severity_list = [ReportUGVSummary.SeveritySequence(ReportUGVSummary.NodeID(node_id_), exp_v1_0_types.SeverityRec(_E_SeverityRec_Severity[severity_2_])) for node_id_, severity_2_ in _S_2B.iter_unpack(data[4:severity_list_end_])]
        if severity_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x10\xfd")
        ugv_severity_rec_ = self.ugv_severity_rec
        if type(ugv_severity_rec_) is not exp_v1_0_types.UGVSeverityRec: raise rt.Reject
        severity_ = ugv_severity_rec_.severity
        if severity_ not in _E_UGVSeverityRec_Severity: raise rt.Reject
        out.append(severity_)
        severity_list_ = self.severity_list
        if type(severity_list_) is not list: raise rt.Reject
        out.append(len(severity_list_))
        raw_: list[int | float] = []
        for item_ in severity_list_:
            if type(item_) is not ReportUGVSummary.SeveritySequence: raise rt.Reject
            node_id_ = item_.node_id
            if type(node_id_) is not ReportUGVSummary.NodeID: raise rt.Reject
            severity_rec_ = item_.severity_rec
            if type(severity_rec_) is not exp_v1_0_types.SeverityRec: raise rt.Reject
            severity_2_ = severity_rec_.severity
            if severity_2_ not in _E_SeverityRec_Severity: raise rt.Reject
            raw_ += (node_id_.node_id, severity_2_)
        out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


_S_H = rt.Packer("<H")
_E_UGVSeverityRec_Severity = rt.members(exp_v1_0_types.UGVSeverityRec.Severity)
_E_SeverityRec_Severity = rt.members(exp_v1_0_types.SeverityRec.Severity)
_S_2B = rt.Packer("<2B")
_L_B = rt.Rows("B")
QueryUGVSummary.REPORT = ReportUGVSummary
