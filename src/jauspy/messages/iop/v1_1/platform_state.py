"""urn:jaus:jss:iop:PlatformState 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from jauspy.codec import runtime as rt
from jauspy.messages.core.v1_0 import management as core_v1_0_management


@dataclass(slots=True, repr=False)
class SetPlatformState(rt.Message):
    """SetPlatformState (0xFF25): Sets the state of the platform.

    platform_state: PlatformState. The state
    """

    CODE = 0xFF25
    NAME = "SetPlatformState"
    SERVICE = "urn:jaus:jss:iop:PlatformState"
    VERSION = "1.1"
    IS_COMMAND = True
    IS_QUERY = False

    class PlatformState(IntEnum):
        """Values of PlatformState."""

        INITIALIZE = 0
        OPERATIONAL = 1
        SHUTDOWN = 2
        SYSTEM_ABORT = 3
        EMERGENCY = 4
        RENDER_USELESS = 5

    platform_state: SetPlatformState.PlatformState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PlatformState", rt.Number("B", rt.Values(SetPlatformState.PlatformState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, platform_state_ = _S_HB.unpack(data)
        if code != 0xFF25: raise rt.Reject
        self.platform_state = _E_SetPlatformState_PlatformState[platform_state_]
        return self

    def _pack(self) -> bytes:
        platform_state_ = self.platform_state
        if platform_state_ not in _E_SetPlatformState_PlatformState: raise rt.Reject
        return _S_HB.pack(0xFF25, platform_state_)


@dataclass(slots=True, repr=False)
class QueryPlatformState(rt.Message):
    """QueryPlatformState (0xFF26): Asks for the state of the platform."""

    CODE = 0xFF26
    NAME = "QueryPlatformState"
    SERVICE = "urn:jaus:jss:iop:PlatformState"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = True
    REPORT: ClassVar[type[ReportPlatformState]]

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.Composite(cls, ())

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        if data != b'&\xff': raise rt.Reject
        return rt.new(cls)

    def _pack(self) -> bytes:
        return _S_H.pack(0xFF26)


class SetEmergency(core_v1_0_management.SetEmergency):
    """SetEmergency (0x0006): Puts the component into the Emergency state; needs no control."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PlatformState"
    VERSION = "1.1"


class ClearEmergency(core_v1_0_management.ClearEmergency):
    """ClearEmergency (0x0007): Ends the emergency that the same client has set."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:PlatformState"
    VERSION = "1.1"


@dataclass(slots=True, repr=False)
class ConfirmPlatformStateRequest(rt.Message):
    """ConfirmPlatformStateRequest (0xFF27): Tells whether the state of the platform is changing.

    platform_state: PlatformState. The state that was asked for
    response_code: ResponseCode. Whether the state is changing
    """

    CODE = 0xFF27
    NAME = "ConfirmPlatformStateRequest"
    SERVICE = "urn:jaus:jss:iop:PlatformState"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class PlatformState(IntEnum):
        """Values of PlatformState."""

        INITIALIZE = 0
        OPERATIONAL = 1
        SHUTDOWN = 2
        SYSTEM_ABORT = 3
        EMERGENCY = 4
        RENDER_USELESS = 5

    class ResponseCode(IntEnum):
        """Values of ResponseCode."""

        TRANSITIONING = 0
        INVALID_STATE = 1

    platform_state: ConfirmPlatformStateRequest.PlatformState | int
    response_code: ConfirmPlatformStateRequest.ResponseCode | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PlatformState", rt.Number("B", rt.Values(ConfirmPlatformStateRequest.PlatformState))),
            ("ResponseCode", rt.Number("B", rt.Values(ConfirmPlatformStateRequest.ResponseCode))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, platform_state_, response_code_ = _S_H2B.unpack(data)
        if code != 0xFF27: raise rt.Reject
        self.platform_state = _E_ConfirmPlatformStateRequest_PlatformState[platform_state_]
        self.response_code = _E_ConfirmPlatformStateRequest_ResponseCode[response_code_]
        return self

    def _pack(self) -> bytes:
        platform_state_ = self.platform_state
        if platform_state_ not in _E_ConfirmPlatformStateRequest_PlatformState: raise rt.Reject
        response_code_ = self.response_code
        if response_code_ not in _E_ConfirmPlatformStateRequest_ResponseCode: raise rt.Reject
        return _S_H2B.pack(0xFF27, platform_state_, response_code_)


@dataclass(slots=True, repr=False)
class ReportPlatformState(rt.Message):
    """ReportPlatformState (0xFF28): Tells the state of the platform.

    platform_state: PlatformState. The state
    """

    CODE = 0xFF28
    NAME = "ReportPlatformState"
    SERVICE = "urn:jaus:jss:iop:PlatformState"
    VERSION = "1.1"
    IS_COMMAND = False
    IS_QUERY = False

    class PlatformState(IntEnum):
        """Values of PlatformState."""

        INITIALIZE = 0
        OPERATIONAL = 1
        SHUTDOWN = 2
        SYSTEM_ABORT = 3
        EMERGENCY = 4
        RENDER_USELESS = 5

    platform_state: ReportPlatformState.PlatformState | int

    @classmethod
    def _layout(cls) -> rt.Item:
        return rt.composite(
            cls, None,
            ("PlatformState", rt.Number("B", rt.Values(ReportPlatformState.PlatformState))),
        )

    @classmethod
    def _unpack(cls, data: bytes, nesting: rt.Nesting | None) -> Self:
        self = rt.new(cls)
        code, platform_state_ = _S_HB.unpack(data)
        if code != 0xFF28: raise rt.Reject
        self.platform_state = _E_ReportPlatformState_PlatformState[platform_state_]
        return self

    def _pack(self) -> bytes:
        platform_state_ = self.platform_state
        if platform_state_ not in _E_ReportPlatformState_PlatformState: raise rt.Reject
        return _S_HB.pack(0xFF28, platform_state_)


_E_SetPlatformState_PlatformState = rt.members(SetPlatformState.PlatformState)
_S_HB = rt.Packer("<HB")
_S_H = rt.Packer("<H")
_E_ConfirmPlatformStateRequest_PlatformState = rt.members(ConfirmPlatformStateRequest.PlatformState)
_E_ConfirmPlatformStateRequest_ResponseCode = rt.members(ConfirmPlatformStateRequest.ResponseCode)
_S_H2B = rt.Packer("<H2B")
_E_ReportPlatformState_PlatformState = rt.members(ReportPlatformState.PlatformState)
QueryPlatformState.REPORT = ReportPlatformState
