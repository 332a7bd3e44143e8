"""urn:jaus:jss:iop:EnhancedAccessControl 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.iop.v1_0 import types as iop_v1_0_types


@dataclass(slots=True, repr=False)
class RequestHandoff(rt.Message):
    """RequestHandoff (0xFF31): Asks for control to be handed over.

    authority_code: 0..255. Authority of the asking client
    explanation: up to 255 characters. Why control is wanted, for people
    """

    CODE = 0xFF31
    NAME = "RequestHandoff"
    SERVICE = "urn:jaus:jss:iop:EnhancedAccessControl"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    authority_code: int
    explanation: str

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("AuthorityCode", rt.Number("B", rt.Values(None, ((0, 255),)))),
            ("Explanation", rt.Text(count=rt.Count("B", 0, 255))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x31 or data[1] != 0xFF: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        self.authority_code = data[2]
        explanation_end_ = 4 + data[3]
        self.explanation = data[4:explanation_end_].decode("latin-1")
        if explanation_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x31\xff")
        out.append(self.authority_code)
        explanation_raw_ = self.explanation.encode("latin-1")
        out.append(len(explanation_raw_))
        out += explanation_raw_
        return bytes(out)


@dataclass(slots=True, repr=False)
class QueryHandoffTimeout(rt.Message):
    """QueryHandoffTimeout (0xFF32): Asks for the timeout of handoff requests."""

    CODE = 0xFF32
    NAME = "QueryHandoffTimeout"
    SERVICE = "urn:jaus:jss:iop:EnhancedAccessControl"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportHandoffTimeout]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'2\xff': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xFF32)


@dataclass(slots=True, repr=False)
class QueryEnhancedTimeout(rt.Message):
    """QueryEnhancedTimeout (0xFF33): Asks for the timeout of enhanced access control."""

    CODE = 0xFF33
    NAME = "QueryEnhancedTimeout"
    SERVICE = "urn:jaus:jss:iop:EnhancedAccessControl"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportEnhancedTimeout]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'3\xff': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xFF33)


@dataclass(slots=True, repr=False)
class RemoveHandoffRequest(rt.Message):
    """RemoveHandoffRequest (0xFF34): Takes back a request for control.

    id: 0..255. Number of the request
    """

    CODE = 0xFF34
    NAME = "RemoveHandoffRequest"
    SERVICE = "urn:jaus:jss:iop:EnhancedAccessControl"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    id: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ID", rt.Number("B", rt.Values(None, ((0, 255),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.id = _S_HB.unpack(data)
        if code != 0xFF34: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0xFF34, self.id)


@dataclass(slots=True, repr=False)
class ConfirmReleaseControl(rt.Message):
    """ConfirmReleaseControl (0xFF39): Tells whether the controlling client hands over.

    release_control_list: 0..255 items. The requests
    """

    CODE = 0xFF39
    NAME = "ConfirmReleaseControl"
    SERVICE = "urn:jaus:jss:iop:EnhancedAccessControl"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    ReleaseControlRec = iop_v1_0_types.ReleaseControlRec

    release_control_list: list[iop_v1_0_types.ReleaseControlRec]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ReleaseControlList", rt.Repeat(rt.Count("B", 0, 255), iop_v1_0_types.ReleaseControlRec.layout())),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data[0] != 0x39 or data[1] != 0xFF: raise rt.Reject
        size = len(data)
        self = rt.new(cls)
        release_control_list_count_ = data[2]
        release_control_list_end_ = 3 + release_control_list_count_ * 2
        self.release_control_list = [iop_v1_0_types.ReleaseControlRec(id_, _E_ReleaseControlRec_ResponseCode[response_code_]) for id_, response_code_ in _S_2B.iter_unpack(data[3:release_control_list_end_])]
        if release_control_list_end_ != size: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        out = bytearray(b"\x39\xff")
        release_control_list_ = self.release_control_list
        if type(release_control_list_) is not list: raise rt.Reject
        out.append(len(release_control_list_))
        raw_: list[int | float] = []
        for item_ in release_control_list_:
            if type(item_) is not iop_v1_0_types.ReleaseControlRec: raise rt.Reject
            response_code_ = item_.response_code
            if response_code_ not in _E_ReleaseControlRec_ResponseCode: raise rt.Reject
            raw_ += (item_.id, response_code_)
        out += _L_B[len(raw_)].pack(*raw_)
        return bytes(out)


@dataclass(slots=True, repr=False)
class ConfirmHandoffRequest(rt.Message):
    """ConfirmHandoffRequest (0xFF35): Tells what has become of a request for control.

    id: 0..255. Number of the request
    response_code: ResponseCode. What has become of the request
    """

    CODE = 0xFF35
    NAME = "ConfirmHandoffRequest"
    SERVICE = "urn:jaus:jss:iop:EnhancedAccessControl"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        GRANTED = 0
        NOT_AVAILABLE = 1
        TIMEOUT = 2
        DENIED = 3
        QUEUED = 4
        DEFERRED = 5
        INSUFFICIENT_AUTHORITY = 6

    id: int
    response_code: ConfirmHandoffRequest.ResponseCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ID", rt.Number("B", rt.Values(None, ((0, 255),)))),
            ("ResponseCode", rt.Number("B", rt.Values(ConfirmHandoffRequest.ResponseCode))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.id, response_code_ = _S_H2B.unpack(data)
        if code != 0xFF35: raise rt.Reject
        self.response_code = _E_ConfirmHandoffRequest_ResponseCode[response_code_]
        return self

    def _pack(self) -> bytes:
        response_code_ = self.response_code
        if response_code_ not in _E_ConfirmHandoffRequest_ResponseCode: raise rt.Reject
        return _S_H2B.pack(0xFF35, self.id, response_code_)


@dataclass(slots=True, repr=False)
class ReportHandoffTimeout(rt.Message):
    """ReportHandoffTimeout (0xFF36): Tells the timeout of handoff requests.

    timeout: in second. Timeout of handoff requests, in seconds
    """

    CODE = 0xFF36
    NAME = "ReportHandoffTimeout"
    SERVICE = "urn:jaus:jss:iop:EnhancedAccessControl"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    timeout: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Timeout", rt.Number("B", rt.ANY, "second")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.timeout = _S_HB.unpack(data)
        if code != 0xFF36: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0xFF36, self.timeout)


@dataclass(slots=True, repr=False)
class ReportEnhancedTimeout(rt.Message):
    """ReportEnhancedTimeout (0xFF37): Tells the timeout of enhanced access control.

    timeout: in second. Timeout of enhanced access control, in seconds
    """

    CODE = 0xFF37
    NAME = "ReportEnhancedTimeout"
    SERVICE = "urn:jaus:jss:iop:EnhancedAccessControl"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    timeout: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Timeout", rt.Number("B", rt.ANY, "second")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.timeout = _S_HB.unpack(data)
        if code != 0xFF37: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0xFF37, self.timeout)


_S_H = rt.Packer("<H")
_S_HB = rt.Packer("<HB")
_E_ReleaseControlRec_ResponseCode = rt.members(iop_v1_0_types.ReleaseControlRec.ResponseCode)
_S_2B = rt.Packer("<2B")
_L_B = rt.Rows("B")
_E_ConfirmHandoffRequest_ResponseCode = rt.members(ConfirmHandoffRequest.ResponseCode)
_S_H2B = rt.Packer("<H2B")
QueryHandoffTimeout.REPORT = ReportHandoffTimeout
QueryEnhancedTimeout.REPORT = ReportEnhancedTimeout
