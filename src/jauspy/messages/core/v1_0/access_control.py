"""urn:jaus:jss:core:AccessControl 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt


@dataclass(slots=True, repr=False)
class RequestControl(rt.Message):
    """RequestControl (0x000D): Asks for exclusive control, or renews it.

    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """

    CODE = 0x000D
    NAME = "RequestControl"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    authority_code: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("AuthorityCode", rt.Number("B", rt.Values(None, ((0, 255),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.authority_code = _S_HB.unpack(data)
        if code != 0x000D: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x000D, self.authority_code)


@dataclass(slots=True, repr=False)
class ReleaseControl(rt.Message):
    """ReleaseControl (0x000E): Gives up exclusive control."""

    CODE = 0x000E
    NAME = "ReleaseControl"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x0e\x00': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x000E)


@dataclass(slots=True, repr=False)
class QueryControl(rt.Message):
    """QueryControl (0x200D): Asks who controls the component."""

    CODE = 0x200D
    NAME = "QueryControl"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportControl]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\r ': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x200D)


@dataclass(slots=True, repr=False)
class QueryAuthority(rt.Message):
    """QueryAuthority (0x2001): Asks for the authority of the component."""

    CODE = 0x2001
    NAME = "QueryAuthority"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportAuthority]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x01 ': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2001)


@dataclass(slots=True, repr=False)
class SetAuthority(rt.Message):
    """SetAuthority (0x0001): Sets the authority of the controlling client.

    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """

    CODE = 0x0001
    NAME = "SetAuthority"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = True
    IS_QUERY = False

    authority_code: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("AuthorityCode", rt.Number("B", rt.Values(None, ((0, 255),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.authority_code = _S_HB.unpack(data)
        if code != 0x0001: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x0001, self.authority_code)


@dataclass(slots=True, repr=False)
class QueryTimeout(rt.Message):
    """QueryTimeout (0x2003): Asks after how long control ends unless it is renewed."""

    CODE = 0x2003
    NAME = "QueryTimeout"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportTimeout]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'\x03 ': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0x2003)


@dataclass(slots=True, repr=False)
class ReportControl(rt.Message):
    """ReportControl (0x400D): Tells who controls the component.

    subsystem_id: Subsystem of the controlling client
    node_id: Node of the controlling client
    component_id: Component of the controlling client
    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """

    CODE = 0x400D
    NAME = "ReportControl"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    subsystem_id: int
    node_id: int
    component_id: int
    authority_code: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("SubsystemID", rt.Number("H")),
            ("NodeID", rt.Number("B")),
            ("ComponentID", rt.Number("B")),
            ("AuthorityCode", rt.Number("B", rt.Values(None, ((0, 255),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.subsystem_id, self.node_id, self.component_id, self.authority_code = _S_2H3B.unpack(data)
        if code != 0x400D: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_2H3B.pack(0x400D, self.subsystem_id, self.node_id, self.component_id, self.authority_code)


@dataclass(slots=True, repr=False)
class RejectControl(rt.Message):
    """RejectControl (0x0010): Tells a client that it has lost or released control, or that releasing is not
    possible.

    response_code: ResponseCode. Whether control is released, or cannot be
    """

    CODE = 0x0010
    NAME = "RejectControl"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        CONTROL_RELEASED = 0
        NOT_AVAILABLE = 1

    response_code: RejectControl.ResponseCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ResponseCode", rt.Number("B", rt.Values(RejectControl.ResponseCode))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, response_code_ = _S_HB.unpack(data)
        if code != 0x0010: raise rt.Reject
        self.response_code = _E_RejectControl_ResponseCode[response_code_]
        return self

    def _pack(self) -> bytes:
        response_code_ = self.response_code
        if response_code_ not in _E_RejectControl_ResponseCode: raise rt.Reject
        return _S_HB.pack(0x0010, response_code_)


@dataclass(slots=True, repr=False)
class ConfirmControl(rt.Message):
    """ConfirmControl (0x000F): Answers a request for control.

    response_code: ResponseCode. Whether control is granted, and if not, why
    """

    CODE = 0x000F
    NAME = "ConfirmControl"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        CONTROL_ACCEPTED = 0
        NOT_AVAILABLE = 1
        INSUFFICIENT_AUTHORITY = 2

    response_code: ConfirmControl.ResponseCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("ResponseCode", rt.Number("B", rt.Values(ConfirmControl.ResponseCode))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, response_code_ = _S_HB.unpack(data)
        if code != 0x000F: raise rt.Reject
        self.response_code = _E_ConfirmControl_ResponseCode[response_code_]
        return self

    def _pack(self) -> bytes:
        response_code_ = self.response_code
        if response_code_ not in _E_ConfirmControl_ResponseCode: raise rt.Reject
        return _S_HB.pack(0x000F, response_code_)


@dataclass(slots=True, repr=False)
class ReportAuthority(rt.Message):
    """ReportAuthority (0x4001): Tells the authority of the component.

    authority_code: 0..255. Authority; the higher code wins, 0 is the lowest
    """

    CODE = 0x4001
    NAME = "ReportAuthority"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    authority_code: int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("AuthorityCode", rt.Number("B", rt.Values(None, ((0, 255),)))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, self.authority_code = _S_HB.unpack(data)
        if code != 0x4001: raise rt.Reject
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x4001, self.authority_code)


@dataclass(slots=True, repr=False)
class ReportTimeout(rt.Message):
    """ReportTimeout (0x4003): Tells after how long control ends unless it is renewed.

    timeout: Timeout or 1..255 in second. Time after the last renewal; 0 means that there is no timeout
    """

    CODE = 0x4003
    NAME = "ReportTimeout"
    SERVICE = "urn:jaus:jss:core:AccessControl"
    VERSION = "1.0"
    IS_COMMAND = False
    IS_QUERY = False

    class Timeout(IntEnum):
        """Values of Timeout."""

        TIMEOUT_FEATURE_DISABLED = 0

    timeout: ReportTimeout.Timeout | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("Timeout", rt.Number("B", rt.Values(ReportTimeout.Timeout, ((1, 255),)), "second")),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, timeout_ = _S_HB.unpack(data)
        if code != 0x4003: raise rt.Reject
        self.timeout = _E_ReportTimeout_Timeout.get(timeout_, timeout_)
        return self

    def _pack(self) -> bytes:
        return _S_HB.pack(0x4003, self.timeout)


_S_HB = rt.Packer("<HB")
_S_H = rt.Packer("<H")
_S_2H3B = rt.Packer("<2H3B")
_E_RejectControl_ResponseCode = rt.members(RejectControl.ResponseCode)
_E_ConfirmControl_ResponseCode = rt.members(ConfirmControl.ResponseCode)
_E_ReportTimeout_Timeout = rt.members(ReportTimeout.Timeout)
QueryControl.REPORT = ReportControl
QueryAuthority.REPORT = ReportAuthority
QueryTimeout.REPORT = ReportTimeout
